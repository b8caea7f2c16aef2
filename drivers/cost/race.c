/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "number.h"

/** Steps of h to t_end, of which h must be a whole fraction (to rounding). */
static int64_t race_steps(double t_end, double h)
{
    const int64_t steps = llrint(t_end / h);
    return steps > 0 ? steps : 1;
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

/** What stays as it is, before the first step. */
struct start {
    double energy, invariants[MODEL_INVARIANTS];
    struct invariant invariant[MODEL_INVARIANTS];
    int64_t count;
};

static void start_look(struct start *start, struct model *model)
{
    start->energy = model_energy(model, &model->bodies);
    start->count = model_invariants(model, start->invariant);
    model_invariant_values(model, &model->bodies, start->invariants);
}

/** Energy and momenta on the way. Returns 0, or 1 if they are no longer numbers. */
static int look(const struct start *start, struct model *model, const vti_bodies *bodies, struct race_result *r)
{
    const double scale = start->energy != 0.0 ? fabs(start->energy) : 1.0;
    const double energy_error = fabs(model_energy(model, bodies) - start->energy) / scale;
    double now[MODEL_INVARIANTS] = {0.0};
    model_invariant_values(model, bodies, now);
    r->energy_error = fmax(r->energy_error, energy_error);
    int finite = isfinite(energy_error);
    for (int64_t k = 0; k < start->count; ++k) {
        const double deviation = fabs(now[k] - start->invariants[k]);
        finite = finite && isfinite(deviation);
        if (start->invariant[k].is_momentum)
            r->momentum_error = fmax(r->momentum_error, deviation);
    }
    return !finite;
}

/** Adds the squares of one view's values and of its differences from the reference's. */
static void add_squares(const vti_view *view, const vti_view *reference, int64_t n, vti_sum *norm, vti_sum *distance)
{
    if (view->c[0] == NULL)
        return;
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            const double exact = reference->c[k][i * reference->stride];
            const double off = view->c[k][i * view->stride] - exact;
            vti_sum_add(norm, exact * exact);
            vti_sum_add(distance, off * off);
        }
}

double race_velocity_error(const vti_bodies *b, const vti_bodies *exact)
{
    vti_sum norm = {0.0, 0.0}, distance = {0.0, 0.0};
    add_squares(&b->v, &exact->v, b->count, &norm, &distance);
    add_squares(&b->omega, &exact->omega, b->count, &norm, &distance);
    const double n = vti_sum_value(&norm);
    return sqrt(vti_sum_value(&distance) / (n > 0.0 ? n : 1.0));
}

double race_position_error(const vti_bodies *b, const vti_bodies *exact)
{
    double most = 0.0;
    for (int64_t i = 0; b->x.c[0] != NULL && i < b->count; ++i) {
        double square = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double off = b->x.c[k][i * b->x.stride] - exact->x.c[k][i * exact->x.stride];
            square += off * off;
        }
        most = square > most || isnan(square) ? square : most;
    }
    return sqrt(most);
}

static int not_finite(const struct trial_run *run, struct message *message)
{
    const struct trial *trial = run->trial;
    return message_set(message, "%s at h = %s: at t = %.6g the state is no longer finite; use a smaller step",
                       trial->stepper->name, NUMBER(trial->h), (double)run->travel.steps * trial->h);
}

struct looker {
    struct start start;
    struct model *model;
    struct race_result *result;
};

static int see(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct looker *l = self;
    (void)t;
    return step == 0 ? 0 : look(&l->start, l->model, bodies, l->result);
}

/** All steps, and energy and momenta at every so many. */
static int go_and_look(struct trial_run *run, int64_t every, struct race_result *r)
{
    struct looker looker = {.model = &run->model, .result = r};
    const struct observer observer = {see, &looker, every, 0, NULL, NULL};
    start_look(&looker.start, &run->model);
    const int result = trial_go(run, r->steps, &observer, 1, &r->message);
    return result > 0 ? not_finite(run, &r->message) : result;
}

static int at_the_end(struct trial_run *run, struct reference *reference, double t_end, struct race_result *r)
{
    if (reference_seek(reference, t_end, NULL, &r->message) != 0)
        return -1;
    const vti_bodies bodies = travel_bodies(&run->travel), exact = reference_at(reference, t_end);
    r->attitude_error = vti_attitude_distance(&bodies, &exact);
    r->position_error = race_position_error(&bodies, &exact);
    r->velocity_error = race_velocity_error(&bodies, &exact);
    r->force_evals = travel_force_evals(&run->travel);
    return isfinite(r->attitude_error + r->position_error + r->velocity_error) ? 0 : not_finite(run, &r->message);
}

/** A fresh run, looked at every so many steps, and the errors at its end. */
static int one_race(const struct scene *scene, const struct trial *trial, double t_end, int64_t every,
                    struct reference *reference, struct race_result *r)
{
    struct trial_run run;
    if (trial_begin(&run, scene, trial, &r->message) != 0)
        return -1;
    int failed = go_and_look(&run, every, r);
    if (failed == 0)
        failed = at_the_end(&run, reference, t_end, r);
    trial_end(&run);
    return failed;
}

void race_measure(const struct scene *scene, const vti_stepper *stepper, double h, double t_end,
                  struct reference *reference, struct race_result *r)
{
    const struct trial trial = trial_of(stepper, h, race_steps(t_end, h));
    memset(r, 0, sizeof *r);
    r->seconds = r->seconds_spread = NAN;
    r->steps = trial.steps;
    r->failed = one_race(scene, &trial, t_end, trial_look_every(&trial), reference, r) != 0;
    /* a rival that chooses its own steps has to end one at every look: what counts is the run without */
    if (!r->failed && method_varies(stepper))
        r->failed = one_race(scene, &trial, t_end, r->steps, reference, r) != 0;
}

/* ---- times ------------------------------------------------------------------------------------------------------- */

double race_clock_cost(void)
{
    double least = INFINITY;
    for (int k = 0; k < 64; ++k) {
        const double from = clock_of_thread();
        least = fmin(least, clock_of_thread() - from);
    }
    return least;
}

/** Seconds of one fresh run, or NaN. */
static double one_run(const struct scene *scene, const struct trial *trial, struct message *message)
{
    struct trial_run run;
    if (trial_begin(&run, scene, trial, message) != 0)
        return NAN;
    const int failed = trial_go(&run, trial->steps, NULL, 0, message);
    trial_end(&run);
    return failed == 0 ? run.seconds : NAN;
}

double race_sample(const struct scene *scene, const vti_stepper *stepper, double h, double t_end,
                   struct message *message)
{
    static const double long_enough = 1e-3;
    enum { MOST_RUNS = 1024 };
    const struct trial trial = trial_of(stepper, h, race_steps(t_end, h));
    const double cost = race_clock_cost();
    double seconds = one_run(scene, &trial, message);
    if (!(seconds < long_enough))
        return seconds;
    /* the first run found the caches cold, which is not what a short run is to be charged with */
    int runs = 0;
    for (seconds = 0.0; seconds < long_enough && runs < MOST_RUNS; ++runs)
        seconds += one_run(scene, &trial, message) - cost;
    return seconds / runs;
}

double race_median(double *value, int64_t n)
{
    int64_t known = 0;
    for (int64_t k = 0; k < n; ++k)
        if (!isnan(value[k]))
            value[known++] = value[k];
    qsort(value, (size_t)known, sizeof *value, number_ascending);
    return known == 0 ? NAN : 0.5 * (value[(known - 1) / 2] + value[known / 2]);
}

void race_settle(double *samples, int n, struct race_result *result)
{
    const double median = race_median(samples, n);
    result->seconds = samples[0];
    result->seconds_spread = (median - samples[0]) / samples[0];
}
