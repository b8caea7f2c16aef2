/* SPDX-License-Identifier: BSD-3-Clause
 * A run of a convergence study: measured against the reference at every step (EQUATIONS 4). */
#ifndef VTI_OUTCOME_H
#define VTI_OUTCOME_H

#include "reference.h"
#include "trial.h"
#include "verdict.h"

enum { OUTCOME_SAMPLES = 513, OUTCOME_COLUMNS = 2 + MODEL_INVARIANTS };

/** What a run measured. A flat record, so that it can travel and be stored as bytes. */
/** The errors of a run; orders are fitted to all but the last. */
enum {
    E_ERROR,        /* ||E_h - E_0||_{H0}/||E_0||_{H0} (absolute if E_0 = 0) */
    Q_ERROR,        /* the paper's | ||q_h||^2 - ||q||^2 |^(1/2)/||q|| */
    H1_ERROR,       /* ||q_h - q||_{H1}/||q||_{H1} */
    ATTITUDE_ERROR, /* largest |log(R_h R^T)| at the end, radians */
    MOMENTUM_ERROR, /* largest deviation of a conserved momentum from its initial value */
    OUTCOME_ERRORS
};
/** "e_error" and so on, as files have them. */
extern const char *const outcome_errors[OUTCOME_ERRORS];

struct outcome {
    int64_t failed; /* 0, or 1 and the reason in message: errors are NaN, the verdict is bad, there is no series */
    int64_t steps, force_evals;
    double error[OUTCOME_ERRORS];
    double seconds;             /* of the run with its measurements: not a result */
    struct judgement judgement; /* on the rows of series; at every step would cost as much as the run */
    struct message verdict;     /* its line */
    int64_t samples;            /* rows of series */
    double series[OUTCOME_SAMPLES][OUTCOME_COLUMNS]; /* t, E_h - E_0, invariants less their initial values */
    struct message message;
};

/** On a run that failed: bad, and nothing is known of it. */
extern const struct judgement outcome_unjudged;

/** Runs the trial, compared with the reference every compare_every steps: those from one state that it knows to the
 *  next. poll (may be NULL) is called with poll_self and the steps taken so far every few milliseconds, and while a
 *  piece of the reference is made; non-zero stops the run, which then has failed for no reason. Never fails as
 *  such: look at outcome->failed. */
void outcome_of(const struct scene *scene, const struct trial *trial, int64_t compare_every,
                struct reference *reference, int (*poll)(void *self, int64_t step), void *poll_self,
                struct outcome *outcome);

#endif
