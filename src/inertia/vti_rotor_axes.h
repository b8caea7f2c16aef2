/* SPDX-License-Identifier: BSD-3-Clause
 * Which of the principal axes of a body are x, y and r (vti_rotor.h), and by which rates it turns about them. */
#ifndef VTI_ROTOR_AXES_H
#define VTI_ROTOR_AXES_H

#include "../lanes/vti_lanes.h"

/** Which axes x, y and r are, by up to three pairs that change places. */
struct rotor_axes {
    lanes_mask second, first; /* r is axis 1; axis 0; of three equal moments, whichever */
    lanes_mask swapped;       /* |d_y| > |d_x| but for the last exchange */
    lanes odd;                /* -0 where x, y, -r are right-handed, else 0 */
};

/** The moments m along the two other axes, in any order, and r; and m_y (m_r - m_x), m_x (m_r - m_y). */
struct rotor_moments {
    lanes m[3], off[2];
};

VTI_INLINE void rotor_swap(lanes_mask where, lanes *a, lanes *b)
{
    const lanes c = lanes_where(where, *b, *a);
    *b = lanes_where(where, *a, *b);
    *a = c;
}

/** An axis is in the middle if the next one's moment is above its own and the other's is not, or the other way round.
 *  d_i = (m_r - m_i)/(m_r m_i). */
VTI_INLINE struct rotor_axes rotor_axes_of(const lanes m[3], struct rotor_moments *along)
{
    struct rotor_axes at;
    lanes *const a = along->m, *const off = along->off;
    const lanes_mask rises = m[0] < m[1];
    at.second = rises ^ (m[1] >= m[2]);
    at.first = rises ^ (m[2] >= m[0]);
    for (int n = 0; n < 3; ++n)
        a[n] = m[n];
    rotor_swap(at.second, a + 1, a + 2);
    rotor_swap(at.first, a, a + 2);
    off[0] = (a[2] - a[0]) * a[1];
    off[1] = (a[2] - a[1]) * a[0];
    at.swapped = lanes_abs(off[1]) > lanes_abs(off[0]);
    rotor_swap(at.swapped, off, off + 1);
    at.odd = lanes_where(at.second ^ at.first ^ at.swapped, lanes_of(-0.0), lanes_of(0.0));
    return at;
}

/** Components along x, y and what makes them right-handed. */
VTI_INLINE void rotor_onto(const struct rotor_axes *at, const lanes v[3], lanes p[3])
{
    for (int n = 0; n < 3; ++n)
        p[n] = v[n];
    rotor_swap(at->second, p + 1, p + 2);
    rotor_swap(at->first, p, p + 2);
    rotor_swap(at->swapped, p, p + 1);
    p[2] = lanes_flip(p[2], at->odd);
}

/** The way back. */
VTI_INLINE void rotor_off(const struct rotor_axes *at, const lanes p[3], lanes v[3])
{
    v[0] = p[0];
    v[1] = p[1];
    v[2] = lanes_flip(p[2], at->odd);
    rotor_swap(at->swapped, v, v + 1);
    rotor_swap(at->first, v, v + 2);
    rotor_swap(at->second, v + 1, v + 2);
}

/* ---- rates ------------------------------------------------------------------------------------------------------- */

/** t k_r, t d_x/2 and t d_y/2, which one division gives together. */
struct rotor_rates {
    lanes turn, half[2];
    lanes range; /* of numbers, in which what is divided by stays where this is below ROTOR_RANGE */
};

#define ROTOR_RANGE 0x1p900

VTI_INLINE struct rotor_rates rotor_rates_of(double t, const struct rotor_moments *along)
{
    const lanes both = along->m[0] * along->m[1], all = both * along->m[2], inv = 1.0 / all, half = (0.5 * t) * inv;
    struct rotor_rates rates = {
        .turn = both * (t * inv), .half = {along->off[0] * half, along->off[1] * half}, .range = all + inv};
    if (WIDTH == 1 && !lanes_all(rates.range < ROTOR_RANGE)) { /* one by one */
        rates.turn = t * (1.0 / along->m[2]);
        for (int n = 0; n < 2; ++n)
            rates.half[n] = (0.5 * t) * (((along->off[n] / along->m[2]) / along->m[0]) / along->m[1]);
    }
    return rates;
}

#endif
