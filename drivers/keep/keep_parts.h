/* SPDX-License-Identifier: BSD-3-Clause
 * What pieces and commits (keep.c) and opening and closing (keep_open.c) share. */
#ifndef VTI_KEEP_PARTS_H
#define VTI_KEEP_PARTS_H

#include "keep.h"

/** The tables by their names in SQL. */
extern const char *const keep_tables[KEEP_TABLES];

/** Writes the line of a failure by the system's reason, an errno, and returns -1. */
int keep_fail_as(struct keep *keep, int reason, struct message *message);
/** The same of what SQLite has against the last call. */
int keep_fail(struct keep *keep, struct message *message);

/** Runs SQL that gives no rows. Returns 0, or -1 with one line in *message. */
int keep_execute(struct keep *keep, const char *sql, struct message *message);
/** Writes SQL about a table and makes a statement of it; NULL if that fails. */
struct sqlite3_stmt *keep_prepare(struct keep *keep, const char *before, enum keep_table table, const char *behind);

/** Whether there is another file, or none, where this one was opened. */
int keep_has_gone(const struct keep *keep);

#endif
