/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The scene reader: the text of every field becomes a value (scene_value.h), then the checks that concern several
 * fields at once. What a file may hold at all is the table in scene_field.c. */
#include "scene.h"

#include <string.h>

#include "scene_reader.h"
#include "scene_value.h"

static int has(const struct scene_reader *reader, const char *path)
{
    return scene_reader_value(reader, path) != NULL;
}

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
        char section[PLACE_PATH];
        memcpy(section, field->path, strlen(field->path) + 1);
        scene_path_up(section);
        if (field->need != SCENE_MUST || has(reader, field->path) || (section[0] != '\0' && !has(reader, section)))
            continue;
        return scene_reader_fail(reader, field->path, "missing; add '%s:', the %s", scene_field_key(field, section),
                                 field->about);
    }
    return 0;
}

/* ---- fields that need each other --------------------------------------------------------------------------------- */

/** Both fields or neither; *given: both. */
static int check_pair(const struct scene_reader *reader, const char *a, const char *b, int *given)
{
    const int has_a = has(reader, a), has_b = has(reader, b);
    *given = has_a && has_b;
    if (has_a == has_b)
        return 0;
    return scene_reader_fail(reader, has_a ? a : b, "given without %s; give both or neither", has_a ? b : a);
}

/** x and v need a mass, alpha and omega an inertia. */
static int check_needed(const struct scene_reader *reader, int needed, const char *path, const char *by)
{
    if (!needed || has(reader, path))
        return 0;
    return scene_reader_fail(reader, path, "missing; bodies with %s need it, the %s", by,
                             scene_field_find(path)->about);
}

static int check_bodies(const struct scene_reader *reader, struct scene *scene)
{
    if (check_pair(reader, "bodies.x", "bodies.v", &scene->translates) != 0 ||
        check_pair(reader, "bodies.alpha", "bodies.omega", &scene->turns) != 0)
        return -1;
    if (!scene->translates && !scene->turns)
        return scene_reader_fail(reader, "bodies", "nothing moves; give x and v, or alpha and omega, or all four");
    if (check_needed(reader, scene->translates, "bodies.mass", "x and v") != 0)
        return -1;
    return check_needed(reader, scene->turns, "bodies.inertia", "alpha and omega");
}

static int check_effects(const struct scene_reader *reader, const struct scene *scene)
{
    if (scene->has_pendulum && !scene->turns)
        return scene_reader_fail(reader, "pendulum", "a pendulum turns; give bodies.alpha and bodies.omega");
    return 0;
}

/** Steps are counted in a double (t = step h), which holds whole numbers up to 2^53. */
static int check_steps(const struct scene_reader *reader, const struct scene *scene)
{
    if (scene->t_end / scene->h <= 0x1p53)
        return 0;
    char t_end[QUOTE_SIZE], h[QUOTE_SIZE];
    return scene_reader_fail(reader, "t_end", "'%s' is more than 2^53 steps of h = %s; take a larger h",
                             quote(t_end, sizeof t_end, scene_reader_value(reader, "t_end")),
                             quote(h, sizeof h, scene_reader_value(reader, "h")));
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
    if (read_values(reader, scene) != 0 || check_missing(reader) != 0 || check_bodies(reader, scene) != 0 ||
        check_effects(reader, scene) != 0 || check_steps(reader, scene) != 0)
        return -1;
    if (scene->stepper == NULL)
        scene->stepper = vti_stepper_find("vti2");
    return scene->name[0] != '\0' ? 0 : take_name_of_file(reader, path, scene);
}

int scene_read(const char *path, const char *const *overrides, int n, struct scene *scene, struct message *message)
{
    struct scene_reader reader;
    memset(scene, 0, sizeof *scene);
    message->text[0] = '\0';
    int result = scene_reader_open(&reader, path, overrides, n, message);
    if (result == 0)
        result = read_scene(&reader, path, scene);
    scene_reader_close(&reader);
    return result;
}
