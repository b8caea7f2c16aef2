/* SPDX-License-Identifier: BSD-3-Clause
 * Files that have reached the disk. Each returns 0, or -1 with errno. */
#ifndef VTI_SYNC_H
#define VTI_SYNC_H

#include <stdio.h>

/** What has been written to the file. */
int sync_file(FILE *file);
/** The file or folder at path: its content, or which files are in it. */
int sync_path(const char *path);

#endif
