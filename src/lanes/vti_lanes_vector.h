/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Lanes of two and more: what is the same for all of them. */
#ifndef VTI_LANES_VECTOR_H
#define VTI_LANES_VECTOR_H

#include <string.h>

#include "vti.h"

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

VTI_INLINE int lanes_all(lanes_mask m);

VTI_INLINE int lanes_are_row(const int64_t p[2 * WIDTH])
{
    lanes_mask first, last, up, up_later; /* the last numbers overlap the first ones in one */
    for (int k = 0; k < WIDTH; ++k) {
        up[k] = (k + 1) / 2;
        up_later[k] = (k + WIDTH) / 2;
    }
    memcpy(&first, p, sizeof first);
    memcpy(&last, p + WIDTH - 1, sizeof last);
    return lanes_all(((first - up - p[0]) | (last - up_later - p[0])) == 0);
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
    /* the same as below: gcc makes three operations of where(m, a, b) and where(m, b, a), which share one, and not
     * two */
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

#endif
