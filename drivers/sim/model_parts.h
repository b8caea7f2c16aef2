/* SPDX-License-Identifier: BSD-3-Clause
 * The parts of a model, in files of their own. Those that take a message return 0, or -1 with one line in it. */
#ifndef VTI_MODEL_PARTS_H
#define VTI_MODEL_PARTS_H

#include "model.h"
#include "tables.h"

/** Reads a table that the scene names, which must be CSV. */
table_reader model_read_table;
/** What the scene leaves to its tables: that columns and keys go together, and that together they give what bodies and
 *  effects need. Finds out whether bodies translate and turn. */
int model_check_tables(struct model *model, const struct tables *tables, struct message *message);

/** What the scene's effects give bodies: bits of effect_gift. */
int model_loads(const struct scene *scene, const struct tables *tables);

/** Allocates and fills the views, the masses, inertias and diameters. */
int model_place_bodies(struct model *model, const struct tables *tables, struct message *message);

/** Whether steps can divide by the masses of bodies that translate and by the inertias of those that turn; mass is
 *  known of each, or p = NULL, and then it is that of the model. */
int model_check_masses(const struct model *model, const struct tables *tables, const vti_scalars *mass,
                       struct message *message);

/** How many bodies, or spheres of clumps, an effect acts on. */
int64_t model_acted_on(const struct model *model, const struct effect *e);

#endif
