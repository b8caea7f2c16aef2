/* SPDX-License-Identifier: BSD-3-Clause */
#include "partings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double partings_touching(const vti_scalars *diameter, int64_t i, int64_t j)
{
    /* to the bit as contacts have it */
    return 0.5 * diameter->p[i * diameter->stride] + 0.5 * diameter->p[j * diameter->stride];
}

double partings_distance(const vti_view *x, int64_t i, int64_t j)
{
    double d[3];
    for (int k = 0; k < 3; ++k)
        d[k] = x->c[k][i * x->stride] - x->c[k][j * x->stride];
    return sqrt(vti_dot(d, d));
}

static int is_before(const struct parting *a, int64_t i, int64_t j)
{
    return a->i < i || (a->i == i && a->j < j);
}

static int add(struct partings *p, struct parting one)
{
    if (p->count == p->room) {
        const int64_t room = 2 * p->room + 16;
        struct parting *list = realloc(p->list, (size_t)room * sizeof *list);
        if (list == NULL)
            return -1;
        p->list = list;
        p->room = room;
    }
    int64_t at = p->count;
    for (; at > 0 && !is_before(&p->list[at - 1], one.i, one.j); --at)
        p->list[at] = p->list[at - 1];
    p->list[at] = one;
    ++p->count;
    p->own += one.length > 0.0;
    return 0;
}

int partings_add(struct partings *p, int64_t i, int64_t j, double distance, const vti_scalars *diameter)
{
    const int overlap = distance < partings_touching(diameter, i, j);
    const struct parting one = {i < j ? i : j, i < j ? j : i, overlap ? distance : 0.0};
    return add(p, one);
}

int64_t partings_end(struct partings *p, const vti_view *x, const vti_scalars *diameter)
{
    const int64_t before = p->own;
    for (int64_t k = 0; k < p->count && p->own > 0; ++k) {
        struct parting *one = &p->list[k];
        if (one->length > 0.0 && partings_distance(x, one->i, one->j) >= partings_touching(diameter, one->i, one->j)) {
            one->length = 0.0;
            --p->own;
        }
    }
    return before - p->own;
}

void partings_lengths(const struct partings *p, const vti_scalars *diameter, int64_t count, const int64_t *pair,
                      double *length)
{
    int64_t at = 0;
    for (int64_t k = 0; k < count; ++k) {
        const int64_t i = pair[2 * k], j = pair[2 * k + 1];
        while (at < p->count && is_before(&p->list[at], i, j))
            ++at;
        const int there = at < p->count && p->list[at].i == i && p->list[at].j == j;
        length[k] = there && p->list[at].length > 0.0 ? p->list[at].length : partings_touching(diameter, i, j);
    }
}

void partings_destroy(struct partings *p)
{
    free(p->list);
    memset(p, 0, sizeof *p);
}

/* ---- keeping them ------------------------------------------------------------------------------------------------ */

enum { NUMBERS = 3 };

int64_t partings_size(const struct partings *p)
{
    return 1 + NUMBERS * p->count;
}

void partings_get(const struct partings *p, double *memory)
{
    *memory++ = (double)p->count;
    for (int64_t k = 0; k < p->count; ++k, memory += NUMBERS) {
        memory[0] = (double)p->list[k].i;
        memory[1] = (double)p->list[k].j;
        memory[2] = p->list[k].length;
    }
}

int64_t partings_put(struct partings *p, const double *memory, int64_t left)
{
    const double count = left > 0 ? memory[0] : -1.0;
    if (!(count >= 0.0 && NUMBERS * count <= (double)(left - 1)))
        return -1;
    partings_destroy(p);
    for (int64_t k = 0; k < (int64_t)count; ++k) {
        const double *at = memory + 1 + NUMBERS * k;
        const struct parting one = {(int64_t)at[0], (int64_t)at[1], at[2]};
        if (add(p, one) != 0)
            return -1;
    }
    return partings_size(p);
}
