/* SPDX-License-Identifier: BSD-3-Clause
 * What all studies share from their start to their end: agreement of the ranks, results that are kept, signals. */
#ifndef VTI_STUDY_TASKS_H
#define VTI_STUDY_TASKS_H

#include "study_go.h"
#include "tasks.h"

/** Ends a stage on all ranks: 0 if it went well on all of them; else one line from one of them and -1. Collective. */
int study_agree(int failed, int rank, const struct message *message);

/** What a study keeps as it goes, and writes. */
struct study_work {
    const char *journal; /* where results are kept in the study's folder */
    const char *results; /* what they are, for people: "runs" */
    int64_t count;       /* of them */
    size_t bytes;        /* of each */
    const struct output *files;
    int files_count;
    void (*identify)(FILE *text, const void *plan); /* what the study is */
    const void *plan;
};

/** From now on signals are noted, and the study ends at its next look for them. */
struct study_watch study_watch_begin(void);

/** Opens the journal on rank 0 and says what is there already; one study at a time. Collective. Returns 0, or -1 when
 *  one line has been said. work must outlive study_tasks_end. */
int study_tasks_open(const struct study_work *work, const struct study_place *place, int rank);
/** Where results go, on rank 0. */
struct store study_tasks_store(void);
/** Whether the files may still be written. Returns 0, or -1 with one line in *message. */
int study_tasks_check(const struct study_place *place, struct message *message);
/** Says in *message what is wrong with the files, and where the results are. Returns -1. */
int study_tasks_not_written(const struct message *problem, struct message *message);
/** The end of a study that returned failed: 0, and nothing of it needs to be kept, or what has come in is. Collective.
 *  Returns on all ranks 0, or when one line has been said WATCH_ASKED or -1. */
int study_tasks_end(int failed, int rank, struct message *message);

#endif
