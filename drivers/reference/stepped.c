/* SPDX-License-Identifier: BSD-3-Clause
 *
 * chin4 is another map than those of the paper and than exact, and of their order where something dissipates, with
 * smaller errors; a fourth of their step leaves a sixteenth of their errors or less. */
#include "stepped.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "travel.h"

enum { RUNS = 3 }; /* of steps 4 h, 2 h and h */

/** One run on its way. */
struct pass {
    struct sampled *sampled;
    struct model model;
    const double *before; /* states of the run before, or NULL */
    vti_integral distance, norm;
    double h, energy, energy_error;
    int64_t steps; /* in an interval */
    int run, asked;
    const struct watch *watch;
};

/** The energy that is constant but for the steps: with what effects have booked. */
static double ledger(struct model *model, const vti_bodies *bodies)
{
    return model_energy(model, bodies) + vti_booked(model->effects, model->effects_count);
}

static int see(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct pass *p = self;
    struct sampled *s = p->sampled;
    (void)t;
    vti_integral_add(&p->norm, p->h, vti_h1_density(bodies));
    if (step % p->steps != 0)
        return 0;
    const int64_t k = step / p->steps;
    double *state = s->states + k * s->width;
    equations_take(s->model, bodies, state);
    state[s->width - 1] = vti_integral_value(&p->norm);
    if (p->before != NULL) {
        const vti_bodies other = equations_bodies(s->model, (double *)p->before + k * s->width),
                         here = equations_bodies(s->model, state);
        vti_integral_add(&p->distance, s->interval, vti_h1_distance(&other, &here));
    }
    const double now = ledger(&p->model, bodies);
    p->energy = k == 0 ? now : p->energy;
    p->energy_error = fmax(p->energy_error, fabs(now - p->energy));
    p->asked = watch_see(p->watch, ((double)k / (double)(s->count - 1) + p->run) / RUNS);
    return p->asked;
}

static int go(struct pass *p, struct message *message)
{
    const struct sampled *s = p->sampled;
    struct travel travel;
    const struct observer observer = {see, p, 1, 0, NULL, NULL};
    if (model_create(s->model->scene, &p->model, message) != 0)
        return -1;
    int failed = travel_create(&travel, vti_stepper_find("chin4"), &p->model, p->h, message);
    if (failed == 0) {
        failed = travel_show(&travel, p->steps * (s->count - 1), &observer, 1, message);
        travel_destroy(&travel);
    }
    model_destroy(&p->model);
    return p->asked ? WATCH_ASKED : failed;
}

/** What halving h has changed last falls by a factor with each further halving that the two changes show, 4 for order
 *  2, and its sum is left; where it does not fall, no more than the change itself is told. */
static double left_over(double change_before, double change)
{
    const double factor = fmin(change_before / change, 4.0);
    return factor > 2.0 ? change / (factor - 1.0) : change;
}

int stepped_solve(struct sampled *s, double finest, const struct watch *watch, struct message *message)
{
    const int64_t coarsest = (int64_t)ceil(s->interval / finest);
    double change[RUNS] = {0.0, 0.0, 0.0};
    double *before = calloc((size_t)(s->count * s->width), sizeof *before);
    int failed = 0;
    if (before == NULL)
        return message_set(message, "%s: out of memory for the reference solution; shorten t_end",
                           s->model->scene->name);
    for (int run = 0; run < RUNS && failed == 0; ++run) {
        struct pass pass = {.sampled = s, .steps = coarsest << run, .run = run, .watch = watch};
        pass.h = s->interval / (double)pass.steps;
        if (run > 0) {
            memcpy(before, s->states, (size_t)(s->count * s->width) * sizeof *before);
            pass.before = before;
        }
        failed = go(&pass, message);
        change[run] = sqrt(vti_integral_value(&pass.distance));
        s->energy_error = pass.energy_error;
    }
    if (failed == 0) {
        const double norm = sqrt(s->states[s->count * s->width - 1]);
        s->spread = change[2] > 0.0 ? left_over(change[1], change[2]) / norm : 0.0;
    }
    free(before);
    return failed;
}
