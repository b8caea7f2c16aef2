/* SPDX-License-Identifier: BSD-3-Clause */
#include "step_errors.h"

#include <math.h>
#include <stdlib.h>

static const double growth = 10.0;    /* in a step: something touches or jumps (EQUATIONS 8.1) */
static const double rounding = 1e-12; /* of the fastest: what is below grows by chance */

struct step_errors *step_errors_create(int64_t bodies)
{
    enum { ROWS = 3, WIDTH = 6 }; /* the most estimates that a stepper makes of a body */
    struct step_errors *errors = calloc(1, sizeof *errors);
    double *memory = calloc((size_t)(ROWS * WIDTH * bodies), sizeof *memory);
    if (errors == NULL || memory == NULL) {
        free(errors);
        free(memory);
        return NULL;
    }
    errors->sums.memory = memory;
    errors->sums.rows = ROWS;
    step_errors_part(errors);
    return errors;
}

void step_errors_destroy(struct step_errors *errors)
{
    if (errors != NULL)
        free(errors->sums.memory);
    free(errors);
}

int step_errors_end(struct step_errors *errors, const vti_stepper *by, double t, const vti_bodies *bodies)
{
    double error[2];
    const int status = vti_step_error(by, bodies, &errors->sums, &error[0], &error[1]);
    if (status == VTI_OK)
        step_errors_take(errors, t, bodies, error);
    return status;
}

/** The largest |v|, or |Omega|, of a body; 0 where there are none. */
static double fastest(const vti_bodies *bodies, const vti_view *view)
{
    double most = 0.0;
    for (int64_t i = 0; view->c[0] != NULL && i < bodies->count; ++i) {
        const int64_t at = i * view->stride;
        const double u[3] = {view->c[0][at], view->c[1][at], view->c[2][at]};
        most = fmax(most, vti_norm(u));
    }
    return most;
}

/** Above both steps before: one of them alone may have passed through 0. */
static int grew(const struct step_errors_found *f, const vti_bodies *bodies, int which, double error)
{
    if (!(error > growth * f->before[0][which] && error > growth * f->before[1][which]))
        return 0;
    return error > rounding * fastest(bodies, which == 0 ? &bodies->v : &bodies->omega);
}

void step_errors_take(struct step_errors *errors, double t, const vti_bodies *bodies, const double error[2])
{
    struct step_errors_found *f = &errors->found;
    if (grew(f, bodies, 0, error[0]) || grew(f, bodies, 1, error[1])) {
        f->jump_t = f->jumps == 0.0 ? t : f->jump_t;
        f->jumps += 1.0;
    }
    for (int which = 0; which < 2; ++which) {
        f->before[0][which] = f->before[1][which];
        f->before[1][which] = error[which];
        f->row[which] = fmax(f->row[which], error[which]);
        if (error[which] > f->most[which]) {
            f->most[which] = error[which];
            f->most_t[which] = t;
        }
    }
}

void step_errors_cut(struct step_errors *errors, const double error[2])
{
    double *cut = errors->found.cut;
    for (int which = 0; which < 2; ++which)
        cut[which] = fmax(cut[which], error[which]);
}

void step_errors_uncut(struct step_errors *errors)
{
    if (errors != NULL)
        errors->found.cut[0] = errors->found.cut[1] = 0.0;
}

double step_errors_shown(const struct step_errors *errors, int which)
{
    return fmax(errors->found.row[which], errors->found.cut[which]);
}

void step_errors_part(struct step_errors *errors)
{
    for (int k = 0; errors != NULL && k < 4; ++k)
        errors->found.before[k / 2][k % 2] = NAN;
}

void step_errors_row(struct step_errors *errors)
{
    errors->found.row[0] = errors->found.row[1] = 0.0;
}
