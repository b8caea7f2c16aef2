/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What survives a kill: one SQLite file beside the output of a run or a study. It says what run or study it is
 * (identity.h) and holds what that has done, numbered pieces of bytes in tables. SQLite commits what has been put since
 * the last commit as a whole or not at all, takes back what a killed program has left half done, and locks the file
 * against other programs from when it is opened until it is closed or the program ends. Its own bytes SQLite does not
 * check: each piece has a digest. */
#ifndef VTI_KEEP_H
#define VTI_KEEP_H

#include <stdint.h>

#include "folder.h"

enum keep_table { KEEP_IDENTITY, KEEP_CHECKPOINT, KEEP_ROWS, KEEP_FRAMES, KEEP_RESULTS, KEEP_TABLES };

struct sqlite3;
struct sqlite3_stmt;

struct keep {
    char path[FOLDER_PATH];
    const char *what;   /* "run" or "study", as messages say */
    struct sqlite3 *db; /* NULL: not open */
    int locked;
    int there;  /* the file was there before */
    int holds;  /* something is committed in it, by this program or an earlier one */
    int waits;  /* something has been put since */
    int reason; /* errno of what has failed last; 0: the file is damaged */
    double due; /* clock: when keep_settle commits next */
    struct sqlite3_stmt *put[KEEP_TABLES], *get[KEEP_TABLES];
};

/** Opens or makes the file at path and locks it. One that holds something is gone on with if resume is not 0 and it is
 *  of the same identity; else it is refused, as are files beside it under names that SQLite would take for its own,
 *  unless a killed program may have left them. Returns 0, or -1 with one line in *message, what was there as it was and
 *  nothing to be closed. */
int keep_open(struct keep *keep, const char *path, const char *what, const char *identity, int resume,
              struct message *message);

/** Puts a piece, in the place of one that has this number. Returns 0, or -1 with one line in *message. */
int keep_put(struct keep *keep, enum keep_table table, int64_t number, const void *bytes, size_t size,
             struct message *message);

/** The piece of this number, until the next call. Returns 1, 0 if there is none, or -1 with one line in *message. */
int keep_get(struct keep *keep, enum keep_table table, int64_t number, const void **bytes, size_t *size,
             struct message *message);

/** Reads all pieces of a table, so that damage is seen, and counts them. Returns 0, or -1 with one line in *message. */
int keep_check(struct keep *keep, enum keep_table table, int64_t *count, struct message *message);

/** Commits what has been put: to the disk. Returns 0, or -1 with one line in *message. */
int keep_commit(struct keep *keep, struct message *message);

/** The same if the last commit was half a second ago, or twenty times as long as that took. */
int keep_settle(struct keep *keep, struct message *message);

/** Writes the line that the file is damaged, and returns -1. */
int keep_damaged(const struct keep *keep, const char *how, struct message *message);

/** Closes the file and leaves it, with what was committed last. Harmless, like keep_remove, if it is not open. */
void keep_close(struct keep *keep);
/** Removes it, as far as it still is this program's, and closes it. */
void keep_remove(struct keep *keep);

#endif
