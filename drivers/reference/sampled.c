/* SPDX-License-Identifier: BSD-3-Clause */
#include "sampled.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Steps across a kink cost accuracy and are cut short by the error control; a tolerance nearer to rounding does not
 * help. */
static const double step_tolerance = 1e-13, looser = 100.0;

int sampled_create(struct sampled *s, struct model *model, double interval, int64_t intervals, struct message *message)
{
    memset(s, 0, sizeof *s);
    s->model = model;
    s->width = equations_width(model);
    s->interval = interval;
    s->count = intervals + 1;
    s->states = calloc((size_t)(s->count * s->width), sizeof *s->states);
    if (s->states == NULL)
        return message_set(message, "%s: out of memory for the reference solution; shorten t_end", model->scene->name);
    s->seen = sampled_state(s, 0);
    const int status = vti_bodies_seal(&s->seen);
    return status == VTI_OK ? 0 : message_set(message, "%s: %s", model->scene->name, vti_status_text(status));
}

void sampled_destroy(struct sampled *s)
{
    free(s->states);
    s->states = NULL;
}

vti_bodies sampled_state(struct sampled *s, int64_t k)
{
    return equations_bodies(s->model, s->states + k * s->width);
}

const vti_bodies *sampled_step(struct sampled *s, int64_t k)
{
    equations_look_at(s->model, &s->seen, s->states + k * s->width);
    return &s->seen;
}

/** State k of those of two solutions is there. */
static int see(const struct sampled *s, const struct watch *watch, int64_t k)
{
    return watch_see(watch, 0.5 * (double)k / (double)(s->count - 1)) ? WATCH_ASKED : 0;
}

/** The solution that is kept. */
static int integrate(struct sampled *s, struct equations *eq, const struct watch *watch, struct message *message)
{
    double t = 0.0, energy = 0.0;
    equations_start(s->model, s->states);
    for (int64_t k = 0; k < s->count; ++k) {
        double *state = s->states + k * s->width;
        if (k > 0) {
            memcpy(state, state - s->width, (size_t)s->width * sizeof *state);
            if (equations_advance(eq, &t, (double)k * s->interval, state, message) != 0)
                return -1;
            if (see(s, watch, k) != 0)
                return WATCH_ASKED;
        }
        const vti_bodies bodies = sampled_state(s, k);
        const double now = model_energy(s->model, &bodies);
        energy = k == 0 ? now : energy;
        s->energy_error = fmax(s->energy_error, fabs(now - energy));
    }
    return 0;
}

/** The solution that it is compared with. */
static int compare(struct sampled *s, struct equations *eq, double *state, const struct watch *watch,
                   struct message *message)
{
    double t = 0.0;
    vti_integral distance = {{0.0, 0.0}, 0.0, 0};
    equations_start(s->model, state);
    const vti_bodies other = equations_bodies(s->model, state);
    for (int64_t k = 0; k < s->count; ++k) {
        if (k > 0 && equations_advance(eq, &t, (double)k * s->interval, state, message) != 0)
            return -1;
        if (k > 0 && see(s, watch, s->count - 1 + k) != 0)
            return WATCH_ASKED;
        const vti_bodies kept = sampled_state(s, k);
        vti_integral_add(&distance, s->interval, vti_h1_distance(&other, &kept));
    }
    const double norm_squared = s->states[s->count * s->width - 1];
    s->spread = sqrt(vti_integral_value(&distance) / norm_squared);
    return 0;
}

int sampled_integrate(struct sampled *s, const struct watch *watch, struct message *message)
{
    struct equations eq;
    int failed = equations_create(&eq, s->model, step_tolerance);
    if (failed == 0) {
        failed = integrate(s, &eq, watch, message);
        equations_destroy(&eq);
    }
    double *state = calloc((size_t)s->width, sizeof *state);
    if (failed == 0 && state != NULL && equations_create(&eq, s->model, looser * step_tolerance) == 0) {
        failed = compare(s, &eq, state, watch, message);
        equations_destroy(&eq);
    }
    free(state);
    return failed;
}
