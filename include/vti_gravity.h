/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of a uniform field. */
#ifndef VTI_GRAVITY_H
#define VTI_GRAVITY_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Uniform field: F = m g, U = -m g.x. Needs mass and, for the energy, x. */
typedef struct vti_gravity {
    double g[3]; /**< acceleration */
} vti_gravity;

/** The effect of *gravity, which must outlive it. Energy term: "gravity". */
VTI_API vti_effect vti_gravity_effect(const vti_gravity *gravity);

#ifdef __cplusplus
}
#endif

#endif
