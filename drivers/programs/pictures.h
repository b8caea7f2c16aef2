/* SPDX-License-Identifier: BSD-3-Clause
 * Pictures, drawn by the vti-plot that stands beside the running program. */
#ifndef VTI_PICTURES_H
#define VTI_PICTURES_H

#include "message.h"

/** Runs "vti-plot folder/name" and waits for it. Returns 0, or -1 with one line in *message. */
int pictures_draw(const char *folder, const char *name, struct message *message);

#endif
