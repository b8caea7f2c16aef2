/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_number.h"

#include <math.h>

#include "number.h"
#include "scene_words.h"

static int read_component(const struct scene_reader *reader, const char *path, const char *text, double *value)
{
    if (number_read(text, value) == 0)
        return 0;
    char shown[QUOTE_SIZE];
    return scene_reader_fail(reader, path, "'%s' is not a number; %s", quote(shown, sizeof shown, text),
                             SCENE_WORDS_NUMBER);
}

static int check_range(const struct scene_reader *reader, const struct scene_field *field, const char *path,
                       const char *text, double number)
{
    char shown[QUOTE_SIZE];
    quote(shown, sizeof shown, text);
    if (field->range == SCENE_POSITIVE && !(number > 0.0))
        return scene_reader_fail(reader, path, "'%s' is not positive; the %s must be > 0", shown, field->about);
    if (field->range == SCENE_NOT_NEGATIVE && !(number >= 0.0))
        return scene_reader_fail(reader, path, "'%s' is negative; the %s must be >= 0", shown, field->about);
    return 0;
}

int scene_number_read(const struct scene_reader *reader, const struct scene_field *field, const char *text,
                      double *number)
{
    if (read_component(reader, field->path, text, number) != 0)
        return -1;
    return check_range(reader, field, field->path, text, *number);
}

/** Writes "path[k]" to item. */
static void item_path(const char *path, size_t k, char item[PLACE_PATH])
{
    item[0] = '\0';
    append(item, PLACE_PATH, path);
    place_append_item(item, k);
}

int scene_number_vector(const struct scene_reader *reader, const struct scene_field *field, char *const text[3],
                        double vector[3])
{
    for (size_t k = 0; k < 3; ++k) {
        char path[PLACE_PATH];
        item_path(field->path, k, path);
        if (read_component(reader, path, text[k], &vector[k]) != 0)
            return -1;
    }
    if (field->range == SCENE_NOT_ZERO && vector[0] == 0.0 && vector[1] == 0.0 && vector[2] == 0.0)
        return scene_reader_fail(reader, field->path, "'[%.20s, %.20s, %.20s]' has no length; the %s must not be zero",
                                 text[0], text[1], text[2], field->about);
    return 0;
}

/* ---- whole numbers ----------------------------------------------------------------------------------------------- */

int scene_number_count(const struct scene_reader *reader, const struct scene_field *field, const char *path,
                       const char *text, int64_t *count)
{
    char shown[QUOTE_SIZE];
    double number;
    if (number_read(text, &number) != 0 || number != floor(number))
        return scene_reader_fail(reader, path, "'%s' is not a whole number; %s", quote(shown, sizeof shown, text),
                                 SCENE_WORDS_COUNT);
    if (fabs(number) > 0x1p53)
        return scene_reader_fail(reader, path, "'%s' is too large; give a whole number up to 2^53",
                                 quote(shown, sizeof shown, text));
    *count = (int64_t)number;
    return check_range(reader, field, path, text, number);
}

int scene_number_counts(const struct scene_reader *reader, const struct scene_field *field, char *const text[3],
                        int64_t counts[3])
{
    for (size_t k = 0; k < 3; ++k) {
        char path[PLACE_PATH];
        item_path(field->path, k, path);
        if (scene_number_count(reader, field, path, text[k], &counts[k]) != 0)
            return -1;
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

static int read_plane(const struct scene_reader *reader, const char *path, char *const text[4], double plane[4])
{
    for (size_t k = 0; k < 4; ++k) {
        char number_path[PLACE_PATH];
        item_path(path, k, number_path);
        if (read_component(reader, number_path, text[k], &plane[k]) != 0)
            return -1;
    }
    if (make_unit(plane) == 0)
        return 0;
    return scene_reader_fail(
        reader, path,
        "'[%.20s, %.20s, %.20s, %.20s]' has no unit normal; its first three numbers are zero or too large", text[0],
        text[1], text[2], text[3]);
}

int scene_number_planes(const struct scene_reader *reader, const struct scene_field *field, char *const *const *rows,
                        struct scene_planes *planes)
{
    planes->count = scene_reader_items(reader, field->path);
    if (planes->count > SCENE_PLANES_MAX)
        return scene_reader_fail(reader, field->path, "%lld planes; give at most %d", (long long)planes->count,
                                 SCENE_PLANES_MAX);
    for (int64_t k = 0; k < planes->count; ++k) {
        char path[PLACE_PATH];
        item_path(field->path, (size_t)k, path);
        if (read_plane(reader, path, rows[k], planes->plane[k]) != 0)
            return -1;
    }
    return 0;
}
