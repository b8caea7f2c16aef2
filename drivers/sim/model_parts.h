/* SPDX-License-Identifier: BSD-3-Clause
 * The steps in which model_create makes a model. All return 0, or -1 with one line in *message. */
#ifndef VTI_MODEL_PARTS_H
#define VTI_MODEL_PARTS_H

#include "model.h"
#include "table.h"

/** Reads the tables that the scene names, as far as they are CSV; what is read is in *own and to be destroyed. */
int model_read_tables(const struct scene *scene, struct tables *own, struct message *message);
/** What the scene leaves to its tables: that columns and keys go together, and that together they give what bodies and
 *  effects need. Finds out whether bodies translate and turn. */
int model_check_tables(struct model *model, const struct tables *tables, struct message *message);

/** Whether the scene's effects push and turn bodies. */
struct loads {
    int force, moment;
};
struct loads model_loads(const struct scene *scene, const struct tables *tables);

/** Allocates and fills the views, the masses, inertias and diameters. */
int model_place_bodies(struct model *model, const struct tables *tables, struct message *message);
/** Makes what the effects act with, and the effects. */
int model_add_effects(struct model *model, const struct tables *tables, struct message *message);

/** A term of the binder exists if the scene gives its stiffness or the table of bonds has it as a column k (BOND_MOMENT and
 *  so on). */
int model_has_term(const struct scene *scene, const struct tables *tables, int k);

#endif
