/* SPDX-License-Identifier: BSD-3-Clause
 * One method over one case, at one step after the other. Times are taken elsewhere (cost_time.h). */
#ifndef VTI_COST_LADDER_H
#define VTI_COST_LADDER_H

#include "cost_plan.h"
#include "race.h"

enum { COST_RUNGS = 64, COST_WORK = 1 << 22 };

/** The runs that went well, in the order of falling h, and what became of the others. Flat: it travels as bytes. */
struct cost_ladder {
    int64_t count;
    int64_t failures;
    struct message failure; /* of the last of those */
    struct race_result runs[COST_RUNGS];
    double h[COST_RUNGS];
};

/** The error that a run is priced by: of the attitudes, or of the velocities where nothing turns. */
double cost_error(const struct race_result *run, int turns);

/** Goes down the plan's steps. Without any: the first step is four times the stable step (half of t_end at most),
 *  each next one has sqrt(2) times as many. It ends when
 *   - the error is below 3e-11,
 *   - the next run would take more force evaluations than allowed,
 *   - the error, below 1e-6 already, is rounding: over the last factor of four in steps it has not even halved, twice in a row.
 *  Runs at the start whose error is above 1 say nothing and are left out. model is of the case, at t = 0. poll (may be NULL)
 *  is called between runs and ends the ladder if it returns non-zero. */
void cost_ladder_run(const struct cost_plan *plan, const struct cost_case *c, const vti_stepper *method,
                     const struct model *model, struct reference *reference, int (*poll)(void *self, int64_t work),
                     void *poll_self, struct cost_ladder *ladder);

#endif
