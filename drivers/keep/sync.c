/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "sync.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

int sync_end(FILE *file, int (*end)(FILE *file))
{
    const int before = ferror(file);
    errno = ENOSPC; /* the reason of an earlier failure is not kept, and this is the likely one */
    return end(file) != 0 || before ? -1 : 0;
}

int sync_file(FILE *file)
{
    return fflush(file) != 0 || fsync(fileno(file)) != 0 ? -1 : 0;
}

int sync_path(const char *path)
{
    const int fd = open(path, O_RDONLY);
    if (fd < 0)
        return -1;
    /* some file systems cannot sync a folder and need not */
    const int failed = fsync(fd) != 0 && errno != EINVAL;
    return close(fd) != 0 || failed ? -1 : 0;
}
