/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_value.h"

#include <string.h>

#include "number.h"
#include "scene_words.h"

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

static int read_component(const struct scene_reader *reader, const char *path, const char *text, double *value)
{
    if (number_read(text, value) == 0)
        return 0;
    char shown[QUOTE_SIZE];
    return scene_reader_fail(reader, path, "'%s' is not a number; %s", quote(shown, sizeof shown, text),
                             SCENE_WORDS_NUMBER);
}

static int read_number(const struct scene_reader *reader, const struct scene_field *field, const void *value,
                       double *number)
{
    char shown[QUOTE_SIZE];
    if (read_component(reader, field->path, value, number) != 0)
        return -1;
    quote(shown, sizeof shown, value);
    if (field->range == SCENE_POSITIVE && !(*number > 0.0))
        return scene_reader_fail(reader, field->path, "'%s' is not positive; the %s must be > 0", shown, field->about);
    if (field->range == SCENE_NOT_NEGATIVE && !(*number >= 0.0))
        return scene_reader_fail(reader, field->path, "'%s' is negative; the %s must be >= 0", shown, field->about);
    return 0;
}

static int read_vector(const struct scene_reader *reader, const struct scene_field *field, const void *value,
                       double vector[3])
{
    char *const *text = value;
    for (size_t k = 0; k < 3; ++k) {
        char path[PLACE_PATH];
        path[0] = '\0';
        append(path, sizeof path, field->path);
        place_append_item(path, k);
        if (read_component(reader, path, text[k], &vector[k]) != 0)
            return -1;
    }
    if (field->range == SCENE_NOT_ZERO && vector[0] == 0.0 && vector[1] == 0.0 && vector[2] == 0.0)
        return scene_reader_fail(reader, field->path, "'[%.20s, %.20s, %.20s]' has no length; the %s must not be zero",
                                 text[0], text[1], text[2], field->about);
    return 0;
}

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

/** Names of the steppers that scenes can have. */
static char *list_steppers(char *out, size_t size)
{
    out[0] = '\0';
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        if (vti_stepper_at(k)->frame == VTI_FRAME_SPACE)
            append(append(out, size, out[0] != '\0' ? ", " : ""), size, vti_stepper_at(k)->name);
    return out;
}

static int read_stepper(const struct scene_reader *reader, const struct scene_field *field, const char *name,
                        const vti_stepper **stepper)
{
    char shown[QUOTE_SIZE], known[256];
    quote(shown, sizeof shown, name);
    list_steppers(known, sizeof known);
    const vti_stepper *found = vti_stepper_find(name);
    if (found == NULL)
        return scene_reader_fail(reader, field->path, "'%s' is not a stepper; take one of %s", shown, known);
    if (found->frame != VTI_FRAME_SPACE)
        return scene_reader_fail(
            reader, field->path,
            "'%s' wants moments in the body's frame, and scenes give them in space; take one of %s", shown, known);
    *stepper = found;
    return 0;
}

/* ---- any field --------------------------------------------------------------------------------------------------- */

int scene_value_read(const struct scene_reader *reader, const struct scene_field *field, struct scene *scene)
{
    const void *value = scene_reader_value(reader, field->path);
    if (value == NULL || field->offset == SCENE_NOWHERE)
        return 0;
    void *target = (char *)scene + field->offset;
    switch (field->kind) {
    case SCENE_SECTION:
        *(int *)target = 1;
        return 0;
    case SCENE_NUMBER:
        return read_number(reader, field, value, target);
    case SCENE_VECTOR:
        return read_vector(reader, field, value, target);
    case SCENE_NAME:
        return scene_value_name(reader, value, "", target);
    case SCENE_STEPPER:
        return read_stepper(reader, field, value, target);
    }
    return 0;
}
