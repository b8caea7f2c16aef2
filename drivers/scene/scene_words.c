/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_words.h"

#include <stdio.h>
#include <string.h>

#include "scene_field.h"

enum { LIST_SIZE = 320 };

void scene_words_unknown(const char *section, const char *key, char text[SCENE_WORDS_SIZE])
{
    char list[LIST_SIZE], shown[QUOTE_SIZE];
    scene_field_list(section, list, sizeof list);
    snprintf(text, SCENE_WORDS_SIZE, "unknown key '%s'; known %s%s: %s", quote(shown, sizeof shown, key),
             section[0] != '\0' ? "in " : "here", section, list);
}

/** What the place holds, as one can say it. */
static void write_found(const struct place *place, char found[2 * QUOTE_SIZE])
{
    if (place->kind == PLACE_VALUE)
        snprintf(found, 2 * QUOTE_SIZE, "'%s'", place->text);
    else if (place->kind == PLACE_LIST)
        snprintf(found, 2 * QUOTE_SIZE, "a list of %lu", (unsigned long)place->items);
    else
        snprintf(found, 2 * QUOTE_SIZE, "a section");
}

void scene_words_shape(const char *path, const struct place *place, char text[SCENE_WORDS_SIZE])
{
    char found[2 * QUOTE_SIZE], list[LIST_SIZE], field_path[PLACE_PATH];
    write_found(place, found);
    snprintf(field_path, sizeof field_path, "%s", path);
    const int in_list = strchr(path, '[') != NULL;
    field_path[strcspn(field_path, "[")] = '\0';
    const struct scene_field *field = scene_field_find(field_path);
    const enum scene_kind kind = field == NULL ? SCENE_SECTION : in_list ? SCENE_NUMBER : field->kind;
    if (kind == SCENE_SECTION)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a %s; write its keys, each on a line of its own: %s", found,
                 path[0] == '\0' ? "scene" : "section", scene_field_list(field_path, list, sizeof list));
    else if (kind == SCENE_VECTOR && place->kind == PLACE_LIST)
        snprintf(text, SCENE_WORDS_SIZE, "%lu values in a list of three numbers; write them as in [0, 0, 1]",
                 (unsigned long)place->items);
    else if (kind == SCENE_VECTOR)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a list of three numbers; write them as in [0, 0, 1]", found);
    else if (kind == SCENE_NUMBER)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a number; %s", found, SCENE_WORDS_NUMBER);
    else
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a word; write a single word", found);
}
