/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Blocks of states go by the message STATES; END says that no more will come. */
#include "sampled_stream.h"

#include <stdlib.h>

enum { BLOCK = 1 << 16 /* doubles */, TAG_STATES = 1, TAG_END = 2 };

void stream_open(struct stream *s, struct sampled *sampled, MPI_Comm comm, int ranks)
{
    const int64_t block = sampled->width < BLOCK ? BLOCK / sampled->width : 1;
    const struct stream stream = {sampled, comm, 0, ranks, block, 0, NULL, 0, 0};
    *s = stream;
    MPI_Comm_rank(comm, &s->rank);
    if (s->rank == 0)
        s->sent = calloc((size_t)((sampled->count / block + 1) * (ranks - 1)), sizeof *s->sent);
}

/* ---- rank 0 ------------------------------------------------------------------------------------------------------ */

/** State k is made. */
static int send_states(void *self, int64_t k)
{
    struct stream *s = self;
    if (k + 1 - s->states < s->block && k + 1 < s->sampled->count) {
        int done; /* the others may need us to take the last block */
        if (s->sent_count > 0)
            MPI_Test(&s->sent[s->sent_count - 1], &done, MPI_STATUS_IGNORE);
        return 0;
    }
    const double *from = s->sampled->states + s->states * s->sampled->width;
    const int n = (int)((k + 1 - s->states) * s->sampled->width);
    for (int rank = 1; rank < s->ranks; ++rank)
        MPI_Isend(from, n, MPI_DOUBLE, rank, TAG_STATES, s->comm, &s->sent[s->sent_count++]);
    s->states = k + 1;
    return 0;
}

static void end(struct stream *s)
{
    for (int rank = 1; rank < s->ranks && !s->ended; ++rank)
        MPI_Send(NULL, 0, MPI_DOUBLE, rank, TAG_END, s->comm);
    s->ended = 1;
}

int sampled_lead(struct stream *s, const struct watch *watch, struct message *message)
{
    const struct sampled_other other = {send_states, s};
    const int failed = s->sent != NULL
                           ? sampled_solve(s->sampled, &other, watch, message)
                           : message_set(message, "%s: out of memory for the reference solution; use fewer ranks",
                                         s->sampled->model->scene->name);
    end(s);
    return failed;
}

/* ---- the others -------------------------------------------------------------------------------------------------- */

/** Waits for the next message. */
static void receive(struct stream *s)
{
    const int64_t width = s->sampled->width, left = s->sampled->count - s->states;
    const int64_t most = left < s->block ? left : s->block;
    MPI_Status status;
    int n;
    MPI_Recv(s->sampled->states + s->states * width, (int)(most * width), MPI_DOUBLE, 0, MPI_ANY_TAG, s->comm, &status);
    MPI_Get_count(&status, MPI_DOUBLE, &n);
    s->states += n / width;
    s->ended = status.MPI_TAG == TAG_END;
}

int stream_await(struct stream *s, int64_t k)
{
    while (s->states <= k && !s->ended)
        receive(s);
    return s->states <= k ? WATCH_ASKED : 0;
}

/** State k is going to be read. */
static int await_state(void *self, int64_t k)
{
    return stream_await(self, k);
}

int sampled_follow(struct stream *s, const struct watch *watch, struct message *message)
{
    const struct sampled_other other = {await_state, s};
    return sampled_compare(s->sampled, &other, watch, message);
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

void stream_close(struct stream *s)
{
    if (s->rank == 0) {
        end(s);
        for (int64_t k = 0; k < s->sent_count; ++k)
            MPI_Wait(&s->sent[k], MPI_STATUS_IGNORE);
    }
    while (s->rank != 0 && !s->ended)
        receive(s);
    free(s->sent);
    s->sent = NULL;
    s->sampled = NULL;
}
