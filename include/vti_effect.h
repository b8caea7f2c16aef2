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

/** One line of physics. A scene holds an array of those that it calls for; what is not in the array does not exist. The
 *  object behind self stays the caller's. */
typedef struct vti_effect {
    const char *name; /**< what it is called */
    /** Adds this effect's force and moment to the bodies' (a force or moment that is absent is left out). */
    void (*apply)(const void *self, const vti_bodies *bodies);
    /** Writes the effect's energies, one per term. */
    void (*energy)(const void *self, const vti_bodies *bodies, double *energies);
    /** VTI_OK if all that these two read is there, of self and of the bodies; may be NULL. Asked before each of them. */
    int (*check)(const void *self, const vti_bodies *bodies);
    const void *self;        /**< first argument of the three */
    int64_t terms;           /**< at most VTI_TERMS */
    const char *const *term; /**< names of the terms, one each */
    int64_t breaks; /**< momenta that it does not conserve, bits: 0-2 linear, 3-5 angular about 0, 6-8 sum of J Omega */
    int64_t
        dissipates; /**< 1 if it takes energy out of the motion: steppers with negative coefficients would put it in */
} vti_effect;

/** force = moment = 0 on the slice, then every effect in order. An effect without apply, as is made of what is NULL or given
 *  in part, is refused with VTI_E_NULL, and one whose check says no with what it says; then nothing has been touched. */
VTI_API int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Once before a run, if forces are effects: VTI_E_DISSIPATES if method has a negative coefficient and some effect dissipates, else VTI_OK. */
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

/** What can make bodies oscillate; NULL is absent. */
typedef struct vti_springs {
    const vti_bonds *bonds;       /**< all of them, whatever the slice */
    const vti_contacts *contacts; /**< every pair of the list counts as touching */
    const vti_walls *walls;       /**< every body counts as touching each of them */
    const vti_pendulum *pendulum; /**< every body hangs in it */
    double
        overlap; /**< largest overlap to reckon with in contacts, as a share of D: Hertz stiffens as its square root */
} vti_springs;

/** A step h that is stable for every stepper whose limit is h < 2/omega_max: *h = 2/omega with omega >= omega_max of the
 *  linearised motion, bounded bond by bond (EQUATIONS 5) with equal shares of a body for all that pulls at it. Exact
 *  eigenvalues lie below, never above; on the torus by 0.2 %. scratch is [count] doubles for the bodies of the slice, which must
 *  be all that the springs name. *h is infinite if nothing oscillates. VTI_E_BOND if a pair names a body that is not in the slice. */
VTI_API int vti_stable_step(const vti_springs *springs, const vti_bodies *bodies, double *scratch, double *h);

#ifdef __cplusplus
}
#endif

#endif
