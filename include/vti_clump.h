/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Clumps: bodies that effects see as spheres at fixed places in them (multispheres; EQUATIONS 7.5). */
#ifndef VTI_CLUMP_H
#define VTI_CLUMP_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The solid that spheres make: what a body of it weighs. */
typedef struct vti_solid {
    double mass;         /**< density times volume */
    double centre[3];    /**< of mass, where offsets of the spheres begin */
    double moments[3];   /**< A <= B <= C about it: vti_bodies.moments */
    double principal[4]; /**< xyzw, w >= 0: takes the principal axes, right-handed, the largest components of the first
                              two positive, to those of the centres: vti_bodies.principal */
} vti_solid;

/** Mass, centre and moments of n spheres centre[n][3], diameter[n], of one density, counted once where they overlap
 *  (EQUATIONS 7.5). A sphere that overlaps no other: exactly. Others: along lines parallel to z, exact on each, lines
 *  by lines of them over its own box; 256 are good for 1e-4. That holds for each moment, however far the spheres are
 *  spread. Time grows with lines^2 n k, k being how many overlap one sphere, and n where that is more than 128; it
 *  doubles where a moment is below 2^-10 of the largest. VTI_E_CLUMP, with fault->body the sphere, for a diameter that
 *  is not positive or a number that is not finite, and with -1 where moments are beyond the range of numbers;
 *  VTI_E_MASS for such a density or mass; VTI_E_COUNT for no spheres or no lines. */
VTI_API int vti_clump_solid(int64_t n, const double *centre, const double *diameter, double density, int64_t lines,
                            vti_solid *solid, vti_fault *fault);

/** The spheres of clumps. Sphere s belongs to body i = body[s] - base and sits at rho = offset[s] in it. To effects the
 *  spheres are bodies of their own, numbered as in this list: contacts, walls, friction, bonds and a host's own effects
 *  act on them as they are. All memory is the caller's. */
typedef struct vti_clumps {
    int64_t count;        /**< spheres */
    const int64_t *body;  /**< [count] the body of each, ascending */
    int64_t base;         /**< 0, or 1 in Fortran */
    const double *offset; /**< [count][3] rho: from the body's centre of mass, in the body's frame, a length */
    /** All spheres, from 0 to count - 1, in views that share no memory with those of the bodies. A view that is absent
     *  is not made. Nothing kicks or moves them: mass and inertia are there for those who read them, as gravity does,
     *  and because views of v and force go with a mass, of omega and moment with an inertia. */
    vti_bodies spheres;
} vti_clumps;

/** When the list has changed: every sphere belongs to one of the n bodies that exist, the list ascends, offsets are
 *  finite, and spheres are as many as the list says. VTI_E_COUNT where they are not; VTI_E_CLUMP, with
 *  fault->body the number of the sphere and fault->value what is wrong: the body or the component of the offset. */
VTI_API int vti_clumps_check(const vti_clumps *clumps, int64_t n, vti_fault *fault);

/** The spheres of the bodies of the slice, as a slice of clumps->spheres; none if the lists are not there. */
VTI_API vti_bodies vti_clumps_spheres(const vti_clumps *clumps, const vti_bodies *bodies);

/** Puts the spheres of the slice's bodies where they are (EQUATIONS 7.5), of the views that they have:
 *      r = R rho,   x_s = x + r,   v_s = v + Omega x r,   attitude and Omega those of the body.
 *  The bodies need an attitude (VTI_E_NEEDS); x, v and Omega that they do not have are 0. VTI_E_CLUMP and VTI_E_NULL
 *  for lists that are not there, VTI_E_ALIAS where a view of the spheres begins where the bodies' begins, or a status
 *  of vti_bodies_check of bodies or spheres. Threads may do slices of bodies at once. */
VTI_API int vti_clumps_spread(const vti_clumps *clumps, const vti_bodies *bodies);

/** Adds the loads of the spheres to those of the slice's bodies, s ascending (a load that is absent is left out):
 *      F += F_s,   RM += RM_s + r x F_s,
 *  the transpose of spread: what was a gradient stays one, and momenta are kept. Errors are those of spread. Threads
 *  may do slices of bodies at once. A step with its own loop over the spheres' effects, which gives a clump of one
 *  sphere at its centre the bits of that sphere:
 *
 *      vti_step_begin(method, h, &bodies, &fault);
 *      vti_clumps_spread(&clumps, &bodies);
 *      vti_apply(on_spheres, n, &clumps.spheres);
 *      vti_apply(on_bodies, m, &bodies);
 *      vti_clumps_gather(&clumps, &bodies);
 *      vti_step_finish(method, h, &bodies);                                                                         */
VTI_API int vti_clumps_gather(const vti_clumps *clumps, const vti_bodies *bodies);

/** An effect on the spheres of clumps. */
typedef struct vti_clumped {
    const vti_clumps *clumps; /**< whose spheres it acts on, and whose bodies bear it */
    const vti_effect *effect; /**< acts on clumps->spheres */
} vti_clumped;

/** The effect on the bodies that *clumped is, which must outlive it with all that it points to: spreads, does what the
 *  effect does on the spheres, and gathers. Name, energies, booked energies and rupture are those of the effect;
 *  springs have the lever of their sphere (vti_spring), and the present force on a sphere counts as a stiffness against
 *  turning. Where it is told of a drift, spheres have the velocity of their chord, (x_s - x_s before)/t. It conserves
 *  what the effect does, but for the sum of J Omega.
 *
 *  As it writes all spheres, slices of bodies may be done one after another, but not at once. Flows (dashpots) change
 *  the velocities of the bodies at once, from touch to touch, by mass and inertia of the whole body; the spheres' own
 *  are not looked at. An effect that has a flow and none for clumps (flow_clumps) is refused, VTI_E_CLUMP. */
VTI_API vti_effect vti_clumped_effect(const vti_clumped *clumped);

#ifdef __cplusplus
}
#endif

#endif
