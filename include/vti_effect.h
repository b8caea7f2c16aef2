/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 *  The interface of an effect: a line of physics with its forces, moments and energies, and what it says of itself. The
 *  library's own have a header each (vti_binder.h, vti_contact.h, vti_wall.h, vti_gravity.h, vti_pendulum.h; what
 *  loses energy: vti_drag.h, vti_dashpot.h, vti_bond_dashpot.h, vti_friction.h, vti_rupture.h; on the spheres of
 *  clumps: vti_clump.h); a host's is served alike. */
#ifndef VTI_EFFECT_H
#define VTI_EFFECT_H

#include "vti_bodies.h"
#include "vti_step.h"
#include "vti_sum.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most energy terms, and the most entries of booked energy, that an effect may have. */
#define VTI_TERMS 8

/* ---- springs, for the stable step (EQUATIONS 5, 6.10) ------------------------------------------------------------ */

/** A spring between two bodies, or between one and a place that does not move, as it is for small motions: displaced by
 *  u and turned by theta, with n from j to i, u = u_i - u_j and P u = u - (n.u) n, it holds
 *      axial/2 (n.u/length)^2 + across/2 |P u/length|^2 + shear/2 |P u/length - (arm_i theta_i + arm_j theta_j) x n|^2
 *      + bend/2 |P (theta_i - theta_j)|^2 + twist/2 [n.(theta_i - theta_j)]^2.
 *  All stiffnesses are energies >= 0, so that a spring constant k is k length^2. The bound does not depend on the
 *  direction of n; a stiffness that is too large lowers it, one that is too small makes it false. */
typedef struct vti_spring {
    int64_t element; /**< which of the effect's: the number of the bond, pair, plane or arm, from 0 */
    int64_t i;       /**< body, an index into the views, from 0 */
    int64_t j;       /**< the other one; -1: what does not move, and u_j = theta_j = 0 */
    double length;   /**< of the spring, > 0 */
    double axial;    /**< along n */
    double across;   /**< across n, however the bodies turn: what a pull along n does */
    double shear;    /**< across n, if the bodies do not turn with it */
    double arm_i;    /**< share of the length from i to where shear acts; with arm_j it sums to 1 in what conserves */
    double arm_j;    /**< and from j */
    double bend;     /**< against turning apart, about what is across n */
    double twist;    /**< and about n */
    double lever_i;  /**< distance from the centre of i, in it, of the place that the spring holds: u_i is that place's;
                          0 where it is the centre */
    double lever_j;  /**< and of j */
} vti_spring;

/** Takes one spring; context is what came with it. */
typedef void vti_spring_visit(void *context, const vti_spring *spring);

/** How far bodies may get from rest, for a bound that holds until they get there. */
typedef struct vti_deformation {
    double overlap; /**< of contacts and walls, a share of D: Hertz stiffens as its square root */
    double strain;  /**< of bonds, a share of L0 below 1, shortened or stretched: shear is stiffer in a shorter bond */
    /** 0: only pairs in the lists of contacts may touch; 1: any two bodies may, and element is the body. */
    int64_t meet;
} vti_deformation;

/* ---- an effect --------------------------------------------------------------------------------------------------- */

/** Momenta that an effect may not conserve, three components each: x, y, z from the lowest bit on. */
enum vti_breaks {
    VTI_BREAKS_LINEAR = 7,   /**< sum of m v */
    VTI_BREAKS_ANGULAR = 56, /**< sum of x x m v + J Omega, about the origin: bits 3 to 5 */
    VTI_BREAKS_SPINS = 448   /**< sum of J Omega: bits 6 to 8 */
};

struct vti_clumps;

/** A drift that has been done, as effects are told of it. */
typedef struct vti_drifted {
    double t;                        /**< its time */
    int64_t law;                     /**< vti_law */
    int64_t frame;                   /**< vti_frame */
    int64_t rotor;                   /**< of bodies with moments: that of the stepper; 0 is 2 */
    const struct vti_clumps *clumps; /**< where the bodies are spheres of clumps, those; else NULL */
    const vti_bodies *bodies;        /**< and the bodies that have them */
} vti_drifted;

/** One line of physics. A scene holds an array of those that it calls for; what is not in the array does not exist. The
 *  object behind self stays the caller's; what changes as time goes on (history, booked energies) is memory of the
 *  caller's that it points to.
 *
 *  Numbers, stiffnesses and lists of the object are read at each call. What the effect says of itself (needs, gives,
 *  smooth, breaks, terms, books, whether it carries) is made of what the parameters are when it is made, by
 *  vti_bonds_effect and its like. Make it again when a term appears or goes (bonds get a stiffness; drag, dashpots or
 *  friction get a coefficient of a motion that had none), when the form of shear changes, when walls begin to move or
 *  have another direction, and when lost, work or by_body is other memory. Until then vti_energy, vti_booked and calls
 *  of steps go by what it was; where bodies lack what a new term reads, the effect's check refuses it (VTI_E_NEEDS).
 *
 *  Members are named in initialisers, and what is not named is absent, is off and costs
 *  nothing: {.name = "magnet", .apply = pull, .self = &magnet}. */
typedef struct vti_effect {
    const char *name; /**< what it is called */
    /** Adds this effect's force and moment to those of the slice's bodies (a force or moment that is absent is left
     *  out). Other bodies are read and not written: slices may be done at once. NULL for what acts by its flow or its
     *  rupture only. */
    void (*apply)(const void *self, const vti_bodies *bodies);
    /** Writes the effect's energies, one per term. Without it the energy is unknown, unless apply is absent too. */
    void (*energy)(const void *self, const vti_bodies *bodies, double *energies);
    /** VTI_OK if the lists and numbers of self may be used with the bodies, which have what needs says; may be NULL.
     *  Asked before each of the others. */
    int (*check)(const void *self, const vti_bodies *bodies);
    /** Calls visit with every spring of the effect, always in one order: each as stiff as it can be while nothing is
     *  deformed by more than *at says, or, if at is NULL, as it is where the bodies are. Returns VTI_OK, or why it
     *  cannot. NULL: it does not say, and there is no bound (VTI_E_SPRINGS), unless there is no apply either; a force
     *  that does not change with position has vti_springs_none. */
    int (*springs)(const void *self, const vti_bodies *bodies, const vti_deformation *at, vti_spring_visit *visit,
                   void *context);
    /** Moves the velocities by the exact flow of its dashpots for the time t, at fixed positions (EQUATIONS 6.3). drift
     *  > 0: a drift of that time follows, and pairs are gone through forwards; drift < 0: one of -drift has been, and
     *  they are gone through backwards. Coefficients that change with position are to be their mean over that drift. */
    void (*flow)(const void *self, const vti_bodies *bodies, double t, double drift);
    /** The same of an effect on the spheres of clumps (vti_clumped), which stand where they are: moves the velocities
     *  of the bodies that have them, by their mass and inertia. NULL: what flows is not for clumps. */
    void (*flow_clumps)(const void *self, const struct vti_clumps *clumps, const vti_bodies *bodies, double t,
                        double drift);
    /** Takes what it remembers of its pairs along with a drift that has been done (EQUATIONS 6.5): velocities are those
     *  of the drift, positions and attitudes those after it. */
    void (*carry)(const void *self, const vti_bodies *bodies, const vti_drifted *drifted);
    /** At the end of a step: takes out what breaks, books its energy and returns how many did (EQUATIONS 6.7). */
    int64_t (*rupture)(const void *self, const vti_bodies *bodies);
    const void *self; /**< first argument of all of them */
    int64_t needs; /**< bits 1 << vti_quantity of what it cannot do without, loads and rounding errors among them; alpha
                          or quat: an attitude in either form; any other bit is refused */
    int64_t gives; /**< what apply adds to: 1 << VTI_QUANTITY_FORCE, 1 << VTI_QUANTITY_MOMENT */
    int64_t smooth;  /**< 1 if its force has all derivatives; 0 if it has kinks, as where a contact begins */
    int64_t settles; /**< 1 if its flow leaves nothing to set to 0 of spheres' velocities (below); bodies at rest then
                         cost a pass less over them */
    int64_t breaks;  /**< momenta that it does not conserve: components of vti_breaks */
    /** 1 if it takes energy out of the motion: steppers with negative coefficients would put it in. */
    int64_t dissipates;
    int64_t terms;           /**< at most VTI_TERMS */
    const char *const *term; /**< names of the terms, one each */
    int64_t books;           /**< entries of booked energy, at most VTI_TERMS */
    const char *const *book; /**< names of the entries, one each */
    const vti_sum *booked; /**< [books]: what it has taken out of the motion so far; negative: put in (EQUATIONS 6.1) */
    const vti_sum *by_body; /**< [bodies][of_body]: what of booked each body has lost, half of what it loses together
                                 with another one; the first books of a body are those of booked; NULL: off */
    int64_t of_body;        /**< entries of a body there, at least books */
} vti_effect;

/** The springs callback of an effect without springs: it never calls visit. */
VTI_API int vti_springs_none(const void *self, const vti_bodies *bodies, const vti_deformation *at,
                             vti_spring_visit *visit, void *context);

/** Whether all of them may be used with the bodies: what every call with effects looks at first. VTI_E_NULL for an
 *  effect that does nothing, having neither apply nor flow nor rupture, as is made of what is NULL or given in part;
 *  VTI_E_COUNT for one of more than VTI_TERMS terms or books; VTI_E_NEEDS for one that needs what the bodies do not
 *  have, or what is no quantity; or what its check says. fault, which may be NULL, has in body the number of the
 *  effect, from 0, and in quantity what is missing; or what vti_bodies_check finds. */
VTI_API int vti_effects_check(const vti_effect *effects, int64_t n, const vti_bodies *bodies, vti_fault *fault);

/** force = moment = 0 on the slice, then every effect in order. Where vti_effects_check refuses, nothing has been
 *  touched. Loads of bodies outside the slice are not written: threads may do a slice each at once, once all bodies
 *  have moved, and get the bits of one call for all, as each body's loads are added in the order of the lists. A list
 *  may be that of vti_pairs_of_slice. */
VTI_API int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Which pairs of the list pair[count][2], whose first body is base, act on bodies of the slice first ... first +
 *  bodies - 1 (from 0): their numbers k from 0, ascending, into which[count] unless that is NULL. Returns how many
 *  there are; 0 where pair is NULL. A list of these pairs alone, of bonds with their rest and stiffnesses or of
 *  contacts, gives that slice the loads of the whole list, to the bit. */
VTI_API int64_t vti_pairs_of_slice(int64_t count, const int64_t *pair, int64_t base, int64_t first, int64_t bodies,
                                   int64_t *which);
/** Once before a run, if forces are effects: VTI_E_DISSIPATES if method has a negative coefficient and some effect
 *  dissipates, flows, carries or ruptures, else VTI_OK. vti_effects_begin asks it; vti_step_begin sees no effects, and
 *  a host that calls neither is not refused: its dissipation then turns into gain wherever the stepper steps back. */
VTI_API int vti_step_check(const vti_stepper *method, const vti_effect *effects, int64_t n);

/* ---- steps with effects that flow, carry or rupture (EQUATIONS 6.1, 6.8) ----------------------------------------- */

/* The loop of a host whose effects damp, have history or break; where none does, it is that of vti_step.h, with the
 * same bits:
 *
 *      for every step {
 *          vti_effects_begin(method, h, effects, n, &bodies, &fault);        flow, kick, drift, carry
 *          vti_apply(effects, n, &bodies);
 *          vti_effects_finish(method, h, effects, n, &bodies);               kick, flow
 *          vti_effects_rupture(effects, n, &bodies, &broken);                if broken > 0: vti_apply again
 *      }
 *
 * Methods of more stages take vti_effects_stage for k = 1 ... stages - 1 before the end, each followed by vti_apply,
 * and probes as in vti_step.h.
 *
 * The flows last as long as the kicks. That of the first kick comes before it, that of the last one after it; of a kick
 * between two drifts one half comes before and one half after. The one kick of VTI-3 is a last and a first half:
 * between them come the flows of both. All go through the effects forwards before a drift, and backwards after it, so
 * that drag, which stands first, is outermost. Before these, where some effect that flows does not settle, velocities
 * below 2^-500 are set to 0, as carry does with spring loads and drag with what it slows: bodies at rest then cost no
 * arithmetic on subnormal numbers. Hosts who write their own steps of vti_kick and vti_drift call vti_effects_flow and
 * vti_effects_carry in these places. */

/** vti_step_begin with the effects' flows and carries: stage 0. On VTI_E_TOO_LARGE the flow before the kick has been
 *  done, and nothing else (of a method of one kick that too); on all other failures nothing. VTI_E_FRAME if the method
 *  is of the body's frame and an effect carries, or flows, reads x and breaks the sum of J Omega, as dashpots do that
 *  turn bodies. */
VTI_API int vti_effects_begin(const vti_stepper *method, double h, const vti_effect *effects, int64_t n,
                              const vti_bodies *bodies, vti_fault *fault);
/** vti_step_stage with them. On VTI_E_TOO_LARGE, which the methods of several stages do not return, the kick has been
 *  done too. */
VTI_API int vti_effects_stage(const vti_stepper *method, int64_t k, double h, const vti_effect *effects, int64_t n,
                              const vti_bodies *bodies, vti_fault *fault);
/** vti_step_finish with them. */
VTI_API int vti_effects_finish(const vti_stepper *method, double h, const vti_effect *effects, int64_t n,
                               const vti_bodies *bodies);
/** What breaks at the end of a step; *broken is how many: unless it is 0, vti_apply comes before the next step. */
VTI_API int vti_effects_rupture(const vti_effect *effects, int64_t n, const vti_bodies *bodies, int64_t *broken);

/** The flows of all effects for the time t >= 0, beside a drift as vti_effect.flow has it: in order, for drift < 0
 *  backwards, before which velocities below 2^-500 become 0 as said above. */
VTI_API int vti_effects_flow(const vti_effect *effects, int64_t n, double t, double drift, const vti_bodies *bodies);
/** Tells all effects that carry of a drift that has been done; VTI_E_FRAME if one does and the frame is the body's,
 *  VTI_E_NULL for clumps without their bodies. */
VTI_API int vti_effects_carry(const vti_effect *effects, int64_t n, const vti_drifted *drifted,
                              const vti_bodies *bodies);
/** Sum of all booked energies: with vti_energy, what is constant. NaN where n is negative, effects NULL and n not 0, or
 *  an effect has books, but booked is NULL. */
VTI_API double vti_booked(const vti_effect *effects, int64_t n);
/** What of it body i, from 0, has lost: the sum over the effects that book by body, whose by_body has to go up to i.
 *  NaN where n or i is negative, effects NULL and n not 0, or of_body less than books. Of clumps (vti_clumped) the
 *  effect on the spheres has theirs. */
VTI_API double vti_booked_of_body(const vti_effect *effects, int64_t n, int64_t i);

#ifdef __cplusplus
}
#endif

#endif
