/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Turns of a body about its axes x and y, and the lists of them that make a drift (vti_rotor.h): Strang, M4 and S10.
 * Several lists go on side by side. */
#ifndef VTI_ROTOR_TURNS_H
#define VTI_ROTOR_TURNS_H

#include "../vti_move.h"
#include "../vti_moments.h"
#include "vti_rotor_axes.h"

/** The larger of the two; but a turn that has reached 1, or is NaN, stays. */
VTI_INLINE lanes rotor_worst(lanes a, lanes b)
{
    return lanes_where(a < 1.0, lanes_where(b <= a, a, b), a);
}

/** Before a loop over lists that go on side by side: their numbers are to stay in registers. */
#if defined(__clang__)
#define ROTOR_UNROLLED _Pragma("unroll")
#elif defined(__GNUC__)
#define ROTOR_UNROLLED _Pragma("GCC unroll 8")
#else
#define ROTOR_UNROLLED
#endif

/* ---- one turn ---------------------------------------------------------------------------------------------------- */

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

/** Turns are cut off at so many radians; beyond, rounding has lost their fraction of a full turn. */
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
 *      (c1, s1 e_x) (c2, s2 e_y) (c, s e_x) = (c2 (c1 c - s1 s), c2 (c1 s + s1 c), s2 (c1 c + s1 s), s2 (s1 c - c1
 *      s)). */
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

/* ---- lists ------------------------------------------------------------------------------------------------------- */

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

#endif
