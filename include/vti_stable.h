/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * A rigorous bound on the step, from the springs of the effects. */
#ifndef VTI_STABLE_H
#define VTI_STABLE_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A bound on the step, and what sets it: the stiffest spring at the bodies that limit it. */
typedef struct vti_stable {
    double h;        /**< 2/omega; infinite if nothing oscillates */
    int64_t effect;  /**< number of the effect in the array, from 0; -1 if nothing oscillates */
    int64_t element; /**< the number of its spring, as in vti_spring; -1 if nothing oscillates */
    int64_t i;       /**< its body, as in vti_spring; -1 if nothing oscillates */
    int64_t j;       /**< the other one; -1 also if there is none */
} vti_stable;

/** A step that is stable for every stepper whose limit is h < 2/omega_max: stable->h = 2/omega with omega >= omega_max
 *  of the motion linearised where nothing is deformed by more than *at (all zeros: at rest), or where the bodies are
 *  (at = NULL), with bonds that are not bent. It is bounded spring by spring (EQUATIONS 5, 6.10) and never above the
 *  exact eigenvalues' limit; on the torus at rest by 0.2 % below it. Where at is given, pairs in contact are those of
 *  the list, all touching, or, if at->meet, any (each body is then taken to have as many neighbours as there is room
 *  for, or bodies), and every body touches every wall. Bodies with moments count with their smallest (EQUATIONS 7.4).
 *
 *  All effects of the scene, a host's own among them, stand in the array. scratch is [count] doubles for the bodies of
 *  the slice, which must be all that the springs name. VTI_E_BOND if a spring names a body that is not in the slice,
 *  VTI_E_MASS or VTI_E_INERTIA if one pulls or turns bodies that have none (without v bodies stay where they are and
 *  need no mass; without omega, or with moments, they need no inertia; but what they have counts),
 *  VTI_E_SPRINGS if an effect does not report its springs: for that there is no bound; the number of the effect is then
 *  in stable->effect, and h is NaN. h is 0 if a number that is read is NaN, in *at also if it is negative, and if
 *  strain is 1 or more and shear is there. */
VTI_API int vti_stable_step(const vti_effect *effects, int64_t n, const vti_bodies *bodies, const vti_deformation *at,
                            double *scratch, vti_stable *stable);

#ifdef __cplusplus
}
#endif

#endif
