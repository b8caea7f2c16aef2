/* SPDX-License-Identifier: BSD-3-Clause */
#include "table.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "quote.h"

static int check_bodies(const struct table *t, struct message *message);

static const struct table_column bodies[] = {{"x", TABLE_ANY},
                                             {"y", TABLE_ANY},
                                             {"z", TABLE_ANY},
                                             {"vx", TABLE_ANY},
                                             {"vy", TABLE_ANY},
                                             {"vz", TABLE_ANY},
                                             {"alpha_x", TABLE_ANY},
                                             {"alpha_y", TABLE_ANY},
                                             {"alpha_z", TABLE_ANY},
                                             {"omega_x", TABLE_ANY},
                                             {"omega_y", TABLE_ANY},
                                             {"omega_z", TABLE_ANY},
                                             {"moment_a", TABLE_POSITIVE},
                                             {"moment_b", TABLE_POSITIVE},
                                             {"moment_c", TABLE_POSITIVE},
                                             {"principal_x", TABLE_ANY},
                                             {"principal_y", TABLE_ANY},
                                             {"principal_z", TABLE_ANY},
                                             {"mass", TABLE_POSITIVE},
                                             {"inertia", TABLE_POSITIVE},
                                             {"diameter", TABLE_POSITIVE},
                                             {"young", TABLE_POSITIVE},
                                             {"poisson", TABLE_NOT_NEGATIVE},
                                             {"clump", TABLE_COUNT}};

const struct table_kind table_bodies = {"bodies", "the scene's table of bodies", bodies,
                                        sizeof bodies / sizeof bodies[0], check_bodies};

/* ---- columns ----------------------------------------------------------------------------------------------------- */

const char *table_column(const struct table_kind *kind, int k)
{
    return k < kind->columns ? kind->column[k].name : NULL;
}

int table_find(const struct table_kind *kind, const char *name)
{
    for (int k = 0; table_column(kind, k) != NULL; ++k)
        if (strcmp(table_column(kind, k), name) == 0)
            return k;
    return -1;
}

char *table_list(const struct table_kind *kind, char *out, size_t size)
{
    out[0] = '\0';
    for (int k = 0; table_column(kind, k) != NULL; ++k)
        quote_append(quote_append(out, size, k > 0 ? ", " : ""), size, table_column(kind, k));
    return out;
}

int table_is_hdf5(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot != NULL && (strcmp(dot, ".h5") == 0 || strcmp(dot, ".hdf5") == 0);
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

void table_start(struct table *table, const struct table_kind *kind, const char *path)
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

/* ---- checks ------------------------------------------------------------------------------------------------------ */

const char *table_refusal(const struct table_kind *kind, int k, double value)
{
    const enum table_range range = kind->column[k].range;
    if (!isfinite(value))
        return "is not finite; give a number";
    if (range == TABLE_POSITIVE && !(value > 0.0))
        return "is not positive; it must be > 0";
    if (range == TABLE_NOT_NEGATIVE && !(value >= 0.0))
        return "is negative; it must be >= 0";
    const int is_whole = value >= 0.0 && value == floor(value) && value <= 0x1p53;
    if (range == TABLE_INDEX && !is_whole)
        return "is not a body; bodies are counted 0, 1, 2 and so on";
    if (range == TABLE_COUNT && !is_whole)
        return "is not a whole number from 0; write 0, 1, 2 and so on";
    return NULL;
}

int table_fail(const struct table *table, int64_t row, struct message *message, const char *format, ...)
{
    char path[240];
    struct message said;
    va_list arguments;
    va_start(arguments, format);
    message_set_list(&said, format, arguments);
    va_end(arguments);
    quote_tail(path, sizeof path, table->path);
    if (table->has_lines)
        return message_set(message, "%s:%lld: %s", path, (long long)row + 2, said.text);
    return message_set(message, "%s: row %lld: %s", path, (long long)row, said.text);
}

int table_fail_whole(const struct table *table, struct message *message, const char *text)
{
    char path[240];
    return message_set(message, "%s: %s", quote_tail(path, sizeof path, table->path), text);
}

int table_fail_columns(const struct table *table, struct message *message, const char *text)
{
    char path[240];
    return message_set(message, "%s%s: %s", quote_tail(path, sizeof path, table->path), table->has_lines ? ":1" : "",
                       text);
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
            return table_fail_columns(t, message, text);
        }
    if (table_has(t, BODY_V) && !table_has(t, BODY_X))
        return table_fail_columns(t, message, "no columns x, y, z; bodies with vx, vy, vz need them");
    if (table_has(t, BODY_MOMENTS) && table_has(t, BODY_INERTIA))
        return table_fail_columns(t, message, "inertia and moment_a, moment_b, moment_c; bodies have one or three");
    if (table_has(t, BODY_YOUNG) != table_has(t, BODY_POISSON))
        return table_fail_columns(t, message, "young and poisson come together; give both");
    return 0;
}

int table_check(const struct table *table, struct message *message)
{
    char text[128];
    if (table->rows > 0)
        return table->kind->check(table, message);
    snprintf(text, sizeof text, "no %s; give a row for each", table->kind->rows);
    return table_fail_columns(table, message, text);
}
