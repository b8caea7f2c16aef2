/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_reader.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

enum { NAME_SIZE = 240, FILE_MAX = 1 << 20 };

/* ---- the file and the --set arguments ---------------------------------------------------------------------------- */

/** The whole file into bytes, which take one more than a scene may have. */
static int read_file(const struct scene_reader *reader, char *bytes, size_t *size)
{
    char problem[SCENE_TEXT_SIZE];
    errno = 0;
    FILE *file = fopen(reader->path, "rb");
    *size = file != NULL ? fread(bytes, 1, FILE_MAX + 1, file) : 0;
    const int failed = file == NULL || ferror(file), error = errno;
    if (file != NULL)
        fclose(file);
    if (!failed && *size <= FILE_MAX)
        return 0;
    snprintf(problem, sizeof problem, "cannot be read: %s; give the path of a scene file", strerror(error));
    return scene_reader_say(reader, NULL, NULL, "",
                            failed ? problem : "is larger than 1 MiB; a scene is short, is this the right file?");
}

int scene_text_read(const char *path, struct scene_text *text, struct message *message)
{
    const struct scene_reader reader = {.path = path, .message = message};
    char *bytes = malloc(FILE_MAX + 1);
    const int result = bytes == NULL ? scene_reader_say(&reader, NULL, NULL, "", "out of memory")
                                     : read_file(&reader, bytes, &text->size);
    if (result != 0)
        free(bytes);
    text->bytes = result == 0 ? bytes : NULL;
    return result;
}

void scene_text_destroy(struct scene_text *text)
{
    free(text->bytes);
    text->bytes = NULL;
}

static int is_option(const char *set)
{
    return strncmp(set, "--", 2) == 0;
}

static int load_set(struct scene_reader *reader, const char *set)
{
    char path[SCENE_KEYS_SIZE];
    const char *key = set + (is_option(set) ? 2 : 0), *equals = strchr(key, '=');
    const size_t n = equals != NULL ? (size_t)(equals - key) : 0;
    if (n == 0 || n >= sizeof path)
        return scene_reader_say(reader, set, NULL, "", "is not path=value; write h=1e-3 or bodies.omega=[0,0,1], say");
    memcpy(path, key, n);
    path[n] = '\0';
    for (char *at = path; is_option(set) && *at != '\0'; ++at)
        *at = *at == '-' ? '_' : *at;
    const char *text = equals + 1;
    if (text[strspn(text, " \t")] == '\0')
        text = "''"; /* nothing at all is an empty text, as it is in the file */
    return scene_load(reader, set, path, text, strlen(text));
}

int scene_reader_open(struct scene_reader *reader, const char *path, const struct scene_text *text,
                      const char *const *sets, int n, struct message *message)
{
    size_t rows = 0;
    while (scene_field_at((int)rows) != NULL)
        ++rows;
    memset(reader, 0, sizeof *reader);
    reader->path = path;
    reader->message = message;
    reader->values = calloc(rows, sizeof *reader->values);
    if (reader->values == NULL)
        return scene_reader_say(reader, NULL, NULL, "", "out of memory");
    int result = scene_load(reader, NULL, "", text->bytes, text->size);
    for (int k = 0; k < n && result == 0; ++k)
        result = load_set(reader, sets[k]);
    return result;
}

void scene_reader_clear(struct scene_value *value)
{
    for (int64_t k = 0; k < value->count; ++k)
        free(value->items[k].text);
    free(value->items);
    memset(value, 0, sizeof *value);
}

void scene_reader_close(struct scene_reader *reader)
{
    for (int k = 0; reader->values != NULL && scene_field_at(k) != NULL; ++k)
        scene_reader_clear(&reader->values[k]);
    free(reader->values);
}

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
        return message_set(reader->message, "%s%s%s%s: %s", is_option(set) ? "" : "--set ",
                           quote(name, sizeof name, set), colon, shown, text);
    if (place != NULL)
        snprintf(lines, sizeof lines, ":%lu:%lu", (unsigned long)place->line, (unsigned long)place->column);
    return message_set(reader->message, "%s%s%s%s: %s", quote_tail(name, sizeof name, reader->path), lines, colon,
                       shown, text);
}

/** The innermost of the value at path and the sections around it that is given; NULL if none is. */
static const struct scene_value *given_around(const struct scene_reader *reader, const char *path)
{
    char at[SCENE_KEYS_SIZE] = "";
    quote_append(at, sizeof at, path);
    for (; at[0] != '\0'; scene_path_up(at))
        if (scene_reader_has(reader, at))
            return scene_reader_at(reader, at);
    return NULL;
}

int scene_reader_fail(const struct scene_reader *reader, const char *path, const char *format, ...)
{
    struct message said;
    const struct scene_value *value = given_around(reader, path);
    const struct place start = reader->start;
    va_list arguments;
    va_start(arguments, format);
    message_set_list(&said, format, arguments);
    va_end(arguments);
    if (value != NULL)
        return scene_reader_say(reader, value->set, &value->place, path, said.text);
    return scene_reader_say(reader, NULL, &start, path, said.text);
}

int scene_reader_fail_item(const struct scene_reader *reader, const struct scene_field *field, int64_t item,
                           const char *part, const char *format, ...)
{
    struct message said;
    char path[SCENE_KEYS_SIZE] = "";
    const struct scene_value *value = scene_reader_at(reader, field->path);
    va_list arguments;
    va_start(arguments, format);
    message_set_list(&said, format, arguments);
    va_end(arguments);
    quote_append(quote_append(path, sizeof path, field->path), sizeof path, part);
    return scene_reader_say(reader, value->set, &value->items[item].place, path, said.text);
}
