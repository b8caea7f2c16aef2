/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A model's bodies in slices that threads do at once, with the bits of one thread: a slice moves its own bodies, and
 * adds the loads of all pairs that name one of them to these alone, in the order of the lists. Pairs across an edge are
 * evaluated on both sides: bodies that are neighbours should have numbers that are near each other. */
#ifndef VTI_SLICES_H
#define VTI_SLICES_H

#include "model.h"

struct slices;

/** From now on the model's steps and forces are done by slices, one for each of threads_used(). The model must stay
 *  where it is. Returns 0, or -1 with one line in *message. */
int slices_create(struct model *model, struct message *message);
/** The model goes on in one piece; harmless if it did. */
void slices_destroy(struct model *model);

/** vti_step_stage, vti_step_finish, and vti_step_next of what cannot be refused, of all bodies by slices, or in one
 *  piece where a step may be refused. */
int slices_stage(const struct model *model, const vti_stepper *stepper, int64_t k, double h, vti_fault *fault);
int slices_finish(const struct model *model, const vti_stepper *stepper, double h);
int slices_next(const struct model *model, const vti_stepper *stepper, double h);
/** vti_clumps_spread of all bodies. */
int slices_spread(const struct model *model);
/** vti_apply of all effects on the model's bodies, whose pairs are found. Also returns MODEL_E_PAIRS. */
int slices_apply(struct model *model);

#endif
