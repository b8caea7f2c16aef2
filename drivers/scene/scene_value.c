/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_value.h"

#include <string.h>

#include "scene_number.h"
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
        append(append(known, sizeof known, known[0] != '\0' ? ", " : ""), sizeof known, w->word);
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
            append(append(out, size, out[0] != '\0' ? ", " : ""), size, scene_stepper_at(k)->name);
    return out;
}

static int read_stepper(const struct scene_reader *reader, const struct scene_field *field, const char *name,
                        const vti_stepper **stepper)
{
    char shown[QUOTE_SIZE], known[512];
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

/* ---- any field --------------------------------------------------------------------------------------------------- */

int scene_value_read(const struct scene_reader *reader, const struct scene_field *field, struct scene *scene)
{
    const struct scene_value *value = scene_reader_at(reader, field->path);
    void *target = scene_field_place(field, scene);
    if (!value->given || target == NULL)
        return 0;
    switch (field->kind) {
    case SCENE_SECTION:
        *(int *)target = 1;
        return 0;
    case SCENE_NUMBER:
        return scene_number_read(reader, field, value, target);
    case SCENE_VECTOR:
        return scene_number_vector(reader, field, value, target);
    case SCENE_COUNT:
    case SCENE_COUNTS:
        return scene_number_counts(reader, field, value, target);
    case SCENE_PLANES:
        return scene_number_planes(reader, field, value, target);
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
