/* SPDX-License-Identifier: BSD-3-Clause
 *
 * SPIRAL for bodies that are no spheres: C. A. del Valle, V. Angelidakis, S. Roy, J. D. Munoz, T. Poeschel, SPIRAL: An
 * efficient algorithm for the integration of the equation of rotational motion, Comput. Phys. Commun. 297, 109077
 * (2024), with velocities at whole steps. Euler's equations in the body's frame go over h/2 by the strong
 * stability-preserving Runge-Kutta method of order 3 (C.-W. Shu, S. Osher, J. Comput. Phys. 77, 439 (1988)) with the
 * moment as it stands, then q <- q exp(h w_b/2), forces, and Euler's equations over h/2 again. The state is w_b: L is
 * not kept. */
#include "general.h"

enum { SPIRAL_WIDTH = GENERAL_WIDTH + 3 };

static double *body_omega(struct course *c, int64_t i)
{
    return c->own + GENERAL_WIDTH * c->n + 3 * i;
}

/** w + d w' with the moment m along the principal axes. */
VTI_INLINE void euler_step(const double I[3], const double w[3], const double m[3], double d, double r[3])
{
    double rate[3];
    euler_body_rate(I, w, m, rate);
    for (int k = 0; k < 3; ++k)
        r[k] = w[k] + d * rate[k];
}

/** Euler's equations over d. */
static void spin_up(struct course *c, int64_t i, double d)
{
    const double *I = c->own + GENERAL_WIDTH * i + GENERAL_I;
    double *w = body_omega(c, i), m[3] = {0.0, 0.0, 0.0}, q[4], a[3], b[3];
    general_axes(c, i, q);
    if (c->m != NULL)
        vti_pair_rotate(q, -1.0, c->m + 3 * i, m);
    euler_step(I, w, m, d, a);
    euler_step(I, a, m, d, b);
    for (int k = 0; k < 3; ++k)
        a[k] = 0.75 * w[k] + 0.25 * b[k];
    euler_step(I, a, m, d, b);
    for (int k = 0; k < 3; ++k)
        w[k] = (1.0 / 3.0) * w[k] + (2.0 / 3.0) * b[k];
}

/** q <- q exp(h w_b/2) */
static void turn(struct course *c, int64_t i)
{
    const double *w = body_omega(c, i);
    double q[4], u[3];
    general_axes(c, i, q);
    vti_pair_rotate(q, 1.0, w, u);
    for (int k = 0; k < 3; ++k)
        u[k] *= c->h;
    quat_turn_exactly(u, q);
    general_set_axes(c, i, q);
}

static int go(struct course *c, int64_t steps)
{
    const double h = c->h;
    for (int64_t k = 0; k < steps; ++k) {
        rival_kick(0.5 * h, c->v, c->f, &c->per_mass, 0, c->n);
        rival_translate(h, c->x, c->v, 0, c->n);
        for (int64_t i = 0; i < c->n; ++i) {
            spin_up(c, i, 0.5 * h);
            turn(c, i);
        }
        const int status = course_forces(c);
        if (status != VTI_OK)
            return status;
        rival_kick(0.5 * h, c->v, c->f, &c->per_mass, 0, c->n);
        for (int64_t i = 0; i < c->n; ++i)
            spin_up(c, i, 0.5 * h);
        ++c->steps;
    }
    return VTI_OK;
}

static int prepare(struct course *c, struct message *message)
{
    const int failed = general_prepare(c, message);
    for (int64_t i = 0; i < c->n; ++i) {
        double q[4];
        general_axes(c, i, q);
        general_body_omega(c->own + GENERAL_WIDTH * i + GENERAL_K, c->L + 3 * i, q, body_omega(c, i));
    }
    return failed;
}

/** Omega, and L as it follows from it. */
static void show(struct course *c)
{
    for (int64_t i = 0; i < c->n; ++i) {
        const double *I = c->own + GENERAL_WIDTH * i + GENERAL_I, *w = body_omega(c, i);
        double q[4], p[3];
        general_axes(c, i, q);
        for (int k = 0; k < 3; ++k)
            p[k] = I[k] * w[k];
        vti_pair_rotate(q, 1.0, w, c->w + 3 * i);
        vti_pair_rotate(q, 1.0, p, c->L + 3 * i);
    }
}

const struct rival rival_spiral_body = {
    .stepper = RIVAL_STEPPER(
        "spiral-aspherical", 2, 0.0, 1, 2.0,
        "Euler's equations by SSP-RK3 over half steps around the exponential map (SPIRAL, del Valle et al. 2024); "
        "bodies of three moments"),
    .own_width = SPIRAL_WIDTH,
    .prepare = prepare,
    .go = go,
    .show = show,
    .takes_forces = 1,
    .general = RIVAL_OF_MOMENTS,
};
