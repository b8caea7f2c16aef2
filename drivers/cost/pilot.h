/* SPDX-License-Identifier: BSD-3-Clause
 * Pilot runs: one stepper over the whole time of a scene, of which only the end and the time taken are kept. */
#ifndef VTI_PILOT_H
#define VTI_PILOT_H

#include "trial.h"

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

#endif
