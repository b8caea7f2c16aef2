/* SPDX-License-Identifier: BSD-3-Clause
 * Effects: the forces, moments and energies that a scene calls for. */
#ifndef VTI_EFFECT_H
#define VTI_EFFECT_H

#include "vti_bodies.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- effects (EQUATIONS 3) ------------------------------------------------------------------------------------ */

/** One line of physics. A scene holds an array of those that it calls for; what is not in the array does not exist. The
 *  object behind self stays the caller's. */
typedef struct vti_effect {
    const char *name;
    /** Adds this effect's force and moment to the bodies' (views that are absent are left out). */
    void (*apply)(const void *self, const vti_bodies *bodies);
    /** Writes the effect's energies, one per term. */
    void (*energy)(const void *self, const vti_bodies *bodies, double *energies);
    const void *self;
    int64_t terms;
    const char *const *term; /* names of the terms, one each */
    int64_t breaks;          /* momenta that the effect does not conserve: bits 0-2 linear, 3-5 angular about 0 */
} vti_effect;

/** force = moment = 0 on the slice, then every effect in order. */
VTI_API int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *bodies);

/** Three-dimensional pendulum: bodies hang by their body-fixed arm rho0 from pivots in a field g along +e3 (E2).
 *  U = -m g e3 . R rho0, RM = m g (R rho0) x e3 (E1). Rotation only. */
typedef struct vti_pendulum {
    double weight;  /* m g */
    double rho0[3]; /* arm in the body's frame */
} vti_pendulum;

/** The effect of *pendulum, which must outlive it. Energy term: "pendulum". */
VTI_API vti_effect vti_pendulum_effect(const vti_pendulum *pendulum);
/** R rho0 of body i in the inertial frame. */
VTI_API void vti_pendulum_arm(const vti_pendulum *pendulum, const vti_bodies *bodies, int64_t i, double arm[3]);

#ifdef __cplusplus
}
#endif

#endif
