/* SPDX-License-Identifier: BSD-3-Clause
 * One run: a stepper at one h over one scene. What is measured on it is up to observers, and to whoever reads its
 * end: errors at every step (outcome.h), errors at the end and times (cost_ladder.h), the end alone (advise.h). */
#ifndef VTI_TRIAL_H
#define VTI_TRIAL_H

#include "travel.h"

struct trial {
    const vti_stepper *stepper;
    double h;
    int64_t steps;
    double t_end; /* where it ends */
};

static inline struct trial trial_of(const vti_stepper *stepper, double h, int64_t steps)
{
    const struct trial trial = {stepper, h, steps, (double)steps * h};
    return trial;
}

/** On its way: a fresh model of the scene and the stepper that moves it. */
struct trial_run {
    const struct trial *trial;
    struct model model;
    struct travel travel;
    double seconds; /* spent in trial_go */
};

/** Returns 0, or -1 with one line in *message and nothing to be ended. The run must not be moved. */
int trial_begin(struct trial_run *run, const struct scene *scene, const struct trial *trial, struct message *message);
/** To step until, as travel_show goes. */
int trial_go(struct trial_run *run, int64_t until, const struct observer *observers, int observers_count,
             struct message *message);
void trial_end(struct trial_run *run);

/** Steps between two looks at what has its largest error within touches, one step of a thousand: one, but of methods
 *  that choose their steps, which a look cuts, a 64th of the run. */
int64_t trial_look_every(const struct trial *trial);

#endif
