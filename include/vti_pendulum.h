/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of gravity on bodies that hang from pivots. */
#ifndef VTI_PENDULUM_H
#define VTI_PENDULUM_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Three-dimensional pendulum: bodies hang by their body-fixed arm rho0 from pivots in a field g along +e3 (E2).
 *  U = -m g e3 . R rho0, RM = m g (R rho0) x e3 (E1; EQUATIONS 3). Rotation only. */
typedef struct vti_pendulum {
    double weight;  /**< m g, a force */
    double rho0[3]; /**< arm in the body's frame, a length */
} vti_pendulum;

/** The effect of *pendulum, which must outlive it. Needs an attitude. Energy term: "pendulum". */
VTI_API vti_effect vti_pendulum_effect(const vti_pendulum *pendulum);
/** U of a body whose arm R rho0 is arm. */
static inline double vti_pendulum_potential(const vti_pendulum *pendulum, const double arm[3])
{
    return -pendulum->weight * arm[2];
}
/** R rho0 of body i in the inertial frame; NaN if there is no such body or it has no attitude. */
VTI_API void vti_pendulum_arm(const vti_pendulum *pendulum, const vti_bodies *bodies, int64_t i, double arm[3]);

#ifdef __cplusplus
}
#endif

#endif
