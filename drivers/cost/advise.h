/* SPDX-License-Identifier: BSD-3-Clause
 * Advice: which stepper and which h reach a given error at the end of a scene, and what that takes. */
#ifndef VTI_ADVISE_H
#define VTI_ADVISE_H

#include "pilot.h"

enum { ADVICE_MOST = 32 };

/** One stepper's way to the error that was asked for. */
struct offer {
    const vti_stepper *stepper;
    int64_t steps; /* 0: no step was found that it survives */
    int64_t force_evals;
    double h, error, seconds;
    int measured; /* 1: this very run was made; 0: followed from coarser ones by the stepper's order */
};

struct advice {
    double target, t_end;
    struct model_limits limits; /* of the step, at the start */
    double max_omega;           /* of the solution */
    double order;               /* that the most accurate runs showed; NaN if they needed no refining */
    const vti_stepper *checked; /* whose runs these were */
    double known;               /* error of the solution that all others are compared with */
    int64_t count;
    struct offer offers[ADVICE_MOST]; /* by rising seconds, rivals after ours; the first is the advice */
};

/** Works out the advice by pilot runs over the whole time, coarse ones where they suffice. Steppers are those of the
 *  list, or all of the core for count 0. Rivals in it are measured too, and are never the advice. say (may be NULL)
 *  hears of every run. Returns 0, or -1 with one line in *message, so too if no run comes near enough to the others
 *  to tell its error, or would take more than budget seconds for that. */
int advise(const struct scene *scene, double target, double t_end, double budget, const vti_stepper *const *steppers,
           int64_t count, void (*say)(const char *stepper, int64_t steps), struct advice *advice,
           struct message *message);

#endif
