/* SPDX-License-Identifier: BSD-3-Clause */
#include "survey.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "queue.h"

/* ---- points ------------------------------------------------------------------------------------------------------ */

static int64_t runs_of(const struct plan *plan)
{
    return plan->steppers_count * plan->h_count;
}

int survey_scene(const struct survey_plan *plan, int64_t p)
{
    return (int)(p / sweep_points(plan->sweep));
}

const struct plan *survey_plan_of(const struct survey_plan *plan, int64_t p)
{
    return &plan->each[survey_scene(plan, p)];
}

char *survey_value(const struct survey_plan *plan, int64_t p, int axis, char *out, size_t size)
{
    const int64_t place = p % sweep_points(plan->sweep);
    return sweep_value(&plan->sweep->axis[axis], sweep_index(plan->sweep, place, axis), out, size);
}

int64_t survey_points(const struct survey_plan *plan)
{
    return plan->scenes_count * sweep_points(plan->sweep);
}

int64_t survey_runs(const struct survey_plan *plan)
{
    int64_t n = 0;
    for (int k = 0; k < plan->scenes_count; ++k)
        n += sweep_points(plan->sweep) * runs_of(&plan->each[k]);
    return n;
}

/** Points of a group: values of the first axis. */
static int64_t group_size(const struct survey_plan *plan)
{
    return plan->sweep->count > 0 ? plan->sweep->axis[0].count : 1;
}

int64_t survey_groups(const struct survey_plan *plan)
{
    return survey_points(plan) / group_size(plan);
}

int64_t survey_bytes(const struct survey_plan *plan)
{
    int64_t most = 0;
    for (int k = 0; k < plan->scenes_count; ++k)
        most = runs_of(&plan->each[k]) > most ? runs_of(&plan->each[k]) : most;
    return (int64_t)sizeof(struct survey_point) + most * (int64_t)sizeof(struct survey_run);
}

/* ---- one point --------------------------------------------------------------------------------------------------- */

static void fail_run(struct survey_run *run, const char *reason)
{
    run->failed = 1;
    run->judgement = outcome_unjudged;
    snprintf(run->reason, sizeof run->reason, "%.*s", SURVEY_REASON - 1, reason);
    for (int m = 0; m < OUTCOME_ERRORS; ++m)
        run->error[m] = NAN;
}

/** trials: what it would have run; NULL if that is not known, as it cannot be made. */
static void fail_point(struct survey_point *point, const struct plan *plan, const struct trial *trials,
                       const char *reason)
{
    point->facts = (struct survey_facts){NAN, NAN, NAN, NAN};
    for (int64_t r = 0; r < runs_of(plan); ++r) {
        const int known = trials != NULL && trials[r].steps > 0;
        point->run[r].steps = known ? trials[r].steps : 0;
        point->run[r].t_end = known ? trials[r].t_end : NAN;
        point->run[r].seconds = NAN;
        fail_run(&point->run[r], reason);
    }
}

static void take_run(const struct study *study, int64_t r, struct survey_run *run)
{
    const struct outcome *outcome = &study->outcomes[r];
    run->steps = study->trials[r].steps;
    run->t_end = study->trials[r].t_end;
    run->force_evals = outcome->force_evals;
    run->seconds = outcome->seconds;
    run->judgement = outcome->judgement;
    memcpy(run->error, outcome->error, sizeof run->error);
    if (outcome->failed)
        fail_run(run, outcome->message.text);
}

static void take_study(const struct study *study, struct survey_point *point)
{
    point->facts = (struct survey_facts){study->energy0, study->norm_squared, study->reference_energy_error,
                                         study->reference_uncertainty};
    for (int64_t r = 0; r < study->runs; ++r)
        take_run(study, r, &point->run[r]);
}

static void run_point(const struct survey_plan *plan, int64_t p, queue_poll poll, void *poll_self,
                      struct survey_point *point)
{
    static struct scene scene;
    static struct tables tables;
    struct study study;
    struct message message = {""};
    const int k = survey_scene(plan, p);
    memset(point, 0, (size_t)survey_bytes(plan));
    const int failed = survey_read(plan, k, p % sweep_points(plan->sweep), &scene, &tables, &message);
    if (failed != 0) {
        fail_point(point, &plan->each[k], NULL, message.text);
        point->ends_all = failed == SURVEY_CHANGED;
        return;
    }
    const struct plan each = survey_plan_with(plan, k, &scene);
    if (study_alone(&each, poll, poll_self, &study, &message) == 0)
        take_study(&study, point);
    else
        fail_point(point, &each, study.trials, message.text);
    study_destroy(&study);
    tables_destroy(&tables);
}

/* ---- points as tasks --------------------------------------------------------------------------------------------- */

struct work {
    const struct survey_plan *plan;
    const struct study_watch *watch;
    const struct store *store;
    struct message *message;
    struct survey_point *scratch; /* one that the store holds */
    double start;
    int64_t next, points, there, done; /* there: in the store before */
};

static void show(const struct work *w)
{
    study_show(w->watch, "points", w->done, w->points - w->there, MPI_Wtime() - w->start);
}

static int64_t next_point(void *self)
{
    struct work *w = self;
    int rank;
    while (w->next < w->points && w->store->recall(w->store->self, w->next, &rank, w->scratch)) {
        ++w->next;
        ++w->there;
    }
    return w->next < w->points ? w->next++ : -1;
}

static void run_task(void *self, int64_t task, queue_poll poll, void *poll_self, void *result)
{
    const struct work *w = self;
    run_point(w->plan, task, poll, poll_self, result);
}

static int task_done(void *self, int64_t task, int rank, const void *result)
{
    struct work *w = self;
    const struct survey_point *point = result;
    if (point->ends_all)
        return message_set(w->message, "%s", point->run[0].reason);
    ++w->done;
    show(w);
    return w->store->keep(w->store->self, task, rank, result, w->message);
}

static void task_progress(void *self, int64_t task, int64_t work)
{
    (void)task;
    (void)work;
    show(self);
}

int survey_run(const struct survey_plan *plan, MPI_Comm comm, const struct study_watch *watch,
               const struct store *store, struct survey *survey, struct message *message)
{
    struct work work = {plan, watch, store, message, NULL, MPI_Wtime(), 0, survey_points(plan), 0, 0};
    const struct survey made = {plan, store, work.points, survey_runs(plan), 0.0};
    const struct queue queue = {&work, survey_bytes(plan), next_point, run_task, task_done, task_progress, watch};
    work.scratch = malloc((size_t)survey_bytes(plan));
    int failed = work.scratch == NULL ? -1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    message->text[0] = '\0';
    *survey = made;
    if (failed == 0)
        failed = queue_run(&queue, comm);
    if (failed == -1 && message->text[0] == '\0')
        message_set(message, "out of memory; use fewer steppers and steps");
    survey->seconds = MPI_Wtime() - work.start;
    free(work.scratch);
    return failed;
}
