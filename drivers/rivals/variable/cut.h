/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps of variable length end where they end. The last one, cut to end where the caller wants to look, is undone before
 * the next: so neither the path nor the number of evaluations depends on how often somebody looks. A cut at the end of
 * the run alone leaves no trace in a course's numbers: the run may go on, as if it had not been. */
#ifndef VTI_RIVALS_CUT_H
#define VTI_RIVALS_CUT_H

#include <math.h>

#include "rival.h"

/** What the bodies are: those of a step that was not cut, or for whom it was. */
enum { NOT_CUT, CUT_TO_LOOK, CUT_AT_END };

/** Doubles of a body's copy. */
enum { KEEPS = 19 };

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
