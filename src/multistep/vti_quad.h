/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A quad: four numbers of one body in vector registers, PARTS parts of them, so that a body alone is served as one of
 * many; in eight lanes those of AT_ONCE = 2 bodies, one after the other. +, -, * and / are C's own on each part,
 * for (int k = 0; k < PARTS; ++k), and do with every number what they do with one; so the bits do not depend on the
 * width.
 *     quad_load, quad_store  four numbers at p and, of the second body, at p + apart
 *     quad_of                (x, y, z, w), of each body
 *     quad_get               a number of a body
 *     quad_three_and         (a0, a1, a2, b1)
 *     quad_and_three         (a2, b1, b2, b3) */

#ifndef VTI_QUAD_H
#define VTI_QUAD_H

#include "../lanes/vti_lanes.h"

#if VTI_WIDTH == 8
typedef lanes part;
#elif VTI_WIDTH == 4
typedef four part;
typedef four_there part_there;
#elif VTI_WIDTH == 2
typedef pair part;
typedef pair_there part_there;
#else
typedef double part, part_there;
#endif

enum { PARTS = 4 / (WIDTH < 4 ? WIDTH : 4), IN_PART = 4 / PARTS, AT_ONCE = WIDTH < 8 ? 1 : 2 };

#if VTI_WIDTH == 8

VTI_INLINE void quad_load(const double *p, int64_t apart, part a[PARTS])
{
    a[0] = two_fours(*(const four_there *)p, *(const four_there *)(p + apart));
}

VTI_INLINE void quad_store(double *p, int64_t apart, const part a[PARTS])
{
    *(four_there *)p = lower(a[0]);
    *(four_there *)(p + apart) = upper(a[0]);
}

#else

VTI_INLINE void quad_load(const double *p, int64_t apart, part a[PARTS])
{
    (void)apart;
    for (int k = 0; k < PARTS; ++k)
        a[k] = *(const part_there *)(p + k * IN_PART);
}

VTI_INLINE void quad_store(double *p, int64_t apart, const part a[PARTS])
{
    (void)apart;
    for (int k = 0; k < PARTS; ++k)
        *(part_there *)(p + k * IN_PART) = a[k];
}

#endif

#if VTI_WIDTH == 8

VTI_INLINE void quad_of(const double x[AT_ONCE], const double y[AT_ONCE], const double z[AT_ONCE],
                        const double w[AT_ONCE], part a[PARTS])
{
    a[0] = two_fours((four){x[0], y[0], z[0], w[0]}, (four){x[1], y[1], z[1], w[1]});
}

VTI_INLINE double quad_get(const part a[PARTS], int body, int l)
{
    return a[0][4 * body + l];
}

VTI_INLINE void quad_three_and(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = SHUFFLE(a[0], b[0], 0, 1, 2, 9, 4, 5, 6, 13);
}

VTI_INLINE void quad_and_three(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = SHUFFLE(a[0], b[0], 2, 9, 10, 11, 6, 13, 14, 15);
}

#elif VTI_WIDTH == 4

VTI_INLINE void quad_of(const double x[AT_ONCE], const double y[AT_ONCE], const double z[AT_ONCE],
                        const double w[AT_ONCE], part a[PARTS])
{
    a[0] = (part){x[0], y[0], z[0], w[0]};
}

VTI_INLINE double quad_get(const part a[PARTS], int body, int l)
{
    (void)body;
    return a[0][l];
}

VTI_INLINE void quad_three_and(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = SHUFFLE(a[0], b[0], 0, 1, 2, 5);
}

VTI_INLINE void quad_and_three(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = SHUFFLE(a[0], b[0], 2, 5, 6, 7);
}

#elif VTI_WIDTH == 2

VTI_INLINE void quad_of(const double x[AT_ONCE], const double y[AT_ONCE], const double z[AT_ONCE],
                        const double w[AT_ONCE], part a[PARTS])
{
    a[0] = (part){x[0], y[0]};
    a[1] = (part){z[0], w[0]};
}

VTI_INLINE double quad_get(const part a[PARTS], int body, int l)
{
    (void)body;
    return a[l / 2][l % 2];
}

VTI_INLINE void quad_three_and(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = a[0];
    r[1] = SHUFFLE(a[1], b[0], 0, 3);
}

VTI_INLINE void quad_and_three(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    r[0] = SHUFFLE(a[1], b[0], 0, 3);
    r[1] = b[1];
}

#else

VTI_INLINE void quad_of(const double x[AT_ONCE], const double y[AT_ONCE], const double z[AT_ONCE],
                        const double w[AT_ONCE], part a[PARTS])
{
    a[0] = x[0];
    a[1] = y[0];
    a[2] = z[0];
    a[3] = w[0];
}

VTI_INLINE double quad_get(const part a[PARTS], int body, int l)
{
    (void)body;
    return a[l];
}

VTI_INLINE void quad_three_and(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    quad_of(a, a + 1, a + 2, b + 1, r);
}

VTI_INLINE void quad_and_three(const part a[PARTS], const part b[PARTS], part r[PARTS])
{
    quad_of(a + 2, b + 1, b + 2, b + 3, r);
}

#endif

#endif
