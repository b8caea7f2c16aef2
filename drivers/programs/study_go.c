/* SPDX-License-Identifier: BSD-3-Clause
 * Runs studies, sweeps and studies of cost on all MPI ranks, from plan to files. */
#include "study_go.h"

#include <stdio.h>

#include "number.h"
#include "study_files.h"
#include "study_tasks.h"
#include "terminal.h"
#include "unused.h"

static const char study_journal[] = "study.journal";

static int count_ranks(void)
{
    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    return ranks;
}

/* ---- from plan to files ------------------------------------------------------------------------------------------ */

/** What the three kinds of studies differ in; *result is theirs. Those that return an int return 0, or not with
 *  *message. */
struct study_kind {
    void (*say_plan)(const void *plan);
    int (*run)(const void *plan, const struct study_watch *watch, const struct store *store, void *result,
               struct message *message);
    int (*write)(void *result, const char *folder, struct message *message); /* and says it */
};

enum { NOT_BEGUN = WATCH_ASKED - 1 };

/** Returns on all ranks 0, or when one line has been said WATCH_ASKED, -1, or NOT_BEGUN, when there is no result. */
static int go_through(const struct study_kind *kind, const struct study_work *work, const struct study_place *place,
                      int rank, void *result)
{
    struct message message = {""}, problem = {""};
    const struct study_watch watch = study_watch_begin(); /* on all ranks before any of them says a word */
    if (study_tasks_open(work, place, rank) != 0)
        return NOT_BEGUN;
    const struct store store = study_tasks_store();
    if (rank == 0)
        kind->say_plan(work->plan);
    int failed = kind->run(work->plan, &watch, rank == 0 ? &store : NULL, result, &message);
    progress_clear();
    if (failed == 0 && rank == 0 &&
        (study_tasks_check(place, &problem) != 0 || kind->write(result, place->folder, &problem) != 0))
        failed = study_tasks_not_written(&problem, &message);
    return study_tasks_end(failed, rank, &message);
}

/* ---- convergence ------------------------------------------------------------------------------------------------ */

/** The first line: what will be done. */
static void say_study_plan(const void *of)
{
    const struct plan *plan = of;
    const int ranks = count_ranks();
    printf("%s to t = %s: ", plan->scene->name, NUMBER(plan->t_end));
    for (int64_t k = 0; k < plan->steppers_count; ++k)
        printf("%s%s", k > 0 ? ", " : "", plan->steppers[k]->name);
    printf(" at %lld step%s from h = %s to %s: %lld runs on %d rank%s, after a reference solution\n",
           (long long)plan->h_count, plan->h_count > 1 ? "s" : "", NUMBER(plan->h[0]),
           NUMBER(plan->h[plan->h_count - 1]), (long long)plan->steppers_count * (long long)plan->h_count, ranks,
           ranks > 1 ? "s" : "");
    fflush(stdout);
}

/** Where runs end before t_end, and at which times they are compared if not at all of the longest steps. */
static void say_times(const struct study *study)
{
    const struct plan *plan = study->plan;
    const int thinned = study->thinned > 1.0;
    if (study->interval > 0.0 && (thinned || study->t_end != plan->t_end))
        printf("note: runs are compared with the reference at multiples of %s%s, and all end at t = %.10g\n",
               NUMBER(study->interval), thinned ? ", as --memory holds no more of its states" : ", the longest step",
               study->t_end);
    for (int64_t k = 0; study->interval == 0.0 && k < plan->h_count; ++k)
        if (study->trials[k].t_end != plan->t_end)
            printf("note: t_end = %s is not a multiple of h = %s: those runs take %lld steps and end at t = %.10g\n",
                   NUMBER(plan->t_end), NUMBER(plan->h[k]), (long long)study->trials[k].steps, study->trials[k].t_end);
}

static void say_study(const struct study *study, const char *folder)
{
    unused_say(&study->model, study->plan->scene->tables, stdout);
    say_times(study);
    study_table_write(study, stdout);
    const int dissipates = model_dissipates(&study->model) != NULL;
    printf("\nreference: %s, its energy constant to %.0e in units of the scene, the solution known to %.0e; "
           "||q||^2 = %.13g\n",
           dissipates ? "chin4 by a fourth of the shortest step, what is lost counted in" : "rk8pd",
           number_plain(study->reference_energy_error), number_plain(study->reference_uncertainty),
           number_plain(study->norm_squared));
    if (study->reference_rounding > 0.0)
        printf(
            "it is rounding that leaves it so: from one number to the next, positions and attitudes change the forces "
            "by more than the tolerance; nearer to the origin bodies are known better\n");
    else if (study->reference_uncertainty > REFERENCE_PARTED && dissipates)
        printf("runs by steps of that kind still part: the motion is chaotic or something breaks, and errors of "
               "trajectories below that mean nothing; that of the energy does\n");
    else if (study->reference_uncertainty > REFERENCE_PARTED)
        printf("the motion is chaotic: no method can follow it to the end, and errors of trajectories mean nothing "
               "there\n");
    printf("%lld runs in %.2f s, written to %s: study.h5 study.csv timing.csv\n", (long long)study->runs,
           study->seconds, folder);
}

/** Whether the verdict on some run is bad, on all ranks. Collective. */
static int some_bad(const struct study *study, int rank)
{
    int bad = 0;
    for (int64_t r = 0; rank == 0 && r < study->runs; ++r)
        bad |= study->outcomes[r].judgement.verdict == VERDICT_BAD;
    MPI_Bcast(&bad, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return bad;
}

static int run_study(const void *plan, const struct study_watch *watch, const struct store *store, void *study,
                     struct message *message)
{
    return study_run(plan, MPI_COMM_WORLD, watch, store, study, message);
}

static int write_study(void *study, const char *folder, struct message *message)
{
    return study_files_write(study, folder, message);
}

int study_go(const struct plan *plan, const struct study_place *place, int rank)
{
    static const struct study_kind kind = {say_study_plan, run_study, write_study};
    struct study study;
    const struct study_work work = {study_journal,          "runs",        plan->steppers_count * plan->h_count,
                                    sizeof(struct outcome), study_outputs, STUDY_FILES,
                                    study_identify,         plan};
    int failed = go_through(&kind, &work, place, rank, &study);
    if (failed == NOT_BEGUN)
        return -1;
    if (failed == 0 && rank == 0)
        say_study(&study, place->folder);
    if (failed == 0)
        failed = some_bad(&study, rank);
    study_destroy(&study);
    return failed;
}

/* ---- surveys ----------------------------------------------------------------------------------------------------- */

static void say_survey_plan(const void *of)
{
    const struct survey_plan *plan = of;
    const int ranks = count_ranks();
    for (int k = 0; k < plan->scenes_count; ++k)
        printf("%s%s", k > 0 ? ", " : "", plan->first[k].name);
    for (int k = 0; k < plan->sweep->count; ++k)
        printf("%s%lld values of %s", k > 0 ? " x " : ": ", (long long)plan->sweep->axis[k].count,
               plan->sweep->axis[k].key);
    printf(": %lld points, each with a reference solution, and %lld runs on %d rank%s\n",
           (long long)survey_points(plan), (long long)survey_runs(plan), ranks, ranks > 1 ? "s" : "");
    fflush(stdout);
}

static int say_survey(const struct survey *survey, const struct survey_counts *counts, const char *folder,
                      struct message *message)
{
    if (survey_table_write(survey, stdout, message) != 0)
        return -1;
    printf("\nverdict: of %lld runs %lld are good, %lld doubtful, %lld bad", (long long)survey->runs,
           (long long)counts->verdict[VERDICT_GOOD], (long long)counts->verdict[VERDICT_DOUBTFUL],
           (long long)counts->verdict[VERDICT_BAD]);
    if (counts->failed > 0)
        printf(", and %lld failed: study.csv says why", (long long)counts->failed);
    if (counts->parted > 0)
        printf(
            "\nat %lld of %lld points the solution is known to no better than %g: the motion is chaotic or something "
            "breaks, errors of trajectories mean nothing there and have no orders",
            (long long)counts->parted, (long long)survey->points, REFERENCE_PARTED);
    printf("\n%lld runs in %.2f s, written to %s: study.h5 study.csv timing.csv\n", (long long)survey->runs,
           survey->seconds, folder);
    return 0;
}

/** With what is counted while its files are written. */
struct counted_survey {
    struct survey survey;
    struct survey_counts counts;
};

static int run_survey(const void *plan, const struct study_watch *watch, const struct store *store, void *counted,
                      struct message *message)
{
    return survey_run(plan, MPI_COMM_WORLD, watch, store, &((struct counted_survey *)counted)->survey, message);
}

static int write_survey(void *counted, const char *folder, struct message *message)
{
    struct counted_survey *c = counted;
    return survey_files_write(&c->survey, folder, &c->counts, message) != 0
               ? -1
               : say_survey(&c->survey, &c->counts, folder, message);
}

int study_go_survey(const struct survey_plan *plan, const struct study_place *place, int rank)
{
    static const struct study_kind kind = {say_survey_plan, run_survey, write_survey};
    struct counted_survey counted = {.counts = {{0}, 0, 0}};
    const struct study_work work = {study_journal, "points",    survey_points(plan),   (size_t)survey_bytes(plan),
                                    study_outputs, STUDY_FILES, study_identify_survey, plan};
    const int failed = go_through(&kind, &work, place, rank, &counted);
    int bad = counted.counts.verdict[VERDICT_BAD] > 0 || counted.counts.failed > 0;
    if (failed == NOT_BEGUN)
        return -1;
    MPI_Bcast(&bad, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return failed == 0 ? bad : failed;
}

/* ---- cost -------------------------------------------------------------------------------------------------------- */

static void say_cost_plan(const void *of)
{
    const struct cost_plan *plan = of;
    const int ranks = count_ranks();
    printf("what accuracy costs: ");
    for (int64_t k = 0; k < plan->cases_count; ++k)
        printf("%s%s to t = %s", k > 0 ? ", " : "", plan->cases[k].name, NUMBER(plan->cases[k].t_end));
    printf(", by %lld methods on %d rank%s: reference solutions, errors, times\n", (long long)plan->methods_count,
           ranks, ranks > 1 ? "s" : "");
    fflush(stdout);
}

static void say_cost(const struct cost *cost, const char *folder)
{
    study_table_write_cost(cost, stdout);
    printf("%lld runs in %.2f s, written to %s: cost.csv errors.csv prices.csv machine.txt\n", (long long)cost->runs,
           cost->seconds, folder);
}

static int run_cost(const void *plan, const struct study_watch *watch, const struct store *store, void *cost,
                    struct message *message)
{
    return cost_run(plan, MPI_COMM_WORLD, watch, store, cost, message);
}

static int write_cost(void *cost, const char *folder, struct message *message)
{
    return cost_files_write(cost, folder, message);
}

int study_go_cost(const struct cost_plan *plan, const struct study_place *place, int rank)
{
    static const struct study_kind kind = {say_cost_plan, run_cost, write_cost};
    static struct cost cost;
    const struct study_work work = {"cost.journal",
                                    "ladders",
                                    plan->cases_count * plan->methods_count,
                                    sizeof(struct cost_ladder),
                                    cost_outputs,
                                    COST_FILES,
                                    study_identify_cost,
                                    plan};
    const int failed = go_through(&kind, &work, place, rank, &cost);
    if (failed == NOT_BEGUN)
        return -1;
    if (failed == 0 && rank == 0)
        say_cost(&cost, place->folder);
    cost_destroy(&cost);
    return failed;
}
