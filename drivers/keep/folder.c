/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "folder.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "stream.h"

int folder_path(const char *folder, const char *name, int part, char path[FOLDER_PATH], struct message *message)
{
    const int length = snprintf(path, FOLDER_PATH, "%s/%s%s", folder, name, part ? ".part" : "");
    if (length < 0 || length >= FOLDER_PATH)
        return message_set(message, "%.200s...: the path is too long; use a shorter one with -o", folder);
    return 0;
}

/** Takes one link at path: 1 if there is none, else 0 and path is where it leads; -1 with errno. */
static int follow(char path[FOLDER_PATH])
{
    char to[FOLDER_PATH];
    const ssize_t length = readlink(path, to, sizeof to - 1);
    if (length < 0)
        return 1;
    to[length] = '\0';
    const size_t before = to[0] == '/' ? 0 : (size_t)(strrchr(path, '/') + 1 - path);
    if (before + (size_t)length >= FOLDER_PATH) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(path + before, to, (size_t)length + 1);
    return 0;
}

void folder_of(const char *path, char folder[FOLDER_PATH])
{
    memcpy(folder, path, strlen(path) + 1);
    char *slash = strrchr(folder, '/');
    slash[slash == folder] = '\0';
}

int folder_output(const char *folder, const char *name, int part, char path[FOLDER_PATH], struct message *message)
{
    enum { LINKS = 40 };
    static const char ending[] = ".part";
    int end = 0;
    if (folder_path(folder, name, 0, path, message) != 0)
        return -1;
    for (int links = 0; end == 0 && links < LINKS; ++links)
        end = follow(path);
    if (end <= 0 || strlen(path) + sizeof ending > FOLDER_PATH)
        return message_set(message, "%.300s/%s: leads through too many or too long links; remove that link", folder,
                           name);
    if (part)
        memcpy(path + strlen(path), ending, sizeof ending);
    return 0;
}

/** mkdir -p */
static int make(const char *folder)
{
    char path[FOLDER_PATH];
    const size_t length = strlen(folder);
    if (length >= sizeof path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    for (size_t i = 1; i <= length; ++i) {
        if (folder[i] != '/' && folder[i] != '\0')
            continue;
        memcpy(path, folder, i);
        path[i] = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST)
            return -1;
    }
    return 0;
}

int folder_create(const char *folder, struct message *message)
{
    if (make(folder) != 0)
        return message_set(message, "%s: the folder cannot be made: %s; choose another with -o", folder,
                           strerror(errno));
    if (faccessat(AT_FDCWD, folder, W_OK | X_OK, AT_EACCESS) != 0)
        return message_set(message, "%s: the folder cannot be written to: %s; choose another with -o", folder,
                           strerror(errno));
    return 0;
}

double folder_space(const char *folder)
{
    struct statvfs info;
    return statvfs(folder, &info) == 0 ? (double)info.f_bavail * (double)info.f_frsize : HUGE_VAL;
}

/* ---- one file ---------------------------------------------------------------------------------------------------- */

const char *folder_remedy(int error)
{
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        return "make space there and go on with --resume, or choose another place with -o";
    if (error == ENOENT || error == ENOTDIR || error == ESTALE)
        return "its folder has vanished; start anew, or elsewhere with -o";
    if (error == EACCES || error == EPERM || error == EROFS)
        return "allow writing there and go on with --resume, or choose another place with -o";
    return "go on with --resume when that is mended, or choose another place with -o";
}

static int fail(const char *path, struct message *message)
{
    return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
}

/** Opens a new file for writing, in the place of one that a killed program has left; never through a link. NULL with
 *  errno. */
static FILE *folder_new(const char *path)
{
    const int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW;
    int fd = open(path, flags, 0666);
    if (fd < 0 && errno == EEXIST && unlink(path) == 0)
        fd = open(path, flags, 0666);
    FILE *file = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (fd >= 0 && file == NULL)
        close(fd);
    return file;
}

FILE *folder_open(const char *folder, const char *name, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_output(folder, name, 1, path, message) != 0)
        return NULL;
    FILE *file = folder_new(path);
    if (file == NULL)
        fail(path, message);
    return file;
}

int folder_close(FILE *file, const char *folder, const char *name, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_output(folder, name, 1, path, message) != 0)
        return -1; /* it has been opened under this name */
    return stream_end(file, fclose) != 0 ? fail(path, message) : 0;
}

int folder_write(const char *folder, const char *name, folder_writer *write, const void *what, struct message *message)
{
    FILE *file = folder_open(folder, name, message);
    if (file == NULL)
        return -1;
    write(what, file);
    return folder_close(file, folder, name, message);
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

/** To the disk, the file or folder at path: its content, or which files are in it. A folder that one may write to and
 *  not read cannot be opened for that; its files have got there. */
static int sync_path(const char *path, int is_folder)
{
    const int fd = open(path, O_RDONLY);
    if (fd < 0)
        return is_folder && errno == EACCES ? 0 : -1;
    /* some file systems cannot sync a folder and need not */
    const int failed = fsync(fd) != 0 && errno != EINVAL;
    return close(fd) != 0 || failed ? -1 : 0;
}

static int sync_part(const char *folder, const char *name, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_output(folder, name, 1, path, message) != 0)
        return -1;
    return sync_path(path, 0) != 0 ? fail(path, message) : 0;
}

/** folder/name.part gets its real name. */
static int keep(const char *folder, const char *name, struct message *message)
{
    char from[FOLDER_PATH], to[FOLDER_PATH], place[FOLDER_PATH];
    if (folder_output(folder, name, 1, from, message) != 0 || folder_output(folder, name, 0, to, message) != 0)
        return -1;
    if (rename(from, to) != 0)
        return fail(to, message);
    folder_of(to, place);
    return strcmp(place, folder) != 0 && sync_path(place, 1) != 0 ? fail(place, message) : 0; /* that of a link */
}

static void drop(const char *folder, const char *name)
{
    char path[FOLDER_PATH];
    struct message ignored = {""};
    if (folder_output(folder, name, 1, path, &ignored) == 0)
        unlink(path);
}

int folder_finish(const char *folder, const char *const *names, int count, int failed, struct message *message)
{
    for (int k = 0; failed == 0 && k < count; ++k)
        failed = sync_part(folder, names[k], message);
    for (int k = 0; failed == 0 && k < count; ++k)
        failed = keep(folder, names[k], message);
    for (int k = 0; failed != 0 && k < count; ++k)
        drop(folder, names[k]);
    return failed == 0 && sync_path(folder, 1) != 0 ? fail(folder, message) : failed;
}
