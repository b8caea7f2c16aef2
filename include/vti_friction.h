/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of friction where bodies touch each other or walls, and the memory of what each touch holds. */
#ifndef VTI_FRICTION_H
#define VTI_FRICTION_H

#include "vti_contact.h"
#include "vti_effect.h"
#include "vti_wall.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Entries of vti_friction.lost. */
enum { VTI_FRICTION_BOOKS = 3 };

/** What the springs of one touch hold, on body i against the other: loads across the normal, and the moment about
 *  it. */
typedef struct vti_held {
    int64_t i;         /**< 1 + body, from 0 */
    int64_t j;         /**< 1 + the other body; -1 - w: wall w, from 0, planes before cylinders */
    double sliding[3]; /**< force */
    double rolling[3]; /**< moment */
    double twisting;   /**< moment about the normal from j to i */
} vti_held;

/** What touches hold, by the bodies' numbers: memory of the caller's, zeros at the start. The first used of held belong
 *  to a restart, in any order: calls change it, and results do not depend on it. A restart puts them into an empty
 *  history (slot all zeros, used and missed 0) one by one with vti_history_add, which writes the slots; held and used
 *  alone, read back beside empty slots, are no history. Lists of pairs may change while it stays, but each pair always
 *  names its two bodies in the same order, and a list each pair once: a spring that is carried twice slides twice. A
 *  body that the host itself moves elsewhere, to an inlet say, keeps its old entries until it comes near the same body
 *  or wall again. To drop them, copy all other entries into a second history by vti_history_add, and go on with that
 *  one. */
typedef struct vti_history {
    int64_t slots;  /**< a power of 2, at most 2^31, above the number of touches; twice as many are fast */
    int64_t used;   /**< touches that hold something, below slots */
    int64_t missed; /**< touches for which there was no room: calls return VTI_E_HISTORY from then on */
    vti_held *held; /**< [slots], of which the first used hold something */
    int64_t *slot;  /**< [slots], by which they are found; calls write it */
} vti_history;

/** Puts what a touch holds into the history: for a larger one, a restart, or bodies with other numbers. VTI_E_HISTORY
 *  if there is no room, used is negative, slots is no power of 2 up to 2^31, i < 1, j is 0 or i, or a load is not
 *  finite; then it is as it was. */
VTI_API int vti_history_add(vti_history *history, const vti_held *held);

/** Friction of contacts and walls: springs that stretch as surfaces move over each other and slide where they would
 *  hold more than the limit, of three motions (EQUATIONS 6.5):
 *
 *      sliding      load |f| <= sliding F_n        stiffness, or mindlin times the stiffness k_n of the contact
 *      rolling      moment |f| <= rolling F_n      rolling_stiffness
 *      twisting     moment |f| <= twisting F_n     twisting_stiffness
 *
 *  F_n is the elastic force of the contact. After each drift springs are carried along with their pair through turns of
 *  any size, by the drift's own increments, and returned to the limit to second order. Total momentum and angular
 *  momentum are kept to rounding. A motion whose coefficient is 0 does not exist. */
typedef struct vti_friction {
    const vti_contacts *contacts; /**< as in vti_dashpots */
    const vti_walls *walls;       /**< the same */
    double sliding;               /**< coefficient mu */
    double rolling;               /**< length: mu_r, about mu times the radius or less */
    double twisting;              /**< length */
    double stiffness;             /**< of sliding, force/length */
    double mindlin;             /**< in place of it: the ratio of the tangential to the normal stiffness, for bodies of
                                       one material of Poisson's ratio nu 2 (1 - nu)/(2 - nu) */
    double rolling_stiffness;   /**< moment */
    double twisting_stiffness;  /**< moment */
    double reach;               /**< as in vti_dashpots */
    vti_history *history;       /**< what the springs hold */
    vti_sum *lost;              /**< [VTI_FRICTION_BOOKS], memory of the caller's, zeros at the start: the energy that
                                       sliding, rolling and twisting have taken so far */
    const double *wall_sliding; /**< [walls], mu of each plane, then of each cylinder, in place of
                                     sliding, which is to be above 0 still; NULL: of all the same */
    vti_sum *by_body; /**< [bodies][VTI_FRICTION_BOOKS], memory of the caller's, zeros at the start: what each body has
                             lost, of a pair half each, at a wall all; NULL: off. As in vti_dashpots pairs are worked
                             one by one then */
    double *by_pair;  /**< [contacts->count][VTI_FRICTION_BOOKS], memory of the caller's: what each pair of the list has
                             lost in the last drift, which by_body then has no part of, for hosts whose threads have
                             lists that share bodies, or who look at contacts one by one; NULL: off */
} vti_friction;

/** The effect of *friction, which must outlive it, as must the lists, of effects of their own, and the history. Needs
 *  x, v, an attitude and omega. Energy terms, of the springs: "friction_sliding",
 *  "friction_rolling", "friction_twisting"; entries of booked energy: "lost_friction_sliding", "lost_friction_rolling",
 *  "lost_friction_twisting". VTI_E_DAMPING of its calls: a number is negative or not finite, or a motion has no
 *  stiffness. VTI_E_HISTORY: slots is no power of 2 up to 2^31, or used is negative or not below slots, or missed is
 *  not 0, or the slots do not lead to the first or last entry of held, as in a history that vti_history_add did not
 *  make. */
VTI_API vti_effect vti_friction_effect(const vti_friction *friction);

#ifdef __cplusplus
}
#endif

#endif
