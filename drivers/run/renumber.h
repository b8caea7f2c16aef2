/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies of a table in another order while a run works on them: along a curve through the cells of space (Z-order), so
 * that those that are neighbours have numbers, and memory, near each other. What people see has the table's numbers. */
#ifndef VTI_RENUMBER_H
#define VTI_RENUMBER_H

#include "model.h"
#include "tables.h"

struct renumbering {
    struct tables tables; /* with the bodies in that order; tables.number is number */
    int64_t *number;      /* [bodies] of each its row in the scene's table, from 0 */
};

/** Puts the bodies of tables, those of *model, in order, and the rows of other tables, which name bodies, by the first
 *  of these. Returns 0, or -1 with one line in *message: bodies are in no table, have no places, are clumps, or bonds
 *  break or are made on the way, which would be told by other numbers. renumber_destroy follows in either case. */
int renumber(const struct model *model, const struct tables *tables, struct renumbering *r, struct message *message);
void renumber_destroy(struct renumbering *r);

/** Copies positions, velocities and attitudes of bodies in that order to bodies in the table's. */
void renumber_back(const int64_t *number, const vti_bodies *from, const vti_bodies *to);

#endif
