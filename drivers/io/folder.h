/* SPDX-License-Identifier: BSD-3-Clause
 * Output folders, and files that are either whole or not there. */
#ifndef VTI_FOLDER_H
#define VTI_FOLDER_H

#include "message.h"

enum { FOLDER_PATH = 4096 };

/** Makes the folder and its parents if need be and checks that files can be made in it. Returns 0, or -1 with one line in
 *  *message. */
int folder_create(const char *folder, struct message *message);

/** path = folder/name, or folder/name.part for the file while it is written. Returns 0, or -1 with *message if too long. */
int folder_path(const char *folder, const char *name, int part, char path[FOLDER_PATH], struct message *message);

/** Gives folder/name.part, written and closed, its real name. Returns 0, or -1 with *message. */
int folder_keep(const char *folder, const char *name, struct message *message);
/** Removes folder/name.part. */
void folder_drop(const char *folder, const char *name);

#endif
