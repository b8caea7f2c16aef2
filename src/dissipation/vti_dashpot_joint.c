/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of bodies with moments and of clumps where they touch each other or walls: the four flows of EQUATIONS 6.3
 * with the tensors of vti_joint.h in the place of masses, in the same order and by the same coefficients and limits.
 * The normal motion is one mode, and so is twisting; the tangential motion and rolling have two, which need not decay
 * alike. m_n, by which zeta counts, is 1/(n.K n). */
#include "vti_damping.h"
#include "vti_joint.h"
#include "../vti_shares.h"
#include "../contacts/vti_touch.h"

/** What each touch takes part in. */
struct sweep {
    const vti_dashpots *p;
    struct vti_bearing of;
    const vti_bodies *b; /* those of the lists */
    double t, drift;
    int damped[VTI_DASHPOT_BOOKS];
};

struct place {
    struct vti_touch touch;
    struct vti_joint joint;
    struct vti_damping damping;
    double span[3][3]; /* the normal, and across it */
    double c[VTI_DASHPOT_BOOKS];
    const vti_held *held; /* by the springs of friction */
};

/** What the limits leave of the impulse p: contacts that do not hold together pull no harder than they push, and spring
 *  and dashpot obey friction's limit together. */
static void limit(const struct sweep *s, const struct place *at, int motion, double p[3])
{
    if (motion == VTI_NORMAL) {
        const double size = vti_dot(p, at->touch.n), least = vti_damping_force(&at->damping, -s->t);
        for (int k = 0; k < 3 && !s->p->pull && size < least; ++k)
            p[k] *= least / size;
        return;
    }
    const double share = vti_damping_share_of_force(s->p, &at->touch, motion);
    double load[3];
    for (int k = 0; k < 3; ++k)
        load[k] = motion == VTI_TANGENTIAL ? at->held->sliding[k]
                  : motion == VTI_ROLLING  ? at->held->rolling[k]
                                           : at->held->twisting * at->touch.n[k];
    if (share >= 0.0)
        vti_damping_limit(p, load, s->t, vti_damping_force(&at->damping, share));
}

/** Two modes that do not decay alike may gain by an impulse that the limit has turned: p goes no further than to where
 *  the kinetic energy is least, s = -p.u/(p.K p) in [0, 1]. Returns what is lost by it. */
static double stop(const struct vti_joint_modes *modes, const double u[3], double p[3])
{
    const double ahead = -vti_dot(p, u), lost = vti_joint_lost(modes, u, p), change = 2.0 * (ahead - lost);
    const double s = ahead <= 0.0 ? 0.0 : ahead < change ? ahead / change : 1.0;
    for (int k = 0; k < 3; ++k)
        p[k] *= s;
    return s < 1.0 ? vti_joint_lost(modes, u, p) : lost;
}

/** What the limits leave of the impulse of two modes, whose direction turns within the flow as they do not decay alike:
 *  by the free impulse p_0 it turns otherwise than by p_1, which the limits have left of it, and taking it from u would
 *  make velocities of first order (test clump_friction). From u + K (p_1 - p_0)/2, by which the velocity amid the flow
 *  is that of p_1, the next one is of second order; where nothing is beyond the limits it is p_0. */
static void limit_two(const struct sweep *s, const struct place *at, int motion, const struct vti_joint_modes *modes,
                      const double c[3], const double u[3], double p[3])
{
    const double free[3] = {p[0], p[1], p[2]};
    double amid[3] = {u[0], u[1], u[2]};
    limit(s, at, motion, p);
    if (p[0] == free[0] && p[1] == free[1] && p[2] == free[2])
        return;
    for (int m = 0; m < modes->count; ++m) {
        double change = 0.0;
        for (int k = 0; k < 3; ++k)
            change += 0.5 * modes->inverse_mass[m] * (p[k] - free[k]) * modes->along[m][k];
        for (int k = 0; k < 3; ++k)
            amid[k] += change * modes->along[m][k];
    }
    vti_joint_decay(modes, c, s->t, amid, p);
    limit(s, at, motion, p);
}

static void flow_of(const struct sweep *s, struct place *at, int motion)
{
    const int turns = motion >= VTI_ROLLING, along = motion == VTI_NORMAL || motion == VTI_TWISTING;
    const double c[3] = {at->c[motion], at->c[motion], 0.0};
    struct vti_joint_modes modes;
    double u[3], p[3];
    vti_joint_modes_of(&at->joint, turns, along ? 1 : 2, (const double(*)[3])at->span + !along, &modes);
    vti_joint_velocity(&at->joint, turns, u);
    vti_joint_decay(&modes, c, s->t, u, p);
    if (along)
        limit(s, at, motion, p);
    else
        limit_two(s, at, motion, &modes, c, u, p);
    const double lost = stop(&modes, u, p);
    vti_sum_add(&s->p->lost[motion], lost);
    if (s->p->by_body != NULL)
        vti_share(s->p->by_body, VTI_DASHPOT_BOOKS, motion, at->touch.i, at->touch.j, lost);
    vti_joint_push(&at->joint, turns, p);
    if (!at->touch.moves)
        return;
    const double worked = -vti_dot(p, turns ? at->touch.w_j : at->touch.v_j); /* the wall puts p.V in */
    vti_sum_add(s->p->walls->work, worked);
    if (s->p->walls->by_body != NULL)
        vti_share(s->p->walls->by_body, 1, 0, at->touch.i, -1, worked);
}

/** Both sides of the touch. Spheres of one body have the same velocity there, and lose nothing. */
static void load(const struct sweep *s, struct place *at)
{
    static const struct vti_joint_side nothing = {.body = -1};
    const struct vti_touch *const touch = &at->touch;
    double place[2][3];
    for (int k = 0; k < 3; ++k) {
        at->span[0][k] = touch->n[k];
        place[0][k] = -touch->s_i * touch->r * touch->n[k];
        place[1][k] = touch->s_j * touch->r * touch->n[k];
    }
    vti_joint_load(&s->of, touch->i, place[0], &at->joint.side[0]);
    at->joint.side[1] = nothing;
    if (touch->j >= 0)
        vti_joint_load(&s->of, touch->j, place[1], &at->joint.side[1]);
    for (int k = 0; k < 3 && touch->moves; ++k) {
        at->joint.side[1].v[k] = touch->v_j[k];
        at->joint.side[1].w[k] = touch->w_j[k];
    }
}

/** A touch within reach: skipped if it is none at both ends of the drift, as in vti_dashpot.c. */
static void visit(const struct sweep *s, struct place *at)
{
    struct vti_joint_modes normal;
    double u[3];
    load(s, at);
    vti_joint_velocity(&at->joint, 0, u);
    const double other = at->touch.delta - s->drift * vti_dot(u, at->touch.n);
    if (at->touch.delta <= 0.0 && other <= 0.0)
        return;
    vti_damping_at(&at->touch, other, &at->damping);
    vti_joint_across(at->touch.n, at->span + 1);
    vti_joint_modes_of(&at->joint, 0, 1, (const double(*)[3])at->span, &normal);
    /* 0 of a body that only turns, and that nothing along the normal turns */
    const double inverse = normal.inverse_mass[0];
    vti_damping_coefficients(s->p, &at->damping, inverse > 0.0 ? 1.0 / inverse : 0.0, at->c);
    at->held = vti_damping_held(s->p, &at->touch);
    for (int k = 0; k < VTI_DASHPOT_BOOKS; ++k) {
        const int motion = s->drift < 0.0 ? VTI_DASHPOT_BOOKS - 1 - k : k;
        if (s->damped[motion])
            flow_of(s, at, motion);
    }
    for (int k = 0; k < 2; ++k)
        vti_joint_store(&s->of, &at->joint.side[k]);
}

static void visit_pairs(const struct sweep *s)
{
    const vti_contacts *const contacts = s->p->contacts;
    struct place at = {.damping = {.zeta = s->p->zeta}};
    for (int64_t k = 0; contacts != NULL && k < contacts->count; ++k)
        if (vti_touch_pair(&at.touch, contacts, s->b, s->drift < 0.0 ? contacts->count - 1 - k : k, s->p->reach))
            visit(s, &at);
}

/** One after the other, forwards or backwards: spheres of one body meet at walls. */
static void visit_walls(const struct sweep *s)
{
    const vti_walls *const walls = s->p->walls;
    const int64_t n = s->b->count, count = vti_faces(walls);
    struct place at;
    for (int64_t k = 0; k < n * count; ++k) {
        const int64_t which = s->drift < 0.0 ? n * count - 1 - k : k, w = which % count;
        if (!vti_touch_wall(&at.touch, walls, s->b, w, s->b->first + which / count, s->p->reach))
            continue;
        at.damping.zeta = s->p->wall_zeta != NULL ? s->p->wall_zeta[w] : s->p->zeta;
        visit(s, &at);
    }
}

void vti_dashpots_flow_joints(const void *self, const vti_clumps *clumps, const vti_bodies *bodies, double t,
                              double drift)
{
    const vti_bodies spheres = clumps != NULL ? vti_clumps_spheres(clumps, bodies) : *bodies;
    struct sweep s = {.p = self, .of = {clumps, bodies}, .b = &spheres, .t = t, .drift = drift};
    vti_damping_all(s.p, s.damped);
    if (drift < 0.0)
        visit_walls(&s);
    visit_pairs(&s);
    if (!(drift < 0.0))
        visit_walls(&s);
}
