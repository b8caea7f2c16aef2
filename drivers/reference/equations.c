/* SPDX-License-Identifier: BSD-3-Clause */
#include "equations.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "euler.h"
#include "random.h"
#include "units.h"

/* ---- the state as bodies ----------------------------------------------------------------------------------------- */

int64_t equations_body_width(const struct model *model)
{
    return (model->translates ? 6 : 0) + (model->turns ? 7 : 0);
}

int64_t equations_width(const struct model *model)
{
    return model->bodies.count * equations_body_width(model) + 1;
}

static vti_view vector_at(double *p, int64_t stride)
{
    const vti_view view = {{p, p + 1, p + 2}, stride, 0};
    return view;
}

void equations_look_at(const struct model *model, vti_bodies *b, double *state)
{
    const int64_t stride = equations_body_width(model);
    double *p = state;
    if (model->translates) {
        b->x = vector_at(p, stride);
        b->v = vector_at(p + 3, stride);
        p += 6;
    }
    if (model->turns) {
        const vti_quat_view quat = {{p, p + 1, p + 2, p + 3}, stride, 0};
        b->quat = quat;
        b->omega = vector_at(p + 4, stride);
    }
}

vti_bodies equations_bodies(const struct model *model, double *state)
{
    vti_bodies b = vti_bodies_none(model->bodies.count);
    b.mass = model->bodies.mass;
    b.inertia = model->bodies.inertia;
    b.moments = model->bodies.moments;
    b.principal = model->bodies.principal;
    equations_look_at(model, &b, state);
    return b;
}

void equations_start(const struct model *model, double *state)
{
    equations_take(model, &model->bodies, state);
    state[equations_width(model) - 1] = 0.0;
}

void equations_take(const struct model *model, const vti_bodies *from, double *state)
{
    const vti_bodies to = equations_bodies(model, state);
    for (int64_t i = 0; i < from->count; ++i) {
        for (int k = 0; k < 3 && model->translates; ++k) {
            to.x.c[k][i * to.x.stride] = from->x.c[k][i * from->x.stride];
            to.v.c[k][i * to.v.stride] = from->v.c[k][i * from->v.stride];
        }
        if (model->turns) {
            double a[3], q[4];
            for (int k = 0; k < 3; ++k) {
                a[k] = from->alpha.c[k][i * from->alpha.stride];
                to.omega.c[k][i * to.omega.stride] = from->omega.c[k][i * from->omega.stride];
            }
            vti_rrv_to_quat_xyzw(a, q);
            for (int k = 0; k < 4; ++k)
                to.quat.xyzw[k][i * to.quat.stride] = q[k];
        }
    }
}

/* ---- the continuous equations ------------------------------------------------------------------------------------ */

/** One body's x' = v and v' = F/m. */
static void translation_rate(const vti_bodies *b, int64_t i, const double force[3], double *rate)
{
    for (int k = 0; k < 3; ++k) {
        rate[k] = b->v.c[k][i * b->v.stride];
        rate[3 + k] = force[k] / b->mass.p[i * b->mass.stride];
    }
}

/** One body's q' = (1/2) Omega q and Omega' = RM/J, or Euler's equations of three moments. */
static void rotation_rate(const vti_bodies *b, int64_t i, const double moment[3], double *rate)
{
    double q[4], w[3], x[3];
    for (int k = 0; k < 4; ++k)
        q[k] = b->quat.xyzw[k][i * b->quat.stride];
    for (int k = 0; k < 3; ++k)
        w[k] = b->omega.c[k][i * b->omega.stride];
    vti_cross(w, q, x);
    for (int k = 0; k < 3; ++k)
        rate[k] = 0.5 * (q[3] * w[k] + x[k]);
    rate[3] = -0.5 * vti_dot(w, q);
    if (b->moments.c[0] != NULL)
        euler_rate(b, i, moment, rate + 4);
    for (int k = 0; k < 3 && b->inertia.p != NULL; ++k)
        rate[4 + k] = moment[k] / b->inertia.p[i * b->inertia.stride];
}

/** The first state's bodies, and the loads on them. */
static int first_bodies(struct equations *eq, double *state)
{
    eq->bodies = equations_bodies(eq->model, state);
    eq->bodies.force = eq->model->translates ? vector_at(eq->loads, 6) : vti_view_none();
    eq->bodies.moment = eq->model->turns ? vector_at(eq->loads + 3, 6) : vti_view_none();
    return vti_bodies_seal(&eq->bodies);
}

/** A step may take long, and an interval many steps: the watch is asked about every hundredth of a second. */
static int is_asked(struct equations *eq)
{
    enum { LOOK_EVERY = 1 << 15 };
    if (eq->asked)
        return 1;
    eq->unseen += eq->model->bodies.count;
    if (eq->unseen < LOOK_EVERY)
        return 0;
    eq->unseen = 0;
    eq->asked = watch_see(eq->watch, eq->share);
    return eq->asked;
}

static int rates(double t, const double state[], double rate[], void *self)
{
    struct equations *eq = self;
    const struct model *model = eq->model;
    const int translates = model->translates, turns = model->turns;
    const int64_t stride = equations_body_width(model), n = eq->model->bodies.count;
    vti_bodies *b = &eq->bodies;
    (void)t;
    ++eq->evals;
    if (is_asked(eq))
        return GSL_EBADFUNC;
    /* GSL promises not to have its state changed; the views are only read */
    if (b->sealed == 0 && (eq->status = first_bodies(eq, (double *)state)) != VTI_OK)
        return GSL_EBADFUNC;
    equations_look_at(model, b, (double *)state);
    if ((eq->status = model_forces(eq->model, b)) != VTI_OK)
        return GSL_EBADFUNC;
    for (int64_t i = 0; i < n; ++i) {
        double *r = rate + i * stride;
        if (translates)
            translation_rate(b, i, eq->loads + 6 * i, r);
        if (turns)
            rotation_rate(b, i, eq->loads + 6 * i + 3, r + (translates ? 6 : 0));
    }
    rate[eq->width - 1] = vti_h1_density(b);
    return GSL_SUCCESS;
}

/* ---- what rounding leaves ---------------------------------------------------------------------------------------- */

/* Positions are known to an ulp, |x| eps, by which the forces of a stiff bond change by K |x| eps, however small the
 * step is; and a step goes through several such errors. Where bodies stand far from the origin, or are light and small,
 * that is more than a tolerance near eps asks for, and steps would be cut to nothing for it. Where an oscillation
 * brings it to less than some tolerances it does no harm, and steps are as if there were none. */
static const double stages = 4.0, some = 64.0;

/** One ulp up or down, whichever comes. */
static double moved(double value, int64_t k)
{
    return (random_bits(0, (uint64_t)k) >> 63) != 0 ? nextafter(value, INFINITY) : nextafter(value, -INFINITY);
}

/** The largest change of any body's number of that kind, from place to place + 2 of a body, becomes that of all; what
 *  overflows is none. */
static void level_noise(struct equations *eq, int64_t place, const double *one, const double *other)
{
    const int64_t stride = equations_body_width(eq->model), n = eq->model->bodies.count;
    double most = 0.0;
    for (int64_t i = 0; i < n; ++i)
        for (int64_t c = i * stride + place; c < i * stride + place + 3; ++c)
            if (isfinite(one[c] - other[c]))
                most = fmax(most, fmax(eq->noise[c], stages * fabs(one[c] - other[c])));
    for (int64_t i = 0; i < n; ++i)
        for (int64_t c = i * stride + place; c < i * stride + place + 3; ++c)
            eq->noise[c] = most;
}

/** Once it does, the control knows of it. */
static int matters(const struct equations *eq)
{
    double most = 0.0;
    for (int64_t c = 0; c < equations_body_width(eq->model); ++c)
        most = fmax(most, eq->noise[c] / eq->unit[c]);
    return isfinite(eq->oscillation) && most * eq->oscillation > some * eq->tolerance;
}

/** Rates of a state and of one whose numbers are the next ones to these. The most that was ever found counts. */
static void look_at_noise(struct equations *eq, double t, const double *state)
{
    enum { AGAIN = 1024 };
    double *const other = eq->noise + eq->width, *const here = other + eq->width, *const there = here + eq->width;
    if (eq->evals < eq->next)
        return;
    for (int64_t k = 0; k < eq->width; ++k)
        other[k] = moved(state[k], k);
    if (rates(t, state, here, eq) == GSL_SUCCESS && rates(t, other, there, eq) == GSL_SUCCESS) {
        if (eq->model->translates)
            level_noise(eq, 3, here, there);
        if (eq->model->turns)
            level_noise(eq, equations_body_width(eq->model) - 3, here, there);
        if (matters(eq))
            control_stop_at(eq->driver->c, &eq->floor);
    }
    eq->next = eq->evals + AGAIN;
}

double equations_rounding_squared(const struct equations *eq)
{
    return eq->floor.squares / (stages * stages * eq->unit[eq->width - 1]);
}

/* ---- integration ------------------------------------------------------------------------------------------------- */

static const double first_step = 1e-4;
/* More than anybody waits for between two times at which the solution is asked for. */
static const double most_steps = 1e10;

/** No step is longer than evaluations may be apart, so that none of the 13 within it passes by a touch. */
static int bound_steps(struct equations *eq, struct message *message)
{
    if (model_longest_gap(eq->model, &eq->longest, message) != 0)
        return -1;
    if (!isfinite(eq->longest))
        return 0;
    if (gsl_odeiv2_driver_reset_hstart(eq->driver, fmin(first_step, eq->longest)) == GSL_SUCCESS &&
        gsl_odeiv2_driver_set_hmax(eq->driver, eq->longest) == GSL_SUCCESS)
        return 0;
    return message_set(message,
                       "%s: no reference solution can be had: what touches asks for steps of at most %.3g; check "
                       "diameters, masses and stiffnesses",
                       eq->model->scene->name, eq->longest);
}

/** 0 if it cannot be found. */
static double oscillation_of(const struct model *model)
{
    struct model_limits limits;
    struct message ignored;
    return model_find_limits(model, &limits, &ignored) == 0 ? model_limits_least(&limits) : 0.0;
}

/** Those of the scene; 1 where forces cannot be had. */
static void find_units(struct equations *eq)
{
    double *const state = eq->noise + eq->width, *const rate = state + eq->width;
    equations_start(eq->model, state);
    for (int64_t k = 0; k < eq->width; ++k)
        eq->unit[k] = 1.0;
    if (rates(0.0, state, rate, eq) == GSL_SUCCESS)
        units_of(eq->model, eq->width, state, rate, eq->unit);
    eq->evals = 0;
    control_in_units(eq->driver->c, eq->unit);
}

int equations_create(struct equations *eq, struct model *model, double tolerance, const struct watch *watch,
                     struct message *message)
{
    memset(eq, 0, sizeof *eq);
    gsl_set_error_handler_off();
    eq->model = model;
    eq->watch = watch;
    eq->tolerance = tolerance;
    eq->oscillation = oscillation_of(model);
    eq->width = equations_width(model);
    eq->system = (gsl_odeiv2_system){rates, NULL, (size_t)eq->width, eq};
    eq->loads = calloc((size_t)(6 * model->bodies.count), sizeof *eq->loads);
    eq->unit = calloc((size_t)eq->width, sizeof *eq->unit);
    eq->noise = calloc((size_t)(4 * eq->width), sizeof *eq->noise);
    eq->floor.noise = eq->noise;
    eq->driver = gsl_odeiv2_driver_alloc_y_new(&eq->system, gsl_odeiv2_step_rk8pd, first_step, tolerance, tolerance);
    gsl_odeiv2_control *control = control_new(tolerance);
    const int fits =
        eq->loads != NULL && eq->unit != NULL && eq->noise != NULL && eq->driver != NULL && control != NULL;
    if (!fits)
        message_set(message, "%s: out of memory for the reference solution; use fewer bodies", model->scene->name);
    if (fits && bound_steps(eq, message) == 0) {
        gsl_odeiv2_control_free(eq->driver->c);
        eq->driver->c = control;
        find_units(eq);
        return 0;
    }
    if (control != NULL)
        gsl_odeiv2_control_free(control);
    equations_destroy(eq);
    return -1;
}

void equations_destroy(struct equations *eq)
{
    if (eq->driver != NULL)
        gsl_odeiv2_driver_free(eq->driver);
    free(eq->loads);
    free(eq->unit);
    free(eq->noise);
    memset(eq, 0, sizeof *eq);
}

/** What stopped GSL, which has no words for it but "failure" and "problem with user-supplied function". */
static const char *reason(const struct equations *eq, int status)
{
    if (eq->status != VTI_OK)
        return model_text(eq->model, eq->status);
    return status == GSL_FAILURE ? "its error stays too large at the shortest step that t can tell"
                                 : gsl_strerror(status);
}

int equations_advance(struct equations *eq, double share, double *t, double to, double *state, struct message *message)
{
    eq->share = share;
    if ((to - *t) / eq->longest > most_steps)
        return message_set(message,
                           "%s: the reference solution would need steps of at most %.3g to see what touches; shorten "
                           "t_end or soften the scene",
                           eq->model->scene->name, eq->longest);
    look_at_noise(eq, *t, state);
    const int status = gsl_odeiv2_driver_apply(eq->driver, t, to, state);
    if (status == GSL_SUCCESS)
        return 0;
    if (eq->asked)
        return WATCH_ASKED;
    return message_set(message, "%s: the reference solution stopped at t = %.6g: %s; shorten t_end or soften the scene",
                       eq->model->scene->name, *t, reason(eq, status));
}
