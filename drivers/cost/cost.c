/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost.h"

#include <stdlib.h>
#include <string.h>

#include "queue.h"

/** What all ranks share while they work. */
struct work {
    const struct cost_plan *plan;
    struct cost *cost;
    struct model *models;     /* [cases_count], at t = 0 */
    double first[COST_CASES]; /* steps of the first run of a ladder */
    struct reference *references;
    const struct study_watch *watch;
    const struct store *store;
    struct message *message;
    double start;
    int64_t *order;    /* [all]: the ladders that the store does not hold, in the order of their going */
    int64_t done, all; /* of these */
    int64_t taken;
    int rank;
};

static int64_t ladders_of(const struct cost_plan *plan)
{
    return plan->cases_count * plan->methods_count;
}

static int anywhere(int failed, MPI_Comm comm)
{
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    return failed;
}

/* ---- references -------------------------------------------------------------------------------------------------- */

/** One for every case. Those that are made stay in their places and are destroyed with the others. */
static int make_references(struct work *w, MPI_Comm comm, struct message *message)
{
    for (int64_t c = 0; c < w->plan->cases_count; ++c) {
        const struct cost_case *it = &w->plan->cases[c];
        struct model *model = &w->models[c];
        if (anywhere(model_create(it->scene, model, message), comm) != 0)
            return -1;
        w->first[c] = cost_first_steps(it, model);
        const struct reference_span span = {it->t_end, reference_is_smooth(model) ? 0.0 : it->t_end, 0.0,
                                            w->plan->memory};
        const int failed = reference_create(model, &span, comm, w->watch, &w->references[c], message);
        if (failed != 0)
            return failed;
        struct cost_facts *facts = &w->cost->facts[c];
        facts->main = cost_main_measure(model);
        facts->has[COST_ATTITUDE] = facts->main == COST_ATTITUDE;
        facts->has[COST_POSITION] = model->bodies.x.c[0] != NULL;
        facts->has[COST_VELOCITY] = facts->has[COST_ENERGY] = 1;
        facts->uncertainty = w->references[c].uncertainty;
    }
    return 0;
}

/* ---- errors: one ladder is one task ------------------------------------------------------------------------------ */

static void run_task(void *self, int64_t task, queue_poll poll, void *poll_self, void *result)
{
    const struct work *w = self;
    const int64_t c = task / w->plan->methods_count, m = task % w->plan->methods_count;
    const struct cost_descent descent = {w->plan,       &w->plan->cases[c], w->plan->methods[m],
                                         &w->models[c], w->first[c],        &w->references[c],
                                         poll,          poll_self};
    cost_ladder_run(&descent, result);
}

static int task_done(void *self, int64_t task, int rank, const void *result)
{
    struct work *w = self;
    memcpy(&w->cost->ladders[task], result, sizeof *w->cost->ladders);
    ++w->done;
    study_show(w->watch, "errors", w->done, w->all, MPI_Wtime() - w->start);
    return w->store != NULL ? w->store->keep(w->store->self, task, rank, result, w->message) : 0;
}

/** Takes what the store has and lists the other tasks in order. */
static void recall(struct work *w, int64_t n)
{
    int rank;
    for (int64_t task = n - 1; task >= 0; --task)
        if (w->store == NULL || !w->store->recall(w->store->self, task, &rank, &w->cost->ladders[task]))
            w->order[w->all++] = task;
}

/** Rank 0: the next one. */
static int64_t next_task(void *self)
{
    struct work *w = self;
    return w->all > w->taken ? w->order[w->taken++] : -1;
}

static void task_progress(void *self, int64_t task, int64_t work)
{
    const struct work *w = self;
    (void)task;
    (void)work;
    study_show(w->watch, "errors", w->done, w->all, MPI_Wtime() - w->start);
}

static int measure_all(struct work *w, MPI_Comm comm, struct message *message)
{
    const int64_t n = ladders_of(w->plan);
    w->order = calloc((size_t)n, sizeof *w->order);
    if (anywhere(w->order == NULL ? -1 : 0, comm) != 0 || w->order == NULL) {
        free(w->order);
        return message_set(message, "out of memory; use fewer scenes");
    }
    w->start = MPI_Wtime();
    message->text[0] = '\0';
    recall(w, n);
    const struct queue queue = {w, sizeof(struct cost_ladder), next_task, run_task, task_done, task_progress, w->watch};
    const int failed = queue_run(&queue, comm);
    free(w->order);
    if (failed == -1 && message->text[0] == '\0')
        message_set(message, "out of memory; use fewer scenes");
    return failed;
}

/* ---- times ------------------------------------------------------------------------------------------------------- */

static int tell(void *self, double share)
{
    const struct work *w = self;
    if (w->rank == 0)
        study_show(w->watch, "times", (int64_t)(1e6 * share), 1000000, MPI_Wtime() - w->start);
    return study_asked(w->watch);
}

/** Every rank's list of the runs that went well, by case, method and h. Returns how many, or -1. */
static int64_t list_runs(const struct work *w, MPI_Comm comm, int rank, struct cost_run **runs)
{
    int64_t n = 0;
    if (rank == 0)
        for (int64_t k = 0; k < ladders_of(w->plan); ++k)
            n += w->cost->ladders[k].count;
    MPI_Bcast(&n, 1, MPI_INT64_T, 0, comm);
    *runs = calloc((size_t)(n > 0 ? n : 1), sizeof **runs);
    struct cost_run *run = *runs;
    if (anywhere(run == NULL ? -1 : 0, comm) != 0 || run == NULL)
        return -1;
    for (int64_t k = 0; rank == 0 && k < ladders_of(w->plan); ++k)
        for (int64_t r = 0; r < w->cost->ladders[k].count; ++r, ++run) {
            run->c = k / w->plan->methods_count;
            run->method = k % w->plan->methods_count;
            run->h = w->cost->ladders[k].h[r];
            run->work = (double)w->cost->ladders[k].runs[r].force_evals * (double)w->models[run->c].bodies.count;
        }
    MPI_Bcast(*runs, (int)(n * (int64_t)sizeof **runs), MPI_BYTE, 0, comm);
    return n;
}

static int time_all(struct work *w, MPI_Comm comm, int rank, struct message *message)
{
    struct cost_run *runs = NULL;
    const int64_t n = list_runs(w, comm, rank, &runs);
    double *samples = calloc((size_t)(n > 0 ? n * w->plan->repeats : 1), sizeof *samples);
    const struct watch on_sample = {tell, w};
    int failed = anywhere(n < 0 || samples == NULL ? -1 : 0, comm);
    w->start = MPI_Wtime();
    if (failed == 0)
        failed = cost_time(w->plan, runs, n, comm, &on_sample, samples);
    if (failed == 0 && rank == 0) {
        double *s = samples;
        for (int64_t k = 0; k < ladders_of(w->plan); ++k)
            for (int64_t r = 0; r < w->cost->ladders[k].count; ++r, s += w->plan->repeats)
                race_settle(s, w->plan->repeats, &w->cost->ladders[k].runs[r]);
        w->cost->runs = n;
    }
    free(runs);
    free(samples);
    return failed == -1 ? message_set(message, "out of memory; use fewer scenes") : failed;
}

/* ---- all together ------------------------------------------------------------------------------------------------ */

static void find_prices(struct cost *cost)
{
    for (int64_t k = 0; k < ladders_of(cost->plan); ++k)
        for (int measure = 0; measure < COST_MEASURES; ++measure)
            for (int e = 0; e < COST_TARGETS; ++e)
                cost->prices[k][measure][e] = cost_price_of(&cost->ladders[k], measure, cost_targets[e]);
}

static int allocate(struct work *w, int rank)
{
    const size_t cases = (size_t)w->plan->cases_count, ladders = (size_t)ladders_of(w->plan);
    w->models = calloc(cases, sizeof *w->models);
    w->references = calloc(cases, sizeof *w->references);
    if (rank == 0) {
        w->cost->ladders = calloc(ladders, sizeof *w->cost->ladders);
        w->cost->prices = calloc(ladders, sizeof *w->cost->prices);
    }
    return w->models != NULL && w->references != NULL &&
                   (rank != 0 || (w->cost->ladders != NULL && w->cost->prices != NULL))
               ? 0
               : -1;
}

static void release(struct work *w)
{
    for (int64_t c = 0; c < w->plan->cases_count; ++c) {
        if (w->references != NULL)
            reference_destroy(&w->references[c]);
        if (w->models != NULL)
            model_destroy(&w->models[c]);
    }
    free(w->references);
    free(w->models);
}

int cost_run(const struct cost_plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
             struct cost *cost, struct message *message)
{
    int rank;
    struct work w = {.plan = plan, .cost = cost, .watch = watch, .store = store, .message = message};
    const double start = MPI_Wtime();
    memset(cost, 0, sizeof *cost);
    cost->plan = plan;
    MPI_Comm_rank(comm, &rank);
    w.rank = rank;
    MPI_Comm_size(comm, &cost->ranks);
    int failed = anywhere(allocate(&w, rank), comm);
    if (failed != 0)
        message_set(message, "out of memory; use fewer scenes");
    if (failed == 0)
        failed = make_references(&w, comm, message);
    if (failed == 0)
        failed = measure_all(&w, comm, message);
    if (failed == 0)
        failed = time_all(&w, comm, rank, message);
    if (failed == 0 && rank == 0)
        find_prices(cost);
    release(&w);
    cost->seconds = MPI_Wtime() - start;
    return failed;
}

void cost_destroy(struct cost *cost)
{
    free(cost->ladders);
    free(cost->prices);
    memset(cost, 0, sizeof *cost);
}
