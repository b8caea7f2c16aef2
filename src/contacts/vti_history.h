/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What touches hold lies side by side, so that who goes along a list goes through memory in order, and is found by a
 * hash table of 8 bytes a slot: open addressing, the next slot where one is taken; what is taken out leaves no gap, as
 * those behind it move up. Where things stand depends on the order in which they came; results do not. */
#ifndef VTI_HISTORY_H
#define VTI_HISTORY_H

#include <stddef.h>

#include "vti.h"

/** A slot is 0, or has the hash above 1 + the number of what is held. */
static inline uint32_t vti_history_hash(int64_t i, int64_t j)
{
    const uint64_t key = (uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) + (uint64_t)j;
    return (uint32_t)(key * UINT64_C(0xbf58476d1ce4e5b9) >> 32);
}

static inline uint32_t vti_history_hash_of(int64_t slot)
{
    return (uint32_t)((uint64_t)slot >> 32);
}

static inline vti_held *vti_history_held(const vti_history *t, int64_t slot)
{
    return &t->held[(int64_t)(uint32_t)slot - 1];
}

static inline int vti_history_is(const vti_held *held, int64_t i, int64_t j)
{
    return held->i == i && held->j == j;
}

/** What the slot of what is held so far down the list has. */
static inline int64_t vti_history_mark(const vti_history *t, int64_t number)
{
    const uint64_t hash = vti_history_hash(t->held[number].i, t->held[number].j);
    return (int64_t)(hash << 32 | (uint64_t)(number + 1));
}

/** Whether what is held so far down the list is found by the slots, whatever these hold. */
static inline int vti_history_leads(const vti_history *t, int64_t number)
{
    const int64_t mark = vti_history_mark(t, number), mask = t->slots - 1;
    int64_t k = (int64_t)vti_history_hash_of(mark) & mask, tries = t->slots;
    for (; t->slot[k] != mark && t->slot[k] != 0 && tries > 0; --tries)
        k = (k + 1) & mask;
    return t->slot[k] == mark;
}

/** Whether it holds no more than there is room for, and the slots know the first and the last of it. */
static inline int vti_history_is_whole(const vti_history *t)
{
    if (t->used < 0 || t->used >= t->slots)
        return 0;
    return t->used == 0 || (vti_history_leads(t, 0) && vti_history_leads(t, t->used - 1));
}

/** The slot of the touch, or the empty one where it would be; i and j are those of vti_held. */
static inline int64_t *vti_history_slot(const vti_history *t, int64_t i, int64_t j)
{
    const uint32_t hash = vti_history_hash(i, j);
    int64_t k = (int64_t)hash & (t->slots - 1);
    for (int64_t slot; (slot = t->slot[k]) != 0; k = (k + 1) & (t->slots - 1))
        if (vti_history_hash_of(slot) == hash && vti_history_is(vti_history_held(t, slot), i, j))
            break;
    return &t->slot[k];
}

/** What the touch holds; NULL if that is nothing. */
static inline vti_held *vti_history_find(const vti_history *t, int64_t i, int64_t j)
{
    const int64_t slot = *vti_history_slot(t, i, j);
    return slot != 0 ? vti_history_held(t, slot) : NULL;
}

/** The same for one who goes along a list, next being where the last one ended: mostly it is one of so many from there
 *  on. */
static inline vti_held *vti_history_next(const vti_history *t, int64_t i, int64_t j, int64_t most, int64_t *next)
{
    int64_t k = *next, end = k + most < t->used ? k + most : t->used;
    while (k < end && !vti_history_is(&t->held[k], i, j))
        ++k;
    vti_held *const held = k < end ? &t->held[k] : vti_history_find(t, i, j);
    *next = held != NULL ? held - t->held + 1 : *next;
    return held;
}

/** Room for one that is not there yet; NULL if there is none. Nobody's pointers move. */
static inline vti_held *vti_history_begin(vti_history *t, int64_t i, int64_t j)
{
    const vti_held nothing = {i, j, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0};
    if (t->used + 1 >= t->slots)
        return NULL;
    t->held[t->used] = nothing;
    *vti_history_slot(t, i, j) = vti_history_mark(t, t->used);
    return &t->held[t->used++];
}

/** Empties a slot. */
static inline void vti_history_close(vti_history *t, int64_t gap)
{
    const int64_t mask = t->slots - 1;
    for (int64_t k = (gap + 1) & mask; t->slot[k] != 0; k = (k + 1) & mask) {
        const int64_t home = (int64_t)vti_history_hash_of(t->slot[k]) & mask;
        if (((k - home) & mask) < ((k - gap) & mask)) /* at home behind the gap */
            continue;
        t->slot[gap] = t->slot[k];
        gap = k;
    }
    t->slot[gap] = 0;
}

/** Takes out what a touch holds; the last one takes its place. */
static inline void vti_history_remove(vti_history *t, vti_held *held)
{
    const int64_t last = --t->used, number = held - t->held;
    vti_history_close(t, vti_history_slot(t, held->i, held->j) - t->slot);
    if (number == last)
        return;
    *held = t->held[last];
    *vti_history_slot(t, held->i, held->j) += number - last;
}

/** What stands at place k changes places with *held, which is behind it. */
static inline void vti_history_swap(vti_history *t, int64_t k, vti_held *held)
{
    const vti_held other = t->held[k];
    const int64_t way = held - t->held - k;
    int64_t *const here = vti_history_slot(t, other.i, other.j), *const there = vti_history_slot(t, held->i, held->j);
    t->held[k] = *held;
    *held = other;
    *here += way;
    *there -= way;
}

#endif
