/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A body of three principal moments I = (A, B, C) along the body's axes, with the angular momentum L in space: as the
 * host moves it, and by Euler's equations along the body's axes, which know nothing of how the library moves such
 * bodies,
 *
 *     q' = q w_b/2,  I w_b' = R^T RM + g I w_b x w_b,  L = R I w_b,   g = 1,
 *
 * by the classical Runge-Kutta method at small steps. */
#include "check.h"

#include <string.h>

struct top vti_kit_top_usual(void)
{
    static const double turned[3] = {0.6, -0.5, 0.7};
    struct top b = {.L = {0.9, 1.4, -1.1}, .I = {1.0, 1.7, 2.3}};
    double alpha[3];
    vti_rrv_from_rotvec(turned, alpha);
    vti_rrv_to_quat_xyzw(alpha, b.q);
    return b;
}

/* ---- Euler's equations ------------------------------------------------------------------------------------------- */

enum { STATE = 7 };

static void moment_on(const struct top *b, const double q[4], double moment[3])
{
    double r[3];
    vti_pair_rotate(q, 1.0, b->arm, r);
    moment[0] = b->moment[0] - r[1];
    moment[1] = b->moment[1] + r[0];
    moment[2] = b->moment[2];
}

/** y = (q, w_b) */
static void euler(const struct top *b, double g, const double *y, double *rate)
{
    const double *q = y, *w = y + 4, p[3] = {b->I[0] * w[0], b->I[1] * w[1], b->I[2] * w[2]};
    double m[3], x[3];
    vti_cross(q, w, x);
    for (int k = 0; k < 3; ++k)
        rate[k] = 0.5 * (q[3] * w[k] + x[k]);
    rate[3] = -0.5 * vti_dot(q, w);
    moment_on(b, q, m);
    vti_pair_rotate(q, -1.0, m, m);
    vti_cross(p, w, x);
    for (int k = 0; k < 3; ++k)
        rate[4 + k] = (m[k] + g * x[k]) / b->I[k];
}

static void add(const double *y, double t, const double *rate, double *r)
{
    for (int k = 0; k < STATE; ++k)
        r[k] = y[k] + t * rate[k];
}

struct top vti_kit_top_moved(const struct top *start, double g, double t)
{
    enum { STEPS = 2000 };
    struct top b = *start;
    double y[STATE], k1[STATE], k2[STATE], k3[STATE], k4[STATE], z[STATE];
    const double h = t / STEPS;
    memcpy(y, b.q, sizeof b.q);
    vti_pair_rotate(b.q, -1.0, b.L, y + 4);
    for (int k = 0; k < 3; ++k)
        y[4 + k] /= b.I[k];
    for (int n = 0; n < STEPS; ++n) {
        euler(&b, g, y, k1);
        add(y, 0.5 * h, k1, z);
        euler(&b, g, z, k2);
        add(y, 0.5 * h, k2, z);
        euler(&b, g, z, k3);
        add(y, h, k3, z);
        euler(&b, g, z, k4);
        for (int k = 0; k < STATE; ++k)
            y[k] += h / 6.0 * (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]);
    }
    memcpy(b.q, y, sizeof b.q);
    for (int k = 0; k < 3; ++k)
        b.L[k] = b.I[k] * y[4 + k];
    vti_pair_rotate(b.q, 1.0, b.L, b.L);
    return b;
}

/* ---- the host ---------------------------------------------------------------------------------------------------- */

static void answer(void *kit, int64_t n, const double *x, const double *quat, double *force, double *moment)
{
    const struct top *b = kit;
    (void)x;
    for (int64_t k = 0; k < 3 * n; ++k)
        force[k] = moment[k] = n == 1 ? 0.0 : NAN;
    if (n == 1)
        moment_on(b, quat, moment);
}

struct top vti_kit_top_hosted(struct kit *kit, const struct top *start, double h, int64_t steps)
{
    struct top b = *start, asked = *start;
    double x[3] = {0.0, 0.0, 0.0}, v[3] = {0.0, 0.0, 0.0}, mass = 1.0, sum = 0.0;
    const int failed =
        kit->host.advance(kit->host.self, h, steps, 1, x, v, b.q, b.L, &mass, start->I, answer, &asked) != 0;
    for (int k = 0; k < 3; ++k)
        sum += b.q[k] + b.L[k];
    if (failed || !isfinite(sum) || !isfinite(1.0 / vti_pair_square(b.q)))
        for (int k = 0; k < 4; ++k)
            b.q[k] = b.L[k % 3] = NAN;
    return b;
}

double vti_kit_top_turned(const struct top *a, const struct top *b)
{
    return isfinite(a->q[0]) && isfinite(b->q[0]) ? vti_pair_distance(a->q, b->q) : NAN;
}
