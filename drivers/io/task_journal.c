/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The file: struct head, then records of {task, rank, result, digest of these}, in the order in which they came in. */
#define _XOPEN_SOURCE 700 /* SIGXFSZ */
#include "task_journal.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "digest.h"
#include "file_lock.h"

struct head {
    char magic[16];
    struct task_identity identity;
    uint64_t digest; /* of all before it */
};

struct mark {
    int64_t task, rank;
};

static const char magic[16] = "vti tasks 1";

static size_t record_size(const struct task_journal *journal)
{
    return sizeof(struct mark) + (size_t)journal->bytes + sizeof(uint64_t);
}

static int fail(const struct task_journal *journal, struct message *message)
{
    return message_set(message, "%s: %s; %s", journal->path, strerror(errno), folder_remedy(errno));
}

static int damaged(const struct task_journal *journal, const char *what, struct message *message)
{
    return message_set(message, "%s: %s; delete it and start the study anew, or choose another folder with -o",
                       journal->path, what);
}

/* ---- bytes ------------------------------------------------------------------------------------------------------- */

/** Appends all of them behind the last whole record, or none. */
static int append(struct task_journal *journal, const void *bytes, size_t size)
{
    const char *from = bytes;
    for (size_t done = 0; done < size;) {
        const ssize_t n = pwrite(journal->fd, from + done, size - done, (off_t)(journal->end + (int64_t)done));
        if (n > 0)
            done += (size_t)n;
        else if (n == 0 || errno != EINTR) {
            const int reason = n == 0 ? ENOSPC : errno;
            const int cut = ftruncate(journal->fd, (off_t)journal->end);
            (void)cut; /* a piece that stays is passed over when the file is opened again */
            errno = reason;
            return -1;
        }
    }
    journal->end += (int64_t)size;
    return 0;
}

/** Returns 1, 0 if the file ends before, or -1. */
static int read_at(const struct task_journal *journal, int64_t place, void *bytes, size_t size)
{
    char *to = bytes;
    for (size_t done = 0; done < size;) {
        const ssize_t n = pread(journal->fd, to + done, size - done, (off_t)(place + (int64_t)done));
        if (n == 0)
            return 0;
        if (n > 0)
            done += (size_t)n;
        else if (errno != EINTR)
            return -1;
    }
    return 1;
}

/* ---- what is there ----------------------------------------------------------------------------------------------- */

static struct head head_of(const struct task_identity *identity)
{
    struct head head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, magic, sizeof magic);
    memcpy(&head.identity, identity, sizeof *identity);
    head.digest = digest_add(DIGEST_START, &head, offsetof(struct head, digest));
    return head;
}

static int check_identity(const struct task_journal *journal, const struct task_identity *have,
                          const struct task_identity *want, struct message *message)
{
    static const char *const others[TASK_PARTS] = {"the scene or --set differs",
                                                   "its table holds other bodies",
                                                   "its table holds other bonds",
                                                   "--steppers differ",
                                                   "--h differs",
                                                   "--t-end differs",
                                                   "--evals or --memory differs"};
    if (strncmp(have->version, want->version, sizeof have->version) != 0)
        return message_set(message,
                           "%s: is of vti %.16s and this is vti %.16s; resume with that version, or start anew "
                           "with -o elsewhere",
                           journal->path, have->version, want->version);
    for (int k = 0; k < TASK_PARTS; ++k)
        if (have->part[k] != want->part[k])
            return message_set(message,
                               "%s: is of another study: %s; resume with the scene, tables and options of that study, "
                               "or start anew with -o elsewhere",
                               journal->path, others[k]);
    if (have->tasks != want->tasks || have->bytes != want->bytes)
        return damaged(journal, "holds other quantities than this program does", message);
    return 0;
}

static int check_head(const struct task_journal *journal, const struct task_identity *identity, struct message *message)
{
    struct head head;
    const int found = read_at(journal, 0, &head, sizeof head);
    if (found < 0)
        return fail(journal, message);
    if (found == 0 || memcmp(head.magic, magic, sizeof magic) != 0 ||
        head.digest != digest_add(DIGEST_START, &head, offsetof(struct head, digest)))
        return damaged(journal, "is no journal of vti-study, or is damaged", message);
    return check_identity(journal, &head.identity, identity, message);
}

/** Takes the record at the end of those before it, whose last bytes may be missing if the study was killed while it wrote
 *  them. Returns 1, 0 if there is none, or -1. */
static int next_record(struct task_journal *journal, struct message *message)
{
    struct mark mark;
    uint64_t digest;
    const size_t size = record_size(journal), body = size - sizeof digest;
    const int found = read_at(journal, journal->end, journal->record, size);
    if (found <= 0)
        return found == 0 ? 0 : fail(journal, message);
    memcpy(&mark, journal->record, sizeof mark);
    memcpy(&digest, journal->record + body, sizeof digest);
    if (digest != digest_add(DIGEST_START, journal->record, body) || mark.task < 0 || mark.task >= journal->tasks)
        return damaged(journal, "a result in it is damaged", message);
    journal->kept += journal->place[mark.task] == 0;
    journal->place[mark.task] = journal->end;
    journal->end += (int64_t)size;
    return 1;
}

static int read_records(struct task_journal *journal, struct message *message)
{
    int more = 1;
    journal->end = (int64_t)sizeof(struct head);
    while (more > 0)
        more = next_record(journal, message);
    return more;
}

/** Whether the file ends within its head, of this very study, which was killed while it wrote that: there is nothing in it. */
static int is_begun(const struct task_journal *journal, const struct task_identity *identity, int64_t size)
{
    char there[sizeof(struct head)];
    const struct head head = head_of(identity);
    return size < (int64_t)sizeof head && read_at(journal, 0, there, (size_t)size) == 1 &&
           memcmp(there, &head, (size_t)size) == 0;
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

static int begin(struct task_journal *journal, const struct task_identity *identity, struct message *message)
{
    const struct head head = head_of(identity);
    if (append(journal, &head, sizeof head) == 0)
        return 0;
    const int failed = fail(journal, message);
    unlink(journal->path);
    return failed;
}

static int take_over(struct task_journal *journal, int resume, const struct task_identity *identity,
                     struct message *message)
{
    struct stat info;
    if (fstat(journal->fd, &info) != 0)
        return fail(journal, message);
    if (is_begun(journal, identity, info.st_size))
        return begin(journal, identity, message);
    if (!resume)
        return message_set(
            message, "%s: holds a study that was interrupted; go on with it by --resume, or delete it to start anew",
            journal->path);
    return check_head(journal, identity, message) != 0 ? -1 : read_records(journal, message);
}

static int make_room(struct task_journal *journal, const struct task_identity *identity, struct message *message)
{
    journal->tasks = identity->tasks;
    journal->bytes = identity->bytes;
    journal->place = calloc((size_t)identity->tasks, sizeof *journal->place);
    journal->record = calloc(1, record_size(journal));
    return journal->place == NULL || journal->record == NULL
               ? message_set(message, "%s: out of memory; use fewer runs", journal->path)
               : 0;
}

static int open_file(struct task_journal *journal, struct message *message)
{
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is to be an error as others are, not the end of the program */
    journal->fd = file_lock_open(journal->path);
    if (journal->fd == FILE_LOCK_TAKEN)
        return message_set(message,
                           "%s: another vti-study is writing there; wait for it or choose another folder with -o",
                           journal->path);
    return journal->fd < 0 ? fail(journal, message) : 0;
}

int task_journal_open(struct task_journal *journal, const char *folder, const char *name, int resume,
                      const struct task_identity *identity, struct message *message)
{
    memset(journal, 0, sizeof *journal);
    journal->fd = -1;
    if (folder_path(folder, name, 0, journal->path, message) == 0 && make_room(journal, identity, message) == 0 &&
        open_file(journal, message) == 0 && take_over(journal, resume, identity, message) == 0)
        return 0;
    journal->kept = 1; /* the file is not ours to remove */
    task_journal_close(journal);
    return -1;
}

/* ---- results ----------------------------------------------------------------------------------------------------- */

static int recall(void *self, int64_t task, int *rank, void *result)
{
    const struct task_journal *journal = self;
    struct mark mark;
    if (journal->place[task] == 0 || read_at(journal, journal->place[task], journal->record, record_size(journal)) != 1)
        return 0;
    memcpy(&mark, journal->record, sizeof mark);
    memcpy(result, journal->record + sizeof mark, (size_t)journal->bytes);
    *rank = (int)mark.rank;
    return 1;
}

/** A killed program loses nothing that is written; only a machine that stops does, and for it a second is little. */
static int sync_now_and_then(struct task_journal *journal)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double seconds = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
    if (seconds - journal->synced < 1.0)
        return 0;
    journal->synced = seconds;
    return fsync(journal->fd) != 0 && errno != EINVAL ? -1 : 0;
}

static int keep(void *self, int64_t task, int rank, const void *result, struct message *message)
{
    struct task_journal *journal = self;
    const struct mark mark = {task, rank};
    const size_t size = record_size(journal), body = size - sizeof(uint64_t);
    memcpy(journal->record, &mark, sizeof mark);
    memcpy(journal->record + sizeof mark, result, (size_t)journal->bytes);
    const uint64_t digest = digest_add(DIGEST_START, journal->record, body);
    memcpy(journal->record + body, &digest, sizeof digest);
    const int64_t place = journal->end;
    if (append(journal, journal->record, size) != 0)
        return fail(journal, message);
    journal->kept += journal->place[task] == 0;
    journal->place[task] = place;
    return sync_now_and_then(journal) != 0 ? fail(journal, message) : 0;
}

struct store task_journal_store(struct task_journal *journal)
{
    const struct store store = {journal, recall, keep};
    return store;
}

/* ---- the end ----------------------------------------------------------------------------------------------------- */

void task_journal_close(struct task_journal *journal)
{
    if (journal->fd >= 0) {
        if (journal->kept == 0)
            unlink(journal->path); /* before the lock goes with the file */
        close(journal->fd);
    }
    free(journal->place);
    free(journal->record);
    memset(journal, 0, sizeof *journal);
    journal->fd = -1;
}

void task_journal_remove(struct task_journal *journal)
{
    journal->kept = 0;
    task_journal_close(journal);
}
