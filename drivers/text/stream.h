/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef VTI_STREAM_H
#define VTI_STREAM_H

#include <errno.h>
#include <stdio.h>

/** Whether all that was ever written to the stream has been taken, now that it is ended by fclose or fflush: 0, or -1
 *  with errno. */
static inline int stream_end(FILE *file, int (*end)(FILE *file))
{
    const int before = ferror(file);
    errno = ENOSPC; /* the reason of an earlier failure is not kept, and this is the likely one */
    return end(file) != 0 || before ? -1 : 0;
}

#endif
