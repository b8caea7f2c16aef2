/* SPDX-License-Identifier: BSD-3-Clause */
#include "smooth.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The tolerance of a step of rk8pd, and the share of the state that interpolation may add. */
static const double step_tolerance = 1e-14, interpolation_tolerance = 1e-13;
/* Panels are halved until the interpolants are that good, or until they would fill this much memory. */
static const double most_bytes = 1e9;
static const double first_panel = 0.5;

int smooth_create(struct smooth *s, struct model *model, struct message *message)
{
    memset(s, 0, sizeof *s);
    s->model = model;
    s->state = calloc((size_t)equations_width(model), sizeof *s->state);
    return s->state != NULL ? 0 : message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
}

void smooth_destroy(struct smooth *s)
{
    panels_destroy(&s->panels);
    free(s->state);
    s->state = NULL;
}

/* ---- integration ----------------------------------------------------------------------------------------------------- */

/** One pass over all panels. */
static int one_pass(struct smooth *s, struct equations *eq, struct message *message)
{
    const struct panels *panels = &s->panels;
    const vti_bodies bodies = equations_bodies(s->model, s->state);
    double t = 0.0;
    s->energy_error = s->interpolation_error = 0.0;
    equations_start(s->model, s->state);
    const double energy = model_energy(s->model, &bodies);
    for (int64_t p = 0; p < panels->count; ++p) {
        for (int k = 0; k < PANELS_NODES; ++k) {
            if (equations_advance(eq, &t, panels_time(panels, p, panels->node[k]), s->state, message) != 0)
                return -1;
            memcpy(panels_row(panels, p, k), s->state, (size_t)panels->width * sizeof *s->state);
        }
        s->energy_error = fmax(s->energy_error, fabs(model_energy(s->model, &bodies) - energy));
        s->interpolation_error = fmax(s->interpolation_error, panels_tail(panels, p));
    }
    return 0;
}

int smooth_integrate(struct smooth *s, double t_end, struct message *message)
{
    const int64_t width = equations_width(s->model) - 1;
    for (int64_t count = (int64_t)ceil(t_end / first_panel);; count *= 2) {
        struct equations eq;
        if (panels_create(&s->panels, width, count, t_end) != 0 || equations_create(&eq, s->model, step_tolerance) != 0)
            return message_set(message, "%s: out of memory for the reference solution; shorten t_end",
                               s->model->scene->name);
        const int failed = one_pass(s, &eq, message);
        equations_destroy(&eq);
        const double next = 2.0 * (double)(count * PANELS_NODES * width) * (double)sizeof(double);
        if (failed != 0 || s->interpolation_error <= interpolation_tolerance || next > most_bytes)
            return failed;
    }
}

vti_bodies smooth_at(struct smooth *s, double t)
{
    double tau;
    const int64_t p = panels_find(&s->panels, t, &tau);
    panels_read(&s->panels, p, tau, s->state);
    return equations_bodies(s->model, s->state);
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
static double smooth_integral(struct smooth *s, int64_t p, double from, double to)
{
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(PANELS_NODES);
    double sum = 0.0;
    for (size_t k = 0; k < PANELS_NODES; ++k) {
        double tau, weight;
        gsl_integration_glfixed_point(from, to, k, &tau, &weight, rule);
        panels_read(&s->panels, p, tau, s->state);
        const vti_bodies bodies = equations_bodies(s->model, s->state);
        sum += weight * vti_h1_density(&bodies);
    }
    gsl_integration_glfixed_table_free(rule);
    return sum * 0.5 * s->panels.t_end / (double)s->panels.count;
}

/** From the start of panel p to tau, in pieces without a half turn (quaternion w = 0) of any body. */
static double panel_integral(struct smooth *s, int64_t p, double end)
{
    const int64_t width = equations_body_width(s->model), w = (s->model->translates ? 6 : 0) + 3;
    vti_sum sum = {0.0, 0.0};
    double from = -1.0;
    while (from < end) {
        double to = end;
        for (int64_t i = 0; s->model->turns && i < s->model->bodies.count; ++i)
            to = next_sign_change(&s->panels, p, i * width + w, from, to);
        vti_sum_add(&sum, smooth_integral(s, p, from, to));
        from = to;
    }
    return vti_sum_value(&sum);
}

double smooth_norm_squared(struct smooth *s, double t)
{
    double tau;
    const int64_t last = panels_find(&s->panels, t, &tau);
    vti_sum sum = {0.0, 0.0};
    for (int64_t p = 0; p <= last; ++p)
        vti_sum_add(&sum, panel_integral(s, p, p < last ? 1.0 : tau));
    return vti_sum_value(&sum);
}
