/* SPDX-License-Identifier: BSD-3-Clause
 * What is seen of the stable step along a run: the bound itself, overlaps, and what slows bodies. */
#include <math.h>

#include "far.h"
#include "plain.h"
#include "verdict_parts.h"

/** As a share of the step. */
static double longest_drift(const vti_stepper *stepper)
{
    double most = stepper->drift == NULL ? 1.0 : 0.0;
    for (int64_t k = 0; stepper->drift != NULL && k <= stepper->stages; ++k)
        most = fmax(most, fabs(stepper->drift[k]));
    return most;
}

double stability_slowing(const struct model *model, const vti_stepper *stepper, double h)
{
    double most = 0.0;
    int pushes = 0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        pushes |= model->effects[k].apply != NULL;
        most = e->kind->slowing != NULL ? fmax(most, e->kind->slowing(e, model)) : most;
    }
    return pushes ? most * longest_drift(stepper) * h : 0.0;
}

double stability_slowing_free(const struct model *model, const vti_stepper *stepper, double h)
{
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        most = e->kind->slowing_free != NULL ? fmax(most, e->kind->slowing_free(e, model)) : most;
    }
    return most * longest_drift(stepper) * h;
}

/** exp(-z) */
static double kept(double z)
{
    static const double per_ln2 = 1.4426950408889634;
    return plain_exp2(-z * per_ln2);
}

double stability_way_error(const vti_stepper *stepper, double z)
{
    static const double slow = 1e-6; /* no way is off by more than half of z */
    const double whole = z / longest_drift(stepper);
    double way = 0.0, kicked = 0.0;
    if (stepper->drift == NULL || !(z > slow))
        return 0.0;
    for (int64_t k = 0; k <= stepper->stages; ++k) {
        kicked += stepper->kick[k];
        way += stepper->drift[k] * kept(kicked * whole);
    }
    return fabs(way * whole / (1.0 - kept(whole)) - 1.0);
}

/* ---- at rows ----------------------------------------------------------------------------------------------------- */

double stability_deepest(const struct model *model, const vti_bodies *bodies)
{
    const vti_clumps *clumps = &model->clumps.list;
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        if (e->kind->deepest != NULL)
            most = fmax(most, e->kind->deepest(e, clumps->count > 0 ? &clumps->spheres : bodies));
    }
    return most;
}

static void add_stiffness(void *sum, const vti_spring *s)
{
    *(double *)sum += s->axial + s->across + s->shear + s->bend + s->twist;
}

double stability_idle(const struct model *model, const vti_bodies *bodies)
{
    double sum = 0.0;
    for (int64_t k = 0; k < model->effects_count; ++k) {
        const vti_effect *e = &model->effects[k];
        if (e->springs != NULL)
            (void)e->springs(e->self, bodies, NULL, add_stiffness, &sum);
    }
    return isfinite(sum) ? 0.5e-18 * sum : 0.0;
}

/** Rows 0 to 31, every second of the next 32, every fourth of the next 64, ... */
static int is_looked_at(double row)
{
    const int64_t number = (int64_t)row;
    int64_t every = 1;
    while (number >= 32 * every)
        every *= 2;
    return number % every == 0;
}

/** Whether what touches holds a tenth more energy than at any look before. The stable step of Hertzian
 *  contact falls as E^(-1/10), so that a hundredth of it is missed. */
static int is_pressed(struct verdict *v, const double *row)
{
    double energy = 0.0;
    for (int c = 1; c < v->columns->held; ++c) {
        const int effect = v->columns->effect[c];
        energy += effect >= 0 && !v->model->effects[effect].smooth ? row[c] : 0.0;
    }
    if (!(energy > 1.1 * v->found.pressed))
        return 0;
    v->found.pressed = energy;
    return 1;
}

/** The bound at t. Returns it, infinite if it is not known. */
static double find_stable_step(struct verdict *v, double t, const vti_bodies *bodies)
{
    struct message ignored;
    vti_stable stable;
    if (model_stable_step(v->model, bodies, NULL, &stable, &ignored) != 0)
        return INFINITY;
    const double h = model_stable_of(v->stepper, stable.h);
    if (h < v->found.stable) {
        v->found.stable = h;
        v->found.stable_t = t;
    }
    return h;
}

/** Of steps that vary the longest since the last look may have been taken where the stable step was that of either
 *  end. */
void stability_row(struct verdict *v, double t, const vti_bodies *bodies, const double *row)
{
    struct findings *f = &v->found;
    const int pressed = is_pressed(v, row);
    f->longest = fmax(f->longest, v->h);
    if (!(is_looked_at(f->rows) || pressed))
        return;
    f->slowing = fmax(f->slowing, stability_slowing(v->model, v->stepper, v->h)); /* bonds may have been made */
    f->slowing_free = fmax(f->slowing_free, stability_slowing_free(v->model, v->stepper, v->h));
    const double h = find_stable_step(v, t, bodies);
    f->share = fmax(f->share, f->longest / (f->varies != 0.0 ? fmax(h, f->before) : h));
    f->before = h;
    f->longest = 0.0;
}

void verdict_longest(struct verdict *v, double h)
{
    v->found.lately = fmax(v->found.lately, h);
    v->found.varies = 1.0;
}

/* ---- between rows ------------------------------------------------------------------------------------------------ */

/** The square of the largest force on a body. */
static double largest_force2(const vti_bodies *b)
{
    const double *x = b->force.c[0], *y = b->force.c[1], *z = b->force.c[2];
    double most = 0.0;
    for (int64_t i = 0; i < b->count; ++i) {
        const int64_t at = i * b->force.stride;
        const double f2 = x[at] * x[at] + y[at] * y[at] + z[at] * z[at];
        most = f2 > most ? f2 : most;
    }
    return most;
}

/** Steps that vary are compared with the stable step at rows. */
void stability_step(struct verdict *v, double t, const vti_bodies *bodies)
{
    static const double quarter = 1.5625; /* 1.25^2 */
    static const double none[3];
    struct findings *f = &v->found;
    if (bodies->force.c[0] == NULL || !far_any(&bodies->force, 0, bodies->count, NULL, none, quarter * f->force2))
        return;
    const double force2 = largest_force2(bodies); /* without NaN, which the next row finds */
    if (!(force2 > quarter * f->force2))
        return;
    f->force2 = force2;
    f->deepest = fmax(f->deepest, stability_deepest(v->model, bodies));
    if (f->varies == 0.0)
        f->share = fmax(f->share, v->h / find_stable_step(v, t, bodies));
}
