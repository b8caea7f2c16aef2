/* SPDX-License-Identifier: BSD-3-Clause
 * What finding (verdict.c, stability.c, places.c) and judging (judgement.c) share. */
#ifndef VTI_VERDICT_PARTS_H
#define VTI_VERDICT_PARTS_H

#include "verdict.h"

/** Of S: more is bad. */
#define VERDICT_MOST_GAIN 0.25

/** The next effect from *k that follows something along a run; NULL behind the last. */
struct effect *verdict_next_watch(const struct model *model, int64_t *k);

/* ---- stability.c ------------------------------------------------------------------------------------------------- */

/** The largest rate at which something slows bodies that others push, times the longest drift: steps see such a push in
 *  whole kicks, and what comes to a steady speed moves (z/2) coth(z/2) times as fast (EQUATIONS 6.3). */
double stability_slowing(const struct model *model, const vti_stepper *stepper, double h);
/** The same of what moves, be it pushed or not. */
double stability_slowing_free(const struct model *model, const vti_stepper *stepper, double h);
/** By what share of themselves the ways and angles of what nothing pushes are wrong, whose velocities are exact, at z =
 *  c t/m of the longest drift: flows go with kicks, so that drifts see the velocities of their starts alone. Of one
 *  drift between half kicks it is 1 - (z/2)/sinh(z/2), of one behind a whole kick 1 - z/(exp z - 1). */
double stability_way_error(const vti_stepper *stepper, double z);
/** The largest overlap with each other or with walls. */
double stability_deepest(const struct model *model, const vti_bodies *bodies);
/** What rounding alone may give springs that nothing strains: the energy of strains and angles of 1e-9, of all of them
 *  where the bodies are. */
double stability_idle(const struct model *model, const vti_bodies *bodies);
/** At a row: the stable step, where it is due, and the largest share of it that steps took. */
void stability_row(struct verdict *v, double t, const vti_bodies *bodies, const double *row);
/** At a step: overlaps and the stable step, where the largest force on a body exceeds by a quarter that of any step
 *  before. Steps that vary are compared with the stable step at rows alone. */
void stability_step(struct verdict *v, double t, const vti_bodies *bodies);

/* ---- places.c ---------------------------------------------------------------------------------------------------- */

/** How far bodies come in a step h towards what they touch, in diameters of the smallest: the largest h|v - u| where
 *  they touch each other, u being the velocity of their centre of mass, so that two come nearer by no more than twice
 *  that; and the largest h|(v - V).N| at walls, of velocity V and with the normal N at the body. Of spheres of clumps,
 *  which also swing about their body's centre, a bound. */
double places_travel(const struct verdict *v, const vti_bodies *bodies);

/** The largest share of its way h|v| that rounding may take from a body in a step, or add to it: half the spacing of
 *  doubles at its place, of bodies that move by more than a hundredth of *fastest, the largest speed so far, and with
 *  more than idle, which rounding may give to a rod that is at rest, or twisted, and goes nowhere. */
double places_rounding(const struct verdict *v, const vti_bodies *bodies, double idle, double *fastest);

#endif
