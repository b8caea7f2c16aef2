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

#include "../lanes/vti_lanes.h"
#include "../vti_move.h"

VTI_MOVE_LAW(rotor_law, lanes, lanes_of, lanes_sqrt)

/** The larger of the two; but a turn that has reached 1, or is NaN, stays. */
VTI_INLINE lanes rotor_worst(lanes a, lanes b)
{
    return lanes_where(a < 1.0, lanes_where(b <= a, a, b), a);
}

/* ---- axes -------------------------------------------------------------------------------------------------------- */

/** Which axes x, y and r are, by up to three pairs that change places. */
struct rotor_axes {
    lanes_mask second, first; /* r is axis 1; axis 0; of three equal moments, whichever */
    lanes_mask swapped;       /* |d_y| > |d_x| but for the last exchange */
    lanes odd;                /* -0 where x, y, -r are right-handed, else 0 */
};

/** The moments m along the two other axes, in any order, and r; and m_y (m_r - m_x), m_x (m_r - m_y). */
struct rotor_moments {
    lanes m[3], off[2];
};

VTI_INLINE void rotor_swap(lanes_mask where, lanes *a, lanes *b)
{
    const lanes c = lanes_where(where, *b, *a);
    *b = lanes_where(where, *a, *b);
    *a = c;
}

/** An axis is in the middle if the next one's moment is above its own and the other's is not, or the other way round.
 *  d_i = (m_r - m_i)/(m_r m_i). */
VTI_INLINE struct rotor_axes rotor_axes_of(const lanes m[3], struct rotor_moments *along)
{
    struct rotor_axes at;
    lanes *const a = along->m, *const off = along->off;
    const lanes_mask rises = m[0] < m[1];
    at.second = rises ^ (m[1] >= m[2]);
    at.first = rises ^ (m[2] >= m[0]);
    for (int n = 0; n < 3; ++n)
        a[n] = m[n];
    rotor_swap(at.second, a + 1, a + 2);
    rotor_swap(at.first, a, a + 2);
    off[0] = (a[2] - a[0]) * a[1];
    off[1] = (a[2] - a[1]) * a[0];
    at.swapped = lanes_abs(off[1]) > lanes_abs(off[0]);
    rotor_swap(at.swapped, off, off + 1);
    at.odd = lanes_where(at.second ^ at.first ^ at.swapped, lanes_of(-0.0), lanes_of(0.0));
    return at;
}

/** Components along x, y and what makes them right-handed. */
VTI_INLINE void rotor_onto(const struct rotor_axes *at, const lanes v[3], lanes p[3])
{
    for (int n = 0; n < 3; ++n)
        p[n] = v[n];
    rotor_swap(at->second, p + 1, p + 2);
    rotor_swap(at->first, p, p + 2);
    rotor_swap(at->swapped, p, p + 1);
    p[2] = lanes_flip(p[2], at->odd);
}

/** The way back. */
VTI_INLINE void rotor_off(const struct rotor_axes *at, const lanes p[3], lanes v[3])
{
    v[0] = p[0];
    v[1] = p[1];
    v[2] = lanes_flip(p[2], at->odd);
    rotor_swap(at->swapped, v, v + 1);
    rotor_swap(at->first, v, v + 2);
    rotor_swap(at->second, v + 1, v + 2);
}

/** A body: the quaternion q ~ R_p (v, w), q.q, and its moments. */
struct rotor_body {
    lanes q[4], square, m[3];
    int turned; /* its principal axes are not the body's own */
};

/** t k_r, t d_x/2 and t d_y/2, which one division gives together. */
struct rotor_rates {
    lanes turn, half[2];
    lanes range; /* of numbers, in which what is divided by stays where this is below ROTOR_RANGE */
};

#define ROTOR_RANGE 0x1p900

VTI_INLINE struct rotor_rates rotor_rates_of(double t, const struct rotor_moments *along)
{
    const lanes both = along->m[0] * along->m[1], all = both * along->m[2], inv = 1.0 / all, half = (0.5 * t) * inv;
    struct rotor_rates rates = {
        .turn = both * (t * inv), .half = {along->off[0] * half, along->off[1] * half}, .range = all + inv};
    if (WIDTH == 1 && !lanes_all(rates.range < ROTOR_RANGE)) { /* one by one */
        rates.turn = t * (1.0 / along->m[2]);
        for (int n = 0; n < 2; ++n)
            rates.half[n] = (0.5 * t) * (((along->off[n] / along->m[2]) / along->m[0]) / along->m[1]);
    }
    return rates;
}

/** Before a loop over lists that go on side by side: their numbers are to stay in registers. */
#if defined(__clang__)
#define ROTOR_UNROLLED _Pragma("unroll")
#elif defined(__GNUC__)
#define ROTOR_UNROLLED _Pragma("GCC unroll 8")
#else
#define ROTOR_UNROLLED
#endif

/* ---- turns about x and y ----------------------------------------------------------------------------------------- */

/** What a list of turns has come to. */
struct rotor_list {
    lanes p[3];    /* along x, y and r, times over */
    lanes over;    /* a product of what turns divide by; of Strang alone, else 1 */
    lanes b[4];    /* all turns so far, up to a factor (v, w); before the third, the pairs (s, c) of x and of y */
    lanes most;    /* the largest |phi|, up to the first of 1 or more */
    lanes sigma;   /* of M4 */
    lanes by[2];   /* phi/2 = by_i p_i tau */
    lanes g;       /* of M4: phi2/2 = +- g p_i (K - 2 p_i^2) tau */
    lanes square;  /* of M4: K = p.p */
    lanes outer;   /* of M4: a */
    int law, hard; /* hard: of turns that are beyond all measure, and are cut off */
    int watches;   /* whether most is wanted, and nothing else */
    int divides;   /* over is 1 */
};

/** Beyond so many radians in a step, phi is whatever is finite. */
#define ROTOR_MOST 64.0

/** phi/2 */
VTI_INLINE lanes rotor_cut(const struct rotor_list *list, lanes half)
{
    if (!list->hard)
        return half;
    half = lanes_where(half < 0.5 * ROTOR_MOST, half, lanes_of(0.5 * ROTOR_MOST));
    return lanes_where(half > -0.5 * ROTOR_MOST, half, lanes_of(-0.5 * ROTOR_MOST));
}

/** Where a turn stands in its list; ROTOR_ALL is the third and the last. */
enum rotor_place { ROTOR_FIRST, ROTOR_SECOND, ROTOR_THIRD, ROTOR_ALL, ROTOR_INNER, ROTOR_LAST };

/** The pair (c, s) of the turn by phi = 2 a/b, up to a factor, which is 1 where b is:
 *      closed (1 + sqrt(1 - phi^2), phi)     exact (1 - phi^2/10, phi/2 - phi^3/120)
 *      Cayley (2, phi)                       exact9 (1 - 3 phi^2/28 + phi^4/1680, phi/2 - phi^3/84)
 *  b is known to be 1 where it is, and of the closed law. */
VTI_INLINE void rotor_pair(int law, int one, lanes a, lanes b, lanes cs[2])
{
    const lanes aa = a * a, bb = one ? lanes_of(1.0) : b * b;
    if (law == VTI_LAW_CLOSED) {
        cs[0] = 1.0 + lanes_sqrt(1.0 - 4.0 * aa);
        cs[1] = 2.0 * a;
    } else if (law == VTI_LAW_CAYLEY) {
        cs[0] = one ? bb : b;
        cs[1] = a;
    } else if (law == VTI_LAW_EXACT) {
        cs[0] = bb - 0.4 * aa;
        cs[0] = one ? cs[0] : b * cs[0];
        cs[1] = a * (bb - aa * (1.0 / 15.0));
    } else {
        const lanes far = (3.0 / 7.0) * bb - aa * (1.0 / 105.0), near = bb - aa * (2.0 / 21.0);
        cs[0] = (one ? bb : bb * bb) - aa * far;
        cs[1] = (one ? a : a * b) * near;
    }
}

/** (p_j, p_k) <- (C p_j + S p_k, C p_k - S p_j), i, j, k cyclic, with
 *      C = (c^2 - s^2)/(c^2 + s^2),  S = 2 c s/(c^2 + s^2),
 *  which of the closed law are c - 1 and s; or p times c^2 + s^2, which over takes instead. */
VTI_INLINE void rotor_turn_p(struct rotor_list *list, int twice, enum rotor_place place, int i, const lanes cs[2])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3, closed = list->law == VTI_LAW_CLOSED && !twice;
    const lanes c = cs[0], s = cs[1], cc = c * c, ss = s * s, norm = cc + ss;
    const lanes C = closed ? c - 1.0 : cc - ss, S = closed ? s : 2.0 * c * s;
    lanes *const p = list->p;
    const lanes p_j = C * p[j] + S * p[k], p_k = C * p[k] - S * p[j];
    if (closed || !list->divides) {
        p[j] = p_j;
        p[k] = p_k;
    } else {
        const lanes inv = 1.0 / norm;
        p[j] = p_j * inv;
        p[k] = p_k * inv;
    }
    if (!list->divides) {
        p[i] *= norm;
        list->over = place == ROTOR_FIRST ? norm : list->over * norm;
    }
}

/** b <- b (c, s e_i); the first three turns, about x, y and x, together:
 *      (c1, s1 e_x) (c2, s2 e_y) (c, s e_x) = (c2 (c1 c - s1 s), c2 (c1 s + s1 c), s2 (c1 c + s1 s), s2 (s1 c - c1 s)). */
VTI_INLINE void rotor_turn_b(enum rotor_place place, int i, lanes c, lanes s, lanes b[4])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (place == ROTOR_FIRST || place == ROTOR_SECOND) {
        b[2 * i] = s;
        b[2 * i + 1] = c;
    } else if (place == ROTOR_THIRD || place == ROTOR_ALL) {
        const lanes cc = b[1] * c, ss = b[0] * s, cs = b[1] * s, sc = b[0] * c, s2 = b[2], c2 = b[3];
        b[0] = c2 * (cs + sc);
        b[1] = s2 * (cc + ss);
        b[2] = s2 * (sc - cs);
        b[3] = c2 * (cc - ss);
    } else {
        const lanes b_i = c * b[i] + s * b[3], b_j = c * b[j] + s * b[k];
        b[3] = c * b[3] - s * b[i];
        b[k] = c * b[k] - s * b[j];
        b[i] = b_i;
        b[j] = b_j;
    }
}

/** M4's turn by phi2 = -+ tau g p (2 K - 4 p^2) about the axis of the turn (c, s) before it, p = p_i being as it was
 *  before both; by the exact law whatever the stepper's, as sigma counts on it. */
VTI_INLINE void rotor_turn_on(struct rotor_list *list, lanes g, lanes p, lanes cs[2])
{
    const lanes about_L = g * (p * p), c = cs[0], s = cs[1];
    lanes by[2];
    rotor_pair(VTI_LAW_EXACT, 1, rotor_cut(list, p * (g * list->square - 2.0 * about_L)), list->over, by);
    cs[0] = c * by[0] - s * by[1];
    cs[1] = c * by[1] + s * by[0];
    list->sigma += about_L;
}

/** The turn about axis i, 0 or 1, by tau of its whole. */
VTI_INLINE void rotor_turn(struct rotor_list *list, int rotor, enum rotor_place place, int i, lanes tau)
{
    const lanes p = list->p[i], a = rotor_cut(list, (tau * list->by[i]) * p);
    lanes cs[2];
    if (list->watches)
        list->most = rotor_worst(list->most, 2.0 * lanes_abs(a));
    rotor_pair(list->law, list->divides || place == ROTOR_FIRST, a, list->over, cs);
    if (rotor == 4)
        rotor_turn_on(list, (i == 0 ? -tau : tau) * list->g, p, cs);
    if (place != ROTOR_LAST && place != ROTOR_ALL)
        rotor_turn_p(list, rotor == 4, place, i, cs);
    rotor_turn_b(place, i, cs[0], cs[1], list->b);
}

/** The same turn of so many lists, each by tau of its own: a chain of products each, which a processor carries on with
 *  side by side. */
VTI_INLINE void rotor_turns(struct rotor_list *lists, int count, int rotor, enum rotor_place place, int i, lanes tau)
{
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n)
        rotor_turn(lists + n, rotor, place, i, tau);
}

/** Strang: x 1/2, y 1, x 1/2, order 2. */
VTI_INLINE void rotor_strang(struct rotor_list *lists, int count)
{
    rotor_turns(lists, count, 2, ROTOR_FIRST, 0, lanes_of(0.5));
    rotor_turns(lists, count, 2, ROTOR_SECOND, 1, lanes_of(1.0));
    rotor_turns(lists, count, 2, ROTOR_ALL, 0, lanes_of(0.5));
}

/** M4: x a, y 1/2, x 1 - 2 a, y 1/2, x a, order 4 with the turns by phi2 and sigma. Here p is in units of 2/(t d_x),
 *  so that rho = -d_y/d_x is all that is left of the moments, and g = 8 d_y/d_x (1 - 6 a + 6 a^2)/12. */
VTI_INLINE void rotor_m4(struct rotor_list *lists, int count)
{
    const lanes half = lanes_of(0.5);
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n) {
        struct rotor_list *const list = lists + n;
        const lanes rho = -list->by[1], root = lanes_sqrt(48.0 + 96.0 * rho + 36.0 * rho * rho);
        const lanes a = (12.0 + 6.0 * rho - root) * (1.0 / 24.0);
        list->outer = a;
        list->g = list->by[1] * ((1.0 - 6.0 * a + 6.0 * a * a) * (8.0 / 12.0));
    }
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n)
        rotor_turn(lists + n, 4, ROTOR_FIRST, 0, lists[n].outer);
    rotor_turns(lists, count, 4, ROTOR_SECOND, 1, half);
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n)
        rotor_turn(lists + n, 4, ROTOR_THIRD, 0, 1.0 - 2.0 * lists[n].outer);
    rotor_turns(lists, count, 4, ROTOR_INNER, 1, half);
    ROTOR_UNROLLED
    for (int n = 0; n < count; ++n)
        rotor_turn(lists + n, 4, ROTOR_LAST, 0, lists[n].outer);
}

/** S10 (Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313): order 6, 21 turns, x a1, y b1, x a2, ..., mirrored. */
VTI_INLINE void rotor_s10(struct rotor_list *lists, int count)
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
    rotor_turns(lists, count, 6, ROTOR_FIRST, 0, lanes_of(x[0]));
    rotor_turns(lists, count, 6, ROTOR_SECOND, 1, lanes_of(y[0]));
    rotor_turns(lists, count, 6, ROTOR_THIRD, 0, lanes_of(x[1]));
    for (int n = 1; n < 9; ++n) {
        rotor_turns(lists, count, 6, ROTOR_INNER, 1, lanes_of(y[n <= 4 ? n : 9 - n]));
        rotor_turns(lists, count, 6, ROTOR_INNER, 0, lanes_of(x[n <= 4 ? n + 1 : 9 - n]));
    }
    rotor_turns(lists, count, 6, ROTOR_INNER, 1, lanes_of(y[0]));
    rotor_turns(lists, count, 6, ROTOR_LAST, 0, lanes_of(x[0]));
}

/* ---- a drift ----------------------------------------------------------------------------------------------------- */

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
    return rotor_worst(list.most, lanes_sqrt(from->about_L));
}

#endif
