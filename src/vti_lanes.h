/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Lanes: a vector of numbers, one of each of WIDTH bodies or bonds, as wide as the file is compiled for. +, -, * and /
 * are C's own and do in every lane what they do with one number, so that the bits do not depend on the width. Where the
 * compiler has no such vectors WIDTH is 1, and lanes are a number.
 *
 * For every width there are
 *     lanes_all      whether a comparison holds in all lanes
 *     lanes_bits     where it does, bit l for lane l
 *     lanes_told     of each lane: -1 where it does, 0 else
 *     lanes_zero     where whole numbers are 0
 *     lanes_where    a where a comparison holds, b elsewhere
 *     lanes_flip     -a where b is -0, a where it is 0
 *     lanes_half_to  2^-k of whole 0 <= k <= 1022
 *     lanes_gather   p[at[0]], p[at[1]], ...                                               lanes_scatter   the way back
 *     lanes_triples  the components of three-vectors that begin at p[at[0]], p[at[1]], ... lanes_untriple  the way back
 *     lanes_quads    those of four numbers that begin there                                lanes_unquad    the way back
 *     triple         three numbers that lie side by side, to be added to others
 * and for two and more, which take bodies in their order,
 *     lanes_split    the components of WIDTH packed three-vectors                          lanes_join      the way back
 *     lanes_spread   k of each body three times, as the components of packed vectors lie */
#ifndef VTI_LANES_H
#define VTI_LANES_H

#include <string.h>

#include "vti_internal.h"

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

#if VTI_WIDTH > 1

#define VECTOR(N) __attribute__((vector_size(8 * (N))))
/** The same where it lies in memory: aligned as numbers are. */
#define THERE(N) __attribute__((vector_size(8 * (N)), aligned(8), may_alias))
#define SHUFFLE __builtin_shufflevector

typedef double lanes VECTOR(VTI_WIDTH);
typedef int64_t lanes_mask VECTOR(VTI_WIDTH);
typedef double lanes_there THERE(VTI_WIDTH);
typedef double pair VECTOR(2);
typedef double pair_there THERE(2);

VTI_INLINE lanes lanes_load(const double *p)
{
    return *(const lanes_there *)p;
}

VTI_INLINE void lanes_store(double *p, lanes a)
{
    *(lanes_there *)p = a;
}

VTI_INLINE lanes lanes_of(double x)
{
    const lanes zero = {0.0};
    return x - zero; /* and not a sum, which would lose the sign of -0 */
}

VTI_INLINE double lanes_get(lanes a, int l)
{
    return a[l];
}

VTI_INLINE void lanes_told(lanes_mask m, int64_t p[WIDTH])
{
    memcpy(p, &m, sizeof m);
}

VTI_INLINE lanes_mask lanes_zero(const int64_t p[WIDTH])
{
    lanes_mask m;
    memcpy(&m, p, sizeof m);
    return m == 0;
}

VTI_INLINE lanes lanes_sqrt(lanes a)
{
    for (int l = 0; l < WIDTH; ++l)
        a[l] = sqrt(a[l]);
    return a;
}

/** Bits of a where m has ones, of b where it has zeros. */
VTI_INLINE lanes lanes_merge(lanes_mask m, lanes a, lanes b)
{
#if VTI_WIDTH == 8 && !defined(__clang__)
    /* the same as below: gcc makes three operations of where(m, a, b) and where(m, b, a), which share one, and not two */
    typedef long long eight VECTOR(8);
    return (lanes)__builtin_ia32_pternlogq512_mask((eight)m, (eight)a, (eight)b, 0xca, (unsigned char)-1);
#else
    return (lanes)((m & (lanes_mask)a) | (~m & (lanes_mask)b));
#endif
}

VTI_INLINE lanes lanes_where(lanes_mask m, lanes a, lanes b)
{
#if VTI_WIDTH == 4 /* the only width for which gcc does not find the one instruction */
    return __builtin_ia32_blendvpd256(b, a, (lanes)m);
#else
    return lanes_merge(m, a, b);
#endif
}

VTI_INLINE lanes lanes_copysign(lanes a, lanes b)
{
    return lanes_merge((lanes_mask)lanes_of(-0.0), b, a);
}

VTI_INLINE lanes lanes_abs(lanes a)
{
    return lanes_copysign(a, lanes_of(0.0));
}

VTI_INLINE lanes lanes_flip(lanes a, lanes b)
{
    return (lanes)((lanes_mask)a ^ (lanes_mask)b);
}

VTI_INLINE lanes lanes_half_to(lanes k)
{
    typedef uint64_t bits VECTOR(VTI_WIDTH);
    return (lanes)((UINT64_C(1023) << 52) - ((bits)(k + 0x1.8p52) << 52));
}

VTI_INLINE pair pair_load(const double *p)
{
    return *(const pair_there *)p;
}

VTI_INLINE void pair_store(double *p, pair a)
{
    *(pair_there *)p = a;
}

struct triple {
    pair xy;
    double z;
};

VTI_INLINE struct triple triple_of(double x, double y, double z)
{
    return (struct triple){{x, y}, z};
}

VTI_INLINE struct triple triple_load(const double *p)
{
    return (struct triple){pair_load(p), p[2]};
}

VTI_INLINE void triple_store(double *p, struct triple a)
{
    pair_store(p, a.xy);
    p[2] = a.z;
}

VTI_INLINE struct triple triple_plus(struct triple a, struct triple b)
{
    return (struct triple){a.xy + b.xy, a.z + b.z};
}

VTI_INLINE struct triple triple_minus(struct triple a, struct triple b)
{
    return (struct triple){a.xy - b.xy, a.z - b.z};
}

/* ---- two --------------------------------------------------------------------------------------------------------- */

#if VTI_WIDTH == 2

VTI_INLINE int lanes_all(lanes_mask m)
{
    return (m[0] & m[1]) != 0;
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

#else

/* ---- four: what eight are made of, too --------------------------------------------------------------------------- */

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

#if VTI_WIDTH == 4

VTI_INLINE int lanes_all(lanes_mask m)
{
    return four_bits(m) == 15;
}

VTI_INLINE void lanes_split(const lanes p[3], lanes a[3])
{
    const lanes x = SHUFFLE(p[0], p[1], 0, 1, 6, 7); /* x0 y0 x2 y2 */
    const lanes y = SHUFFLE(p[0], p[2], 2, 3, 4, 5); /* z0 x1 z2 x3 */
    const lanes z = SHUFFLE(p[1], p[2], 0, 1, 6, 7); /* y1 z1 y3 z3 */
    a[0] = SHUFFLE(x, y, 0, 5, 2, 7);
    a[1] = SHUFFLE(x, z, 1, 4, 3, 6);
    a[2] = SHUFFLE(y, z, 0, 5, 2, 7);
}

VTI_INLINE void lanes_join(const lanes a[3], lanes p[3])
{
    const lanes x = SHUFFLE(a[0], a[1], 0, 4, 2, 6);
    const lanes y = SHUFFLE(a[2], a[0], 0, 5, 2, 7);
    const lanes z = SHUFFLE(a[1], a[2], 1, 5, 3, 7);
    p[0] = SHUFFLE(x, y, 0, 1, 4, 5);
    p[1] = SHUFFLE(z, x, 0, 1, 6, 7);
    p[2] = SHUFFLE(y, z, 2, 3, 6, 7);
}

VTI_INLINE void lanes_spread(lanes k, lanes p[3])
{
    p[0] = SHUFFLE(k, k, 0, 0, 0, 1);
    p[1] = SHUFFLE(k, k, 1, 1, 2, 2);
    p[2] = SHUFFLE(k, k, 2, 3, 3, 3);
}

#define lanes_bits four_bits
#define lanes_gather four_gather
#define lanes_scatter four_scatter
#define lanes_triples four_triples
#define lanes_untriple four_untriple
#define lanes_quads four_quads
#define lanes_unquad four_unquad

#else

/* ---- eight ------------------------------------------------------------------------------------------------------- */

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
#endif

/* ---- one --------------------------------------------------------------------------------------------------------- */

#else

typedef double lanes;
typedef int lanes_mask;

VTI_INLINE lanes lanes_load(const double *p)
{
    return *p;
}

VTI_INLINE void lanes_store(double *p, lanes a)
{
    *p = a;
}

VTI_INLINE lanes lanes_of(double x)
{
    return x;
}

VTI_INLINE double lanes_get(lanes a, int l)
{
    (void)l;
    return a;
}

VTI_INLINE void lanes_told(lanes_mask m, int64_t p[1])
{
    p[0] = m ? -1 : 0;
}

VTI_INLINE lanes_mask lanes_zero(const int64_t p[1])
{
    return p[0] == 0;
}

VTI_INLINE lanes lanes_sqrt(lanes a)
{
    return sqrt(a);
}

VTI_INLINE lanes lanes_where(lanes_mask m, lanes a, lanes b)
{
    return m ? a : b;
}

VTI_INLINE lanes lanes_copysign(lanes a, lanes b)
{
    return copysign(a, b);
}

VTI_INLINE lanes lanes_abs(lanes a)
{
    return fabs(a);
}

VTI_INLINE int lanes_all(lanes_mask m)
{
    return m;
}

VTI_INLINE unsigned lanes_bits(lanes_mask m)
{
    return (unsigned)m;
}

VTI_INLINE lanes lanes_flip(lanes a, lanes b)
{
    return copysign(1.0, b) * a;
}

VTI_INLINE lanes lanes_half_to(lanes k)
{
    uint64_t bits;
    double power = k + 0x1.8p52;
    memcpy(&bits, &power, sizeof bits);
    bits = (UINT64_C(1023) << 52) - (bits << 52);
    memcpy(&power, &bits, sizeof power);
    return power;
}

VTI_INLINE lanes lanes_gather(const double *p, const int64_t at[1])
{
    return p[at[0]];
}

VTI_INLINE void lanes_scatter(double *p, const int64_t at[1], lanes a)
{
    p[at[0]] = a;
}

/** Of n numbers side by side. */
#define SIDE_BY_SIDE(WHAT, BACK, N)                                                                                    \
    VTI_INLINE void lanes_##WHAT(const double *p, const int64_t at[1], lanes a[N])                                     \
    {                                                                                                                  \
        for (int k = 0; k < (N); ++k)                                                                                  \
            a[k] = p[at[0] + k];                                                                                       \
    }                                                                                                                  \
    VTI_INLINE void lanes_##BACK(double *p, const int64_t at[1], const lanes a[N])                                     \
    {                                                                                                                  \
        for (int k = 0; k < (N); ++k)                                                                                  \
            p[at[0] + k] = a[k];                                                                                       \
    }
SIDE_BY_SIDE(triples, untriple, 3)
SIDE_BY_SIDE(quads, unquad, 4)
#undef SIDE_BY_SIDE

struct triple {
    double x, y, z;
};

VTI_INLINE struct triple triple_of(double x, double y, double z)
{
    return (struct triple){x, y, z};
}

VTI_INLINE struct triple triple_load(const double *p)
{
    return triple_of(p[0], p[1], p[2]);
}

VTI_INLINE void triple_store(double *p, struct triple a)
{
    p[0] = a.x;
    p[1] = a.y;
    p[2] = a.z;
}

VTI_INLINE struct triple triple_plus(struct triple a, struct triple b)
{
    return triple_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

VTI_INLINE struct triple triple_minus(struct triple a, struct triple b)
{
    return triple_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

#endif

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
