/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of bonds as flows of velocities: the order of the bonds, by colours as contacts' (EQUATIONS 6.4), and the
 * effect; what a bond between spheres does is in vti_bond_kernels.h. Bodies with moments, and clumps whose spheres are
 * bonded, have the tensors K and H of vti_joint.h in the place of masses: shear and bending have two modes, each damped
 * by its own; those bonds go one by one. */
#include "vti_bond_flow.h"
#include "vti_colour.h"
#include "vti_decay.h"
#include "vti_joint.h"
#include "../vti_shares.h"
#include "../contacts/vti_touch.h"
#include "../vti_ready.h"

enum { MOTIONS = VTI_BOND_DASHPOT_BOOKS };

/** Bond k where it is. Returns 1, or 0 where its bodies coincide. */
VTI_INLINE int find_bond(struct vti_touch *at, const vti_bonds *p, const vti_bodies *b, int64_t k)
{
    double d[3];
    vti_touch_apart(at, p->pair, p->base, b, k, d);
    at->r = vti_norm(d);
    if (!(at->r > VTI_COINCIDENT))
        return 0;
    for (int c = 0; c < 3; ++c)
        at->n[c] = d[c] / at->r;
    at->s_i = at->s_j = 0.5;
    return 1;
}

/** Windows of the list from the first on; where a drift has been the same from the last on. */
static void visit_bonds(const vti_bonds *bonds, double drift, vti_colour_work *work, const void *context)
{
    const int64_t windows = (bonds->count + VTI_WINDOW - 1) / VTI_WINDOW;
    int64_t number[VTI_WINDOW];
    struct vti_window window;
    for (int64_t w = 0; w < windows; ++w) {
        const int64_t first = VTI_WINDOW * (drift < 0.0 ? windows - 1 - w : w), left = bonds->count - first,
                      count = left < VTI_WINDOW ? left : VTI_WINDOW;
        for (int64_t n = 0; n < count; ++n)
            number[n] = first + n;
        vti_window_work(&window, bonds->pair, number, count, drift < 0.0, work, context);
    }
}

/** c of one motion of bond k. */
static double coefficient(const vti_bond_dashpots *p, int motion, double mass, int64_t k)
{
    const vti_scalars *const stiffness = vti_bond_stiffness(p, motion);
    const double energy = stiffness->p != NULL && p->zeta > 0.0 ? vti_scalar(stiffness, k) : 0.0;
    return vti_bond_coefficient(p, motion, mass, energy, vti_bond_turns(motion) ? 1.0 : p->bonds->rest[4 * k + 3]);
}

/* ---- spheres ----------------------------------------------------------------------------------------------------- */

/** So many bonds of one colour in this order. */
static void flow_colour(const void *sweep, const int64_t *bonds, int64_t count, int64_t most)
{
    for (int64_t first = 0; first < count; first += most) {
        const int64_t left = count - first, n = left < most ? left : most;
        vti_touch_kernels_for(n)->flow_bonds(sweep, n, bonds + first);
    }
}

/** The same one by one, so that what each bond loses is known. */
static void flow_singly(const void *sweep, const int64_t *bonds, int64_t count, int64_t most)
{
    const struct vti_bond_sweep *const s = sweep;
    const vti_bonds *const list = s->p->bonds;
    vti_bond_dashpots own = *s->p;
    struct vti_bond_sweep one = *s;
    (void)most;
    one.p = &own;
    for (int64_t k = 0; k < count; ++k) {
        const int64_t *const pair = list->pair + 2 * bonds[k];
        vti_sum lost[MOTIONS] = {{0.0, 0.0}};
        own.lost = lost;
        vti_touch_kernels_for(1)->flow_bonds(&one, 1, bonds + k);
        vti_share_out(lost, MOTIONS, s->p->lost, s->p->by_body, pair[0] - list->base, pair[1] - list->base);
    }
}

/* ---- bodies of any inertia --------------------------------------------------------------------------------------- */

static double flow_modes(const vti_bond_dashpots *p, struct vti_joint *at, const double span[][3], double t, int64_t k,
                         int motion)
{
    const int turns = vti_bond_turns(motion), along = motion == VTI_AXIAL || motion == VTI_TWIST;
    struct vti_joint_modes modes;
    double u[3], push[3], c[3];
    vti_joint_modes_of(at, turns, along ? 1 : 2, span + !along, &modes);
    for (int m = 0; m < modes.count; ++m)
        c[m] = modes.inverse_mass[m] > 0.0 ? coefficient(p, motion, 1.0 / modes.inverse_mass[m], k) : 0.0;
    vti_joint_velocity(at, turns, u);
    vti_joint_decay(&modes, c, t, u, push);
    vti_joint_push(at, turns, push);
    return vti_joint_lost(&modes, u, push);
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
    for (int m = 0; m < MOTIONS; ++m) {
        const int motion = drift < 0.0 ? MOTIONS - 1 - m : m;
        const double lost = flow_modes(p, &at, (const double(*)[3])span, t, k, motion);
        vti_sum_add(&p->lost[motion], lost);
        if (p->by_body != NULL)
            vti_share(p->by_body, MOTIONS, motion, bond->i, bond->j, lost);
    }
    for (int side = 0; side < 2; ++side)
        vti_joint_store(of, &at.side[side]);
}

/** Bonds between bodies of any inertia, or spheres of clumps. */
struct joints {
    const vti_bond_dashpots *p;
    struct vti_bearing of;
    const vti_bodies *spheres; /* those of the list */
    double t, drift;
};

/** So many bonds of one colour, one by one. */
static void flow_joints_of(const void *joints, const int64_t *bonds, int64_t count, int64_t most)
{
    const struct joints *const s = joints;
    struct vti_touch at;
    (void)most;
    for (int64_t k = 0; k < count; ++k)
        if (find_bond(&at, s->p->bonds, s->spheres, bonds[k]))
            flow_joint(s->p, &at, &s->of, s->t, s->drift, bonds[k]);
}

static void flow_joints(const void *self, const vti_clumps *clumps, const vti_bodies *bodies, double t, double drift)
{
    const vti_bond_dashpots *p = self;
    const struct joints s = {p, {clumps, bodies}, clumps != NULL ? &clumps->spheres : bodies, t, drift};
    visit_bonds(p->bonds, drift, flow_joints_of, &s);
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_bond_dashpots *p = self;
    const struct vti_bond_sweep s = {.p = p, .b = b, .t = t, .drift = drift};
    if (vti_has(&b->moments))
        flow_joints(p, NULL, b, t, drift);
    else
        visit_bonds(p->bonds, drift, p->by_body == NULL ? flow_colour : flow_singly, &s);
}

/** Whether they turn bodies. */
static int turns(const vti_bond_dashpots *p)
{
    return p->bending > 0.0 || p->twisting > 0.0 || (p->zeta > 0.0 && p->bonds->moment.p != NULL);
}

static int check(const void *self, const vti_bodies *b)
{
    const vti_bond_dashpots *p = self;
    const double all[] = {p->zeta, p->axial, p->shear, p->bending, p->twisting};
    for (int k = 0; k < 5; ++k)
        if (!(isfinite(all[k]) && all[k] >= 0.0))
            return VTI_E_DAMPING;
    if (p->lost == NULL)
        return VTI_E_NULL;
    if (turns(p) && !vti_has(&b->omega))
        return VTI_E_NEEDS;
    const int64_t reads = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS;
    const int status = vti_bonds_ready(p->bonds, b, reads);
    return status != VTI_OK ? status : vti_inertia_check(b);
}

vti_effect vti_bond_dashpots_effect(const vti_bond_dashpots *dashpots)
{
    static const char *const book[VTI_BOND_DASHPOT_BOOKS] = {"lost_bond_axial", "lost_bond_shear", "lost_bond_bending",
                                                             "lost_bond_twisting"};
    const vti_bond_dashpots *p = dashpots;
    if (p == NULL || p->lost == NULL || p->bonds == NULL)
        return vti_effect_none();
    const int spins = turns(p) || p->shear > 0.0 || (p->zeta > 0.0 && p->bonds->shear.p != NULL);
    const vti_effect effect = {.name = "bond_dashpot",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = flow_joints,
                               .self = p,
                               .needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS |
                                        (turns(p) ? 1 << VTI_QUANTITY_OMEGA : 0),
                               .smooth = 1,
                               .settles = 1,
                               .breaks = spins ? VTI_BREAKS_SPINS : 0,
                               .dissipates = 1,
                               .books = VTI_BOND_DASHPOT_BOOKS,
                               .book = book,
                               .booked = p->lost,
                               .by_body = p->by_body,
                               .of_body = VTI_BOND_DASHPOT_BOOKS};
    return effect;
}
