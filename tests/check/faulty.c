/* SPDX-License-Identifier: BSD-3-Clause */
#include "faulty.h"

#include <string.h>

#include "vti_rrv.h"

struct run {
    int fault;
    double h;
    int64_t n;
    double *x, *v, *q, *w;
    const double *mass, *inertia;
    double f[3 * VTI_CHECK_BODIES], m[3 * VTI_CHECK_BODIES]; /* now */
    double f_old[3 * VTI_CHECK_BODIES], m_old[3 * VTI_CHECK_BODIES];
};

static int has(const struct run *r, int fault)
{
    return (r->fault & fault) != 0;
}

/* ---- kicks --------------------------------------------------------------------------------------------------------- */

static double per_load(const struct run *r, int64_t i)
{
    const double j = has(r, NO_INERTIA) ? 1.0 : has(r, MASS_FOR_INERTIA) ? r->mass[i] : r->inertia[i];
    return (has(r, WRONG_SIGN) ? -1.0 : 1.0) / j;
}

static void kick_by(struct run *r, double t, const double *f, const double *m)
{
    const double s = has(r, TWICE) ? 2.0 * t : t;
    for (int64_t i = 0; i < r->n; ++i) {
        double alpha[3], moment[3] = {m[3 * i], m[3 * i + 1], m[3 * i + 2]};
        vti_rrv_from_quat_xyzw(r->q + 4 * i, alpha);
        if (has(r, BODY_SPIN)) /* what is kept is R^T omega; kicking that by M is kicking omega by R M */
            vti_rrv_rotate(alpha, moment, moment);
        if (has(r, BODY_MOMENT))
            vti_rrv_rotate_back(alpha, moment, moment);
        for (int64_t k = 3 * i; k < 3 * i + 3; ++k) {
            r->v[k] += has(r, NO_FORCE) ? 0.0 : s * f[k] / r->mass[i];
            r->w[k] += has(r, NO_ROTATION) ? 0.0 : s * moment[k - 3 * i] * per_load(r, i);
        }
    }
}

static void kick(struct run *r, double t)
{
    kick_by(r, t, r->f, r->m);
}

/* ---- drifts -------------------------------------------------------------------------------------------------------- */

/** p q in the order x, y, z, w: first q, then p. */
static void product(const double p[4], const double q[4], double r[4])
{
    double u[3];
    vti_cross(p, q, u);
    r[3] = p[3] * q[3] - vti_dot(p, q);
    for (int k = 0; k < 3; ++k)
        r[k] = u[k] + p[3] * q[k] + q[3] * p[k];
}

static void add_turns(const double u[3], double q[4])
{
    double a[3], theta[3];
    vti_rrv_from_quat_xyzw(q, a);
    vti_rrv_to_rotvec(a, theta);
    for (int k = 0; k < 3; ++k)
        theta[k] += u[k];
    vti_rrv_from_rotvec(theta, a);
    vti_rrv_to_quat_xyzw(a, q);
}

static void turn(const struct run *r, const double w[3], double q[4])
{
    const double half = 0.5 * (has(r, DOUBLE_TURN) ? 2.0 : 1.0) * (has(r, INVERSE_ATTITUDE) ? -1.0 : 1.0) * r->h;
    const double u[3] = {r->h * w[0], r->h * w[1], r->h * w[2]}, dq[4] = {half * w[0], half * w[1], half * w[2], 1.0};
    double next[4];
    if (has(r, ADDED_TURNS)) {
        add_turns(u, q);
        return;
    }
    if (has(r, WRONG_SIDE | INVERSE_ATTITUDE))
        product(q, dq, next);
    else
        product(dq, q, next);
    double k = has(r, NOT_NORMALISED) ? 1.0 : 1.0 / sqrt(vti_dot(next, next) + next[3] * next[3]);
    if (has(r, REFUSES_HALF_TURN) && q[3] * next[3] <= 0.0)
        k = NAN;
    for (int c = 0; c < 4; ++c)
        q[c] = k * next[c];
}

static void drift_positions(struct run *r)
{
    for (int64_t k = 0; k < 3 * r->n; ++k)
        r->x[k] += r->h * r->v[k];
}

static void drift_attitudes(struct run *r)
{
    for (int64_t i = 0; i < r->n && !has(r, NO_ROTATION); ++i)
        turn(r, r->w + 3 * i, r->q + 4 * i);
}

/* ---- steps --------------------------------------------------------------------------------------------------------- */

static void look(struct run *r, vti_check_forces *forces, void *kit)
{
    memcpy(r->f_old, r->f, sizeof r->f);
    memcpy(r->m_old, r->m, sizeof r->m);
    forces(kit, r->n, r->x, r->q, r->f, r->m);
}

static void simple_step(struct run *r, vti_check_forces *forces, void *kit)
{
    if (has(r, LATE))
        kick(r, r->h);
    drift_positions(r);
    drift_attitudes(r);
    if (has(r, EULER))
        kick(r, r->h);
    look(r, forces, kit);
    if (has(r, EARLY))
        kick(r, r->h);
}

static void verlet_step(struct run *r, int64_t step, vti_check_forces *forces, void *kit)
{
    if (has(r, OLD_VELOCITY))
        drift_positions(r);
    if (has(r, OLD_SPIN))
        drift_attitudes(r);
    if (step > 0 || !has(r, NO_FIRST_HALF))
        kick(r, 0.5 * r->h);
    if (!has(r, OLD_VELOCITY))
        drift_positions(r);
    if (!has(r, OLD_SPIN))
        drift_attitudes(r);
    look(r, forces, kit);
    kick_by(r, 0.5 * r->h, has(r, PREVIOUS_FORCE) ? r->f_old : r->f, has(r, PREVIOUS_MOMENT) ? r->m_old : r->m);
    for (int64_t k = 0; k < 3 * r->n && has(r, WEAK_DAMPING); ++k)
        r->w[k] *= 1.0 - 1e-4;
}

int faulty_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                   const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    struct run r = {*(const int *)self, h, n, x, v, quat, omega, mass, inertia, {0}, {0}, {0}, {0}};
    if (!has(&r, NOT_PRIMED))
        look(&r, forces, kit);
    for (int64_t k = 0; k < steps; ++k) {
        if (has(&r, LATE | EARLY | EULER))
            simple_step(&r, forces, kit);
        else
            verlet_step(&r, k, forces, kit);
    }
    return 0;
}
