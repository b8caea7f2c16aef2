/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How a body of three moments drifts (EQUATIONS 7.2): a turn about L in space, and turns about two of its principal
 * axes. With r the axis of the middle k = 1/moment (ties: any, as all are), x and y the two others, d_i = k_i - k_r and
 * |d_x| >= |d_y| (ties: x = r + 1), d_x d_y <= 0 and
 *
 *     T = k_r |L|^2/2 + d_x p_x^2/2 + d_y p_y^2/2,  p = R_p^T L.
 *
 * The first term commutes with the rest, and turns as a sphere's does, by k_r t L; the others are split by a list of
 * turns about x and y. A turn by phi is the pair (c, f phi) of its law, an unnormalised quaternion. Formulas are on
 * lanes (vti_lanes.h), a number in each; where that is one, they are those of a single body. */
#ifndef VTI_ROTOR_H
#define VTI_ROTOR_H

#include "vti_lanes.h"
#include "vti_move.h"

VTI_MOVE_LAW(rotor_law, lanes, lanes_of, lanes_sqrt)

/** The larger of the two; but a turn that has reached 1, or is NaN, stays. */
VTI_INLINE lanes rotor_worst(lanes a, lanes b)
{
    return lanes_where(a < 1.0, lanes_where(b <= a, a, b), a);
}

/* ---- axes -------------------------------------------------------------------------------------------------------- */

struct rotor_axes {
    lanes_mask later, last; /* r is not axis 0; nor axis 1 */
    lanes_mask swapped;     /* x, y = r + 2, r + 1, and x, y, -r are right-handed */
    lanes k_r, d_x, d_y;
};

/** v_r, v_{r+1}, v_{r+2} */
VTI_INLINE void rotor_from_r(const struct rotor_axes *at, const lanes v[3], lanes c[3])
{
    c[0] = lanes_where(at->later, lanes_where(at->last, v[2], v[1]), v[0]);
    c[1] = lanes_where(at->later, lanes_where(at->last, v[0], v[2]), v[1]);
    c[2] = lanes_where(at->later, lanes_where(at->last, v[1], v[0]), v[2]);
}

/** Of moments m and k = 1/m. An axis is in the middle if the next one's moment is above its own and the other's is not,
 *  or the other way round. */
VTI_INLINE struct rotor_axes rotor_axes_of(const lanes m[3], const lanes k[3])
{
    struct rotor_axes at;
    lanes c[3];
    const lanes_mask rises = m[0] < m[1];
    at.later = rises ^ (m[2] < m[0]);
    at.last = rises ^ (m[1] < m[2]);
    rotor_from_r(&at, k, c);
    at.k_r = c[0];
    c[1] -= c[0];
    c[2] -= c[0];
    at.swapped = lanes_abs(c[2]) > lanes_abs(c[1]);
    at.d_x = lanes_where(at.swapped, c[2], c[1]);
    at.d_y = lanes_where(at.swapped, c[1], c[2]);
    return at;
}

/** Components along x, y and what makes them right-handed. */
VTI_INLINE void rotor_onto(const struct rotor_axes *at, const lanes v[3], lanes p[3])
{
    lanes c[3];
    rotor_from_r(at, v, c);
    p[0] = lanes_where(at->swapped, c[2], c[1]);
    p[1] = lanes_where(at->swapped, c[1], c[2]);
    p[2] = lanes_where(at->swapped, -c[0], c[0]);
}

/** The way back. */
VTI_INLINE void rotor_off(const struct rotor_axes *at, const lanes p[3], lanes v[3])
{
    const lanes c[3] = {lanes_where(at->swapped, -p[2], p[2]), lanes_where(at->swapped, p[1], p[0]),
                        lanes_where(at->swapped, p[0], p[1])};
    v[0] = lanes_where(at->later, lanes_where(at->last, c[1], c[2]), c[0]);
    v[1] = lanes_where(at->later, lanes_where(at->last, c[2], c[0]), c[1]);
    v[2] = lanes_where(at->later, lanes_where(at->last, c[0], c[1]), c[2]);
}

/* ---- turns about x and y ----------------------------------------------------------------------------------------- */

/** What a list of turns has come to. */
struct rotor_list {
    lanes p[3];    /* along x, y and r */
    lanes b[4];    /* all turns so far, (v, w) */
    lanes most;    /* the largest |phi|, up to the first of 1 or more */
    lanes sigma;   /* of M4 */
    lanes by[2];   /* phi = by_i p_i tau */
    lanes g;       /* of M4: phi2 = +- g p_i (2 K - 4 p_i^2) tau */
    lanes square;  /* of M4: K = p.p */
    int law, hard; /* hard: of turns that are beyond all measure, and are cut off */
    int watches;   /* whether most is wanted, and nothing else */
};

/** Beyond so many radians in a step, phi is whatever is finite. */
#define ROTOR_MOST 64.0

VTI_INLINE lanes rotor_cut(const struct rotor_list *list, lanes phi)
{
    if (!list->hard)
        return phi;
    phi = lanes_where(phi < ROTOR_MOST, phi, lanes_of(ROTOR_MOST));
    return lanes_where(phi > -ROTOR_MOST, phi, lanes_of(-ROTOR_MOST));
}

/** Where a turn stands in its list. */
enum rotor_place { ROTOR_FIRST, ROTOR_SECOND, ROTOR_INNER, ROTOR_LAST };

/** (p_j, p_k) <- (C p_j + S p_k, C p_k - S p_j), i, j, k cyclic, with
 *      C = (c^2 - s^2)/(c^2 + s^2),  S = 2 c s/(c^2 + s^2),
 *  which of the closed law are c - 1 and s. */
VTI_INLINE void rotor_turn_p(int closed, int i, lanes c, lanes s, lanes p[3])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const lanes cc = c * c, ss = s * s;
    const lanes C = closed ? c - 1.0 : cc - ss, S = closed ? s : 2.0 * c * s;
    const lanes p_j = C * p[j] + S * p[k], p_k = C * p[k] - S * p[j];
    const lanes inv = closed ? lanes_of(1.0) : 1.0 / (cc + ss);
    p[j] = p_j * inv;
    p[k] = p_k * inv;
}

/** b <- b (c, s e_i), of the first two turns without the products with 0. */
VTI_INLINE void rotor_turn_b(enum rotor_place place, int i, lanes c, lanes s, lanes b[4])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (place == ROTOR_FIRST) {
        b[i] = s;
        b[3] = c;
    } else if (place == ROTOR_SECOND) { /* k is the axis of the first */
        b[i] = s * b[3];
        b[j] = s * b[k];
        b[3] = c * b[3];
        b[k] = c * b[k];
    } else {
        const lanes b_i = c * b[i] + s * b[3], b_j = c * b[j] + s * b[k];
        b[3] = c * b[3] - s * b[i];
        b[k] = c * b[k] - s * b[j];
        b[i] = b_i;
        b[j] = b_j;
    }
}

/** The turn about axis i, 0 or 1, by tau of its whole. */
VTI_INLINE void rotor_turn(struct rotor_list *list, int rotor, enum rotor_place place, int i, lanes tau)
{
    const lanes p = list->p[i], phi = rotor_cut(list, tau * list->by[i] * p);
    lanes c[2];
    if (list->watches)
        list->most = rotor_worst(list->most, lanes_abs(phi));
    rotor_law(list->law, phi * phi, c);
    lanes s = c[1] * phi;
    if (rotor == 4) {
        const lanes g = (i == 0 ? -tau : tau) * list->g, pp = p * p;
        const lanes more = rotor_cut(list, g * p * (2.0 * list->square - 4.0 * pp));
        lanes d[2];
        rotor_law(VTI_LAW_EXACT, more * more, d);
        const lanes s2 = d[1] * more, both = c[0] * d[0] - s * s2;
        s = c[0] * s2 + s * d[0];
        c[0] = both;
        list->sigma += 2.0 * g * pp;
    }
    if (place != ROTOR_LAST)
        rotor_turn_p(list->law == VTI_LAW_CLOSED && rotor != 4, i, c[0], s, list->p);
    rotor_turn_b(place, i, c[0], s, list->b);
}

/** Strang: x 1/2, y 1, x 1/2, order 2. */
VTI_INLINE void rotor_strang(struct rotor_list *list)
{
    rotor_turn(list, 2, ROTOR_FIRST, 0, lanes_of(0.5));
    rotor_turn(list, 2, ROTOR_SECOND, 1, lanes_of(1.0));
    rotor_turn(list, 2, ROTOR_LAST, 0, lanes_of(0.5));
}

/** M4: x a, y 1/2, x 1 - 2 a, y 1/2, x a, order 4 with the turns by phi2 and sigma. Here p is in units of 1/(t d_x), so
 *  that rho = -d_y/d_x is all that is left of the moments, and g = d_y/d_x (1 - 6 a + 6 a^2)/12. */
VTI_INLINE void rotor_m4(struct rotor_list *list)
{
    const lanes rho = -list->by[1], root = lanes_sqrt(48.0 + 96.0 * rho + 36.0 * rho * rho);
    const lanes a = (12.0 + 6.0 * rho - root) * (1.0 / 24.0), middle = 1.0 - 2.0 * a;
    list->g = list->by[1] * ((1.0 - 6.0 * a + 6.0 * a * a) * (1.0 / 12.0));
    list->square = list->p[0] * list->p[0] + list->p[1] * list->p[1] + list->p[2] * list->p[2];
    rotor_turn(list, 4, ROTOR_FIRST, 0, a);
    rotor_turn(list, 4, ROTOR_SECOND, 1, lanes_of(0.5));
    rotor_turn(list, 4, ROTOR_INNER, 0, middle);
    rotor_turn(list, 4, ROTOR_INNER, 1, lanes_of(0.5));
    rotor_turn(list, 4, ROTOR_LAST, 0, a);
}

/** S10 (Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313): order 6, 21 turns, x a1, y b1, x a2, ..., mirrored. */
VTI_INLINE void rotor_s10(struct rotor_list *list)
{
    static const double x[6] = {0.0502627644003922,
                                0.413514300428344,
                                0.0450798897943977,
                                -0.188054853819569,
                                0.541960678450780,
                                1.0 - 2.0 * (0.0502627644003922 + 0.413514300428344 + 0.0450798897943977 -
                                             0.188054853819569 + 0.541960678450780)},
                        y[5] = {0.148816447901042, -0.132385865767784, 0.067307604692185, 0.432666402578175,
                                0.5 - (0.148816447901042 - 0.132385865767784 + 0.067307604692185 + 0.432666402578175)};
    rotor_turn(list, 6, ROTOR_FIRST, 0, lanes_of(x[0]));
    rotor_turn(list, 6, ROTOR_SECOND, 1, lanes_of(y[0]));
    for (int n = 1; n < 10; ++n) {
        rotor_turn(list, 6, ROTOR_INNER, 0, lanes_of(x[n <= 5 ? n : 10 - n]));
        rotor_turn(list, 6, ROTOR_INNER, 1, lanes_of(y[n <= 4 ? n : 9 - n]));
    }
    rotor_turn(list, 6, ROTOR_LAST, 0, lanes_of(x[0]));
}

/* ---- a drift ----------------------------------------------------------------------------------------------------- */

/** A body: the quaternion q ~ R_p (v, w), 2/q.q, its moments, 1/moments, and whether it is a sphere. */
struct rotor_body {
    lanes q[4], scale, m[3], k[3];
    lanes_mask round;
    int turned; /* its principal axes are not the body's own */
};

VTI_INLINE void rotor_moments(struct rotor_body *body)
{
    for (int n = 0; n < 3; ++n)
        body->k[n] = 1.0 / body->m[n];
    body->round = (body->m[0] == body->m[1]) & (body->m[1] == body->m[2]);
}

/** R_p diag(m) R_p^T v */
VTI_INLINE void rotor_times(const struct rotor_body *body, const lanes m[3], const lanes v[3], lanes r[3])
{
    lanes p[3];
    lanes_rotate(body->q, body->scale, -1.0, v, p);
    for (int n = 0; n < 3; ++n)
        p[n] *= m[n];
    lanes_rotate(body->q, body->scale, 1.0, p, r);
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

/** The list of turns of a drift by e_x = t d_x and e_y = t d_y of p along x, y and r. */
VTI_INLINE void rotor_list_of(int rotor, lanes e_x, lanes e_y, const lanes p[3], struct rotor_list *list)
{
    for (int n = 0; n < 3; ++n)
        list->p[n] = rotor == 4 ? e_x * p[n] : p[n];
    list->sigma = list->most = lanes_of(0.0);
    list->by[0] = e_x;
    list->by[1] = e_y;
    if (rotor == 4) {
        list->by[0] = lanes_of(1.0);
        list->by[1] = e_y / lanes_where(e_x == 0.0, list->by[0], e_x);
        rotor_m4(list);
    } else if (rotor == 6)
        rotor_s10(list);
    else
        rotor_strang(list);
}

/** An increment 2 f u/c: side 1 in space, -1 in the body. */
struct rotor_increment {
    lanes c, f, u[3], side;
};

/** The turn about L: u = t k_r L, and the pair of its law. */
VTI_INLINE void rotor_about_L(int law, lanes t, lanes k_r, const lanes L[3], lanes u[3], lanes cf[2])
{
    for (int n = 0; n < 3; ++n)
        u[n] = t * (k_r * L[n]);
    rotor_law(law, lanes_dot(u, u), cf);
}

/** L along x, y and r; of a sphere, in space. */
VTI_INLINE void rotor_spin(const struct rotor_body *body, const struct rotor_axes *at, const lanes L[3], lanes p[3])
{
    lanes r[3];
    lanes_rotate(body->q, body->scale, -1.0, L, r);
    rotor_onto(at, r, p);
    for (int n = 0; n < 3; ++n)
        p[n] = lanes_where(body->round, L[n], p[n]);
}

/** All turns as one, d, which is that about L as it comes. In space the turn about L is the last; in the body it is one
 *  about p = R_p^T L before all others: (c0, f0 u) b. M4 adds the turn by sigma L, of e_x p. Of a sphere there are no
 *  others, and d stays, to the bit. */
VTI_INLINE void rotor_join(int rotor, const struct rotor_body *body, const struct rotor_axes *at,
                           const struct rotor_list *list, const lanes p[3], lanes e_x, struct rotor_increment *d)
{
    const lanes *const b = list->b;
    lanes x[3], v[3], w = d->c;
    for (int n = 0; n < 3; ++n)
        v[n] = d->f * d->u[n];
    if (rotor == 4) {
        lanes s[3], more[2];
        for (int n = 0; n < 3; ++n)
            s[n] = list->sigma * (e_x * p[n]);
        rotor_law(VTI_LAW_EXACT, lanes_dot(s, s), more);
        for (int n = 0; n < 3; ++n)
            s[n] *= more[1];
        w = d->c * more[0] - lanes_dot(v, s);
        for (int n = 0; n < 3; ++n)
            v[n] = d->c * s[n] + more[0] * v[n];
    }
    lanes_cross(v, b, x);
    const lanes c = w * b[3] - lanes_dot(v, b);
    for (int n = 0; n < 3; ++n)
        x[n] = (w * b[n] + b[3] * v[n]) + x[n];
    rotor_off(at, x, v);
    if (body->turned)
        lanes_rotate(body->q, body->scale, 1.0, v, v);
    const lanes in_space = lanes_of(1.0);
    d->side = lanes_where(body->round, in_space, body->turned ? in_space : -in_space);
    d->c = lanes_where(body->round, d->c, c);
    d->f = lanes_where(body->round, d->f, in_space);
    for (int n = 0; n < 3; ++n)
        d->u[n] = lanes_where(body->round, d->u[n], v[n]);
}

/** The increment of a drift of time t, with spin L. */
VTI_INLINE void rotor_drift(int law, int rotor, lanes t, const struct rotor_body *body, const lanes L[3],
                            struct rotor_increment *d)
{
    const struct rotor_axes at = rotor_axes_of(body->m, body->k);
    const lanes e_x = t * at.d_x, e_y = t * at.d_y;
    struct rotor_list list;
    lanes p[3], cf[2];
    list.law = law;
    list.hard = list.watches = 0;
    rotor_spin(body, &at, L, p);
    rotor_list_of(rotor, e_x, e_y, p, &list);
    rotor_about_L(law, t, at.k_r, p, d->u, cf);
    d->c = cf[0];
    d->f = cf[1];
    rotor_join(rotor, body, &at, &list, p, e_x, d);
}

/** The largest turn of it. */
VTI_INLINE lanes rotor_most(int law, int rotor, lanes t, const struct rotor_body *body, const lanes L[3])
{
    const struct rotor_axes at = rotor_axes_of(body->m, body->k);
    struct rotor_list list;
    lanes u[3], p[3];
    list.law = law;
    list.hard = 0;
    list.watches = 1;
    rotor_spin(body, &at, L, p);
    rotor_list_of(rotor, t * at.d_x, t * at.d_y, p, &list);
    for (int n = 0; n < 3; ++n)
        u[n] = t * (at.k_r * p[n]);
    return rotor_worst(list.most, lanes_sqrt(lanes_dot(u, u)));
}

#endif
