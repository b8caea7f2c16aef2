/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The journal of a study: a file in its folder that says what study it is and takes every result as it comes in. It is
 * locked while a study works there, and removed when the study's files are written, so that a study that dies leaves what it
 * has done. */
#ifndef VTI_TASK_JOURNAL_H
#define VTI_TASK_JOURNAL_H

#include "folder.h"
#include "store.h"

/** What a study is, by digests; it goes on only as the same study. */
enum task_part { TASK_SCENES, TASK_BODIES, TASK_TABLES, TASK_METHODS, TASK_STEPS, TASK_ENDS, TASK_LIMITS, TASK_PARTS };

struct task_identity {
    char version[16]; /* of vti */
    int64_t tasks;
    int64_t bytes; /* of a result */
    uint64_t part[TASK_PARTS];
};

struct task_journal {
    char path[FOLDER_PATH];
    int fd;
    int64_t tasks, bytes;
    int64_t end;           /* of the last whole record */
    int64_t kept;          /* tasks whose results are there */
    int64_t *place;        /* [tasks]: of the record in the file, 0 if there is none */
    unsigned char *record; /* one, as it is in the file */
    double synced;         /* when */
};

/** Opens folder/name and locks it. If it holds a study already, resume says whether to go on with it; that must be the one of
 *  *identity. Returns 0, or -1 with one line in *message, the file as it was and nothing to be closed. */
int task_journal_open(struct task_journal *journal, const char *folder, const char *name, int resume,
                      const struct task_identity *identity, struct message *message);

/** The results as a store; they are of the size that the identity names. */
struct store task_journal_store(struct task_journal *journal);

/** Closes the file and leaves it where it is, unless it holds no result. */
void task_journal_close(struct task_journal *journal);
/** Closes and removes it. */
void task_journal_remove(struct task_journal *journal);

#endif
