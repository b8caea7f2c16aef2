/* SPDX-License-Identifier: BSD-3-Clause
 * Advice: which stepper and which h reach a given error at the end of a scene, and what that takes. */
#ifndef VTI_ADVISE_H
#define VTI_ADVISE_H

#include "trial.h"

/* ---- pilot runs -------------------------------------------------------------------------------------------------- */

/* Pilot runs: one stepper over the whole time of a scene, of which only the end and the time taken are kept. */

struct pilot {
    int64_t steps, force_evals;
    int failed;       /* a step was refused, or the end is not finite; message says why */
    double seconds;   /* of the steps alone */
    double max_omega; /* largest |Omega| at some 64 times */
    vti_bodies end;   /* v and alpha at t_end, of those that the scene has */
    double *memory;
    struct message message;
};

/** Runs the trial. Returns 0, or -1 with one line in *message if there is no memory or no model; a
 *  run that fails on its way is pilot->failed. */
int pilot_run(const struct scene *scene, const struct trial *trial, struct pilot *pilot, struct message *message);
void pilot_destroy(struct pilot *pilot);

/** How far the end of a run is from that of the solution: the largest |log(R R_s^T)| of a body, radians; where
 *  nothing turns the relative error of the velocities, (sum |v - v_s|^2 / sum |v_s|^2)^(1/2). Infinite if either run
 *  has failed. */
double pilot_error(const struct pilot *pilot, const struct pilot *solution);

/* ---- advice ------------------------------------------------------------------------------------------------------ */

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
 *  list, or all of ours for count 0. Rivals in it are measured too, and are never the advice. say (may be NULL)
 *  hears of every run. Returns 0, or -1 with one line in *message, so too if no run comes near enough to the others
 *  to tell its error, or would take more than budget seconds for that. */
int advise(const struct scene *scene, double target, double t_end, double budget, const vti_stepper *const *steppers,
           int64_t count, void (*say)(const char *stepper, int64_t steps), struct advice *advice,
           struct message *message);

/* ---- the search of one stepper ----------------------------------------------------------------------------------- */

/* One stepper's way to an error: which number of steps meets it. */

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
