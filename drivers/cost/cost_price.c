/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost.h"

#include <gsl/gsl_fit.h>
#include <math.h>

#include "plain.h"

const double cost_targets[COST_TARGETS] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/** Rule 1. */
static int reaches(const struct cost_ladder *ladder, int measure, int64_t k, double error)
{
    enum { RUNS = 3 };
    for (int64_t r = k; r < k + RUNS && r < ladder->count; ++r)
        if (!(cost_error(&ladder->runs[r], measure) <= error))
            return 0;
    return 1;
}

/** The point at share between a and b of a straight line in logarithms. */
static double between(double a, double b, double share)
{
    return a * plain_power(b / a, share);
}

struct cost_price cost_price_of(const struct cost_ladder *ladder, int measure, double error)
{
    struct cost_price price = {NAN, NAN};
    int64_t best = -1;
    for (int64_t k = 0; k < ladder->count; ++k)
        if (reaches(ladder, measure, k, error) &&
            (best < 0 || ladder->runs[k].force_evals < ladder->runs[best].force_evals))
            best = k;
    if (best < 0)
        return price;
    const struct race_result *run = &ladder->runs[best], *before = run - (best > 0);
    const double fine = cost_error(run, measure), coarse = cost_error(before, measure);
    double share = 1.0;
    if (coarse > error && fine > 0.0)
        share = plain_log2(coarse / error) / plain_log2(coarse / fine);
    price.force_evals = between((double)before->force_evals, (double)run->force_evals, share);
    price.seconds = between(before->seconds, run->seconds, share);
    return price;
}

/** 10 to the slope of log(value) over log(1/error). The first prices may all be that of the largest step that goes at
 *  all, which is no trade of error against cost: they do not count. */
static double factor(const double *value)
{
    enum { FEWEST = 3 };
    double x[COST_TARGETS], y[COST_TARGETS], c0, c1, cov00, cov01, cov11, sum;
    size_t n = 0;
    int first = 0;
    while (first + 1 < COST_TARGETS && value[first] == value[first + 1])
        ++first;
    for (int k = first > 0 ? first + 1 : 0; k < COST_TARGETS; ++k)
        if (isfinite(value[k])) {
            x[n] = -plain_log2(cost_targets[k]);
            y[n++] = plain_log2(value[k]);
        }
    if (n < FEWEST)
        return NAN;
    gsl_fit_linear(x, 1, y, 1, n, &c0, &c1, &cov00, &cov01, &cov11, &sum);
    return plain_power(10.0, c1);
}

struct cost_price cost_price_factor(const struct cost_price prices[COST_TARGETS])
{
    double evals[COST_TARGETS], seconds[COST_TARGETS];
    for (int k = 0; k < COST_TARGETS; ++k) {
        evals[k] = prices[k].force_evals;
        seconds[k] = prices[k].seconds;
    }
    const struct cost_price result = {factor(evals), factor(seconds)};
    return result;
}
