/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of bonds that break. */
#ifndef VTI_RUPTURE_H
#define VTI_RUPTURE_H

#include "vti_binder.h"
#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Entries of vti_rupture.lost. */
enum { VTI_RUPTURE_BOOKS = 1 };

/** What bonds bear (EQUATIONS 6.7). At the end of a step, with N, V, M_b, M_t, U and r/L0 - 1 of vti_bonds_measure
 *  where the bodies are, those break for which
 *
 *      N/normal + V/shear + M_b/bending + M_t/torsion >= 1,  or  r/L0 - 1 >= stretch,  or  U >= energy;
 *
 *  pressure, N < 0, delays. A limit that is absent is no limit, one that is infinite is never met, and of bond number m
 *  it is number m of the array, or one for all.
 *
 *  All bonds are tested on the same state. What breaks leaves the list: bonds->count falls, the arrays of the list keep
 *  their order, and what has left stands behind them, in the same arrays. So everything else that reads the list, as
 *  the effect of the bonds and that of their dashpots, is as it would be had the bond never been there, to the bit, and
 *  is spent on bonds that hold only. */
typedef struct vti_rupture {
    vti_bonds *bonds; /**< of an effect of their own. pair, rest, turn and stiffnesses that are arrays are written when
                           bonds leave: memory that may be written, that no other list shares, with one value for each
                           bond */
    int64_t *id; /**< [count] as the list was at first: numbers of the bonds, counted from bonds->base and ascending:
                           0, 1, 2 ... They move with their bonds */
    vti_scalars stretch; /**< of r/L0 - 1 */
    vti_scalars normal;  /**< of N, a force */
    vti_scalars shear;   /**< of V, a force */
    vti_scalars bending; /**< of M_b, a moment */
    vti_scalars torsion; /**< of M_t, a moment */
    vti_scalars energy;  /**< of U */
    vti_sum *lost;       /**< [VTI_RUPTURE_BOOKS], memory of the caller's, zeros at the start: the energy that bonds had
                              when they broke */
    vti_sum *by_body; /**< [bodies], memory of the caller's, zeros at the start: of each body half of what its bonds had
                              when they broke; NULL: off */
} vti_rupture;

/** Once before use, after vti_bonds_check: numbers ascend from bonds->base on, and every limit is > 0. On failure
 *  VTI_E_BOND, with fault->body the place of the bond in the list, from 0, and fault->value what is wrong: its number,
 *  its limit, or how many limits there are where they are too few. */
VTI_API int vti_rupture_check(const vti_rupture *rupture, vti_fault *fault);
/** The effect of *rupture, which must outlive it, as must the bonds. It has neither force nor energy, those are the
 *  bonds', and acts in vti_effects_rupture, on all bonds whatever the slice: one thread calls it, and nobody reads the
 *  list meanwhile. Needs positions, and the attitudes that the bonds need. Booked energy: "lost_rupture". */
VTI_API vti_effect vti_rupture_effect(const vti_rupture *rupture);
/** Takes the bonds out of the list whose count numbers stand in id, ascending, as when they break, but books nothing:
 *  to go on from a checkpoint, or for rules of the host's own. VTI_E_BOND where one is not in the list; nothing has
 *  changed then. */
VTI_API int vti_rupture_take_out(const vti_rupture *rupture, int64_t count, const int64_t *id);

#ifdef __cplusplus
}
#endif

#endif
