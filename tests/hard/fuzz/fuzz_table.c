/* SPDX-License-Identifier: BSD-3-Clause
 * Any bytes as a CSV table, of bodies or of bonds by the first byte: refused with one line, or numbers that can stand
 * where they do and of which a model can be made. */
#include "fuzz.h"

#include "binder.h"
#include "model.h"
#include "table_csv.h"

enum { ROWS = 300 };

static void check(const struct table *table)
{
    fuzz_must(table->rows > 0 && table->rows <= table->capacity, "a table has rows, and place for them");
    for (int k = 0; table_column(table->kind, k) != NULL; ++k)
        for (int64_t row = 0; table_has(table, k) && row < table->rows; ++row)
            fuzz_must(table_refusal(table->kind, k, table->column[k][row]) == NULL, "a number fits its column");
}

/** The same file as the table of a scene. */
static void use(const struct table_kind *kind)
{
    static const char *const texts[] = {
        "bodies: {table: table.csv}\ngravity: [0, 0, -1]\nh: 1/64\nt_end: 1\n",
        "bodies:\n  chain: {count: 20, spacing: 1}\n  mass: 1\n  inertia: 1\nbinder: {table: table.csv}\n"
        "h: 1/64\nt_end: 1\n"};
    static struct scene scene;
    struct model model;
    struct message message = {""};
    const char *text = texts[kind != &table_bodies];
    fuzz_must(scene_read(fuzz_file("scene.yaml", text, strlen(text)), NULL, 0, &scene, &message) == 0, message.text);
    if (model_create(&scene, &model, &message) != 0) {
        fuzz_one_line(&message);
        return;
    }
    (void)model_energy(&model, &model.bodies);
    model_destroy(&model);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct table table;
    struct message message = {""};
    if (size < 1)
        return 0;
    const struct table_kind *kind = data[0] & 1 ? &binder_table : &table_bodies;
    if (table_csv_read(fuzz_file("table.csv", data + 1, size - 1), kind, &table, &message) != 0) {
        fuzz_one_line(&message);
        return 0;
    }
    check(&table);
    const int64_t rows = table.rows;
    table_destroy(&table);
    if (rows <= ROWS)
        use(kind);
    return 0;
}
