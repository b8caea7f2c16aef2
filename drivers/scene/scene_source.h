/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A YAML text that a scene is made of: the file, or the value of one --set; how it is loaded with libcyaml, and how
 * messages name a place in it. */
#ifndef VTI_SCENE_SOURCE_H
#define VTI_SCENE_SOURCE_H

#include "scene_place.h"
#include "scene_schema.h"

struct scene_source {
    const char *name;      /* the file, or what followed --set */
    int is_set;            /* from --set: has no lines */
    char path[PLACE_PATH]; /* of the value that text holds; "" for the file, which holds the whole scene */
    char *text;
    size_t size;
};

/** The longest scene file, in bytes. */
enum { SCENE_SOURCE_MAX = 1 << 20 };

/** Reads a file. Returns 0, or -1 with one line in *message; text is from malloc. */
int scene_source_file(const char *path, struct scene_source *source, struct message *message);

/** Takes "path=value" apart. Does not look whether the path is known. Returns and allocates likewise. */
int scene_source_set(const char *argument, struct scene_source *source, struct message *message);

/** Loads the text with the schema of its value. Returns 0 and what scene_source_free must free, a NULL value if the text
 *  is an empty section; or -1 with one line in *message. */
int scene_source_load(const struct scene_source *source, const cyaml_schema_value_t *schema, struct scene_slot *slot,
                      struct message *message);

void scene_source_free(const cyaml_schema_value_t *schema, struct scene_slot *slot);

/** Writes the line "PLACE: PATH: TEXT" and returns -1. A NULL place is the source as a whole. */
int scene_source_fail(const struct scene_source *source, const struct place *place, const char *path, const char *text,
                      struct message *message);

#endif
