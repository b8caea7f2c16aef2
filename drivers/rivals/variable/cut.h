/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps of variable length end where they end. The last one, cut to end where the caller wants to look, is undone
 * before the next: so neither the path nor the number of evaluations depends on how often somebody looks. A cut at the
 * end of the run alone leaves no trace in a course's numbers: the run may go on, as if it had not been. */
#ifndef VTI_RIVALS_CUT_H
#define VTI_RIVALS_CUT_H

#include <math.h>

#include "loop.h"
#include "rival.h"

/** What the bodies are: those of a step that was not cut, or for whom it was. */
enum { NOT_CUT, CUT_TO_LOOK, CUT_AT_END };

/** The shortest steps, as a share of h: a run can end and go on at multiples of h alone. */
#define CUT_SHORTEST 0x1p-26

/** Doubles of a body's copy. */
enum { KEEPS = 19 };

/** When so many steps of h end. If somebody wants that sooner, they become fewer, to the first multiple of h that is
 *  after t: the run goes on from there as from its end. */
static inline double cut_end(struct course *c, double t, int64_t *steps)
{
    if (c->wants != NULL && c->wants->wants(c->wants->self)) {
        int64_t sooner = (int64_t)(t / c->h) - c->steps;
        while (sooner < 1 || (double)(c->steps + sooner) * c->h <= t)
            ++sooner;
        c->ends |= sooner < *steps;
        *steps = sooner < *steps ? sooner : *steps;
        c->wants = NULL;
    }
    return (double)(c->steps + *steps) * c->h;
}

/** The copy of all bodies behind so many doubles per body of own. */
static inline vti_kept cut_kept(const struct course *c, int64_t behind)
{
    const vti_kept kept = {c->own + behind * c->n, KEEPS};
    return kept;
}

/** The longest step since the look before, as far as it has gone the next one too, which ends beyond the look. */
static inline double cut_longest(const struct course *c, double longest, double next)
{
    return c->steps > 0 ? fmax(longest, fmin(next, (double)c->steps * c->h)) : 0.0;
}

#endif
