/* SPDX-License-Identifier: BSD-3-Clause
 *
 * exp(-z) for flows of dashpots and drag, with the same bits wherever there is IEEE arithmetic: nothing that moves a
 * body calls libm's. With z = k ln 2 + r, |r| <= ln(2)/2, and P the Taylor polynomial of degree 14 of expm1(-r),
 *
 *     exp(-z) = 2^-k (1 + P),      1 - exp(-z) = (1 - 2^-k) - 2^-k P                                                 */
#ifndef VTI_DECAY_H
#define VTI_DECAY_H

#include "../contacts/vti_touch_motion.h"

struct vti_decay {
    lanes kept; /* exp(-z) */
    lanes gone; /* 1 - exp(-z), small where z is */
};

/** P(r) of n <= 4 at once, so that none waits for the other's polynomial. */
VTI_INLINE void vti_decay_series(int n, const lanes *r, lanes *p)
{
    /* 1/n! with alternating signs, n = 14 ... 2: what is left out is below r^15/15! < 2^-62 r */
    static const double taylor[] = {1.0 / 87178291200.0,
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
    enum { TERMS = sizeof taylor / sizeof taylor[0] };
    lanes r2[4], odd[4]; /* even and odd powers apart: half as long a chain */
    for (int i = 0; i < n; ++i) {
        r2[i] = r[i] * r[i];
        p[i] = lanes_of(taylor[0]);
        odd[i] = lanes_of(taylor[1]);
    }
    for (int c = 2; c < TERMS; c += 2)
        for (int i = 0; i < n; ++i) {
            p[i] = p[i] * r2[i] + taylor[c];
            odd[i] = c + 1 < TERMS ? odd[i] * r2[i] + taylor[c + 1] : odd[i];
        }
    for (int i = 0; i < n; ++i)
        p[i] = (p[i] + r[i] * odd[i]) * r2[i] - r[i];
}

/** Of n <= 4 of z >= 0; both members are NaN where z is. Errors: 2 eps of each. */
VTI_INLINE void vti_decays(int n, const lanes *z, struct vti_decay *d)
{
    static const double per_ln2 = 1.4426950408889634, ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b39p-40;
    static const double most = 708.0;  /* beyond, exp(-z) < 2^-1021 */
    static const double within = 0.34; /* < ln(2)/2, k is 0 */
    lanes r[4], power[4], p[4];
    lanes_mask small = lanes_of(0.0) < within;
    for (int i = 0; i < n; ++i)
        small &= z[i] < within;
    if (lanes_all(small)) { /* as mostly: the same bits, with k = 0, r = z */
        vti_decay_series(n, z, p);
        for (int i = 0; i < n; ++i) {
            d[i].kept = 1.0 + p[i];
            d[i].gone = 0.0 - p[i];
        }
        return;
    }
    for (int i = 0; i < n; ++i) {
        const lanes z_i = lanes_where(z[i] > most, lanes_of(most), z[i]);
        const lanes x = z_i * per_ln2 + 0.5, near = (x + 0x1.8p52) - 0x1.8p52;
        const lanes k = lanes_where(near > x, near - 1.0, near); /* the whole part of x */
        r[i] = (z_i - k * ln2_high) - k * ln2_low;
        power[i] = lanes_half_to(k);
    }
    vti_decay_series(n, r, p);
    for (int i = 0; i < n; ++i) {
        d[i].kept = lanes_where(z[i] > most, lanes_of(0.0), power[i] + power[i] * p[i]);
        d[i].gone = (1.0 - power[i]) - power[i] * p[i];
    }
}

VTI_INLINE struct vti_decay vti_decay(lanes z)
{
    struct vti_decay d;
    vti_decays(1, &z, &d);
    return d;
}

/** (1 - exp(-z))/z, 1 at 0. */
VTI_INLINE lanes vti_decay_mean(lanes z, const struct vti_decay *d)
{
    return lanes_where(z > 0.0, d->gone / z, lanes_of(1.0));
}

#endif
