/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of bonds as flows of the time t (EQUATIONS 6.3), with u and w of vti_touch.h for shares of 1/2:
 *
 *     axial p = m_n expm1(-c_a t/m_n) (u.n) n             shear p = m_t expm1(-c_s t/m_t) P u
 *     bending l = J_r expm1(-c_b t/J_r) P w               twisting l = J_r expm1(-c_w t/J_r) (w.n) n
 *
 * Bond by bond in this order, backward reversed. Bodies with moments, and clumps whose spheres are bonded, have the
 * tensors K and H of vti_joint.h in the place of masses: shear and bending have two modes, each damped by its own. */
#include "vti_decay.h"
#include "vti_joint.h"
#include "vti_touch.h"

enum { AXIAL, SHEAR, BENDING, TWISTING, MOTIONS };

/** Bond k where it is. Returns 1, or 0 where its bodies coincide. */
VTI_INLINE int find_bond(struct vti_touch *at, const vti_bonds *p, const vti_bodies *b, int64_t k)
{
    double d[3], xj[3];
    at->moves = 0;
    at->i = p->pair[2 * k] - p->base;
    at->j = p->pair[2 * k + 1] - p->base;
    vti_load(&b->x, at->i, d);
    vti_load(&b->x, at->j, xj);
    for (int c = 0; c < 3; ++c)
        d[c] -= xj[c];
    at->r = vti_norm(d);
    if (!(at->r > VTI_COINCIDENT))
        return 0;
    for (int c = 0; c < 3; ++c)
        at->n[c] = d[c] / at->r;
    at->s_i = at->s_j = 0.5;
    return 1;
}

/** Bond k on the way: backwards where a drift has been. */
static int64_t bond_at(const vti_bonds *p, int64_t k, double drift)
{
    return drift < 0.0 ? p->count - 1 - k : k;
}

static int turns_of(int motion)
{
    return motion == BENDING || motion == TWISTING;
}

/** Of a motion with that reduced mass, or moment of inertia: the constant and 2 zeta sqrt(m k); stiffness is an energy,
 *  k that over length^2. */
VTI_INLINE double coefficient(const vti_bond_dashpots *p, int motion, double mass, int64_t k)
{
    const vti_bonds *bonds = p->bonds;
    const double constant = motion == AXIAL     ? p->axial
                            : motion == SHEAR   ? p->shear
                            : motion == BENDING ? p->bending
                                                : p->twisting;
    const vti_scalars *stiffness = motion == AXIAL ? &bonds->axial : motion == SHEAR ? &bonds->shear : &bonds->moment;
    const double energy = stiffness->p != NULL && p->zeta > 0.0 ? vti_scalar(stiffness, k) : 0.0,
                 length = turns_of(motion) ? 1.0 : bonds->rest[4 * k + 3];
    return constant + (energy > 0.0 ? 2.0 * p->zeta * sqrt(mass * energy) / length : 0.0);
}

/* ---- spheres ----------------------------------------------------------------------------------------------------- */

static void flow_one(const vti_bond_dashpots *p, const struct vti_touch *at, struct vti_touch_motion *m, double t,
                     int64_t k, int motion)
{
    const int turns = turns_of(motion);
    if (turns && !m->turns)
        return;
    const double mass = 1.0 / (turns             ? vti_touch_per_rolling(at)
                               : motion == AXIAL ? vti_touch_per_normal(at)
                                                 : vti_touch_per_tangential(at));
    const double c = coefficient(p, motion, mass, k);
    double a[3], along[3];
    if (!(c > 0.0))
        return;
    if (turns)
        vti_touch_roll(m, a);
    else
        vti_touch_slip(at, m, a);
    vti_touch_split(at, a, along);
    double *const damped = motion == AXIAL || motion == TWISTING ? along : a;
    vti_sum_add(&p->lost[motion], vti_touch_decay(mass, vti_decay(c * t / mass).gone, damped));
    if (turns)
        vti_touch_turn(at, damped, m);
    else
        vti_touch_push(at, damped, m);
}

/* ---- bodies of any inertia --------------------------------------------------------------------------------------- */

static void flow_modes(const vti_bond_dashpots *p, struct vti_joint *at, const double span[][3], double t, int64_t k,
                       int motion)
{
    const int turns = turns_of(motion), along = motion == AXIAL || motion == TWISTING;
    struct vti_joint_modes modes;
    double u[3], push[3], c[3];
    vti_joint_modes_of(at, turns, along ? 1 : 2, span + !along, &modes);
    for (int m = 0; m < modes.count; ++m)
        c[m] = modes.yield[m] > 0.0 ? coefficient(p, motion, 1.0 / modes.yield[m], k) : 0.0;
    vti_joint_velocity(at, turns, u);
    vti_joint_decay(&modes, c, t, u, push);
    vti_sum_add(&p->lost[motion], vti_joint_lost(&modes, u, push));
    vti_joint_push(at, turns, push);
}

static void flow_joint(const vti_bond_dashpots *p, const struct vti_touch *bond, const struct vti_bearing *of, double t,
                       double drift, int64_t k)
{
    struct vti_joint at;
    double span[3][3], place[2][3];
    for (int c = 0; c < 3; ++c) {
        span[0][c] = bond->n[c];
        place[0][c] = -bond->s_i * bond->r * bond->n[c];
        place[1][c] = bond->s_j * bond->r * bond->n[c];
    }
    vti_joint_across(bond->n, span + 1);
    vti_joint_load(of, bond->i, place[0], &at.side[0]);
    vti_joint_load(of, bond->j, place[1], &at.side[1]);
    for (int m = 0; m < MOTIONS; ++m)
        flow_modes(p, &at, (const double(*)[3])span, t, k, drift < 0.0 ? MOTIONS - 1 - m : m);
    for (int side = 0; side < 2; ++side)
        vti_joint_store(of, &at.side[side]);
}

static void flow_joints(const void *self, const vti_clumps *clumps, const vti_bodies *bodies, double t, double drift)
{
    const vti_bond_dashpots *p = self;
    const struct vti_bearing of = {clumps, bodies};
    struct vti_touch at;
    for (int64_t k = 0; k < p->bonds->count; ++k) {
        const int64_t bond = bond_at(p->bonds, k, drift);
        if (find_bond(&at, p->bonds, clumps != NULL ? &clumps->spheres : bodies, bond))
            flow_joint(p, &at, &of, t, drift, bond);
    }
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_bond_dashpots *p = self;
    struct vti_touch at;
    struct vti_touch_motion motion;
    if (vti_has(&b->moments)) {
        flow_joints(p, NULL, b, t, drift);
        return;
    }
    for (int64_t k = 0; k < p->bonds->count; ++k) {
        const int64_t bond = bond_at(p->bonds, k, drift);
        if (!find_bond(&at, p->bonds, b, bond))
            continue;
        vti_touch_masses(&at, b);
        vti_touch_load(&at, b, &motion);
        for (int m = 0; m < MOTIONS; ++m)
            flow_one(p, &at, &motion, t, bond, drift < 0.0 ? MOTIONS - 1 - m : m);
        vti_touch_store(&at, b, &motion);
    }
}

static int check(const void *self, const vti_bodies *b)
{
    const vti_bond_dashpots *p = self;
    const double all[] = {p->zeta, p->axial, p->shear, p->bending, p->twisting};
    for (int k = 0; k < 5; ++k)
        if (!(isfinite(all[k]) && all[k] >= 0.0))
            return VTI_E_DAMPING;
    if (p->bonds->count > 0 && (p->bonds->pair == NULL || p->bonds->rest == NULL))
        return VTI_E_NULL;
    return vti_has(&b->omega) && !vti_has(&b->moments) && b->inertia.p == NULL ? VTI_E_INERTIA : VTI_OK;
}

vti_effect vti_bond_dashpots_effect(const vti_bond_dashpots *dashpots)
{
    static const char *const book[VTI_BOND_DASHPOT_BOOKS] = {"lost_bond_axial", "lost_bond_shear", "lost_bond_bending",
                                                             "lost_bond_twisting"};
    const vti_bond_dashpots *p = dashpots;
    if (p == NULL || p->lost == NULL || p->bonds == NULL)
        return vti_effect_none();
    const int turns = p->bending > 0.0 || p->twisting > 0.0 || (p->zeta > 0.0 && p->bonds->moment.p != NULL);
    const int spins = turns || p->shear > 0.0 || (p->zeta > 0.0 && p->bonds->shear.p != NULL);
    const vti_effect effect = {.name = "bond_dashpot",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = flow_joints,
                               .self = p,
                               .needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS |
                                        (turns ? 1 << VTI_QUANTITY_OMEGA : 0),
                               .smooth = 1,
                               .breaks = spins ? 0700 : 0,
                               .dissipates = 1,
                               .books = VTI_BOND_DASHPOT_BOOKS,
                               .book = book,
                               .booked = p->lost};
    return effect;
}
