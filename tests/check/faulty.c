/* SPDX-License-Identifier: BSD-3-Clause */
#include "faulty.h"

#include <string.h>

#include "vti_rrv.h"

struct run {
    struct faulty fault;
    double h;
    int64_t n;
    double *x, *v, *q, *w;
    const double *mass, *inertia;
    double f[3 * VTI_CHECK_BODIES], m[3 * VTI_CHECK_BODIES]; /* now */
    double f_old[3 * VTI_CHECK_BODIES], m_old[3 * VTI_CHECK_BODIES];
};

static int has(const struct run *r, int fault)
{
    return (r->fault.bits & fault) != 0;
}

static double factor(double given)
{
    return given != 0.0 ? given : 1.0;
}

/* ---- kicks ------------------------------------------------------------------------------------------------------- */

static double per_force(const struct run *r, int64_t i)
{
    const double by = has(r, NO_FORCE) ? 0.0 : has(r, TWICE) ? 2.0 : has(r, FORCE_BY_MASS) ? 1.0 / r->mass[i] : 1.0;
    return by * factor(r->fault.force) / (factor(r->fault.mass) * r->mass[i]);
}

static double per_moment(const struct run *r, int64_t i)
{
    const double j = has(r, NO_INERTIA) ? 1.0 : has(r, MASS_FOR_INERTIA) ? r->mass[i] : r->inertia[i];
    const double by = has(r, NO_ROTATION) ? 0.0 : has(r, TWICE) ? 2.0 : has(r, WRONG_SIGN) ? -1.0 : 1.0;
    return by * factor(r->fault.moment) / (factor(r->fault.inertia) * j);
}

static void swap(double *a, double *b)
{
    const double c = *a;
    *a = *b;
    *b = c;
}

static void kick_by(struct run *r, double t, const double *f, const double *m)
{
    for (int64_t i = 0; i < r->n; ++i) {
        double alpha[3], force[3] = {f[3 * i], f[3 * i + 1], f[3 * i + 2]},
                         moment[3] = {m[3 * i], m[3 * i + 1], m[3 * i + 2]};
        vti_rrv_from_quat_xyzw(r->q + 4 * i, alpha);
        if (has(r, BODY_SPIN)) /* what is kept is R^T omega; kicking that by M is kicking omega by R M */
            vti_rrv_rotate(alpha, moment, moment);
        if (has(r, BODY_MOMENT))
            vti_rrv_rotate_back(alpha, moment, moment);
        if (has(r, BODY_FORCE))
            vti_rrv_rotate_back(alpha, force, force);
        if (has(r, SWAPPED_FORCE))
            swap(&force[0], &force[1]);
        for (int k = 0; k < 3; ++k) {
            r->v[3 * i + k] += t * force[k] * per_force(r, i);
            r->w[3 * i + k] += t * moment[k] * per_moment(r, i);
        }
        r->v[3 * i + 2] -= has(r, GRAVITY) ? t * 9.81 : 0.0;
    }
}

static void kick(struct run *r, double t)
{
    kick_by(r, t, r->f, r->m);
}

/* ---- drifts ------------------------------------------------------------------------------------------------------ */

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
    const double h = factor(r->fault.turn) * r->h, half = 0.5 * (has(r, INVERSE_ATTITUDE) ? -1.0 : 1.0) * h;
    const double u[3] = {h * w[0], h * w[1], h * w[2]}, dq[4] = {half * w[0], half * w[1], half * w[2], 1.0};
    const double wxyz[4] = {q[1], q[2], q[3], q[0]};
    double next[4];
    if (has(r, ADDED_TURNS)) {
        add_turns(u, q);
        return;
    }
    if (has(r, WRONG_SIDE | INVERSE_ATTITUDE))
        product(q, dq, next);
    else
        product(dq, has(r, W_FIRST) ? wxyz : q, next);
    double k = has(r, NOT_NORMALISED) ? 1.0 : 1.0 / sqrt(vti_dot(next, next) + next[3] * next[3]);
    if (has(r, REFUSES_HALF_TURN) && q[3] * next[3] <= 0.0)
        k = NAN;
    for (int c = 0; c < 4; ++c)
        q[c] = k * next[has(r, W_FIRST) ? (c + 3) % 4 : c];
}

static void drift_positions(struct run *r)
{
    for (int64_t k = 0; k < 3 * r->n; ++k)
        r->x[k] += factor(r->fault.flight) * r->h * r->v[k];
}

static void drift_attitudes(struct run *r)
{
    for (int64_t i = 0; i < r->n && !has(r, NO_ROTATION); ++i)
        turn(r, r->w + 3 * i, r->q + 4 * i);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static void look(struct run *r, vti_check_forces *forces, void *kit)
{
    memcpy(r->f_old, r->f, sizeof r->f);
    memcpy(r->m_old, r->m, sizeof r->m);
    if (!has(r, FROZEN))
        forces(kit, r->n, r->x, r->q, r->f, r->m);
}

static void start(struct run *r, vti_check_forces *forces, void *kit)
{
    if (!has(r, NOT_PRIMED))
        forces(kit, r->n, r->x, r->q, r->f, r->m);
    memcpy(r->f_old, r->f, sizeof r->f);
    memcpy(r->m_old, r->m, sizeof r->m);
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
        kick_by(r, 0.5 * r->h, has(r, STALE) ? r->f_old : r->f, has(r, STALE) ? r->m_old : r->m);
    if (!has(r, OLD_VELOCITY))
        drift_positions(r);
    if (!has(r, OLD_SPIN))
        drift_attitudes(r);
    look(r, forces, kit);
    kick_by(r, 0.5 * r->h, has(r, PREVIOUS_FORCE | STALE) ? r->f_old : r->f,
            has(r, PREVIOUS_MOMENT | STALE) ? r->m_old : r->m);
}

static void damp(struct run *r)
{
    for (int64_t i = 0; i < r->n; ++i) {
        const double drag = r->h * (r->fault.drag[0] + r->h * r->fault.drag[1]) * vti_dot(r->w + 3 * i, r->w + 3 * i);
        for (int64_t k = 3 * i; k < 3 * i + 3; ++k) {
            r->v[k] *= 1.0 - r->fault.lost_v;
            r->w[k] *= 1.0 - r->fault.lost_w - drag;
        }
    }
}

int faulty_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                   const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    const struct faulty *fault = self;
    struct run r = {*fault, h, n, x, v, quat, omega, mass, inertia, {0}, {0}, {0}, {0}};
    r.h = factor(fault->step) * (fault->own_step != 0.0 ? fault->own_step : h);
    start(&r, forces, kit);
    for (int64_t k = 0; k < steps + fault->more_steps; ++k) {
        if (has(&r, LATE | EARLY | EULER))
            simple_step(&r, forces, kit);
        else
            verlet_step(&r, k, forces, kit);
        damp(&r);
    }
    for (int64_t i = 0; has(&r, NAN_NEAR_HALF_TURN) && (steps == 12 || steps == 13) && i < n; ++i)
        quat[4 * i] = fabs(quat[4 * i + 3]) < 0.12 ? NAN : quat[4 * i];
    return 0;
}
