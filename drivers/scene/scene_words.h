/* SPDX-License-Identifier: BSD-3-Clause
 * What messages about a scene say, problem and remedy: one wording whoever finds the problem. */
#ifndef VTI_SCENE_WORDS_H
#define VTI_SCENE_WORDS_H

#include "scene_place.h"

enum { SCENE_WORDS_SIZE = 512 };

#define SCENE_WORDS_NUMBER "write 0.01, 1e-3, 1/64 or 2^-6"

#define SCENE_WORDS_COUNT "write 80 or 1e5"

/** No such key in the section ("" is the whole scene). */
void scene_words_unknown(const char *section, const char *key, char text[SCENE_WORDS_SIZE]);

/** What stands at place is not of the shape that path calls for. */
void scene_words_shape(const char *path, const struct place *place, char text[SCENE_WORDS_SIZE]);

#endif
