/* SPDX-License-Identifier: BSD-3-Clause
 * The state of bodies as one row of numbers, what a run needs to go on with the same bits; and bodies with a state of
 * their own. */
#ifndef VTI_STATE_H
#define VTI_STATE_H

#include "message.h"
#include "sink.h"
#include "vti.h"

/** How many doubles the state of the bodies is: positions, velocities, attitudes, angular velocities and
 *  momenta and the residuals, of those that are present. Forces are not in it: they follow from positions. */
int64_t state_size(const vti_bodies *bodies);
void state_get(const vti_bodies *bodies, double *state);
/** The same, some at a time. */
void state_give(const vti_bodies *bodies, struct sink *sink);
void state_put(const double *state, const vti_bodies *bodies);

/** Looks for a number that is not finite, or larger than most. Returns 0 if there is none; else -1 with "body 7 has
 *  velocity nan" in *message. */
int state_watch(const vti_bodies *bodies, double most, struct message *message);

/* ---- bodies that share all but some views with others ------------------------------------------------------------ */

/** Sets of views are sums. */
enum {
    OWN_X = 1,
    OWN_V = 2,
    OWN_ALPHA = 4,
    OWN_OMEGA = 8,
    OWN_SPIN = 16,
    OWN_FORCE = 32,
    OWN_MOMENT = 64,
    OWN_ALL = 127
};

struct fork {
    vti_bodies bodies;
    int own;        /* OWN_ */
    double *memory; /* of these, to be freed; NULL without any */
};

/** Makes bodies with memory of their own, zeros so far, for those views of the set that are there, without residuals,
 *  and with the views of *of for all else. Returns 0, or -1 if there is no memory. */
int state_fork_create(struct fork *fork, const vti_bodies *of, int own);
/** Copies what the fork owns from bodies with the same views. */
void state_fork_take(struct fork *fork, vti_bodies from);

#endif
