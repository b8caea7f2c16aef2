/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Eight lanes: AVX-512. */
#ifndef VTI_LANES_EIGHT_H
#define VTI_LANES_EIGHT_H

#include "vti_lanes_fours.h"

/** gcc makes a shuffle of one, which waits for the one port that has any, where b comes from memory. */
VTI_INLINE lanes two_fours(four a, four b)
{
#ifdef __clang__
    return SHUFFLE(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return __builtin_ia32_insertf64x4_mask(__builtin_ia32_pd512_256pd(a), b, 1, lanes_of(0.0), 0xff);
#endif
}

VTI_INLINE four lower(lanes a)
{
    return SHUFFLE(a, a, 0, 1, 2, 3);
}

VTI_INLINE four upper(lanes a)
{
    return SHUFFLE(a, a, 4, 5, 6, 7);
}

VTI_INLINE unsigned lanes_bits(lanes_mask m)
{
    typedef long long eight VECTOR(8);
    return (unsigned char)__builtin_ia32_cvtq2mask512((eight)m);
}

VTI_INLINE int lanes_all(lanes_mask m)
{
    return lanes_bits(m) == 0xff;
}

VTI_INLINE lanes lanes_gather(const double *p, const int64_t at[8])
{
    return two_fours(four_gather(p, at), four_gather(p, at + 4));
}

VTI_INLINE void lanes_scatter(double *p, const int64_t at[8], lanes a)
{
    four_scatter(p, at, lower(a));
    four_scatter(p, at + 4, upper(a));
}

VTI_INLINE lanes lanes_after(lanes before, lanes a)
{
    return SHUFFLE(before, a, 7, 8, 9, 10, 11, 12, 13, 14);
}

VTI_INLINE lanes lanes_before(lanes a, double next)
{
    return SHUFFLE(a, lanes_of(next), 1, 2, 3, 4, 5, 6, 7, 8);
}

VTI_INLINE void lanes_split(const lanes p[3], lanes a[3])
{
    const lanes x = SHUFFLE(p[0], p[1], 0, 3, 6, 9, 12, 15, 0, 0);
    const lanes y = SHUFFLE(p[0], p[1], 1, 4, 7, 10, 13, 0, 0, 0);
    const lanes z = SHUFFLE(p[0], p[1], 2, 5, 8, 11, 14, 0, 0, 0);
    a[0] = SHUFFLE(x, p[2], 0, 1, 2, 3, 4, 5, 10, 13);
    a[1] = SHUFFLE(y, p[2], 0, 1, 2, 3, 4, 8, 11, 14);
    a[2] = SHUFFLE(z, p[2], 0, 1, 2, 3, 4, 9, 12, 15);
}

VTI_INLINE void lanes_join(const lanes a[3], lanes p[3])
{
    const lanes x = SHUFFLE(a[0], a[1], 0, 8, 0, 1, 9, 0, 2, 10);
    const lanes y = SHUFFLE(a[0], a[1], 0, 3, 11, 0, 4, 12, 0, 5);
    const lanes z = SHUFFLE(a[0], a[1], 13, 0, 6, 14, 0, 7, 15, 0);
    p[0] = SHUFFLE(x, a[2], 0, 1, 8, 3, 4, 9, 6, 7);
    p[1] = SHUFFLE(y, a[2], 10, 1, 2, 11, 4, 5, 12, 7);
    p[2] = SHUFFLE(z, a[2], 0, 13, 2, 3, 14, 5, 6, 15);
}

VTI_INLINE void lanes_spread(lanes k, lanes p[3])
{
    p[0] = SHUFFLE(k, k, 0, 0, 0, 1, 1, 1, 2, 2);
    p[1] = SHUFFLE(k, k, 2, 3, 3, 3, 4, 4, 4, 5);
    p[2] = SHUFFLE(k, k, 5, 5, 6, 6, 6, 7, 7, 7);
}

VTI_INLINE lanes four_pairs(const double *p, int64_t a, int64_t b, int64_t c, int64_t d)
{
    return two_fours(two_pairs(p + a, p + b), two_pairs(p + c, p + d));
}

/** Bodies 0, 2, 4, 6 and 1, 3, 5, 7 as pairs (x, y) and (y, z). */
VTI_INLINE void lanes_triples(const double *p, const int64_t at[8], lanes a[3])
{
    lanes xy[2], yz[2];
    for (int k = 0; k < 2; ++k) {
        xy[k] = four_pairs(p, at[k], at[k + 2], at[k + 4], at[k + 6]);
        yz[k] = four_pairs(p + 1, at[k], at[k + 2], at[k + 4], at[k + 6]);
    }
    a[0] = SHUFFLE(xy[0], xy[1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[1] = SHUFFLE(xy[0], xy[1], 1, 9, 3, 11, 5, 13, 7, 15);
    a[2] = SHUFFLE(yz[0], yz[1], 1, 9, 3, 11, 5, 13, 7, 15);
}

VTI_INLINE void lanes_untriple(double *p, const int64_t at[8], const lanes a[3])
{
    const lanes x = SHUFFLE(a[0], a[1], 0, 8, 2, 10, 4, 12, 6, 14), y = SHUFFLE(a[0], a[1], 1, 9, 3, 11, 5, 13, 7, 15);
    pair_store(p + at[0], SHUFFLE(x, x, 0, 1));
    pair_store(p + at[1], SHUFFLE(y, y, 0, 1));
    pair_store(p + at[2], SHUFFLE(x, x, 2, 3));
    pair_store(p + at[3], SHUFFLE(y, y, 2, 3));
    pair_store(p + at[4], SHUFFLE(x, x, 4, 5));
    pair_store(p + at[5], SHUFFLE(y, y, 4, 5));
    pair_store(p + at[6], SHUFFLE(x, x, 6, 7));
    pair_store(p + at[7], SHUFFLE(y, y, 6, 7));
    lanes_scatter(p + 2, at, a[2]);
}

/** As four_transpose, of the lower and the upper halves. */
VTI_INLINE void halves_transpose(const lanes r[4], lanes c[4])
{
    const lanes x = SHUFFLE(r[0], r[1], 0, 8, 2, 10, 4, 12, 6, 14), y = SHUFFLE(r[0], r[1], 1, 9, 3, 11, 5, 13, 7, 15);
    const lanes z = SHUFFLE(r[2], r[3], 0, 8, 2, 10, 4, 12, 6, 14), w = SHUFFLE(r[2], r[3], 1, 9, 3, 11, 5, 13, 7, 15);
    c[0] = SHUFFLE(x, z, 0, 1, 8, 9, 4, 5, 12, 13);
    c[1] = SHUFFLE(y, w, 0, 1, 8, 9, 4, 5, 12, 13);
    c[2] = SHUFFLE(x, z, 2, 3, 10, 11, 6, 7, 14, 15);
    c[3] = SHUFFLE(y, w, 2, 3, 10, 11, 6, 7, 14, 15);
}

VTI_INLINE void lanes_quads(const double *p, const int64_t at[8], lanes a[4])
{
    lanes r[4];
    for (int l = 0; l < 4; ++l)
        r[l] = two_fours(*(const four_there *)(p + at[l]), *(const four_there *)(p + at[l + 4]));
    halves_transpose(r, a);
}

VTI_INLINE void lanes_unquad(double *p, const int64_t at[8], const lanes a[4])
{
    lanes r[4];
    halves_transpose(a, r);
    for (int l = 0; l < 4; ++l) {
        *(four_there *)(p + at[l]) = lower(r[l]);
        *(four_there *)(p + at[l + 4]) = upper(r[l]);
    }
}

#endif
