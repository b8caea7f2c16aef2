/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "file_lock.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct flock whole(void)
{
    struct flock lock;
    memset(&lock, 0, sizeof lock);
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

int file_lock(int fd)
{
    struct flock lock = whole();
    if (fcntl(fd, F_SETLK, &lock) == 0 || errno == ENOLCK || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP)
        return 0;
    return errno == EACCES || errno == EAGAIN ? FILE_LOCK_TAKEN : -1;
}

/** Whether path still is the open file: another process may have removed it between its being opened and locked here. */
static int is_at(int fd, const char *path)
{
    struct stat ours, there;
    return fstat(fd, &ours) == 0 && stat(path, &there) == 0 && ours.st_dev == there.st_dev &&
           ours.st_ino == there.st_ino;
}

int file_lock_open(const char *path)
{
    for (;;) {
        const int fd = open(path, O_RDWR | O_CREAT, 0666);
        const int locked = fd < 0 ? -1 : file_lock(fd);
        if (locked == 0 && is_at(fd, path))
            return fd;
        const int reason = errno;
        if (fd >= 0)
            close(fd);
        errno = reason;
        if (locked != 0)
            return locked;
    }
}

int file_lock_taken(const char *path)
{
    struct flock lock = whole();
    const int fd = open(path, O_RDWR);
    if (fd < 0)
        return 0;
    const int known = fcntl(fd, F_GETLK, &lock) == 0;
    close(fd);
    return known && lock.l_type != F_UNLCK;
}
