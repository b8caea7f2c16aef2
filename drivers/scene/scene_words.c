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

/** The field that a path is, or is a part of; NULL for the scene as a whole. */
static const struct scene_field *field_around(const char *path)
{
    char field_path[PLACE_PATH];
    snprintf(field_path, sizeof field_path, "%s", path);
    field_path[strcspn(field_path, "[")] = '\0';
    return scene_field_find(field_path);
}

/** How many [index] steps a path has. */
static int count_indices(const char *path)
{
    int n = 0;
    for (const char *p = path; (p = strchr(p, '[')) != NULL; ++p)
        ++n;
    return n;
}

/** What belongs where a list of n numbers belongs. */
static void write_list(const char *what, const char *example, const struct place *place, const char *found,
                       char text[SCENE_WORDS_SIZE])
{
    if (place->kind == PLACE_LIST)
        snprintf(text, SCENE_WORDS_SIZE, "%lu values in a list of %s; write them as in %s", (unsigned long)place->items,
                 what, example);
    else
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a list of %s; write them as in %s", found, what, example);
}

static void write_planes(int indices, const struct place *place, const char *found, char text[SCENE_WORDS_SIZE])
{
    if (indices > 0)
        write_list("four numbers nx, ny, nz, d", "[1, 0, 0, 0]", place, found, text);
    else
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a list of planes; write them as in [[1, 0, 0, 0], [0, 1, 0, 0]]",
                 found);
}

void scene_words_shape(const char *path, const struct place *place, char text[SCENE_WORDS_SIZE])
{
    char found[2 * QUOTE_SIZE], list[LIST_SIZE];
    write_found(place, found);
    const struct scene_field *field = field_around(path);
    const int indices = count_indices(path);
    const enum scene_kind kind = field == NULL ? SCENE_SECTION : field->kind;
    if (kind == SCENE_SECTION)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a %s; write its keys, each on a line of its own: %s", found,
                 path[0] == '\0' ? "scene" : "section", scene_field_list(path, list, sizeof list));
    else if (kind == SCENE_PLANES && indices < 2)
        write_planes(indices, place, found, text);
    else if (kind == SCENE_VECTOR && indices < 1)
        write_list("three numbers", "[0, 0, 1]", place, found, text);
    else if (kind == SCENE_COUNTS && indices < 1)
        write_list("three whole numbers", "[4, 4, 4]", place, found, text);
    else if (kind == SCENE_COUNT || kind == SCENE_COUNTS)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a whole number; %s", found, SCENE_WORDS_COUNT);
    else if (kind == SCENE_NUMBER || indices > 0)
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a number; %s", found, SCENE_WORDS_NUMBER);
    else
        snprintf(text, SCENE_WORDS_SIZE, "%s is not a word; write a single word", found);
}
