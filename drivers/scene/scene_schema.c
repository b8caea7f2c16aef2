/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_schema.h"

#include <string.h>

enum {
    OPTIONAL = CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL
}; /* what must be there is checked after --set, by scene.c */

static const cyaml_schema_value_t text = {CYAML_VALUE_STRING(OPTIONAL, char, 0, CYAML_UNLIMITED)};
static const cyaml_schema_value_t vector = {CYAML_VALUE_SEQUENCE_FIXED(OPTIONAL, char *, &text, 3)};
static const cyaml_schema_value_t row_of_four = {CYAML_VALUE_SEQUENCE_FIXED(OPTIONAL, char *, &text, 4)};
static const cyaml_schema_value_t rows = {
    CYAML_VALUE_SEQUENCE(OPTIONAL, char *(*)[4], &row_of_four, 0, CYAML_UNLIMITED)};

/* ---- from the table to the schema -------------------------------------------------------------------------------- */

static cyaml_schema_value_t section_value(struct scene_schema *schema, const char *section);

static cyaml_schema_value_t field_value(struct scene_schema *schema, const struct scene_field *field)
{
    if (field->kind == SCENE_SECTION)
        return section_value(schema, field->path);
    if (field->kind == SCENE_PLANES)
        return rows;
    return field->kind == SCENE_VECTOR || field->kind == SCENE_COUNTS ? vector : text;
}

static int count_keys(const char *section)
{
    int n = 0;
    for (int k = 0; scene_field_at(k) != NULL; ++k)
        n += scene_field_key(scene_field_at(k), section) != NULL;
    return n;
}

/** Takes rows for the section's keys and the end mark (key NULL), then fills them, inner sections included. */
static cyaml_schema_value_t section_value(struct scene_schema *schema, const char *section)
{
    const int keys = count_keys(section);
    cyaml_schema_field_t *row = &schema->rows[schema->used], *first = row;
    schema->used += keys + 1;
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const struct scene_field *field = scene_field_at(k);
        const char *key = scene_field_key(field, section);
        if (key == NULL)
            continue;
        row->key = key;
        row->data_offset = (uint32_t)((size_t)(row - first) * sizeof(struct scene_slot));
        row->count_offset = row->data_offset + (uint32_t)offsetof(struct scene_slot, items);
        row->count_size = sizeof(uint64_t);
        row->value = field_value(schema, field);
        ++row;
    }
    const cyaml_schema_value_t value = {.type = CYAML_MAPPING,
                                        .flags = (enum cyaml_flag)OPTIONAL,
                                        .data_size = (uint32_t)((size_t)keys * sizeof(struct scene_slot)),
                                        .mapping = {first}};
    return value;
}

void scene_schema_build(struct scene_schema *schema)
{
    memset(schema, 0, sizeof *schema);
    schema->root = section_value(schema, "");
}

/* ---- the way along a path ---------------------------------------------------------------------------------------- */

/** The row of the first key of path; *path then stands at the next key, or is NULL. */
static const cyaml_schema_field_t *step(const cyaml_schema_value_t *section, const char **path)
{
    const size_t n = strcspn(*path, ".");
    const cyaml_schema_field_t *row = section->mapping.fields;
    while (strncmp(row->key, *path, n) != 0 || row->key[n] != '\0')
        ++row;
    *path = (*path)[n] == '.' ? *path + n + 1 : NULL;
    return row;
}

const cyaml_schema_value_t *scene_schema_value(const struct scene_schema *schema, const char *path)
{
    const cyaml_schema_value_t *value = &schema->root;
    while (path != NULL)
        value = &step(value, &path)->value;
    return value;
}

void *scene_schema_zeros(size_t bytes)
{
    void *p = cyaml_mem(NULL, NULL, bytes);
    if (p != NULL)
        memset(p, 0, bytes);
    return p;
}

struct scene_slot *scene_schema_slot(const struct scene_schema *schema, struct scene_slot *root, const char *path,
                                     int make)
{
    const cyaml_schema_value_t *value = &schema->root;
    struct scene_slot *slot = root;
    while (path != NULL) {
        if (slot->value == NULL && make)
            slot->value = scene_schema_zeros(value->data_size);
        if (slot->value == NULL)
            return NULL;
        const cyaml_schema_field_t *row = step(value, &path);
        slot = (struct scene_slot *)slot->value + row->data_offset / sizeof(struct scene_slot);
        value = &row->value;
    }
    return slot;
}
