/* SPDX-License-Identifier: BSD-3-Clause
 * What a scene or its tables say to no effect. */
#ifndef VTI_UNUSED_H
#define VTI_UNUSED_H

#include <stdio.h>

#include "model.h"
#include "tables.h"

/** A line for each key of bodies, and for columns of their table, that the model does not go by: an inertia where
 *  nothing turns, a mass where nothing translates and no inertia follows from it, materials that give no stiffness. */
void unused_say(const struct model *model, const struct tables *tables, FILE *file);

#endif
