/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_stepper.h"

#include <string.h>

static const vti_stepper *(*admitted)(int64_t i);

void scene_stepper_admit(const vti_stepper *(*at)(int64_t i))
{
    admitted = at;
}

const vti_stepper *scene_stepper_at(int64_t i)
{
    const int64_t core = vti_stepper_count();
    if (i < core)
        return vti_stepper_at(i);
    return admitted != NULL ? admitted(i - core) : NULL;
}

const vti_stepper *scene_stepper_find(const char *name)
{
    const vti_stepper *stepper = NULL;
    for (int64_t i = 0; (stepper = scene_stepper_at(i)) != NULL && strcmp(stepper->name, name) != 0;)
        ++i;
    return stepper;
}
