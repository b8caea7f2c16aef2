/* SPDX-License-Identifier: BSD-3-Clause
 * The checks of a scene that concern several fields at once. */
#ifndef VTI_SCENE_CHECK_H
#define VTI_SCENE_CHECK_H

#include "scene.h"
#include "scene_reader.h"

/** Finds out what the values that were read amount to (arrangement, translates, turns and what is given), and whether
 *  they go together. What a table would have to say is left to whoever reads the table. Returns 0, or -1 with one line in
 *  the reader's message. */
int scene_check(const struct scene_reader *reader, struct scene *scene);

#endif
