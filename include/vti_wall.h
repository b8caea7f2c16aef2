/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of rigid walls: planes, and cylinders from inside, which may move. */
#ifndef VTI_WALL_H
#define VTI_WALL_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How a wall moves: at a velocity and, without changing its place, about its axis, as a piston, a shear box or a drum
 *  does. The host may change velocity and spin between steps. */
typedef struct vti_wall_motion {
    double velocity[3]; /**< of the wall as a whole */
    double spin;        /**< angular velocity about the axis, of a plane its normal through centre */
    double centre[3];   /**< of a plane: a point of that axis where the plane was at first */
    double moved[3];    /**< how far the wall has come from its first place: zeros at the start, moved along with each
                             drift by its own time (vti_effects_carry), part of a restart */
} vti_wall_motion;

/** Rigid walls that keep bodies on one side of planes n.x = offset, that to which n points, and inside of cylinders: a
 *  particle of radius zero at the foot point, U = 2/5 K [1 - g/(D/2)]_+^{5/2}, g being how far the centre is from the
 *  wall. They are counted from 0, planes first. Bodies are to be thinner than their cylinder, D/2 below its radius: in
 *  a narrower one the push may hold them across by more than vti_stable_step is told. */
typedef struct vti_walls {
    int64_t count;           /**< planes */
    const double *plane;     /**< [count][4]: n (unit), offset; where it was at first, if it moves */
    vti_scalars diameter;    /**< D: one for all, or [bodies] */
    double stiffness;        /**< K^pw, energy, of all walls */
    const double *each;      /**< [count + cylinders], K^pw of each wall in place of it; NULL: of all the same */
    int64_t cylinders;       /**< how many */
    const double *cylinder;  /**< [cylinders][7]: axis (unit), a point on it, radius; the point at first */
    vti_wall_motion *motion; /**< [count + cylinders]: memory of the caller's; NULL: none moves */
    vti_sum *work;           /**< one, memory of the caller's, {0, 0} at the start, needed where there is motion: the
                                  energy that the moving walls have taken, negative what they have put in, by their
                                  normal forces and by the friction and dashpots on them (EQUATIONS 6.1) */
    vti_scalars modulus;     /**< E/(1 - nu^2) of the bodies, force/area: K of a body at a wall then follows from the
                                  material of both, K = (4/3) E* R^3, 1/E* = 1/M_body + 1/M_wall, and stiffness and each
                                  are 0 and NULL (EQUATIONS 6.6) */
    const double *moduli;    /**< [count + cylinders], the same of each wall; NULL: they are rigid, 1/M_wall = 0 */
    vti_sum *by_body; /**< [bodies], memory of the caller's, zeros at the start: what of work is each body's; NULL:
                                  off */
} vti_walls;

/** Whether they may be walls of n bodies: normals and axes are of length 1 to 1e-12, radii and moduli finite and > 0,
 *  K finite and >= 0, or none with a modulus, places and motions finite, and the bodies' diameters and moduli finite
 *  and > 0 and as many as are needed. VTI_E_NULL, VTI_E_COUNT, or VTI_E_CONTACT with the number of the wall in
 *  fault->body and what is wrong with it in fault->value, of a normal or axis its length; -1 where it is not about
 *  one wall: then fault->value is the body of which a number is wrong, or the stiffness that is one too many. Effects
 *  look at the walls themselves before every call, at the bodies' diameters they do not. */
VTI_API int vti_walls_check(const vti_walls *walls, int64_t n, vti_fault *fault);

/** The distance of the place x from wall w where it is now, and in n the unit normal there, from the wall to x; on a
 *  cylinder's axis n = 0. NaN, and n as it was, if there is no such wall. */
VTI_API double vti_walls_gap(const vti_walls *walls, int64_t w, const double x[3], double n[3]);

/** K of body i at wall w, both from 0; NaN if there is no such wall or no diameter of that body. */
VTI_API double vti_walls_stiffness(const vti_walls *walls, int64_t w, int64_t i);

/** The effect of *walls, which must outlive it. Needs x; VTI_E_CONTACT of its calls as vti_walls_check says. Energy
 *  term: "wall". Where walls move it needs v, carries them along with each drift, so that its steps are those of
 *  vti_effects_begin, and books their work: "work_wall". It stands before the friction of its walls. */
VTI_API vti_effect vti_walls_effect(const vti_walls *walls);

#ifdef __cplusplus
}
#endif

#endif
