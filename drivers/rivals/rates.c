/* SPDX-License-Identifier: BSD-3-Clause */
#include "rates.h"

#include <string.h>

#include "euler.h"
#include "quaternion.h"
#include "verlet.h"

/* ---- a state ----------------------------------------------------------------------------------------------------- */

/** Where the blocks of a state begin; the first absent ones take no room. */
struct places {
    int64_t v, q, w, end;
};

static inline struct places places_of(const struct course *c)
{
    const int64_t n = c->n, v = c->x != NULL ? 3 * n : 0, q = 2 * v;
    const int64_t w = c->q != NULL ? q + 4 * n : q, end = c->q != NULL ? w + 3 * n : w;
    const struct places p = {v, q, w, end};
    return p;
}

int64_t rates_width(const struct course *c)
{
    return places_of(c).end;
}

int64_t rates_room(const struct course *c)
{
    return (rates_width(c) + 7) / 8 * 8;
}

int64_t rates_velocities(const struct course *c)
{
    return places_of(c).v;
}

static void copy(double *to, const double *from, int64_t n)
{
    memcpy(to, from, (size_t)n * sizeof *to);
}

void rates_start(const struct course *c, double *state)
{
    const struct places p = places_of(c);
    if (c->x != NULL) {
        copy(state, c->x, 3 * c->n);
        copy(state + p.v, c->v, 3 * c->n);
    }
    if (c->q != NULL) {
        copy(state + p.q, c->q, 4 * c->n);
        copy(state + p.w, c->w, 3 * c->n);
    }
}

static void point(vti_view *view, double *p)
{
    for (int k = 0; k < 3; ++k)
        view->c[k] = p + k;
}

/** The seal of the bodies stays good: only the addresses of like memory change. */
void rates_look_at(struct course *c, const double *state)
{
    const struct places p = places_of(c);
    double *s = (double *)state; /* views are made for bodies that may move; forces only read them */
    if (c->x != NULL) {
        point(&c->bodies.x, s);
        point(&c->bodies.v, s + p.v);
    }
    if (c->q != NULL) {
        for (int k = 0; k < 4; ++k)
            c->bodies.quat.xyzw[k] = s + p.q + k;
        point(&c->bodies.omega, s + p.w);
    }
}

void rates_momenta(struct course *c)
{
    for (int64_t i = 0; c->L != NULL && i < c->n; ++i)
        euler_momentum(&c->bodies, i, c->L + 3 * i);
}

void rates_show(struct course *c)
{
    rates_look_at(c, c->own);
    rates_momenta(c);
}

void rates_live_in(struct course *c, double *state)
{
    const struct places p = places_of(c);
    rates_look_at(c, state);
    if (c->x != NULL) {
        c->x = state;
        c->v = state + p.v;
    }
    if (c->q != NULL) {
        c->q = state + p.q;
        c->w = state + p.w;
    }
}

void rates_normalise(const struct course *c, double *state)
{
    double *q = state + places_of(c).q;
    for (int64_t i = 0; i < c->n && c->q != NULL; ++i)
        quat_unit_of(q + 4 * i, q + 4 * i);
}

/* ---- its derivative ---------------------------------------------------------------------------------------------- */

/** load/m in place. */
static void accelerations(double *restrict load, const vti_scalars *per, int64_t n)
{
    if (per->stride == 0) {
        const double k = *per->p;
        for (int64_t j = 0; k != 1.0 && j < 3 * n; ++j)
            load[j] *= k;
        return;
    }
    for (int64_t i = 0; i < n; ++i)
        for (int64_t j = 3 * i; j < 3 * i + 3; ++j)
            load[j] *= per->p[i];
}

/** q' = (1/2) Omega q */
static void turning(const double *restrict q, const double *restrict w, double *restrict rate, int64_t n)
{
    for (int64_t i = 0; i < n; ++i) {
        const double half[3] = {0.5 * w[3 * i], 0.5 * w[3 * i + 1], 0.5 * w[3 * i + 2]};
        quat_turned(0.0, half, q + 4 * i, rate + 4 * i);
    }
}

/** Omega' in the place of the moments. */
static void gyrations(const struct course *c, double *restrict moment)
{
    for (int64_t i = 0; i < c->n; ++i) {
        const double m[3] = {moment[3 * i], moment[3 * i + 1], moment[3 * i + 2]};
        euler_rate(&c->bodies, i, m, moment + 3 * i);
    }
}

/** The loads, or 0 where no effect gives any. */
static int loads(struct course *c, const double *state, double *force, double *moment)
{
    rates_look_at(c, state);
    if (c->f != NULL)
        point(&c->bodies.force, force);
    else if (c->x != NULL)
        memset(force, 0, (size_t)(3 * c->n) * sizeof *force);
    if (c->m != NULL)
        point(&c->bodies.moment, moment);
    else if (c->q != NULL)
        memset(moment, 0, (size_t)(3 * c->n) * sizeof *moment);
    return course_forces(c);
}

int rates(struct course *c, const double *state, double *rate)
{
    const struct places p = places_of(c);
    const int status = loads(c, state, rate + p.v, rate + p.w);
    if (status != VTI_OK)
        return status;
    if (c->x != NULL)
        copy(rate, state + p.v, 3 * c->n);
    if (c->f != NULL)
        accelerations(rate + p.v, &c->per_mass, c->n);
    if (c->q != NULL)
        turning(state + p.q, state + p.w, rate + p.q, c->n);
    if (c->L != NULL)
        gyrations(c, rate + p.w);
    else if (c->m != NULL)
        accelerations(rate + p.w, &c->per_inertia, c->n);
    return VTI_OK;
}

void rates_drift(const struct course *c, double t)
{
    rival_translate(t, c->x, c->v, 0, c->n);
    rival_turn(t, c->q, c->w, quat_turn_exactly, 0, c->n);
}
