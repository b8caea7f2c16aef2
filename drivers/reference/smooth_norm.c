/* SPDX-License-Identifier: BSD-3-Clause
 * The exact norm ||q||^2 on the panels of a smooth reference. */
#include <gsl/gsl_integration.h>
#include <math.h>

#include "smooth.h"

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

/* In pieces without a half turn (quaternion w = 0) of any body. */
double smooth_panel_integral(struct smooth *s, int64_t p, double end)
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
    if (s->sums_window != s->window) {
        s->sums[0] = smooth_sum_before(s, s->window);
        s->sums_known = 0;
        s->sums_window = s->window;
    }
    for (; s->sums_known < last - s->panels.first; ++s->sums_known) {
        vti_sum *next = &s->sums[s->sums_known + 1];
        *next = s->sums[s->sums_known];
        vti_sum_add(next, smooth_panel_integral(s, s->panels.first + s->sums_known, 1.0));
    }
    vti_sum sum = s->sums[last - s->panels.first];
    vti_sum_add(&sum, smooth_panel_integral(s, last, tau));
    return vti_sum_value(&sum);
}
