/* SPDX-License-Identifier: BSD-3-Clause
 * The time loop: steps a model and shows every state to observers. */
#ifndef VTI_LOOP_H
#define VTI_LOOP_H

#include "model.h"

/** Sees the bodies at t = step h and must not change them. Returns 0 to go on, anything else to stop the run. */
struct observer {
    int (*see)(void *self, int64_t step, double t, const vti_bodies *bodies);
    void *self;
    int64_t every; /* called at steps 0, every, 2 every, ..., and at the last */
    int raw;       /* 0: position and velocity are of the same time. 1: the bodies as the stepper keeps them */
    /** Whether it looks at velocities at a step at which it is called; NULL: always. Asked once for each, before see,
     *  of lists of kicks and drifts. Where nobody does, the step may end with the begin of the next, in one pass over
     *  the bodies with the same bits, and the velocities are of neither: a kick over the model's owed by the loads
     *  brings copies of them there, with the same bits. */
    int (*looks)(void *self, int64_t step);
    /** Whether it is to be called soon, between its steps too; NULL: never. Asked after each step of variable length,
     *  many of which may lie between two calls. */
    int (*wants)(void *self);
};

/** looks of an observer that looks at no velocities. */
int loop_never_looks(void *self, int64_t step);

/** Steps are counted in a double (t = step h), which holds whole numbers up to this. */
#define LOOP_STEPS 0x1p53
/** Whole steps of h that fit into t_end (to rounding): a run ends at loop_steps h, which is t_end if that is a multiple
 *  of h and the last step before it otherwise. At most LOOP_STEPS. */
int64_t loop_steps(double t_end, double h);

/** Takes the model, which is at step from, to step steps by steps of h, and shows steps from ... steps to the
 *  observers, in their order. With from > 0 the model's bodies must be as a raw observer saw them at that step, and the
 *  run goes on with the same bits. Returns 0; 1 if an observer stopped it; -1 with one line in *message if a step was
 *  refused. */
int loop_run(struct model *model, const vti_stepper *stepper, double h, int64_t from, int64_t steps,
             const struct observer *observers, int observers_count, struct message *message);

#endif
