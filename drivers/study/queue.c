/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Messages: a worker sends DONE (its task and result; task -1 at the start) and receives TASK (the next one, or -1).
 * STOP asks a worker to end the task that it is at; a worker that is asked so from outside tells rank 0 by ASKED. */
#define _POSIX_C_SOURCE 200809L
#include "queue.h"

#include <stdlib.h>
#include <time.h>

enum { TAG_DONE = 1, TAG_TASK = 2, TAG_STOP = 3, TAG_ASKED = 4 };

/** A message DONE. */
struct report {
    int64_t task;
    char result[];
};

struct state {
    const struct queue *queue;
    MPI_Comm comm;
    int ranks;
    struct report *report;
    int report_bytes;
    /* rank 0 */
    int workers; /* that still ask for tasks */
    char *home;  /* [ranks] 1 for those that have */
    int stopped; /* 0, or what queue_run returns */
    int64_t own_task;
    /* the others */
    int told; /* 1 once rank 0 has been sent ASKED */
};

/* ---- rank 0 ------------------------------------------------------------------------------------------------------ */

static int64_t next_task(struct state *s)
{
    return s->stopped ? -1 : s->queue->next(s->queue->self);
}

/** Nothing more is taken or handed out; rank, which has nothing to do just now, need not be told. */
static void stop(struct state *s, int rank, int why)
{
    for (int other = 1; other < s->ranks && !s->stopped; ++other)
        if (other != rank && !s->home[other])
            MPI_Send(NULL, 0, MPI_BYTE, other, TAG_STOP, s->comm);
    s->stopped = s->stopped ? s->stopped : why;
}

static void take(struct state *s, int rank, const struct report *report)
{
    if (report->task >= 0 && !s->stopped && s->queue->done(s->queue->self, report->task, rank, report->result) != 0)
        stop(s, rank, -1);
}

/** Receives one message and answers it. */
static void serve(struct state *s)
{
    MPI_Status status;
    MPI_Recv(s->report, s->report_bytes, MPI_BYTE, MPI_ANY_SOURCE, MPI_ANY_TAG, s->comm, &status);
    if (status.MPI_TAG == TAG_ASKED) {
        stop(s, 0, WATCH_ASKED);
        return;
    }
    take(s, status.MPI_SOURCE, s->report);
    const int64_t task = next_task(s);
    if (task < 0) {
        s->home[status.MPI_SOURCE] = 1;
        --s->workers;
    }
    MPI_Send(&task, 1, MPI_INT64_T, status.MPI_SOURCE, TAG_TASK, s->comm);
}

static int poll_root(void *self, int64_t work)
{
    struct state *s = self;
    int waiting = s->ranks > 1;
    while (waiting) {
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, s->comm, &waiting, MPI_STATUS_IGNORE);
        if (waiting)
            serve(s);
    }
    s->queue->progress(s->queue->self, s->own_task, work);
    if (study_asked(s->queue->watch))
        stop(s, 0, WATCH_ASKED);
    return s->stopped;
}

static void work_root(struct state *s, struct report *own)
{
    while ((own->task = next_task(s)) >= 0) {
        s->own_task = own->task;
        s->queue->run(s->queue->self, own->task, poll_root, s, own->result);
        take(s, 0, own);
    }
    s->own_task = -1;
    while (s->workers > 0) {
        const struct timespec a_moment = {0, 1000000};
        poll_root(s, 0);
        nanosleep(&a_moment, NULL);
    }
}

/* ---- the others -------------------------------------------------------------------------------------------------- */

static int poll_worker(void *self, int64_t work)
{
    struct state *s = self;
    int told = 0;
    (void)work;
    if (!s->told && study_asked(s->queue->watch)) {
        s->told = 1;
        MPI_Send(NULL, 0, MPI_BYTE, 0, TAG_ASKED, s->comm);
    }
    MPI_Iprobe(0, TAG_STOP, s->comm, &told, MPI_STATUS_IGNORE);
    return told;
}

static void work_other(struct state *s)
{
    s->report->task = -1;
    for (;;) {
        MPI_Send(s->report, s->report_bytes, MPI_BYTE, 0, TAG_DONE, s->comm);
        MPI_Recv(&s->report->task, 1, MPI_INT64_T, 0, TAG_TASK, s->comm, MPI_STATUS_IGNORE);
        if (s->report->task < 0)
            break;
        s->queue->run(s->queue->self, s->report->task, poll_worker, s, s->report->result);
    }
    /* a STOP may have come after the last poll: it must not stay behind in the communicator */
    int told = 1;
    while (told) {
        MPI_Iprobe(0, TAG_STOP, s->comm, &told, MPI_STATUS_IGNORE);
        if (told)
            MPI_Recv(NULL, 0, MPI_BYTE, 0, TAG_STOP, s->comm, MPI_STATUS_IGNORE);
    }
}

int queue_run(const struct queue *queue, MPI_Comm comm)
{
    int rank;
    struct state s = {queue, comm, 0, NULL, 0, 0, NULL, 0, -1, 0};
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &s.ranks);
    s.workers = s.ranks - 1;
    const size_t bytes = sizeof *s.report + (size_t)queue->bytes;
    s.report_bytes = (int)bytes;
    s.report = calloc(1, bytes);
    struct report *own = calloc(1, bytes);
    s.home = calloc((size_t)s.ranks, 1);
    const int without = s.report == NULL || own == NULL || s.home == NULL;
    int failed = without ? -1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    if (!failed && !without) {
        if (rank == 0)
            work_root(&s, own);
        else
            work_other(&s);
        failed = s.stopped;
        MPI_Bcast(&failed, 1, MPI_INT, 0, comm);
    }
    free(s.report);
    free(own);
    free(s.home);
    return failed;
}
