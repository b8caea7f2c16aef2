/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A model: a scene turned into what the core steps, bodies and an array of effects. What the scene does not name is not
 * in it: no view, no array, no effect. */
#ifndef VTI_MODEL_H
#define VTI_MODEL_H

#include "neighbours.h"
#include "scene.h"

enum { MODEL_EFFECTS = 8, MODEL_INVARIANTS = 8 };

/** Among the statuses of the core: the pairs in contact could not be found; model->trouble says why. */
enum { MODEL_E_PAIRS = -1000 };

/** Effects stand in the order binder, contact, wall, gravity, pendulum, of those that there are. The model points into
 *  itself and must not be moved or copied. */
struct model {
    const struct scene *scene; /* must outlive the model */
    int translates, turns;     /* as views say: x and v, alpha and omega */
    vti_bodies bodies;
    vti_scalars diameter; /* p = NULL if neither scene nor table gives any */
    vti_effect effects[MODEL_EFFECTS];
    int64_t effects_count;

    vti_bonds bonds;              /* count 0 without binder */
    vti_contacts contacts;        /* its list is that of neighbours, as of the last update */
    vti_walls walls;              /* count 0 without wall */
    struct neighbours neighbours; /* all zeros without contact */

    double mass, inertia, sphere; /* of all bodies, where no table says more; sphere is the diameter */
    double *memory;               /* of the bodies */
    double *bond_memory;          /* rest vectors and stiffnesses */
    int64_t *bond_pairs;
    struct message trouble;
};

/** Makes the model of *scene at t = 0, forces and moments included. Returns 0, or -1 with one line in *message. */
int model_create(const struct scene *scene, struct model *model, struct message *message);
void model_destroy(struct model *model);

/** Brings the list of contacts up to the bodies' positions, if the scene has contacts; bodies may be any with the model's
 *  views, or a quaternion view for alpha. Returns VTI_OK or MODEL_E_PAIRS. The effects' energies are right for the bodies
 *  of the last call; model_forces and model_energy make it themselves. */
int model_find_pairs(struct model *model, const vti_bodies *bodies);

/** Forces and moments of all effects at the bodies' positions. Returns VTI_OK or a status that model_text explains. */
int model_forces(struct model *model, const vti_bodies *bodies);
/** Kinetic energies and all energies of the effects; NaN if the contacts cannot be found. */
double model_energy(struct model *model, const vti_bodies *bodies);
/** One sentence for a status of model_forces. */
const char *model_text(const struct model *model, int status);

/** The largest overlap to reckon with, as a share of D: that at which a contact has taken up the energy that bodies bring
 *  into it, 2/5 K o^{5/2} = e. e is twice the largest kinetic energy of a body (two of them may meet) and the work of
 *  gravity on a body's way to the first plane below it, for the body of which the sum is largest. It is an estimate: what
 *  pushes from behind, as in a pile, is not in it. 0 without contact and wall, at most 1. */
double model_overlap(const struct model *model);
/** The rigorous stable step of the model as it stands (vti_stable_step), with contacts at *overlap: every pair of the list
 *  of contacts and every body at every plane counts as touching. Infinite if nothing oscillates. Returns 0, or -1 with one
 *  line in *message. */
int model_stable_step(const struct model *model, double overlap, double *h, struct message *message);

/* ---- what the continuous motion conserves besides the energy --------------------------------------------------------- */

/** One conserved number of the scene. */
struct invariant {
    const char *name;  /* as in files */
    const char *label; /* as in pictures, mathtext */
    int is_momentum;   /* counts in the momentum error */
};

/** The scene's invariants, in a fixed order: components of linear and of angular momentum that every effect keeps; of those
 *  angular ones that some effect breaks, the component of the spin, sum J Omega, if every effect keeps that. Returns how many
 *  (at most MODEL_INVARIANTS). */
int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS]);
/** Their values for the bodies, in the same order. */
void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS]);

#endif
