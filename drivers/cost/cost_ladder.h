/* SPDX-License-Identifier: BSD-3-Clause
 * One method over one case, at one step after the other. Times are taken elsewhere (cost.h, cost_time). */
#ifndef VTI_COST_LADDER_H
#define VTI_COST_LADDER_H

#include "cost_plan.h"
#include "reference.h"
#include "trial.h"

/* ---- one run ----------------------------------------------------------------------------------------------------- */

/* One method at one h over one scene: how far off it is at the end, and how long it takes. The two are found in
 * separate runs, so that no time is that of a measurement. */

/** What came out. A flat record, so that it can travel as bytes. */
struct race_result {
    int64_t failed; /* 0, or 1 and the reason in message */
    int64_t steps, force_evals;
    double attitude_error; /* largest |log(R_h R^T)| over the bodies at t_end, radians; 0 if nothing turns */
    double position_error; /* largest |x_h - x| over the bodies at t_end, lengths; 0 if nothing translates */
    /** At t_end, of v and Omega together as far as the scene has them: the square root of
     *  sum |v_h - v|^2 + |Omega_h - Omega|^2 over sum |v|^2 + |Omega|^2. */
    double velocity_error;
    double energy_error;   /* largest |E_h - E_0|/|E_0| of all steps (absolute if E_0 = 0); 64 looks where steps vary */
    double momentum_error; /* largest deviation of a conserved momentum from its initial value, same steps */
    double seconds, seconds_spread; /* race_settle; NaN before */
    struct message message;
};

/** A run on a fresh model of scene, and its errors against the reference, which must know t_end. A step that is
 *  refused or a state that is not finite is a failed run. Fills in all but the times. */
void race_measure(const struct scene *scene, const vti_stepper *stepper, double h, double t_end,
                  struct reference *reference, struct race_result *result);

/** The same errors of bodies against others: of v and Omega together, relative; of x, 0 if nothing translates. */
double race_velocity_error(const vti_bodies *bodies, const vti_bodies *exact);
double race_position_error(const vti_bodies *bodies, const vti_bodies *exact);

/** Seconds that reading the clock twice takes. */
double race_clock_cost(void);
/** Seconds of processor time, which is wall-clock time on a core of one's own, of the run alone: without model,
 *  start and observers. One sample is the mean of as many fresh runs in a row as fill a millisecond, at least one.
 *  Returns it, or NaN with one line in *message if the run failed. */
double race_sample(const struct scene *scene, const vti_stepper *stepper, double h, double t_end,
                   struct message *message);

/** The median of those that are numbers, NaN if none is; sorts these to the front. */
double race_median(double *value, int64_t n);
/** seconds: the least of n samples. seconds_spread: how far their median is above it, as a share of it, which one burst
 *  of noise does not move. Sorts the samples. */
void race_settle(double *samples, int n, struct race_result *result);

/* ---- the runs of one method -------------------------------------------------------------------------------------- */

enum { COST_RUNGS = 64, COST_WORK = 1 << 22, COST_EVALS = 1 << 18 };

/** The runs that went well, in the order of falling h, and what became of the others. Flat: it travels as bytes. */
struct cost_ladder {
    int64_t count;
    int64_t failures;
    struct message failure; /* of the last of those */
    struct race_result runs[COST_RUNGS];
    double h[COST_RUNGS];
};

/** What an error can be of. A ladder goes down by the main one of its scene. */
enum { COST_ATTITUDE, COST_POSITION, COST_VELOCITY, COST_ENERGY, COST_MEASURES };

/** What tells how far off a scene's runs are: the attitude, or the velocity where nothing but the paper's own rotation
 *  has an error in it (model_twists); the position where velocities are exact too (model_only_slows). */
static inline int cost_main_measure(const struct model *model)
{
    if (model_only_slows(model))
        return COST_POSITION;
    return model_twists(model) || (model->turns && !model->translates) ? COST_ATTITUDE : COST_VELOCITY;
}

/** "attitude", "position", "velocity", "energy". */
extern const char *const cost_measures[COST_MEASURES];

/** The error of a run by that measure. */
double cost_error(const struct race_result *run, int measure);

/** Steps of the first run of a ladder that is found: they are four times as long as the stable step, and two at least.
 *  model has just been made: lists of pairs depend on what was searched for before, and all ranks are to begin
 *  alike. */
double cost_first_steps(const struct cost_case *c, struct model *model);

/** One method over one case. */
struct cost_descent {
    const struct cost_plan *plan;
    const struct cost_case *c;
    const vti_stepper *method;
    const struct model *model; /* of the case, at t = 0 */
    double first;              /* steps of the first run, where the plan has none: cost_first_steps */
    struct reference *reference;
    /** Called between runs with the number of the next, and ends the ladder if it returns non-zero; may be NULL. */
    int (*poll)(void *self, int64_t work);
    void *poll_self;
};

/** Goes down the plan's steps. Without any: from that first run on, each next one with sqrt(2) times as many steps. It
 *  ends when the error is below 3e-11, the next run would take more force evaluations than allowed, or the error, below
 *  1e-6, is rounding: over the last factor of four in steps it has not even halved, twice in a row. Runs at the start
 *  whose error is above 1 say nothing and are left out. */
void cost_ladder_run(const struct cost_descent *d, struct cost_ladder *ladder);

#endif
