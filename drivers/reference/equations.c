/* SPDX-License-Identifier: BSD-3-Clause */
#include "equations.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

#include "control.h"
#include "euler.h"

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

/* ---- integration ------------------------------------------------------------------------------------------------- */

int equations_create(struct equations *eq, struct model *model, double tolerance, const struct watch *watch)
{
    static const double first_step = 1e-4;
    memset(eq, 0, sizeof *eq);
    gsl_set_error_handler_off();
    eq->model = model;
    eq->watch = watch;
    eq->width = equations_width(model);
    eq->system = (gsl_odeiv2_system){rates, NULL, (size_t)eq->width, eq};
    eq->loads = calloc((size_t)(6 * model->bodies.count), sizeof *eq->loads);
    eq->driver = gsl_odeiv2_driver_alloc_y_new(&eq->system, gsl_odeiv2_step_rk8pd, first_step, tolerance, tolerance);
    gsl_odeiv2_control *control = control_new(tolerance);
    if (eq->loads != NULL && eq->driver != NULL && control != NULL) {
        gsl_odeiv2_control_free(eq->driver->c);
        eq->driver->c = control;
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
    const int status = gsl_odeiv2_driver_apply(eq->driver, t, to, state);
    if (status == GSL_SUCCESS)
        return 0;
    if (eq->asked)
        return WATCH_ASKED;
    return message_set(message, "%s: the reference solution stopped at t = %.6g: %s; shorten t_end or soften the scene",
                       eq->model->scene->name, *t, reason(eq, status));
}
