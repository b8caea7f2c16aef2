/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the tests of hard cases share: the line that a case leaves for docs/robustness.md, bodies under effects that any
 * stepper moves, and the angles by which the laws turn in closed form. */
#ifndef VTI_TESTS_HARD_H
#define VTI_TESTS_HARD_H

#include "effects/crowd.h"
#include "play.h"

/* A composition cuts half turns off at |alpha_i| = 2^60: 4/2^60 rad. */
#define CUT 3.5e-18

/** A line of the table, "robust | case | who | outcome": whoever behaves alike in a case is put together by
 *  table.py. */
static inline void robust(const char *what, const char *who, const char *outcome, ...)
{
    va_list args;
    va_start(args, outcome);
    printf("robust | %s | %s | ", what, who);
    vprintf(outcome, args);
    printf("\n");
    fflush(stdout);
    va_end(args);
}

/* ---- laws -------------------------------------------------------------------------------------------------------- */

/** The angle by which a drift turns, s = t|Omega| of either sign; NaN beyond the bound of the closed form. */
static inline long double law_angle(int64_t law, long double s)
{
    const long double s2 = s * s;
    if (law == VTI_LAW_CLOSED)
        return asinl(s);
    if (law == VTI_LAW_CAYLEY)
        return 2 * atanl(s / 2);
    if (s2 >= 0x1p60L)
        return PI_L;
    if (law == VTI_LAW_EXACT)
        return 2 * atan2l(s * (1 - s2 / 60), 2 - s2 / 5);
    return 2 * atan2l(s * (1 - s2 / 42), 2 - 3 * s2 / 14 + s2 * s2 / 840);
}

/** The angle of a whole step of a free body, s = h|Omega|. */
static inline long double step_angle(const vti_stepper *method, long double s)
{
    long double sum = 0;
    for (int64_t k = 0; k <= method->stages; ++k)
        sum += law_angle(method->law, method->drift[k] * s);
    return sum;
}

/* ---- bodies under effects ---------------------------------------------------------------------------------------- */

/** A crowd and its effects. It points into itself and is not to be copied once ready. */
typedef struct troupe {
    crowd c, elsewhere;
    const vti_effect *effects;
    int64_t n;
    const vti_stepper *method;
    vti_bodies b, probed;
} troupe;

/** Forces; in the body's frame, omega and moment are R^T Omega and M. */
static inline void troupe_load(void *self, const vti_bodies *b)
{
    const troupe *t = self;
    vti_apply(t->effects, t->n, b);
    if (t->method->frame != VTI_FRAME_BODY)
        return;
    for (int64_t i = 0; i < b->count; ++i)
        vti_rrv_rotate_back(b->alpha.c[0] + 3 * i, b->moment.c[0] + 3 * i, b->moment.c[0] + 3 * i);
}

/** Ready for a first step: t->c is set, with Omega in space. */
static inline void troupe_ready(troupe *t, const vti_stepper *method, const vti_effect *effects, int64_t n)
{
    t->method = method;
    t->effects = effects;
    t->n = n;
    t->elsewhere = t->c;
    t->b = crowd_bodies(&t->c);
    t->probed = crowd_bodies(&t->elsewhere);
    t->probed.force = t->b.force;
    t->probed.moment = t->b.moment;
    assert_int_equal(vti_bodies_seal(&t->b), VTI_OK);
    assert_int_equal(vti_bodies_seal(&t->probed), VTI_OK);
    for (int i = 0; i < t->c.n && method->frame == VTI_FRAME_BODY; ++i)
        vti_rrv_rotate_back(t->c.alpha[i], t->c.omega[i], t->c.omega[i]);
    troupe_load(t, &t->b);
}

/** One step, or the status with which it is refused. */
static inline int troupe_step(troupe *t, double h, vti_fault *fault)
{
    const vti_stepper *const m = t->method;
    for (int64_t k = 0; k <= m->stages; ++k) {
        if (m->probe != NULL && m->probe[k] != 0.0) {
            vti_step_probe(m, k, h, &t->b, &t->probed);
            troupe_load(t, &t->probed);
        }
        if (k == m->stages)
            return vti_step_finish(m, h, &t->b);
        const int status = vti_step_stage(m, k, h, &t->b, fault);
        if (status != VTI_OK)
            return status;
        troupe_load(t, &t->b);
    }
    return VTI_OK;
}

static inline double troupe_energy(const troupe *t)
{
    return vti_energy(t->effects, t->n, &t->b);
}

static inline int troupe_is_finite(const troupe *t)
{
    const crowd *c = &t->c;
    return all_finite(c->x[0], 3 * c->n) && all_finite(c->v[0], 3 * c->n) && all_finite(c->alpha[0], 3 * c->n) &&
           all_finite(c->omega[0], 3 * c->n);
}

/** One free body without loads, of the attitude alpha. */
static inline void troupe_free(troupe *t, const vti_stepper *method, const double alpha[3], const double omega[3])
{
    crowd_clear(&t->c, 1, CROWD_ALPHA);
    memcpy(t->c.alpha[0], alpha, sizeof t->c.alpha[0]);
    memcpy(t->c.omega[0], omega, sizeof t->c.omega[0]);
    troupe_ready(t, method, NULL, 0);
}

#endif
