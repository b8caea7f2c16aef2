/* SPDX-License-Identifier: BSD-3-Clause */
#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "sync.h"

int output_end(struct message *message)
{
    if (sync_end(stdout, fflush) == 0)
        return 0;
    return message_set(message, "standard output: cannot be written: %s; send it to another place", strerror(errno));
}
