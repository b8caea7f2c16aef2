/* SPDX-License-Identifier: BSD-3-Clause
 * What a program says on standard output. */
#ifndef VTI_OUTPUT_H
#define VTI_OUTPUT_H

#include "message.h"

/** At the end of a program: whether all that it said has got there. Returns 0, or -1 with one line in *message. */
int output_end(struct message *message);

#endif
