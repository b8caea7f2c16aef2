/* SPDX-License-Identifier: BSD-3-Clause
 * From the words of a value to numbers. All return 0, or -1 with one line in the reader's message. */
#ifndef VTI_SCENE_NUMBER_H
#define VTI_SCENE_NUMBER_H

#include "scene.h"
#include "scene_reader.h"

int scene_number_read(const struct scene_reader *reader, const struct scene_field *field,
                      const struct scene_value *value, double *number);
int scene_number_vector(const struct scene_reader *reader, const struct scene_field *field,
                        const struct scene_value *value, double vector[3]);
/** One whole number, or three. */
int scene_number_counts(const struct scene_reader *reader, const struct scene_field *field,
                        const struct scene_value *value, int64_t *counts);
/** Normals are made unit vectors, and d is divided with them, so that the plane stays the one that is written. */
int scene_number_planes(const struct scene_reader *reader, const struct scene_field *field,
                        const struct scene_value *value, struct scene_planes *planes);

#endif
