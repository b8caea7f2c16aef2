/* SPDX-License-Identifier: BSD-3-Clause
 * From words to struct scene: value by value, and the checks that concern several at once. */
#ifndef VTI_SCENE_VALUE_H
#define VTI_SCENE_VALUE_H

#include "scene.h"
#include "scene_reader.h"

/** Converts the field's value, checks its range and writes it to the field's place in *scene; a field that is not given
 *  is left alone. Returns 0, or -1 with one line in the reader's message. */
int scene_value_read(const struct scene_reader *reader, const struct scene_field *field, struct scene *scene);

/** The same for the name of the scene; whose says in a message where it comes from, if not from the field. */
int scene_value_name(const struct scene_reader *reader, const char *name, const char *whose, char out[64]);

/** Finds out what the values that were read amount to (arrangement, translates, turns and what is given), and whether
 *  they go together. What a table would have to say is left to whoever reads the table. Returns 0, or -1 with one line
 *  in the reader's message. */
int scene_check(const struct scene_reader *reader, struct scene *scene);

#endif
