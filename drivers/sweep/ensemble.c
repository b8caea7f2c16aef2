/* SPDX-License-Identifier: BSD-3-Clause
 *
 * B. P. Welford, Note on a method for calculating corrected sums of squares and products, Technometrics 4, 419 (1962):
 *
 *     m_n = m_{n-1} + (x - m_{n-1})/n,   S_n = S_{n-1} + (x - m_{n-1})(x - m_n) */
#include "ensemble.h"

#include <math.h>

void ensemble_add(struct ensemble *e, double x)
{
    e->count += !isnan(x);
    e->infinite += isinf(x) != 0;
    if (!isfinite(x))
        return;
    const double off = x - e->mean;
    e->mean += off / (double)(e->count - e->infinite);
    e->squares += off * (x - e->mean);
}

double ensemble_mean(const struct ensemble *e)
{
    return e->infinite > 0 ? INFINITY : e->count > 0 ? e->mean : NAN;
}

double ensemble_spread(const struct ensemble *e)
{
    return e->count > 1 && e->infinite == 0 ? sqrt(e->squares / (double)(e->count - 1)) : NAN;
}
