/* SPDX-License-Identifier: BSD-3-Clause
 * Output folders, and files that are either whole or not there. */
#ifndef VTI_FOLDER_H
#define VTI_FOLDER_H

#include <stdio.h>

#include "message.h"

enum { FOLDER_PATH = 4096 };

/** Makes the folder and its parents if need be and checks that files can be made in it. Returns 0, or -1 with one line
 *  in *message. */
int folder_create(const char *folder, struct message *message);

/** Bytes that one who is not root may write there; infinite if nobody says. */
double folder_space(const char *folder);

/** path = folder/name, or folder/name.part for the file while it is written. Returns 0, or -1 with *message if too
 *  long. */
int folder_path(const char *folder, const char *name, int part, char path[FOLDER_PATH], struct message *message);

/** The same for a file that is put out: links are followed, so that a link stays and what it leads to is written. */
int folder_output(const char *folder, const char *name, int part, char path[FOLDER_PATH], struct message *message);

/** folder = that of the file at path, as folder_path and folder_output give it. */
void folder_of(const char *path, char folder[FOLDER_PATH]);

/** What to do about an error with a file that is written while a run or a study goes. */
const char *folder_remedy(int error);

/** Opens folder/name.part for writing; NULL with *message if that cannot be. */
FILE *folder_open(const char *folder, const char *name, struct message *message);
/** Closes it. Returns 0, or -1 with *message if not all that was written to it has got there. */
int folder_close(FILE *file, const char *folder, const char *name, struct message *message);

/** What writes a file of something, *what. */
typedef void folder_writer(const void *what, FILE *file);
/** All three: opens folder/name.part, writes, closes. Returns 0, or -1 with *message. */
int folder_write(const char *folder, const char *name, folder_writer *write, const void *what, struct message *message);

/** The end of files that belong together. If failed is 0, brings every folder/name.part, written and closed, to the
 *  disk and then gives all of them their real names; otherwise, and if that fails, removes them. Returns 0, or -1 with
 *  *message, which is as it was if failed is not 0. */
int folder_finish(const char *folder, const char *const *names, int count, int failed, struct message *message);

#endif
