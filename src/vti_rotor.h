/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How a body of three moments drifts (EQUATIONS 7.2): a turn about L in space, and turns about two of its principal
 * axes. With r the axis of the middle k = 1/moment (ties: lowest number), x and y the two others, d_i = k_i - k_r and
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
    lanes_mask first, second; /* r is axis 0; or else 1; or else 2 */
    lanes_mask swapped;       /* x, y = r + 2, r + 1, and x, y, -r are right-handed */
    lanes k_r, d_x, d_y;
};

/** v_r, v_{r+1}, v_{r+2} */
VTI_INLINE void rotor_from_r(const struct rotor_axes *at, const lanes v[3], lanes c[3])
{
    for (int n = 0; n < 3; ++n)
        c[n] = lanes_where(at->first, v[n], lanes_where(at->second, v[(n + 1) % 3], v[(n + 2) % 3]));
}

VTI_INLINE struct rotor_axes rotor_axes_of(const lanes k[3])
{
    struct rotor_axes at;
    lanes c[3];
    const lanes low = lanes_where(k[0] < k[1], k[0], k[1]), high = lanes_where(k[0] < k[1], k[1], k[0]);
    const lanes rest = lanes_where(high < k[2], high, k[2]), middle = lanes_where(low < rest, rest, low);
    at.first = k[0] == middle;
    at.second = k[1] == middle;
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
    for (int n = 0; n < 3; ++n)
        v[n] = lanes_where(at->first, c[n], lanes_where(at->second, c[(n + 2) % 3], c[(n + 1) % 3]));
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

/** b <- b (c, s e_i), and unless this is the last, (p_j, p_k) <- (C p_j + S p_k, C p_k - S p_j), i, j, k cyclic, with
 *      C = (c - s)(c + s)/(c^2 + s^2),  S = 2 c s/(c^2 + s^2). */
VTI_INLINE void rotor_turn_by(struct rotor_list *list, int i, int last, lanes c, lanes s)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    lanes *const p = list->p, *const b = list->b;
    if (!last) {
        const lanes inv = 1.0 / (c * c + s * s), C = (c - s) * (c + s) * inv, S = 2.0 * c * s * inv;
        const lanes p_j = C * p[j] + S * p[k];
        p[k] = C * p[k] - S * p[j];
        p[j] = p_j;
    }
    const lanes b_i = c * b[i] + s * b[3], b_j = c * b[j] + s * b[k];
    b[3] = c * b[3] - s * b[i];
    b[k] = c * b[k] - s * b[j];
    b[i] = b_i;
    b[j] = b_j;
}

/** The turn about axis i, 0 or 1, by tau of its whole. */
VTI_INLINE void rotor_turn(struct rotor_list *list, int rotor, int i, lanes tau, int last)
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
    rotor_turn_by(list, i, last, c[0], s);
}

/** Strang: x 1/2, y 1, x 1/2, order 2. */
VTI_INLINE void rotor_strang(struct rotor_list *list)
{
    rotor_turn(list, 2, 0, lanes_of(0.5), 0);
    rotor_turn(list, 2, 1, lanes_of(1.0), 0);
    rotor_turn(list, 2, 0, lanes_of(0.5), 1);
}

/** M4: x a, y 1/2, x 1 - 2 a, y 1/2, x a, order 4 with the turns by phi2 and sigma. Here p is in units of 1/(t d_x), so
 *  that rho = -d_y/d_x is all that is left of the moments, and g = d_y/d_x (1 - 6 a + 6 a^2)/12. */
VTI_INLINE void rotor_m4(struct rotor_list *list)
{
    const lanes rho = -list->by[1], root = lanes_sqrt(48.0 + 96.0 * rho + 36.0 * rho * rho);
    const lanes a = (12.0 + 6.0 * rho - root) * (1.0 / 24.0), middle = 1.0 - 2.0 * a;
    list->g = list->by[1] * ((1.0 - 6.0 * a + 6.0 * a * a) * (1.0 / 12.0));
    list->square = list->p[0] * list->p[0] + list->p[1] * list->p[1] + list->p[2] * list->p[2];
    rotor_turn(list, 4, 0, a, 0);
    rotor_turn(list, 4, 1, lanes_of(0.5), 0);
    rotor_turn(list, 4, 0, middle, 0);
    rotor_turn(list, 4, 1, lanes_of(0.5), 0);
    rotor_turn(list, 4, 0, a, 1);
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
    for (int n = 0; n < 10; ++n) {
        rotor_turn(list, 6, 0, lanes_of(x[n <= 5 ? n : 10 - n]), 0);
        rotor_turn(list, 6, 1, lanes_of(y[n <= 4 ? n : 9 - n]), 0);
    }
    rotor_turn(list, 6, 0, lanes_of(x[0]), 1);
}

/* ---- a drift ----------------------------------------------------------------------------------------------------- */

/** A body: the quaternion q ~ R_p (v, w), 2/q.q, its moments, and 1/moments. */
struct rotor_body {
    lanes q[4], scale, m[3], k[3];
};

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

/** The list of turns of a drift: by e_x = t d_x and e_y = t d_y of L. */
VTI_INLINE void rotor_list_of(int rotor, const struct rotor_body *body, const struct rotor_axes *at, const lanes L[3],
                              lanes e_x, lanes e_y, struct rotor_list *list)
{
    lanes p[3];
    lanes_rotate(body->q, body->scale, -1.0, L, p);
    rotor_onto(at, p, list->p);
    list->b[0] = list->b[1] = list->b[2] = list->sigma = list->most = lanes_of(0.0);
    list->b[3] = lanes_of(1.0);
    list->by[0] = e_x;
    list->by[1] = e_y;
    if (rotor == 4) {
        for (int n = 0; n < 3; ++n)
            list->p[n] *= e_x;
        list->by[0] = lanes_of(1.0);
        list->by[1] = e_y / lanes_where(e_x == 0.0, list->by[0], e_x);
        rotor_m4(list);
    } else if (rotor == 6)
        rotor_s10(list);
    else
        rotor_strang(list);
}

/** An increment 2 f u/c in space. */
struct rotor_increment {
    lanes c, f, u[3];
    lanes_mask plain; /* it is the turn about L and nothing else */
};

/** (c0, f0 u)(b_w, R_p b_v), the turn about L, to which M4 adds that by sigma L, after all others. Where there are no
 *  others, it is the sphere's, to the bit. */
VTI_INLINE void rotor_join(int rotor, const struct rotor_body *body, const struct rotor_axes *at,
                           const struct rotor_list *list, const lanes L[3], lanes e_x, const lanes cf[2],
                           struct rotor_increment *d)
{
    const lanes_mask plain = (list->b[0] == 0.0) & (list->b[1] == 0.0) & (list->b[2] == 0.0) & (list->sigma == 0.0);
    lanes b[3], x[3], v[3], w = cf[0];
    rotor_off(at, list->b, b);
    lanes_rotate(body->q, body->scale, 1.0, b, b);
    for (int n = 0; n < 3; ++n)
        v[n] = cf[1] * d->u[n];
    if (rotor == 4) {
        lanes s[3], more[2];
        for (int n = 0; n < 3; ++n)
            s[n] = list->sigma * (e_x * L[n]);
        rotor_law(VTI_LAW_EXACT, lanes_dot(s, s), more);
        for (int n = 0; n < 3; ++n)
            s[n] *= more[1];
        w = cf[0] * more[0] - lanes_dot(v, s);
        for (int n = 0; n < 3; ++n)
            v[n] = cf[0] * s[n] + more[0] * v[n];
    }
    lanes_cross(v, b, x);
    d->plain = plain;
    d->c = lanes_where(plain, cf[0], w * list->b[3] - lanes_dot(v, b));
    d->f = lanes_where(plain, cf[1], lanes_of(1.0));
    for (int n = 0; n < 3; ++n)
        d->u[n] = lanes_where(plain, d->u[n], (w * b[n] + list->b[3] * v[n]) + x[n]);
}

/** The increment of a drift of time t, with spin L. */
VTI_INLINE void rotor_drift(int law, int rotor, lanes t, const struct rotor_body *body, const lanes L[3],
                            struct rotor_increment *d)
{
    const struct rotor_axes at = rotor_axes_of(body->k);
    const lanes e_x = t * at.d_x, e_y = t * at.d_y;
    struct rotor_list list;
    list.law = law;
    list.hard = list.watches = 0;
    rotor_list_of(rotor, body, &at, L, e_x, e_y, &list);
    for (int n = 0; n < 3; ++n)
        d->u[n] = t * (at.k_r * L[n]);
    lanes cf[2];
    rotor_law(law, lanes_dot(d->u, d->u), cf);
    rotor_join(rotor, body, &at, &list, L, e_x, cf, d);
}

/** The largest turn of it. */
VTI_INLINE lanes rotor_most(int law, int rotor, lanes t, const struct rotor_body *body, const lanes L[3])
{
    const struct rotor_axes at = rotor_axes_of(body->k);
    struct rotor_list list;
    lanes u[3];
    list.law = law;
    list.hard = 0;
    list.watches = 1;
    rotor_list_of(rotor, body, &at, L, t * at.d_x, t * at.d_y, &list);
    for (int n = 0; n < 3; ++n)
        u[n] = t * (at.k_r * L[n]);
    return rotor_worst(list.most, lanes_sqrt(lanes_dot(u, u)));
}

#endif
