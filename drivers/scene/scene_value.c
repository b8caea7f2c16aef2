/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_value.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "number.h"
#include "scene_stepper.h"

/* ---- words ------------------------------------------------------------------------------------------------------- */

int scene_value_name(const struct scene_reader *reader, const char *name, const char *whose, char out[64])
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    char shown[QUOTE_SIZE];
    const size_t n = strlen(name);
    if (n == 0 || n > 63 || name[strspn(name, allowed)] != '\0')
        return scene_reader_fail(reader, "name", "'%s'%s cannot name files; write 1 to 63 letters, digits, _ or -",
                                 quote(shown, sizeof shown, name), whose);
    memcpy(out, name, n + 1);
    return 0;
}

static const struct scene_word yes_no[] = {{"yes", 1}, {"no", 0}, {NULL, 0}};

static int read_word(const struct scene_reader *reader, const struct scene_field *field, const char *text,
                     const struct scene_word *words, int64_t *value)
{
    char shown[QUOTE_SIZE], known[128] = "";
    for (const struct scene_word *w = words; w->word != NULL; ++w) {
        if (strcmp(w->word, text) == 0) {
            *value = w->value;
            return 0;
        }
        quote_append(quote_append(known, sizeof known, known[0] != '\0' ? ", " : ""), sizeof known, w->word);
    }
    return scene_reader_fail(reader, field->path, "'%s' is not one of %s; take one of them",
                             quote(shown, sizeof shown, text), known);
}

/** Relative to the folder of the scene file, so that a scene and its tables travel together. */
static int read_path(const struct scene_reader *reader, const struct scene_field *field, const char *text,
                     char out[SCENE_PATH_SIZE])
{
    const char *scene = reader->path, *slash = strrchr(scene, '/');
    const size_t folder = text[0] != '/' && slash != NULL ? (size_t)(slash - scene) + 1 : 0, n = strlen(text);
    char shown[QUOTE_SIZE];
    if (n == 0)
        return scene_reader_fail(reader, field->path, "'' is not a path; name the %s", field->about);
    if (folder + n >= SCENE_PATH_SIZE)
        return scene_reader_fail(reader, field->path, "'%s' is too long; keep folder and name below %d letters",
                                 quote(shown, sizeof shown, text), SCENE_PATH_SIZE);
    memcpy(out, scene, folder);
    memcpy(out + folder, text, n + 1);
    return 0;
}

/** Names of the steppers that scenes can have. */
static char *list_steppers(char *out, size_t size)
{
    out[0] = '\0';
    for (int64_t k = 0; scene_stepper_at(k) != NULL; ++k)
        if (scene_stepper_at(k)->frame == VTI_FRAME_SPACE)
            quote_append(quote_append(out, size, out[0] != '\0' ? ", " : ""), size, scene_stepper_at(k)->name);
    return out;
}

static int read_stepper(const struct scene_reader *reader, const struct scene_field *field, const char *name,
                        const vti_stepper **stepper)
{
    char shown[QUOTE_SIZE], known[768];
    quote(shown, sizeof shown, name);
    list_steppers(known, sizeof known);
    const vti_stepper *found = scene_stepper_find(name);
    if (found == NULL)
        return scene_reader_fail(reader, field->path, "'%s' is not a stepper; take one of %s", shown, known);
    if (found->frame != VTI_FRAME_SPACE)
        return scene_reader_fail(
            reader, field->path,
            "'%s' wants moments in the body's frame, and scenes give them in space; take one of %s", shown, known);
    *stepper = found;
    return 0;
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

/** What the path of an item has behind the field's: "" of a single number, "[1]" of a vector, "[0][3]" of rows. */
static const char *part_of(const struct scene_field *field, int64_t item, char part[48])
{
    const struct scene_rows *rows = scene_rows_of(field->kind);
    if (rows != NULL && rows->row != NULL)
        snprintf(part, 48, "[%lld][%lld]", (long long)(item / rows->width), (long long)(item % rows->width));
    else if (rows != NULL || field->kind == SCENE_VECTOR || field->kind == SCENE_COUNTS)
        snprintf(part, 48, "[%lld]", (long long)item);
    else
        part[0] = '\0';
    return part;
}

/** Number k of a value that is given. */
static int read_number(const struct scene_reader *reader, const struct scene_field *field,
                       const struct scene_value *value, int64_t k, double *number)
{
    char shown[QUOTE_SIZE], part[48];
    const char *text = value->items[k].text;
    if (number_read(text, number) != 0)
        return scene_reader_fail_item(reader, field, k, part_of(field, k, part), "'%s' %s",
                                      quote(shown, sizeof shown, text), number_refusal(text));
    return 0;
}

static int check_range(const struct scene_reader *reader, const struct scene_field *field,
                       const struct scene_value *value, int64_t k, double number)
{
    char shown[QUOTE_SIZE], part[48];
    quote(shown, sizeof shown, value->items[k].text);
    part_of(field, k, part);
    if (field->range == SCENE_POSITIVE && !(number > 0.0))
        return scene_reader_fail_item(reader, field, k, part, "'%s' is not positive; the %s must be > 0", shown,
                                      field->about);
    if (field->range == SCENE_POISSON && number > 0.5)
        return scene_reader_fail_item(reader, field, k, part, "'%s' is above 0.5; no material has that", shown);
    if ((field->range == SCENE_NOT_NEGATIVE || field->range == SCENE_POISSON) && !(number >= 0.0))
        return scene_reader_fail_item(reader, field, k, part, "'%s' is negative; the %s must be >= 0", shown,
                                      field->about);
    return 0;
}

static int read_one(const struct scene_reader *reader, const struct scene_field *field, const struct scene_value *value,
                    double *number)
{
    if (read_number(reader, field, value, 0, number) != 0)
        return -1;
    return check_range(reader, field, value, 0, *number);
}

static int read_vector(const struct scene_reader *reader, const struct scene_field *field,
                       const struct scene_value *value, double vector[3])
{
    const struct scene_item *items = value->items;
    for (int k = 0; k < 3; ++k)
        if (read_number(reader, field, value, k, &vector[k]) != 0 ||
            check_range(reader, field, value, k, vector[k]) != 0)
            return -1;
    if (field->range == SCENE_NOT_ZERO && vector[0] == 0.0 && vector[1] == 0.0 && vector[2] == 0.0)
        return scene_reader_fail(reader, field->path, "'[%.20s, %.20s, %.20s]' has no length; the %s must not be zero",
                                 items[0].text, items[1].text, items[2].text, field->about);
    return 0;
}

/* ---- whole numbers ----------------------------------------------------------------------------------------------- */

static int read_counts(const struct scene_reader *reader, const struct scene_field *field,
                       const struct scene_value *value, int64_t *counts)
{
    for (int64_t k = 0; k < value->count; ++k) {
        char shown[QUOTE_SIZE], part[48];
        double number;
        const char *text = quote(shown, sizeof shown, value->items[k].text);
        part_of(field, k, part);
        if (number_read(value->items[k].text, &number) != 0 || number != floor(number))
            return scene_reader_fail_item(reader, field, k, part, "'%s' is not a whole number; " NUMBER_WRITE_COUNT,
                                          text);
        if (fabs(number) > 0x1p53)
            return scene_reader_fail_item(reader, field, k, part, "'%s' is too large; give a whole number up to 2^53",
                                          text);
        if (check_range(reader, field, value, k, number) != 0)
            return -1;
        counts[k] = (int64_t)number;
    }
    return 0;
}

/* ---- lists of rows ----------------------------------------------------------------------------------------------- */

/** Divides a vector and what follows it, count numbers in all, by the length of the vector. Returns -1 if that is not
 *  possible. */
static int make_unit(double *row, int count)
{
    const double length = vti_norm(row);
    int good = length > 0.0 && isfinite(length);
    for (int k = 0; k < count && good; ++k) {
        row[k] /= length;
        good &= isfinite(row[k]);
    }
    return good ? 0 : -1;
}

/** What a row must be besides numbers. */
static int finish_row(const struct scene_reader *reader, const struct scene_field *field,
                      const struct scene_value *value, int64_t row, double *numbers)
{
    const int64_t width = scene_rows_of(field->kind)->width;
    const struct scene_item *items = &value->items[width * row];
    char part[48];
    snprintf(part, sizeof part, "[%lld]", (long long)row);
    if (field->kind == SCENE_PLANES && make_unit(numbers, 4) != 0)
        return scene_reader_fail_item(
            reader, field, width * row, part,
            "'[%.20s, %.20s, %.20s, %.20s]' has no unit normal; its first three numbers are zero, too small or too "
            "large",
            items[0].text, items[1].text, items[2].text, items[3].text);
    if (field->kind == SCENE_CYLINDERS && make_unit(numbers, 3) != 0)
        return scene_reader_fail_item(reader, field, width * row, part,
                                      "'[%.20s, %.20s, %.20s, ...]' has no axis; its first three numbers are zero, "
                                      "too small or too large",
                                      items[0].text, items[1].text, items[2].text);
    if (field->kind == SCENE_CYLINDERS && !(numbers[6] > 0.0))
        return scene_reader_fail_item(reader, field, width * row + 6, part,
                                      "the radius '%.20s' is not positive; the seventh number must be > 0",
                                      items[6].text);
    if (field->kind == SCENE_SPHERES && !(numbers[3] > 0.0))
        return scene_reader_fail_item(reader, field, width * row + 3, part,
                                      "the diameter '%.20s' is not positive; the fourth number must be > 0",
                                      items[3].text);
    return 0;
}

/** A list of rows into its count and its numbers. */
static int read_rows(const struct scene_reader *reader, const struct scene_field *field,
                     const struct scene_value *value, struct scene_list *list)
{
    const struct scene_rows *rows = scene_rows_of(field->kind);
    double *numbers = list->numbers;
    list->count = value->count / rows->width;
    if (list->count > rows->most)
        return scene_reader_fail(reader, field->path, "%lld %s; give at most %lld", (long long)list->count, rows->name,
                                 (long long)rows->most);
    for (int64_t row = 0; row < list->count; ++row, numbers += rows->width) {
        for (int64_t k = 0; k < rows->width; ++k)
            if (read_number(reader, field, value, rows->width * row + k, &numbers[k]) != 0 ||
                check_range(reader, field, value, rows->width * row + k, numbers[k]) != 0)
                return -1;
        if (finish_row(reader, field, value, row, numbers) != 0)
            return -1;
    }
    return 0;
}

/* ---- any field --------------------------------------------------------------------------------------------------- */

int scene_value_read(const struct scene_reader *reader, const struct scene_field *field, struct scene *scene)
{
    const struct scene_value *value = scene_reader_at(reader, field->path);
    void *target = scene_field_place(field, scene);
    if (!value->given || target == NULL)
        return 0;
    switch (field->kind) {
    case SCENE_SECTION:
        break;
    case SCENE_NUMBER:
        return read_one(reader, field, value, target);
    case SCENE_VECTOR:
        return read_vector(reader, field, value, target);
    case SCENE_COUNT:
    case SCENE_COUNTS:
        return read_counts(reader, field, value, target);
    case SCENE_PLANES:
    case SCENE_CYLINDERS:
    case SCENE_SPHERES:
    case SCENE_VECTORS:
    case SCENE_NUMBERS:
        return read_rows(reader, field, value, target);
    case SCENE_YES_NO:
        return read_word(reader, field, value->items[0].text, yes_no, target);
    case SCENE_WORD:
        return read_word(reader, field, value->items[0].text, field->words, target);
    case SCENE_PATH:
        return read_path(reader, field, value->items[0].text, target);
    case SCENE_NAME:
        return scene_value_name(reader, value->items[0].text, "", target);
    case SCENE_STEPPER:
        return read_stepper(reader, field, value->items[0].text, target);
    }
    return 0;
}
