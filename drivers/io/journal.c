/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "journal.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "digest.h"
#include "file_lock.h"
#include "sync.h"

#define TAKEN "%s: another vti-run is writing there; wait for it or choose another place with -o"

static const char *const names[] = {"checkpoint", "checkpoint.part", "rows", "frames"};

static int fail(const struct journal *journal, const char *name, struct message *message)
{
    return message_set(message, "%s/%s: %s; %s", journal->folder, name, strerror(errno), folder_remedy(errno));
}

int journal_name(struct journal *journal, const char *stem, struct message *message)
{
    memset(journal, 0, sizeof *journal);
    const int length = snprintf(journal->folder, sizeof journal->folder, "%s.run", stem);
    if (length < 0 || length >= (int)sizeof journal->folder - 32) /* room for the names in it */
        return message_set(message, "-o: the path is longer than %d bytes; use a shorter one", FOLDER_PATH - 32);
    return 0;
}

/** Whether there is a file of another name than those of a journal; -1 with errno. */
static int holds_others(const char *folder)
{
    DIR *list = opendir(folder);
    int others = 0;
    if (list == NULL)
        return -1;
    for (const struct dirent *entry; others == 0 && (entry = readdir(list)) != NULL;) {
        others = strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
        for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k)
            others = others && strcmp(entry->d_name, names[k]) != 0;
    }
    closedir(list);
    return others;
}

int journal_look(const struct journal *journal, struct message *message)
{
    struct stat info;
    char rows[FOLDER_PATH], checkpoint[FOLDER_PATH];
    if (lstat(journal->folder, &info) != 0)
        return JOURNAL_NONE;
    if (folder_path(journal->folder, "rows", 0, rows, message) != 0 ||
        folder_path(journal->folder, "checkpoint", 0, checkpoint, message) != 0)
        return -1;
    if (holds_others(journal->folder) != 0)
        return message_set(message, "%s: is there already and is none of vti-run's; choose another place with -o",
                           journal->folder);
    if (file_lock_taken(rows))
        return message_set(message, TAKEN, journal->folder);
    return lstat(checkpoint, &info) == 0 ? JOURNAL_RUN : JOURNAL_EARLY;
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

/** Locked until it is closed or the program ends, however it ends. */
static int lock(struct journal *journal, int fd, const char *name, struct message *message)
{
    const int locked = file_lock(fd);
    if (locked == FILE_LOCK_TAKEN)
        return message_set(message, TAKEN, journal->folder);
    if (locked != 0)
        return message_set(message, "%s/%s: cannot be locked: %s; choose another place with -o", journal->folder, name,
                           strerror(errno));
    journal->locked = 1;
    return 0;
}

struct journal_mark journal_mark_start(int64_t doubles)
{
    const struct journal_mark mark = {doubles, 0, DIGEST_START};
    return mark;
}

static int unreadable(const struct journal *journal, const struct journal_file *file, struct message *message)
{
    return message_set(message, "%s/%s: cannot be read: %s; delete %s and start the run anew", journal->folder,
                       file->name, feof(file->stream) ? "it is too short" : strerror(errno), journal->folder);
}

static int64_t bytes_of(const struct journal_file *file)
{
    return 8 * file->mark.doubles * file->mark.count;
}

static int check_size(const struct journal *journal, const struct journal_file *file, struct message *message)
{
    struct stat info;
    if (fstat(fileno(file->stream), &info) != 0)
        return fail(journal, file->name, message);
    if (info.st_size >= bytes_of(file))
        return 0;
    return message_set(
        message, "%s/%s: has %lld bytes where its checkpoint counts %lld; delete %s and start the run anew",
        journal->folder, file->name, (long long)info.st_size, (long long)bytes_of(file), journal->folder);
}

static int check_digest(const struct journal *journal, const struct journal_file *file, struct message *message)
{
    enum { PIECE = 4096 };
    double piece[PIECE];
    uint64_t digest = DIGEST_START;
    for (int64_t left = bytes_of(file) / 8; left > 0;) {
        const size_t n = (size_t)(left < PIECE ? left : PIECE);
        if (fread(piece, 8, n, file->stream) != n)
            return unreadable(journal, file, message);
        digest = digest_add(digest, piece, 8 * n);
        left -= (int64_t)n;
    }
    if (digest == file->mark.digest)
        return 0;
    return message_set(
        message, "%s/%s: is damaged: its records are not those of its checkpoint; delete %s and start the run anew",
        journal->folder, file->name, journal->folder);
}

/** Cuts the file to its records and moves to the end. */
static int cut(const struct journal *journal, const struct journal_file *file, struct message *message)
{
    if (ftruncate(fileno(file->stream), bytes_of(file)) != 0 || fseeko(file->stream, 0, SEEK_END) != 0)
        return fail(journal, file->name, message);
    return 0;
}

static int open_file(struct journal *journal, struct journal_file *file, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_path(journal->folder, file->name, 0, path, message) != 0)
        return -1;
    const int fd = open(path, O_RDWR | O_CREAT | O_NOFOLLOW, 0666);
    if (fd < 0)
        return fail(journal, file->name, message);
    file->stream = fdopen(fd, "r+b");
    if (file->stream == NULL) {
        close(fd);
        return fail(journal, file->name, message);
    }
    if (lock(journal, fd, file->name, message) != 0 || check_size(journal, file, message) != 0 ||
        check_digest(journal, file, message) != 0)
        return -1;
    return cut(journal, file, message);
}

int journal_open(struct journal *journal, struct journal_mark rows, struct journal_mark frames, struct message *message)
{
    const struct journal_file of_rows = {NULL, "rows", rows}, of_frames = {NULL, "frames", frames};
    journal->rows = of_rows;
    journal->frames = of_frames;
    if (mkdir(journal->folder, 0777) != 0 && errno != EEXIST)
        return message_set(message, "%s: the folder cannot be made: %s; choose another place with -o", journal->folder,
                           strerror(errno));
    return open_file(journal, &journal->rows, message) != 0 || open_file(journal, &journal->frames, message) != 0 ? -1
                                                                                                                  : 0;
}

/* ---- records ----------------------------------------------------------------------------------------------------- */

int journal_add(struct journal *journal, struct journal_file *file, const double *record, struct message *message)
{
    struct journal_mark *mark = &file->mark;
    const size_t n = (size_t)mark->doubles;
    if (fwrite(record, 8, n, file->stream) != n)
        return fail(journal, file->name, message);
    mark->digest = digest_add(mark->digest, record, 8 * n);
    ++mark->count;
    return 0;
}

int journal_sync(struct journal *journal, struct message *message)
{
    if (sync_file(journal->rows.stream) != 0)
        return fail(journal, journal->rows.name, message);
    if (sync_file(journal->frames.stream) != 0)
        return fail(journal, journal->frames.name, message);
    return 0;
}

int journal_read(const struct journal *journal, const struct journal_file *file, int64_t first, int64_t count,
                 double *records, struct message *message)
{
    const size_t wanted = (size_t)(count * file->mark.doubles);
    if (fseeko(file->stream, (off_t)(8 * file->mark.doubles * first), SEEK_SET) == 0 &&
        fread(records, 8, wanted, file->stream) == wanted)
        return 0;
    return unreadable(journal, file, message);
}

/* ---- the end ----------------------------------------------------------------------------------------------------- */

void journal_close(struct journal *journal)
{
    struct journal_file *const files[] = {&journal->rows, &journal->frames};
    for (int k = 0; k < 2; ++k) {
        if (files[k]->stream != NULL)
            fclose(files[k]->stream);
        files[k]->stream = NULL;
    }
}

void journal_remove(struct journal *journal)
{
    char path[FOLDER_PATH];
    struct message ignored = {""};
    journal_close(journal);
    for (size_t k = 0; journal->locked && k < sizeof names / sizeof names[0]; ++k)
        if (folder_path(journal->folder, names[k], 0, path, &ignored) == 0)
            unlink(path);
    rmdir(journal->folder);
}
