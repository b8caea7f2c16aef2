/* SPDX-License-Identifier: BSD-3-Clause
 * Lists of steps h as given to --h: one number, a comma list, or a ladder from:to by factors of two. */
#ifndef VTI_LADDER_H
#define VTI_LADDER_H

#include <stdint.h>

#include "message.h"

enum { LADDER_MOST = 64 };

/** Reads the list into h[LADDER_MOST], by falling h; returns how many, or -1 with one line in *message.
 *  Numbers are positive and written as number_read takes them; none may appear twice. */
int64_t ladder_read(const char *text, double h[LADDER_MOST], struct message *message);

#endif
