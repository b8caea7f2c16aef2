/* SPDX-License-Identifier: BSD-3-Clause */
#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

int output_end(struct message *message)
{
    errno = ENOSPC; /* the reason of an earlier failure is not kept, and this is the likely one */
    if (fflush(stdout) == 0 && !ferror(stdout))
        return 0;
    return message_set(message, "standard output: cannot be written: %s; send it to another place", strerror(errno));
}
