/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The scene reader: the text of every field becomes a value (scene_value.h), then come the checks that concern several
 * fields at once (scene_check.c). What a file may hold at all is the table in scene_field.c. */
#include "scene.h"

#include <string.h>

#include "scene_value.h"

/* ---- field by field ---------------------------------------------------------------------------------------------- */

static int read_values(const struct scene_reader *reader, struct scene *scene)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k)
        if (scene_value_read(reader, scene_field_at(k), scene) != 0)
            return -1;
    return 0;
}

/** A field that must be there is missed only where its section is there. */
static int check_missing(const struct scene_reader *reader)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const struct scene_field *field = scene_field_at(k);
        char section[SCENE_KEYS_SIZE] = "";
        quote_append(section, sizeof section, field->path);
        scene_path_up(section);
        if (field->need != SCENE_MUST || scene_reader_has(reader, field->path) ||
            (section[0] != '\0' && !scene_reader_has(reader, section)))
            continue;
        return scene_reader_fail(reader, field->path, "missing; add '%s:', the %s", scene_field_key(field, section),
                                 field->about);
    }
    return 0;
}

/* ---- the scene --------------------------------------------------------------------------------------------------- */

/** Without a name the scene is called like its file, up to the last dot. */
static int take_name_of_file(const struct scene_reader *reader, const char *path, struct scene *scene)
{
    const char *slash = strrchr(path, '/'), *base = slash != NULL ? slash + 1 : path, *dot = strrchr(base, '.');
    const size_t n = dot != NULL ? (size_t)(dot - base) : strlen(base);
    char name[sizeof scene->name + 1] = "";
    memcpy(name, base, n < sizeof scene->name ? n : sizeof scene->name);
    return scene_value_name(reader, name, " (from the file's name, for there is no key 'name')", scene->name);
}

static int read_scene(const struct scene_reader *reader, const char *path, struct scene *scene)
{
    scene->chain.direction[0] = 1.0;
    kinds_defaults(&scene->settings);
    scene->stepper = vti_stepper_find("vti2");
    if (read_values(reader, scene) != 0 || check_missing(reader) != 0 || scene_check(reader, scene) != 0)
        return -1;
    return scene->name[0] != '\0' ? 0 : take_name_of_file(reader, path, scene);
}

int scene_read_text(const char *path, const struct scene_text *text, const char *const *overrides, int n,
                    struct scene *scene, struct message *message)
{
    struct scene_reader reader;
    memset(scene, 0, sizeof *scene);
    message->text[0] = '\0';
    if (kinds_check(message) != 0)
        return -1;
    int result = scene_reader_open(&reader, path, text, overrides, n, message);
    if (result == 0)
        result = read_scene(&reader, path, scene);
    scene_reader_close(&reader);
    return result;
}

int scene_read(const char *path, const char *const *overrides, int n, struct scene *scene, struct message *message)
{
    struct scene_text text;
    if (scene_text_read(path, &text, message) != 0)
        return -1;
    const int result = scene_read_text(path, &text, overrides, n, scene, message);
    scene_text_destroy(&text);
    return result;
}

int scene_no_memory(const struct scene *scene, struct message *message)
{
    return message_set(message, "%s: out of memory; use fewer bodies", scene->name);
}
