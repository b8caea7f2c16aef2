/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The journal of a run: rows of its table, frames of its trajectory, what touches in these, if that is asked for, and
 * a checkpoint (checkpoint.h), in OUT.run (keep.h). The output is made from it when the run ends, so that a run that
 * dies leaves all that it had recorded at its last checkpoint, and the output of an earlier run is not touched before
 * there is a new one. Rows, frames and touches are streams of numbers, cut into pieces of one size. */
#ifndef VTI_JOURNAL_H
#define VTI_JOURNAL_H

#include "keep.h"

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
    struct journal_file rows, frames, touches; /* of touches that nobody asks for mark.doubles is 0 */
};

/** Of a stream without records. */
struct journal_mark journal_mark_start(int64_t doubles);

/** Where all streams stand. */
struct journal_marks {
    struct journal_mark rows, frames, touches;
};

struct journal_marks journal_marks(const struct journal *journal);

/** Starts the streams of an open journal where these marks say, whose records it must hold. Returns 0, or -1 with one
 *  line in *message. */
int journal_start(struct journal *journal, const struct journal_marks *marks, struct message *message);

/** About how many bytes it takes with so many rows, frames and touches. */
double journal_bytes(const struct journal *journal, double rows, double frames, double touches);

/** Appends one record. Returns 0, or -1 with one line in *message. */
int journal_add(struct journal *journal, struct journal_file *file, const double *record, struct message *message);
/** Hands on what journal_add has held back. Returns 0, or -1 with one line in *message. */
int journal_flush(struct journal *journal, struct message *message);
/** Reads count records from the first, after journal_flush; then nothing may be added. Returns 0, or -1 with one line
 *  in *message. */
int journal_read(struct journal *journal, struct journal_file *file, int64_t first, int64_t count, double *records,
                 struct message *message);

/** Closes the journal and leaves it, with its last checkpoint, or removes it. */
void journal_end(struct journal *journal, int removes);

#endif
