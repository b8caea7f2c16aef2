/* SPDX-License-Identifier: BSD-3-Clause
 * A cost study: every case with every method, errors first, times after and apart from them, then prices. */
#ifndef VTI_COST_H
#define VTI_COST_H

#include <mpi.h>

#include "cost_ladder.h"
#include "store.h"

/* ---- prices ------------------------------------------------------------------------------------------------------ */

/* What an error costs. From the runs of one method, ordered by their steps, the price of an error e is found so:
 *
 *  1. A run reaches e if its error is <= e and those of the next two runs, twice as many steps at the default ladder,
 *     are too, as far as there are any. Without this a run whose error happens to pass through zero would count as a
 *     good one.
 *  2. Of the runs that reach e the cheapest is taken, by force evaluations.
 *  3. Between it and the coarser run before it, whose error is above e, evaluations and seconds are interpolated: both
 *     are straight lines in their logarithms over the logarithm of the error.
 *  4. If there is no coarser run, or its error is not above e, the price is that of the run itself: coarser ones fail,
 *     so that it is the least for which one gets anything; of steps that were given (--h) nobody has tried them.
 *
 * Nothing is extrapolated: what no run reaches has no price. */

enum { COST_TARGETS = 9 };

/** 1e-2, 1e-3, ..., 1e-10. */
extern const double cost_targets[COST_TARGETS];

/** NaN twice if the error is not reached. */
struct cost_price {
    double force_evals, seconds;
};

struct cost_price cost_price_of(const struct cost_ladder *ladder, int measure, double error);

/** By how much each grows when the error is to be ten times smaller: a straight line through the logarithms of the
 *  prices of all targets. NaN with fewer than three prices. */
struct cost_price cost_price_factor(const struct cost_price prices[COST_TARGETS]);

/* ---- a cost study ------------------------------------------------------------------------------------------------ */

/** What is known about a case besides its runs. */
struct cost_facts {
    int has[COST_MEASURES]; /* 0: its scene has nothing of that */
    int main;               /* the measure that its ladders go down by */
    double uncertainty; /* of the reference by its own estimate, relative (reference.h), without long ways' rounding */
};

/** What came out; filled in on rank 0, empty elsewhere. Ladder and prices of case c and method m stand at c
 *  methods_count + m. */
struct cost {
    const struct cost_plan *plan;
    struct cost_facts facts[COST_CASES];
    struct cost_ladder *ladders;                              /* [cases_count * methods_count] */
    struct cost_price (*prices)[COST_MEASURES][COST_TARGETS]; /* the same */
    int64_t runs;                                             /* that went well */
    int ranks;
    double seconds; /* for everything */
};

/** Runs the plan on all ranks of comm. All but seconds and their spread is the same for any number of ranks.
 *  Collective. Ladders (struct cost_ladder) that the store holds are not computed again; the others come into it;
 *  times are taken anew. Returns 0, or on all ranks -1 with one line in *message on rank 0, or WATCH_ASKED. store
 *  and watch may be NULL. */
int cost_run(const struct cost_plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
             struct cost *cost, struct message *message);
void cost_destroy(struct cost *cost);

/* ---- times ------------------------------------------------------------------------------------------------------- */

/* The times of the runs of a cost study. */

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
