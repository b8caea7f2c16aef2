/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "race.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "number.h"

int64_t race_steps(double t_end, double h)
{
    const int64_t steps = llrint(t_end / h);
    return steps > 0 ? steps : 1;
}

/* ---- errors ---------------------------------------------------------------------------------------------------------- */

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

/** Energy and momenta on the way. Returns 0, or -1 if they are no longer numbers. */
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
    return finite ? 0 : -1;
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

static double velocity_error(const vti_bodies *b, const vti_bodies *exact)
{
    vti_sum norm = {0.0, 0.0}, distance = {0.0, 0.0};
    add_squares(&b->v, &exact->v, b->count, &norm, &distance);
    add_squares(&b->omega, &exact->omega, b->count, &norm, &distance);
    const double n = vti_sum_value(&norm);
    return sqrt(vti_sum_value(&distance) / (n > 0.0 ? n : 1.0));
}

static int not_finite(const struct travel *travel, double h, struct message *message)
{
    return message_set(message, "%s at h = %s: at t = %.6g the state is no longer finite; use a smaller step",
                       travel->method->name, NUMBER(h), (double)travel->steps * h);
}

/** All steps, and energy and momenta at as many times. */
static int go_and_look(struct travel *travel, double h, int64_t looks, struct race_result *r)
{
    struct start start;
    start_look(&start, travel->model);
    for (int64_t k = 1; k <= looks; ++k) {
        const int64_t until = r->steps / looks * k + r->steps % looks * k / looks;
        if (until == travel->steps)
            continue;
        if (travel_go(travel, until - travel->steps, &r->message) != 0)
            return -1;
        const vti_bodies bodies = travel_bodies(travel);
        if (look(&start, travel->model, &bodies, r) != 0)
            return not_finite(travel, h, &r->message);
    }
    return 0;
}

static int at_the_end(struct travel *travel, double h, struct reference *reference, double t_end, struct race_result *r)
{
    if (reference_seek(reference, t_end, NULL, &r->message) != 0)
        return -1;
    const vti_bodies bodies = travel_bodies(travel), exact = reference_at(reference, t_end);
    r->attitude_error = vti_attitude_distance(&bodies, &exact);
    r->velocity_error = velocity_error(&bodies, &exact);
    r->force_evals = travel_force_evals(travel);
    return isfinite(r->attitude_error) && isfinite(r->velocity_error) ? 0 : not_finite(travel, h, &r->message);
}

/** A fresh run, with looks on the way, and the errors at its end. */
static int run(const struct scene *scene, const struct method *method, double h, double t_end, int64_t looks,
               struct reference *reference, struct race_result *r)
{
    struct model model;
    struct travel travel;
    if (model_create(scene, &model, &r->message) != 0)
        return -1;
    int failed = travel_create(&travel, method, &model, h, &r->message);
    if (failed == 0) {
        failed = go_and_look(&travel, h, looks, r);
        if (failed == 0)
            failed = at_the_end(&travel, h, reference, t_end, r);
        travel_destroy(&travel);
    }
    model_destroy(&model);
    return failed;
}

void race_measure(const struct scene *scene, const struct method *method, double h, double t_end,
                  struct reference *reference, struct race_result *r)
{
    memset(r, 0, sizeof *r);
    r->seconds = r->seconds_spread = NAN;
    r->steps = race_steps(t_end, h);
    r->failed = run(scene, method, h, t_end, RACE_LOOKS, reference, r) != 0;
    /* a rival that chooses its own steps has to end one at every look: what counts is the run without */
    if (!r->failed && method->stepper == NULL)
        r->failed = run(scene, method, h, t_end, 1, reference, r) != 0;
}

/* ---- times ----------------------------------------------------------------------------------------------------------- */

/** The processor's time for this thread: what others do on the same core is not charged to the run. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/** Seconds that reading the clock twice takes. */
static double clock_cost(void)
{
    double least = INFINITY;
    for (int k = 0; k < 64; ++k) {
        const double from = now();
        least = fmin(least, now() - from);
    }
    return least;
}

/** Seconds of one fresh run, or NaN. */
static double one_run(const struct scene *scene, const struct method *method, double h, int64_t steps,
                      struct message *message)
{
    struct model model;
    struct travel travel;
    double seconds = NAN;
    if (model_create(scene, &model, message) != 0)
        return NAN;
    if (travel_create(&travel, method, &model, h, message) == 0) {
        const double from = now();
        const int failed = travel_go(&travel, steps, message);
        seconds = failed == 0 ? now() - from : NAN;
        travel_destroy(&travel);
    }
    model_destroy(&model);
    return seconds;
}

double race_sample(const struct scene *scene, const struct method *method, double h, double t_end,
                   struct message *message)
{
    static const double long_enough = 1e-3;
    enum { MOST_RUNS = 1024 };
    const int64_t steps = race_steps(t_end, h);
    const double cost = clock_cost();
    double seconds = one_run(scene, method, h, steps, message);
    if (!(seconds < long_enough))
        return seconds;
    /* the first run found the caches cold, which is not what a short run is to be charged with */
    int runs = 0;
    for (seconds = 0.0; seconds < long_enough && runs < MOST_RUNS; ++runs)
        seconds += one_run(scene, method, h, steps, message) - cost;
    return seconds / runs;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void race_settle(double *samples, int n, struct race_result *result)
{
    qsort(samples, (size_t)n, sizeof *samples, ascending);
    const double median = 0.5 * (samples[(n - 1) / 2] + samples[n / 2]);
    result->seconds = samples[0];
    result->seconds_spread = (median - samples[0]) / samples[0];
}

void race_time(const struct scene *scene, const struct method *method, double h, double t_end, int repeats,
               struct race_result *result)
{
    double samples[RACE_REPEATS] = {0.0};
    const int n = repeats < 1 ? 1 : repeats < RACE_REPEATS ? repeats : RACE_REPEATS;
    result->seconds = result->seconds_spread = NAN;
    for (int k = 0; k < n; ++k) {
        samples[k] = race_sample(scene, method, h, t_end, &result->message);
        if (isnan(samples[k]))
            return;
    }
    race_settle(samples, n, result);
}
