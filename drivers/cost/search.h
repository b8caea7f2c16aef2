/* SPDX-License-Identifier: BSD-3-Clause
 * One stepper's way to an error: which number of steps meets it. */
#ifndef VTI_SEARCH_H
#define VTI_SEARCH_H

#include "advise.h"

struct search {
    const struct scene *scene;
    struct advice *advice;
    struct pilot solution;
    double omega0;
    double stable_h; /* of contacts as they are listed and bonds at rest: searches begin there */
    double limit;    /* force evaluations beyond which runs are too dear */
    double budget;   /* seconds to spend on the solution */
    void (*say)(const char *stepper, int64_t steps);
    struct message *message;
};

/** A pilot run. Returns 0, or -1 with one line in *s->message. */
int search_run(struct search *s, const vti_stepper *stepper, int64_t steps, struct pilot *pilot);
/** The fewest steps that are worth trying: below 0.9 of the stable step, and of the closed form's own bound; at
 *  least 4. */
int64_t search_fewest(const struct search *s, const vti_stepper *stepper);
/** Fills in the offer of o->stepper by runs of up to limit force evaluations, compared with s->solution. Returns
 *  likewise. */
int search_stepper(struct search *s, struct offer *o, double limit);

#endif
