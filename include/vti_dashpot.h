/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The effect of dashpots where bodies touch each other or walls. */
#ifndef VTI_DASHPOT_H
#define VTI_DASHPOT_H

#include "vti_contact.h"
#include "vti_effect.h"
#include "vti_friction.h"
#include "vti_wall.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Entries of vti_dashpots.lost. */
enum { VTI_DASHPOT_BOOKS = 4 };

/** Dashpots of contacts and walls, each the exact flow of its two bodies' velocities (EQUATIONS 6.3), gone through
 *  before a drift and backwards after it: none gains energy, whatever h, the coefficients and the number of contacts,
 *  and the stable step stays what it was. Total momentum and angular momentum are kept to rounding. A coefficient that
 *  depends on the overlap is its mean over the drift beside it.
 *
 *  Pairs within reach are coloured 256 at a time, in the order of the list, each with the smallest colour that neither
 *  of its bodies has yet. Pairs of one colour share no body, and are processed many at once (EQUATIONS 6.4).
 *
 *  The normal coefficient is normal + 2 zeta sqrt((5/6) m_n k_n), m_n the reduced mass and k_n the stiffness of the
 *  contact where it is: with zeta alone restitution is the same at every speed, as vti_dashpots_zeta has it. The
 *  tangential one is tangential + ratio times the normal one.
 *
 *  Of bodies with moments, and of clumps, the inverse reduced mass is a tensor K: the velocity that the contact point
 *  gains by an impulse there, the whole body moving. m_n is 1/(n.K n), and the tangential velocity decays along two
 *  directions, each with its own mass. */
typedef struct vti_dashpots {
    const vti_contacts *contacts; /**< pairs, diameters and stiffness, or NULL; its list may change between steps, and
                                       holds the pairs that touch at either end of a drift */
    const vti_walls *walls;       /**< planes and cylinders, or NULL */
    const vti_friction *friction; /**< of the same lists, or NULL: tangential, rolling and twisting dashpots and its
                                       springs obey its limits together */
    double zeta;                  /**< damping ratio of the normal motion */
    double normal;                /**< mass/time */
    double tangential;            /**< mass/time */
    double ratio;                 /**< of the tangential to the normal coefficient */
    double rolling;               /**< against rolling over each other, energy times time; needs omega */
    double twisting;              /**< against turning about the normal; needs omega */
    int64_t pull;                 /**< 0: the normal force never attracts, as the dashpot's pull is limited to the
                                       contact's push; 1: it may */
    double reach;                 /**< length, to be given, > 0: pairs with a wider gap are skipped. Lists must hold all
                                       pairs with a narrower one; what else they hold does not matter. More than two
                                       bodies come nearer in one drift, or touches that begin and end within one are
                                       missed, at the cost of the order. INFINITY: skip none */
    vti_sum *lost;                /**< [VTI_DASHPOT_BOOKS], memory of the caller's, zeros at the start: the energy that
                                       the motions have lost so far, normal, tangential, rolling, twisting */
    const double *wall_zeta;      /**< [walls], zeta of each plane, then of each cylinder, in place
                                       of zeta; NULL: of all the same */
    vti_sum *by_body; /**< [bodies][VTI_DASHPOT_BOOKS], memory of the caller's, zeros at the start: what each
                                       body has lost, of a pair half each, at a wall all; NULL: off. Bits of all else
                                       are the same; pairs are worked one by one then, not as many as a register
                                       holds */
} vti_dashpots;

/** The zeta by which two bodies part with the share e of the velocity with which they meet, 0 < e <= 1, in a Hertzian
 *  and in a linear contact, at every speed: with pull e = exp(-pi zeta/sqrt(1 - zeta^2)), without
 *  e = exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2)). NaN for other e. */
VTI_API double vti_dashpots_zeta(double e, int64_t pull);

/** The effect of *dashpots, which must outlive it, as must the lists, of effects of their own. Needs x, v and mass, and
 *  inertia or moments where bodies turn. Entries of booked energy: "lost_dashpot_normal", "lost_dashpot_tangential",
 *  "lost_dashpot_rolling", "lost_dashpot_twisting". VTI_E_DAMPING of its calls: a coefficient, or a limit
 *  of friction, is negative or not finite, or the reach is not positive. */
VTI_API vti_effect vti_dashpots_effect(const vti_dashpots *dashpots);

#ifdef __cplusplus
}
#endif

#endif
