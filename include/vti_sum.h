/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Compensated sums, and integrals over time by them. */
#ifndef VTI_SUM_H
#define VTI_SUM_H

#include <stdint.h>

#include "vti_rrv.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Sum with its rounding error carried along (Neumaier). Start from {0, 0}. */
typedef struct vti_sum {
    double high; /**< the sum as far as it goes */
    double low;  /**< what it leaves out */
} vti_sum;

/** Adds x. */
static inline void vti_sum_add(vti_sum *s, double x)
{
    const double t = s->high + x;
    s->low += fabs(s->high) >= fabs(x) ? (s->high - t) + x : (x - t) + s->high;
    s->high = t;
}

/** The sum, rounded once. */
static inline double vti_sum_value(const vti_sum *s)
{
    return isinf(s->high) ? s->high : s->high + s->low; /* the error of an infinite sum is NaN */
}

/** Integral over time by the trapezoid rule at the steps, fed one value per step. Start from {{0, 0}, 0, 0}. */
typedef struct vti_integral {
    vti_sum sum;    /**< the integral so far */
    double last;    /**< the value at the last step */
    int64_t values; /**< how many there have been */
} vti_integral;

/** The value at the next step, h after the one before (h is not used for the first). */
static inline void vti_integral_add(vti_integral *q, double h, double value)
{
    if (q->values++ > 0)
        vti_sum_add(&q->sum, 0.5 * h * (q->last + value));
    q->last = value;
}

/** The integral up to the last step. */
static inline double vti_integral_value(const vti_integral *q)
{
    return vti_sum_value(&q->sum);
}

#ifdef __cplusplus
}
#endif

#endif
