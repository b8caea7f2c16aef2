/* SPDX-License-Identifier: BSD-3-Clause
 * The steppers that scenes may name: the core's, and those that a program admits. */
#ifndef VTI_SCENE_STEPPER_H
#define VTI_SCENE_STEPPER_H

#include "vti.h"

/** Lets scenes name the steppers at(0), at(1), ... up to the first NULL too. To be called before the first scene is
 *  read. */
void scene_stepper_admit(const vti_stepper *(*at)(int64_t i));

/** Stepper i of all; NULL behind the last. */
const vti_stepper *scene_stepper_at(int64_t i);
/** NULL if there is none of that name. */
const vti_stepper *scene_stepper_find(const char *name);

#endif
