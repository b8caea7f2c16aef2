/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A packing of spheres, its list of neighbours, and the same pairs by brute force. */
#ifndef VTI_TESTS_PACKING_H
#define VTI_TESTS_PACKING_H

#include "support.h"

#include "neighbours.h"

enum { PACKING_MAX = 600, STRIDE = 4 }; /* positions stand in rows of 4, the last of which nobody may touch */

typedef struct packing {
    int n;
    double x[PACKING_MAX][STRIDE], v[PACKING_MAX][3], diameter[PACKING_MAX];
    int64_t excluded[PACKING_MAX][2];
    int excluded_count;
    char is_excluded[PACKING_MAX][PACKING_MAX];
    struct neighbours list;
    struct message message;
} packing;

static inline vti_view packing_x(packing *b)
{
    vti_view view = vti_view_packed(b->x[0]);
    view.stride = STRIDE;
    return view;
}

static inline void packing_create(packing *b, double skin)
{
    const vti_scalars diameter = vti_scalars_array(b->diameter);
    if (neighbours_create(&b->list, b->n, &diameter, skin, b->excluded_count, b->excluded[0], &b->message) != 0)
        fail_msg("%s", b->message.text);
}

static inline int packing_update(packing *b)
{
    const vti_view x = packing_x(b);
    const int result = neighbours_update(&b->list, &x, &b->message);
    if (result < 0)
        fail_msg("%s", b->message.text);
    return result;
}

/** n spheres in a cube of the half side size, of diameters from 1 to ratio. */
static inline void packing_scatter(packing *b, rng *g, int n, double size, double ratio)
{
    memset(b, 0, sizeof *b);
    b->n = n;
    for (int i = 0; i < n; ++i) {
        random_vector(g, size, b->x[i]);
        b->x[i][3] = NAN;
        b->diameter[i] = uniform(g, 1.0, ratio);
    }
}

/** Excludes count pairs, near ones among them, each way round and some of them twice. */
static inline void packing_exclude(packing *b, rng *g, int count)
{
    for (int k = 0; k < count; ++k) {
        const int i = rng_below(g, b->n), j = k % 3 == 0 ? (i + 1) % b->n : rng_below(g, b->n);
        b->excluded[k][0] = i;
        b->excluded[k][1] = j;
        b->is_excluded[i][j] = b->is_excluded[j][i] = 1;
    }
    b->excluded_count = count;
}

/** The distance of two surfaces. */
static inline double packing_gap(const packing *b, int64_t i, int64_t j)
{
    const double d[3] = {b->x[i][0] - b->x[j][0], b->x[i][1] - b->x[j][1], b->x[i][2] - b->x[j][2]};
    return vti_norm(d) - 0.5 * b->diameter[i] - 0.5 * b->diameter[j];
}

/** Ascending, in range, without the excluded: whatever the positions. */
static inline void assert_in_order(const packing *b)
{
    const int64_t *const p = b->list.pair;
    for (int64_t k = 0; k < b->list.count; ++k) {
        const int64_t i = p[2 * k], j = p[2 * k + 1];
        if (!(0 <= i && i < j && j < b->n))
            fail_msg("pair %d is (%d, %d)", (int)k, (int)i, (int)j);
        if (k > 0 && !(p[2 * k - 2] < i || (p[2 * k - 2] == i && p[2 * k - 1] < j)))
            fail_msg("pair %d, (%d, %d), is not after the one before", (int)k, (int)i, (int)j);
        if (b->is_excluded[i][j])
            fail_msg("(%d, %d) is excluded", (int)i, (int)j);
    }
}

/** In order, and every pair whose gap is below the limit is there; returns how many those are. */
static inline int64_t assert_complete(const packing *b, double limit)
{
    int64_t k = 0, near = 0;
    assert_in_order(b);
    for (int i = 0; i < b->n; ++i)
        for (int j = i + 1; j < b->n; ++j) {
            const int64_t *const p = b->list.pair + 2 * k;
            const int is_there = k < b->list.count && p[0] == i && p[1] == j;
            k += is_there;
            if (b->is_excluded[i][j] || !(packing_gap(b, i, j) < limit))
                continue;
            if (!is_there)
                fail_msg("(%d, %d) is missing, with a gap of %.17g", i, j, packing_gap(b, i, j));
            ++near;
        }
    return near;
}

#endif
