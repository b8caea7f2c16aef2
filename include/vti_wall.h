/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of rigid planes. */
#ifndef VTI_WALL_H
#define VTI_WALL_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Rigid planes n.x = offset that keep bodies on the side to which n points: a particle of radius zero at the foot
 *  point, U = 2/5 K [1 - g/(D/2)]_+^{5/2} with g = n.x - offset. */
typedef struct vti_walls {
    int64_t count;        /**< planes */
    const double *plane;  /**< [count][4]: n (unit), offset */
    vti_scalars diameter; /**< D of the bodies */
    double stiffness;     /**< K^pw, energy */
} vti_walls;

/** The effect of *walls, which must outlive it. Energy term: "wall". */
VTI_API vti_effect vti_walls_effect(const vti_walls *walls);

#ifdef __cplusplus
}
#endif

#endif
