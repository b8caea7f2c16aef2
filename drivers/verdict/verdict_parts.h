/* SPDX-License-Identifier: BSD-3-Clause
 * What finding (verdict.c) and judging (judgement.c) share. */
#ifndef VTI_VERDICT_PARTS_H
#define VTI_VERDICT_PARTS_H

#include "verdict.h"

/** Of S: more is bad. */
#define VERDICT_MOST_GAIN 0.25

/** The next effect from *k that follows something along a run; NULL behind the last. */
struct effect *verdict_next_watch(const struct model *model, int64_t *k);

/** Largest h|v|, less the common velocity, in diameters of the smallest body; of spheres of clumps, which also swing
 *  about their body's centre, a bound. */
double verdict_travel(const struct verdict *v, const vti_bodies *bodies);

#endif
