/* SPDX-License-Identifier: BSD-3-Clause
 * One run of a study: a stepper at one h over one scene, measured against the reference at every step (EQUATIONS 4). */
#ifndef VTI_TRIAL_H
#define VTI_TRIAL_H

#include "loop.h"
#include "reference.h"
#include "verdict.h"

enum { TRIAL_SAMPLES = 513, TRIAL_COLUMNS = 2 + MODEL_INVARIANTS };

struct trial {
    const vti_stepper *stepper;
    double h;
    int64_t steps;
    double t_end;          /* where the run ends: steps h */
    int64_t compare_every; /* steps from one state that the reference knows to the next */
};

/** What a run measured. A flat record, so that it can travel and be stored as bytes. */
struct outcome {
    int64_t failed; /* 0, or 1 and the reason in message */
    int64_t steps, force_evals;
    double e_error;             /* ||E_h - E_0||_{H0}/||E_0||_{H0} (absolute if E_0 = 0) */
    double q_error;             /* the paper's | ||q_h||^2 - ||q||^2 |^(1/2)/||q|| */
    double h1_error;            /* ||q_h - q||_{H1}/||q||_{H1} */
    double attitude_error;      /* largest |log(R_h R^T)| at the end, radians */
    double momentum_error;      /* largest deviation of a conserved momentum from its initial value */
    double seconds;             /* of the run with its measurements: not a result */
    struct judgement judgement; /* on the rows of series; at every step would cost as much as the run */
    struct message verdict;     /* its line */
    int64_t samples;            /* rows of series */
    double series[TRIAL_SAMPLES][TRIAL_COLUMNS]; /* t, E_h - E_0, invariants less their initial values */
    struct message message;
};

/** Runs trial on a fresh model of scene. poll (may be NULL) is called with poll_self and the steps taken so far every few
 *  thousand steps, and while a piece of the reference is made; non-zero stops the run, which then has failed for no reason.
 *  Never fails as such: look at outcome->failed. */
void trial_run(const struct scene *scene, const struct trial *trial, struct reference *reference,
               int (*poll)(void *self, int64_t step), void *poll_self, struct outcome *outcome);

#endif
