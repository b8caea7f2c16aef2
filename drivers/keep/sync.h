/* SPDX-License-Identifier: BSD-3-Clause
 * What has been written to a file: all of it, and on the disk. Each returns 0, or -1 with errno. */
#ifndef VTI_SYNC_H
#define VTI_SYNC_H

#include <stdio.h>

/** Whether all that was ever written to the stream has been taken, now that it is ended by fclose or fflush. */
int sync_end(FILE *file, int (*end)(FILE *file));
/** To the disk, what has been written to the file. */
int sync_file(FILE *file);
/** To the disk, the file or folder at path: its content, or which files are in it. */
int sync_path(const char *path);

#endif
