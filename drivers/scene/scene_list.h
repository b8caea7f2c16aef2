/* SPDX-License-Identifier: BSD-3-Clause
 * What a scene may name, for people: the tables that scenes are read by. */
#ifndef VTI_SCENE_LIST_H
#define VTI_SCENE_LIST_H

#include <stdio.h>

#include "message.h"

/** Prints the steppers, the effects or the keys of scenes, one a line: name, tabulator, what it is. Returns 0, or -1
 *  with one line in *message if what is none of "steppers", "effects" and "keys". */
int scene_list(const char *what, FILE *file, struct message *message);

#endif
