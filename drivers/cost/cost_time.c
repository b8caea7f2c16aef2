/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost.h"

#include <math.h>
#include <stdlib.h>

/** Deals the runs out in as many hands of about equal work: the longest first, each to the hand with the least. */
static int deal(const struct cost_run *runs, int64_t n, int hands, int *hand)
{
    double *load = calloc((size_t)hands, sizeof *load);
    char *dealt = calloc((size_t)n, 1);
    const int failed = load == NULL || dealt == NULL;
    for (int64_t k = 0; k < n && !failed; ++k) {
        int64_t longest = -1;
        int least = 0;
        for (int64_t r = 0; r < n; ++r)
            if (!dealt[r] && (longest < 0 || runs[r].work > runs[longest].work))
                longest = r;
        for (int r = 1; r < hands; ++r)
            if (load[r] < load[least])
                least = r;
        dealt[longest] = 1;
        hand[longest] = least;
        load[least] += runs[longest].work;
    }
    free(load);
    free(dealt);
    return failed ? -1 : 0;
}

static double sample(const struct cost_plan *plan, const struct cost_run *run)
{
    struct message message;
    const struct cost_case *c = &plan->cases[run->c];
    const double seconds = race_sample(c->scene, plan->methods[run->method], run->h, c->t_end, &message);
    return isnan(seconds) ? INFINITY : seconds;
}

int cost_time(const struct cost_plan *plan, const struct cost_run *runs, int64_t n, MPI_Comm comm,
              const struct watch *watch, double *samples)
{
    int rank, ranks;
    double done = 0.0, all = 0.0;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
    int *hand = calloc((size_t)(n > 0 ? n : 1), sizeof *hand);
    int failed = hand == NULL || deal(runs, n, ranks, hand) != 0;
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, comm);
    if (failed || hand == NULL) {
        free(hand);
        return -1;
    }
    for (int64_t r = 0; r < n; ++r)
        all += runs[r].work * plan->repeats / ranks;
    for (int round = 0; round < plan->repeats; ++round)
        for (int64_t r = 0; r < n; ++r) {
            double *s = &samples[r * plan->repeats + round];
            *s = 0.0;
            if (hand[r] != (rank + round) % ranks || failed)
                continue;
            *s = sample(plan, &runs[r]);
            done += runs[r].work;
            failed = watch_see(watch, done / all) ? WATCH_ASKED : 0;
        }
    free(hand);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    MPI_Allreduce(MPI_IN_PLACE, samples, (int)(n * plan->repeats), MPI_DOUBLE, MPI_MAX, comm);
    return failed;
}
