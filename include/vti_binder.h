/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of bonds between bodies. */
#ifndef VTI_BINDER_H
#define VTI_BINDER_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Forms of the shear energy; c is the cosine between the bond and where the bodies' attitudes would have it. */
enum vti_shear {
    VTI_SHEAR_OBJECTIVE = 1, /**< K (1 - c), c = n.(b_i + b_j)/|b_i + b_j|: the default */
    VTI_SHEAR_QUARTIC = 2,   /**< K/2 (1 - c)^2 with the same c: objective, with the printed exponent */
    VTI_SHEAR_PRINTED = 3    /**< K/2 (1 - c)^2 with c = (R_i n0).(R_j n): as printed, not objective (E11) */
};

/** Bonds between bodies, in the caller's memory (EQUATIONS 3). With d = x_i - x_j, r = |d|, n = d/r and b = R n0:
 *      moment  K/2 |theta_ij|^2, exp S(theta_ij) = R_i R_j^T
 *      axial   K/2 (r/L0 - 1)^2
 *      shear   as vti_shear says
 *  A stiffness that is absent (p = NULL) is a term that is absent, and costs nothing. Attitudes are those that have
 *  turned the bodies since the rest configuration, in which R = I. Coincident centres have no direction: no force.
 *
 *  Bonds whose bodies are not at R = I when they are at rest, as those made later, have a rotation Q0 each: b_i = R_i
 *  n0, b_j = R_j Q0^T n0 and exp S(theta_ij) = R_i Q0 R_j^T (EQUATIONS 6.6). At rest is where L0 = r, n0 = R_i^T n and
 *  Q0 = R_i^T R_j: vti_bonds_rest_now. */
typedef struct vti_bonds {
    int64_t count;       /**< bonds in the list */
    const int64_t *pair; /**< [count][2]: i, j */
    int64_t base;        /**< index of the first body in pair: 0, or 1 in Fortran */
    const double *rest;  /**< [count][4]: n0, L0 with x_i0 - x_j0 = L0 n0; see vti_bonds_rest */
    vti_scalars moment;  /**< K^m, energy: one for all, or [count] */
    vti_scalars axial;   /**< K^a, likewise; the axial stiffness is K^a/L0^2 */
    vti_scalars shear;   /**< K^s, likewise */
    int64_t shear_form;  /**< vti_shear; ignored without shear */
    const double *turn; /**< [count][4]: Q0 as a unit quaternion (x, y, z, w). NULL: I for all, which costs nothing. Not
                              with the printed shear, which knows one frame only */
} vti_bonds;

/** rest[count][4] of the pairs from the positions x of the rest configuration. VTI_E_BOND, with fault->body the number
 *  of the bond (from 0), if its bodies coincide, or one comes before the first or, where x has a count, after the
 *  last. */
VTI_API int vti_bonds_rest(int64_t count, const int64_t *pair, int64_t base, const vti_view *x, double *rest,
                           vti_fault *fault);
/** rest[count][4] and turn[count][4] of pairs that are to be at rest where the bodies are now, turned as they are:
 *  those bonds have neither force nor moment nor energy, to rounding. Bodies without attitudes have not turned. Errors
 *  as those of vti_bonds_rest, VTI_E_NEEDS without positions, VTI_E_BOND also for a body that does not exist and for an
 *  attitude that is a zero quaternion or not finite, or a status of vti_bodies_check; then nothing has been written. */
VTI_API int vti_bonds_rest_now(int64_t count, const int64_t *pair, int64_t base, const vti_bodies *b, double *rest,
                               double *turn, vti_fault *fault);
/** Once before use: every pair names two different bodies of the n that exist, L0 > 0, |n0| = |Q0| = 1, stiffnesses
 *  finite and >= 0. On failure VTI_E_BOND, with fault->body the number of the bond and fault->value what is wrong: the
 *  length of Q0, say; with bond -1 it is a shear_form that does not exist or cannot be used with turn. */
VTI_API int vti_bonds_check(const vti_bonds *bonds, int64_t n, vti_fault *fault);
/** Numbers of one bond between vti_bonds_loads and vti_bonds_sum, for nobody else to read. */
#define VTI_BOND_LOADS 9

/** The effect of the bonds in two passes that threads can share: first loads of bonds, each thread those of its own
 *  range, then their sums, each thread those of its own bodies. The bits are those of the effect, however many share.
 *  vti_bonds_loads writes loads[(last - first) * VTI_BOND_LOADS] of the bonds first <= k < last, counted from 0, of the
 *  bodies as they are; nothing else changes. Once before use: vti_bonds_check. VTI_E_NULL without a list, bodies or
 *  loads, VTI_E_COUNT unless 0 <= first <= last <= count, VTI_E_BOND for a shear_form that is none or that does not go
 *  with turn, VTI_E_NEEDS without the positions or attitudes that the bonds read, or what is wrong with the bodies. */
VTI_API int vti_bonds_loads(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last, double *loads);
/** Adds loads[(last - first) * VTI_BOND_LOADS] of the bonds first <= k < last to force and moment of those of their
 *  bodies that are in the slice, in the order of the list; an absent one is left out. No two threads may sum for the
 *  same body. Errors as those of vti_bonds_loads. */
VTI_API int vti_bonds_sum(const vti_bonds *bonds, const double *loads, int64_t first, int64_t last,
                          const vti_bodies *b);
/** What vti_bonds_measure says of a bond, with n, r and L0 as above. */
enum vti_bond_measure {
    VTI_BOND_NORMAL = 0,  /**< N = (K^a/L0)(r/L0 - 1): a force, negative under pressure */
    VTI_BOND_ACROSS = 1,  /**< V, the force across n; of the objective shear (K^s/r)|P mh|, P u = u - (u.n) n */
    VTI_BOND_BENDING = 2, /**< M_b = K^m|P theta_ij|: a moment */
    VTI_BOND_TORSION = 3, /**< M_t = K^m|theta_ij.n| */
    VTI_BOND_ENERGY = 4,  /**< U, of all terms */
    VTI_BOND_STRETCH = 5, /**< r/L0 - 1 */
    VTI_BOND_MEASURES = 6 /**< how many they are */
};

/** What the springs of the bonds first <= k < last hold where the bodies are, without dashpots: measures[(last - first)
 *  * VTI_BOND_MEASURES], bond by bond. Of a term that is absent it is 0. Errors as those of vti_bonds_loads; positions
 *  are needed whatever the terms. */
VTI_API int vti_bonds_measure(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,
                              double *measures);
/** The effect of *bonds, which must outlive it. Bonds across the slice's edge load its own bodies only. Energy
 *  terms, of those that are present: "binder_moment", "binder_axial", "binder_shear". */
VTI_API vti_effect vti_bonds_effect(const vti_bonds *bonds);

#ifdef __cplusplus
}
#endif

#endif
