/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of drag by a medium. */
#ifndef VTI_DRAG_H
#define VTI_DRAG_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Entries of vti_drag.lost. */
enum { VTI_DRAG_BOOKS = 2 };

/** Drag on every body, with u = v - medium:
 *
 *      F = -linear u - quadratic |u| u,      RM = -angular Omega.
 *
 *  It acts as the exact flow of the velocities (EQUATIONS 6.3), before the first kick of a step and after the last:
 *  whatever h and the coefficients, |u| and |Omega| never grow. What is absent (p = NULL) does nothing.
 *
 *  On the spheres of clumps (vti_clumped) it acts on the velocity of each, v + Omega x r, and so on both motions of the
 *  body: as the exact flow of one sphere after the other (quadratic drag to second order), none of which raises the
 *  body's kinetic energy relative to the medium. One value or one for each sphere then; the masses are those of the
 *  bodies. */
typedef struct vti_drag {
    vti_scalars linear;    /**< one value or one for each body, mass/time, finite and >= 0, of which calls look at one
                                value for all only; needs v and mass */
    vti_scalars quadratic; /**< the same, mass/length */
    vti_scalars angular;   /**< the same, mass length^2/time; needs omega, and inertia or moments */
    double medium[3];      /**< velocity of the medium */
    vti_sum *lost;         /**< [VTI_DRAG_BOOKS], memory of the caller's, zeros at the start: the energy that drag has
                                taken out of translation and out of rotation so far. Where several threads have a slice
                                of the bodies each, each has sums of its own. */
    vti_sum *by_body; /**< [bodies][VTI_DRAG_BOOKS], memory of the caller's, zeros at the start: the same of each body,
                                of clumps of each sphere; NULL: off */
} vti_drag;

/** The effect of *drag, which must outlive it. Stands before the other effects of an array, so that its flow is the
 *  outermost. Entries of booked energy: "lost_drag_translation", "lost_drag_rotation". VTI_E_DAMPING of its calls: a
 *  coefficient of all bodies is negative or not finite; VTI_E_INERTIA: it slows turning, and there is no inertia. */
VTI_API vti_effect vti_drag_effect(const vti_drag *drag);

#ifdef __cplusplus
}
#endif

#endif
