/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "left.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder.h"

/** The first bytes of a regular file that is open, as many as there are, then zeros. Returns 1 if they can be read. */
static int read_start(int fd, unsigned char *start, size_t size)
{
    struct stat info;
    memset(start, 0, size);
    return fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && pread(fd, start, size, 0) >= 0;
}

/** Whether a file of SQLite may begin so: as it says, or with zeros, which it writes before what they stand for, or
 *  with as much of that as was written over them before a kill. */
static int begins(const unsigned char *start, const void *as, size_t size)
{
    size_t k = 0;
    while (k < size && start[k] == ((const unsigned char *)as)[k])
        ++k;
    while (k < size && start[k] == 0)
        ++k;
    return k == size;
}

int left_is_ours(int fd)
{
    enum { ID = 68 };
    unsigned char start[ID + 4];
    if (!read_start(fd, start, sizeof start) || !begins(start, "SQLite format 3", 16))
        return 0;
    const unsigned id = (unsigned)start[ID] << 24 | (unsigned)start[ID + 1] << 16 | (unsigned)start[ID + 2] << 8 |
                        (unsigned)start[ID + 3];
    return start[0] == 0 || id == LEFT_ID;
}

/** The same of a journal of SQLite's. */
static int is_journal(int fd)
{
    static const unsigned char magic[] = {0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
    unsigned char start[sizeof magic];
    return read_start(fd, start, sizeof start) && begins(start, magic, sizeof magic);
}

/** Asks one of them about what is at path; otherwise if there is nothing, and 0 if that is a link. */
static int look_at(const char *path, int (*ask)(int fd), int otherwise)
{
    const int fd = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0)
        return errno == ENOENT ? otherwise : 0;
    const int answer = ask(fd);
    close(fd);
    return answer;
}

int left_is_there(const char *path)
{
    return look_at(path, left_is_ours, 0);
}

const char *const left_endings[LEFT_ENDINGS] = {"-journal", "-wal", "-shm"};

int left_beside(const char *path, const char *what, struct message *message)
{
    char beside[FOLDER_PATH + 16];
    struct stat info;
    for (int k = 0; k < LEFT_ENDINGS; ++k) {
        snprintf(beside, sizeof beside, "%s%s", path, left_endings[k]);
        if (k == 0 ? !look_at(beside, is_journal, 1) : lstat(beside, &info) == 0)
            return message_set(message,
                               "%.600s: is there already and belongs to no %s that was interrupted; move it away, or "
                               "choose another place with -o",
                               beside, what);
    }
    return 0;
}
