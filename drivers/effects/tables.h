/* SPDX-License-Identifier: BSD-3-Clause
 * The tables of a scene: that of its bodies, and those that its effects have. */
#ifndef VTI_TABLES_H
#define VTI_TABLES_H

#include "kinds.h"
#include "table.h"

struct scene;

/** The tables that a scene names; a table that it does not name has no rows and no columns. */
struct tables {
    struct table bodies, effect[EFFECT_COUNT];
    const int64_t *number; /* [bodies] as people know them (renumber.h); NULL: by their rows */
};

/** Table k of the scene, k < TABLES: that of the bodies, then those of the effects. Its path is "" if the scene names
 *  none. */
enum { TABLES = 1 + EFFECT_COUNT };
const char *tables_path(const struct scene *scene, int k);
/** What it is of; NULL for an effect that has no table. */
const struct table_kind *tables_kind(int k);

/** Reads all tables of the scene. Returns 0, or -1 with one line in *message; tables_destroy must follow in either
 *  case. */
int tables_read_by(table_reader *read, const struct scene *scene, struct tables *tables, struct message *message);
void tables_destroy(struct tables *tables);
/** Of what table k holds, wherever it lies (digest.h). */
uint64_t tables_digest(const struct tables *tables, int k);

#endif
