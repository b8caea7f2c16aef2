/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of Hertzian contact between bodies. */
#ifndef VTI_CONTACT_H
#define VTI_CONTACT_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Hertzian contact between the pairs of a list, U = 2/5 K [1 - r/D]_+^{5/2} with D = (D_i + D_j)/2 (E4). The list may
 *  hold pairs that do not touch. Coincident centres have no direction: no force. */
typedef struct vti_contacts {
    int64_t count;        /**< pairs in the list */
    const int64_t *pair;  /**< [count][2] */
    int64_t base;         /**< 0, or 1 in Fortran */
    vti_scalars diameter; /**< D of the bodies */
    double stiffness;     /**< K^pp, energy */
} vti_contacts;

/** When the list has changed, for those who do not trust it: every pair names two different bodies of the n that exist,
 *  of finite diameters > 0, and K is finite and >= 0. On failure VTI_E_CONTACT, with fault->body the number of the
 *  pair, -1 for K, and fault->value what is wrong. */
VTI_API int vti_contacts_check(const vti_contacts *contacts, int64_t n, vti_fault *fault);
/** The effect of *contacts, which must outlive it; its list may change between steps. Energy term: "contact". */
VTI_API vti_effect vti_contacts_effect(const vti_contacts *contacts);

#ifdef __cplusplus
}
#endif

#endif
