/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rank 0 sends blocks of states to where rank 1 has them in the end, so that nobody needs more memory; the message END
 * says that no more will come. Rank 1 takes all of them whatever happens to its own solution. */
#include "sampled_pair.h"

#include <stdlib.h>

enum { BLOCK = 1 << 16 /* doubles */, TAG_STATES = 1, TAG_END = 2, TAG_SPREAD = 3 };

struct link {
    struct sampled *sampled;
    MPI_Comm comm;
    int64_t block, states; /* in a message; that have been sent or received */
    MPI_Request *sent;     /* rank 0; NULL if there is no memory: it then waits for rank 1 */
    int sent_count;
    int ended, cut; /* rank 1: 1 if nothing more will come, though it was needed */
};

/* ---- rank 0 ------------------------------------------------------------------------------------------------------ */

/** State k is made. */
static int send_states(void *self, int64_t k)
{
    struct link *link = self;
    const struct sampled *s = link->sampled;
    if (k + 1 - link->states < link->block && k + 1 < s->count) {
        int done; /* rank 1 may need us to take the last block */
        if (link->sent_count > 0)
            MPI_Test(&link->sent[link->sent_count - 1], &done, MPI_STATUS_IGNORE);
        return 0;
    }
    const double *from = s->states + link->states * s->width;
    const int n = (int)((k + 1 - link->states) * s->width);
    if (link->sent != NULL)
        MPI_Isend(from, n, MPI_DOUBLE, 1, TAG_STATES, link->comm, &link->sent[link->sent_count++]);
    else
        MPI_Send(from, n, MPI_DOUBLE, 1, TAG_STATES, link->comm);
    link->states = k + 1;
    return 0;
}

static int lead(struct link *link, const struct watch *watch, struct message *message)
{
    const struct sampled_other other = {send_states, link};
    const int failed = sampled_solve(link->sampled, &other, watch, message);
    MPI_Waitall(link->sent_count, link->sent, MPI_STATUSES_IGNORE);
    MPI_Send(NULL, 0, MPI_DOUBLE, 1, TAG_END, link->comm);
    MPI_Send(&link->sampled->energy_error, 1, MPI_DOUBLE, 1, TAG_SPREAD, link->comm);
    MPI_Recv(&link->sampled->spread, 1, MPI_DOUBLE, 1, TAG_SPREAD, link->comm, MPI_STATUS_IGNORE);
    return failed;
}

/* ---- rank 1 ------------------------------------------------------------------------------------------------------ */

/** Waits for the next message. */
static void receive_states(struct link *link)
{
    const struct sampled *s = link->sampled;
    MPI_Status status;
    int n;
    const int64_t left = s->count - link->states, most = left < link->block ? left : link->block;
    MPI_Recv(s->states + link->states * s->width, (int)(most * s->width), MPI_DOUBLE, 0, MPI_ANY_TAG, link->comm,
             &status);
    MPI_Get_count(&status, MPI_DOUBLE, &n);
    link->states += n / s->width;
    link->ended = status.MPI_TAG == TAG_END;
}

/** State k is going to be read. */
static int await_state(void *self, int64_t k)
{
    struct link *link = self;
    while (link->states <= k && !link->ended)
        receive_states(link);
    link->cut = link->states <= k;
    return link->cut ? WATCH_ASKED : 0;
}

static int follow(struct link *link, const struct watch *watch, struct message *message)
{
    const struct sampled_other other = {await_state, link};
    const int failed = sampled_compare(link->sampled, &other, watch, message);
    while (!link->ended)
        receive_states(link);
    MPI_Recv(&link->sampled->energy_error, 1, MPI_DOUBLE, 0, TAG_SPREAD, link->comm, MPI_STATUS_IGNORE);
    MPI_Send(&link->sampled->spread, 1, MPI_DOUBLE, 0, TAG_SPREAD, link->comm);
    return link->cut ? 0 : failed; /* why nothing more comes rank 0 says */
}

int sampled_pair_integrate(struct sampled *s, MPI_Comm comm, const struct watch *watch, struct message *message)
{
    int rank;
    struct link link = {s, comm, s->width < BLOCK ? BLOCK / s->width : 1, 0, NULL, 0, 0, 0};
    MPI_Comm_rank(comm, &rank);
    if (rank == 1)
        return follow(&link, watch, message);
    link.sent = calloc((size_t)(s->count / link.block + 1), sizeof(MPI_Request));
    const int failed = lead(&link, watch, message);
    free(link.sent);
    return failed;
}
