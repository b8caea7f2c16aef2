/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How a body of three moments drifts (EQUATIONS 7.2): a turn about L in space, and turns about two of its principal
 * axes. With r the axis of the middle k = 1/moment, x and y the two others, d_i = k_i - k_r and |d_x| >= |d_y| (ties:
 * any, as all are), d_x d_y <= 0 and
 *
 *     T = k_r |L|^2/2 + d_x p_x^2/2 + d_y p_y^2/2,  p = R_p^T L.
 *
 * The first term commutes with the rest, and turns as a sphere's does, by k_r t L; the others are split by a list of
 * turns about x and y. A turn by phi is the pair (c, f phi) of its law, an unnormalised quaternion. Formulas are on
 * lanes (vti_lanes.h), a number in each; where that is one, they are those of a single body. */
#ifndef VTI_ROTOR_H
#define VTI_ROTOR_H

#include "vti_rotor_turns.h"

VTI_MOVE_LAW(rotor_law, lanes, lanes_of, lanes_sqrt)

/** A body: the quaternion q ~ R_p (v, w), q.q, and its moments. */
struct rotor_body {
    lanes q[4], square, m[3];
    int turned; /* its principal axes are not the body's own */
};

/** Whether three moments are one. */
VTI_INLINE lanes_mask rotor_is_round(const lanes m[3])
{
    return (m[0] == m[1]) & (m[1] == m[2]);
}

/** R_p diag(m) R_p^T v, or with 1/m. */
VTI_INLINE void rotor_times(const struct rotor_body *body, int inverse, const lanes v[3], lanes r[3])
{
    const lanes scale = 2.0 / body->square;
    lanes p[3];
    lanes_rotate(body->q, scale, -1.0, v, p);
    for (int n = 0; n < 3; ++n)
        p[n] *= inverse ? 1.0 / body->m[n] : body->m[n];
    lanes_rotate(body->q, scale, 1.0, p, r);
}

/** q = attitude principal: first the principal axes onto the body's, then those into space. */
VTI_INLINE void rotor_principal(const lanes a[4], const lanes p[4], lanes q[4])
{
    lanes x[3];
    lanes_cross(a, p, x);
    for (int n = 0; n < 3; ++n)
        q[n] = (a[3] * p[n] + p[3] * a[n]) + x[n];
    q[3] = a[3] * p[3] - lanes_dot(a, p);
}

/** An increment 2 f u/c; in space, or in the body. f is 1 but of spheres. */
struct rotor_increment {
    lanes c, f, u[3];
};

/** Of a sphere: the turn about L by u = t k L, and the pair of its law, in space. */
VTI_INLINE void rotor_sphere(int law, lanes t, lanes k, const lanes L[3], struct rotor_increment *d)
{
    lanes cf[2];
    for (int n = 0; n < 3; ++n)
        d->u[n] = t * (k * L[n]);
    rotor_law(law, lanes_dot(d->u, d->u), cf);
    d->c = cf[0];
    d->f = cf[1];
}

/** The incremental form of vti_rrv.h of an increment with f = 1 and of half the attitude, g = alpha/2:
 *      alpha + 2 [u + side u x g + (u.g) g]/(c - u.g).
 *  Returns u.g. */
VTI_INLINE lanes rotor_incremental(lanes c, const lanes u[3], double side, const lanes g[3], lanes add[3])
{
    const lanes d = lanes_dot(u, g), inv = 2.0 / (c - d);
    lanes x[3];
    lanes_cross(u, g, x);
    for (int k = 0; k < 3; ++k)
        add[k] = ((u[k] + side * x[k]) + d * g[k]) * inv;
    return d;
}

/** p = R_p^T L along x, y and r, R_p^T L = L + 2/q.q (v x x - w x), x = v x L. */
VTI_INLINE void rotor_spin(const struct rotor_body *body, lanes scale, const struct rotor_axes *at, const lanes L[3],
                           lanes p[3])
{
    lanes x[3], xx[3], r[3];
    lanes_cross(body->q, L, x);
    lanes_cross(body->q, x, xx);
    for (int n = 0; n < 3; ++n)
        r[n] = L[n] + scale * (xx[n] - body->q[3] * x[n]);
    rotor_onto(at, r, p);
}

/** Where rotor_join has its increments: 1 in space, -1 in the body. */
VTI_INLINE double rotor_side(const struct rotor_body *body)
{
    return body->turned ? 1.0 : -1.0;
}

/** All turns as one, d. In space the turn about L, of time * k_r, is the last; in the body it is one about p = R_p^T L
 *  before all others: (c0, s0 p) b. */
VTI_INLINE void rotor_join(const struct rotor_body *body, lanes scale, const struct rotor_axes *at, const lanes b[4],
                           lanes c0, lanes s0, const lanes p[3], struct rotor_increment *d)
{
    lanes x[3], v[3];
    for (int n = 0; n < 3; ++n)
        v[n] = s0 * p[n];
    lanes_cross(v, b, x);
    d->c = c0 * b[3] - lanes_dot(v, b);
    for (int n = 0; n < 3; ++n)
        x[n] = (c0 * b[n] + b[3] * v[n]) + x[n];
    rotor_off(at, x, d->u);
    if (body->turned)
        lanes_rotate(body->q, scale, 1.0, d->u, d->u);
    d->f = lanes_of(1.0);
}

/** What a drift of time t begins with: the axes, p, t k_r and e = t d_x/2, t d_y/2, and L.L. */
struct rotor_start {
    struct rotor_axes at;
    lanes p[3], turn, e[2], square, scale, range;
    lanes about_L, about_x; /* (t k_r)^2 L.L, (t d_x/2)^2 L.L */
};

VTI_INLINE void rotor_start_of(double t, const struct rotor_body *body, const lanes L[3], struct rotor_start *from)
{
    struct rotor_moments along;
    from->scale = 2.0 / body->square;
    from->at = rotor_axes_of(body->m, &along);
    const struct rotor_rates rates = rotor_rates_of(t, &along);
    from->turn = rates.turn;
    from->e[0] = rates.half[0];
    from->e[1] = rates.half[1];
    from->square = lanes_dot(L, L);
    from->about_L = (from->turn * from->turn) * from->square;
    from->about_x = (from->e[0] * from->e[0]) * from->square;
    from->range = rates.range;
    rotor_spin(body, from->scale, &from->at, L, from->p);
}

/** Whether all is in the range of numbers and no turn of a drift is more than 2, however its list has it: none is more
 *  than t |L| times the larger of k_r and d_x. Products of up to 21 pairs are below 2^23 then. */
VTI_INLINE lanes_mask rotor_is_tame(const struct rotor_start *from)
{
    return (1.0 / ROTOR_RANGE) * from->range + (0.25 * from->about_L + from->about_x) < 1.0;
}

/** The lists of turns of so many drifts, of p along x, y and r. */
VTI_INLINE void rotor_lists_of(int law, int rotor, const struct rotor_start *const *from, struct rotor_list *lists,
                               int count)
{
    ROTOR_UNROLLED
    for (int m = 0; m < count; ++m) {
        struct rotor_list *const list = lists + m;
        const lanes e_x = from[m]->e[0], e_y = from[m]->e[1];
        for (int n = 0; n < 3; ++n)
            list->p[n] = rotor == 4 ? e_x * from[m]->p[n] : from[m]->p[n];
        list->sigma = list->most = lanes_of(0.0);
        list->law = law;
        list->divides = rotor != 2 || law == VTI_LAW_CLOSED || list->hard;
        list->over = lanes_of(1.0);
        list->by[0] = e_x;
        list->by[1] = e_y;
        if (rotor == 4) {
            list->by[0] = lanes_of(1.0);
            list->by[1] = e_y / lanes_where(e_x == 0.0, list->by[0], e_x);
            list->square = from[m]->about_x;
        }
    }
    if (rotor == 4)
        rotor_m4(lists, count);
    else if (rotor == 6)
        rotor_s10(lists, count);
    else
        rotor_strang(lists, count);
}

/** The turn about L as a pair (c, s p): by t k_r L and its law, to which M4 adds that by sigma L, of e_x p. */
VTI_INLINE void rotor_about_L(int law, int rotor, const struct rotor_start *from, lanes sigma, lanes cs[2])
{
    const lanes turn = from->turn;
    rotor_law(law, from->about_L, cs);
    cs[1] *= turn;
    if (rotor == 4) {
        const lanes c = cs[0], s = cs[1], more = sigma * (2.0 * from->e[0]);
        lanes by[2];
        rotor_law(VTI_LAW_EXACT, (more * more) * from->square, by);
        by[1] *= more;
        cs[0] = c * by[0] - (s * by[1]) * from->square;
        cs[1] = c * by[1] + s * by[0];
    }
}

/** So many lists at most go on side by side. */
enum { ROTOR_ABREAST = 4 };

/** The increments of so many drifts that begin so, of bodies that are no spheres. */
VTI_INLINE void rotor_drift(int law, int rotor, const struct rotor_start *const *from, const struct rotor_body *body,
                            struct rotor_increment *d, int count)
{
    struct rotor_list lists[ROTOR_ABREAST];
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n)
        lists[n].hard = lists[n].watches = 0;
    rotor_lists_of(law, rotor, from, lists, count);
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n) {
        lanes cs[2];
        rotor_about_L(law, rotor, from[n], lists[n].sigma, cs);
        rotor_join(body, from[n]->scale, &from[n]->at, lists[n].b, cs[0], cs[1], from[n]->p, d + n);
    }
}

/** The largest turn of it. */
VTI_INLINE lanes rotor_most(int law, int rotor, const struct rotor_start *from)
{
    struct rotor_list list;
    list.hard = 0;
    list.watches = 1;
    rotor_lists_of(law, rotor, &from, &list, 1);
    const lanes about = lanes_sqrt(from->about_L);
    return lanes_where(about > list.most, about, list.most + 0.0 * about); /* NaN of either shows */
}

#endif
