/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of contacts and walls as flows of the time t (EQUATIONS 6.3), with u and w of the touch:
 *
 *     normal p = m_n expm1(-c_n t/m_n) (u.n) n            tangential p = m_t expm1(-c_t t/m_t) P u
 *     rolling l = J_r expm1(-c_r t/J_r) P w               twisting l = J_r expm1(-c_w t/J_r) (w.n) n
 *
 * Forward in this order, backward reversed. An impulse that takes the velocity u to u' lowers the kinetic energy by
 * -p.(u + u')/2, which is booked. */
#include "vti_damping.h"
#include "vti_joint.h"

enum { NORMAL = VTI_NORMAL, TANGENTIAL = VTI_TANGENTIAL, ROLLING = VTI_ROLLING, TWISTING = VTI_TWISTING, MOTIONS };

/** What the touch is between here and the other end of the drift. */
struct place {
    struct vti_touch touch;
    struct vti_touch_motion motion;
    double approach; /* u.n, which the flow of no other motion changes */
    double spin;     /* w.n, likewise */
    struct vti_damping damping;
    double mass[MOTIONS]; /* what resists */
    double gone[MOTIONS]; /* the share of the velocity that goes, where nothing limits it */
    const vti_held *held; /* by the springs of friction */
};

/** mass and gone of all motions, in which velocities have no part. */
static void find_decays(const vti_dashpots *p, double t, struct place *at)
{
    const int turns = p->rolling > 0.0 || p->twisting > 0.0;
    struct vti_decay d[MOTIONS];
    at->mass[NORMAL] = vti_touch_normal_mass(&at->touch);
    at->mass[TANGENTIAL] = vti_touch_tangential_mass(&at->touch);
    at->mass[ROLLING] = at->mass[TWISTING] = at->motion.turns ? vti_touch_rolling_inertia(&at->touch) : 1.0;
    double c[MOTIONS], z[MOTIONS];
    vti_damping_coefficients(p, &at->damping, at->mass[NORMAL], c);
    for (int k = 0; k < MOTIONS; ++k)
        z[k] = c[k] * t / at->mass[k];
    if (turns)
        vti_decays(MOTIONS, z, d);
    else
        vti_decays(ROLLING, z, d);
    for (int k = 0; k < (turns ? MOTIONS : ROLLING); ++k)
        at->gone[k] = d[k].gone;
}

/* ---- impulses ---------------------------------------------------------------------------------------------------- */

/** The impulse p at the touch; a wall that moves puts p.V in. */
static void push(const vti_dashpots *dashpots, struct place *at, const double p[3])
{
    vti_touch_push(&at->touch, p, &at->motion);
    if (at->touch.moves)
        vti_sum_add(dashpots->walls->work, -vti_dot(p, at->touch.v_j));
}

/** The moment impulse l; a wall that turns puts l.W in. */
static void turn(const vti_dashpots *dashpots, struct place *at, const double l[3])
{
    vti_touch_turn(&at->touch, l, &at->motion);
    if (at->touch.moves)
        vti_sum_add(dashpots->walls->work, -vti_dot(l, at->touch.w_j));
}

/* ---- the four flows ---------------------------------------------------------------------------------------------- */

/** Pulls no harder than the contact pushes, if it may not: p >= -t F_n. */
static void flow_normal(const vti_dashpots *p, struct place *at, double t)
{
    const struct vti_touch *touch = &at->touch;
    const double m = at->mass[NORMAL], un = at->approach;
    double impulse[3];
    double size = -m * at->gone[NORMAL] * un;
    const double least = vti_damping_force(&at->damping, -t);
    if (!p->pull && size < least)
        size = least;
    for (int k = 0; k < 3; ++k)
        impulse[k] = size * touch->n[k];
    push(p, at, impulse);
    vti_sum_add(&p->lost[NORMAL], -size * (un + 0.5 * size / m));
}

/** a - (a.n) n */
static void across(double a[3], const double n[3])
{
    const double along = vti_dot(a, n);
    for (int k = 0; k < 3; ++k)
        a[k] -= along * n[k];
}

/** Of the velocity a of a motion: becomes the impulse. Returns what is lost by it. */
static double decay(const vti_dashpots *p, const struct place *at, int motion, double t, const double f[3], double a[3])
{
    const double mass = at->mass[motion], gone = at->gone[motion];
    const double share = vti_damping_share_of_force(p, &at->touch, motion);
    if (!(share > 0.0))
        return vti_touch_decay(mass, gone, a);
    const double whole[3] = {-mass * gone * a[0], -mass * gone * a[1], -mass * gone * a[2]};
    return vti_touch_decay(mass, gone * vti_damping_limited(whole, f, t, vti_damping_force(&at->damping, share)), a);
}

static void flow_tangential(const vti_dashpots *p, struct place *at, double t)
{
    double u[3];
    vti_touch_slip(&at->touch, &at->motion, u);
    across(u, at->touch.n);
    vti_sum_add(&p->lost[TANGENTIAL], decay(p, at, TANGENTIAL, t, at->held->sliding, u));
    push(p, at, u);
}

static void flow_rolling(const vti_dashpots *p, struct place *at, double t)
{
    double w[3];
    vti_touch_roll(&at->motion, w);
    across(w, at->touch.n);
    vti_sum_add(&p->lost[ROLLING], decay(p, at, ROLLING, t, at->held->rolling, w));
    turn(p, at, w);
}

static void flow_twisting(const vti_dashpots *p, struct place *at, double t)
{
    double w[3], load[3];
    for (int k = 0; k < 3; ++k) {
        w[k] = at->spin * at->touch.n[k];
        load[k] = at->held->twisting * at->touch.n[k];
    }
    vti_sum_add(&p->lost[TWISTING], decay(p, at, TWISTING, t, load, w));
    turn(p, at, w);
}

static void flow_of(int motion, const vti_dashpots *p, struct place *at, double t)
{
    if (motion == NORMAL)
        flow_normal(p, at, t);
    else if (motion == TANGENTIAL)
        flow_tangential(p, at, t);
    else if (motion == ROLLING)
        flow_rolling(p, at, t);
    else
        flow_twisting(p, at, t);
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

/** What each touch takes part in. */
struct sweep {
    const vti_dashpots *p;
    const vti_bodies *b;
    double t, drift;
    int damped[MOTIONS];
};

/** A touch within reach: skipped if it is none at both ends of the drift. The other end is at delta - drift u.n, ahead
 *  of a drift that follows (drift > 0), behind one that has been. */
static void visit(const struct sweep *s, struct place *at)
{
    struct vti_touch *touch = &at->touch;
    double u[3], w[3];
    vti_touch_load(touch, s->b, &at->motion);
    vti_touch_slip(touch, &at->motion, u);
    at->approach = vti_dot(u, touch->n);
    const double other = touch->delta - s->drift * at->approach;
    if (touch->delta <= 0.0 && other <= 0.0)
        return;
    vti_touch_roll(&at->motion, w);
    at->spin = vti_dot(w, touch->n);
    vti_touch_masses(touch, s->b);
    vti_damping_at(touch, other, &at->damping);
    at->held = vti_damping_held(s->p, touch);
    find_decays(s->p, s->t, at);
    for (int k = 0; k < MOTIONS; ++k) {
        const int motion = s->drift < 0.0 ? MOTIONS - 1 - k : k;
        if (s->damped[motion])
            flow_of(motion, s->p, at, s->t);
    }
    vti_touch_store(touch, s->b, &at->motion);
}

static void visit_pairs(const struct sweep *s)
{
    const vti_contacts *contacts = s->p->contacts;
    struct place at = {.damping = {.zeta = s->p->zeta}};
    for (int64_t k = 0; contacts != NULL && k < contacts->count; ++k)
        if (vti_touch_pair(&at.touch, contacts, s->b, s->drift < 0.0 ? contacts->count - 1 - k : k, s->p->reach))
            visit(s, &at);
}

/** Bodies one after the other, each with the walls in their order: flows of different bodies at walls do not meet. */
static void visit_walls(const struct sweep *s)
{
    const vti_walls *walls = s->p->walls;
    const int64_t first = s->b->first, n = s->b->count, count = vti_faces(walls);
    struct place at;
    for (int64_t i = first; count > 0 && i < first + n; ++i)
        for (int64_t k = 0; k < count; ++k) {
            at.touch.wall = s->drift < 0.0 ? count - 1 - k : k;
            if (!vti_touch_wall(&at.touch, walls, s->b, at.touch.wall, i, s->p->reach))
                continue;
            at.damping.zeta = s->p->wall_zeta != NULL ? s->p->wall_zeta[at.touch.wall] : s->p->zeta;
            visit(s, &at);
        }
}

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_dashpots *p = self;
    struct sweep s = {.p = p, .b = b, .t = t, .drift = drift};
    if (vti_has(&b->moments)) {
        vti_dashpots_flow_joints(p, NULL, b, t, drift);
        return;
    }
    vti_damping_all(p, s.damped);
    if (drift < 0.0)
        visit_walls(&s);
    visit_pairs(&s);
    if (!(drift < 0.0))
        visit_walls(&s);
}

/* ---- restitution ------------------------------------------------------------------------------------------------- */

/** atan(sqrt(s))/sqrt(s), atanh(sqrt(-s))/sqrt(-s) of s > -1: halved by atan x = 2 atan(x/(1 + sqrt(1 + x^2))) until
 *  the series 1 - s/3 + s^2/5 - ... ends at s^8 < 2^-60. */
static double arc(double s)
{
    double factor = 1.0, sum = 0.0;
    while (fabs(s) > 1.0 / 256.0) {
        const double half = 1.0 + sqrt(1.0 + s);
        factor *= 2.0 / half;
        s /= half * half;
    }
    for (int n = 8; n >= 0; --n)
        sum = 1.0 / (2 * n + 1) - s * sum;
    return factor * sum;
}

/** e of zeta: with arccos(zeta)/sqrt(1 - zeta^2) = (2/(1 + zeta)) atan(sqrt(s))/sqrt(s), s = (1 - zeta)/(1 + zeta) */
static double restitution(double zeta, int64_t pull)
{
    const double pi = 3.14159265358979323846;
    if (pull)
        return vti_decay(pi * zeta / sqrt((1.0 - zeta) * (1.0 + zeta))).kept;
    return vti_decay(4.0 * zeta / (1.0 + zeta) * arc((1.0 - zeta) / (1.0 + zeta))).kept;
}

double vti_dashpots_zeta(double e, int64_t pull)
{
    double low = 0.0, high = 1.0;
    if (!(e > 0.0 && e <= 1.0))
        return NAN;
    while (!pull && high < 1e12 && restitution(high, pull) > e)
        high *= 2.0;
    for (int k = 0; k < 100; ++k) { /* halved until no number is left between them */
        const double middle = 0.5 * (low + high);
        if (restitution(middle, pull) > e)
            low = middle;
        else
            high = middle;
    }
    return e < 1.0 ? high : 0.0;
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static int check(const void *self, const vti_bodies *b)
{
    const vti_dashpots *p = self;
    const double all[] = {p->zeta, p->normal, p->tangential, p->ratio, p->rolling, p->twisting};
    int good = p->reach >= 0.0;
    for (int k = 0; k < 6; ++k)
        good &= isfinite(all[k]) && all[k] >= 0.0;
    for (int64_t w = 0; p->wall_zeta != NULL && w < vti_faces(p->walls); ++w)
        good &= isfinite(p->wall_zeta[w]) && p->wall_zeta[w] >= 0.0;
    if (!good)
        return VTI_E_DAMPING;
    if (p->contacts != NULL &&
        (p->contacts->diameter.p == NULL || (p->contacts->count > 0 && p->contacts->pair == NULL)))
        return VTI_E_NULL;
    return vti_has(&b->omega) && !vti_has(&b->moments) && b->inertia.p == NULL ? VTI_E_INERTIA : VTI_OK;
}

vti_effect vti_dashpots_effect(const vti_dashpots *dashpots)
{
    static const char *const book[VTI_DASHPOT_BOOKS] = {"lost_dashpot_normal", "lost_dashpot_tangential",
                                                        "lost_dashpot_rolling", "lost_dashpot_twisting"};
    const vti_dashpots *p = dashpots;
    if (p == NULL || p->lost == NULL || (p->contacts == NULL && p->walls == NULL))
        return vti_effect_none();
    const int turns = p->rolling > 0.0 || p->twisting > 0.0, slides = p->tangential > 0.0 || p->ratio > 0.0;
    int64_t breaks = turns || slides ? 0700 : 0;
    if (p->walls != NULL)
        breaks |= turns || slides ? 0777 : vti_walls_effect(p->walls).breaks;
    const vti_effect effect = {.name = "dashpot",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = vti_dashpots_flow_joints,
                               .self = p,
                               .needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS |
                                        (turns ? 1 << VTI_QUANTITY_OMEGA : 0),
                               .breaks = breaks,
                               .dissipates = 1,
                               .books = p->twisting > 0.0  ? 4
                                        : p->rolling > 0.0 ? 3
                                        : slides           ? 2
                                                           : 1,
                               .book = book,
                               .booked = p->lost};
    return effect;
}
