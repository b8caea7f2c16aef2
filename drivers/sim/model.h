/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A model: a scene turned into what the core steps, bodies and an array of effects. What the scene does not name is not
 * in it: no view, no array, no effect. */
#ifndef VTI_MODEL_H
#define VTI_MODEL_H

#include <stddef.h>

#include "clumps.h"
#include "kind.h"
#include "scene.h"

enum { MODEL_EFFECTS = EFFECT_COUNT, MODEL_INVARIANTS = 8 };

/** Among the statuses of the core: the pairs of an effect could not be found; model->trouble says why. */
enum { MODEL_E_PAIRS = -1000 };

struct slices;      /* slices.h */
struct step_errors; /* step_errors.h */

/** Effects stand in the order of effects/kinds.h, of those that there are. The model points into itself and must not be
 *  moved or copied. */
struct model {
    const struct scene *scene; /* must outlive the model */
    int translates, turns;     /* as views say: x and v, alpha and omega (with spin, where there are moments) */
    vti_bodies bodies;
    struct clumps clumps; /* their spheres, where they are clumps */
    vti_scalars diameter; /* of the spheres (model_spheres); p = NULL if neither scene nor table gives any */
    vti_scalars modulus;  /* E/(1 - nu^2) of each; p = NULL if the table gives none */
    vti_effect effects[MODEL_EFFECTS]; /* what each does to the bodies */
    int64_t effects_count;
    vti_effect acting[MODEL_EFFECTS];       /* effect k as it acts: effects[k], or the same on the spheres of clumps */
    int on_spheres[MODEL_EFFECTS];          /* whether effect k acts on these */
    vti_clumped clumped[MODEL_EFFECTS];     /* makes effects[k] of acting[k] there */
    struct effect instances[MODEL_EFFECTS]; /* settings and memory of effects[k], which only its own file knows */
    int64_t instances_count;                /* effects_count; 0 where effects are not those of a scene */
    int seeks;                              /* pairs are to be found, or spheres follow their clumps */

    double mass, inertia, sphere;    /* of all bodies, where no table says more; sphere is the diameter */
    double moments[3], principal[4]; /* of all bodies, where they are no spheres */
    double *memory;                  /* of the bodies */
    const int64_t *number;           /* [bodies] as people know them, the tables'; NULL: as they are */
    double owed;                     /* time of the kick that v and Omega still lack (loop.h, looks); 0: none */
    struct message trouble;
    struct slices *slices;      /* of the bodies, for threads; NULL: all in one piece */
    struct step_errors *errors; /* of its steps, the model's own; NULL: nobody asks for them */
};

/** Whether its bodies are clumps. */
static inline int model_has_clumps(const struct model *model)
{
    return model->clumps.list.count > 0;
}

/** The number of body i in the scene's tables. */
static inline int64_t model_number(const struct model *model, int64_t i)
{
    return model->number != NULL && i >= 0 ? model->number[i] : i;
}

/** Makes the model of *scene at t = 0, forces and moments included. Returns 0, or -1 with one line in *message. */
int model_create(const struct scene *scene, struct model *model, struct message *message);
void model_destroy(struct model *model);

/** What has surfaces: the spheres of clumps, as of the last model_find_pairs, or else the bodies. */
const vti_bodies *model_spheres(const struct model *model);
/** What touches, of all effects that have surfaces. */
struct effect_surfaces model_surfaces(const struct model *model);
/** The effects' loads on the bodies of a slice and, where these are clumps, on their spheres, which have been put where
 *  they are; each effect k as acting[k]. Returns VTI_OK or a status. */
int model_apply(const struct model *model, const vti_effect *acting, const vti_bodies *bodies,
                const vti_bodies *spheres);

/** Brings the lists of pairs up to the bodies' positions, of effects that have one; bodies may be any with the model's
 *  views, or a quaternion view for alpha. Returns VTI_OK or MODEL_E_PAIRS. The effects' energies are right for the
 *  bodies of the last call; model_forces and model_energy make it themselves. */
int model_find_pairs(struct model *model, const vti_bodies *bodies);

/** Forces and moments of all effects at the bodies' positions. Returns VTI_OK or a status that model_text explains. */
int model_forces(struct model *model, const vti_bodies *bodies);
/** Kinetic energies and all energies of the effects; NaN if the pairs cannot be found. */
double model_energy(struct model *model, const vti_bodies *bodies);
/** That of the model's bodies, for shares of it: 0 where it is nothing but what rounding leaves of its terms. */
double model_energy0(struct model *model);
/** The first effect that flows, carries, breaks or dissipates; NULL if none does. Steps of such a model are those of
 *  vti_effects_begin. */
const vti_effect *model_dissipates(const struct model *model);

/** Whether bodies turn otherwise than freely, so that attitudes tell what steps err by: elastic touches of spheres
 *  without friction leave Omega as it is, and attitudes exact, whatever they do to positions. */
int model_twists(const struct model *model);

/** Whether nothing pushes or turns the bodies, and a medium slows their ways: velocities are exact then, whatever the
 *  step, and positions tell what steps err by. */
int model_only_slows(const struct model *model);

/** Whether something in it may break. */
int model_breaks(const struct model *model);

/** Returns 0 if the bodies are spheres, as the method named what requires; else -1 with one line in *message, of which
 *  remedy is the end. */
int model_of_spheres(const struct model *model, const char *what, const char *remedy, struct message *message);

/** What breaks at the end of the step, at t, and what bonds are made then; where something is, forces are evaluated
 *  anew. Returns VTI_OK or a status that model_text explains. */
int model_rupture(struct model *model, int64_t step, double t);

/** What the effects keep beside the bodies, booked energies and what they remember, for a run that goes on with the
 *  same bits: how many doubles, and the doubles. */
int64_t model_memory_size(const struct model *model);
void model_memory_get(const struct model *model, double *memory);
/** Returns 0, or -1 if so many are not those of this model. */
int model_memory_put(struct model *model, const double *memory, int64_t size);

/** Entries of booked energy that are kept of each body (scene.by_body), in the order of the effects; their names go to
 *  name. Returns how many: 0 where nobody asks, or nothing is booked. */
int64_t model_body_books(const struct model *model, const char *name[EFFECT_TERMS_OF_ALL]);
/** value[bodies] of entry k, of clumps the sum over the spheres; body i stands at number[i], unless that is NULL. */
void model_body_booked(const struct model *model, int64_t k, const int64_t *number, double *value);

/** One sentence for a status of model_forces. */
const char *model_text(const struct model *model, int status);

/** Inverse effective mass: the velocity that a unit impulse gives a body where it acts, at most. */
struct model_inverse_mass {
    double per_mass, per_inertia; /* 1/m, and 1/J by the smallest moment; 0 of what it has not */
    double by_turning;            /* of an impulse at the centre of a sphere of a clump: its part by the clump's turn */
};
/** Of sphere k of clumps; of body k without of_spheres, or where there are no clumps. */
struct model_inverse_mass model_inverse_mass_of(const struct model *model, int of_spheres, int64_t k);
/** That of an impulse that acts an arm from the centre, across it. */
double model_inverse_mass_at(const struct model_inverse_mass *inverse, double arm);

/** How far bodies may get from rest by the energy that they have: an estimate, since what pushes from behind, as in a
 *  pile or a fragment that bonds hold together, is not in it, nor what a medium or spin brings. e is twice the largest
 *  kinetic energy of a body (two of them may meet), without that of the motion of the whole if there are no walls, and
 *  the work of the field on a body's way to the first wall below it, for the body of which the sum is largest, and
 *  twice what one spring holds (effect_kind.held); or what the weight sets free as a body sinks into a wall by that
 *  much, if that is more. What e does is what the effects say (effect_kind.deform). */
vti_deformation model_deformation(const struct model *model, const vti_bodies *bodies);
/** The bound on the stable step of the model (vti_stable_step): of bodies where they are with the contacts that they
 *  have, of the last model_find_pairs, if at is NULL, or while nothing is deformed by more than *at. Bodies as in
 *  model_find_pairs. Costs about as much as a step. Returns 0, or -1 with one line in *message. */
int model_stable_step(const struct model *model, const vti_bodies *bodies, const vti_deformation *at,
                      vti_stable *stable, struct message *message);
/** What limits the step, "bond 12 of bodies 12 and 13"; "nothing oscillates" if nothing does. */
void model_limit_text(const struct model *model, const vti_deformation *at, const vti_stable *stable, char *text,
                      size_t size);

/** Both bounds of bodies as they are at the start of a run, and what sets them. */
struct model_limits {
    vti_deformation at; /* what their energies allow, model_deformation */
    vti_stable rest;    /* the bound at rest */
    vti_stable within;  /* while nothing is deformed by more than *at */
    char rest_by[96], within_by[96];
};
int model_find_limits(const struct model *model, struct model_limits *limits, struct message *message);
/** The lesser of the two; that at rest where energies allow a deformation within which no step is sure: within.h = 0 */
static inline double model_limits_least(const struct model_limits *limits)
{
    return limits->within.h > 0.0 ? fmin(limits->rest.h, limits->within.h) : limits->rest.h;
}
/** The stable step of a stepper of which h is that of velocity Verlet, 2/omega, as vti_stable and model_limits have it:
 *  the stepper's reach is h omega up to which it is stable. */
static inline double model_stable_of(const vti_stepper *stepper, double h)
{
    return 0.5 * stepper->reach * h;
}
/** The longest time between two evaluations of forces by which methods that choose their steps may not miss a touch: an
 *  error that they estimate between touches knows of none. It is 3/omega of the stiffest contact that energies at the
 *  start allow. A touch of two spheres lasts 4.0/omega or longer (2.94 delta/v of Hertz, with omega = 1.37 v/delta), so
 *  that forces are taken at least once where they are a fourth of their largest or more. Infinite where forces have no
 *  kinks. Returns 0, or -1 with one line in *message. */
int model_longest_gap(const struct model *model, double *gap, struct message *message);

/* ---- what the continuous motion conserves besides the energy ----------------------------------------------------- */

/** One conserved number of the scene. */
struct invariant {
    const char *name;  /* as in files */
    const char *label; /* as in pictures, mathtext */
    int is_momentum;   /* counts in the momentum error */
};

/** About the origin. */
void model_angular_momentum(const vti_bodies *bodies, double values[3]);
/** The scene's invariants, in a fixed order: components of linear and of angular momentum that every effect keeps; of
 *  those angular ones that some effect breaks, the component of the spin, sum J Omega, if every effect keeps that.
 *  Returns how many (at most MODEL_INVARIANTS). */
int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS]);
/** The momenta among them, which come first: bits 0 to 2 the linear one, 3 to 5 the angular one about the origin, 6 to
 *  8 the spin. */
int64_t model_momenta(const struct model *model);
/** Their values for the bodies, in the same order. */
void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS]);
/** Those that count as momenta of the ones that effects conserve themselves, in the same order, of many states of body
 *  0 (effect_invariants.of_states): value[][stride]. Returns how many rows they are. */
int64_t model_own_momenta(const struct model *model, const vti_bodies *states, double *value, int64_t stride);

#endif
