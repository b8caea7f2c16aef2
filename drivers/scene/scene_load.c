/* SPDX-License-Identifier: BSD-3-Clause
 *
 * libcyaml reads a source by the schema and tells what does not fit in log lines, innermost part first:
 *
 *     Load: Expecting STRING, got event: SEQUENCE_START
 *     Load: Backtrace:
 *       in sequence entry '2' (line: 2, column: 13)
 *       in mapping field 'omega' (line: 2, column: 10)
 *       in mapping field 'bodies' (line: 2, column: 3)
 *
 * Path and key are taken from them, the place from libyaml (scene_place.h), because libcyaml has none for a key. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_source.h"
#include "scene_words.h"

/* ---- what libcyaml says ------------------------------------------------------------------------------------------ */

struct report {
    char key[2 * QUOTE_SIZE]; /* that it did not expect */
    int is_duplicate;
    char path[PLACE_PATH]; /* inside the source */
};

/** Puts one step in front of the path. */
static void prepend(struct report *report, const char *key, size_t item)
{
    char rest[PLACE_PATH];
    memcpy(rest, report->path, sizeof rest);
    report->path[0] = '\0';
    if (key != NULL)
        place_append_key(report->path, key);
    else
        place_append_item(report->path, item);
    place_join(report->path, rest);
}

static const char *behind(const char *line, const char *start)
{
    const size_t n = strlen(start);
    return strncmp(line, start, n) == 0 ? line + n : NULL;
}

static void collect(cyaml_log_t level, void *context, const char *format, va_list arguments)
{
    struct report *report = context;
    char line[512];
    const char *rest;
    (void)level;
    vsnprintf(line, sizeof line, format, arguments);
    line[strcspn(line, "\n")] = '\0'; /* no key has a line break inside: see place_check */
    if ((rest = behind(line, "Load: Unexpected key: ")) != NULL) {
        quote(report->key, sizeof report->key, rest);
    } else if (behind(line, "Load: Mapping field already seen: ") != NULL) {
        report->is_duplicate = 1;
    } else if ((rest = behind(line, "  in sequence entry '")) != NULL) {
        prepend(report, NULL, (size_t)strtoul(rest, NULL, 10) - 1);
    } else if ((rest = behind(line, "  in mapping field '")) != NULL) {
        char *end = strstr(line, "' (line: ");
        if (end != NULL)
            *end = '\0';
        prepend(report, rest, 0);
    }
}

static cyaml_config_t config_with(struct report *report)
{
    const cyaml_config_t config = {.log_fn = report != NULL ? collect : NULL,
                                   .log_ctx = report,
                                   .mem_fn = cyaml_mem,
                                   .log_level = CYAML_LOG_ERROR,
                                   .flags = CYAML_CFG_NO_ALIAS};
    return config;
}

void scene_source_free(const cyaml_schema_value_t *schema, struct scene_slot *slot)
{
    const cyaml_config_t config = config_with(NULL);
    cyaml_free(&config, schema, slot->value, (unsigned)slot->items);
    slot->value = NULL;
    slot->items = 0;
}

/* ---- what the user is told --------------------------------------------------------------------------------------- */

/** The path in the scene of a path in the source. */
static void whole_path(const struct scene_source *source, const char *inside, char path[PLACE_PATH])
{
    memcpy(path, source->path, PLACE_PATH);
    place_join(path, inside);
}

static int fail_at(const struct scene_source *source, struct report *report, int occurrence, const char *text,
                   struct message *message)
{
    char path[PLACE_PATH];
    struct place place;
    const int found = place_find(source->text, source->size, report->path, occurrence, &place) == 0;
    if (occurrence > 1 || report->key[0] != '\0') {
        place.line = place.key_line;
        place.column = place.key_column;
    }
    whole_path(source, report->path, path);
    return scene_source_fail(source, found ? &place : NULL, path, text, message);
}

static int fail_unknown(const struct scene_source *source, struct report *report, struct message *message)
{
    char text[SCENE_WORDS_SIZE], section[PLACE_PATH];
    whole_path(source, report->path, section);
    scene_words_unknown(section, report->key, text);
    place_append_key(report->path, report->key);
    return fail_at(source, report, 1, text, message);
}

static int fail_duplicate(const struct scene_source *source, struct report *report, struct message *message)
{
    char text[SCENE_WORDS_SIZE];
    struct place first;
    place_find(source->text, source->size, report->path, 1, &first);
    snprintf(text, sizeof text, "given a second time, first on line %lu; keep one of them",
             (unsigned long)first.key_line);
    return fail_at(source, report, 2, text, message);
}

/** A list where a number belongs, two numbers where three do, and the like. */
static int fail_shape(const struct scene_source *source, struct report *report, cyaml_err_t error,
                      struct message *message)
{
    char text[SCENE_WORDS_SIZE], path[PLACE_PATH];
    struct place place;
    if (error != CYAML_ERR_INVALID_VALUE && strchr(report->path, '[') != NULL)
        scene_path_up(report->path); /* too few or too many items: the list, not its last item, is to blame */
    if (place_find(source->text, source->size, report->path, 1, &place) != 0)
        return scene_source_fail(source, NULL, report->path, cyaml_strerror(error), message);
    whole_path(source, report->path, path);
    scene_words_shape(path, &place, text);
    return fail_at(source, report, 1, text, message);
}

static int fail(const struct scene_source *source, struct report *report, cyaml_err_t error, struct message *message)
{
    if (report->key[0] != '\0' || error == CYAML_ERR_INVALID_KEY)
        return fail_unknown(source, report, message);
    if (report->is_duplicate)
        return fail_duplicate(source, report, message);
    if (error == CYAML_ERR_INVALID_VALUE || error == CYAML_ERR_SEQUENCE_ENTRIES_MIN ||
        error == CYAML_ERR_SEQUENCE_ENTRIES_MAX || error == CYAML_ERR_SEQUENCE_FIXED_COUNT)
        return fail_shape(source, report, error, message);
    return fail_at(source, report, 1, cyaml_strerror(error), message);
}

int scene_source_load(const struct scene_source *source, const cyaml_schema_value_t *schema, struct scene_slot *slot,
                      struct message *message)
{
    struct place place;
    struct message problem;
    struct report report = {"", 0, ""};
    const cyaml_config_t config = config_with(&report);
    unsigned items = 0;
    slot->value = NULL;
    if (place_check(source->text, source->size, &place, &problem) != 0)
        return scene_source_fail(source, &place, source->path, problem.text, message);
    const cyaml_err_t error =
        cyaml_load_data((const uint8_t *)source->text, source->size, &config, schema, &slot->value,
                        schema->type == CYAML_SEQUENCE ? &items : NULL); /* which libcyaml wants for no other type */
    slot->items = items;
    return error == CYAML_OK ? 0 : fail(source, &report, error, message);
}
