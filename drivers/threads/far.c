/* SPDX-License-Identifier: BSD-3-Clause
 * Mostly no vector is long, and a bound by components, which takes numbers as they lie in memory, is enough: a vector
 * with no component above (limit/3)^{1/2} is not longer than limit^{1/2}. */
#include "far.h"

#include <stddef.h>

#include "wide.h"

/** So many vectors have their bound at once; three times as many are a whole number of registers. */
enum { BLOCK = 16 };

/** Whether some vector of a block may be long. A third of the limit is less here, by far more than rounding takes. */
VTI_INLINE int block_may(const double *x, const double *from, const double shared[3 * BLOCK], double limit)
{
    const double third = 0.333 * limit;
    int64_t count = 0;
    for (int k = 0; k < 3 * BLOCK; ++k) {
        const double d = x[k] - (from != NULL ? from[k] : 0.0) - shared[k];
        count += !(d * d <= third);
    }
    return count > 0;
}

/** Whether some of a block is long, by its length: those sums that is_any has. */
VTI_INLINE int block_is(const double *x, const double *from, const double shared[3 * BLOCK], double limit)
{
    double squares[3 * BLOCK];
    int64_t count = 0;
    for (int k = 0; k < 3 * BLOCK; ++k) {
        const double d = x[k] - (from != NULL ? from[k] : 0.0) - shared[k];
        squares[k] = d * d;
    }
    for (int i = 0; i < BLOCK; ++i)
        count += !(squares[3 * i] + squares[3 * i + 1] + squares[3 * i + 2] <= limit);
    return count > 0;
}

/** Whether some of so many vectors is long, by its length. */
VTI_INLINE int is_any(const double *const x[3], int64_t stride, int64_t count, const double *from,
                      const double shared[3], double limit)
{
    for (int64_t i = 0; i < count; ++i) {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double d = x[k][i * stride] - (from != NULL ? from[3 * i + k] : 0.0) - shared[k];
            sum += d * d;
        }
        if (!(sum <= limit))
            return 1;
    }
    return 0;
}

VTI_INLINE int is_any_packed(const double *x, int64_t count, const double *from, const double shared[3], double limit)
{
    return is_any((const double *const[3]){x, x + 1, x + 2}, 3, count, from, shared, limit);
}

/** from is NULL or not in each of two calls, so that each has a loop of its own. */
VTI_INLINE int any_of_packed(const double *x, int64_t count, const double *from, const double shared[3], double limit)
{
    double every[3 * BLOCK];
    int64_t i = 0;
    for (int k = 0; k < 3 * BLOCK; ++k)
        every[k] = shared[k % 3];
    for (; i + BLOCK <= count; i += BLOCK) {
        const double *const there = from != NULL ? from + 3 * i : NULL;
        if (block_may(x + 3 * i, there, every, limit) && block_is(x + 3 * i, there, every, limit))
            return 1;
    }
    return is_any_packed(x + 3 * i, count - i, from != NULL ? from + 3 * i : NULL, shared, limit);
}

VTI_INLINE void any_packed_loops(const double *x, int64_t count, const double *from, const double shared[3],
                                 double limit, int *any)
{
    *any = from != NULL ? any_of_packed(x, count, from, shared, limit) : any_of_packed(x, count, NULL, shared, limit);
}

static void any_packed(const double *x, int64_t count, const double *from, const double shared[3], double limit,
                       int *any);
WIDE(any_packed, (const double *x, int64_t count, const double *from, const double shared[3], double limit, int *any),
     (x, count, from, shared, limit, any))

int far_any(const vti_view *x, int64_t begin, int64_t end, const double *from, const double shared[3], double limit)
{
    const int64_t at = begin * x->stride;
    const double *const first[3] = {x->c[0] + at, x->c[1] + at, x->c[2] + at};
    const double *const there = from != NULL ? from + 3 * begin : NULL;
    int any;
    if (x->stride != 3 || first[1] != first[0] + 1 || first[2] != first[0] + 2)
        return is_any(first, x->stride, end - begin, there, shared, limit);
    any_packed(first[0], end - begin, there, shared, limit, &any);
    return any;
}
