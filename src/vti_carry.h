/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How the springs of a touch follow a drift (EQUATIONS 6.5, carry): through the turn of the normal (swing) and of both
 * bodies about it (twirl), stretched by how far surfaces have moved over each other, and returned to the limit along
 * the mean of the old and the new direction, which is of second order. */
#ifndef VTI_CARRY_H
#define VTI_CARRY_H

#include "vti_history.h"
#include "vti_touch.h"

/** Of the drift that has been done; touch is where it ends. */
struct vti_carry {
    struct vti_touch touch;
    double n0[3], n_m[3]; /* normals at its start and in the middle */
    int turns_over;       /* n0 = -n1: there is no middle */
    double delta0;        /* overlap at its start */
    double tau;           /* of the twirl: tan of a quarter of both turns about n_m together */
    double slid[3];       /* X of sliding, across n_m */
    double rolled[3];     /* X of rolling, across n_m */
    double twisted;       /* x of twisting */
    double dragged[3];    /* where walls move: by how much the wall's surface has, */
    double turned[3];     /* and turned */
};

static inline void vti_carry_across(double a[3], const double n[3])
{
    const double along = vti_dot(a, n);
    for (int k = 0; k < 3; ++k)
        a[k] -= along * n[k];
}

/** Increments of attitude over the drift: the law's own; at a plane h Omega, so that rolling on it is exact. */
static inline void vti_carry_turns(const struct vti_touch *at, const vti_walls *walls, const vti_bodies *b,
                                   const vti_drifted *drifted, double ai[3], double aj[3])
{
    const double still[3] = {0.0, 0.0, 0.0};
    const int at_plane = at->j < 0 && at->wall < walls->count;
    double wi[3], wj[3];
    vti_load(&b->omega, at->i, wi);
    if (at->j >= 0)
        vti_load(&b->omega, at->j, wj);
    for (int k = 0; k < 3; ++k) {
        if (at->j < 0)
            wj[k] = at->moves ? at->w_j[k] : still[k];
        ai[k] = drifted->t * wi[k];
        aj[k] = drifted->t * wj[k];
    }
    if (at_plane)
        return;
    vti_drift_increment((int)drifted->law, drifted->t, wi, ai);
    vti_drift_increment((int)drifted->law, drifted->t, wj, aj);
}

/** The place that body i had before the drift, from a point of the axis of the wall there, and its place now. */
static inline void vti_carry_from_axis(const struct vti_carry *c, const vti_walls *walls, const vti_bodies *b,
                                       double before[3], double now[3])
{
    double x[3];
    vti_load(&b->x, c->touch.i, x);
    vti_face_from_axis(walls, c->touch.wall, x, now);
    for (int k = 0; k < 3; ++k)
        before[k] = now[k] - c->slid[k];
}

/** Takes the way of a turning wall's surface off the motion: A x (foot0 + foot1)/2, A the wall's increment. */
static inline void vti_carry_drag(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b, double h,
                                  const double aj[3], const double d0[3])
{
    const struct vti_touch *const at = &c->touch;
    double before[3], now[3], foot[3], way[3];
    vti_carry_from_axis(c, walls, b, before, now);
    for (int k = 0; k < 3; ++k)
        foot[k] = 0.5 * (before[k] - d0[k] + now[k] - at->r * at->n[k]);
    vti_cross(aj, foot, way);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] -= way[k];
        c->dragged[k] = h * walls->motion[at->wall].velocity[k] + way[k];
        c->turned[k] = aj[k];
    }
}

/** d at the start of the drift, and with it n0 and delta0. */
static inline void vti_carry_start(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b, double d0[3])
{
    const struct vti_touch *const at = &c->touch;
    if (at->j < 0 && at->wall >= walls->count) {
        double before[3], now[3];
        vti_carry_from_axis(c, walls, b, before, now);
        const double gap = vti_face_inside(vti_face_axis(walls, at->wall), before, c->n0);
        for (int k = 0; k < 3; ++k)
            d0[k] = gap * c->n0[k];
        c->delta0 = at->length - gap;
        return;
    }
    double along = 0.0; /* of the way, normal to a plane */
    for (int k = 0; k < 3; ++k)
        along += c->slid[k] * at->n[k];
    for (int k = 0; k < 3; ++k)
        d0[k] = at->j >= 0 ? at->r * at->n[k] - c->slid[k] : (at->r - along) * at->n[k];
    const double r0 = vti_norm(d0);
    c->delta0 = at->length - (at->j >= 0 ? r0 : at->r - along);
    for (int k = 0; k < 3; ++k)
        c->n0[k] = at->j >= 0 && r0 > VTI_COINCIDENT ? d0[k] / r0 : at->n[k];
}

/** n0, n_m, delta0 and the motion X over the drift. */
static inline void vti_carry_motion(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b,
                                    const vti_drifted *drifted)
{
    const struct vti_touch *const at = &c->touch;
    const double h = drifted->t;
    double vi[3], vj[3] = {0.0, 0.0, 0.0}, ai[3], aj[3], d0[3], turn[3], sum[3], middle[3], s[3];
    vti_load(&b->v, at->i, vi);
    if (at->j >= 0)
        vti_load(&b->v, at->j, vj);
    for (int k = 0; k < 3; ++k) {
        if (at->moves)
            vj[k] = walls->motion[at->wall].velocity[k];
        c->slid[k] = h * (vi[k] - vj[k]);
    }
    vti_carry_turns(at, walls, b, drifted, ai, aj);
    vti_carry_start(c, walls, b, d0);
    if (at->moves)
        vti_carry_drag(c, walls, b, h, aj, d0);
    for (int k = 0; k < 3; ++k) {
        s[k] = c->n0[k] + at->n[k];
        turn[k] = at->s_i * ai[k] + at->s_j * aj[k];
        sum[k] = 0.5 * (d0[k] + at->r * at->n[k]);
    }
    const double length = vti_norm(s);
    c->turns_over = !(length > 0.0);
    for (int k = 0; k < 3; ++k)
        c->n_m[k] = c->turns_over ? at->n[k] : s[k] / length;
    vti_cross(turn, sum, middle);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] -= middle[k];
        c->rolled[k] = ai[k] - aj[k];
        sum[k] = ai[k] + aj[k];
    }
    c->tau = 0.125 * vti_dot(sum, s);
    c->twisted = vti_dot(c->rolled, c->n_m);
    vti_carry_across(c->slid, c->n_m);
    vti_carry_across(c->rolled, c->n_m);
    if (c->delta0 < 0.0 && at->delta > 0.0) { /* since they have touched */
        const double share = at->delta / (at->delta - c->delta0);
        c->twisted *= share;
        for (int k = 0; k < 3; ++k) {
            c->slid[k] *= share;
            c->rolled[k] *= share;
        }
    }
}

/** k_n = (3/2) K/length^{5/2} delta^{1/2} times mindlin, or the constant one, of sliding; 0 where nothing touches. */
static inline double vti_carry_stiffness(const vti_friction *p, const struct vti_touch *at, double delta)
{
    if (!(delta > 0.0 && p->sliding > 0.0))
        return 0.0;
    return p->mindlin > 0.0 ? p->mindlin * 1.5 * at->stiffness / (at->length * at->length) * sqrt(delta / at->length)
                            : p->stiffness;
}

/** The mean over a drift of a stiffness that goes as sqrt(delta) while delta goes evenly from one overlap to the other:
 *  with the mean of the two ends instead, a spring that sticks from the first touch on would be off by h^{3/2}. It lies
 *  between the two, so that a spring which stiffens loses. */
static inline double vti_carry_mean(double k0, double k1)
{
    return k0 + k1 > 0.0 ? 2.0 / 3.0 * (k0 * k0 + k0 * k1 + k1 * k1) / (k0 + k1) : 0.0;
}

/** F_n */
static inline double vti_carry_normal(const struct vti_touch *at, double delta)
{
    const double o = delta / at->length;
    return o > 0.0 ? vti_hertz_force(at->stiffness, at->length, o) : 0.0;
}

/** f, across a, turned to be across b by the shortest turn. */
static inline void vti_carry_swing(const double a[3], const double b[3], double f[3])
{
    const double share = vti_dot(f, b) / (1.0 + vti_dot(a, b));
    for (int k = 0; k < 3; ++k)
        f[k] -= share * (a[k] + b[k]);
}

/** W z, the turn by 4 atan(tau)/2 about n_m. */
static inline void vti_carry_twirl(const struct vti_carry *c, const double z[3], double turned[3])
{
    double side[3];
    const double t2 = c->tau * c->tau;
    vti_cross(c->n_m, z, side);
    for (int k = 0; k < 3; ++k)
        turned[k] = ((1.0 - t2) * z[k] + 2.0 * c->tau * side[k]) / (1.0 + t2);
}

/** z on the limit a1: along the mean of the old load, e = W y/a0, and the new one. */
static inline void vti_carry_return(const double z[3], const double turned[3], double a0, double a1, double y1[3])
{
    const double z2 = vti_dot(z, z);
    double e[3], lambda = 0.0, factor = a1 > 0.0 ? 1.0 : 0.0;
    for (int k = 0; k < 3; ++k)
        e[k] = a0 > 0.0 ? turned[k] / a0 : 0.0;
    const double ahead = vti_dot(z, e);
    if (!(z2 <= a1 * a1) && a1 > 0.0) {
        if (ahead > 0.0) {
            const double half = a1 + ahead, over = z2 - a1 * a1, e2 = vti_dot(e, e);
            lambda = over / (half + sqrt(half * half + (1.0 - (e2 < 1.0 ? e2 : 1.0)) * over));
            factor = a1 / (a1 + lambda);
        } else
            factor = a1 / sqrt(z2);
    }
    for (int k = 0; k < 3; ++k)
        y1[k] = (z[k] - lambda * e[k]) * factor;
}

/** A spring's limits and stiffnesses at both ends of the drift, the stiffness on the way, the share of its load that
 *  it keeps while the contact opens and softens. */
struct vti_carry_law {
    double a0, a1, k0, k1, k_m, kept;
};

/** The load f of one spring, which X has stretched; its mean over the drift in *mean. Returns what is lost by it: (y +
 *  y1).X/2 - |y1|^2/(2 k1) + |y|^2/(2 k0). */
static inline double vti_carry_spring(const struct vti_carry *c, const struct vti_carry_law *law, const double x[3],
                                      double f[3], double mean[3])
{
    double y[3] = {f[0], f[1], f[2]}, stretched[3], z[3], turned[3], y1[3] = {0.0, 0.0, 0.0};
    if (!c->turns_over) {
        vti_carry_swing(c->n0, c->n_m, y);
        for (int k = 0; k < 3; ++k)
            stretched[k] = law->kept * y[k] + 0.5 * law->k_m * x[k];
        vti_carry_twirl(c, stretched, z);
        vti_carry_twirl(c, y, turned);
        for (int k = 0; k < 3; ++k)
            z[k] += 0.5 * law->k_m * x[k];
        vti_carry_return(z, turned, law->a0, law->a1, y1);
    }
    double lost = 0.0;
    for (int k = 0; k < 3; ++k) {
        mean[k] = 0.5 * (y[k] + y1[k]);
        lost += mean[k] * x[k];
        f[k] = y1[k];
    }
    lost -= law->k1 > 0.0 ? 0.5 * vti_dot(y1, y1) / law->k1 : 0.0;
    lost += law->k0 > 0.0 ? 0.5 * vti_dot(y, y) / law->k0 : 0.0;
    vti_carry_swing(c->n_m, c->touch.n, f);
    return lost;
}

/** The same of twisting, a scalar. */
static inline double vti_carry_twist(double a1, double stiffness, double x, double *f, double *mean)
{
    const double y = *f, z = y + stiffness * x, y1 = z > a1 ? a1 : z < -a1 ? -a1 : z;
    *f = y1;
    *mean = 0.5 * (y + y1);
    return *mean * x - 0.5 * (y1 * y1 - y * y) / stiffness;
}

/** A wall that moves by so much takes what the load on the body holds back with. */
static inline void vti_carry_work(const vti_friction *p, const struct vti_carry *c, const double load[3],
                                  const double way[3])
{
    if (c->touch.moves)
        vti_sum_add(p->walls->work, vti_dot(load, way));
}

/** All springs of a touch. */
static inline void vti_carry_held(const vti_friction *p, const struct vti_carry *c, vti_held *held)
{
    const double force0 = vti_carry_normal(&c->touch, c->delta0), force1 = vti_carry_normal(&c->touch, c->touch.delta);
    double mean[3];
    if (p->sliding > 0.0) {
        const double k0 = vti_carry_stiffness(p, &c->touch, c->delta0),
                     k1 = vti_carry_stiffness(p, &c->touch, c->touch.delta);
        const int closes = k1 >= k0;
        const double mu = c->touch.j < 0 ? vti_friction_of_wall(p, c->touch.wall) : p->sliding;
        const struct vti_carry_law law = {mu * force0,
                                          mu * force1,
                                          k0,
                                          k1,
                                          !(p->mindlin > 0.0) ? p->stiffness
                                          : closes            ? vti_carry_mean(k0, k1)
                                                              : k1,
                                          !(p->mindlin > 0.0) || closes ? 1.0 : k1 / k0};
        vti_sum_add(&p->lost[0], vti_carry_spring(c, &law, c->slid, held->sliding, mean));
        vti_carry_work(p, c, mean, c->dragged);
    }
    if (p->rolling > 0.0) {
        const double k = p->rolling_stiffness;
        const struct vti_carry_law law = {p->rolling * force0, p->rolling * force1, k, k, k, 1.0};
        vti_sum_add(&p->lost[1], vti_carry_spring(c, &law, c->rolled, held->rolling, mean));
        vti_carry_work(p, c, mean, c->turned);
    }
    if (p->twisting > 0.0) {
        double load;
        vti_sum_add(&p->lost[2],
                    vti_carry_twist(p->twisting * force1, p->twisting_stiffness, c->twisted, &held->twisting, &load));
        for (int k = 0; k < 3; ++k)
            mean[k] = load * c->n_m[k];
        vti_carry_work(p, c, mean, c->turned);
    }
}

#endif
