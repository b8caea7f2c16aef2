/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The journal of a run: rows of its table, frames of its trajectory and a checkpoint, in OUT.run (keep.h). The output
 * is made from it when the run ends, so that a run that dies leaves all that it had recorded at its last checkpoint,
 * and the output of an earlier run is not touched before there is a new one. Rows and frames are two streams of
 * numbers, cut into pieces of one size. */
#ifndef VTI_JOURNAL_H
#define VTI_JOURNAL_H

#include "keep.h"
#include "scene.h"
#include "verdict.h"

/** A stream of records of equal size. */
struct journal_mark {
    int64_t doubles; /* of a record */
    int64_t count;   /* records */
    uint64_t digest; /* of all of them */
};

struct journal_file {
    enum keep_table table;
    struct journal_mark mark;
    double *piece;  /* one, in memory: the last, until something is read */
    int64_t loaded; /* its number */
};

struct journal {
    struct keep keep;
    struct journal_file rows, frames;
};

/** How far a run is. With it goes the state of the bodies and of the verdict so far, as more what else the stepper
 *  keeps (travel_state), and what the verdict's model does (model_memory_get). */
struct checkpoint {
    int64_t step;                       /* not yet recorded */
    int64_t record_every, frames_every; /* steps between rows and between frames */
    int64_t fields;                     /* FIELD_ of frames (record.h): --resume keeps them */
    struct journal_mark rows, frames;
    int64_t state_doubles;
};

/** Of a stream without records. */
struct journal_mark journal_mark_start(int64_t doubles);

/** Starts the two streams of an open journal where these marks say, whose records it must hold. Returns 0, or -1 with
 *  one line in *message. */
int journal_start(struct journal *journal, struct journal_mark rows, struct journal_mark frames,
                  struct message *message);

/** About how many bytes it takes with so many rows and frames. */
double journal_bytes(const struct journal *journal, int64_t rows, int64_t frames);

/** Appends one record. Returns 0, or -1 with one line in *message. */
int journal_add(struct journal *journal, struct journal_file *file, const double *record, struct message *message);
/** Hands on what journal_add has held back. Returns 0, or -1 with one line in *message. */
int journal_flush(struct journal *journal, struct message *message);
/** Reads count records from the first, after journal_flush; then nothing may be added. Returns 0, or -1 with one line
 *  in *message. */
int journal_read(struct journal *journal, struct journal_file *file, int64_t first, int64_t count, double *records,
                 struct message *message);

/** Commits the journal with a checkpoint of the bodies and of the verdict so far; marks and sizes in *checkpoint are
 *  set. Returns 0, or -1 with one line in *message and the checkpoint before it as it was. */
int checkpoint_write(struct journal *journal, struct checkpoint *checkpoint, const vti_bodies *bodies,
                     const struct verdict *verdict, const double *more, int64_t more_count, struct message *message);

/** Bytes of such a checkpoint, of what the model remembers now. */
double checkpoint_bytes(const vti_bodies *bodies, const struct verdict *verdict, int64_t more_count);

/** The bytes of the checkpoint in the journal, piece by piece: size of all bytes, from byte at on. take returns 0, or
 *  non-zero if there is no memory. Returns 0, or -1 with one line in *message, which is to be empty before. */
int checkpoint_pieces(struct journal *journal,
                      int (*take)(void *self, size_t at, size_t all, const void *piece, size_t size), void *self,
                      struct message *message);
/** All of them, from malloc; NULL with one line in *message. */
unsigned char *checkpoint_read(struct journal *journal, size_t *size, struct message *message);

/** Takes a checkpoint from its bytes, which malloc has aligned, for these bodies and their verdict, which get its
 *  state, or stay as they are if that is of step 0: they are at t = 0 already. Returns 0, or -1: it is none, or is
 *  damaged. */
int checkpoint_take(const unsigned char *bytes, size_t size, struct checkpoint *checkpoint, const vti_bodies *bodies,
                    struct verdict *verdict, double *more, int64_t more_count);

/** Closes the journal and leaves it, with its last checkpoint, or removes it. */
void journal_end(struct journal *journal, int removes);

#endif
