/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Trouble at a chosen moment, preloaded into a program (LD_PRELOAD): of the calls that change files in the folder
 * TROUBLE_IN the one whose number is TROUBLE_AT meets TROUBLE_HOW:
 *     kill   SIGKILL before it              torn   SIGKILL when half of its bytes are written
 *     term   SIGTERM before it              full   no space, from this call on
 *     nolock no locks, whatever the call    once   no space, for this call only
 * All are listed in the file TROUBLE_LOG, if that is set. */
#undef _FILE_OFFSET_BITS /* open and open64 are different names here */
#undef _FORTIFY_SOURCE
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FREES, GROWS }; /* whether a call needs space */
enum { PATH = 4096 };

static int calls;

/** The function that would have been called. */
#define REAL(NAME, RESULT, ...)                                                                                        \
    RESULT (*real)(__VA_ARGS__);                                                                                       \
    void *const found = dlsym(RTLD_NEXT, NAME);                                                                        \
    memcpy(&real, &found, sizeof real)

static int is_how(const char *word)
{
    const char *how = getenv("TROUBLE_HOW");
    return how != NULL && strcmp(how, word) == 0;
}

static void list(const char *call, const char *path)
{
    const char *log = getenv("TROUBLE_LOG");
    FILE *file = log != NULL ? fopen(log, "a") : NULL;
    if (file == NULL)
        return;
    fprintf(file, "%s %s\n", call, path);
    fclose(file);
}

/** Whether this is the call, or with no space any after it. */
static int is_now(void)
{
    const char *at = getenv("TROUBLE_AT");
    const int wanted = at != NULL ? atoi(at) : 0;
    return wanted > 0 && (calls == wanted || (is_how("full") && calls > wanted));
}

/** Before every call; 1 if it must fail. */
static int meet(const char *call, const char *path, int grows)
{
    const char *in = getenv("TROUBLE_IN");
    if (in == NULL || strncmp(path, in, strlen(in)) != 0)
        return 0;
    ++calls;
    list(call, path);
    if (!is_now())
        return 0;
    if (is_how("kill"))
        raise(SIGKILL);
    if (is_how("term"))
        raise(SIGTERM);
    errno = ENOSPC;
    return grows && (is_how("full") || is_how("once"));
}

static void path_of(int fd, char path[PATH])
{
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t length = readlink(link, path, PATH - 1);
    path[length > 0 ? length : 0] = '\0';
}

static int meet_file(const char *call, int fd)
{
    char path[PATH];
    path_of(fd, path);
    return meet(call, path, GROWS);
}

/* ---- locks ------------------------------------------------------------------------------------------------------- */

/** nolock: the file system has none. Nobody here calls it without a third argument that matters to locks. */
#define FCNTL(NAME)                                                                                                    \
    int NAME(int fd, int command, ...)                                                                                 \
    {                                                                                                                  \
        va_list rest;                                                                                                  \
        va_start(rest, command);                                                                                       \
        void *argument = va_arg(rest, void *);                                                                         \
        va_end(rest);                                                                                                  \
        REAL(#NAME, int, int, int, ...);                                                                               \
        if (is_how("nolock") && (command == F_SETLK || command == F_GETLK)) {                                          \
            errno = EOPNOTSUPP;                                                                                        \
            return -1;                                                                                                 \
        }                                                                                                              \
        return real(fd, command, argument);                                                                            \
    }
FCNTL(fcntl)
FCNTL(fcntl64)

/* ---- what is opened ---------------------------------------------------------------------------------------------- */

#define OPEN(NAME)                                                                                                     \
    int NAME(const char *path, int flags, ...)                                                                         \
    {                                                                                                                  \
        mode_t mode = 0;                                                                                               \
        if (flags & O_CREAT) {                                                                                         \
            va_list rest;                                                                                              \
            va_start(rest, flags);                                                                                     \
            mode = va_arg(rest, mode_t);                                                                               \
            va_end(rest);                                                                                              \
        }                                                                                                              \
        REAL(#NAME, int, const char *, int, ...);                                                                      \
        return flags & O_CREAT && meet("open", path, GROWS) ? -1 : real(path, flags, mode);                            \
    }
OPEN(open)
OPEN(open64)

#define FOPEN(NAME)                                                                                                    \
    FILE *NAME(const char *restrict path, const char *restrict mode)                                                   \
    {                                                                                                                  \
        REAL(#NAME, FILE *, const char *, const char *);                                                               \
        return mode[0] != 'r' && meet("fopen", path, GROWS) ? NULL : real(path, mode);                                 \
    }
FOPEN(fopen)
FOPEN(fopen64)

int mkdir(const char *path, mode_t mode)
{
    REAL("mkdir", int, const char *, mode_t);
    return meet("mkdir", path, GROWS) ? -1 : real(path, mode);
}

/* ---- what is written --------------------------------------------------------------------------------------------- */

#define PWRITE(NAME, OFFSET)                                                                                           \
    ssize_t NAME(int fd, const void *bytes, size_t size, OFFSET place)                                                 \
    {                                                                                                                  \
        REAL(#NAME, ssize_t, int, const void *, size_t, OFFSET);                                                       \
        if (meet_file("pwrite", fd))                                                                                   \
            return -1;                                                                                                 \
        if (is_now() && is_how("torn") && real(fd, bytes, size / 2, place) >= 0)                                       \
            raise(SIGKILL);                                                                                            \
        return real(fd, bytes, size, place);                                                                           \
    }
PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

int fflush(FILE *file)
{
    REAL("fflush", int, FILE *);
    return file != NULL && meet_file("fflush", fileno(file)) ? EOF : real(file);
}

/** What had not been written before is lost. */
int fclose(FILE *file)
{
    char path[PATH];
    REAL("fclose", int, FILE *);
    path_of(fileno(file), path);
    struct stat before;
    const int known = fstat(fileno(file), &before) == 0, failed = meet("fclose", path, GROWS), code = real(file);
    if (!failed)
        return code;
    errno = known && truncate(path, before.st_size) == 0 ? ENOSPC : EIO;
    return EOF;
}

#define SYNC(NAME)                                                                                                     \
    int NAME(int fd)                                                                                                   \
    {                                                                                                                  \
        REAL(#NAME, int, int);                                                                                         \
        return meet_file("fsync", fd) ? -1 : real(fd);                                                                 \
    }
SYNC(fsync)
SYNC(fdatasync)

#define FTRUNCATE(NAME, OFFSET)                                                                                        \
    int NAME(int fd, OFFSET size)                                                                                      \
    {                                                                                                                  \
        REAL(#NAME, int, int, OFFSET);                                                                                 \
        return meet_file("ftruncate", fd) ? -1 : real(fd, size);                                                       \
    }
FTRUNCATE(ftruncate, off_t)
FTRUNCATE(ftruncate64, off64_t)

/* ---- names ------------------------------------------------------------------------------------------------------- */

int rename(const char *from, const char *to)
{
    REAL("rename", int, const char *, const char *);
    return meet("rename", to, FREES) ? -1 : real(from, to);
}

int unlink(const char *path)
{
    REAL("unlink", int, const char *);
    return meet("unlink", path, FREES) ? -1 : real(path);
}

int rmdir(const char *path)
{
    REAL("rmdir", int, const char *);
    return meet("rmdir", path, FREES) ? -1 : real(path);
}
