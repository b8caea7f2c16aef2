/* SPDX-License-Identifier: BSD-3-Clause
 * Sums of many states at once, and where the numbers of a body stand in them: what the norms (states.c) and what is
 * conserved (states_conserved.c) share. */
#ifndef VTI_STATES_PARTS_H
#define VTI_STATES_PARTS_H

#include "states.h"
#include "wide.h"

struct sums {
    int64_t count; /* of what was added; behind 0 nothing is filled in, and after 1 there is nothing in low */
    double high[PANELS_BLOCK], low[PANELS_BLOCK];
};

VTI_INLINE void sums_add(struct sums *restrict sums, const double *restrict x, int64_t n)
{
    if (sums->count++ == 0) {
        for (int64_t k = 0; k < n; ++k)
            sums->high[k] = 0.0 + x[k];
        return;
    }
    for (int64_t k = 0; k < n; ++k) {
        vti_sum sum = {sums->high[k], sums->count > 2 ? sums->low[k] : 0.0};
        vti_sum_add(&sum, x[k]);
        sums->high[k] = sum.high;
        sums->low[k] = sum.low;
    }
}

VTI_INLINE void sums_value(const struct sums *restrict sums, double *restrict x, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const vti_sum sum = {sums->count > 0 ? sums->high[k] : 0.0, sums->count > 1 ? sums->low[k] : 0.0};
        x[k] = vti_sum_value(&sum);
    }
}

VTI_INLINE void squares(const double *restrict a, double *restrict out, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const double v[3] = {a[k], a[PANELS_BLOCK + k], a[2 * PANELS_BLOCK + k]};
        out[k] = vti_dot(v, v);
    }
}

/** Places of the vectors and of the attitude in a body's numbers. */
struct places {
    int64_t vector[3], vectors, attitude, width;
};

VTI_INLINE struct places places_of(const struct states *s)
{
    struct places places = {{0, 0, 0}, 0, 0, 0};
    if (s->translates) {
        places.vector[places.vectors++] = 0;
        places.vector[places.vectors++] = 3;
        places.width = 6;
    }
    if (s->turns) {
        places.attitude = places.width;
        places.vector[places.vectors++] = places.width + 4;
        places.width += 7;
    }
    return places;
}

/** A few states more than n fill the vectors up. */
VTI_INLINE int64_t filled(int64_t n)
{
    return (n + 7) & ~INT64_C(7);
}

#endif
