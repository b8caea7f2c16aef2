/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One lane: a number, where the compiler has no vectors. */
#ifndef VTI_LANES_ONE_H
#define VTI_LANES_ONE_H

#include <string.h>

#include "vti.h"

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

VTI_INLINE int lanes_are_row(const int64_t p[2])
{
    (void)p;
    return 1;
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

VTI_INLINE lanes lanes_after(lanes before, lanes a)
{
    (void)a;
    return before;
}

VTI_INLINE lanes lanes_before(lanes a, double next)
{
    (void)a;
    return next;
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

VTI_INLINE void lanes_split(const lanes p[3], lanes a[3])
{
    for (int k = 0; k < 3; ++k)
        a[k] = p[k];
}

VTI_INLINE void lanes_join(const lanes a[3], lanes p[3])
{
    lanes_split(a, p);
}

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
