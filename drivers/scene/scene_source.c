/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_SIZE = 240 };

int scene_source_fail(const struct scene_source *source, const struct place *place, const char *path, const char *text,
                      struct message *message)
{
    char name[NAME_SIZE], shown[2 * QUOTE_SIZE], lines[48] = "";
    const char *colon = path[0] != '\0' ? ": " : "";
    quote(shown, sizeof shown, path);
    if (source->is_set)
        return message_set(message, "--set %s%s%s: %s", quote(name, sizeof name, source->name), colon, shown, text);
    if (place != NULL)
        snprintf(lines, sizeof lines, ":%lu:%lu", (unsigned long)place->line, (unsigned long)place->column);
    return message_set(message, "%s%s%s%s: %s", quote_tail(name, sizeof name, source->name), lines, colon, shown, text);
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

static int unreadable(const struct scene_source *source, int error, struct message *message)
{
    char text[256];
    snprintf(text, sizeof text, "cannot be read: %s; give the path of a scene file", strerror(error));
    return scene_source_fail(source, NULL, "", text, message);
}

/** The whole file, into memory that doubles until the file ends or is too large for a scene. */
static int read_all(FILE *file, struct scene_source *source, struct message *message)
{
    for (size_t capacity = 4096;; capacity *= 2) {
        char *larger = realloc(source->text, capacity);
        if (larger == NULL)
            return unreadable(source, ENOMEM, message);
        source->text = larger;
        errno = 0;
        source->size += fread(larger + source->size, 1, capacity - source->size, file);
        if (ferror(file))
            return unreadable(source, errno, message);
        if (source->size > SCENE_SOURCE_MAX)
            return scene_source_fail(source, NULL, "",
                                     "is larger than 1 MiB; a scene is short, is this the right file?", message);
        if (source->size < capacity)
            return 0;
    }
}

int scene_source_file(const char *path, struct scene_source *source, struct message *message)
{
    memset(source, 0, sizeof *source);
    source->name = path;
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return unreadable(source, errno, message);
    const int result = read_all(file, source, message);
    fclose(file);
    if (result != 0) {
        free(source->text);
        source->text = NULL;
    }
    return result;
}

/* ---- --set ------------------------------------------------------------------------------------------------------- */

int scene_source_set(const char *argument, struct scene_source *source, struct message *message)
{
    memset(source, 0, sizeof *source);
    source->name = argument;
    source->is_set = 1;
    const char *equals = strchr(argument, '=');
    const size_t n = equals != NULL ? (size_t)(equals - argument) : 0;
    if (n == 0 || n >= PLACE_PATH)
        return scene_source_fail(source, NULL, "", "is not path=value; write h=1e-3 or bodies.omega=[0,0,1], say",
                                 message);
    memcpy(source->path, argument, n);
    const char *value = equals + 1;
    if (value[strspn(value, " \t")] == '\0')
        value = "''"; /* nothing at all is an empty text, as it is in the file */
    source->size = strlen(value);
    source->text = malloc(source->size + 1);
    if (source->text == NULL)
        return scene_source_fail(source, NULL, "", "out of memory", message);
    memcpy(source->text, value, source->size + 1);
    return 0;
}
