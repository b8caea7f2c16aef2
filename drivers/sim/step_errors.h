/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What single steps of a run err by, as steppers with an estimate say (EQUATIONS 8.1, 8.2): vti-run --errors. The
 * largest of the steps between two rows are columns; how errors of a run add up depends on its motion. */
#ifndef VTI_STEP_ERRORS_H
#define VTI_STEP_ERRORS_H

#include <stddef.h>

#include "vti.h"

/** Of velocity and of angular velocity; all doubles, as they are kept in a checkpoint. */
struct step_errors_found {
    double row[2];             /* largest since the row before */
    double cut[2];             /* largest of steps cut to end here, which are undone thereafter */
    double most[2], most_t[2]; /* largest of all, and when that step ended */
    double before[2][2];       /* of the two steps before; NaN where there are none to compare with */
    double jumps, jump_t;      /* steps whose estimate grew tenfold (8.1), and when the first of them ended */
};

struct step_errors {
    vti_errors sums; /* vti_step_watch */
    struct step_errors_found found;
};

/** For so many bodies; NULL if there is no memory. */
struct step_errors *step_errors_create(int64_t bodies);
void step_errors_destroy(struct step_errors *errors);

/** vti_step_watch before kick k of a step. Nothing if errors is NULL. */
static inline int step_errors_watch(struct step_errors *errors, const vti_stepper *by, int64_t k, double h,
                                    const vti_bodies *bodies)
{
    return errors == NULL ? VTI_OK : vti_step_watch(by, k, h, bodies, &errors->sums);
}

/** Takes what has been watched of a step that ends at t into account. */
int step_errors_end(struct step_errors *errors, const vti_stepper *by, double t, const vti_bodies *bodies);

/** Takes the error[2] of a step that ends at t into account. */
void step_errors_take(struct step_errors *errors, double t, const vti_bodies *bodies, const double error[2]);
/** The same of a step that was cut to end where somebody looks: it counts there alone. */
void step_errors_cut(struct step_errors *errors, const double error[2]);
/** Such steps are undone. Nothing if errors is NULL. */
void step_errors_uncut(struct step_errors *errors);
/** The next step is not to be compared with those before: it is by another method, or of another length. Nothing if
 *  errors is NULL. */
void step_errors_part(struct step_errors *errors);
/** What a row shows, of velocity (0) or of angular velocity (1). */
double step_errors_shown(const struct step_errors *errors, int which);
/** Begins a new row. */
void step_errors_row(struct step_errors *errors);

#endif
