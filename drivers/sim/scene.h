/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene: the bodies, the effects it calls for and how to step them, as numbers. A section that the file lacks is an
 * effect that does not exist; a body without x and v does not translate, one without alpha and omega does not turn. */
#ifndef VTI_SCENE_H
#define VTI_SCENE_H

#include "message.h"
#include "vti.h"

struct scene {
    char name[64];
    int translates; /* x and v are given */
    int turns;      /* alpha and omega are given */
    double mass, inertia;
    double x[3], v[3], alpha[3], omega[3];
    int has_pendulum;
    vti_pendulum pendulum;
    const vti_stepper *stepper;
    double h, t_end;
};

/** Reads and checks the YAML file at path; overrides are "path.to.key=value" strings that replace or add values before the check
 *  (n of them). Returns 0, or -1 with one line in *message such as
 *  "pendulum.yaml:5:12: bodies.inertia: 'two' is not a number; write 0.01, 1e-3, 1/64 or 2^-6". */
int scene_read(const char *path, const char *const *overrides, int n, struct scene *scene, struct message *message);

#endif
