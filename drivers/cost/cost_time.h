/* SPDX-License-Identifier: BSD-3-Clause
 * The times of the runs of a cost study. */
#ifndef VTI_COST_TIME_H
#define VTI_COST_TIME_H

#include <mpi.h>

#include "cost_ladder.h"

/** One run to be timed. work is any measure of its length. Flat. */
struct cost_run {
    int64_t c, method;
    double h, work;
};

/** Times n runs, which are the same on all ranks. Each rank does one run at a time, without a message in between.
 *  The runs are gone through plan->repeats times, so that a burst of noise hits one sample of many runs rather than
 *  all samples of one, and every time by another rank. samples[n][repeats] comes out on all ranks. watch looks on on
 *  every rank after each of its runs. Collective. Returns on all ranks 0, or -1 if there is no memory, or
 *  WATCH_ASKED. */
int cost_time(const struct cost_plan *plan, const struct cost_run *runs, int64_t n, MPI_Comm comm,
              const struct watch *watch, double *samples);

#endif
