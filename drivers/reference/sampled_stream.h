/* SPDX-License-Identifier: BSD-3-Clause
 * States of a sampled reference on their way from rank 0 of a communicator, which makes them, to others that read them
 * meanwhile. They go where they stay in the end, so that nobody needs more memory. */
#ifndef VTI_SAMPLED_STREAM_H
#define VTI_SAMPLED_STREAM_H

#include <mpi.h>

#include "sampled.h"

struct stream {
    struct sampled *sampled; /* NULL: there is no stream */
    MPI_Comm comm;
    int rank, ranks;       /* the first of comm have the states */
    int64_t block, states; /* in a message; that have been sent or received */
    MPI_Request *sent;     /* rank 0: [ranks - 1] for each block; NULL if there is no memory */
    int64_t sent_count;
    int ended; /* 1 if nothing more will come */
};

/** Between the first ranks of comm, which sends nothing else in between. stream_close is due. */
void stream_open(struct stream *stream, struct sampled *sampled, MPI_Comm comm, int ranks);
/** Takes what is on its way, whether it is needed or not; by all of them. */
void stream_close(struct stream *stream);
/** Another rank than 0: waits for state k. Returns 0, or WATCH_ASKED if it will never come. */
int stream_await(struct stream *stream, int64_t k);

/** Rank 0: sampled_solve, and sends the states. */
int sampled_lead(struct stream *stream, const struct watch *watch, struct message *message);
/** One of the others meanwhile: sampled_compare. */
int sampled_follow(struct stream *stream, const struct watch *watch, struct message *message);

#endif
