/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What an error costs. From the runs of one method, ordered by their steps, the price of an error e is found so:
 *
 *  1. A run reaches e if its error is <= e and those of the next two runs, twice as many steps at the default ladder, are
 *     too. Without this a run whose error happens to pass through zero would count as a good one.
 *  2. Of the runs that reach e the cheapest is taken, by force evaluations.
 *  3. Between it and the coarser run before it, whose error is above e, evaluations and seconds are interpolated: both are
 *     straight lines in their logarithms over the logarithm of the error.
 *  4. If there is no coarser run, or its error is not above e, the price is that of the run itself: coarser ones fail, so that
 *     it is the least for which one gets anything.
 *
 * Nothing is extrapolated: what no run reaches has no price. */
#ifndef VTI_COST_PRICE_H
#define VTI_COST_PRICE_H

#include "cost_ladder.h"

enum { COST_TARGETS = 9 };

/** 1e-2, 1e-3, ..., 1e-10. */
extern const double cost_targets[COST_TARGETS];

/** NaN twice if the error is not reached. */
struct cost_price {
    double force_evals, seconds;
};

struct cost_price cost_price_of(const struct cost_ladder *ladder, int turns, double error);

/** By how much each grows when the error is to be ten times smaller: a straight line through the logarithms of the
 *  prices of all targets. NaN with fewer than three prices. */
struct cost_price cost_price_factor(const struct cost_price prices[COST_TARGETS]);

#endif
