/* SPDX-License-Identifier: BSD-3-Clause
 * What tells one run from another. */
#ifndef VTI_RUN_IDENTITY_H
#define VTI_RUN_IDENTITY_H

#include "checkpoint.h"
#include "model.h"

/** The identity of a run of the scene file at path with these overrides, whose model is at t = 0. Overrides of t_end
 *  do not count. Returns 0, or -1 with one line in *message. */
int run_identity(const char *path, const char *const *overrides, int n, const struct model *model,
                 struct identity *identity, struct message *message);

#endif
