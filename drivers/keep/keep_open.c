/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rollback journal and not WAL: frames are large, and go to the disk once instead of twice; network file systems have
 * what it needs, locks by fcntl, where WAL wants shared memory. */
#define _XOPEN_SOURCE 700
#include "keep.h"

#include <errno.h>
#include <fcntl.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "identity.h"
#include "keep_parts.h"
#include "left.h"

enum { PAGE = 16384 };

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
        return keep_fail_as(keep, errno, message);
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
        return keep->db != NULL ? keep_fail(keep, message) : keep_fail_as(keep, ENOMEM, message);
    if (keep_execute(keep, setup, message) != 0)
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
    int failed = keep_execute(keep, sql, message);
    for (int k = 0; failed == 0 && k < KEEP_TABLES; ++k) {
        snprintf(sql, sizeof sql, "CREATE TABLE %s (number INTEGER PRIMARY KEY, bytes BLOB, digest INTEGER)",
                 keep_tables[k]);
        failed = keep_execute(keep, sql, message);
    }
    return failed;
}

static int prepare_all(struct keep *keep, struct message *message)
{
    for (int k = 0; k < KEEP_TABLES; ++k) {
        keep->put[k] = keep_prepare(keep, "INSERT OR REPLACE INTO", (enum keep_table)k, "VALUES (?, ?, ?)");
        keep->get[k] = keep_prepare(keep, "SELECT number, bytes, digest FROM", (enum keep_table)k, "WHERE number = ?");
        if (keep->put[k] == NULL || keep->get[k] == NULL)
            return keep_fail(keep, message);
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
    } while (keep->db != NULL && keep_has_gone(keep)); /* removed between being opened and locked */
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
    if (keep->locked && !keep_has_gone(keep)) { /* before the lock goes with the file */
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
