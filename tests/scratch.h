/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where tests put files: a folder of their own, in TMPDIR or, where that is not set, in memory if there is such a
 * place; a disk would take longer than what is tested. No test library: fuzz targets have none. */
#ifndef VTI_TESTS_SCRATCH_H
#define VTI_TESTS_SCRATCH_H

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/** Makes a new folder and puts its path into path. Returns whether it could. Needs POSIX 2008 of the includer. */
static inline int scratch_make(char *path, size_t size)
{
    const char *set = getenv("TMPDIR");
    const char *in = set != NULL && set[0] != '\0' ? set : access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    const int length = snprintf(path, size, "%s/vti-XXXXXX", in);
    return length > 0 && (size_t)length < size && mkdtemp(path) != NULL;
}

#endif
