/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "table_csv.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "quote.h"

/** A file that is being read. */
struct csv {
    struct table *table;
    struct message *message;
    char *line; /* of getline */
    size_t size;
    long number;              /* of the line, from 1 */
    int order[TABLE_COLUMNS]; /* which column stands where */
    int width;                /* columns in the file */
};

static int fail(const struct csv *csv, const char *at, const char *text)
{
    char path[240], place[48] = "";
    if (at != NULL)
        snprintf(place, sizeof place, ":%ld:%ld", csv->number, (long)(at - csv->line) + 1);
    else if (csv->number > 0)
        snprintf(place, sizeof place, ":%ld", csv->number);
    return message_set(csv->message, "%s%s: %s", quote_tail(path, sizeof path, csv->table->path), place, text);
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/** The next line without its end. Returns 1, 0 at the end of the file, or -1. */
static int next_line(struct csv *csv, FILE *file)
{
    char text[128];
    errno = 0;
    const ssize_t n = getline(&csv->line, &csv->size, file);
    if (n < 0 && feof(file) && !ferror(file))
        return 0;
    if (n < 0) {
        csv->number = 0;
        snprintf(text, sizeof text, "cannot be read: %s; give the path of a table", strerror(errno));
        return fail(csv, NULL, text);
    }
    ++csv->number;
    if (strlen(csv->line) != (size_t)n)
        return fail(csv, csv->line + strlen(csv->line), "a byte 0; give a text file");
    char *const end = csv->line + strcspn(csv->line, "\r\n");
    if (end[strspn(end, "\r\n")] != '\0') {
        *end = '\0'; /* what precedes it */
        return fail(csv, end,
                    "a line that ends with a carriage return alone; let lines end with newlines (tr '\\r' '\\n')");
    }
    *end = '\0';
    return 1;
}

/** Cuts the field at *next off, blanks around it too; *next then stands behind its comma, or is NULL. */
static char *cut(char **next)
{
    char *field = *next + strspn(*next, " \t"), *end = field + strcspn(field, ",");
    *next = *end == ',' ? end + 1 : NULL;
    *end = '\0';
    while (end > field && (end[-1] == ' ' || end[-1] == '\t'))
        *--end = '\0';
    return field;
}

static int count_fields(const char *line)
{
    int n = 1;
    for (; (line = strchr(line, ',')) != NULL; ++line)
        ++n;
    return n;
}

/* ---- the line of names ------------------------------------------------------------------------------------------- */

/** What spreadsheets and statistics programs write that is not read. */
static const char *find_habit(const char *name)
{
    return strchr(name, ';') != NULL ? "columns are parted by ';'; let commas part them, and points stand in numbers"
           : strchr(name, '\t') != NULL
               ? "columns are parted by tabs; let commas part them, and points stand in numbers"
           : name[0] == '"' ? "a name in quotation marks; write names and numbers without any"
                            : NULL;
}

static int fail_name(const struct csv *csv, const char *name)
{
    char shown[QUOTE_SIZE], known[256], text[416];
    const char *habit = find_habit(name);
    if (habit != NULL)
        return fail(csv, name, habit);
    snprintf(text, sizeof text, "unknown column '%s'; known are %s", quote(shown, sizeof shown, name),
             table_list(csv->table->kind, known, sizeof known));
    return fail(csv, name, text);
}

static int read_names(struct csv *csv)
{
    char text[2 * QUOTE_SIZE], *next = csv->line;
    if (strncmp(next, "\xef\xbb\xbf", 3) == 0) /* which spreadsheets write in front */
        next += 3;
    while (next != NULL) {
        char *name = cut(&next);
        const int k = table_find(csv->table->kind, name);
        if (k < 0)
            return fail_name(csv, name);
        if (table_has(csv->table, k)) {
            snprintf(text, sizeof text, "%s: a second time; keep one of the columns", name);
            return fail(csv, name, text);
        }
        if (table_add(csv->table, k) != 0)
            return fail(csv, NULL, "out of memory");
        csv->order[csv->width++] = k;
    }
    return 0;
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

static int read_value(const struct csv *csv, int k, const char *field)
{
    const struct table *table = csv->table;
    char shown[QUOTE_SIZE], text[4 * QUOTE_SIZE];
    double value;
    const char *refusal =
        number_read(field, &value) == 0 ? table_refusal(table->kind, k, value) : number_refusal(field);
    if (refusal == NULL) {
        table->column[k][table->rows] = value;
        return 0;
    }
    snprintf(text, sizeof text, "%s: '%s' %s", table_column(table->kind, k), quote(shown, sizeof shown, field),
             refusal);
    return fail(csv, field, text);
}

static int read_row(struct csv *csv)
{
    char text[96], *next = csv->line;
    if (csv->line[strspn(csv->line, " \t")] == '\0')
        return fail(csv, NULL, "an empty line; remove it");
    if (count_fields(csv->line) != csv->width) {
        const int n = count_fields(csv->line);
        snprintf(text, sizeof text, "%d value%s in a row of %d column%s; give one for each name in line 1", n,
                 n == 1 ? "" : "s", csv->width, csv->width == 1 ? "" : "s");
        return fail(csv, NULL, text);
    }
    if (csv->table->rows == TABLE_ROWS_MAX || table_reserve(csv->table, csv->table->rows + 1) != 0)
        return fail(csv, NULL, "out of memory; give fewer rows");
    for (int k = 0; k < csv->width; ++k)
        if (read_value(csv, csv->order[k], cut(&next)) != 0)
            return -1;
    ++csv->table->rows;
    return 0;
}

static int read_all(struct csv *csv, FILE *file)
{
    int more = next_line(csv, file);
    if (more == 0)
        return fail(csv, NULL, "an empty file; give a line of names and a row a line");
    if (more < 0 || read_names(csv) != 0)
        return -1;
    while ((more = next_line(csv, file)) > 0)
        if (read_row(csv) != 0)
            return -1;
    return more < 0 ? -1 : table_check(csv->table, csv->message);
}

int table_csv_read(const char *path, const struct table_kind *kind, struct table *table, struct message *message)
{
    struct csv csv = {.table = table, .message = message};
    char text[128];
    table_start(table, kind, path);
    table->has_lines = 1;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        snprintf(text, sizeof text, "cannot be read: %s; give the path of a table", strerror(errno));
        return fail(&csv, NULL, text);
    }
    const int result = read_all(&csv, file);
    fclose(file);
    free(csv.line);
    if (result != 0)
        table_destroy(table);
    return result;
}
