/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The flows of a touch's dashpots for the time t (EQUATIONS 6.3), with u and w of the touch:
 *
 *     normal p = m_n expm1(-c_n t/m_n) (u.n) n            tangential p = m_t expm1(-c_t t/m_t) P u
 *     rolling l = J_r expm1(-c_r t/J_r) P w               twisting l = J_r expm1(-c_w t/J_r) (w.n) n
 *
 * Forward in this order, backward reversed. An impulse that takes the velocity u to u' lowers the kinetic energy by
 * -p.(u + u')/2, which is booked. For lanes of touches, or for one, as in vti_touch_motion.h. */
#ifndef VTI_DASHPOT_FLOW_H
#define VTI_DASHPOT_FLOW_H

#include <float.h>

#include "vti_damping.h"

enum { NORMAL = VTI_NORMAL, TANGENTIAL = VTI_TANGENTIAL, ROLLING = VTI_ROLLING, TWISTING = VTI_TWISTING, MOTIONS };

/** What touches take part in. */
struct vti_sweep {
    const vti_dashpots *p;
    const vti_bodies *b;
    double t, drift;
    int damped[MOTIONS];
    const int64_t *guess; /* [VTI_GUESSES] where what pair k holds may stand, at k % VTI_GUESSES; NULL: not known */
};

enum { VTI_GUESSES = 1024 };

/** What the touch is between here and the other end of the drift. */
struct place {
    struct vti_touch touch;
    struct vti_touch_motion motion;
    lanes_mask out; /* what is no touch whatever its overlap, as there is no direction or it is out of reach */
    lanes approach; /* u.n, which the flow of no other motion changes */
    lanes spin;     /* w.n, likewise */
    struct vti_damping damping;
    lanes per[MOTIONS];    /* 1/m_n, 1/m_t, 1/J_r, 1/J_r */
    lanes mass[MOTIONS];   /* m_n, m_t, J_r, J_r */
    lanes gone[MOTIONS];   /* the share of the velocity that goes, where nothing limits it */
    struct vti_loads held; /* by the springs of friction */
    lanes lost[MOTIONS];   /* of energy */
    lanes worked;          /* what a wall that moves has taken */
};

/** mass and gone of all motions, in which velocities have no part; idle lanes keep their velocities. */
VTI_INLINE void find_decays(const struct vti_sweep *s, lanes_mask idle, struct place *at)
{
    const int turns = s->damped[ROLLING] || s->damped[TWISTING], motions = turns ? MOTIONS : ROLLING;
    struct vti_decay d[MOTIONS];
    lanes c[MOTIONS], z[MOTIONS];
    const lanes per_n = vti_touch_per_normal(&at->touch), per_t = vti_touch_per_tangential(&at->touch),
                per_r = turns ? vti_touch_per_rolling(&at->touch) : lanes_of(1.0);
    const lanes all = 1.0 / (per_n * per_t * per_r); /* one division for three, unless their product is out of range */
    const lanes_mask in_range = (all > 0.0) & (all <= DBL_MAX);
    at->per[NORMAL] = per_n;
    at->per[TANGENTIAL] = per_t;
    at->per[ROLLING] = at->per[TWISTING] = per_r;
    at->mass[NORMAL] = per_t * per_r * all;
    at->mass[TANGENTIAL] = per_n * per_r * all;
    at->mass[ROLLING] = at->mass[TWISTING] = per_n * per_t * all;
    for (int k = 0; k < MOTIONS && !lanes_all(in_range); ++k)
        at->mass[k] = lanes_where(in_range, at->mass[k], 1.0 / at->per[k]);
    vti_damping_coefficients(s->p, &at->damping, at->mass[NORMAL], c);
    for (int k = 0; k < motions; ++k)
        z[k] = c[k] * s->t * at->per[k];
    if (turns)
        vti_decays(MOTIONS, z, d);
    else
        vti_decays(ROLLING, z, d);
    for (int k = 0; k < motions; ++k)
        at->gone[k] = lanes_where(idle, lanes_of(0.0), d[k].gone);
}

/* ---- impulses ---------------------------------------------------------------------------------------------------- */

/** The impulse p at the touch; a wall that moves puts p.V in. */
VTI_INLINE void push(struct place *at, const lanes p[3])
{
    vti_touch_push(&at->touch, p, &at->motion);
    if (at->touch.moves)
        at->worked -= lanes_dot(p, at->touch.v_j);
}

/** The moment impulse l; a wall that turns puts l.W in. */
VTI_INLINE void turn(struct place *at, const lanes l[3])
{
    vti_touch_turn(&at->touch, l, &at->motion);
    if (at->touch.moves)
        at->worked -= lanes_dot(l, at->touch.w_j);
}

/* ---- the four flows ---------------------------------------------------------------------------------------------- */

/** Pulls no harder than the contact pushes, if it may not: p >= -t F_n. */
VTI_INLINE void flow_normal(const vti_dashpots *p, struct place *at, double t)
{
    const lanes m = at->mass[NORMAL], un = at->approach, least = vti_damping_force(&at->damping, -t);
    lanes size = -m * at->gone[NORMAL] * un;
    if (!p->pull)
        size = lanes_where(size < least, least, size);
    vti_touch_press(&at->touch, size, &at->motion);
    if (at->touch.moves)
        at->worked -= size * lanes_dot(at->touch.n, at->touch.v_j);
    at->lost[NORMAL] = -size * (un + 0.5 * size * at->per[NORMAL]);
}

/** Of the velocity a of a motion: becomes the impulse. Returns what is lost by it. */
VTI_INLINE lanes decay(const vti_dashpots *p, const struct place *at, int motion, double t, const lanes f[3],
                       lanes a[3])
{
    const lanes mass = at->mass[motion], gone = at->gone[motion];
    const double share = vti_damping_share_of_force(p, &at->touch, motion);
    if (share < 0.0)
        return vti_touch_decay(mass, gone, a);
    lanes impulse[3] = {-mass * gone * a[0], -mass * gone * a[1], -mass * gone * a[2]};
    vti_damping_limit(impulse, f, t, vti_damping_force(&at->damping, share));
    const lanes lost = -lanes_dot(impulse, a) - 0.5 * at->per[motion] * lanes_dot(impulse, impulse);
    for (int k = 0; k < 3; ++k)
        a[k] = impulse[k];
    return lost;
}

VTI_INLINE void flow_tangential(const vti_dashpots *p, struct place *at, double t)
{
    lanes u[3];
    vti_touch_slip(&at->touch, &at->motion, u);
    vti_touch_across(at->touch.n, u);
    at->lost[TANGENTIAL] = decay(p, at, TANGENTIAL, t, at->held.sliding, u);
    push(at, u);
}

VTI_INLINE void flow_rolling(const vti_dashpots *p, struct place *at, double t)
{
    lanes w[3];
    vti_touch_roll(&at->motion, w);
    vti_touch_across(at->touch.n, w);
    at->lost[ROLLING] = decay(p, at, ROLLING, t, at->held.rolling, w);
    turn(at, w);
}

VTI_INLINE void flow_twisting(const vti_dashpots *p, struct place *at, double t)
{
    lanes w[3], load[3];
    for (int k = 0; k < 3; ++k) {
        w[k] = at->spin * at->touch.n[k];
        load[k] = at->held.twisting * at->touch.n[k];
    }
    at->lost[TWISTING] = decay(p, at, TWISTING, t, load, w);
    turn(at, w);
}

VTI_INLINE void flow_of(int motion, const struct vti_sweep *s, struct place *at)
{
    if (!s->damped[motion])
        return;
    if (motion == NORMAL)
        flow_normal(s->p, at, s->t);
    else if (motion == TANGENTIAL)
        flow_tangential(s->p, at, s->t);
    else if (motion == ROLLING)
        flow_rolling(s->p, at, s->t);
    else
        flow_twisting(s->p, at, s->t);
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

/** A touch, which has its motion. The other end of the drift is at delta - drift u.n, ahead of a drift
 *  that follows (drift > 0), behind one that has been. Returns 0, and nothing has changed, if it is no touch at both
 *  ends. */
VTI_INLINE int flow_touch(const struct vti_sweep *s, struct place *at)
{
    const struct vti_touch *const touch = &at->touch;
    const lanes zero = lanes_of(0.0);
    lanes u[3], w[3];
    for (int k = 0; k < 3; ++k)
        u[k] = at->motion.v_i[k] - at->motion.v_j[k]; /* what turns slips across the normal */
    at->approach = lanes_dot(u, touch->n);
    const lanes other = touch->delta - s->drift * at->approach;
    const lanes_mask idle = at->out | ((touch->delta <= 0.0) & (other <= 0.0));
    if (lanes_all(idle))
        return 0;
    at->spin = at->worked = zero;
    if (s->damped[TWISTING]) {
        vti_touch_roll(&at->motion, w);
        at->spin = lanes_dot(w, touch->n);
    }
    for (int k = 0; k < MOTIONS; ++k)
        at->lost[k] = zero;
    vti_damping_at(touch, other, &at->damping);
    find_decays(s, idle, at);
    if (s->drift < 0.0) {
        flow_of(TWISTING, s, at);
        flow_of(ROLLING, s, at);
        flow_of(TANGENTIAL, s, at);
    }
    flow_of(NORMAL, s, at);
    if (!(s->drift < 0.0)) {
        flow_of(TANGENTIAL, s, at);
        flow_of(ROLLING, s, at);
        flow_of(TWISTING, s, at);
    }
    return 1;
}

#endif
