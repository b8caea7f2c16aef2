/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The formulas of EQUATIONS 2 and 3 as they stand there, with rotation matrices. Nothing of the library is used
 * here. */
#include <math.h>
#include <string.h>

#include "torus_quad.h"

__extension__ typedef __float128 quad;

/* of libquadmath; its header is not on every compiler's path */
quad sqrtq(quad x);
quad sinq(quad x);
quad cosq(quad x);
quad asinq(quad x);
quad acosq(quad x);

enum { N = 80 };

struct ring {
    quad x[N][3], v[N][3], R[N][3][3], w[N][3], F[N][3], T[N][3];
    quad n0[N][3], L0[N]; /* of the bond (k, k + 1 mod N) */
    quad moment, axial, shear, contact, wall;
    int printed;
};

static const int K_MOMENT = 10, K_AXIAL = 200, K_SHEAR = 200, K_CONTACT = 2100;

/* ---- vectors and matrices ---------------------------------------------------------------------------------------- */

static quad dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static quad norm(const quad a[3])
{
    return sqrtq(dot(a, a));
}

static void cross(const quad a[3], const quad b[3], quad r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void product(quad A[3][3], quad B[3][3], quad C[3][3])
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

static void transpose(quad A[3][3], quad B[3][3])
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            B[i][j] = A[j][i];
}

static void apply(quad A[3][3], const quad v[3], quad r[3])
{
    for (int i = 0; i < 3; ++i)
        r[i] = dot(A[i], v);
}

/** R(alpha) = I + 4/(4 + |alpha|^2) [S + S^2/2] */
static void rotation(const quad a[3], quad R[3][3])
{
    quad S[3][3] = {{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}}, S2[3][3];
    product(S, S, S2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            R[i][j] = (i == j) + 4 / (4 + dot(a, a)) * (S[i][j] + S2[i][j] / 2);
}

/** log R: the skew part is sin(theta) times the axis, the trace 1 + 2 cos(theta). */
static void logarithm(quad R[3][3], quad theta[3])
{
    const quad s[3] = {(R[2][1] - R[1][2]) / 2, (R[0][2] - R[2][0]) / 2, (R[1][0] - R[0][1]) / 2};
    const quad sine = norm(s), cosine = (R[0][0] + R[1][1] + R[2][2] - 1) / 2;
    const quad angle = cosine > sine ? asinq(sine) : acosq(cosine);
    for (int k = 0; k < 3; ++k)
        theta[k] = sine > 0 ? angle / sine * s[k] : 0;
}

/* ---- loads and energies ------------------------------------------------------------------------------------------ */

/** Adds the pair of forces f n on i and -f n on j. */
static void push(struct ring *r, int i, int j, quad f, const quad n[3])
{
    for (int k = 0; k < 3; ++k) {
        r->F[i][k] += f * n[k];
        r->F[j][k] -= f * n[k];
    }
}

static void moment_and_axial(struct ring *r, int i, int j, quad length, const quad n[3])
{
    quad back[3][3], relative[3][3], theta[3];
    transpose(r->R[j], back);
    product(r->R[i], back, relative);
    logarithm(relative, theta);
    for (int k = 0; k < 3; ++k) {
        r->T[i][k] -= K_MOMENT * theta[k];
        r->T[j][k] += K_MOMENT * theta[k];
    }
    r->moment += dot(theta, theta) * K_MOMENT / 2;
    const quad stretch = length / r->L0[i] - 1;
    push(r, i, j, -K_AXIAL / r->L0[i] * stretch, n);
    r->axial += stretch * stretch * K_AXIAL / 2;
}

/** U = K (1 - mh.n), F_i = (K/r) P mh, T_a = b_a x (K/L)(n - c mh) */
static void objective(struct ring *r, int i, int j, quad length, const quad n[3])
{
    quad bi[3], bj[3], m[3], P[3], pull[3], t[3];
    apply(r->R[i], r->n0[i], bi);
    apply(r->R[j], r->n0[i], bj);
    for (int k = 0; k < 3; ++k)
        m[k] = bi[k] + bj[k];
    const quad L = norm(m);
    for (int k = 0; k < 3; ++k)
        m[k] /= L;
    const quad c = dot(m, n);
    for (int k = 0; k < 3; ++k) {
        P[k] = m[k] - c * n[k];
        pull[k] = K_SHEAR / L * (n[k] - c * m[k]);
    }
    push(r, i, j, K_SHEAR / length, P);
    cross(bi, pull, t);
    for (int k = 0; k < 3; ++k)
        r->T[i][k] += t[k];
    cross(bj, pull, t);
    for (int k = 0; k < 3; ++k)
        r->T[j][k] += t[k];
    r->shear += K_SHEAR * (1 - c);
}

/** c = (R_i n0).(R_j n), g = R_j^T R_i n0, U = K/2 (1 - c)^2, F_i = (K(1 - c)/r) P g, T_i = K(1 - c)(R_i n0) x (R_j
 *  n) */
static void printed(struct ring *r, int i, int j, quad length, const quad n[3])
{
    quad bi[3], nj[3], g[3], P[3], back[3][3], t[3];
    apply(r->R[i], r->n0[i], bi);
    apply(r->R[j], n, nj);
    transpose(r->R[j], back);
    apply(back, bi, g);
    const quad c = dot(bi, nj), along = dot(g, n), k1 = K_SHEAR * (1 - c);
    for (int k = 0; k < 3; ++k)
        P[k] = g[k] - along * n[k];
    push(r, i, j, k1 / length, P);
    cross(bi, nj, t);
    for (int k = 0; k < 3; ++k) {
        r->T[i][k] += k1 * t[k];
        r->T[j][k] -= k1 * t[k];
    }
    r->shear += K_SHEAR * (1 - c) * (1 - c) / 2;
}

/** d = x_i - x_j, n = d/|d|; returns |d|. */
static quad direction(const struct ring *r, int i, int j, quad n[3])
{
    for (int k = 0; k < 3; ++k)
        n[k] = r->x[i][k] - r->x[j][k];
    const quad length = norm(n);
    for (int k = 0; k < 3; ++k)
        n[k] /= length;
    return length;
}

/** 1 if i and j are surely apart, judged in double precision with room to spare. */
static int apart(const struct ring *r, int i, int j, double D)
{
    double d2 = 0;
    for (int k = 0; k < 3; ++k) {
        const double d = (double)r->x[i][k] - (double)r->x[j][k];
        d2 += d * d;
    }
    return d2 > 1.01 * D * D;
}

/** U = 2/5 K [1 - r/D]^{5/2}, F_i = (K/D) [1 - r/D]^{3/2} n between all that are not bonded; a wall at x = 0 has
 *  D/2. */
static void contacts(struct ring *r, quad D)
{
    quad n[3];
    for (int i = 0; i < N; ++i)
        for (int j = i + 1; j < N; ++j) {
            if (j == i + 1 || (i == 0 && j == N - 1) || apart(r, i, j, (double)D))
                continue;
            const quad o = 1 - direction(r, i, j, n) / D;
            if (o > 0) {
                push(r, i, j, K_CONTACT / D * o * sqrtq(o), n);
                r->contact += K_CONTACT * o * o * sqrtq(o) * 2 / 5;
            }
        }
    for (int i = 0; i < N; ++i) {
        const quad o = 1 - r->x[i][0] / (D / 2);
        if (o > 0) {
            r->F[i][0] += K_CONTACT / (D / 2) * o * sqrtq(o);
            r->wall += K_CONTACT * o * o * sqrtq(o) * 2 / 5;
        }
    }
}

static void loads(struct ring *r, quad D)
{
    memset(r->F, 0, sizeof r->F);
    memset(r->T, 0, sizeof r->T);
    r->moment = r->axial = r->shear = r->contact = r->wall = 0;
    for (int i = 0; i < N; ++i) {
        const int j = (i + 1) % N;
        quad n[3];
        const quad length = direction(r, i, j, n);
        moment_and_axial(r, i, j, length, n);
        (r->printed ? printed : objective)(r, i, j, length, n);
    }
    contacts(r, D);
}

/* ---- motion ------------------------------------------------------------------------------------------------------ */

/** m = J = 1: v += t F, Omega += t T. */
static void kick(struct ring *r, quad t)
{
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < 3; ++k) {
            r->v[i][k] += t * r->F[i][k];
            r->w[i][k] += t * r->T[i][k];
        }
}

/** x += t v, R <- R(t Omega) R */
static void drift(struct ring *r, quad t)
{
    for (int i = 0; i < N; ++i) {
        quad a[3], turn[3][3], R[3][3];
        for (int k = 0; k < 3; ++k) {
            r->x[i][k] += t * r->v[i][k];
            a[k] = t * r->w[i][k];
        }
        rotation(a, turn);
        product(turn, r->R[i], R);
        memcpy(r->R[i], R, sizeof R);
    }
}

static quad start(struct ring *r)
{
    const quad pi = 2 * acosq(0), D = 3 * sinq(pi / N);
    memset(r, 0, sizeof *r);
    for (int k = 0; k < N; ++k) {
        r->x[k][0] = (3 + D) / 2 + 3 * cosq(2 * pi * k / N) / 2;
        r->x[k][1] = 3 * sinq(2 * pi * k / N) / 2;
        r->v[k][0] = -1;
        r->R[k][0][0] = r->R[k][1][1] = r->R[k][2][2] = 1;
    }
    for (int k = 0; k < N; ++k)
        r->L0[k] = direction(r, k, (k + 1) % N, r->n0[k]);
    return D;
}

static void record(const struct ring *r, double e[TORUS_ENERGIES])
{
    quad translation = 0, rotation_ = 0;
    for (int i = 0; i < N; ++i) {
        translation += dot(r->v[i], r->v[i]) / 2;
        rotation_ += dot(r->w[i], r->w[i]) / 2;
    }
    const quad all[TORUS_ENERGIES] = {
        translation, rotation_,
        r->moment,   r->axial,
        r->shear,    r->contact,
        r->wall,     translation + rotation_ + r->moment + r->axial + r->shear + r->contact + r->wall};
    for (int k = 0; k < TORUS_ENERGIES; ++k)
        e[k] = (double)all[k];
}

void torus_quad(int printed_shear, int records, const int *at, double (*energies)[TORUS_ENERGIES])
{
    static struct ring r;
    const quad D = start(&r), h = (quad)1 / 1000;
    r.printed = printed_shear;
    loads(&r, D);
    for (int step = 1, k = 0; k < records; ++step) {
        kick(&r, h / 2);
        drift(&r, h);
        loads(&r, D);
        kick(&r, h / 2);
        if (step == at[k])
            record(&r, energies[k++]);
    }
}
