/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A model: a scene turned into what the core steps, bodies and an array of effects. What the scene does not name is not
 * in it. */
#ifndef VTI_MODEL_H
#define VTI_MODEL_H

#include "scene.h"

enum { MODEL_EFFECTS = 8, MODEL_INVARIANTS = 8 };

struct model {
    const struct scene *scene; /* must outlive the model */
    vti_bodies bodies;
    vti_effect effects[MODEL_EFFECTS];
    int64_t effects_count;
    double *memory;
};

/** Makes the model of *scene at t = 0, forces and moments included. Returns 0, or -1 with one line in *message. */
int model_create(const struct scene *scene, struct model *model, struct message *message);
void model_destroy(struct model *model);

/** Forces and moments of all effects at the bodies' positions. bodies may be any with the model's views. */
int model_forces(const struct model *model, const vti_bodies *bodies);
double model_energy(const struct model *model, const vti_bodies *bodies);

/* ---- what the continuous motion conserves besides the energy --------------------------------------------------------- */

/** One conserved number of the scene. */
struct invariant {
    const char *name;  /* as in files */
    const char *label; /* as in pictures, mathtext */
    int is_momentum;   /* counts in the momentum error */
};

/** The scene's invariants, in a fixed order; returns how many (at most MODEL_INVARIANTS). */
int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS]);
/** Their values for the bodies, in the same order. */
void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS]);

#endif
