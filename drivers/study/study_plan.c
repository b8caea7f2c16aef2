/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a plan comes to before anything is run: at which times runs are compared, how many steps each takes, and
 * whether its steppers can take its scene. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "study_parts.h"

enum { ORIGIN = 64 };

/** Where the reference can be read at any time, runs are compared at every step. Elsewhere at the multiples of the
 *  longest step, or of a multiple of it if the states would not fit into memory, which all steps must divide. */
static int choose_interval(struct study *study, struct message *message)
{
    const struct plan *plan = study->plan;
    study->t_end = plan->t_end;
    if (reference_is_smooth(&study->model))
        return 0;
    const double width = (double)equations_width(&study->model) * (double)sizeof(double);
    for (int64_t k = 0; k < plan->h_count; ++k)
        study->interval = fmax(study->interval, plan->h[k]);
    for (int64_t k = 0; k < plan->h_count; ++k) {
        const double ratio = study->interval / plan->h[k];
        if (fabs(ratio - rint(ratio)) > 1e-9 * ratio)
            return message_set(message,
                               "--h: %s does not divide the longest step %s, and runs of scenes with contacts, walls "
                               "or many bodies are compared at common times; use a ladder such as 1/1000:1/8000",
                               NUMBER(plan->h[k]), NUMBER(study->interval));
    }
    const double longest = study->interval;
    while (plan->t_end / study->interval * width > plan->memory)
        study->interval *= 2.0;
    study->thinned = study->interval / longest;
    if (study->thinned > 1.0 && study->interval > plan->t_end)
        return message_set(message, "--memory: %s bytes hold no two states of the reference solution; give more",
                           NUMBER(plan->memory));
    study->t_end = (double)loop_steps(plan->t_end, study->interval) * study->interval;
    return 0;
}

/** Where the steps come from, as messages begin. */
static const char *origin_of(const struct plan *plan, char text[ORIGIN])
{
    if (!plan->h_around)
        return "--h";
    snprintf(text, ORIGIN, "steps around the scene's h = %s", NUMBER(plan->scene->h));
    return text;
}

/** Before steps are counted. */
static int check_counts(const struct plan *plan, struct message *message)
{
    char origin[ORIGIN];
    for (int64_t k = 0; k < plan->h_count; ++k)
        if (!(plan->t_end / plan->h[k] <= LOOP_STEPS))
            return message_set(message, "%s: t_end = %s is more than 2^53 steps of h = %s; use a larger step",
                               origin_of(plan, origin), NUMBER(plan->t_end), NUMBER(plan->h[k]));
    return 0;
}

static int make_trials(struct study *study, struct message *message)
{
    const struct plan *plan = study->plan;
    char origin[ORIGIN];
    for (int64_t r = 0; r < study->runs; ++r) {
        const double h = plan->h[r % plan->h_count];
        struct trial *trial = &study->trials[r];
        *trial = trial_of(plan->steppers[r / plan->h_count], h, loop_steps(study->t_end, h));
        if (trial->steps < 1)
            return message_set(message, "%s: %s is longer than t_end = %s; %s", origin_of(plan, origin),
                               NUMBER(trial->h), NUMBER(plan->t_end),
                               plan->h_around ? "name smaller ones with --h" : "use a smaller step");
        if (trial->steps > (int64_t)1 << 40)
            return message_set(message, "%s: %s makes %lld steps to t_end = %s; use a larger step",
                               origin_of(plan, origin), NUMBER(trial->h), (long long)trial->steps, NUMBER(plan->t_end));
    }
    return 0;
}

static int allocate(struct study *study, int rank)
{
    const size_t runs = (size_t)study->runs;
    study->trials = calloc(runs, sizeof *study->trials);
    if (rank == 0) {
        study->outcomes = calloc(runs, sizeof *study->outcomes);
        study->ranks = calloc(runs, sizeof *study->ranks);
        study->orders = calloc((size_t)study->plan->steppers_count, sizeof *study->orders);
    }
    return study->trials != NULL &&
           (rank != 0 || (study->outcomes != NULL && study->ranks != NULL && study->orders != NULL));
}

int study_prepare(const struct plan *plan, int rank, struct study *study, struct message *message)
{
    memset(study, 0, sizeof *study);
    study->plan = plan;
    study->runs = plan->steppers_count * plan->h_count;
    if (!allocate(study, rank))
        return message_set(message, "out of memory for %lld runs", (long long)study->runs);
    if (check_counts(plan, message) != 0 || model_create(plan->scene, &study->model, message) != 0 ||
        choose_interval(study, message) != 0)
        return -1;
    return make_trials(study, message);
}

/** Whether each stepper can take the scene, which a run would say only after the reference. In a model of its own, as
 *  rivals may prepare something in it. */
static int check_steppers(const struct plan *plan, struct message *message)
{
    struct model model;
    double longest = 0.0;
    for (int64_t k = 0; k < plan->h_count; ++k)
        longest = fmax(longest, plan->h[k]);
    if (model_create(plan->scene, &model, message) != 0)
        return -1;
    int failed = 0;
    for (int64_t s = 0; failed == 0 && s < plan->steppers_count; ++s) {
        struct travel travel;
        failed = travel_create(&travel, plan->steppers[s], &model, longest, message);
        if (failed == 0)
            travel_destroy(&travel);
    }
    model_destroy(&model);
    return failed;
}

int study_prepare_checked(const struct plan *plan, int rank, struct study *study, struct message *message)
{
    return study_prepare(plan, rank, study, message) != 0 ? -1 : check_steppers(plan, message);
}

struct reference_span study_span(const struct study *study)
{
    const struct plan *plan = study->plan;
    struct reference_span span = {study->t_end, study->interval, INFINITY, plan->memory};
    for (int64_t k = 0; k < plan->h_count; ++k)
        span.finest = fmin(span.finest, plan->h[k]);
    return span;
}

int study_check(const struct plan *plan, struct message *message)
{
    struct study study;
    const int failed = study_prepare_checked(plan, 1, &study, message);
    study_destroy(&study);
    return failed;
}
