/* SPDX-License-Identifier: BSD-3-Clause
 * Sums a += t b, plain and with their rounding errors carried along: what kick and translation share. */
#ifndef VTI_SUM_H
#define VTI_SUM_H

#include "vti_internal.h"

/** a += b with the rounding error of the sum carried in *low (two-sum, exact whatever the magnitudes). */
static inline double add_compensated(double a, double b, double *low)
{
    const double y = b + *low, s = a + y, z = s - a;
    *low = (a - (s - z)) + (y - z);
    return s;
}

/** a += t b of bodies begin <= i < end, or t/m b where m is given, with the residuals in low. */
void vti_sum_compensated(double t, const vti_view *a, const vti_view *b, const vti_scalars *m, const vti_view *low,
                         int64_t begin, int64_t end);

/** a += k b of n numbers: what kick and translation are where vectors lie packed and one mass serves all. */
void vti_sum_packed(double *restrict a, const double *restrict b, double k, int64_t n);

#endif
