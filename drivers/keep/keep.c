/* SPDX-License-Identifier: BSD-3-Clause */
#include "keep.h"

#include <errno.h>
#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <string.h>

#include "clock.h"
#include "digest.h"
#include "keep_parts.h"

const char *const keep_tables[KEEP_TABLES] = {"identity", "checkpoint", "rows", "frames", "results"};

/* ---- messages ---------------------------------------------------------------------------------------------------- */

int keep_fail_as(struct keep *keep, int reason, struct message *message)
{
    keep->reason = reason;
    return message_set(message, "%.600s: %s; %s", keep->path, strerror(reason), folder_remedy(reason));
}

int keep_damaged(const struct keep *keep, const char *how, struct message *message)
{
    return message_set(message, "%.600s: %s; delete it and start the %s anew, or choose another place with -o",
                       keep->path, how, keep->what);
}

static int fail_as_damaged(struct keep *keep, struct message *message)
{
    keep->reason = 0;
    return keep_damaged(keep, "is none of vti's, or is damaged", message);
}

/** The failure after which nothing more can be put. */
static int fail_again(struct keep *keep, struct message *message)
{
    return keep->reason != 0 ? keep_fail_as(keep, keep->reason, message) : fail_as_damaged(keep, message);
}

int keep_fail(struct keep *keep, struct message *message)
{
    const int last = errno, code = sqlite3_extended_errcode(keep->db), reason = sqlite3_system_errno(keep->db);
    switch (code & 0xff) {
    case SQLITE_BUSY:
        keep->reason = EBUSY;
        return message_set(message,
                           "%.600s: another vti-%s is writing there; wait for it or choose another place with -o",
                           keep->path, keep->what);
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
    case SQLITE_ERROR: /* the tables are not ours */
        return fail_as_damaged(keep, message);
    case SQLITE_FULL:
        return keep_fail_as(keep, ENOSPC, message);
    case SQLITE_NOMEM:
        return keep_fail_as(keep, ENOMEM, message);
    case SQLITE_READONLY:
        return keep_fail_as(keep, code == SQLITE_READONLY_DBMOVED ? ENOENT : EACCES, message);
    default: /* it forgets the reason of a commit that fails */
        return keep_fail_as(keep, reason != 0 ? reason : last != 0 ? last : EIO, message);
    }
}

int keep_execute(struct keep *keep, const char *sql, struct message *message)
{
    return sqlite3_exec(keep->db, sql, NULL, NULL, NULL) == SQLITE_OK ? 0 : keep_fail(keep, message);
}

/* ---- pieces ------------------------------------------------------------------------------------------------------ */

/** Whether SQLite has taken back all since the last commit, because the disk has failed. */
static int is_broken(const struct keep *keep)
{
    return sqlite3_get_autocommit(keep->db);
}

static uint64_t digest_of(int64_t number, const void *bytes, size_t size)
{
    return digest_add(digest_add(DIGEST_START, &number, sizeof number), bytes, size);
}

int keep_put(struct keep *keep, enum keep_table table, int64_t number, const void *bytes, size_t size,
             struct message *message)
{
    struct sqlite3_stmt *put = keep->put[table];
    if (is_broken(keep))
        return fail_again(keep, message);
    sqlite3_bind_int64(put, 1, number);
    if (table == KEEP_IDENTITY)
        sqlite3_bind_text64(put, 2, bytes, size, SQLITE_STATIC, SQLITE_UTF8);
    else
        sqlite3_bind_blob64(put, 2, bytes, size, SQLITE_STATIC);
    sqlite3_bind_int64(put, 3, (int64_t)digest_of(number, bytes, size));
    const int failed = sqlite3_step(put) != SQLITE_DONE ? keep_fail(keep, message) : 0;
    sqlite3_reset(put);
    keep->waits = 1;
    return failed;
}

/** Takes a row "number, bytes, digest" to which a statement has been stepped. */
static int take(struct keep *keep, struct sqlite3_stmt *row, const void **bytes, size_t *size, struct message *message)
{
    const int64_t number = sqlite3_column_int64(row, 0);
    *bytes = sqlite3_column_blob(row, 1);
    *size = (size_t)sqlite3_column_bytes(row, 1);
    if (digest_of(number, *bytes, *size) == (uint64_t)sqlite3_column_int64(row, 2))
        return 0;
    return keep_damaged(keep, "is damaged", message);
}

int keep_get(struct keep *keep, enum keep_table table, int64_t number, const void **bytes, size_t *size,
             struct message *message)
{
    struct sqlite3_stmt *get = keep->get[table];
    sqlite3_reset(get);
    sqlite3_bind_int64(get, 1, number);
    const int found = sqlite3_step(get);
    if (found != SQLITE_ROW)
        return found == SQLITE_DONE ? 0 : keep_fail(keep, message);
    return take(keep, get, bytes, size, message) == 0 ? 1 : -1;
}

struct sqlite3_stmt *keep_prepare(struct keep *keep, const char *before, enum keep_table table, const char *behind)
{
    char sql[128];
    struct sqlite3_stmt *made = NULL;
    snprintf(sql, sizeof sql, "%s %s %s", before, keep_tables[table], behind);
    sqlite3_prepare_v2(keep->db, sql, -1, &made, NULL);
    return made;
}

int keep_check(struct keep *keep, enum keep_table table, int64_t *count, struct message *message)
{
    const void *bytes;
    size_t size;
    struct sqlite3_stmt *all = keep_prepare(keep, "SELECT number, bytes, digest FROM", table, "ORDER BY number");
    int step = SQLITE_ERROR, failed = 0;
    *count = 0;
    while (all != NULL && failed == 0 && (step = sqlite3_step(all)) == SQLITE_ROW) {
        failed = take(keep, all, &bytes, &size, message);
        ++*count;
    }
    if (failed == 0 && step != SQLITE_DONE)
        failed = keep_fail(keep, message);
    sqlite3_finalize(all);
    return failed;
}

int keep_has_gone(const struct keep *keep)
{
    int moved = 0;
    sqlite3_file_control(keep->db, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved;
}

/* ---- commits ----------------------------------------------------------------------------------------------------- */

int keep_commit(struct keep *keep, struct message *message)
{
    const double begin = clock_now();
    if (is_broken(keep))
        return fail_again(keep, message);
    if (keep_has_gone(keep))
        return keep_fail_as(keep, ENOENT, message);
    if (keep_execute(keep, "COMMIT; BEGIN", message) != 0)
        return -1;
    keep->holds = 1;
    keep->waits = 0;
    keep->due = clock_now() + fmax(0.5, 20.0 * (clock_now() - begin));
    return 0;
}

int keep_settle(struct keep *keep, struct message *message)
{
    return keep->waits && clock_now() >= keep->due ? keep_commit(keep, message) : 0;
}
