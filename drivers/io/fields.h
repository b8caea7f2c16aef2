/* SPDX-License-Identifier: BSD-3-Clause
 * What a run writes of its bodies if asked for: --fields. */
#ifndef VTI_FIELDS_H
#define VTI_FIELDS_H

#include "model.h"

/** Sets of them are sums. */
enum { FIELD_FORCE = 1, FIELD_MOMENT = 2 };

/** "force,moment", each once or more. Returns 0, or -1 with one line in *message. */
int fields_read(const char *text, int *fields, struct message *message);
/** Whether the model has them all: a force if an effect gives one, a moment alike. Returns 0, or -1 with one line in *message. */
int fields_check(int fields, const struct model *model, struct message *message);

#endif
