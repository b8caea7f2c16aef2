/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Vectors of four numbers of AVX2, of which four and eight lanes are made. */
#ifndef VTI_LANES_FOURS_H
#define VTI_LANES_FOURS_H

#include "vti_lanes_vector.h"

typedef double four VECTOR(4);
typedef double four_there THERE(4);
typedef int64_t four_mask VECTOR(4);

VTI_INLINE unsigned four_bits(four_mask m)
{
    return (unsigned)__builtin_ia32_movmskpd256((four)m);
}

VTI_INLINE four four_gather(const double *p, const int64_t at[4])
{
    return (four){p[at[0]], p[at[1]], p[at[2]], p[at[3]]};
}

VTI_INLINE void four_scatter(double *p, const int64_t at[4], four a)
{
    for (int l = 0; l < 4; ++l)
        p[at[l]] = a[l];
}

/** The pair at p and the one at q: loads that are put in place, and no shuffle. */
VTI_INLINE four two_pairs(const double *p, const double *q)
{
    const pair low = pair_load(p);
    return __builtin_ia32_vinsertf128_pd256(SHUFFLE(low, low, 0, 1, -1, -1), pair_load(q), 1);
}

VTI_INLINE void four_triples(const double *p, const int64_t at[4], four a[3])
{
    const four x = two_pairs(p + at[0], p + at[2]), y = two_pairs(p + at[1], p + at[3]);
    a[0] = SHUFFLE(x, y, 0, 4, 2, 6);
    a[1] = SHUFFLE(x, y, 1, 5, 3, 7);
    a[2] = four_gather(p + 2, at);
}

VTI_INLINE void four_untriple(double *p, const int64_t at[4], const four a[3])
{
    const four x = SHUFFLE(a[0], a[1], 0, 4, 2, 6), y = SHUFFLE(a[0], a[1], 1, 5, 3, 7);
    pair_store(p + at[0], SHUFFLE(x, x, 0, 1));
    pair_store(p + at[1], SHUFFLE(y, y, 0, 1));
    pair_store(p + at[2], SHUFFLE(x, x, 2, 3));
    pair_store(p + at[3], SHUFFLE(y, y, 2, 3));
    four_scatter(p + 2, at, a[2]);
}

/** Rows and columns of four times four numbers change places. */
VTI_INLINE void four_transpose(const four r[4], four c[4])
{
    const four x = SHUFFLE(r[0], r[1], 0, 4, 2, 6), y = SHUFFLE(r[0], r[1], 1, 5, 3, 7);
    const four z = SHUFFLE(r[2], r[3], 0, 4, 2, 6), w = SHUFFLE(r[2], r[3], 1, 5, 3, 7);
    c[0] = SHUFFLE(x, z, 0, 1, 4, 5);
    c[1] = SHUFFLE(y, w, 0, 1, 4, 5);
    c[2] = SHUFFLE(x, z, 2, 3, 6, 7);
    c[3] = SHUFFLE(y, w, 2, 3, 6, 7);
}

VTI_INLINE void four_quads(const double *p, const int64_t at[4], four a[4])
{
    four r[4];
    for (int l = 0; l < 4; ++l)
        r[l] = *(const four_there *)(p + at[l]);
    four_transpose(r, a);
}

VTI_INLINE void four_unquad(double *p, const int64_t at[4], const four a[4])
{
    four r[4];
    four_transpose(a, r);
    for (int l = 0; l < 4; ++l)
        *(four_there *)(p + at[l]) = r[l];
}

#endif
