/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where things stand in a YAML text, told by libyaml's events: line and column of the value at a path such as
 * "bodies.omega[1]". Nothing is stored; each question reads the text again, since only a message asks. */
#ifndef VTI_SCENE_PLACE_H
#define VTI_SCENE_PLACE_H

#include <stddef.h>

#include "message.h"
#include "quote.h"

enum { PLACE_PATH = 256, PLACE_DEPTH = 16 };

enum place_kind { PLACE_VALUE, PLACE_LIST, PLACE_SECTION };

struct place {
    size_t line, column;         /* of the value, counted from 1 */
    size_t key_line, key_column; /* of its key; of the value if it has none */
    enum place_kind kind;
    size_t items;          /* of a list */
    char text[QUOTE_SIZE]; /* of a single value, fit to be shown */
};

/** Refuses what no scene may be, whatever its keys: text that is not YAML, no document or several, aliases, keys that
 *  are not words, line breaks or control characters inside a value, nesting deeper than PLACE_DEPTH. Returns 0, or -1
 *  with the place and one clause that says what is wrong and what to do. */
int place_check(const char *text, size_t size, struct place *place, struct message *problem);

/** Finds the value at path, "" being the whole text; if a key is given several times, its occurrence of that number,
 *  counted from 1. Returns 0, or -1 if there is none. */
int place_find(const char *text, size_t size, const char *path, int occurrence, struct place *place);

/** Appends one step to a path, as the two functions above write it. */
void place_append_key(char path[PLACE_PATH], const char *key);
void place_append_item(char path[PLACE_PATH], size_t index);
/** Appends a path inside the value at path. What does not fit into a path is dropped. */
void place_join(char path[PLACE_PATH], const char *inside);

#endif
