/* SPDX-License-Identifier: BSD-3-Clause
 * The norms of a run and of its error (EQUATIONS 4), and how far energy and momenta go, taken along with its steps:
 * many steps at once where the reference is known at all of them. */
#ifndef VTI_NORMS_H
#define VTI_NORMS_H

#include "reference.h"
#include "states.h"
#include "trial.h"

struct norms {
    struct reference *reference;
    const struct watch *watch; /* while the reference is brought to where the run is */
    double h;
    int64_t last;                        /* step */
    int64_t compare_every, next_compare; /* steps: no division at those between */
    vti_integral norm_squared;           /* |x|^2 + |v|^2 + theta^2 + |Omega|^2 of q_h */
    vti_integral error_squared;          /* the same of q_h - q */
    double attitude_error;               /* at the last step */

    struct model *model;
    double energy0, invariants0[MODEL_INVARIANTS]; /* at the start */
    double energy_unit;                            /* |E_0|, or 1 where it is 0 */
    struct invariant invariant[MODEL_INVARIANTS];
    int64_t invariants, momenta; /* how many, and of these the momenta of bodies, which are first */
    vti_integral energy_squared; /* (E_h - E_0)^2 */
    double momentum_error;       /* largest deviation of a momentum; once NaN, it stays */

    struct states states;
    double *memory;      /* of what is kept, and of loads */
    double *kept;        /* states of steps that wait (states.h), NULL where steps are taken one by one */
    double *loads, owed; /* those that owe a kick, and over which time */
    vti_bodies *bodies;  /* of spheres: each body in all that wait, and its loads (states_of_body) */
    const double *exact; /* the reference's at the same steps */
    int64_t held, room;  /* how many wait, and for how many there are the reference's */
    double terms[EFFECT_TERMS_OF_ALL][PANELS_BLOCK]; /* the effects' energies in them */
    int puts;                                        /* 1: some of these have to be taken state by state */
    int64_t terms_count; /* how many, where energies of bodies are taken of many steps at once, else -1 */
};

/** The energy that only steps change: with what effects have booked. */
double norms_energy(struct model *model, const vti_bodies *bodies);

/** For a run of *model over the trial, compared with the reference every compare_every steps. Returns 0, or -1 with one
 *  line in *message. norms_destroy is due after either. */
int norms_create(struct norms *norms, struct model *model, const struct trial *trial, int64_t compare_every,
                 struct reference *reference, const struct watch *watch, struct message *message);
void norms_destroy(struct norms *norms);
/** Whether the steps between 0 and the last have to be whole: else velocities may owe a kick (loop.h). */
int norms_looks(const struct norms *norms);
/** The next step, from 0 on. Returns 0, or what reference_seek returns. */
int norms_take(struct norms *norms, int64_t step, const vti_bodies *bodies, struct message *message);

#endif
