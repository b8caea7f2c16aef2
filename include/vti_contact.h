/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of Hertzian contact between bodies. */
#ifndef VTI_CONTACT_H
#define VTI_CONTACT_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Hertzian contact between the pairs of a list, U = 2/5 K [1 - r/L]_+^{5/2} (E4). The list may hold pairs that do not
 *  touch; it names each pair once, as one that it names twice would act twice. Coincident centres have no direction: no
 *  force.
 *
 *  All pairs share one energy K, or K follows from the bodies' material: F = k_H (L - r)^{3/2}, K = k_H L^{5/2}, k_H =
 *  (4/3) E* sqrt(R*), 1/R* = 2/D_i + 2/D_j, 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j (EQUATIONS 6.6). */
typedef struct vti_contacts {
    int64_t count;        /**< pairs in the list */
    const int64_t *pair;  /**< [count][2] */
    int64_t base;         /**< 0, or 1 in Fortran */
    vti_scalars diameter; /**< D: one for all, or [bodies] */
    double stiffness;     /**< K^pp of all pairs, energy; 0 where there is a modulus */
    vti_scalars modulus;  /**< E/(1 - nu^2) of the bodies, force/area, of Young's modulus E and Poisson's ratio nu */
    vti_scalars length;   /**< [count] L, the distance at which each pair begins to touch: that of a pair whose bond has
                               broken while its bodies overlap (EQUATIONS 6.7). Absent: (D_i + D_j)/2 for all */
} vti_contacts;

/** When the list has changed, for those who do not trust it: every pair names two different bodies of the n that exist,
 *  diameters, moduli and lengths are finite and > 0 and as many as are needed, and K is finite and >= 0, or 0 with a
 *  modulus. On failure VTI_E_CONTACT, with fault->body the number of the pair, -1 for K, and fault->value what is
 *  wrong: the number, the body for which there is none, or how many lengths there are. */
VTI_API int vti_contacts_check(const vti_contacts *contacts, int64_t n, vti_fault *fault);
/** K of pair k, from 0; NaN if there is none. For scales of energy and time: two spheres of reduced mass m that meet at
 *  v overlap by (5 m v^2/(4 K))^{2/5} of L. */
VTI_API double vti_contacts_stiffness(const vti_contacts *contacts, int64_t k);
/** The effect of *contacts, which must outlive it; its list may change between steps. Energy term: "contact". Where any
 *  two bodies may meet (vti_deformation), those that are not in the list begin to touch at (D_i + D_j)/2. */
VTI_API vti_effect vti_contacts_effect(const vti_contacts *contacts);

#ifdef __cplusplus
}
#endif

#endif
