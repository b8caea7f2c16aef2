/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The table of what touches hold: open addressing, the next slot where one is taken; what is taken out leaves no gap,
 * as those behind it move up. Slots depend on the order of insertion; results do not. */
#ifndef VTI_HISTORY_H
#define VTI_HISTORY_H

#include <stddef.h>

#include "vti.h"

static inline int64_t vti_history_home(const vti_history *t, int64_t i, int64_t j)
{
    const uint64_t key = (uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) + (uint64_t)j;
    return (int64_t)(key * UINT64_C(0xbf58476d1ce4e5b9) >> 32 & (uint64_t)(t->slots - 1));
}

/** The slot of the touch, or the empty one where it would be; i and j are those of vti_held. */
static inline vti_held *vti_history_at(const vti_history *t, int64_t i, int64_t j)
{
    int64_t k = vti_history_home(t, i, j);
    while (t->slot[k].i != 0 && !(t->slot[k].i == i && t->slot[k].j == j))
        k = (k + 1) & (t->slots - 1);
    return &t->slot[k];
}

/** What the touch holds; NULL if that is nothing. */
static inline const vti_held *vti_history_find(const vti_history *t, int64_t i, int64_t j)
{
    const vti_held *at = vti_history_at(t, i, j);
    return at->i != 0 ? at : NULL;
}

static inline void vti_history_remove(vti_history *t, vti_held *held)
{
    const int64_t mask = t->slots - 1;
    int64_t gap = held - t->slot;
    for (int64_t k = (gap + 1) & mask; t->slot[k].i != 0; k = (k + 1) & mask) {
        const int64_t home = vti_history_home(t, t->slot[k].i, t->slot[k].j);
        if (((k - home) & mask) < ((k - gap) & mask)) /* at home behind the gap */
            continue;
        t->slot[gap] = t->slot[k];
        gap = k;
    }
    t->slot[gap].i = 0;
    --t->used;
}

#endif
