/* SPDX-License-Identifier: BSD-3-Clause
 * What a run or a study is, as text: lines "key: value" of all that its result depends on. It resumes only as that. */
#ifndef VTI_IDENTITY_H
#define VTI_IDENTITY_H

#include <stdio.h>

#include "scene.h"

/** Writes the version of vti. */
void identity_version(FILE *text);

/** Writes what a scene means, whatever its file looks like: its values, and digests of the columns of its tables,
 *  wherever these lie. Lines begin with before; keys in without, which ends with NULL, are left out. */
void identity_scene(FILE *text, const char *before, const struct scene *scene, const char *const *without);

/** Whether the text that is there is the one here; if not, the first line that differs: "h: 0.01 there, 0.02 here". */
int identity_is(const char *there, size_t size, const char *here, struct message *difference);

/** Writes the line that what is kept at path is another run, or study, and returns -1. */
int identity_refuse(const char *path, const char *what, const struct message *difference, struct message *message);

#endif
