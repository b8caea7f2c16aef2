/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The continuous equations of a model, for GSL:
 *
 *     x' = v,  v' = F/m,  q' = (1/2) Omega q,  Omega' = RM/J,  (||q||^2)' = |x|^2 + |v|^2 + theta^2 + |Omega|^2
 *
 * with the attitude as a quaternion; of bodies of three moments Omega' is by Euler's equations, J Omega' = RM - Omega x
 * J Omega with J = R_p diag(A, B, C) R_p^T, and not by the angular momentum that the steppers go by. They share the
 * effects' forces with the steppers and nothing else. */
#ifndef VTI_EQUATIONS_H
#define VTI_EQUATIONS_H

#include <gsl/gsl_odeiv2.h>

#include "control.h"
#include "model.h"
#include "watch.h"

struct equations {
    struct model *model; /* its contacts follow the states that are looked at */
    int64_t width;       /* doubles in a state: all bodies, then ||q||^2 up to now */
    double *loads;       /* force and moment of every body */
    double *unit;        /* [width]: units.h */
    double *noise;       /* [4][width]: what rounding changes in rates, and scratch to find it */
    int64_t evals, next; /* of rates; at which noise is looked at again */
    struct control_floor floor;
    double oscillation; /* 2/omega of what oscillates fastest; infinite if nothing does */
    double longest;     /* step that passes by no touch; infinite if nothing meets */
    double tolerance;
    vti_bodies bodies; /* where rates are taken; sealed */
    int status, asked; /* why rates were refused: what the core said, 1 if the watch asked for the end */
    const struct watch *watch;
    double share;   /* of the whole, that is done; for the watch */
    int64_t unseen; /* bodies whose rates were taken since the watch was last asked */
    gsl_odeiv2_system system;
    gsl_odeiv2_driver *driver;
};

/** rk8pd on the equations of *model with an error per step of tolerance. equations must stay where it is; watch is
 *  asked on the way. Returns 0, or -1 with one line in *message. */
int equations_create(struct equations *equations, struct model *model, double tolerance, const struct watch *watch,
                     struct message *message);
void equations_destroy(struct equations *equations);

/** The sum of the squares of what rounding has changed in velocities and spins at steps that it is a bound of, above
 *  the tolerance, in the unit of the norm; 0 if there was none. */
double equations_rounding_squared(const struct equations *equations);

/** Doubles of one body in a state: x v if it translates, q Omega if it turns. */
int64_t equations_body_width(const struct model *model);
int64_t equations_width(const struct model *model);
/** The model's bodies at t = 0 as a state. */
void equations_start(const struct model *model, double *state);
/** Bodies with attitudes as alpha, of the model's own views, as a state; its last number is left alone. */
void equations_take(const struct model *model, const vti_bodies *from, double *state);
/** A state seen as bodies: nothing is copied. */
vti_bodies equations_bodies(const struct model *model, double *state);
/** Lets *bodies, which equations_bodies has made of another state, see this one. A seal stays good: only the addresses
 *  of like memory change. */
void equations_look_at(const struct model *model, vti_bodies *bodies, double *state);
/** Takes the state from *t to to; share is what of the whole was done before, 0 to 1. Returns 0, or -1 with one line in
 *  *message, or WATCH_ASKED. */
int equations_advance(struct equations *equations, double share, double *t, double to, double *state,
                      struct message *message);

#endif
