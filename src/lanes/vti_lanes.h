/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Lanes: a vector of numbers, one of each of WIDTH bodies or bonds, as wide as the file is compiled for. +, -, * and /
 * are C's own and do in every lane what they do with one number, so that the bits do not depend on the width. Where the
 * compiler has no such vectors WIDTH is 1, and lanes are a number. Each width has a file, which is included here alone.
 *
 * For every width there are
 *     lanes_all      whether a comparison holds in all lanes
 *     lanes_bits     where it does, bit l for lane l
 *     lanes_told     of each lane: -1 where it does, 0 else
 *     lanes_zero     where whole numbers are 0
 *     lanes_are_row  whether 2 WIDTH whole numbers are pairs in a row, i, i + 1, i + 1, i + 2, ...; the last is any
 *     lanes_where    a where a comparison holds, b elsewhere
 *     lanes_flip     -a where b is -0, a where it is 0
 *     lanes_half_to  2^-k of whole 0 <= k <= 1022
 *     lanes_gather   p[at[0]], p[at[1]], ...                                               lanes_scatter   the way back
 *     lanes_triples  the components of three-vectors that begin at p[at[0]], p[at[1]], ... lanes_untriple  the way back
 *     lanes_after    the last number of `before`, then all of a but the last
 *     lanes_before   all of a but the first number, then `next`
 *     lanes_quads    those of four numbers that begin there                                lanes_unquad    the way back
 *     lanes_split    the components of WIDTH packed three-vectors                          lanes_join      the way back
 *     triple         three numbers that lie side by side, to be added to others
 * and for two and more, which take bodies in their order,
 *     lanes_spread   k of each body three times, as the components of packed vectors lie */
#ifndef VTI_LANES_H
#define VTI_LANES_H

#include "../vti_views.h"

#if defined(__has_builtin) && !defined(VTI_WIDTH)
#if __has_builtin(__builtin_shufflevector)
#if defined(__AVX512DQ__) && defined(__AVX512VL__)
#define VTI_WIDTH 8
#elif defined(__AVX2__)
#define VTI_WIDTH 4
#elif defined(__SSE2__) || defined(__ARM_NEON)
#define VTI_WIDTH 2
#endif
#endif
#endif
#ifndef VTI_WIDTH
#define VTI_WIDTH 1
#endif

enum { WIDTH = VTI_WIDTH };

#if VTI_WIDTH == 1
#include "vti_lanes_one.h"
#elif VTI_WIDTH == 2
#include "vti_lanes_two.h"
#elif VTI_WIDTH == 4
#include "vti_lanes_four.h"
#else
#include "vti_lanes_eight.h"
#endif

/** Whether a < b in all lanes; of eight at once, as gcc makes lanes of a < b first, and bits of these. */
VTI_INLINE int lanes_all_less(lanes a, lanes b)
{
#if VTI_WIDTH == 8 && !defined(__clang__)
    enum { LESS = 1, CURRENT = 4 }; /* _CMP_LT_OS, _MM_FROUND_CUR_DIRECTION */
    return (unsigned char)__builtin_ia32_cmppd512_mask(a, b, LESS, (unsigned char)-1, CURRENT) == 0xff;
#else
    return lanes_all(a < b);
#endif
}

/** a, 0 where it has decayed to nothing (VTI_STILL). */
VTI_INLINE lanes lanes_settled(lanes a)
{
    return lanes_where(lanes_abs(a) < VTI_STILL, 0.0 * a, a);
}

/** at[] of what lies at a stride. */
VTI_INLINE void lanes_strided(int64_t stride, int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = l * stride;
}

/** Numbers at a stride, which is 0 for one that is all of theirs. */
VTI_INLINE lanes lanes_of_scalars(const double *p, int64_t stride)
{
    int64_t at[WIDTH];
    lanes_strided(stride, at);
    return stride == 1 ? lanes_load(p) : stride == 0 ? lanes_of(*p) : lanes_gather(p, at);
}

VTI_RRV_PRODUCTS(lanes_dot, lanes_cross, lanes)
VTI_RRV_ROTATION(lanes_square, lanes_rotate, lanes_dot, lanes_cross, lanes)

#endif
