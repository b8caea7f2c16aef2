/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rollback journal and not WAL: frames are large, and go to the disk once instead of twice; network file systems have
 * what it needs, locks by fcntl, where WAL wants shared memory. */
#define _XOPEN_SOURCE 700
#include "keep.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "digest.h"
#include "identity.h"
#include "left.h"

enum { PAGE = 16384 };

static const char *const tables[KEEP_TABLES] = {"identity", "checkpoint", "rows", "frames", "results"};

/* ---- messages ---------------------------------------------------------------------------------------------------- */

static int fail_as(struct keep *keep, int reason, struct message *message)
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
    return keep->reason != 0 ? fail_as(keep, keep->reason, message) : fail_as_damaged(keep, message);
}

/** What SQLite has against the last call. */
static int fail(struct keep *keep, struct message *message)
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
        return fail_as(keep, ENOSPC, message);
    case SQLITE_NOMEM:
        return fail_as(keep, ENOMEM, message);
    case SQLITE_READONLY:
        return fail_as(keep, code == SQLITE_READONLY_DBMOVED ? ENOENT : EACCES, message);
    default:
        return fail_as(keep, reason != 0 ? reason : last != 0 ? last : EIO, message); /* it forgets that of a commit */
    }
}

static int execute(struct keep *keep, const char *sql, struct message *message)
{
    return sqlite3_exec(keep->db, sql, NULL, NULL, NULL) == SQLITE_OK ? 0 : fail(keep, message);
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
    const int failed = sqlite3_step(put) != SQLITE_DONE ? fail(keep, message) : 0;
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
        return found == SQLITE_DONE ? 0 : fail(keep, message);
    return take(keep, get, bytes, size, message) == 0 ? 1 : -1;
}

/** Writes SQL about a table and makes a statement of it. */
static struct sqlite3_stmt *prepare(struct keep *keep, const char *before, enum keep_table table, const char *behind)
{
    char sql[128];
    struct sqlite3_stmt *made = NULL;
    snprintf(sql, sizeof sql, "%s %s %s", before, tables[table], behind);
    sqlite3_prepare_v2(keep->db, sql, -1, &made, NULL);
    return made;
}

int keep_check(struct keep *keep, enum keep_table table, int64_t *count, struct message *message)
{
    const void *bytes;
    size_t size;
    struct sqlite3_stmt *all = prepare(keep, "SELECT number, bytes, digest FROM", table, "ORDER BY number");
    int step = SQLITE_ERROR, failed = 0;
    *count = 0;
    while (all != NULL && failed == 0 && (step = sqlite3_step(all)) == SQLITE_ROW) {
        failed = take(keep, all, &bytes, &size, message);
        ++*count;
    }
    if (failed == 0 && step != SQLITE_DONE)
        failed = fail(keep, message);
    sqlite3_finalize(all);
    return failed;
}

/** Whether there is another file, or none, where this one was opened. */
static int has_gone(const struct keep *keep)
{
    int moved = 0;
    sqlite3_file_control(keep->db, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved;
}

/* ---- commits ----------------------------------------------------------------------------------------------------- */

double keep_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int keep_commit(struct keep *keep, struct message *message)
{
    const double begin = keep_now();
    if (is_broken(keep))
        return fail_again(keep, message);
    if (has_gone(keep))
        return fail_as(keep, ENOENT, message);
    if (execute(keep, "COMMIT; BEGIN", message) != 0)
        return -1;
    keep->holds = 1;
    keep->waits = 0;
    keep->due = keep_now() + fmax(0.5, 20.0 * (keep_now() - begin));
    return 0;
}

int keep_settle(struct keep *keep, struct message *message)
{
    return keep->waits && keep_now() >= keep->due ? keep_commit(keep, message) : 0;
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

/** SQLite takes no path of more characters, that of its journal. */
static int check_length(const struct keep *keep, struct message *message)
{
    enum { MOST = 511 };
    char *const whole = realpath(keep->path, NULL);
    const size_t length = whole != NULL ? strlen(whole) + strlen("-journal") : 0;
    free(whole);
    if (length <= MOST)
        return 0;
    if (!keep->there)
        unlink(keep->path);
    return message_set(message,
                       "%.200s: with its folder the path has %lld characters, and at most %d can be used; use a "
                       "shorter one with -o",
                       keep->path, (long long)length, MOST);
}

/** Makes the file if need be, and finds out whether its file system knows locks. */
static int probe(struct keep *keep, const char **vfs, struct message *message)
{
    struct stat info;
    struct flock lock;
    memset(&lock, 0, sizeof lock);
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    keep->there = lstat(keep->path, &info) == 0;
    if (keep->there && !S_ISREG(info.st_mode))
        return message_set(message, "%.600s: is there already and is no file; choose another place with -o",
                           keep->path);
    if (left_beside(keep->path, keep->what, message) != 0)
        return -1;
    const int fd = open(keep->path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (fd < 0)
        return fail_as(keep, errno, message);
    *vfs = fcntl(fd, F_GETLK, &lock) == 0 ? "unix" : "unix-none";
    const int ours = left_is_ours(fd);
    close(fd);
    if (ours && check_length(keep, message) != 0)
        return -1;
    /* before SQLite writes to a file that is somebody's */
    return ours ? 0 : keep_damaged(keep, "is none of vti's, or is damaged", message);
}

static int lock(struct keep *keep, const char *vfs, struct message *message)
{
    char setup[160];
    snprintf(setup, sizeof setup,
             "PRAGMA page_size = %d; PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode "
             "= TRUNCATE; BEGIN EXCLUSIVE",
             PAGE);
    if (sqlite3_open_v2(keep->path, &keep->db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, vfs) != SQLITE_OK)
        return keep->db != NULL ? fail(keep, message) : fail_as(keep, ENOMEM, message);
    if (execute(keep, setup, message) != 0)
        return -1;
    keep->locked = 1;
    return 0;
}

static int64_t number_of(struct keep *keep, const char *sql)
{
    struct sqlite3_stmt *get = NULL;
    sqlite3_prepare_v2(keep->db, sql, -1, &get, NULL);
    const int64_t number = sqlite3_step(get) == SQLITE_ROW ? sqlite3_column_int64(get, 0) : -1;
    sqlite3_finalize(get);
    return number;
}

static int make_tables(struct keep *keep, struct message *message)
{
    char sql[160];
    snprintf(sql, sizeof sql, "PRAGMA application_id = %d", LEFT_ID);
    int failed = execute(keep, sql, message);
    for (int k = 0; failed == 0 && k < KEEP_TABLES; ++k) {
        snprintf(sql, sizeof sql, "CREATE TABLE %s (number INTEGER PRIMARY KEY, bytes BLOB, digest INTEGER)",
                 tables[k]);
        failed = execute(keep, sql, message);
    }
    return failed;
}

static int prepare_all(struct keep *keep, struct message *message)
{
    for (int k = 0; k < KEEP_TABLES; ++k) {
        keep->put[k] = prepare(keep, "INSERT OR REPLACE INTO", (enum keep_table)k, "VALUES (?, ?, ?)");
        keep->get[k] = prepare(keep, "SELECT number, bytes, digest FROM", (enum keep_table)k, "WHERE number = ?");
        if (keep->put[k] == NULL || keep->get[k] == NULL)
            return fail(keep, message);
    }
    return 0;
}

/** What is there is of this very run or study. */
static int check_identity(struct keep *keep, const char *identity, struct message *message)
{
    const void *bytes = NULL;
    size_t size = 0;
    struct message difference;
    const int found = keep_get(keep, KEEP_IDENTITY, 0, &bytes, &size, message);
    if (found <= 0)
        return found < 0 ? -1 : keep_damaged(keep, "is damaged", message);
    if (identity_is(bytes, size, identity, &difference))
        return 0;
    return identity_refuse(keep->path, keep->what, &difference, message);
}

static int take_over(struct keep *keep, const char *identity, int resume, struct message *message)
{
    const int64_t version = number_of(keep, "PRAGMA application_id");
    if (version == 0 && number_of(keep, "SELECT count(*) FROM sqlite_master") == 0)
        return make_tables(keep, message) != 0 || prepare_all(keep, message) != 0
                   ? -1
                   : keep_put(keep, KEEP_IDENTITY, 0, identity, strlen(identity), message);
    if (version != LEFT_ID)
        return keep_damaged(keep, "is none of vti's, or is damaged", message);
    keep->holds = 1;
    if (!resume)
        return message_set(
            message, "%.600s: holds a %s that was interrupted; go on with it by --resume, or delete it to start anew",
            keep->path, keep->what);
    return prepare_all(keep, message) != 0 ? -1 : check_identity(keep, identity, message);
}

int keep_open(struct keep *keep, const char *path, const char *what, const char *identity, int resume,
              struct message *message)
{
    const char *vfs = NULL;
    int failed;
    memset(keep, 0, sizeof *keep);
    snprintf(keep->path, sizeof keep->path, "%s", path);
    keep->what = what;
    do {
        keep_close(keep);
        failed = probe(keep, &vfs, message) != 0 || lock(keep, vfs, message) != 0 ? -1 : 0;
    } while (keep->db != NULL && has_gone(keep)); /* removed between being opened and locked */
    if (failed == 0 && take_over(keep, identity, resume, message) == 0) {
        keep->waits = 0;
        return 0;
    }
    if (failed == 0 && !keep->there)
        keep_remove(keep);
    else
        keep_close(keep);
    return -1;
}

/* ---- closing ----------------------------------------------------------------------------------------------------- */

/** SQLite's own journal. It is empty when all is well; else it holds what is to be taken back. */
static void remove_journal(const struct keep *keep, int removes)
{
    char path[FOLDER_PATH + 16];
    struct stat info;
    snprintf(path, sizeof path, "%s-journal", keep->path);
    if (stat(path, &info) == 0 && (removes || info.st_size == 0))
        unlink(path);
}

static void end(struct keep *keep, int removes)
{
    for (int k = 0; k < KEEP_TABLES; ++k) {
        sqlite3_finalize(keep->put[k]);
        sqlite3_finalize(keep->get[k]);
        keep->put[k] = keep->get[k] = NULL;
    }
    if (keep->locked && !has_gone(keep)) { /* before the lock goes with the file */
        sqlite3_exec(keep->db, "ROLLBACK", NULL, NULL, NULL);
        remove_journal(keep, removes);
        if (removes)
            unlink(keep->path);
    }
    sqlite3_close(keep->db);
    keep->db = NULL;
    keep->locked = 0;
}

void keep_close(struct keep *keep)
{
    end(keep, 0);
}

void keep_remove(struct keep *keep)
{
    end(keep, 1);
}
