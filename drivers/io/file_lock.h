/* SPDX-License-Identifier: BSD-3-Clause
 * Files that one program at a time may write. */
#ifndef VTI_FILE_LOCK_H
#define VTI_FILE_LOCK_H

enum { FILE_LOCK_TAKEN = -2 };

/** Locks the open file for this process until it closes it or ends, however it ends: the kernel lets go, so there are no stale
 *  locks. Returns 0, FILE_LOCK_TAKEN, or -1 with errno. Where the file system has no locks it does nothing. */
int file_lock(int fd);

/** Opens the file for reading and writing, makes it if need be, and locks it. Returns its descriptor, FILE_LOCK_TAKEN if
 *  another process holds it, or -1 with errno. */
int file_lock_open(const char *path);

/** Whether another process holds the file: 1 or 0. Not for a process that has locked it, whose lock this would undo. */
int file_lock_taken(const char *path);

#endif
