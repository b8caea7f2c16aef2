/* SPDX-License-Identifier: BSD-3-Clause */
#define _XOPEN_SOURCE 700 /* S_ISVTX */
#include "overwrite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder.h"
#include "held.h"
#include "left.h"

/* ---- marks ------------------------------------------------------------------------------------------------------- */

static int is_text(const char *path, const struct mark *mark)
{
    char start[4096];
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return 0;
    const size_t size = fread(start, 1, sizeof start - 1, file);
    fclose(file);
    start[size] = '\0';
    for (const char *const *lack = mark->lacks; lack != NULL && *lack != NULL; ++lack)
        if (strstr(start, *lack) != NULL)
            return 0;
    return strncmp(start, mark->begins, strlen(mark->begins)) == 0 &&
           (mark->holds == NULL || strstr(start, mark->holds) != NULL);
}

/** Whether the regular file at path may be a file of ours that was half written when its program was killed. HDF5
 *  writes the first bytes last, and so may the system. */
static int is_half(const char *path, const struct mark *mark)
{
    static const char zeros[8];
    char start[64] = "";
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return 0;
    const size_t size = fread(start, 1, sizeof start, file);
    fclose(file);
    if (memcmp(start, zeros, sizeof zeros) == 0)
        return 1;
    if (mark->begins == NULL)
        return held_begins(path);
    return strncmp(start, mark->begins, size < strlen(mark->begins) ? size : strlen(mark->begins)) == 0;
}

int overwrite_is_ours(const char *path, const struct mark *mark)
{
    struct stat info;
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode))
        return 0;
    return info.st_size == 0 ||
           (mark->begins == NULL ? held_has(path, mark->holds != NULL ? mark->holds : "vti_version")
                                 : is_text(path, mark));
}

int overwrite_is_protected(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && (info.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
}

/* ---- which file is which ----------------------------------------------------------------------------------------- */

static int is_same(const char *a, const char *b)
{
    struct stat of_a, of_b;
    if (strcmp(a, b) == 0)
        return 1;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
}

/** The file itself, and the one beside it that it is written as. */
static int check_inputs(const char *folder, const char *name, const struct input *inputs, int count,
                        struct message *message)
{
    char path[FOLDER_PATH];
    for (int part = 0; part < 2; ++part) {
        if (folder_output(folder, name, part, path, message) != 0)
            return -1;
        for (int k = 0; k < count; ++k)
            if (inputs[k].path[0] != '\0' && is_same(path, inputs[k].path))
                return message_set(message,
                                   "%.300s/%s: would replace %.300s, which is %s; choose another place with -o", folder,
                                   name, inputs[k].path, inputs[k].what);
    }
    return 0;
}

/** Where the program keeps what it has done, and the files that SQLite makes beside it. */
static int check_kept(const char *folder, const char *name, const struct input *inputs, int count,
                      struct message *message)
{
    char path[FOLDER_PATH + 16];
    if (folder_path(folder, name, 0, path, message) != 0)
        return -1;
    char *const end = path + strlen(path);
    for (int k = -1; k < LEFT_ENDINGS; ++k) {
        const char *const ending = k < 0 ? "" : left_endings[k];
        memcpy(end, ending, strlen(ending) + 1);
        for (int n = 0; n < count; ++n)
            if (inputs[n].path[0] != '\0' && is_same(path, inputs[n].path))
                return message_set(message,
                                   "%.300s: what is done so far would be kept there, in the place of %.300s, which is "
                                   "%s; choose another place with -o",
                                   path, inputs[n].path, inputs[n].what);
    }
    return 0;
}

static int check_others(const char *folder, const struct output *outputs, int k, struct message *message)
{
    char mine[FOLDER_PATH], other[FOLDER_PATH];
    if (folder_output(folder, outputs[k].name, 0, mine, message) != 0)
        return -1;
    for (int j = 0; j < k; ++j) {
        if (folder_output(folder, outputs[j].name, 0, other, message) != 0)
            return -1;
        if (is_same(mine, other))
            return message_set(message, "%.300s/%s: is the same file as %s; remove that link", folder, outputs[k].name,
                               outputs[j].name);
    }
    return 0;
}

/** Whether a file can be made where the link leads that the output is, if it is one. */
static int check_link(const char *folder, const char *name, const char *target, struct message *message)
{
    char own[FOLDER_PATH], place[FOLDER_PATH];
    struct stat info;
    if (folder_path(folder, name, 0, own, message) != 0)
        return -1;
    if (lstat(own, &info) != 0 || !S_ISLNK(info.st_mode))
        return 0;
    folder_of(target, place);
    return faccessat(AT_FDCWD, place, W_OK | X_OK, AT_EACCESS) == 0
               ? 0
               : message_set(message, "%.300s: leads to %.600s, which cannot be written to: %s; remove that link", own,
                             place, strerror(errno));
}

/** Whether the file, which is there, may be replaced by a new one: in a folder like /tmp only by its owner, or the
 *  folder's. */
static int check_owner(const char *path, const struct stat *file, struct message *message)
{
    char place[FOLDER_PATH];
    struct stat info;
    const uid_t me = geteuid();
    folder_of(path, place);
    if (me == 0 || file->st_uid == me || stat(place, &info) != 0 || (info.st_mode & S_ISVTX) == 0 || info.st_uid == me)
        return 0;
    return message_set(message,
                       "%.600s: is there already and is another user's, whom the folder lets replace it alone; choose "
                       "another place with -o",
                       path);
}

/** Whether the file, which is there, may be replaced without --force. */
static int check_ours(const char *path, const struct mark *mark, struct message *message)
{
    if (faccessat(AT_FDCWD, path, R_OK, AT_EACCESS) != 0)
        return message_set(message,
                           "%.600s: is there already and cannot be looked at: %s; choose another place with -o, or "
                           "replace it with --force",
                           path, strerror(errno));
    if (!overwrite_is_ours(path, mark)) {
        if (mark->begins == NULL && held_is(path))
            return message_set(message,
                               "%.600s: is there already and " HELD_TEXT
                               ", choose another place with -o, or replace it with --force",
                               path);
        return message_set(message,
                           "%.600s: is there already and is no result of vti; choose another place with -o, or replace "
                           "it with --force",
                           path);
    }
    if (overwrite_is_protected(path))
        return message_set(message,
                           "%.600s: is there already and is write-protected; choose another place with -o, or replace "
                           "it with --force",
                           path);
    return 0;
}

static int check_there(const char *folder, const struct output *o, int force, struct message *message)
{
    char path[FOLDER_PATH];
    struct stat info;
    if (folder_output(folder, o->name, 0, path, message) != 0 || check_link(folder, o->name, path, message) != 0)
        return -1;
    if (stat(path, &info) != 0)
        return errno == ENOENT ? 0
                               : message_set(message, "%.600s: cannot be looked at: %s; choose another place with -o",
                                             path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return message_set(message, "%.600s: is there already and is no file; choose another place with -o", path);
    if (!force && check_ours(path, &o->mark, message) != 0)
        return -1;
    return check_owner(path, &info, message);
}

/** The name under which it is written at first. */
static int check_part(const char *folder, const struct output *o, int left, int force, struct message *message)
{
    char path[FOLDER_PATH];
    struct stat info;
    if (folder_output(folder, o->name, 1, path, message) != 0)
        return -1;
    if (lstat(path, &info) != 0)
        return errno == ENOENT ? 0
                               : message_set(message, "%.600s: cannot be looked at: %s; choose another place with -o",
                                             path, strerror(errno));
    if (!S_ISREG(info.st_mode) && !S_ISLNK(info.st_mode))
        return message_set(
            message,
            "%.600s: is there already and is no file; %.200s is written under that name at first: choose "
            "another place with -o",
            path, o->name);
    if (force || (S_ISREG(info.st_mode) && (info.st_size == 0 || (left && is_half(path, &o->mark)))))
        return 0;
    return message_set(message,
                       "%.500s: is there already and belongs to nothing that was interrupted; %.200s is written under "
                       "that name at first: move it away, replace it with --force, or choose another place with -o",
                       path, o->name);
}

int overwrite_inputs(const char *path, const struct scene *scene, struct input *list)
{
    const struct input file = {path, "the scene"};
    int n = 0;
    list[n++] = file;
    for (int k = 0; k < TABLES; ++k)
        if (tables_path(scene, k)[0] != '\0') {
            const struct input table = {tables_path(scene, k), tables_kind(k)->file};
            list[n++] = table;
        }
    return n;
}

int overwrite_check(const struct overwrite *o, struct message *message)
{
    const char *const folder = o->folder;
    if (check_kept(folder, o->kept.name, o->inputs, o->inputs_count, message) != 0)
        return -1;
    for (int k = 0; k < o->outputs_count; ++k)
        if (check_inputs(folder, o->outputs[k].name, o->inputs, o->inputs_count, message) != 0 ||
            check_others(folder, o->outputs, k, message) != 0 ||
            check_there(folder, &o->outputs[k], o->force, message) != 0 ||
            check_part(folder, &o->outputs[k], o->kept.left, o->force, message) != 0)
            return -1;
    return 0;
}
