/* SPDX-License-Identifier: BSD-3-Clause */
#include "tables.h"

#include <string.h>

#include "digest.h"
#include "kind.h"
#include "scene.h"

const char *tables_path(const struct scene *scene, int k)
{
    const struct effect_kind *kind = kinds_at(k - 1);
    const char *path = k == 0 ? scene->table : "";
    for (int f = 0; kind != NULL && f < kind->fields_count; ++f)
        if (kind->fields[f].kind == SCENE_PATH)
            path = (const char *)kinds_settings_of(kind, &scene->settings) + kind->fields[f].offset;
    return path;
}

const struct table_kind *tables_kind(int k)
{
    return k == 0 ? &table_bodies : kinds_at(k - 1)->table;
}

static struct table *tables_at(struct tables *tables, int k)
{
    return k == 0 ? &tables->bodies : &tables->effect[k - 1];
}

int tables_read_by(table_reader *read, const struct scene *scene, struct tables *tables, struct message *message)
{
    int result = 0;
    memset(tables, 0, sizeof *tables);
    for (int k = 0; k < TABLES && result == 0; ++k)
        if (tables_path(scene, k)[0] != '\0')
            result = read(tables_path(scene, k), tables_kind(k), tables_at(tables, k), message);
    return result;
}

void tables_destroy(struct tables *tables)
{
    for (int k = 0; k < TABLES; ++k)
        table_destroy(tables_at(tables, k));
}

uint64_t tables_digest(const struct tables *tables, int k)
{
    const struct table *table = k == 0 ? &tables->bodies : &tables->effect[k - 1];
    uint64_t digest = DIGEST_START;
    for (int64_t c = 0; c < TABLE_COLUMNS; ++c)
        if (table_has(table, (int)c)) {
            digest = digest_add(digest, &c, sizeof c);
            digest = digest_add(digest, table->column[c], sizeof(double) * (size_t)table->rows);
        }
    return digest;
}
