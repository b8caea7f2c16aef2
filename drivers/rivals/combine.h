/* SPDX-License-Identifier: BSD-3-Clause
 * Sums of slopes, with which Runge-Kutta, Adams and extrapolation methods spend what time they take beside the
 * forces. */
#ifndef VTI_COMBINE_H
#define VTI_COMBINE_H

#include <stdint.h>

#include "vti_rrv.h"

/** Of width numbers from j on, which stay in registers over all slopes. */
VTI_INLINE void combine_block(double *to, const double *from, int count, const double *weight, double *const *slope,
                              int64_t j, int width)
{
    double sum[8] = {0.0};
    for (int s = 0; s < count; ++s) {
        const double w = weight[s], *k = slope[s] + j;
        for (int l = 0; l < width; ++l)
            sum[l] += w * k[l];
    }
    for (int l = 0; l < width; ++l)
        to[j + l] = from[j + l] + sum[l];
}

/** to = from + sum_s weight_s slope_s, of numbers begin to end. to may be from, or a slope. */
static inline void combine(double *to, const double *from, int count, const double *weight, double *const *slope,
                           int64_t begin, int64_t end)
{
    int64_t j = begin;
    for (; j + 8 <= end; j += 8)
        combine_block(to, from, count, weight, slope, j, 8);
    for (; j + 2 <= end; j += 2)
        combine_block(to, from, count, weight, slope, j, 2);
    for (; j < end; ++j)
        combine_block(to, from, count, weight, slope, j, 1);
}

#endif
