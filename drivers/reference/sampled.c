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

/** What is done once state k of the first solution or of the second is there. */
static double share_of(const struct sampled *s, const struct sampled_other *other, int second, int64_t k)
{
    const double share = (double)k / (double)(s->count - 1);
    return other != NULL ? share : 0.5 * (share + second);
}

static int see(const struct sampled *s, const struct sampled_other *other, const struct watch *watch, int second,
               int64_t k)
{
    return watch_see(watch, share_of(s, other, second, k)) ? WATCH_ASKED : 0;
}

/** From state k - 1 to state k. */
static int advance(const struct sampled *s, struct equations *eq, const struct sampled_other *other, int second,
                   int64_t k, double *t, double *state, struct message *message)
{
    return equations_advance(eq, share_of(s, other, second, k - 1), t, (double)k * s->interval, state, message);
}

static int meet(const struct sampled_other *other, int64_t k)
{
    return other != NULL ? other->at(other->self, k) : 0;
}

/** The solution that is kept. */
static int solve(struct sampled *s, struct equations *eq, const struct sampled_other *other, const struct watch *watch,
                 struct message *message)
{
    double t = 0.0, energy = 0.0;
    equations_start(s->model, s->states);
    for (int64_t k = 0; k < s->count; ++k) {
        double *state = s->states + k * s->width;
        if (k > 0) {
            memcpy(state, state - s->width, (size_t)s->width * sizeof *state);
            const int failed = advance(s, eq, other, 0, k, &t, state, message);
            if (failed != 0)
                return failed;
            if (see(s, other, watch, 0, k) != 0)
                return WATCH_ASKED;
        }
        const vti_bodies bodies = sampled_state(s, k);
        const double now = model_energy(s->model, &bodies);
        energy = k == 0 ? now : energy;
        s->energy_error = fmax(s->energy_error, fabs(now - energy));
        if (meet(other, k) != 0)
            return WATCH_ASKED;
    }
    return 0;
}

double sampled_relative(double change_squared, double norm_squared)
{
    return change_squared == 0.0 ? 0.0 : sqrt(change_squared / norm_squared);
}

/** The solution that it is compared with. */
static int compare(struct sampled *s, struct equations *eq, double *state, const struct sampled_other *other,
                   const struct watch *watch, struct message *message)
{
    double t = 0.0;
    vti_integral distance = {{0.0, 0.0}, 0.0, 0};
    equations_start(s->model, state);
    const vti_bodies other_bodies = equations_bodies(s->model, state);
    for (int64_t k = 0; k < s->count; ++k) {
        const int failed = k > 0 ? advance(s, eq, other, 1, k, &t, state, message) : 0;
        if (failed != 0)
            return failed;
        if ((k > 0 && see(s, other, watch, 1, k) != 0) || meet(other, k) != 0)
            return WATCH_ASKED;
        const vti_bodies kept = sampled_state(s, k);
        vti_integral_add(&distance, s->interval, vti_h1_distance(&other_bodies, &kept));
    }
    const double norm_squared = s->states[s->count * s->width - 1];
    s->spread = sampled_relative(vti_integral_value(&distance), norm_squared);
    return 0;
}

int sampled_solve(struct sampled *s, const struct sampled_other *other, const struct watch *watch,
                  struct message *message)
{
    struct equations eq;
    if (equations_create(&eq, s->model, step_tolerance, watch, message) != 0)
        return -1;
    const int failed = solve(s, &eq, other, watch, message);
    equations_destroy(&eq);
    return failed;
}

int sampled_compare(struct sampled *s, const struct sampled_other *other, const struct watch *watch,
                    struct message *message)
{
    struct equations eq;
    int failed = -1;
    double *state = calloc((size_t)s->width, sizeof *state);
    if (state == NULL)
        message_set(message, "%s: out of memory for the reference solution; use fewer bodies", s->model->scene->name);
    else if (equations_create(&eq, s->model, looser * step_tolerance, watch, message) == 0) {
        failed = compare(s, &eq, state, other, watch, message);
        equations_destroy(&eq);
    }
    free(state);
    return failed;
}
