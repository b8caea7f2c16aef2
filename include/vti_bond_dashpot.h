/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of dashpots in bonds. */
#ifndef VTI_BOND_DASHPOT_H
#define VTI_BOND_DASHPOT_H

#include "vti_binder.h"
#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Entries of vti_bond_dashpots.lost. */
enum { VTI_BOND_DASHPOT_BOOKS = 4 };

/** Dashpots beside the springs of bonds, as flows of velocities like those of vti_dashpots, without limits: along the
 *  bond, across it, against bending and against twisting (EQUATIONS 6.3). Coefficients are constants, with the term of
 *  zeta added: by it each motion alone, of a bond at rest with nothing else on its bodies, is damped with the ratio
 *  zeta, 2 zeta sqrt(m k) with its own stiffness k and reduced mass m. Of bodies with moments, and of bonds between the
 *  spheres of clumps (vti_clumped), shear and bending have two modes each, and each has a mass of its own. */
typedef struct vti_bond_dashpots {
    const vti_bonds *bonds; /**< whose pairs, lengths and stiffnesses they are */
    double zeta;            /**< of all terms that the bonds have */
    double axial;           /**< mass/time */
    double shear;           /**< mass/time */
    double bending;         /**< energy times time; needs omega */
    double twisting;        /**< energy times time; needs omega */
    vti_sum *lost;    /**< [VTI_BOND_DASHPOT_BOOKS], memory of the caller's, zeros at the start: the energy that the
                                 motions have lost so far, axial, shear, bending, twisting */
    vti_sum *by_body; /**< [bodies][VTI_BOND_DASHPOT_BOOKS], memory of the caller's, zeros at the start: what each body
                           has lost, half of what its bonds have; NULL: off. As in vti_dashpots bonds go one by one
                           then */
} vti_bond_dashpots;

/** The effect of *dashpots, which must outlive it, as must the bonds, of an effect of their own. Needs x, v and mass,
 *  and omega and inertia, or moments, where bonds turn bodies. Entries of booked energy: "lost_bond_axial",
 *  "lost_bond_shear", "lost_bond_bending", "lost_bond_twisting". VTI_E_DAMPING of its calls: a coefficient is negative
 *  or not finite. */
VTI_API vti_effect vti_bond_dashpots_effect(const vti_bond_dashpots *dashpots);

#ifdef __cplusplus
}
#endif

#endif
