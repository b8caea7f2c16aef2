/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_reader.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { NAME_SIZE = 240 };

/* ---- values ------------------------------------------------------------------------------------------------------ */

struct scene_value *scene_reader_at(const struct scene_reader *reader, const char *path)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k)
        if (strcmp(scene_field_at(k)->path, path) == 0)
            return &reader->values[k];
    return NULL;
}

int scene_reader_has(const struct scene_reader *reader, const char *path)
{
    return scene_reader_at(reader, path)->given;
}

const char *scene_reader_value(const struct scene_reader *reader, const char *path)
{
    return scene_reader_at(reader, path)->items[0].text;
}

/* ---- messages ---------------------------------------------------------------------------------------------------- */

int scene_reader_say(const struct scene_reader *reader, const char *set, const struct place *place, const char *path,
                     const char *text)
{
    char name[NAME_SIZE], shown[2 * QUOTE_SIZE], lines[48] = "";
    const char *colon = path[0] != '\0' ? ": " : "";
    quote(shown, sizeof shown, path);
    if (set != NULL)
        return message_set(reader->message, "--set %s%s%s: %s", quote(name, sizeof name, set), colon, shown, text);
    if (place != NULL)
        snprintf(lines, sizeof lines, ":%lu:%lu", (unsigned long)place->line, (unsigned long)place->column);
    return message_set(reader->message, "%s%s%s%s: %s", quote_tail(name, sizeof name, reader->path), lines, colon,
                       shown, text);
}

/** The innermost of the value at path and the sections around it that is given; NULL if none is. */
static const struct scene_value *given_around(const struct scene_reader *reader, const char *path)
{
    char at[SCENE_KEYS_SIZE] = "";
    append(at, sizeof at, path);
    for (; at[0] != '\0'; scene_path_up(at))
        if (scene_reader_has(reader, at))
            return scene_reader_at(reader, at);
    return NULL;
}

int scene_reader_fail(const struct scene_reader *reader, const char *path, const char *format, ...)
{
    char text[SCENE_TEXT_SIZE];
    const struct scene_value *value = given_around(reader, path);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return scene_reader_say(reader, value != NULL ? value->set : NULL, value != NULL ? &value->place : &reader->start,
                            path, text);
}

int scene_reader_fail_item(const struct scene_reader *reader, const struct scene_field *field, int64_t item,
                           const char *part, const char *format, ...)
{
    char text[SCENE_TEXT_SIZE], path[SCENE_KEYS_SIZE] = "";
    const struct scene_value *value = scene_reader_at(reader, field->path);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    append(append(path, sizeof path, field->path), sizeof path, part);
    return scene_reader_say(reader, value->set, &value->items[item].place, path, text);
}
