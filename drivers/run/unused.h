/* SPDX-License-Identifier: BSD-3-Clause
 * What a scene or its tables say to no effect. */
#ifndef VTI_UNUSED_H
#define VTI_UNUSED_H

#include "model.h"
#include "table.h"

enum { RUN_UNUSED = 8 };

/** A line for each key of bodies, and for columns of their table, that the model does not go by: an inertia where
 *  nothing turns, a mass where nothing translates and no inertia follows from it, materials that give no stiffness.
 *  Returns how many. */
int run_unused(const struct model *model, const struct tables *tables, struct message lines[RUN_UNUSED]);

#endif
