/* SPDX-License-Identifier: BSD-3-Clause
 * The state of bodies as one row of numbers: what a run needs to go on with the same bits. */
#ifndef VTI_STATE_H
#define VTI_STATE_H

#include "message.h"
#include "vti.h"

/** How many doubles the state of the bodies is: positions, velocities, attitudes, angular velocities and the
 *  residuals, of those that are present. Forces are not in it: they follow from positions. */
int64_t state_size(const vti_bodies *bodies);
void state_get(const vti_bodies *bodies, double *state);
void state_put(const double *state, const vti_bodies *bodies);

/** Looks for a number that is not finite, or larger than most. Returns 0 if there is none; else -1 with "body 7 has
 *  velocity nan" in *message. */
int state_watch(const vti_bodies *bodies, double most, struct message *message);

#endif
