/* SPDX-License-Identifier: BSD-3-Clause */
#include "reference.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The tolerance of a step of rk8pd, and the share of the state that interpolation may add. */
static const double step_tolerance = 1e-14, interpolation_tolerance = 1e-13;
/* Panels are halved until the interpolants are that good, or until they would fill this much memory. */
static const double most_bytes = 1e9;
static const double first_panel = 0.5;

/* ---- the state as bodies --------------------------------------------------------------------------------------------- */

/** Doubles of one body in the state: x v if it translates, q Omega if it turns. */
static int64_t body_width(const struct scene *scene)
{
    return (scene->translates ? 6 : 0) + (scene->turns ? 7 : 0);
}

static vti_view vector_at(double *p, int64_t stride)
{
    const vti_view view = {{p, p + 1, p + 2}, stride};
    return view;
}

/** The state seen as bodies: nothing is copied. */
static vti_bodies state_bodies(const struct model *model, double *state)
{
    const struct scene *scene = model->scene;
    const int64_t stride = body_width(scene);
    vti_bodies b = vti_bodies_none(model->bodies.count);
    b.mass = model->bodies.mass;
    b.inertia = model->bodies.inertia;
    double *p = state;
    if (scene->translates) {
        b.x = vector_at(p, stride);
        b.v = vector_at(p + 3, stride);
        p += 6;
    }
    if (scene->turns) {
        const vti_quat_view quat = {{p, p + 1, p + 2, p + 3}, stride};
        b.quat = quat;
        b.omega = vector_at(p + 4, stride);
    }
    return b;
}

static void initial_state(const struct model *model, double *state)
{
    const vti_bodies *from = &model->bodies;
    vti_bodies to = state_bodies(model, state);
    for (int64_t i = 0; i < from->count; ++i) {
        for (int k = 0; k < 3 && model->scene->translates; ++k) {
            to.x.c[k][i * to.x.stride] = from->x.c[k][i * from->x.stride];
            to.v.c[k][i * to.v.stride] = from->v.c[k][i * from->v.stride];
        }
        if (model->scene->turns) {
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

/* ---- the continuous equations ---------------------------------------------------------------------------------------- */

struct equations {
    const struct model *model;
    double *loads; /* force and moment of every body */
};

/** One body's x' = v and v' = F/m. */
static void translation_rate(const vti_bodies *b, int64_t i, const double force[3], double *rate)
{
    for (int k = 0; k < 3; ++k) {
        rate[k] = b->v.c[k][i * b->v.stride];
        rate[3 + k] = force[k] / b->mass.p[i * b->mass.stride];
    }
}

/** One body's q' = (1/2) Omega q and Omega' = RM/J. */
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
    for (int k = 0; k < 3; ++k)
        rate[4 + k] = moment[k] / b->inertia.p[i * b->inertia.stride];
}

static int rates(double t, const double state[], double rate[], void *self)
{
    const struct equations *eq = self;
    const struct scene *scene = eq->model->scene;
    const int64_t stride = body_width(scene), n = eq->model->bodies.count;
    /* GSL promises not to have its state changed; the views are only read */
    vti_bodies b = state_bodies(eq->model, (double *)state);
    b.force = scene->translates ? vector_at(eq->loads, 6) : vti_view_none();
    b.moment = scene->turns ? vector_at(eq->loads + 3, 6) : vti_view_none();
    (void)t;
    if (model_forces(eq->model, &b) != VTI_OK)
        return GSL_EBADFUNC;
    for (int64_t i = 0; i < n; ++i) {
        double *r = rate + i * stride;
        if (scene->translates)
            translation_rate(&b, i, eq->loads + 6 * i, r);
        if (scene->turns)
            rotation_rate(&b, i, eq->loads + 6 * i + 3, r + (scene->translates ? 6 : 0));
    }
    return GSL_SUCCESS;
}

/* ---- integration --------------------------------------------------------------------------------------------------- */

/** One pass over all panels. */
static int integrate(struct reference *r, struct message *message)
{
    struct equations eq = {r->model, NULL};
    const struct panels *panels = &r->panels;
    gsl_odeiv2_system system = {rates, NULL, (size_t)panels->width, &eq};
    const double first_step = panels->t_end / (double)(panels->count * PANELS_NODES);
    eq.loads = calloc((size_t)(6 * r->model->bodies.count), sizeof *eq.loads);
    gsl_odeiv2_driver *driver =
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first_step, step_tolerance, step_tolerance);
    int status = eq.loads != NULL && driver != NULL ? GSL_SUCCESS : GSL_ENOMEM;
    double t = 0.0;
    r->energy_error = r->interpolation_error = 0.0;
    initial_state(r->model, r->state);
    const vti_bodies bodies = state_bodies(r->model, r->state);
    const double energy = model_energy(r->model, &bodies);
    for (int64_t p = 0; p < panels->count && status == GSL_SUCCESS; ++p) {
        for (int k = 0; k < PANELS_NODES && status == GSL_SUCCESS; ++k) {
            status = gsl_odeiv2_driver_apply(driver, &t, panels_time(panels, p, panels->node[k]), r->state);
            memcpy(panels_row(panels, p, k), r->state, (size_t)panels->width * sizeof *r->state);
        }
        r->energy_error = fmax(r->energy_error, fabs(model_energy(r->model, &bodies) - energy));
        r->interpolation_error = fmax(r->interpolation_error, panels_tail(panels, p));
    }
    gsl_odeiv2_driver_free(driver);
    free(eq.loads);
    if (status != GSL_SUCCESS)
        return message_set(message,
                           "%s: the reference solution stopped at t = %.6g: %s; shorten t_end or soften the scene",
                           r->model->scene->name, t, gsl_strerror(status));
    return 0;
}

/** Halves the panels until the interpolants are as good as the steps. */
static int integrate_until_smooth(struct reference *r, double t_end, struct message *message)
{
    const int64_t width = r->model->bodies.count * body_width(r->model->scene);
    for (int64_t count = (int64_t)ceil(t_end / first_panel);; count *= 2) {
        if (panels_create(&r->panels, width, count, t_end) != 0)
            return message_set(message, "%s: out of memory for the reference solution; shorten t_end",
                               r->model->scene->name);
        if (integrate(r, message) != 0)
            return -1;
        const double next = 2.0 * (double)(count * PANELS_NODES * width) * (double)sizeof(double);
        if (r->interpolation_error <= interpolation_tolerance || next > most_bytes)
            return 0;
    }
}

/* ---- sharing ---------------------------------------------------------------------------------------------------------- */

/** MPI counts are int: large arrays travel in pieces. */
static void broadcast(double *p, int64_t n, MPI_Comm comm)
{
    for (int64_t done = 0; done < n;) {
        const int64_t left = n - done;
        const int piece = left < (1 << 24) ? (int)left : 1 << 24;
        MPI_Bcast(p + done, piece, MPI_DOUBLE, 0, comm);
        done += piece;
    }
}

/** Gives every rank the panels of rank 0. */
static int share(struct reference *r, double t_end, MPI_Comm comm, int failed, struct message *message)
{
    int rank;
    int64_t size[2] = {r->panels.width, r->panels.count};
    MPI_Comm_rank(comm, &rank);
    MPI_Bcast(&failed, 1, MPI_INT, 0, comm);
    MPI_Bcast(size, 2, MPI_INT64_T, 0, comm);
    if (failed == 0 && rank != 0 && panels_create(&r->panels, size[0], size[1], t_end) != 0)
        failed = message_set(message, "%s: out of memory for the reference solution", r->model->scene->name);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    if (failed != 0)
        return -1;
    double quality[2] = {r->energy_error, r->interpolation_error};
    broadcast(r->panels.values, size[0] * size[1] * PANELS_NODES, comm);
    broadcast(quality, 2, comm);
    r->energy_error = quality[0];
    r->interpolation_error = quality[1];
    return 0;
}

int reference_create(const struct model *model, double t_end, MPI_Comm comm, struct reference *r,
                     struct message *message)
{
    int rank, failed = 0;
    MPI_Comm_rank(comm, &rank);
    memset(r, 0, sizeof *r);
    r->model = model;
    gsl_set_error_handler_off();
    r->state = calloc((size_t)(model->bodies.count * body_width(model->scene)), sizeof *r->state);
    if (r->state == NULL)
        failed = message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    if (failed == 0 && rank == 0)
        failed = integrate_until_smooth(r, t_end, message);
    if (share(r, t_end, comm, failed, message) == 0)
        return 0;
    reference_destroy(r);
    return -1;
}

void reference_destroy(struct reference *r)
{
    panels_destroy(&r->panels);
    free(r->state);
    r->state = NULL;
}

vti_bodies reference_at(struct reference *r, double t)
{
    double tau;
    const int64_t p = panels_find(&r->panels, t, &tau);
    panels_read(&r->panels, p, tau, r->state);
    return state_bodies(r->model, r->state);
}

/* ---- the exact norm ---------------------------------------------------------------------------------------------------- */

/** The next tau after from, up to to, where component c changes its sign between two nodes, or to. */
static double next_sign_change(const struct panels *panels, int64_t p, int64_t c, double from, double to)
{
    double low = from, value = panels_read_one(panels, p, from, c);
    for (int k = 0; k <= PANELS_NODES; ++k) {
        double high = k < PANELS_NODES ? panels->node[k] : to;
        if (high <= low || high > to)
            continue;
        if (signbit(panels_read_one(panels, p, high, c)) == signbit(value)) {
            low = high;
            continue;
        }
        while (0.5 * (low + high) > low && 0.5 * (low + high) < high) {
            const double middle = 0.5 * (low + high);
            if (signbit(panels_read_one(panels, p, middle, c)) == signbit(value))
                low = middle;
            else
                high = middle;
        }
        return high;
    }
    return to;
}

/** The integral of the norm's integrand over [from, to] of panel p, on which it is smooth. */
static double smooth_integral(struct reference *r, int64_t p, double from, double to)
{
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(PANELS_NODES);
    double sum = 0.0;
    for (size_t k = 0; k < PANELS_NODES; ++k) {
        double tau, weight;
        gsl_integration_glfixed_point(from, to, k, &tau, &weight, rule);
        panels_read(&r->panels, p, tau, r->state);
        const vti_bodies bodies = state_bodies(r->model, r->state);
        sum += weight * vti_h1_density(&bodies);
    }
    gsl_integration_glfixed_table_free(rule);
    return sum * 0.5 * r->panels.t_end / (double)r->panels.count;
}

/** From the start of panel p to tau, in pieces without a half turn (quaternion w = 0) of any body. */
static double panel_integral(struct reference *r, int64_t p, double end)
{
    const struct scene *scene = r->model->scene;
    const int64_t width = body_width(scene), w = (scene->translates ? 6 : 0) + 3;
    vti_sum sum = {0.0, 0.0};
    double from = -1.0;
    while (from < end) {
        double to = end;
        for (int64_t i = 0; scene->turns && i < r->model->bodies.count; ++i)
            to = next_sign_change(&r->panels, p, i * width + w, from, to);
        vti_sum_add(&sum, smooth_integral(r, p, from, to));
        from = to;
    }
    return vti_sum_value(&sum);
}

double reference_norm_squared(struct reference *r, double t)
{
    double tau;
    const int64_t last = panels_find(&r->panels, t, &tau);
    vti_sum sum = {0.0, 0.0};
    for (int64_t p = 0; p <= last; ++p)
        vti_sum_add(&sum, panel_integral(r, p, p < last ? 1.0 : tau));
    return vti_sum_value(&sum);
}
