/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_number.h"

#include <math.h>
#include <stdio.h>

#include "number.h"

/** What the path of an item has behind the field's: "" of a single number, "[1]" of a vector, "[0][3]" of planes. */
static const char *part_of(const struct scene_field *field, int64_t item, char part[48])
{
    if (field->kind == SCENE_PLANES)
        snprintf(part, 48, "[%lld][%lld]", (long long)(item / 4), (long long)(item % 4));
    else if (field->kind == SCENE_VECTOR || field->kind == SCENE_COUNTS)
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
        return scene_reader_fail_item(reader, field, k, part_of(field, k, part), "'%s' is not a number; " NUMBER_WRITE,
                                      quote(shown, sizeof shown, text));
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
    if (field->range == SCENE_NOT_NEGATIVE && !(number >= 0.0))
        return scene_reader_fail_item(reader, field, k, part, "'%s' is negative; the %s must be >= 0", shown,
                                      field->about);
    return 0;
}

int scene_number_read(const struct scene_reader *reader, const struct scene_field *field,
                      const struct scene_value *value, double *number)
{
    if (read_number(reader, field, value, 0, number) != 0)
        return -1;
    return check_range(reader, field, value, 0, *number);
}

int scene_number_vector(const struct scene_reader *reader, const struct scene_field *field,
                        const struct scene_value *value, double vector[3])
{
    const struct scene_item *items = value->items;
    for (int k = 0; k < 3; ++k)
        if (read_number(reader, field, value, k, &vector[k]) != 0)
            return -1;
    if (field->range == SCENE_NOT_ZERO && vector[0] == 0.0 && vector[1] == 0.0 && vector[2] == 0.0)
        return scene_reader_fail(reader, field->path, "'[%.20s, %.20s, %.20s]' has no length; the %s must not be zero",
                                 items[0].text, items[1].text, items[2].text, field->about);
    return 0;
}

/* ---- whole numbers ----------------------------------------------------------------------------------------------- */

int scene_number_counts(const struct scene_reader *reader, const struct scene_field *field,
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

/* ---- planes ------------------------------------------------------------------------------------------------------ */

/** Divides a plane by the length of its normal. Returns -1 if that is not possible. */
static int make_unit(double plane[4])
{
    const double length = vti_norm(plane);
    if (!(length > 0.0) || !isfinite(length))
        return -1;
    for (int k = 0; k < 4; ++k)
        plane[k] /= length;
    return isfinite(plane[3]) ? 0 : -1;
}

static int read_plane(const struct scene_reader *reader, const struct scene_field *field,
                      const struct scene_value *value, int64_t row, double plane[4])
{
    const struct scene_item *items = &value->items[4 * row];
    char part[48];
    for (int k = 0; k < 4; ++k)
        if (read_number(reader, field, value, 4 * row + k, &plane[k]) != 0)
            return -1;
    if (make_unit(plane) == 0)
        return 0;
    snprintf(part, sizeof part, "[%lld]", (long long)row);
    return scene_reader_fail_item(
        reader, field, 4 * row, part,
        "'[%.20s, %.20s, %.20s, %.20s]' has no unit normal; its first three numbers are zero or too large",
        items[0].text, items[1].text, items[2].text, items[3].text);
}

int scene_number_planes(const struct scene_reader *reader, const struct scene_field *field,
                        const struct scene_value *value, struct scene_planes *planes)
{
    planes->count = value->count / 4;
    if (planes->count > SCENE_PLANES_MAX)
        return scene_reader_fail(reader, field->path, "%lld planes; give at most %d", (long long)planes->count,
                                 SCENE_PLANES_MAX);
    for (int64_t row = 0; row < planes->count; ++row)
        if (read_plane(reader, field, value, row, planes->plane[row]) != 0)
            return -1;
    return 0;
}
