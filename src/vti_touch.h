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
 *     Omega_i += l/J_i,  Omega_j -= l/J_j.                                                                           */
#ifndef VTI_TOUCH_H
#define VTI_TOUCH_H

#include "vti_face.h"
#include "vti_hertz.h"

struct vti_touch {
    int64_t i, j; /* j < 0: a wall */
    int64_t wall; /* which of them */
    int moves;    /* 1: the wall does, at the foot point with v_j and w_j */
    double v_j[3], w_j[3];
    double n[3], r, s_i, s_j;
    double delta;     /* overlap as a length; negative is a gap */
    double length;    /* L, on which the overlap is a share: of a pair its own, of a wall D_i/2 */
    double stiffness; /* K */
    double per_m_i, per_m_j, per_j_i, per_j_j; /* 1/m and 1/J; 0 for a wall, and 1/J where nothing turns */
};

/** What bodies of a touch have: 1/m and, where bodies turn, 1/J. */
static inline void vti_touch_masses(struct vti_touch *at, const vti_bodies *b)
{
    const int turns = vti_has(&b->omega);
    at->per_m_i = 1.0 / vti_scalar(&b->mass, at->i);
    at->per_m_j = at->j >= 0 ? 1.0 / vti_scalar(&b->mass, at->j) : 0.0;
    at->per_j_i = turns ? 1.0 / vti_scalar(&b->inertia, at->i) : 0.0;
    at->per_j_j = turns && at->j >= 0 ? 1.0 / vti_scalar(&b->inertia, at->j) : 0.0;
}

/** Of pair k of the list. Returns 1, or 0 where centres coincide, so that there is no direction, or the gap is above
 *  reach. */
static inline int vti_touch_pair(struct vti_touch *at, const vti_contacts *p, const vti_bodies *b, int64_t k,
                                 double reach)
{
    double d[3], xj[3];
    at->moves = 0;
    at->i = p->pair[2 * k] - p->base;
    at->j = p->pair[2 * k + 1] - p->base;
    vti_load(&b->x, at->i, d);
    vti_load(&b->x, at->j, xj);
    for (int c = 0; c < 3; ++c)
        d[c] -= xj[c];
    const double di = vti_scalar(&p->diameter, at->i), dj = vti_scalar(&p->diameter, at->j);
    at->length = vti_contact_length(p, k, at->i, at->j);
    const double far = at->length + reach, r2 = vti_dot(d, d);
    if (!(r2 <= far * far))
        return 0;
    at->r = sqrt(r2);
    if (!(at->r > VTI_COINCIDENT))
        return 0;
    for (int c = 0; c < 3; ++c)
        at->n[c] = d[c] / at->r;
    at->delta = at->length - at->r;
    at->stiffness = vti_contact_stiffness(p, at->i, at->j, at->length);
    at->s_i = di / (di + dj);
    at->s_j = 1.0 - at->s_i;
    return 1;
}

/** mu of wall w. */
static inline double vti_friction_of_wall(const vti_friction *p, int64_t w)
{
    return p->wall_sliding != NULL ? p->wall_sliding[w] : p->sliding;
}

/** Of body i and wall w, where they are now. Returns 1, or 0 where the gap is above reach, or there is no direction. */
static inline int vti_touch_wall(struct vti_touch *at, const vti_walls *p, const vti_bodies *b, int64_t w, int64_t i,
                                 double reach)
{
    double x[3];
    vti_load(&b->x, i, x);
    at->i = i;
    at->j = -1;
    at->wall = w;
    at->length = 0.5 * vti_scalar(&p->diameter, i);
    at->r = vti_face_gap(p, w, x, at->n);
    at->delta = at->length - at->r;
    if (!(at->delta >= -reach) || (w >= p->count && !(vti_dot(at->n, at->n) > 0.0)))
        return 0;
    at->stiffness = vti_face_stiffness(p, w, i, at->length);
    at->s_i = 1.0;
    at->s_j = 0.0;
    at->moves = p->motion != NULL;
    for (int c = 0; c < 3 && at->moves; ++c)
        x[c] -= at->r * at->n[c];
    if (at->moves)
        vti_face_velocity(p, w, x, at->v_j, at->w_j);
    return 1;
}

/** Velocities of both sides, which flows change; of a wall they are its own and stay. */
struct vti_touch_motion {
    int turns; /* whether bodies do; w_i and w_j are 0 else */
    double v_i[3], v_j[3], w_i[3], w_j[3];
};

static inline void vti_touch_load(const struct vti_touch *at, const vti_bodies *b, struct vti_touch_motion *m)
{
    static const struct vti_touch_motion still;
    *m = still;
    m->turns = vti_has(&b->omega);
    vti_load(&b->v, at->i, m->v_i);
    if (at->j >= 0)
        vti_load(&b->v, at->j, m->v_j);
    for (int c = 0; c < 3 && at->moves; ++c) {
        m->v_j[c] = at->v_j[c];
        m->w_j[c] = at->w_j[c];
    }
    if (m->turns)
        vti_load(&b->omega, at->i, m->w_i);
    if (m->turns && at->j >= 0)
        vti_load(&b->omega, at->j, m->w_j);
}

static inline void vti_touch_store(const struct vti_touch *at, const vti_bodies *b, const struct vti_touch_motion *m)
{
    vti_store(&b->v, at->i, m->v_i);
    if (at->j >= 0)
        vti_store(&b->v, at->j, m->v_j);
    if (m->turns)
        vti_store(&b->omega, at->i, m->w_i);
    if (m->turns && at->j >= 0)
        vti_store(&b->omega, at->j, m->w_j);
}

/** u */
static inline void vti_touch_slip(const struct vti_touch *at, const struct vti_touch_motion *m, double u[3])
{
    double spin[3], across[3];
    for (int c = 0; c < 3; ++c)
        spin[c] = (at->s_i * m->w_i[c] + at->s_j * m->w_j[c]) * at->r;
    vti_cross(spin, at->n, across);
    for (int c = 0; c < 3; ++c)
        u[c] = m->v_i[c] - m->v_j[c] - across[c];
}

/** w */
static inline void vti_touch_roll(const struct vti_touch_motion *m, double w[3])
{
    for (int c = 0; c < 3; ++c)
        w[c] = m->w_i[c] - m->w_j[c];
}

/** a += factor b */
static inline void vti_touch_change(double a[3], double factor, const double b[3])
{
    for (int c = 0; c < 3; ++c)
        a[c] += factor * b[c];
}

/** The impulse p at the contact point, on body i. */
static inline void vti_touch_push(const struct vti_touch *at, const double p[3], struct vti_touch_motion *m)
{
    double arm[3];
    vti_touch_change(m->v_i, at->per_m_i, p);
    if (at->j >= 0)
        vti_touch_change(m->v_j, -at->per_m_j, p);
    if (!m->turns)
        return;
    vti_cross(at->n, p, arm);
    vti_touch_change(m->w_i, -at->s_i * at->r * at->per_j_i, arm);
    if (at->j >= 0)
        vti_touch_change(m->w_j, -at->s_j * at->r * at->per_j_j, arm);
}

/** The moment impulse l, on body i. */
static inline void vti_touch_turn(const struct vti_touch *at, const double l[3], struct vti_touch_motion *m)
{
    vti_touch_change(m->w_i, at->per_j_i, l);
    if (at->j >= 0)
        vti_touch_change(m->w_j, -at->per_j_j, l);
}

/** Of a velocity a against which mass resists and of which the share gone goes: becomes the impulse. Returns the
 *  kinetic energy that it takes, -p.(a + a')/2. */
static inline double vti_touch_decay(double mass, double gone, double a[3])
{
    const double lost = mass * gone * (1.0 - 0.5 * gone) * vti_dot(a, a);
    for (int c = 0; c < 3; ++c)
        a[c] *= -mass * gone;
    return lost;
}

/** a = (a.n) n + P a: leaves P a there, and (a.n) n in along. */
static inline void vti_touch_split(const struct vti_touch *at, double a[3], double along[3])
{
    const double an = vti_dot(a, at->n);
    for (int c = 0; c < 3; ++c) {
        along[c] = an * at->n[c];
        a[c] -= along[c];
    }
}

static inline double vti_touch_normal_mass(const struct vti_touch *at)
{
    return 1.0 / (at->per_m_i + at->per_m_j);
}

static inline double vti_touch_tangential_mass(const struct vti_touch *at)
{
    const double turning = at->s_i * at->s_i * at->per_j_i + at->s_j * at->s_j * at->per_j_j;
    return 1.0 / (at->per_m_i + at->per_m_j + at->r * at->r * turning);
}

static inline double vti_touch_rolling_inertia(const struct vti_touch *at)
{
    return 1.0 / (at->per_j_i + at->per_j_j);
}

#endif
