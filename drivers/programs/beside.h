/* SPDX-License-Identifier: BSD-3-Clause
 * Files that belong to the programs, found relative to the running program: in the build tree as when installed. */
#ifndef VTI_BESIDE_H
#define VTI_BESIDE_H

#include "message.h"

enum { BESIDE_PATH = 4096 };

/** The path of a shipped scene, "pendulum.yaml". Returns 0, or -1 if there is none. */
int beside_scene(const char *name, char path[BESIDE_PATH]);
/** Pictures: runs "vti-plot folder/name" and waits for it. Returns 0, or -1 with one line in *message. */
int pictures_draw(const char *folder, const char *name, struct message *message);

#endif
