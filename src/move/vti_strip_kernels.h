/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies in strips, where one loop translates and turns them: what it translates before it turns, and what it
 * prefetches. Included by vti_move_kernels.h only. */
#ifndef VTI_STRIP_KERNELS_H
#define VTI_STRIP_KERNELS_H

#include "vti_kick_kernels.h"
#include "../vti_processor.h"

/** What is translated; a copy, which stays in registers. */
VTI_INLINE struct translation translation_with(enum order order, const struct translation *with)
{
    const struct translation none = {0};
    return order == MIXED || with == NULL ? none : *with;
}

/** Memory gives more to a loop that goes from array to array every few of its lines than to loops that stay with some
 *  of the arrays. Of so many bodies that no cache near has them, what comes next is prefetched, as the processor itself
 *  does not foresee eight arrays and more in turns; of fewer it costs more than it gains. Into the first-level cache,
 *  and then in short strips, as it waits for few lines at once; AMD's processors, where that doubles the time of a
 *  step, into the second. */
enum { STRIP = 32, SHORT_STRIP = 8, AHEAD = 32, FAR = 1 << 19 };

static struct strips strips_of(int64_t bodies)
{
    const int far = bodies >= FAR, near = !vti_is_amd();
    return (struct strips){far && near ? SHORT_STRIP : STRIP, far ? AHEAD : 0, near};
}

/** Where the strip ends that begins with i. */
VTI_INLINE int64_t strip_end(enum order order, struct translation x, int64_t i, int64_t end)
{
    return order == MIXED || x.v.x == NULL || end - i < x.strips.bodies ? end : i + x.strips.bodies;
}

/** Translates the bodies of a strip, if they are to be. */
VTI_INLINE void translate_strip(enum order order, struct translation x, int64_t i, int64_t to)
{
    if (order != MIXED && x.v.x != NULL)
        kick_and_move_all(order, x.k, x.t, x.v, x.moves, x.x, i, to);
}

/* ---- prefetching ------------------------------------------------------------------------------------------------- */

/** Numbers of a line of the cache, and bodies that are prefetched at once. */
enum { LINE = 8 };

VTI_INLINE void prefetch(struct strips strips, const double *p, int lines)
{
    for (int k = 0; k < lines; ++k)
        if (strips.near)
            __builtin_prefetch(p + LINE * k, 0, 3);
        else
            __builtin_prefetch(p + LINE * k, 0, 2);
}

VTI_INLINE void prefetch_vectors(struct strips strips, enum order order, struct stream s, int64_t i)
{
    prefetch(strips, order == PACKED ? s.x + 3 * i : s.x + i, order == PACKED ? 3 : 1);
    if (order != PACKED) {
        prefetch(strips, s.y + i, 1);
        prefetch(strips, s.z + i, 1);
    }
}

/** What kicks read and write of a. */
VTI_INLINE void prefetch_kicks(struct strips strips, enum order order, struct kicks k, struct stream a, int64_t i)
{
    prefetch_vectors(strips, order, a, i);
    if (k.count > 0)
        prefetch_vectors(strips, order, k.by, i);
    if (k.count > 0 && k.stride == 1)
        prefetch(strips, k.m + i, 1);
}

/** All but the attitudes of LINE bodies from i on. */
VTI_INLINE void prefetch_line(enum order order, struct translation x, struct kicks k, struct stream omega, int64_t i)
{
    prefetch_kicks(x.strips, order, x.k, x.v, i);
    if (x.moves)
        prefetch_vectors(x.strips, order, x.x, i);
    prefetch_kicks(x.strips, order, k, omega, i);
}

/** The first body after those that are prefetched while the strip up to `to` moves, which begin x.strips.ahead after
 *  it; 0 if none are. */
VTI_INLINE int64_t prefetched_until(enum order order, struct translation x, int64_t to, int64_t end)
{
    const int64_t until = to + x.strips.ahead;
    return order == MIXED || until == to || until > end ? 0 : until;
}

#endif
