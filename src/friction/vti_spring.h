/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How the springs of a touch follow a drift (EQUATIONS 6.5, carry): through the turn of the normal (swing) and of both
 * bodies about it (twirl), stretched by how far surfaces have moved over each other, and returned to the limit along
 * the mean of the old and the new direction, which is of second order. For lanes of touches, or for one, as in
 * vti_touch_motion.h. */
#ifndef VTI_SPRING_H
#define VTI_SPRING_H

#include "../contacts/vti_hertz.h"
#include "../contacts/vti_touch_motion.h"

/** Of the drift that has been done; touch is where it ends. */
struct vti_carry {
    struct vti_touch touch;
    lanes n0[3], n_m[3];   /* normals at its start and in the middle */
    lanes_mask turns_over; /* n0 = -n1: there is no middle */
    lanes delta0;          /* overlap at its start */
    lanes tau;             /* of the twirl: tan of a quarter of both turns about n_m together */
    lanes slid[3];         /* X of sliding, across n_m */
    lanes rolled[3];       /* X of rolling, across n_m */
    lanes twisted;         /* x of twisting */
    lanes dragged[3];      /* where walls move: by how much the wall's surface has moved */
    lanes turned[3];       /* where walls move: by how much it has turned */
};

/** What a drift takes, of sliding, rolling and twisting: what is lost, and what a wall that moves has taken. */
struct vti_taken {
    lanes lost[VTI_FRICTION_BOOKS], worked[VTI_FRICTION_BOOKS];
};

/* ---- motion ------------------------------------------------------------------------------------------------------ */

/** d0, n0 and delta0 of two bodies that have moved against each other by way. */
VTI_INLINE void vti_carry_apart(struct vti_carry *c, const lanes way[3], lanes d0[3])
{
    const struct vti_touch *const at = &c->touch;
    for (int k = 0; k < 3; ++k)
        d0[k] = at->r * at->n[k] - way[k];
    const lanes r0 = lanes_sqrt(lanes_dot(d0, d0)), per_r0 = 1.0 / r0;
    c->delta0 = at->length - r0;
    for (int k = 0; k < 3; ++k)
        c->n0[k] = lanes_where(r0 > VTI_COINCIDENT, d0[k] * per_r0, at->n[k]);
}

/** n_m and the motion X, of d0, n0, delta0 and, in slid, the way of the centres; a_i and a_j are the increments of the
 *  attitudes. */
VTI_INLINE void vti_carry_stretch(struct vti_carry *c, const lanes d0[3], const lanes a_i[3], const lanes a_j[3])
{
    const struct vti_touch *const at = &c->touch;
    lanes s[3], turn[3], sum[3], middle[3];
    for (int k = 0; k < 3; ++k) {
        s[k] = c->n0[k] + at->n[k];
        turn[k] = at->s_i * a_i[k] + at->s_j * a_j[k];
        sum[k] = 0.5 * (d0[k] + at->r * at->n[k]);
    }
    const lanes length = lanes_sqrt(lanes_dot(s, s)), per_length = 1.0 / length;
    c->turns_over = length <= 0.0;
    for (int k = 0; k < 3; ++k)
        c->n_m[k] = lanes_where(c->turns_over, at->n[k], s[k] * per_length);
    lanes_cross(turn, sum, middle);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] -= middle[k];
        c->rolled[k] = a_i[k] - a_j[k];
        sum[k] = a_i[k] + a_j[k];
    }
    c->tau = 0.125 * lanes_dot(sum, s);
    c->twisted = lanes_dot(c->rolled, c->n_m);
    vti_touch_across(c->n_m, c->slid);
    vti_touch_across(c->n_m, c->rolled);
    /* since they have touched */
    const lanes part = at->delta / (at->delta - c->delta0);
    const lanes share = lanes_where((c->delta0 < 0.0) & (at->delta > 0.0), part, lanes_of(1.0));
    c->twisted *= share;
    for (int k = 0; k < 3; ++k) {
        c->slid[k] *= share;
        c->rolled[k] *= share;
    }
}

/* ---- stiffness and limit ----------------------------------------------------------------------------------------- */

/** k_n = (3/2) K/length^{5/2} delta^{1/2} times mindlin, or the constant one, of sliding; 0 where nothing touches. */
VTI_INLINE lanes vti_carry_stiffness(const vti_friction *p, const struct vti_touch *at, lanes delta)
{
    const lanes zero = lanes_of(0.0);
    if (!(p->sliding > 0.0))
        return zero;
    if (!(p->mindlin > 0.0))
        return lanes_where(delta > 0.0, lanes_of(p->stiffness), zero);
    const lanes o = lanes_where(delta > 0.0, delta / at->length, zero);
    return p->mindlin * 1.5 * at->stiffness / (at->length * at->length) * lanes_sqrt(o);
}

/** The mean over a drift of a stiffness that goes as sqrt(delta) while delta goes evenly from one overlap to the other:
 *  with the mean of the two ends instead, a spring that sticks from the first touch on would be off by h^{3/2}. It lies
 *  between the two, so that a spring which stiffens loses. */
VTI_INLINE lanes vti_carry_mean(lanes k0, lanes k1)
{
    const lanes mean = 2.0 / 3.0 * (k0 * k0 + k0 * k1 + k1 * k1) / (k0 + k1);
    return lanes_where(k0 + k1 > 0.0, mean, lanes_of(0.0));
}

VTI_HERTZ_FORCE(vti_carry_hertz, lanes, lanes_sqrt)

/** F_n of that overlap; 0 where nothing touches. */
VTI_INLINE lanes vti_carry_normal(const struct vti_touch *at, lanes delta)
{
    const lanes o = lanes_where(delta > 0.0, delta / at->length, lanes_of(0.0));
    return vti_carry_hertz(at->stiffness, at->length, o);
}

/* ---- turns of loads ---------------------------------------------------------------------------------------------- */

/** f, across a, turned to be across b by the shortest turn. */
VTI_INLINE void vti_carry_swing(const lanes a[3], const lanes b[3], lanes f[3])
{
    const lanes share = lanes_dot(f, b) / (1.0 + lanes_dot(a, b));
    for (int k = 0; k < 3; ++k)
        f[k] -= share * (a[k] + b[k]);
}

/** W z: z turned by 2 atan(tau) about n_m. */
VTI_INLINE void vti_carry_twirl(const struct vti_carry *c, const lanes z[3], lanes turned[3])
{
    lanes side[3];
    const lanes t2 = c->tau * c->tau, per = 1.0 / (1.0 + t2), along = (1.0 - t2) * per, aside = 2.0 * c->tau * per;
    lanes_cross(c->n_m, z, side);
    for (int k = 0; k < 3; ++k)
        turned[k] = along * z[k] + aside * side[k];
}

/** z on the limit a1: along the mean of the old load, e = W y/a0, and the new one. */
VTI_INLINE void vti_carry_return(const lanes z[3], const lanes turned[3], lanes a0, lanes a1, lanes y1[3])
{
    const lanes zero = lanes_of(0.0), one = lanes_of(1.0), z2 = lanes_dot(z, z), over = z2 - a1 * a1;
    const lanes_mask holds = (z2 <= a1 * a1) & (a1 > 0.0);
    for (int k = 0; k < 3; ++k)
        y1[k] = z[k];
    if (lanes_all(holds)) /* as mostly: neither roots nor divisions */
        return;
    const lanes per_a0 = lanes_where(a0 > 0.0, 1.0 / a0, zero);
    lanes e[3];
    for (int k = 0; k < 3; ++k)
        e[k] = turned[k] * per_a0;
    const lanes ahead = lanes_dot(z, e), half = a1 + ahead, e2 = lanes_dot(e, e);
    const lanes beyond = over / (half + lanes_sqrt(half * half + (1.0 - lanes_where(e2 < 1.0, e2, one)) * over));
    const lanes_mask follows = ahead > 0.0;
    const lanes lambda = lanes_where(follows & (a1 > 0.0), beyond, zero);
    const lanes back = a1 / lanes_where(follows, a1 + beyond, lanes_sqrt(z2));
    const lanes factor = lanes_where(a1 > 0.0, back, zero);
    for (int k = 0; k < 3; ++k)
        y1[k] = lanes_where(holds, z[k], (z[k] - lambda * e[k]) * factor);
}

/* ---- springs ----------------------------------------------------------------------------------------------------- */

/** A spring's limits and stiffnesses at both ends of the drift, the stiffness on the way, the share of its load that
 *  it keeps while the contact opens and softens. */
struct vti_carry_law {
    lanes a0, a1, k0, k1, k_m, kept;
};

/** |y|^2/(2 k), nothing where there is no spring. */
VTI_INLINE lanes vti_carry_energy(const lanes y[3], lanes k)
{
    return lanes_where(k > 0.0, 0.5 * lanes_dot(y, y) / k, lanes_of(0.0));
}

/** The load f of one spring, which X has stretched; its mean over the drift in *mean. Returns what is lost by it: (y +
 *  y1).X/2 - |y1|^2/(2 k1) + |y|^2/(2 k0). */
VTI_INLINE lanes vti_carry_spring(const struct vti_carry *c, const struct vti_carry_law *law, const lanes x[3],
                                  lanes f[3], lanes mean[3])
{
    const lanes zero = lanes_of(0.0);
    lanes y[3] = {f[0], f[1], f[2]}, stretched[3], z[3], turned[3], y1[3];
    vti_carry_swing(c->n0, c->n_m, y);
    for (int k = 0; k < 3; ++k) {
        y[k] = lanes_where(c->turns_over, f[k], y[k]);
        stretched[k] = law->kept * y[k] + 0.5 * law->k_m * x[k];
    }
    vti_carry_twirl(c, stretched, z);
    vti_carry_twirl(c, y, turned);
    for (int k = 0; k < 3; ++k)
        z[k] += 0.5 * law->k_m * x[k];
    vti_carry_return(z, turned, law->a0, law->a1, y1);
    lanes lost = zero;
    for (int k = 0; k < 3; ++k) {
        y1[k] = lanes_where(c->turns_over, zero, y1[k]);
        mean[k] = 0.5 * (y[k] + y1[k]);
        lost += mean[k] * x[k];
        f[k] = y1[k];
    }
    lost -= vti_carry_energy(y1, law->k1);
    lost += vti_carry_energy(y, law->k0);
    vti_carry_swing(c->n_m, c->touch.n, f);
    for (int k = 0; k < 3; ++k)
        f[k] = lanes_settled(f[k]);
    return lost;
}

/** The same of twisting, a scalar. */
VTI_INLINE lanes vti_carry_twist(lanes a1, double stiffness, lanes x, lanes *f, lanes *mean)
{
    const lanes y = *f, z = y + stiffness * x, y1 = lanes_where(z > a1, a1, lanes_where(z < -a1, -a1, z));
    *f = lanes_settled(y1);
    *mean = 0.5 * (y + y1);
    return *mean * x - 0.5 * (y1 * y1 - y * y) / stiffness;
}

/** The sliding spring's law, with the coefficient mu there. */
VTI_INLINE struct vti_carry_law vti_carry_sliding(const vti_friction *p, const struct vti_carry *c, lanes mu,
                                                  lanes force0, lanes force1)
{
    struct vti_carry_law law = {.a0 = mu * force0, .a1 = mu * force1};
    law.k0 = vti_carry_stiffness(p, &c->touch, c->delta0);
    law.k1 = vti_carry_stiffness(p, &c->touch, c->touch.delta);
    law.k_m = lanes_of(p->stiffness);
    law.kept = lanes_of(1.0);
    if (p->mindlin > 0.0) {
        const lanes_mask closes = law.k1 >= law.k0;
        law.k_m = lanes_where(closes, vti_carry_mean(law.k0, law.k1), law.k1);
        law.kept = lanes_where(closes, law.kept, law.k1 / law.k0);
    }
    return law;
}

/** All springs of a touch. A wall that moves takes what the load on the body holds back with. */
VTI_INLINE void vti_carry_loads(const vti_friction *p, const struct vti_carry *c, lanes mu, struct vti_loads *f,
                                struct vti_taken *taken)
{
    const lanes force0 = vti_carry_normal(&c->touch, c->delta0), force1 = vti_carry_normal(&c->touch, c->touch.delta);
    const int moves = c->touch.moves;
    lanes mean[3];
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k)
        taken->lost[k] = taken->worked[k] = lanes_of(0.0);
    if (p->sliding > 0.0) {
        const struct vti_carry_law law = vti_carry_sliding(p, c, mu, force0, force1);
        taken->lost[0] = vti_carry_spring(c, &law, c->slid, f->sliding, mean);
        if (moves)
            taken->worked[0] = lanes_dot(mean, c->dragged);
    }
    if (p->rolling > 0.0) {
        const lanes k = lanes_of(p->rolling_stiffness);
        const struct vti_carry_law law = {p->rolling * force0, p->rolling * force1, k, k, k, lanes_of(1.0)};
        taken->lost[1] = vti_carry_spring(c, &law, c->rolled, f->rolling, mean);
        if (moves)
            taken->worked[1] = lanes_dot(mean, c->turned);
    }
    if (p->twisting > 0.0) {
        lanes load;
        taken->lost[2] = vti_carry_twist(p->twisting * force1, p->twisting_stiffness, c->twisted, &f->twisting, &load);
        for (int k = 0; k < 3; ++k)
            mean[k] = load * c->n_m[k];
        if (moves)
            taken->worked[2] = lanes_dot(mean, c->turned);
    }
}

#endif
