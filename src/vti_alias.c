/* SPDX-License-Identifier: BSD-3-Clause
 * Which views share memory. Component k of body i is the double number word[k] + i stride of all memory, so that two
 * components share one if word_a + i stride_a = word_b + j stride_b for some bodies i and j of the slice. That needs no
 * look at bodies, and no loop over them. */
#include "vti_ready.h"

/** More doubles than there is memory for. */
#define FAR (INT64_C(1) << 56)

/** The numbers i stride of the bodies first <= i <= last. */
struct bodies_range {
    int64_t first, last;
};

/** What a view reaches: the words of its components for body 0, of which low and high are the outermost, and the
 *  outermost words of all bodies. */
struct reach {
    int64_t word[4];
    int64_t components, stride, low, high, begin, end, quantity;
};

/** i stride, held within what can be added to a word. */
static inline int64_t offset(int64_t i, int64_t stride)
{
    if (i == 0)
        return 0;
    const double product = (double)i * (double)stride;
    if (fabs(product) < 0x1p61)
        return i * stride;
    return product < 0.0 ? -(INT64_C(1) << 61) : INT64_C(1) << 61;
}

static inline int64_t lower(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static inline int64_t higher(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static inline int64_t word_of(const double *p)
{
    return (int64_t)((uintptr_t)p / sizeof(double));
}

/** Appends what a view reaches, if it is there; returns how many there are. w is the fourth component, where there is
 *  one. */
VTI_INLINE int add(struct reach *all, int n, double *const c[3], const double *w, int64_t stride,
                   const struct bodies_range *range, int64_t quantity)
{
    if (c[0] == NULL)
        return n;
    struct reach *r = &all[n];
    r->components = w != NULL ? 4 : 3;
    r->stride = stride;
    r->quantity = quantity;
    const int64_t x = word_of(c[0]), y = word_of(c[1]), z = word_of(c[2]);
    r->word[0] = x;
    r->word[1] = y;
    r->word[2] = z;
    r->word[3] = w != NULL ? word_of(w) : z;
    r->low = lower(lower(x, y), lower(z, r->word[3]));
    r->high = higher(higher(x, y), higher(z, r->word[3]));
    const int64_t first = offset(range->first, stride), last = offset(range->last, stride);
    r->begin = r->low + lower(first, last);
    r->end = r->high + higher(first, last);
    return n + 1;
}

static int64_t magnitude(int64_t a)
{
    return a < 0 ? -a : a;
}

/** Whether d is a whole number of strides, not more than from the first body to the last. */
static int same_stride_meets(int64_t d, int64_t stride, const struct bodies_range *range)
{
    if (d == 0)
        return 1;
    return stride != 0 && d % stride == 0 && magnitude(d / stride) <= range->last - range->first;
}

/** The greatest common divisor g of positive a and m; *inverse of a/g modulo m/g, by Euclid. */
static int64_t divisor(int64_t a, int64_t m, int64_t *inverse)
{
    int64_t r = m, next = a % m, u = 0, v = 1;
    while (next != 0) {
        const int64_t q = r / next, rest = r % next, w = u - q * v;
        r = next;
        next = rest;
        u = v;
        v = w;
    }
    *inverse = u;
    return r;
}

/** The quotient rounded up; by > 0. */
static int64_t ceiling(int64_t a, int64_t by)
{
    return a / by + (a % by > 0);
}

/** Whether i s - j t = d for some i and j of the range. Of i s = d (mod |t|) the solutions are i0 + k |t|/g, with g the
 *  divisor that s and t share; along them j goes in steps of s/g or -s/g. */
static int strides_meet(int64_t d, int64_t s, int64_t t, const struct bodies_range *range)
{
    const int64_t first = range->first, last = range->last < FAR ? range->last : FAR;
    if (first == last)
        return offset(first, s) - offset(first, t) == d;
    if (s > INT32_MAX || s < -INT32_MAX || t > INT32_MAX || t < -INT32_MAX || magnitude(d) > FAR || first > last)
        return 0;
    int64_t inverse;
    const int64_t g = divisor(magnitude(s), magnitude(t), &inverse), period = magnitude(t) / g;
    if (d % g != 0)
        return 0;
    int64_t i0 = d / g % period * (inverse % period) % period;
    i0 = s < 0 ? -i0 : i0;
    i0 += i0 < 0 ? period : 0;
    int64_t j0 = (i0 * s - d) / t, step = period * s / t;
    if (step < 0) { /* the same range from its other end */
        j0 = first + last - j0;
        step = -step;
    }
    const int64_t from_i = ceiling(first - i0, period), from_j = ceiling(first - j0, step);
    const int64_t k = higher(from_i, from_j);
    return k <= (last - i0) / period && i0 + k * period <= last && k <= (last - j0) / step && j0 + k * step <= last;
}

static int meet(const struct reach *a, int k, const struct reach *b, int l, const struct bodies_range *range)
{
    const int64_t d = b->word[l] - a->word[k];
    return a->stride == b->stride ? same_stride_meets(d, a->stride, range)
                                  : strides_meet(d, a->stride, b->stride, range);
}

/** Whether all words of a lie within less than one stride, so that those of no two bodies meet. */
static int within_stride(int64_t low, int64_t high, int64_t stride)
{
    return high - low < stride || low - high > stride;
}

/** Arrays apart, or members of one struct; what is neither is looked at component by component. */
static inline int views_meet(const struct reach *a, const struct reach *b, const struct bodies_range *range)
{
    if (a->end < b->begin || b->end < a->begin)
        return 0;
    const int64_t low = lower(a->low, b->low), high = higher(a->high, b->high);
    if (a->stride == b->stride && (a->high < b->low || b->high < a->low) && within_stride(low, high, a->stride))
        return 0;
    for (int k = 0; k < a->components; ++k)
        for (int l = 0; l < b->components; ++l)
            if (meet(a, k, b, l, range))
                return 1;
    return 0;
}

static int components_meet(const struct reach *a, const struct bodies_range *range)
{
    if (within_stride(a->low, a->high, a->stride))
        return 0;
    for (int k = 0; k < a->components; ++k)
        for (int l = 0; l < k; ++l)
            if (meet(a, k, a, l, range))
                return 1;
    return 0;
}

int vti_alias_check(const vti_bodies *b, vti_fault *fault)
{
    const struct bodies_range range = {b->first, b->first + b->count - 1};
#define COUNT(constant, number, member, type, role) +1
    struct reach all[VTI_QUANTITIES(COUNT)];
    int n = 0;
    /* what is one for all is only read, as scalars are */
#define STATE_ADDS(member) 1
#define LOAD_ADDS(member) 1
#define LOW_ADDS(member) 1
#define CONSTANT_ADDS(member) (b->member.stride != 0)
#define ADD_vti_view(member, quantity, adds)                                                                           \
    if (adds(member))                                                                                                  \
        n = add(all, n, b->member.c, NULL, b->member.stride, &range, quantity);
#define ADD_vti_quat_view(member, quantity, adds)                                                                      \
    if (adds(member))                                                                                                  \
        n = add(all, n, b->member.xyzw, b->member.xyzw[3], b->member.stride, &range, quantity);
#define ADD_vti_scalars(member, quantity, adds) /* only read */
#define ADD(constant, number, member, type, role) ADD_##type(member, constant, role##_ADDS)
    VTI_QUANTITIES(ADD)
    for (int i = 0; i < n; ++i) {
        if (components_meet(&all[i], &range))
            return vti_refuse(VTI_E_STRIDE, -1, 0.0, all[i].quantity, fault);
        for (int j = 0; j < i; ++j)
            if (views_meet(&all[i], &all[j], &range))
                return vti_refuse(VTI_E_ALIAS, -1, 0.0, all[i].quantity, fault);
    }
    return VTI_OK;
}
