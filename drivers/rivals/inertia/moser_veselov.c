/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Discrete rigid bodies whose turn R_p <- R_p F is found from g = h p, p = R_p^T L, by an equation. In the Rodrigues
 * vector a of F, J = diag(A, B, C):
 *
 *     4/(4 + |a|^2) (J a + a x J a/2) = g      J. Moser, A. P. Veselov, Discrete versions of some classical integrable
 *                                              systems and factorization of matrix polynomials, Commun. Math. Phys.
 *                                              139, 217 (1991); the paper's VTI-1 for bodies that are no spheres
 *     J a + a x J a/2 = g                      the implicit midpoint rule; the paper's VTI-2
 *
 * Newton's method from a = J^-1 g solves both. The first has a solution in closed form too (EQUATIONS 7.3). With D =
 * diag((B + C - A)/2, ...) and Z = F D one has Z^T Z = D^2, Z - Z^T = S(g), and Z's eigenvalues are square roots of the
 * roots of a cubic. Of their symmetric functions e1 = tr Z, e2, e3 = D1 D2 D3, e1 is the largest root of
 *
 *     (e1^2 - s1)^2 - 8 e3 e1 - 4 s2 = 0,  s1 = tr D^2 - |g|^2,
 *     s2 = D1^2 D2^2 + D2^2 D3^2 + D3^2 D1^2 - sum g_i^2 D_i^2,
 *
 * to which Newton's method falls from tr D, and e2 = (e1^2 - s1)/2. Z = M + G, G = S(g)/2, has the symmetric part
 *
 *     (2 D^2 G - e1 D^2 - e3) M = -e3 G - D^4 - 2 D^2 G^2 + e1 D^2 G - e2 D^2.
 *
 * Flat bodies (C = A + B), of which D_3 = 0, make this singular; they take Newton's method for a. */
#include "general.h"

enum { ITERATIONS = 60 };

/** q <- q F for the Rodrigues vector a of F. */
VTI_INLINE void turn_by(const double a[3], double q[4])
{
    double r[4];
    general_turned(2.0, a, q, r);
    quat_unit_of(r, q);
}

/* ---- by Newton's method ------------------------------------------------------------------------------------------ */

/** N = J a + a x J a/2, and its gradient J + (S(a) J - S(J a))/2 by columns. */
VTI_INLINE void midpoint_map(const double J[3], const double a[3], double N[3], double column[3][3])
{
    const double p[3] = {J[0] * a[0], J[1] * a[1], J[2] * a[2]};
    vti_cross(a, p, N);
    for (int i = 0; i < 3; ++i)
        N[i] = p[i] + 0.5 * N[i];
    for (int j = 0; j < 3; ++j) {
        const int k = (j + 1) % 3, l = (j + 2) % 3; /* a x e_j = a_l e_k - a_k e_l */
        column[j][j] = J[j];
        column[j][k] = 0.5 * (a[l] * J[j] - p[l]);
        column[j][l] = 0.5 * (p[k] - a[k] * J[j]);
    }
}

/** Times c = 4/(4 + a.a): the gradient becomes c grad N - (c^2/2) N a^T. */
VTI_INLINE void moser_veselov_map(const double J[3], const double a[3], double N[3], double column[3][3])
{
    const double c = 4.0 / (4.0 + vti_dot(a, a));
    midpoint_map(J, a, N, column);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            column[j][i] = c * (column[j][i] - 0.5 * c * N[i] * a[j]);
    for (int i = 0; i < 3; ++i)
        N[i] *= c;
}

typedef void increment_map(const double J[3], const double a[3], double N[3], double column[3][3]);

/** a with map(a) = g: 0; or -1. A correction of 1e-9 leaves the next one below rounding. */
VTI_INLINE int by_newton(const double J[3], const double k[3], const double g[3], increment_map *map, double a[3])
{
    for (int i = 0; i < 3; ++i)
        a[i] = k[i] * g[i];
    for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
        double N[3], column[3][3], d[3];
        map(J, a, N, column);
        const double off[3] = {g[0] - N[0], g[1] - N[1], g[2] - N[2]};
        vector_solve(column[0], column[1], column[2], off, d);
        for (int i = 0; i < 3; ++i)
            a[i] += d[i];
        if (vti_dot(d, d) <= 1e-18 * vti_dot(a, a))
            return 0;
    }
    return -1;
}

VTI_INLINE int newton_turn(double h, const double J[3], const double k[3], const double L[3], increment_map *map,
                           double q[4])
{
    double g[3], a[3];
    vti_pair_rotate(q, -1.0, L, g);
    for (int i = 0; i < 3; ++i)
        g[i] *= h;
    if (by_newton(J, k, g, map, a) != 0)
        return -1;
    turn_by(a, q);
    return 0;
}

VTI_INLINE int midpoint(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    return newton_turn(h, I, k, L, midpoint_map, q);
}

VTI_INLINE int iterated(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    return newton_turn(h, I, k, L, moser_veselov_map, q);
}

/* ---- in closed form ---------------------------------------------------------------------------------------------- */

/** The largest root e1 of (e1^2 - s1)^2 - 8 e3 e1 - 4 s2, from above; NaN if there is none. */
VTI_INLINE double largest_root(double from, double s1, double s2, double e3)
{
    double e = from;
    for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
        const double d = e * e - s1, slope = 4.0 * e * d - 8.0 * e3,
                     next = e - (d * d - 8.0 * e3 * e - 4.0 * s2) / slope;
        if (!(slope > 0.0))
            return NAN;
        if (!(next < e)) /* rounding has stopped it */
            return e;
        e = next;
    }
    return NAN;
}

/** F of g = h p by rows; -1 if there is none. D has no 0. */
VTI_INLINE int closed_turn(const double D[3], const double g[3], double F[9])
{
    const double square[3] = {D[0] * D[0], D[1] * D[1], D[2] * D[2]}, gg = vti_dot(g, g), e3 = D[0] * D[1] * D[2];
    const double s1 = square[0] + square[1] + square[2] - gg,
                 s2 = square[0] * square[1] + square[1] * square[2] + square[2] * square[0] -
                      (g[0] * g[0] * square[0] + g[1] * g[1] * square[1] + g[2] * g[2] * square[2]);
    const double e1 = largest_root(D[0] + D[1] + D[2], s1, s2, e3), e2 = 0.5 * (e1 * e1 - s1);
    const double G[3][3] = {
        {0.0, -0.5 * g[2], 0.5 * g[1]}, {0.5 * g[2], 0.0, -0.5 * g[0]}, {-0.5 * g[1], 0.5 * g[0], 0.0}};
    double left[3][3], right[3][3]; /* by columns */
    if (isnan(e1))
        return -1;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double on = i == j, G2 = 0.25 * (g[i] * g[j] - on * gg);
            left[j][i] = 2.0 * square[i] * G[i][j] - on * (e1 * square[i] + e3);
            right[j][i] = (e1 * square[i] - e3) * G[i][j] - 2.0 * square[i] * G2 - on * square[i] * (square[i] + e2);
        }
    for (int j = 0; j < 3; ++j) {
        double M[3];
        vector_solve(left[0], left[1], left[2], right[j], M);
        for (int i = 0; i < 3; ++i)
            F[3 * i + j] = (M[i] + G[i][j]) / D[j];
    }
    return 0;
}

/** q <- q F */
VTI_INLINE int closed(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    static const double flat = 0x1p-10;
    const double D[3] = {0.5 * (I[1] + I[2] - I[0]), 0.5 * (I[2] + I[0] - I[1]), 0.5 * (I[0] + I[1] - I[2])};
    const double least = flat * (D[0] + D[1] + D[2]);
    double g[3], F[9], pair[4], r[4];
    if (D[0] < least || D[1] < least || D[2] < least)
        return iterated(h, I, k, L, q);
    vti_pair_rotate(q, -1.0, L, g);
    for (int i = 0; i < 3; ++i)
        g[i] *= h;
    if (closed_turn(D, g, F) != 0)
        return -1;
    vti_rrv_pair_from_matrix(F, pair);
    general_turned(pair[3], pair, q, r);
    quat_unit_of(r, q);
    return 0;
}

GENERAL_RIVAL(
    rival_moser_veselov, closed, 2, "moser-veselov",
    "velocity Verlet by L, the discrete body of Moser and Veselov (1991) in closed form: the paper's VTI-1 for "
    "bodies of three moments")
GENERAL_RIVAL(rival_moser_veselov_newton, iterated, 2, "moser-veselov-newton",
              "the same, its equation solved by Newton's method; bodies of three moments")
GENERAL_RIVAL(rival_midpoint, midpoint, 2, "implicit-midpoint",
              "velocity Verlet by L, the implicit midpoint rule by Newton's method: the paper's VTI-2 for bodies of "
              "three moments")
