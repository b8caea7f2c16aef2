/* SPDX-License-Identifier: BSD-3-Clause
 * What all studies need from their start to their end: agreement of the ranks, results that are kept, signals. */
#define _POSIX_C_SOURCE 200809L
#include "study_tasks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "hdf5_sink.h"
#include "identity.h"
#include "left.h"
#include "signals.h"
#include "tasks.h"
#include "terminal.h"

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
        FILE *const file = signals_seen() != NULL ? last_words() : stderr;
        progress_clear();
        fprintf(file, "vti-study: %s\n", all[1] == rank ? message->text : "out of memory; use fewer runs");
        fflush(file);
    }
    return -1;
}

/* ---- what is kept, which rank 0 has ----------------------------------------------------------------------------- */

static struct tasks tasks;
static const struct study_work *now; /* the one that is open */

/** left says whether the journal is ours (overwrite.h). */
static int check_files(const struct study_place *place, int left, struct message *message)
{
    const struct overwrite overwrite = {.folder = place->folder,
                                        .outputs = now->files,
                                        .outputs_count = now->files_count,
                                        .inputs = place->inputs,
                                        .inputs_count = place->inputs_count,
                                        .kept = {now->journal, left},
                                        .force = place->force};
    return overwrite_check(&overwrite, message);
}

int study_tasks_check(const struct study_place *place, struct message *message)
{
    return check_files(place, 1, message);
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
    const int ours = overwrite_is_ours(path, &hdf5);
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

static int check_start(const struct study_place *place, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_path(place->folder, now->journal, 0, path, message) != 0)
        return -1;
    return check_files(place, left_is_there(path), message) != 0 ? -1 : check_pictures(place, message);
}

/** On rank 0. */
static int open_here(const struct study_place *place, struct message *message)
{
    size_t size;
    char *identity = NULL;
    FILE *text = open_memstream(&identity, &size);
    int failed = text == NULL ? -1 : 0;
    if (failed == 0) {
        identity_version(text);
        now->identify(text, now->plan);
        fprintf(text, "bytes of a result: %zu\n", now->bytes);
        failed = fclose(text) != 0 ? -1 : 0;
    }
    if (failed == 0 &&
        (check_start(place, message) != 0 || folder_create(place->folder, message) != 0 ||
         tasks_open(&tasks, place->folder, now->journal, place->resume, identity, now->bytes, message) != 0))
        failed = -1;
    free(identity);
    return failed;
}

int study_tasks_open(const struct study_work *work, const struct study_place *place, int rank)
{
    struct message message = {""};
    now = work;
    hdf5_start();
    const int failed = rank == 0 ? open_here(place, &message) : 0;
    if (study_agree(failed, rank, &message) != 0)
        return -1;
    if (rank == 0 && place->resume && tasks.kept > 0)
        printf("goes on: %lld of %lld %s are there already\n", (long long)tasks.kept, (long long)now->count,
               now->results);
    else if (rank == 0 && place->resume)
        printf("no %s are there yet: starts\n", now->results);
    fflush(stdout);
    return 0;
}

struct store study_tasks_store(void)
{
    return tasks_store(&tasks);
}

int study_tasks_not_written(const struct message *problem, struct message *message)
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
    return signals_seen() != NULL;
}

struct study_watch study_watch_begin(void)
{
    const struct study_watch watch = {show, is_asked};
    signals_catch();
    return watch;
}

static void say_stopped(struct message *message)
{
    if (tasks.kept == 0)
        message_set(message, "stopped before any %s were done; the same command with --resume starts again",
                    now->results);
    else
        message_set(message, "stopped; %lld of %lld %s are kept in %.300s: go on with --resume", (long long)tasks.kept,
                    (long long)now->count, now->results, tasks.keep.path);
}

/** Keeps what is done, on rank 0. Returns 0, or -1 if that cannot be: then *message says so, too. */
static int keep_results(int failed, struct message *message)
{
    struct message problem;
    if (tasks_commit(&tasks, &problem) != 0) {
        const struct message cause = *message;
        if (strcmp(cause.text, problem.text) == 0)
            return -1;
        return message_set(message, "%.500s%s%.500s", cause.text, cause.text[0] != '\0' ? "; and " : "", problem.text);
    }
    if (failed == WATCH_ASKED)
        say_stopped(message);
    return 0;
}

int study_tasks_end(int failed, int rank, struct message *message)
{
    int lost = rank == 0 && failed != 0 && keep_results(failed, message) != 0;
    MPI_Bcast(&lost, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (rank == 0)
        tasks_end(&tasks, failed == 0);
    const int agreed = study_agree(lost ? -1 : failed, rank, message);
    return failed == WATCH_ASKED && !lost ? failed : agreed;
}
