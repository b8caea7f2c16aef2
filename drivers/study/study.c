/* SPDX-License-Identifier: BSD-3-Clause */
#include "study.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "queue.h"
#include "study_parts.h"

static void one_run(const struct study *study, int64_t r, struct reference *reference, queue_poll poll, void *poll_self,
                    struct outcome *outcome)
{
    const struct trial *trial = &study->trials[r];
    const int64_t compare_every = study->interval > 0.0 ? llrint(study->interval / trial->h) : 1;
    outcome_of(study->plan->scene, trial, compare_every, reference, poll, poll_self, outcome);
}

/* ---- the runs as tasks ------------------------------------------------------------------------------------------- */

struct work {
    struct study *study;
    struct reference *reference;
    const struct study_watch *watch;
    const struct store *store;
    struct message *message;
    double start;
    int64_t *order, left, taken;   /* [left]: the runs that the store does not hold, in the order of their going */
    int64_t steps_all, steps_done; /* of these */
};

static void run_task(void *self, int64_t task, queue_poll poll, void *poll_self, void *result)
{
    const struct work *w = self;
    one_run(w->study, task, w->reference, poll, poll_self, result);
}

static void show(struct work *w, int64_t extra)
{
    study_show(w->watch, "runs", w->steps_done + extra, w->steps_all, MPI_Wtime() - w->start);
}

static int task_done(void *self, int64_t task, int rank, const void *result)
{
    struct work *w = self;
    memcpy(&w->study->outcomes[task], result, sizeof *w->study->outcomes);
    w->study->ranks[task] = rank;
    w->steps_done += w->study->trials[task].steps;
    show(w, 0);
    return w->store != NULL ? w->store->keep(w->store->self, task, rank, result, w->message) : 0;
}

/** Takes what the store has and leaves the other tasks in order. */
static void recall(struct work *w)
{
    for (int64_t k = 0; k < w->study->runs; ++k) {
        const int64_t task = w->order[k];
        if (w->store != NULL &&
            w->store->recall(w->store->self, task, &w->study->ranks[task], &w->study->outcomes[task]))
            continue;
        w->steps_all += w->study->trials[task].steps;
        w->order[w->left++] = task;
    }
}

/** Rank 0: the next one. */
static int64_t next_task(void *self)
{
    struct work *w = self;
    return w->left > w->taken ? w->order[w->taken++] : -1;
}

static void task_progress(void *self, int64_t task, int64_t steps)
{
    show(self, task >= 0 ? steps : 0);
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

/** Errors of attitude grow as t sqrt(steps) eps. Where trajectories part, no error of theirs means anything, however
 *  large. The energy of a stiff or fast scene is known no better than the reference keeps it. The q-error is a square
 *  root. */
double study_floor(int measure, int64_t steps, double t_end, double uncertainty, double energy_error)
{
    const double rounding = 16.0 * DBL_EPSILON * sqrt((double)steps) * fmax(1.0, t_end);
    if (measure != E_ERROR && uncertainty > REFERENCE_PARTED)
        return INFINITY;
    const double known = fmax(rounding, 10.0 * uncertainty);
    if (measure == E_ERROR)
        return fmax(rounding, 10.0 * energy_error);
    return measure == Q_ERROR ? sqrt(known) : known;
}

double study_share(double energy_error, double energy0)
{
    return energy_error / (energy0 != 0.0 ? fabs(energy0) : 1.0);
}

struct order study_order(const struct plan *plan, const double *error, const double *floor)
{
    return fit_order(plan->h, error, floor, plan->scene->tolerance > 0.0 ? 0 : plan->h_count);
}

static void fit_orders(struct study *study)
{
    const double energy_error = study_share(study->reference_energy_error, study->energy0);
    const struct plan *plan = study->plan;
    for (int64_t s = 0; s < plan->steppers_count; ++s)
        for (int m = 0; m < STUDY_MEASURES; ++m) {
            double error[LADDER_MOST], floor[LADDER_MOST];
            for (int64_t k = 0; k < plan->h_count; ++k) {
                const int64_t run = s * plan->h_count + k;
                error[k] = study->outcomes[run].error[m];
                floor[k] = study_floor(m, study->trials[run].steps, study->trials[run].t_end,
                                       study->reference_uncertainty, energy_error);
            }
            study->orders[s][m] = study_order(plan, error, floor);
        }
}

/* ---- all together ------------------------------------------------------------------------------------------------ */

/** The queue over all runs, once the reference is there. */
static int run_all(struct study *study, struct reference *reference, MPI_Comm comm, const struct study_watch *watch,
                   const struct store *store, struct message *message)
{
    struct work work = {study, reference, watch, store, message, MPI_Wtime(), NULL, 0, 0, 0, 0};
    work.order = calloc((size_t)study->runs, sizeof *work.order);
    const int without = work.order == NULL;
    int failed = without;
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, comm);
    if (failed || without) {
        free(work.order);
        return message_set(message, "out of memory for %lld runs; use fewer", (long long)study->runs);
    }
    longest_first(study, work.order);
    message->text[0] = '\0';
    recall(&work);
    const struct queue queue = {&work, sizeof(struct outcome), next_task, run_task, task_done, task_progress, watch};
    failed = queue_run(&queue, comm);
    free(work.order);
    study->seconds = MPI_Wtime() - work.start;
    if (failed == -1 && message->text[0] == '\0')
        message_set(message, "out of memory; use fewer runs");
    return failed;
}

static void note_reference(struct study *study, struct reference *reference)
{
    study->energy0 = model_energy0(&study->model);
    study->norm_squared = reference_norm_squared(reference, study->t_end);
    study->reference_energy_error = reference->energy_error;
    study->reference_uncertainty = reference->uncertainty;
    study->reference_rounding = reference->rounding;
}

int study_run(const struct plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
              struct study *study, struct message *message)
{
    int rank;
    struct reference reference;
    MPI_Comm_rank(comm, &rank);
    int failed = study_prepare_checked(plan, rank, study, message);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    if (failed == 0) {
        const struct reference_span span = study_span(study);
        failed = reference_create(&study->model, &span, comm, watch, &reference, message);
    }
    if (failed != 0)
        return failed;
    if (rank == 0)
        note_reference(study, &reference);
    failed = run_all(study, &reference, comm, watch, store, message);
    reference_destroy(&reference);
    if (failed == 0 && rank == 0)
        fit_orders(study);
    return failed;
}

/* ---- by one rank ------------------------------------------------------------------------------------------------- */

struct alone {
    queue_poll poll;
    void *self;
};

static int see_alone(void *self, double share)
{
    const struct alone *alone = self;
    (void)share;
    return alone->poll(alone->self, 0);
}

int study_alone(const struct plan *plan, int (*poll)(void *self, int64_t work), void *poll_self, struct study *study,
                struct message *message)
{
    struct alone alone = {poll, poll_self};
    const struct watch watch = {see_alone, &alone};
    struct reference reference;
    int failed = study_prepare(plan, 0, study, message);
    if (failed == 0) {
        const struct reference_span span = study_span(study);
        failed = reference_alone(&study->model, &span, &watch, &reference, message);
    }
    if (failed != 0)
        return failed;
    note_reference(study, &reference);
    for (int64_t r = 0; r < study->runs; ++r)
        one_run(study, r, &reference, poll, poll_self, &study->outcomes[r]);
    reference_destroy(&reference);
    fit_orders(study);
    return 0;
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
