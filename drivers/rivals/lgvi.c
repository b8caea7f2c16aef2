/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Lie group variational integrator on rotation matrices. With F the increment of the attitude and Omega already
 * kicked by h/2,
 *
 *     h S(J Omega) = F J_d - J_d F^T,   R <- F R
 *
 * In Cayley coordinates, F = (I + S(f)) (I - S(f))^-1, and with u = h Omega for a sphere that is
 *
 *     G(f) = u + u x f + (u.f) f - 2 f = 0,   grad G = S(u) + f u^T + (u.f - 2) I
 *
 * and Newton's method solves it. T. Lee, M. Leok, N. H. McClamroch, Lie group variational integrators for the full
 * body problem, Comput. Methods Appl. Mech. Eng. 196, 2907 (2007); for the Cayley form see T. Lee, Computational
 * geometric mechanics and control of rigid bodies, thesis, Univ. of Michigan (2008). The solution for a sphere turns
 * by asin h|Omega|, exists for h|Omega| < 1 only, and is VTI-1, which writes it down in closed form. In the inertial
 * frame moments need not be turned into the body's. */
#include "quaternion.h"
#include "verlet.h"

enum { ITERATIONS = 60, MATRIX = 9 };

/** G(f) = 0. Newton's iteration rises towards the root from f = u/2 for every |u| < 1 and doubles its digits: after a
 *  correction of 1e-9 the next one would be lost in rounding. */
VTI_INLINE void implicit_increment(const double u[3], double f[3])
{
    for (int k = 0; k < 3; ++k)
        f[k] = 0.5 * u[k];
    for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
        const double uf = vti_dot(u, f), e = uf - 2.0;
        double x[3], d[3];
        vti_cross(u, f, x);
        const double minus_g[3] = {-(u[0] + x[0] + e * f[0]), -(u[1] + x[1] + e * f[1]), -(u[2] + x[2] + e * f[2])};
        const double a0[3] = {f[0] * u[0] + e, u[2] + f[1] * u[0], -u[1] + f[2] * u[0]};
        const double a1[3] = {-u[2] + f[0] * u[1], f[1] * u[1] + e, u[0] + f[2] * u[1]};
        const double a2[3] = {u[1] + f[0] * u[2], -u[0] + f[1] * u[2], f[2] * u[2] + e};
        vector_solve(a0, a1, a2, minus_g, d);
        for (int k = 0; k < 3; ++k)
            f[k] += d[k];
        if (vti_dot(d, d) <= 1e-18 * vti_dot(f, f))
            break;
    }
}

/** R <- F R, F = [(1 - f.f) I + 2 S(f) + 2 f f^T]/(1 + f.f), column by column. */
VTI_INLINE void turn_matrix(const double f[3], double R[MATRIX])
{
    const double ff = vti_dot(f, f), k = 1.0 / (1.0 + ff), c = (1.0 - ff) * k, s = 2.0 * k;
    for (int j = 0; j < 3; ++j) {
        const double p[3] = {R[j], R[3 + j], R[6 + j]}, along = vti_dot(f, p);
        double x[3];
        vti_cross(f, p, x);
        for (int i = 0; i < 3; ++i)
            R[3 * i + j] = c * p[i] + s * (x[i] + along * f[i]);
    }
}

/** drift(h) of the attitudes, or VTI_E_TOO_LARGE at the first body without a solution. */
static int turn(struct course *c)
{
    double *restrict R = c->own, *restrict q = c->q;
    const double *restrict w = c->w;
    const double h = c->h;
    for (int64_t i = 0; i < c->n; ++i) {
        const double u[3] = {h * w[3 * i], h * w[3 * i + 1], h * w[3 * i + 2]};
        double f[3];
        if (!(vti_dot(u, u) < 1.0)) {
            c->fault.body = i;
            c->fault.value = vti_norm(u);
            return VTI_E_TOO_LARGE;
        }
        implicit_increment(u, f);
        turn_matrix(f, R + MATRIX * i);
        vti_rrv_pair_from_matrix(R + MATRIX * i, q + 4 * i);
    }
    return VTI_OK;
}

static int go(struct course *c, int64_t steps)
{
    const double h = c->h;
    for (int64_t k = 0; k < steps; ++k) {
        rival_kick_all(c, 0.5 * h, 0, c->n);
        rival_translate(h, c->x, c->v, 0, c->n);
        int status = c->q != NULL ? turn(c) : VTI_OK;
        if (status == VTI_OK)
            status = course_forces(c);
        if (status != VTI_OK)
            return status;
        rival_kick_all(c, 0.5 * h, 0, c->n);
        ++c->steps;
    }
    return VTI_OK;
}

static int prepare(struct course *c, struct message *message)
{
    (void)message;
    for (int64_t i = 0; i < c->n && c->q != NULL; ++i) {
        double a[3];
        vti_rrv_from_quat_xyzw(c->q + 4 * i, a);
        vti_rrv_to_matrix(a, c->own + MATRIX * i);
    }
    return 0;
}

static void show(struct course *c)
{
    for (int64_t i = 0; i < c->n && c->q != NULL; ++i)
        quat_unit_of(c->q + 4 * i, c->q + 4 * i);
}

static void resume(struct course *c)
{
    for (int64_t i = 0; i < c->n && c->q != NULL; ++i)
        vti_rrv_pair_from_matrix(c->own + MATRIX * i, c->q + 4 * i);
}

const struct rival rival_lgvi = {
    .stepper = RIVAL_STEPPER(
        "lgvi", 2, 0.0, 1, 2.0,
        "Lie group variational integrator on matrices, Newton for its implicit equation: VTI-1's map for spheres "
        "(Lee, Leok, McClamroch 2007)"),
    .own_width = MATRIX,
    .prepare = prepare,
    .go = go,
    .show = show,
    .resume = resume,
    .takes_forces = 1,
};
