/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene: the bodies, the effects it calls for and how to step them, as numbers. A section that the file lacks is an
 * effect that does not exist; a body without x and v does not translate, one without alpha and omega does not turn.
 * What a scene file may hold is the table in scene_field.c. */
#ifndef VTI_SCENE_H
#define VTI_SCENE_H

#include "message.h"
#include "vti.h"

struct scene {
    char name[64];  /* letters, digits, _ and -; of the file, up to its last dot, if the scene has none */
    int translates; /* x and v are given */
    int turns;      /* alpha and omega are given */
    double mass, inertia;
    double x[3], v[3], alpha[3], omega[3];
    int has_pendulum;
    vti_pendulum pendulum;
    const vti_stepper *stepper; /* "vti2" if the file has none; moments are in space */
    double h, t_end;
};

/** Reads and checks the YAML file at path. overrides are n "path.to.key=value" strings, as they follow --set; they
 *  replace or add single values before the check, the later one counts, and a value is written as in the file ("[0, 0,
 *  1]", "1/64"). Anchors are passed over, aliases refused. Returns 0, or -1 with one line in *message such as
 *  "pendulum.yaml:6:12: bodies.inertia: 'two' is not a number; write 0.01, 1e-3, 1/64 or 2^-6", where a value that came
 *  from an override is placed by "--set path=value" instead of file, line and column. *scene needs no freeing. */
int scene_read(const char *path, const char *const *overrides, int n, struct scene *scene, struct message *message);

#endif
