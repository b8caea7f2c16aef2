/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Clumps of a scene (EQUATIONS 7.5): bodies that move as one solid and are several spheres to contacts and walls. Their
 * templates are weighed, and each body gets the spheres of its own. */
#ifndef VTI_CLUMPS_H
#define VTI_CLUMPS_H

#include "scene.h"

struct table;
struct tables;

/** A template: spheres of the scene's list, and the solid that they make, of density 1. */
struct clump_template {
    int64_t first, count;
    vti_solid solid;
};

struct clumps {
    vti_clumps list;                 /* of all bodies; count 0 where bodies are no clumps */
    vti_scalars diameter;            /* of the spheres */
    vti_scalars modulus;             /* E/(1 - nu^2) of the spheres; p = NULL if bodies have none */
    struct clump_template *template; /* [scene_templates] */
    int64_t *body;                   /* memory of list.body, and of all doubles */
    double *memory;
};

/** Weighs the templates of a scene with clumps. Returns 0, or -1 with one line in *message; clumps_destroy follows in
 *  either case. */
int clumps_weigh(struct clumps *clumps, const struct scene *scene, struct message *message);
/** The template of body i: the table has it, or templates take turns. */
const struct clump_template *clumps_template(const struct clumps *clumps, const struct scene *scene,
                                             const struct table *bodies, int64_t i);
/** Whether each template is a single sphere: then the bodies are spheres, with one moment of inertia. */
int clumps_are_spheres(const struct clumps *clumps, const struct scene *scene);
/** A, B, C of a body of the template and of that mass; of a single sphere those of a solid one, to the bit. */
void clumps_moments(const struct clump_template *of, const struct scene *scene, double mass, double moments[3]);

/** Makes the spheres of all bodies, with the views that the scene's effects on spheres read and load. bodies have
 *  masses and an inertia; modulus is theirs. Returns 0, or -1 with one line in *message. */
int clumps_place(struct clumps *clumps, const struct scene *scene, const struct tables *tables,
                 const vti_bodies *bodies, const vti_scalars *modulus, struct message *message);

/** Harmless for one that is all zeros. */
void clumps_destroy(struct clumps *clumps);

#endif
