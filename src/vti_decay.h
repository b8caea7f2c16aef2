/* SPDX-License-Identifier: BSD-3-Clause
 *
 * exp(-z) for flows of dashpots and drag, with the same bits wherever there is IEEE arithmetic: nothing that moves a
 * body calls libm's. With z = k ln 2 + r, |r| <= ln(2)/2, and P the Taylor polynomial of degree 14 of expm1(-r),
 *
 *     exp(-z) = 2^-k (1 + P),      1 - exp(-z) = (1 - 2^-k) - 2^-k P                                                 */
#ifndef VTI_DECAY_H
#define VTI_DECAY_H

#include <string.h>

#include "vti_internal.h"

struct vti_decay {
    double kept; /* exp(-z) */
    double gone; /* 1 - exp(-z), small where z is */
};

/** 2^-k for 0 <= k <= 1022. */
static inline double vti_half_to(int64_t k)
{
    const uint64_t bits = (uint64_t)(1023 - k) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

/** Of z >= 0; both members are NaN where z is. Errors: 2 eps of each. */
static inline struct vti_decay vti_decay(double z)
{
    /* 1/n! with alternating signs, n = 14 ... 2: what is left out is below r^15/15! < 2^-62 r */
    static const double coefficient[] = {1.0 / 87178291200.0,
                                         -1.0 / 6227020800.0,
                                         1.0 / 479001600.0,
                                         -1.0 / 39916800.0,
                                         1.0 / 3628800.0,
                                         -1.0 / 362880.0,
                                         1.0 / 40320.0,
                                         -1.0 / 5040.0,
                                         1.0 / 720.0,
                                         -1.0 / 120.0,
                                         1.0 / 24.0,
                                         -1.0 / 6.0,
                                         0.5};
    static const double per_ln2 = 1.4426950408889634, ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b39p-40;
    struct vti_decay d = {0.0, 1.0};
    if (z > 708.0) /* below 2^-1021 */
        return d;
    const int64_t k = z >= 0.0 ? (int64_t)(z * per_ln2 + 0.5) : 0;
    const double r = (z - (double)k * ln2_high) - (double)k * ln2_low, power = vti_half_to(k);
    double p = coefficient[0];
    for (size_t n = 1; n < sizeof coefficient / sizeof coefficient[0]; ++n)
        p = p * r + coefficient[n];
    p = p * r * r - r;
    d.kept = power + power * p;
    d.gone = (1.0 - power) - power * p;
    return d;
}

/** (1 - exp(-z))/z, 1 at 0. */
static inline double vti_decay_mean(double z, const struct vti_decay *d)
{
    return z > 0.0 ? d->gone / z : 1.0;
}

#endif
