/* SPDX-License-Identifier: BSD-3-Clause
 * Runs studies, sweeps and studies of cost on all MPI ranks, from plan to files; keeps what --resume needs. */
#define _POSIX_C_SOURCE 200809L
#include "study_go.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "hdf5_sink.h"
#include "identity.h"
#include "left.h"
#include "number.h"
#include "terminal.h"
#include "signals.h"
#include "study_files.h"
#include "tasks.h"

/* ---- all ranks -------------------------------------------------------------------------------------------------- */

int study_agree(int failed, int rank, const struct message *message)
{
    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    /* whether all ranks went on; and the lowest rank that has a message, which prints it */
    int mine[2] = {failed == 0, failed != 0 && message->text[0] != '\0' ? rank : ranks}, all[2] = {0, 0};
    MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (all[0] == 1)
        return 0;
    if (all[1] == rank || (all[1] == ranks && rank == 0)) {
        progress_clear();
        fprintf(stderr, "vti-study: %s\n", all[1] == rank ? message->text : "out of memory; use fewer runs");
    }
    return -1;
}

/* ---- what is kept, which rank 0 has ----------------------------------------------------------------------------- */

static struct tasks tasks;
static const char *results = "runs"; /* what they are, for people */
static const char study_journal[] = "study.journal", cost_journal[] = "cost.journal";

/** name is where results are kept, and left says whether it is ours (overwrite.h). */
static int check_files(const struct study_place *place, const char *name, int left, const struct output *files,
                       int count, struct message *message)
{
    const struct kept kept = {name, left};
    return overwrite_check(place->folder, files, count, place->inputs, place->inputs_count, &kept, place->force,
                           message);
}

/** Pictures do not say whose they are: they are ours where study.h5 is, which they are drawn of. */
static int check_pictures(const struct study_place *place, struct message *message)
{
    static const struct mark hdf5 = {NULL, NULL, NULL};
    char path[FOLDER_PATH];
    struct stat info;
    if (place->pictures == NULL || place->force)
        return 0;
    if (folder_output(place->folder, "study.h5", 0, path, message) != 0)
        return -1;
    const int ours = mark_is_ours(path, &hdf5);
    for (const char *const *name = place->pictures; *name != NULL && !ours; ++name) {
        if (folder_path(place->folder, *name, 0, path, message) != 0)
            return -1;
        if (lstat(path, &info) == 0)
            return message_set(message,
                               "%.600s: is there already and is no picture of a study; choose another place with -o, "
                               "replace it with --force, or draw none with --no-plot",
                               path);
    }
    return 0;
}

static int check_start(const struct study_place *place, const char *name, const struct output *files, int count,
                       struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_path(place->folder, name, 0, path, message) != 0)
        return -1;
    return check_files(place, name, left_is_there(path), files, count, message) != 0 ? -1
                                                                                     : check_pictures(place, message);
}

/** On rank 0; identify writes what the study is. */
static int open_here(const struct study_place *place, const char *name, const struct output *files, int count,
                     void (*identify)(FILE *text, const void *plan), const void *plan, size_t bytes,
                     struct message *message)
{
    size_t size;
    char *identity = NULL;
    FILE *text = open_memstream(&identity, &size);
    int failed = text == NULL ? -1 : 0;
    if (failed == 0) {
        identity_version(text);
        identify(text, plan);
        fprintf(text, "bytes of a result: %zu\n", bytes);
        failed = fclose(text) != 0 ? -1 : 0;
    }
    if (failed == 0 &&
        (check_start(place, name, files, count, message) != 0 || folder_create(place->folder, message) != 0 ||
         tasks_open(&tasks, place->folder, name, place->resume, identity, bytes, message) != 0))
        failed = -1;
    free(identity);
    return failed;
}

/** Collective. */
static int open_tasks(const struct study_place *place, const char *name, const struct output *files, int count,
                      void (*identify)(FILE *text, const void *plan), const void *plan, int64_t all, size_t bytes,
                      int rank)
{
    struct message message = {""};
    hdf5_start();
    const int failed = rank == 0 ? open_here(place, name, files, count, identify, plan, bytes, &message) : 0;
    if (study_agree(failed, rank, &message) != 0)
        return -1;
    if (rank == 0 && place->resume && tasks.kept > 0)
        printf("goes on: %lld of %lld %s are there already\n", (long long)tasks.kept, (long long)all, results);
    else if (rank == 0 && place->resume)
        printf("no %s are there yet: starts\n", results);
    fflush(stdout);
    return 0;
}

/** What is wrong with the files, and where the results are. */
static int not_written(const struct message *problem, struct message *message)
{
    if (tasks_commit(&tasks, message) != 0)
        return -1;
    return message_set(message, "%.600s; the results are kept in %.300s: when that is mended go on with --resume",
                       problem->text, tasks.keep.path);
}

/* ---- the person at the terminal --------------------------------------------------------------------------------- */

static void show(const char *what, int64_t done, int64_t all, double seconds)
{
    tasks_settle(&tasks);
    progress_show_what(what, done, all, seconds);
}

static int is_asked(void)
{
    return run_signals_seen() != NULL;
}

/** From now on signals are noted, and the study ends at its next look for them. */
static struct study_watch begin_watch(void)
{
    const struct study_watch watch = {show, is_asked};
    run_signals_catch();
    return watch;
}

static int say_stopped(int64_t all, struct message *message)
{
    if (tasks_commit(&tasks, message) != 0)
        return -1;
    if (tasks.kept == 0)
        return message_set(message, "stopped before any %s were done; the same command with --resume starts again",
                           results);
    return message_set(message, "stopped; %lld of %lld %s are kept in %.300s: go on with --resume",
                       (long long)tasks.kept, (long long)all, results, tasks.keep.path);
}

/** The end of a study of so many runs that returned failed, on all ranks. */
static int end_study(int failed, int64_t all, int done, int rank, struct message *message)
{
    struct message ignored;
    if (failed == WATCH_ASKED && rank == 0)
        say_stopped(all, message);
    else if (rank == 0 && !done)
        tasks_commit(&tasks, &ignored);
    if (rank == 0)
        tasks_end(&tasks, done);
    const int agreed = study_agree(failed, rank, message);
    return failed == WATCH_ASKED ? failed : agreed;
}

static int count_ranks(void)
{
    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    return ranks;
}

/* ---- convergence ------------------------------------------------------------------------------------------------ */

/** The first line: what will be done. */
static void say_plan(const struct plan *plan)
{
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
    say_times(study);
    study_table_write(study, stdout);
    const int dissipates = model_dissipates(&study->model) != NULL;
    printf("\nreference: %s, its energy constant to %.0e, the solution known to %.0e; ||q||^2 = %.13g\n",
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

int study_go(const struct plan *plan, const struct study_place *place, int rank)
{
    struct study study;
    struct message message = {""}, problem = {""};
    const int64_t all = plan->steppers_count * plan->h_count;
    const struct study_watch watch = begin_watch(); /* on all ranks before any of them says a word */
    if (open_tasks(place, study_journal, study_outputs, STUDY_FILES, study_identify, plan, all, sizeof(struct outcome),
                   rank) != 0)
        return -1;
    const struct store store = tasks_store(&tasks);
    if (rank == 0)
        say_plan(plan);
    int failed = study_run(plan, MPI_COMM_WORLD, &watch, rank == 0 ? &store : NULL, &study, &message);
    progress_clear();
    if (failed == 0 && rank == 0 &&
        (check_files(place, study_journal, 1, study_outputs, STUDY_FILES, &problem) != 0 ||
         study_files_write(&study, place->folder, &problem) != 0))
        failed = not_written(&problem, &message);
    /* a run that is refused would be refused again */
    failed = end_study(failed, all, failed == 0 || study.refused, rank, &message);
    if (failed == 0 && rank == 0)
        say_study(&study, place->folder);
    if (failed == 0)
        failed = some_bad(&study, rank);
    study_destroy(&study);
    return failed;
}

/* ---- surveys ----------------------------------------------------------------------------------------------------- */

static void say_survey_plan(const struct survey_plan *plan)
{
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

int survey_go(const struct survey_plan *plan, const struct study_place *place, int rank)
{
    struct survey survey;
    struct survey_counts counts = {{0}, 0, 0};
    struct message message = {""}, problem = {""};
    const struct study_watch watch = begin_watch(); /* on all ranks before any of them says a word */
    results = "points";
    if (open_tasks(place, study_journal, study_outputs, STUDY_FILES, survey_identify, plan, survey_points(plan),
                   (size_t)survey_bytes(plan), rank) != 0)
        return -1;
    const struct store store = tasks_store(&tasks);
    if (rank == 0)
        say_survey_plan(plan);
    int failed = survey_run(plan, MPI_COMM_WORLD, &watch, rank == 0 ? &store : NULL, &survey, &message);
    progress_clear();
    if (failed == 0 && rank == 0 &&
        (check_files(place, study_journal, 1, study_outputs, STUDY_FILES, &problem) != 0 ||
         survey_files_write(&survey, place->folder, &counts, &problem) != 0 ||
         say_survey(&survey, &counts, place->folder, &problem) != 0))
        failed = not_written(&problem, &message);
    failed = end_study(failed, survey_points(plan), failed == 0, rank, &message);
    int bad = counts.verdict[VERDICT_BAD] > 0 || counts.failed > 0;
    MPI_Bcast(&bad, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return failed == 0 ? bad : failed;
}

/* ---- cost -------------------------------------------------------------------------------------------------------- */

static void say_cost_plan(const struct cost_plan *plan)
{
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
    cost_table_write(cost, stdout);
    printf("%lld runs in %.2f s, written to %s: cost.csv errors.csv prices.csv machine.txt\n", (long long)cost->runs,
           cost->seconds, folder);
}

int cost_go(const struct cost_plan *plan, const struct study_place *place, int rank)
{
    static struct cost cost;
    struct message message = {""}, problem = {""};
    const int64_t all = plan->cases_count * plan->methods_count;
    const struct study_watch watch = begin_watch(); /* on all ranks before any of them says a word */
    results = "ladders";
    if (open_tasks(place, cost_journal, cost_outputs, COST_FILES, cost_identify, plan, all, sizeof(struct cost_ladder),
                   rank) != 0)
        return -1;
    const struct store store = tasks_store(&tasks);
    if (rank == 0)
        say_cost_plan(plan);
    int failed = cost_run(plan, MPI_COMM_WORLD, &watch, rank == 0 ? &store : NULL, &cost, &message);
    progress_clear();
    if (failed == 0 && rank == 0 &&
        (check_files(place, cost_journal, 1, cost_outputs, COST_FILES, &problem) != 0 ||
         cost_files_write(&cost, place->folder, &problem) != 0))
        failed = not_written(&problem, &message);
    failed = end_study(failed, all, failed == 0, rank, &message);
    if (failed == 0 && rank == 0)
        say_cost(&cost, place->folder);
    cost_destroy(&cost);
    return failed;
}
