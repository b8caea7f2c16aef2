/* SPDX-License-Identifier: BSD-3-Clause */
#include "study.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "queue.h"

const char *const study_measures[STUDY_MEASURES] = {"e_error", "q_error", "h1_error", "attitude_error"};

double study_measure(const struct outcome *outcome, int measure)
{
    const double values[STUDY_MEASURES] = {outcome->e_error, outcome->q_error, outcome->h1_error,
                                           outcome->attitude_error};
    return values[measure];
}

/* ---- the plan ---------------------------------------------------------------------------------------------------- */

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
    while (plan->t_end / study->interval * width > plan->memory)
        study->interval *= 2.0;
    study->t_end = (double)loop_steps(plan->t_end, study->interval) * study->interval;
    return 0;
}

static int make_trials(struct study *study, struct message *message)
{
    const struct plan *plan = study->plan;
    for (int64_t r = 0; r < study->runs; ++r) {
        const double h = plan->h[r % plan->h_count];
        struct trial *trial = &study->trials[r];
        *trial = trial_of(plan->steppers[r / plan->h_count], h, loop_steps(study->t_end, h));
        if (trial->steps < 1)
            return message_set(message, "--h: %s is longer than t_end = %s; use a smaller step", NUMBER(trial->h),
                               NUMBER(plan->t_end));
        if (trial->steps > (int64_t)1 << 40)
            return message_set(message, "--h: %s makes %lld steps to t_end = %s; use a larger step", NUMBER(trial->h),
                               (long long)trial->steps, NUMBER(plan->t_end));
    }
    return 0;
}

/* ---- the runs as tasks ------------------------------------------------------------------------------------------- */

struct work {
    struct study *study;
    struct reference *reference;
    const struct study_watch *watch;
    const struct store *store;
    struct message *message;
    double start;
    int64_t steps_all, steps_done; /* of the runs that the store does not hold */
};

static void run_task(void *self, int64_t task, queue_poll poll, void *poll_self, void *result)
{
    const struct work *w = self;
    const struct study *study = w->study;
    const struct trial *trial = &study->trials[task];
    const int64_t compare_every = study->interval > 0.0 ? llrint(study->interval / trial->h) : 1;
    outcome_of(study->plan->scene, trial, compare_every, w->reference, poll, poll_self, result);
}

static void show(struct work *w, int64_t extra)
{
    study_show(w->watch, "runs", w->steps_done + extra, w->steps_all, MPI_Wtime() - w->start);
}

static int task_done(void *self, int64_t task, int rank, const void *result)
{
    struct work *w = self;
    const struct outcome *outcome = memcpy(&w->study->outcomes[task], result, sizeof *outcome);
    w->study->ranks[task] = rank;
    w->steps_done += w->study->trials[task].steps;
    show(w, 0);
    if (outcome->failed) {
        w->study->refused = 1;
        *w->message = outcome->message;
        return 1;
    }
    return w->store != NULL ? w->store->keep(w->store->self, task, rank, result, w->message) : 0;
}

/** Takes what the store has and leaves the other tasks in order. Returns how many. */
static int64_t recall(struct work *w, int64_t *order)
{
    int64_t left = 0;
    for (int64_t k = 0; k < w->study->runs; ++k) {
        const int64_t task = order[k];
        if (w->store != NULL &&
            w->store->recall(w->store->self, task, &w->study->ranks[task], &w->study->outcomes[task]))
            continue;
        w->steps_all += w->study->trials[task].steps;
        order[left++] = task;
    }
    return left;
}

static void task_progress(void *self, int64_t task, int64_t steps)
{
    show(self, task >= 0 ? steps : 0);
}

static int is_asked(void *self)
{
    const struct work *w = self;
    return study_asked(w->watch);
}

/** Rows sorted by falling number of steps, equal ones by row. */
static void longest_first(const struct study *study, int64_t *order)
{
    for (int64_t r = 0; r < study->runs; ++r) {
        int64_t k = r;
        for (; k > 0 && study->trials[order[k - 1]].steps < study->trials[r].steps; --k)
            order[k] = order[k - 1];
        order[k] = r;
    }
}

/* ---- orders ------------------------------------------------------------------------------------------------------ */

/** Below this a measure is rounding, since errors of attitude grow as t sqrt(steps) eps, or no more than the
 *  reference is known to. The q-error is a square root. */
static double least_error(const struct study *study, int measure, const struct trial *trial)
{
    const double rounding = 16.0 * DBL_EPSILON * sqrt((double)trial->steps) * fmax(1.0, trial->t_end);
    const double known = fmax(rounding, 10.0 * study->reference_uncertainty);
    if (strcmp(study_measures[measure], "e_error") == 0)
        return rounding;
    return strcmp(study_measures[measure], "q_error") == 0 ? sqrt(known) : known;
}

static void fit_orders(struct study *study)
{
    const struct plan *plan = study->plan;
    for (int64_t s = 0; s < plan->steppers_count; ++s)
        for (int m = 0; m < STUDY_MEASURES; ++m) {
            double error[LADDER_MOST], floor[LADDER_MOST];
            for (int64_t k = 0; k < plan->h_count; ++k) {
                const int64_t run = s * plan->h_count + k;
                error[k] = study_measure(&study->outcomes[run], m);
                floor[k] = least_error(study, m, &study->trials[run]);
            }
            study->orders[s][m] = fit_order(plan->h, error, floor, plan->h_count);
        }
}

/* ---- all together ------------------------------------------------------------------------------------------------ */

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

/** The queue over all runs, once the reference is there. */
static int run_all(struct study *study, struct reference *reference, MPI_Comm comm, const struct study_watch *watch,
                   const struct store *store, struct message *message)
{
    struct work work = {study, reference, watch, store, message, MPI_Wtime(), 0, 0};
    int64_t *order = calloc((size_t)study->runs, sizeof *order);
    const int without = order == NULL;
    int failed = without;
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, comm);
    if (failed || without) {
        free(order);
        return message_set(message, "out of memory for %lld runs; use fewer", (long long)study->runs);
    }
    longest_first(study, order);
    message->text[0] = '\0';
    const int64_t left = recall(&work, order);
    const struct queue queue = {&work,    left,      order,         sizeof(struct outcome),
                                run_task, task_done, task_progress, is_asked};
    failed = queue_run(&queue, comm);
    free(order);
    study->seconds = MPI_Wtime() - work.start;
    if (failed == -1 && message->text[0] == '\0')
        message_set(message, "out of memory; use fewer runs");
    return failed;
}

int study_run(const struct plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
              struct study *study, struct message *message)
{
    int rank;
    struct reference reference;
    MPI_Comm_rank(comm, &rank);
    memset(study, 0, sizeof *study);
    study->plan = plan;
    study->runs = plan->steppers_count * plan->h_count;
    int failed =
        allocate(study, rank) ? 0 : message_set(message, "out of memory for %lld runs", (long long)study->runs);
    if (failed == 0)
        failed = model_create(plan->scene, &study->model, message);
    if (failed == 0)
        failed = choose_interval(study, message);
    if (failed == 0)
        failed = make_trials(study, message);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    if (failed == 0)
        failed = reference_create(&study->model, study->t_end, study->interval, plan->memory, comm, watch, &reference,
                                  message);
    if (failed != 0)
        return failed;
    if (rank == 0) {
        study->energy0 = model_energy(&study->model, &study->model.bodies);
        study->norm_squared = reference_norm_squared(&reference, study->t_end);
        study->reference_energy_error = reference.energy_error;
        study->reference_uncertainty = reference.uncertainty;
    }
    failed = run_all(study, &reference, comm, watch, store, message);
    reference_destroy(&reference);
    if (failed == 0 && rank == 0)
        fit_orders(study);
    return failed;
}

void study_destroy(struct study *study)
{
    model_destroy(&study->model);
    free(study->trials);
    free(study->outcomes);
    free(study->ranks);
    free(study->orders);
    memset(study, 0, sizeof *study);
}
