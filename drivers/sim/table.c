/* SPDX-License-Identifier: BSD-3-Clause */
#include "table.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "quote.h"

enum range { ANY, POSITIVE, NOT_NEGATIVE, INDEX };

struct column {
    const char *name;
    enum range range;
};

static const struct column bodies[] = {
    {"x", ANY},       {"y", ANY},       {"z", ANY},         {"vx", ANY},           {"vy", ANY},
    {"vz", ANY},      {"alpha_x", ANY}, {"alpha_y", ANY},   {"alpha_z", ANY},      {"omega_x", ANY},
    {"omega_y", ANY}, {"omega_z", ANY}, {"mass", POSITIVE}, {"inertia", POSITIVE}, {"diameter", POSITIVE}};
static const struct column bonds[] = {
    {"i", INDEX}, {"j", INDEX}, {"moment", NOT_NEGATIVE}, {"axial", NOT_NEGATIVE}, {"shear", NOT_NEGATIVE}};

/* ---- columns ---------------------------------------------------------------------------------------------------------- */

static const struct column *columns(enum table_kind kind, int *count)
{
    *count = (int)(kind == TABLE_BODIES ? sizeof bodies / sizeof *bodies : sizeof bonds / sizeof *bonds);
    return kind == TABLE_BODIES ? bodies : bonds;
}

const char *table_column(enum table_kind kind, int k)
{
    int count;
    const struct column *all = columns(kind, &count);
    return k < count ? all[k].name : NULL;
}

int table_find(enum table_kind kind, const char *name)
{
    for (int k = 0; table_column(kind, k) != NULL; ++k)
        if (strcmp(table_column(kind, k), name) == 0)
            return k;
    return -1;
}

char *table_list(enum table_kind kind, char *out, size_t size)
{
    out[0] = '\0';
    for (int k = 0; table_column(kind, k) != NULL; ++k)
        append(append(out, size, k > 0 ? ", " : ""), size, table_column(kind, k));
    return out;
}

int table_is_hdf5(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot != NULL && (strcmp(dot, ".h5") == 0 || strcmp(dot, ".hdf5") == 0);
}

/* ---- memory ----------------------------------------------------------------------------------------------------------- */

void table_start(struct table *table, enum table_kind kind, const char *path)
{
    memset(table, 0, sizeof *table);
    table->kind = kind;
    snprintf(table->path, sizeof table->path, "%s", path);
}

static int resize(struct table *table, int k, int64_t capacity)
{
    double *larger = realloc(table->column[k], (size_t)capacity * sizeof *larger);
    if (larger == NULL)
        return -1;
    table->column[k] = larger;
    return 0;
}

int table_add(struct table *table, int k)
{
    return resize(table, k, table->capacity > 0 ? table->capacity : 1);
}

int table_reserve(struct table *table, int64_t rows)
{
    if (rows <= table->capacity)
        return 0;
    const int64_t capacity = rows > 2 * table->capacity ? rows : 2 * table->capacity;
    for (int k = 0; k < TABLE_COLUMNS; ++k)
        if (table_has(table, k) && resize(table, k, capacity) != 0)
            return -1;
    table->capacity = capacity;
    return 0;
}

void table_destroy(struct table *table)
{
    for (int k = 0; k < TABLE_COLUMNS; ++k)
        free(table->column[k]);
    memset(table, 0, sizeof *table);
}

/* ---- checks ----------------------------------------------------------------------------------------------------------- */

const char *table_refusal(enum table_kind kind, int k, double value)
{
    int count;
    const enum range range = columns(kind, &count)[k].range;
    if (!isfinite(value))
        return "is not finite; give a number";
    if (range == POSITIVE && !(value > 0.0))
        return "is not positive; it must be > 0";
    if (range == NOT_NEGATIVE && !(value >= 0.0))
        return "is negative; it must be >= 0";
    if (range == INDEX && (!(value >= 0.0) || value != floor(value) || value > 0x1p53))
        return "is not a body; bodies are counted 0, 1, 2 and so on";
    return NULL;
}

int table_fail(const struct table *table, int64_t row, struct message *message, const char *format, ...)
{
    char path[240], text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    quote_tail(path, sizeof path, table->path);
    if (table->has_lines)
        return message_set(message, "%s:%lld: %s", path, (long long)row + 2, text);
    return message_set(message, "%s: row %lld: %s", path, (long long)row, text);
}

static int fail_columns(const struct table *table, struct message *message, const char *problem)
{
    char path[240];
    return message_set(message, "%s%s: %s", quote_tail(path, sizeof path, table->path), table->has_lines ? ":1" : "",
                       problem);
}

static int check_bodies(const struct table *t, struct message *message)
{
    char text[128];
    for (int k = 0; k < BODY_VECTORS; k += 3)
        for (int c = 0; c < 3; ++c) {
            if (table_has(t, k + c) || (!table_has(t, k) && !table_has(t, k + 1) && !table_has(t, k + 2)))
                continue;
            snprintf(text, sizeof text, "no column %s; give %s, %s and %s or none of them", bodies[k + c].name,
                     bodies[k].name, bodies[k + 1].name, bodies[k + 2].name);
            return fail_columns(t, message, text);
        }
    if (table_has(t, BODY_V) && !table_has(t, BODY_X))
        return fail_columns(t, message, "no columns x, y, z; bodies with vx, vy, vz need them");
    return 0;
}

int table_check(const struct table *table, struct message *message)
{
    if (table->rows == 0)
        return fail_columns(table, message,
                            table->kind == TABLE_BODIES ? "no bodies; give a row for each"
                                                        : "no bonds; give a row for each");
    if (table->kind == TABLE_BODIES)
        return check_bodies(table, message);
    for (int k = BOND_I; k <= BOND_J; ++k)
        if (!table_has(table, k))
            return fail_columns(table, message,
                                k == BOND_I ? "no column i; bonds need i and j" : "no column j; bonds need i and j");
    return 0;
}
