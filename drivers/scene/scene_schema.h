/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The table of scene_field.h as a schema of libcyaml. A section is loaded into an array of slots, one for each of its
 * keys, that point to such an array again (section), to char *[3] (vector), to char **[items] (list of rows) or to
 * char (all else); NULL where the file lacks the key. Numbers are left as text here, because libcyaml knows neither 1/64
 * nor 2^-6. */
#ifndef VTI_SCENE_SCHEMA_H
#define VTI_SCENE_SCHEMA_H

#include <cyaml/cyaml.h>

#include "scene_field.h"

struct scene_slot {
    void *value;
    uint64_t items; /* of a list of rows */
};

struct scene_schema {
    cyaml_schema_value_t root;
    cyaml_schema_field_t rows[2 * SCENE_FIELDS_MAX + 1]; /* a field and, for a section, the end mark of its keys */
    int used;
};

/** Fills *schema, which must stay where it is: the parts of it point to each other. */
void scene_schema_build(struct scene_schema *schema);

/** The schema of one value, and its slot in what was loaded with schema->root. With make set, sections on the way that
 *  are missing are made, else (or without memory) the answer is NULL. The path must be in the table. */
const cyaml_schema_value_t *scene_schema_value(const struct scene_schema *schema, const char *path);
struct scene_slot *scene_schema_slot(const struct scene_schema *schema, struct scene_slot *root, const char *path,
                                     int make);

/** Zeroed memory that cyaml_free can free. */
void *scene_schema_zeros(size_t bytes);

#endif
