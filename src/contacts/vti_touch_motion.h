/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Two bodies, or a body and a wall, where they touch: the kinematics that dashpots and friction share (EQUATIONS 6.2).
 * With d = x_i - x_j (of a wall the foot point to the centre), r = |d|, n = d/r and shares s_i + s_j = 1,
 *
 *     u = v_i - v_j - (s_i Omega_i + s_j Omega_j) x d,      w = Omega_i - Omega_j,
 *     1/m_n = 1/m_i + 1/m_j,     1/m_t = 1/m_n + r^2 (s_i^2/J_i + s_j^2/J_j),     1/J_r = 1/J_i + 1/J_j,
 *
 * both 0 in every rigid motion. Impulses p at the contact point and l about it keep linear and total angular momentum:
 *
 *     v_i += p/m_i,  v_j -= p/m_j,  Omega_i -= s_i (d x p)/J_i,  Omega_j -= s_j (d x p)/J_j,
 *     Omega_i += l/J_i,  Omega_j -= l/J_j.
 *
 * For lanes of touches, each of which shares no body with another; for one touch, outside of the kernels, where
 * lanes are a number. */
#ifndef VTI_TOUCH_MOTION_H
#define VTI_TOUCH_MOTION_H

#ifndef TOUCH_KERNELS
#define VTI_WIDTH 1
#endif
#include "../lanes/vti_lanes.h"

struct vti_touch {
    int64_t i, j; /* of one touch its bodies, j < 0: a wall; of lanes only the sign of j, which all share */
    int64_t wall; /* which of them */
    int moves;    /* 1: the wall does, at the foot point with v_j and w_j */
    lanes v_j[3], w_j[3];
    lanes n[3], r, s_i, s_j;
    lanes delta;     /* overlap as a length; negative is a gap */
    lanes length;    /* L, on which the overlap is a share: of a pair its own, of a wall D_i/2 */
    lanes stiffness; /* K */
    lanes per_m_i, per_m_j, per_j_i, per_j_j; /* 1/m and 1/J; 0 for a wall, and 1/J where nothing turns */
};

/** Of two bodies d apart, and from which distance on they touch, the length; s_i = D_i/(D_i + D_j) says where between
 *  them. */
VTI_INLINE void vti_touch_between(struct vti_touch *at, const lanes d[3], lanes s_i)
{
    at->r = lanes_sqrt(lanes_dot(d, d));
    const lanes per_r = 1.0 / at->r;
    for (int c = 0; c < 3; ++c)
        at->n[c] = d[c] * per_r;
    at->delta = at->length - at->r;
    at->s_i = s_i;
    at->s_j = 1.0 - s_i;
}

/** Velocities of both sides, which flows change; of a wall they are its own and stay. */
struct vti_touch_motion {
    int turns; /* whether bodies do; w_i and w_j are 0 else */
    lanes v_i[3], v_j[3], w_i[3], w_j[3];
};

/** What the springs of friction hold there: vti_held for lanes. */
struct vti_loads {
    lanes sliding[3], rolling[3], twisting;
};

/** mu of wall w. */
static inline double vti_friction_of_wall(const vti_friction *p, int64_t w)
{
    return p->wall_sliding != NULL ? p->wall_sliding[w] : p->sliding;
}

/** u */
VTI_INLINE void vti_touch_slip(const struct vti_touch *at, const struct vti_touch_motion *m, lanes u[3])
{
    lanes spin[3], across[3];
    for (int c = 0; c < 3; ++c)
        spin[c] = (at->s_i * m->w_i[c] + at->s_j * m->w_j[c]) * at->r;
    lanes_cross(spin, at->n, across);
    for (int c = 0; c < 3; ++c)
        u[c] = m->v_i[c] - m->v_j[c] - across[c];
}

/** w */
VTI_INLINE void vti_touch_roll(const struct vti_touch_motion *m, lanes w[3])
{
    for (int c = 0; c < 3; ++c)
        w[c] = m->w_i[c] - m->w_j[c];
}

/** a += factor b */
VTI_INLINE void vti_touch_change(lanes a[3], lanes factor, const lanes b[3])
{
    for (int c = 0; c < 3; ++c)
        a[c] += factor * b[c];
}

/** The impulse p n on body i, which turns nothing. */
VTI_INLINE void vti_touch_press(const struct vti_touch *at, lanes p, struct vti_touch_motion *m)
{
    vti_touch_change(m->v_i, at->per_m_i * p, at->n);
    if (at->j >= 0)
        vti_touch_change(m->v_j, -at->per_m_j * p, at->n);
}

/** The impulse p at the contact point, on body i. */
VTI_INLINE void vti_touch_push(const struct vti_touch *at, const lanes p[3], struct vti_touch_motion *m)
{
    lanes arm[3];
    vti_touch_change(m->v_i, at->per_m_i, p);
    if (at->j >= 0)
        vti_touch_change(m->v_j, -at->per_m_j, p);
    if (!m->turns)
        return;
    lanes_cross(at->n, p, arm);
    vti_touch_change(m->w_i, -at->s_i * at->r * at->per_j_i, arm);
    if (at->j >= 0)
        vti_touch_change(m->w_j, -at->s_j * at->r * at->per_j_j, arm);
}

/** The moment impulse l, on body i. */
VTI_INLINE void vti_touch_turn(const struct vti_touch *at, const lanes l[3], struct vti_touch_motion *m)
{
    vti_touch_change(m->w_i, at->per_j_i, l);
    if (at->j >= 0)
        vti_touch_change(m->w_j, -at->per_j_j, l);
}

/** Of a velocity a against which mass resists and of which the share gone goes: becomes the impulse. Returns the
 *  kinetic energy that it takes, -p.(a + a')/2. */
VTI_INLINE lanes vti_touch_decay(lanes mass, lanes gone, lanes a[3])
{
    const lanes lost = mass * gone * (1.0 - 0.5 * gone) * lanes_dot(a, a);
    for (int c = 0; c < 3; ++c)
        a[c] *= -mass * gone;
    return lost;
}

/** a = (a.n) n + P a: leaves P a there, and (a.n) n in along. */
VTI_INLINE void vti_touch_split(const lanes n[3], lanes a[3], lanes along[3])
{
    const lanes an = lanes_dot(a, n);
    for (int c = 0; c < 3; ++c) {
        along[c] = an * n[c];
        a[c] -= along[c];
    }
}

/** P a alone. */
VTI_INLINE void vti_touch_across(const lanes n[3], lanes a[3])
{
    lanes along[3];
    vti_touch_split(n, a, along);
}

/** 1/m_n */
VTI_INLINE lanes vti_touch_per_normal(const struct vti_touch *at)
{
    return at->per_m_i + at->per_m_j;
}

/** 1/m_t */
VTI_INLINE lanes vti_touch_per_tangential(const struct vti_touch *at)
{
    const lanes turning = at->s_i * at->s_i * at->per_j_i + at->s_j * at->s_j * at->per_j_j;
    return at->per_m_i + at->per_m_j + at->r * at->r * turning;
}

/** 1/J_r */
VTI_INLINE lanes vti_touch_per_rolling(const struct vti_touch *at)
{
    return at->per_j_i + at->per_j_j;
}

#endif
