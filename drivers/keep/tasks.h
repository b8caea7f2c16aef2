/* SPDX-License-Identifier: BSD-3-Clause
 * The results of a study as they come in, in a file of its folder (keep.h) that is removed when the study's files are
 * written: a study that dies leaves what it had done half a second before. */
#ifndef VTI_TASKS_H
#define VTI_TASKS_H

#include "keep.h"
#include "store.h"

struct tasks {
    struct keep keep;
    int64_t kept;          /* results that are there */
    size_t size;           /* of a result with the rank before it */
    unsigned char *result; /* one, so */
};

/** Opens folder/name for a study of this identity, with results of so many bytes. If it holds results already, resume
 *  says whether to go on with them. Returns 0, or -1 with one line in *message, the file as it was and nothing to be
 *  closed. */
int tasks_open(struct tasks *tasks, const char *folder, const char *name, int resume, const char *identity,
               size_t bytes, struct message *message);

/** The results as a store. */
struct store tasks_store(struct tasks *tasks);

/** To be called often: brings to the disk what has waited for half a second. */
void tasks_settle(struct tasks *tasks);
/** Brings all results to the disk. Returns 0, or -1 with one line in *message. */
int tasks_commit(struct tasks *tasks, struct message *message);

/** Closes the file with what has been committed, or removes it, as it is when it holds nothing. */
void tasks_end(struct tasks *tasks, int removes);

#endif
