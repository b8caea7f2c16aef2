/* SPDX-License-Identifier: BSD-3-Clause
 * From the text of a value to numbers: one, three, whole ones, planes. All return 0, or -1 with one line in the reader's
 * message. */
#ifndef VTI_SCENE_NUMBER_H
#define VTI_SCENE_NUMBER_H

#include "scene.h"
#include "scene_reader.h"

int scene_number_read(const struct scene_reader *reader, const struct scene_field *field, const char *text,
                      double *number);
int scene_number_vector(const struct scene_reader *reader, const struct scene_field *field, char *const text[3],
                        double vector[3]);
/** path is that of the value in messages, which may be a part of the field. */
int scene_number_count(const struct scene_reader *reader, const struct scene_field *field, const char *path,
                       const char *text, int64_t *count);
int scene_number_counts(const struct scene_reader *reader, const struct scene_field *field, char *const text[3],
                        int64_t counts[3]);
/** Normals are made unit vectors, and d is divided with them, so that the plane stays the one that is written. */
int scene_number_planes(const struct scene_reader *reader, const struct scene_field *field, char *const *const *rows,
                        struct scene_planes *planes);

#endif
