/* SPDX-License-Identifier: BSD-3-Clause
 * Checkpoints of a run in its journal: how far it is, the state of its bodies and of its verdict, and the digest of
 * all. */
#ifndef VTI_CHECKPOINT_H
#define VTI_CHECKPOINT_H

#include "journal.h"
#include "verdict.h"

/** How far a run is. With it goes the state of the bodies and of the verdict so far, as more what else the stepper
 *  keeps (travel_state), and what the verdict's model does (model_memory_get). */
struct checkpoint {
    int64_t step;                       /* not yet recorded */
    int64_t record_every, frames_every; /* steps between rows and between frames */
    struct journal_mark rows, frames, touches;
    int64_t state_doubles;
};

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

#endif
