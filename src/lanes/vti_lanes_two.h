/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Two lanes: SSE2, NEON. */
#ifndef VTI_LANES_TWO_H
#define VTI_LANES_TWO_H

#include "vti_lanes_vector.h"

VTI_INLINE int lanes_all(lanes_mask m)
{
#ifdef __SSE2__ /* for which compilers take three more operations */
    return __builtin_ia32_movmskpd((lanes)m) == 3;
#else
    return (m[0] & m[1]) != 0;
#endif
}

VTI_INLINE unsigned lanes_bits(lanes_mask m)
{
    return (unsigned)(m[0] & 1) | (unsigned)(m[1] & 2);
}

VTI_INLINE lanes lanes_gather(const double *p, const int64_t at[2])
{
    return (lanes){p[at[0]], p[at[1]]};
}

VTI_INLINE void lanes_scatter(double *p, const int64_t at[2], lanes a)
{
    p[at[0]] = a[0];
    p[at[1]] = a[1];
}

VTI_INLINE lanes lanes_after(lanes before, lanes a)
{
    return SHUFFLE(before, a, 1, 2);
}

VTI_INLINE lanes lanes_before(lanes a, double next)
{
    return SHUFFLE(a, lanes_of(next), 1, 2);
}

VTI_INLINE void lanes_split(const lanes p[3], lanes a[3])
{
    a[0] = SHUFFLE(p[0], p[1], 0, 3);
    a[1] = SHUFFLE(p[0], p[2], 1, 2);
    a[2] = SHUFFLE(p[1], p[2], 0, 3);
}

VTI_INLINE void lanes_join(const lanes a[3], lanes p[3])
{
    p[0] = SHUFFLE(a[0], a[1], 0, 2);
    p[1] = SHUFFLE(a[2], a[0], 0, 3);
    p[2] = SHUFFLE(a[1], a[2], 1, 3);
}

VTI_INLINE void lanes_spread(lanes k, lanes p[3])
{
    p[0] = SHUFFLE(k, k, 0, 0);
    p[1] = k;
    p[2] = SHUFFLE(k, k, 1, 1);
}

VTI_INLINE void lanes_triples(const double *p, const int64_t at[2], lanes a[3])
{
    const pair x = pair_load(p + at[0]), y = pair_load(p + at[1]);
    a[0] = SHUFFLE(x, y, 0, 2);
    a[1] = SHUFFLE(x, y, 1, 3);
    a[2] = lanes_gather(p + 2, at);
}

VTI_INLINE void lanes_untriple(double *p, const int64_t at[2], const lanes a[3])
{
    pair_store(p + at[0], SHUFFLE(a[0], a[1], 0, 2));
    pair_store(p + at[1], SHUFFLE(a[0], a[1], 1, 3));
    lanes_scatter(p + 2, at, a[2]);
}

VTI_INLINE void lanes_quads(const double *p, const int64_t at[2], lanes a[4])
{
    for (int k = 0; k < 4; k += 2) {
        const pair x = pair_load(p + at[0] + k), y = pair_load(p + at[1] + k);
        a[k] = SHUFFLE(x, y, 0, 2);
        a[k + 1] = SHUFFLE(x, y, 1, 3);
    }
}

VTI_INLINE void lanes_unquad(double *p, const int64_t at[2], const lanes a[4])
{
    for (int k = 0; k < 4; k += 2) {
        pair_store(p + at[0] + k, SHUFFLE(a[k], a[k + 1], 0, 2));
        pair_store(p + at[1] + k, SHUFFLE(a[k], a[k + 1], 1, 3));
    }
}

#endif
