/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A dynamic queue of independent tasks over the ranks of a communicator. Rank 0 hands out tasks and works too: it
 * answers the others between the slices of its own task. Plain point-to-point messages, so any transport will do. */
#ifndef VTI_QUEUE_H
#define VTI_QUEUE_H

#include <mpi.h>
#include <stdint.h>

#include "watch.h"

/** Called by a running task now and then, with the work done so far; non-zero asks the task to end. */
typedef int (*queue_poll)(void *poll_self, int64_t work);

struct queue {
    void *self;
    int64_t bytes; /* of one result */
    /** Rank 0: the next task to be handed out, -1 if there is none. */
    int64_t (*next)(void *self);
    /** Any rank: does the task and writes its result. */
    void (*run)(void *self, int64_t task, queue_poll poll, void *poll_self, void *result);
    /** Rank 0: takes a result. Non-zero stops the queue: tasks under way are asked to end, no more are handed out. */
    int (*done)(void *self, int64_t task, int rank, const void *result);
    /** Rank 0: progress of its own task, -1 while it waits for those of others. */
    void (*progress)(void *self, int64_t task, int64_t work);
    const struct study_watch *watch; /* any rank asks it often whether the queue shall end; may be NULL */
};

/** Works the queue off. Collective; returns on all ranks 0, or -1 if done stopped it or memory ran out, or
 *  WATCH_ASKED if any rank was asked to end. */
int queue_run(const struct queue *queue, MPI_Comm comm);

#endif
