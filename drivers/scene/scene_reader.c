/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_reader.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_words.h"

/* ---- the file and the --set arguments ---------------------------------------------------------------------------- */

static int load_file(struct scene_reader *reader, const char *path)
{
    struct scene_source *source = &reader->sources[0];
    if (scene_source_file(path, source, reader->message) != 0)
        return -1;
    reader->sources_count = 1;
    return scene_source_load(source, &reader->schema.root, &reader->root, reader->message);
}

static int fail_unknown(const struct scene_source *source, struct message *message)
{
    char section[PLACE_PATH], text[SCENE_WORDS_SIZE];
    const struct scene_field *field;
    snprintf(section, sizeof section, "%s", source->path);
    do { /* the innermost section that exists */
        scene_path_up(section);
        field = scene_field_find(section);
    } while (section[0] != '\0' && (field == NULL || field->kind != SCENE_SECTION));
    const size_t n = strlen(section);
    scene_words_unknown(section, source->path + n + (n > 0), text);
    return scene_source_fail(source, NULL, source->path, text, message);
}

static int fail_section(const struct scene_source *source, struct message *message)
{
    char list[SCENE_WORDS_SIZE], text[2 * SCENE_WORDS_SIZE];
    snprintf(text, sizeof text, "a section is not set as a whole; set one of its keys: %s",
             scene_field_list(source->path, list, sizeof list));
    return scene_source_fail(source, NULL, source->path, text, message);
}

/** Puts the value of --set in the place of the file's, which may lack it and the sections around it. */
static int load_set(struct scene_reader *reader, const char *argument)
{
    struct scene_source *source = &reader->sources[reader->sources_count];
    if (scene_source_set(argument, source, reader->message) != 0)
        return -1;
    ++reader->sources_count;
    const struct scene_field *field = scene_field_find(source->path);
    if (field == NULL)
        return fail_unknown(source, reader->message);
    if (field->kind == SCENE_SECTION)
        return fail_section(source, reader->message);
    const cyaml_schema_value_t *schema = scene_schema_value(&reader->schema, source->path);
    struct scene_slot *slot = scene_schema_slot(&reader->schema, &reader->root, source->path, 1), loaded;
    if (slot == NULL)
        return scene_source_fail(source, NULL, "", "out of memory", reader->message);
    if (scene_source_load(source, schema, &loaded, reader->message) != 0)
        return -1;
    scene_source_free(schema, slot);
    *slot = loaded;
    return 0;
}

int scene_reader_open(struct scene_reader *reader, const char *path, const char *const *sets, int n,
                      struct message *message)
{
    memset(reader, 0, sizeof *reader);
    reader->message = message;
    scene_schema_build(&reader->schema);
    reader->sources = calloc((size_t)n + 1, sizeof *reader->sources);
    if (reader->sources == NULL)
        return message_set(message, "%s: out of memory", path);
    int result = load_file(reader, path);
    for (int k = 0; k < n && result == 0; ++k)
        result = load_set(reader, sets[k]);
    return result;
}

void scene_reader_close(struct scene_reader *reader)
{
    scene_source_free(&reader->schema.root, &reader->root);
    for (int k = 0; k < reader->sources_count; ++k)
        free(reader->sources[k].text);
    free(reader->sources);
}

static const struct scene_slot *find_slot(const struct scene_reader *reader, const char *path)
{
    struct scene_slot root = reader->root; /* a copy, for without make nothing is written */
    return scene_schema_slot(&reader->schema, &root, path, 0);
}

const void *scene_reader_value(const struct scene_reader *reader, const char *path)
{
    const struct scene_slot *slot = find_slot(reader, path);
    return slot != NULL ? slot->value : NULL;
}

int scene_reader_has(const struct scene_reader *reader, const char *path)
{
    return scene_reader_value(reader, path) != NULL;
}

int64_t scene_reader_items(const struct scene_reader *reader, const char *path)
{
    const struct scene_slot *slot = find_slot(reader, path);
    return slot != NULL ? (int64_t)slot->items : 0;
}

/* ---- places ------------------------------------------------------------------------------------------------------ */

/** path is part of whole: the same, or whole goes on with a key or an index. */
static int is_part(const char *path, const char *whole)
{
    const size_t n = strlen(path);
    return strncmp(path, whole, n) == 0 && (whole[n] == '\0' || whole[n] == '.' || whole[n] == '[');
}

/** The last --set of the value at path or around it, or (inside) of a value in the section at path. */
static const struct scene_source *find_set(const struct scene_reader *reader, const char *path, int inside)
{
    for (int k = reader->sources_count - 1; k > 0; --k) {
        const char *set = reader->sources[k].path;
        if (inside ? is_part(path, set) : is_part(set, path))
            return &reader->sources[k];
    }
    return NULL;
}

/** The source that gives the value at path or, if it is not given, the section around it; its place if that is a file.
 *  */
static const struct scene_source *find(const struct scene_reader *reader, const char *path, struct place *place)
{
    const struct scene_source *file = &reader->sources[0], *set = find_set(reader, path, 0);
    char at[PLACE_PATH];
    snprintf(at, sizeof at, "%s", path);
    while (set == NULL && place_find(file->text, file->size, at, 1, place) != 0) {
        set = find_set(reader, at, 1);
        if (at[0] == '\0')
            break;
        scene_path_up(at);
    }
    if (set == NULL && place->kind == PLACE_SECTION && at[0] != '\0') {
        place->line = place->key_line;
        place->column = place->key_column;
    }
    return set != NULL ? set : file;
}

int scene_reader_fail(const struct scene_reader *reader, const char *path, const char *format, ...)
{
    char text[SCENE_WORDS_SIZE];
    struct place place;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const struct scene_source *source = find(reader, path, &place);
    return scene_source_fail(source, &place, path, text, reader->message);
}
