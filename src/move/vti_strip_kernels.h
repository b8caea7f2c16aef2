/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies in strips, where one loop translates and turns them: what it translates before it turns, and what it prefetches.
 * Included by vti_move_kernels.h only. */
#ifndef VTI_STRIP_KERNELS_H
#define VTI_STRIP_KERNELS_H

#include "vti_kick_kernels.h"
#include "../vti_processor.h"

/** What is translated before it is turned, where one loop does both: memory gives more to a loop that goes from array to
 *  array every few of its lines than to loops that stay with some of the arrays. */
enum { STRIP = 32 };

/** What is translated; a copy, which stays in registers. */
VTI_INLINE struct translation translation_with(enum order order, const struct translation *with)
{
    const struct translation none = {0};
    return order == MIXED || with == NULL ? none : *with;
}

/** Translates the bodies of a strip that begins with i, if they are to be. Returns where it ends. */
VTI_INLINE int64_t translate_strip(enum order order, struct translation x, int64_t i, int64_t end)
{
    if (order == MIXED || x.v.x == NULL)
        return end;
    const int64_t to = end - i < STRIP ? end : i + STRIP;
    kick_and_move(order, x.k, x.t, x.v, x.moves, x.x, i, to);
    return to;
}

/** Of so many bodies that no cache near has them, what comes next is prefetched, as the processor itself does not foresee
 *  eight arrays and more in turns; of fewer it costs more than it gains. Into the first-level cache, two strips ahead;
 *  AMD's processors, where that doubles the time of a step, into the second, one strip ahead. */
enum { FAR = 1 << 19 };

static struct ahead ahead_of(int64_t bodies)
{
    const int near = !vti_is_amd();
    return (struct ahead){bodies < FAR ? 0 : near ? 2 * STRIP : STRIP, near};
}

VTI_INLINE void prefetch(struct ahead ahead, const double *p, int64_t count)
{
    for (int64_t k = 0; k < count; k += 8)
        if (ahead.near)
            __builtin_prefetch(p + k, 0, 3);
        else
            __builtin_prefetch(p + k, 0, 2);
}

VTI_INLINE void prefetch_vectors(struct ahead ahead, enum order order, struct stream s, int64_t i)
{
    prefetch(ahead, order == PACKED ? s.x + 3 * i : s.x + i, order == PACKED ? 3 * STRIP : STRIP);
    if (order != PACKED) {
        prefetch(ahead, s.y + i, STRIP);
        prefetch(ahead, s.z + i, STRIP);
    }
}

/** What kicks read and write of a. */
VTI_INLINE void prefetch_kicks(struct ahead ahead, enum order order, struct kicks k, struct stream a, int64_t i)
{
    prefetch_vectors(ahead, order, a, i);
    if (k.count > 0)
        prefetch_vectors(ahead, order, k.by, i);
    if (k.count > 0 && k.stride == 1)
        prefetch(ahead, k.m + i, STRIP);
}

/** All but attitudes of the strip that begins with i. */
VTI_INLINE void prefetch_strip(enum order order, struct translation x, struct kicks k, struct stream omega, int64_t i)
{
    prefetch_kicks(x.ahead, order, x.k, x.v, i);
    if (x.moves)
        prefetch_vectors(x.ahead, order, x.x, i);
    prefetch_kicks(x.ahead, order, k, omega, i);
}

/** Of the strip so far ahead of the one that begins with i. Returns its first body, or -1 if nothing is to be
 *  prefetched. */
VTI_INLINE int64_t prefetch_ahead(enum order order, struct translation x, struct kicks k, struct stream omega,
                                  int64_t i, int64_t end)
{
    const int64_t next = i + x.ahead.bodies;
    if (order == MIXED || next == i || next + STRIP > end)
        return -1;
    prefetch_strip(order, x, k, omega, next);
    return next;
}

#endif
