/* SPDX-License-Identifier: BSD-3-Clause
 * A study: one scene, several steppers, several h; every combination is one run. */
#ifndef VTI_STUDY_H
#define VTI_STUDY_H

#include "fit.h"
#include "ladder.h"
#include "store.h"
#include "outcome.h"

enum { STUDY_STEPPERS = 64 };

/** What is asked for. */
struct plan {
    const struct scene *scene;
    const vti_stepper *steppers[STUDY_STEPPERS];
    int64_t steppers_count;
    double h[LADDER_MOST];
    int64_t h_count;
    int h_around; /* 1: nobody named steps; they are around the scene's h */
    double t_end;
    double memory; /* bytes that the reference may take on every rank (reference.h) */
};

/** Errors that orders are fitted to, the first of a run's. */
enum { STUDY_MEASURES = MOMENTUM_ERROR };

/** Below this a measure is rounding, or no more than the reference is known to, uncertainty, or keeps its energy to,
 *  energy_error. */
double study_floor(int measure, int64_t steps, double t_end, double uncertainty, double energy_error);
/** That of a reference as a share of the energy, as of runs. */
double study_share(double energy_error, double energy0);

/** The order of a stepper's errors [h_count] above their floors; none where a tolerance chooses the steps, which errors
 *  follow then, and not h. */
struct order study_order(const struct plan *plan, const double *error, const double *floor);

/** What came out; filled in on rank 0, empty elsewhere. Row r is stepper r / h_count at h r % h_count. */
struct study {
    const struct plan *plan;
    struct model model; /* at t = 0 */
    int64_t runs;
    struct trial *trials;                   /* [runs] */
    struct outcome *outcomes;               /* [runs] */
    int *ranks;                             /* [runs] that did it */
    struct order (*orders)[STUDY_MEASURES]; /* [steppers_count] */
    double energy0, norm_squared;
    double t_end;    /* the plan's, or the last common time of all runs before it */
    double interval; /* at which runs are compared with the reference; 0 is every step */
    double thinned;  /* so many of the longest steps, as memory holds no more states; 1: every one, 0: no interval */
    double reference_energy_error, reference_uncertainty; /* the second relative, of the solution */
    double reference_rounding;                            /* the same where it is rounding that leaves it so, else 0 */
    double seconds;                                       /* for all runs, reference excluded */
};

/** Runs the plan on all ranks of comm; a run that fails is an outcome like others. Collective. Returns 0, or -1 on all
 *  ranks with one line in *message on rank 0. Outcomes that the store holds are not computed again; the others come
 *  into it. store and watch may be NULL; a study that watch has asked to end returns WATCH_ASKED on all ranks, and no
 *  message. */
int study_run(const struct plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
              struct study *study, struct message *message);
/** The same runs with the same bits, one after the other by this rank for itself, as one of many such studies. poll is
 *  called often with poll_self; non-zero ends the study, whose results then mean nothing. Returns 0, or -1 with one
 *  line in *message, or WATCH_ASKED. study_destroy is due after any of them. */
int study_alone(const struct plan *plan, int (*poll)(void *self, int64_t work), void *poll_self, struct study *study,
                struct message *message);
/** Whether the plan's scene makes a model that its steppers can take, and its steps suit each other. Returns 0, or -1
 *  with one line in *message. */
int study_check(const struct plan *plan, struct message *message);

void study_destroy(struct study *study);

#endif
