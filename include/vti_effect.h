/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Effects: the forces, moments and energies that a scene calls for. */
#ifndef VTI_EFFECT_H
#define VTI_EFFECT_H

#include "vti_bodies.h"
#include "vti_step.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- effects (EQUATIONS 3) ------------------------------------------------------------------------------------ */

/** An effect has at most so many terms. */
#define VTI_TERMS 8

/** A spring between two bodies, or between one and a place that does not move, as it is for small motions: displaced by u and
 *  turned by theta, with n from j to i, u = u_i - u_j and P u = u - (n.u) n, it holds
 *      axial/2 (n.u/length)^2 + across/2 |P u/length|^2 + shear/2 |P u/length - (arm_i theta_i + arm_j theta_j) x n|^2
 *      + bend/2 |P (theta_i - theta_j)|^2 + twist/2 [n.(theta_i - theta_j)]^2.
 *  All stiffnesses are energies >= 0, so that a spring constant k is k length^2. The direction of n is nothing to the bound, nor
 *  is a stiffness that is too large; one that is too small makes it false. */
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
} vti_spring;

/** Takes one spring; context is what came with it. */
typedef void vti_spring_visit(void *context, const vti_spring *spring);

/** How far bodies may get from rest, for a bound that holds until they get there. */
typedef struct vti_deformation {
    double overlap; /**< of contacts and walls, a share of D: Hertz stiffens as its square root */
    double strain;  /**< of bonds, a share of L0 below 1, shortened or stretched: shear is stiffer in a shorter bond */
    int64_t
        meet; /**< 0: pairs in the lists of contacts may touch, and no others; 1: any two of the bodies may, and element is the body */
} vti_deformation;

/** One line of physics. A scene holds an array of those that it calls for; what is not in the array does not exist. The
 *  object behind self stays the caller's. Members are named in initialisers, and what is not named is absent:
 *  {.name = "magnet", .apply = pull, .self = &magnet}. */
typedef struct vti_effect {
    const char *name; /**< what it is called */
    /** Adds this effect's force and moment to the bodies' (a force or moment that is absent is left out). */
    void (*apply)(const void *self, const vti_bodies *bodies);
    /** Writes the effect's energies, one per term. */
    void (*energy)(const void *self, const vti_bodies *bodies, double *energies);
    /** VTI_OK if all that the others read is there, of self and of the bodies; may be NULL. Asked before each of them. */
    int (*check)(const void *self, const vti_bodies *bodies);
    /** Shows visit every spring of the effect, always in the same order: each as stiff as it can be while nothing is deformed
     *  by more than *at says, or, if at is NULL, as it is where the bodies are. Returns VTI_OK, or why it cannot. NULL: it
     *  does not say, and there is no bound (VTI_E_SPRINGS); a force that does not change with position has vti_springs_none. */
    int (*springs)(const void *self, const vti_bodies *bodies, const vti_deformation *at, vti_spring_visit *visit,
                   void *context);
    const void *self;        /**< first argument of the four */
    int64_t terms;           /**< at most VTI_TERMS */
    const char *const *term; /**< names of the terms, one each */
    int64_t breaks; /**< momenta that it does not conserve, bits: 0-2 linear, 3-5 angular about 0, 6-8 sum of J Omega */
    int64_t
        dissipates; /**< 1 if it takes energy out of the motion: steppers with negative coefficients would put it in */
} vti_effect;

/** force = moment = 0 on the slice, then every effect in order. An effect without apply, as is made of what is NULL or given
 *  in part, is refused with VTI_E_NULL, and one whose check says no with what it says; then nothing has been touched. */
VTI_API int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Once before a run, if forces are effects: VTI_E_DISSIPATES if method has a negative coefficient and some effect dissipates,
 *  else VTI_OK. Nothing else asks: vti_step_begin sees no effects, and a host that does not call this is not refused; its
 *  dissipation then turns into gain wherever the stepper steps back. */
VTI_API int vti_step_check(const vti_stepper *method, const vti_effect *effects, int64_t n);

/* ---- pendulum ------------------------------------------------------------------------------------------------------ */

/** Three-dimensional pendulum: bodies hang by their body-fixed arm rho0 from pivots in a field g along +e3 (E2).
 *  U = -m g e3 . R rho0, RM = m g (R rho0) x e3 (E1). Rotation only. */
typedef struct vti_pendulum {
    double weight;  /**< m g */
    double rho0[3]; /**< arm in the body's frame */
} vti_pendulum;

/** The effect of *pendulum, which must outlive it. Energy term: "pendulum". */
VTI_API vti_effect vti_pendulum_effect(const vti_pendulum *pendulum);
/** R rho0 of body i in the inertial frame; not a number if there is no such body or it has no attitude. */
VTI_API void vti_pendulum_arm(const vti_pendulum *pendulum, const vti_bodies *bodies, int64_t i, double arm[3]);

/* ---- gravity -------------------------------------------------------------------------------------------------------- */

/** Uniform field: F = m g, U = -m g.x. Needs x for the energy and mass. */
typedef struct vti_gravity {
    double g[3]; /**< acceleration */
} vti_gravity;

/** The effect of *gravity, which must outlive it. Energy term: "gravity". */
VTI_API vti_effect vti_gravity_effect(const vti_gravity *gravity);

/* ---- binder ---------------------------------------------------------------------------------------------------------- */

/** Forms of the shear energy; c is the cosine between the bond and where the bodies' attitudes would have it. */
enum vti_shear {
    VTI_SHEAR_OBJECTIVE = 1, /**< K (1 - c), c = n.(b_i + b_j)/|b_i + b_j|: the default */
    VTI_SHEAR_QUARTIC = 2,   /**< K/2 (1 - c)^2 with the same c: objective, with the printed exponent */
    VTI_SHEAR_PRINTED = 3    /**< K/2 (1 - c)^2 with c = (R_i n0).(R_j n): as printed, not objective (E11) */
};

/** Bonds between bodies, in the caller's memory. With d = x_i - x_j, r = |d|, n = d/r and b = R n0:
 *      moment  K/2 |theta_ij|^2, exp S(theta_ij) = R_i R_j^T
 *      axial   K/2 (r/L0 - 1)^2
 *      shear   as vti_shear says
 *  A stiffness that is absent (p = NULL) is a term that is absent, and costs nothing. Attitudes are those that have turned
 *  the bodies since the rest configuration, in which R = I. Coincident centres have no direction: no force. */
typedef struct vti_bonds {
    int64_t count;       /**< bonds in the list */
    const int64_t *pair; /**< [count][2]: i, j */
    int64_t base;        /**< index of the first body in pair: 0, or 1 in Fortran */
    const double *rest;  /**< [count][4]: n0, L0 with x_i0 - x_j0 = L0 n0; see vti_bonds_rest */
    vti_scalars moment;  /**< K^m, energy */
    vti_scalars axial;   /**< K^a, energy; the axial stiffness is K^a/L0^2 */
    vti_scalars shear;   /**< K^s, energy */
    int64_t shear_form;  /**< vti_shear; ignored without shear */
} vti_bonds;

/** rest[count][4] of the pairs from the positions x of the rest configuration. VTI_E_BOND, with fault->body the number of
 *  the bond (from 0), if its bodies coincide or one comes before the first; how many there are is not known here. */
VTI_API int vti_bonds_rest(int64_t count, const int64_t *pair, int64_t base, const vti_view *x, double *rest,
                           vti_fault *fault);
/** Once before use: every pair names two different bodies of the n that exist, L0 > 0, |n0| = 1, stiffnesses finite and
 *  >= 0. On failure VTI_E_BOND, with fault->body the number of the bond and fault->value what is wrong. */
VTI_API int vti_bonds_check(const vti_bonds *bonds, int64_t n, vti_fault *fault);
/** The effect of *bonds, which must outlive it. It acts on all of its bonds, whatever the slice of bodies. Energy terms, of
 *  those that are present: "binder_moment", "binder_axial", "binder_shear". */
VTI_API vti_effect vti_bonds_effect(const vti_bonds *bonds);

/* ---- contact --------------------------------------------------------------------------------------------------------- */

/** Hertzian contact between the pairs of a list, U = 2/5 K [1 - r/D]_+^{5/2} with D = (D_i + D_j)/2 (E4). The list may hold
 *  pairs that do not touch. Coincident centres have no direction: no force. */
typedef struct vti_contacts {
    int64_t count;        /**< pairs in the list */
    const int64_t *pair;  /**< [count][2] */
    int64_t base;         /**< 0, or 1 in Fortran */
    vti_scalars diameter; /**< D of the bodies */
    double stiffness;     /**< K^pp, energy */
} vti_contacts;

/** When the list has changed, for those who do not trust it: every pair names two different bodies of the n that exist, of
 *  finite diameters > 0, and K is finite and >= 0. On failure VTI_E_CONTACT, with fault->body the number of the pair, -1 for K,
 *  and fault->value what is wrong. */
VTI_API int vti_contacts_check(const vti_contacts *contacts, int64_t n, vti_fault *fault);
/** The effect of *contacts, which must outlive it; its list may change between steps. Energy term: "contact". */
VTI_API vti_effect vti_contacts_effect(const vti_contacts *contacts);

/** Rigid planes n.x = offset that keep bodies on the side to which n points: a particle of radius zero at the foot point,
 *  U = 2/5 K [1 - g/(D/2)]_+^{5/2} with g = n.x - offset. */
typedef struct vti_walls {
    int64_t count;        /**< planes */
    const double *plane;  /**< [count][4]: n (unit), offset */
    vti_scalars diameter; /**< D of the bodies */
    double stiffness;     /**< K^pw, energy */
} vti_walls;

/** The effect of *walls, which must outlive it. Energy term: "wall". */
VTI_API vti_effect vti_walls_effect(const vti_walls *walls);

/* ---- stability -------------------------------------------------------------------------------------------------------- */

/** The springs of an effect that has none: it calls visit for nothing. */
VTI_API int vti_springs_none(const void *self, const vti_bodies *bodies, const vti_deformation *at,
                             vti_spring_visit *visit, void *context);

/** A bound on the step, and what sets it: the stiffest spring at the bodies that allow no more. */
typedef struct vti_stable {
    double h;        /**< 2/omega; infinite if nothing oscillates */
    int64_t effect;  /**< number of the effect in the array, from 0; -1 if nothing oscillates */
    int64_t element; /**< the number of its spring, as in vti_spring; -1 if nothing oscillates */
    int64_t i;       /**< its body, as in vti_spring; -1 if nothing oscillates */
    int64_t j;       /**< the other one; -1 also if there is none */
} vti_stable;

/** A step that is stable for every stepper whose limit is h < 2/omega_max: stable->h = 2/omega with omega >= omega_max of the
 *  motion linearised where nothing is deformed by more than *at (all zeros: at rest), or where the bodies are (at = NULL), with
 *  bonds that are not bent. It is bounded spring by spring (EQUATIONS 5, 6.10) and never above the exact eigenvalues' limit; on the
 *  torus at rest by 0.2 % below it. Where at is given, pairs in contact are those of the list, all touching, or, if at->meet,
 *  any (each body is then taken to have as many neighbours as there is room for, or bodies), and every body touches every wall.
 *
 *  All effects of the scene, a host's own among them, stand in the array. scratch is [count] doubles for the bodies of the slice,
 *  which must be all that the springs name. VTI_E_BOND if a spring names a body that is not in the slice, VTI_E_SPRINGS if an effect
 *  does not report its springs: for that there is no bound; the number of the effect is then in stable->effect, and h is NaN.
 *  h is 0 if a number that is read is NaN, in *at also if it is negative, and if strain is 1 or more and shear is there. */
VTI_API int vti_stable_step(const vti_effect *effects, int64_t n, const vti_bodies *bodies, const vti_deformation *at,
                            double *scratch, vti_stable *stable);

#ifdef __cplusplus
}
#endif

#endif
