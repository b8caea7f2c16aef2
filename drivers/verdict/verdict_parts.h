/* SPDX-License-Identifier: BSD-3-Clause
 * What finding (verdict.c) and judging (judgement.c) share. */
#ifndef VTI_VERDICT_PARTS_H
#define VTI_VERDICT_PARTS_H

#include "verdict.h"

/** Of S: more is bad. */
#define VERDICT_MOST_GAIN 0.25

/** The next effect from *k that follows something along a run; NULL behind the last. */
struct effect *verdict_next_watch(const struct model *model, int64_t *k);

/** How far bodies come in a step h towards what they touch, in diameters of the smallest: the largest h|v - u| where
 *  they touch each other, u being the velocity of their centre of mass, so that two come nearer by no more than twice
 *  that; and the largest h|(v - V).N| at walls, of velocity V and with the normal N at the body. Of spheres of clumps,
 *  which also swing about their body's centre, a bound. */
double verdict_travel(const struct verdict *v, const vti_bodies *bodies);

/** The largest share of its way h|v| that rounding may take from a body in a step, or add to it: half the spacing of
 *  doubles at its place, of bodies that move by more than a hundredth of *fastest, the largest speed so far. */
double verdict_rounding(const struct verdict *v, const vti_bodies *bodies, double *fastest);

#endif
