/* SPDX-License-Identifier: BSD-3-Clause
 *
 * GSL's rk8pd on y = (x, v, q, Omega): P. J. Prince, J. R. Dormand, High order embedded Runge-Kutta formulae, J.
 * Comput. Appl. Math. 7, 67 (1981), order 8, thirteen evaluations; M. Galassi et al., GNU Scientific Library
 * Reference Manual, 3rd ed. (2009), "Ordinary Differential Equations".
 *
 * "rk8pd" takes steps of h, without a thought for the error estimate that GSL makes beside them.
 *
 * "rk8pd-adaptive" is how it is meant to be used: GSL chooses the steps so that the estimate stays below
 *
 *     epsilon = SHARE (h f)^8,   at least 1e-14,   f = max(omega_max, max |Omega| at t = 0)
 *
 * absolute and relative to each number of the state. omega_max is what vti_stable_step allows for (0 if nothing
 * oscillates; if nothing spins either, f = 1/h). As the estimate grows with the eighth power of the step, the steps
 * chosen are proportional to h: a third of it to all of it on the scenes here. Below epsilon = 1e-14 rounding would
 * be refined, not error: h has no effect there. The last step, cut to end where the caller wants to look, is taken
 * by a copy that is left behind, so that neither the path nor the number of evaluations depends on how often
 * somebody looks. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "control.h"
#include "plain.h"
#include "rates.h"

enum { ORDER = 8, STATES = 2 };
static const double share = 1e-7, least = 1e-14;
static const double gap = 1201146811.0 / 1299019798.0 - 0.65; /* the largest between nodes c_i */

/** Numbers of a course: where GSL is, the step that it would take next, and evaluations that nobody needs who does not
 *  look. */
enum { TIME, STEP, CUT_EVALS };

struct tool {
    gsl_odeiv2_system system;
    gsl_odeiv2_step *step;
    gsl_odeiv2_control *control; /* these three of the adaptive one */
    gsl_odeiv2_evolve *evolve, *cut;
    int status; /* of the last forces */
};

/* ---- tools ------------------------------------------------------------------------------------------------------- */

static int derivative(double t, const double y[], double dydt[], void *self)
{
    struct course *c = self;
    struct tool *tool = c->tool;
    (void)t;
    tool->status = rates(c, y, dydt);
    return tool->status == VTI_OK ? GSL_SUCCESS : GSL_EBADFUNC;
}

static void dismiss(struct course *c)
{
    struct tool *tool = c->tool;
    if (tool == NULL)
        return;
    if (tool->cut != NULL)
        gsl_odeiv2_evolve_free(tool->cut);
    if (tool->evolve != NULL)
        gsl_odeiv2_evolve_free(tool->evolve);
    if (tool->control != NULL)
        gsl_odeiv2_control_free(tool->control);
    if (tool->step != NULL)
        gsl_odeiv2_step_free(tool->step);
    free(tool);
}

static int prepare(struct course *c, struct message *message)
{
    struct tool *tool = calloc(1, sizeof *tool);
    (void)message;
    if (tool == NULL)
        return -1;
    gsl_set_error_handler_off();
    c->tool = tool;
    tool->system = (gsl_odeiv2_system){derivative, NULL, (size_t)rates_width(c), c};
    tool->step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, tool->system.dimension);
    rates_start(c, c->own);
    return tool->step != NULL ? 0 : -1;
}

static int prepare_adaptive(struct course *c, struct message *message)
{
    double most;
    if (prepare(c, message) != 0 || course_fastest(c, &most, message) != 0 || course_longest(c, gap, message) != 0)
        return -1;
    const double epsilon = fmax(share * plain_power(most, ORDER), least);
    struct tool *tool = c->tool;
    c->number[STEP] = fmin(c->h, c->longest);
    tool->control = control_new(epsilon);
    tool->evolve = gsl_odeiv2_evolve_alloc(tool->system.dimension);
    tool->cut = gsl_odeiv2_evolve_alloc(tool->system.dimension);
    return tool->control != NULL && tool->evolve != NULL && tool->cut != NULL ? 0 : -1;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static int status_of(const struct tool *tool, int gsl_status)
{
    if (gsl_status == GSL_SUCCESS)
        return VTI_OK;
    return tool->status != VTI_OK ? tool->status : RIVAL_E_DIVERGES;
}

/** own is the state, and GSL's estimate of its error. */
static int go(struct course *c, int64_t steps)
{
    struct tool *tool = c->tool;
    double *const y = c->own, *const error = y + tool->system.dimension;
    for (int64_t k = 0; k < steps; ++k) {
        const int failed = gsl_odeiv2_step_apply(tool->step, 0.0, c->h, y, error, NULL, NULL, &tool->system);
        if (failed != GSL_SUCCESS)
            return status_of(tool, failed);
        rates_normalise(c, y);
        ++c->steps;
    }
    return VTI_OK;
}

/** A step of GSL's choice, that ends at end if that is nearer. GSL_SUCCESS or not. */
static int choose_step(const struct course *c, gsl_odeiv2_evolve *evolve, double *t, double end, double *h, double *y)
{
    struct tool *tool = c->tool;
    const int result = gsl_odeiv2_evolve_apply(evolve, tool->control, tool->step, &tool->system, t, end, h, y);
    *h = fmin(*h, c->longest);
    return result;
}

/** The copy's way from the last free step to end. */
static int cut(const struct course *c, const double *y, double end, double *copy)
{
    struct tool *tool = c->tool;
    double t = c->number[TIME], h = c->number[STEP];
    memcpy(copy, y, tool->system.dimension * sizeof *copy);
    gsl_odeiv2_evolve_reset(tool->cut);
    while (t < end) {
        const int failed = choose_step(c, tool->cut, &t, end, &h, copy);
        if (failed != GSL_SUCCESS)
            return failed;
    }
    return GSL_SUCCESS;
}

/** own is the state after the last free step, and the copy at t = steps h. */
static int go_adaptive(struct course *c, int64_t steps)
{
    struct tool *tool = c->tool;
    const double end = (double)(c->steps + steps) * c->h;
    int failed = GSL_SUCCESS;
    c->evals -= (int64_t)c->number[CUT_EVALS];
    while (failed == GSL_SUCCESS && c->number[TIME] + c->number[STEP] < end)
        failed = choose_step(c, tool->evolve, &c->number[TIME], INFINITY, &c->number[STEP], c->own);
    const int64_t evals = c->evals;
    if (failed == GSL_SUCCESS)
        failed = cut(c, c->own, end, c->own + tool->system.dimension);
    c->number[CUT_EVALS] = (double)(c->evals - evals);
    if (failed != GSL_SUCCESS)
        return status_of(tool, failed);
    c->steps += steps;
    return VTI_OK;
}

static void show_adaptive(struct course *c)
{
    double *const copy = c->own + rates_width(c);
    if (c->steps == 0)
        rates_start(c, copy);
    rates_normalise(c, copy);
    rates_look_at(c, copy);
    rates_momenta(c);
}

const struct rival rival_rk8pd = {
    .stepper =
        RIVAL_STEPPER("rk8pd", ORDER, 0.0, 13, NAN,
                      "Runge-Kutta Prince-Dormand of order 8 with fixed steps, quaternion normalised after each (GSL)"),
    .own_width = STATES * RATES_WIDTH,
    .prepare = prepare,
    .go = go,
    .show = rates_show,
    .dismiss = dismiss,
    .general = RIVAL_OF_BOTH,
};

const struct rival rival_rk8pd_adaptive = {
    .stepper = RIVAL_STEPPER(
        "rk8pd-adaptive", ORDER, 0.0, 0, NAN,
        "Runge-Kutta Prince-Dormand of order 8 with step size control; its tolerance is proportional to h^8 (GSL)"),
    .own_width = STATES * RATES_WIDTH,
    .prepare = prepare_adaptive,
    .go = go_adaptive,
    .show = show_adaptive,
    .dismiss = dismiss,
    .general = RIVAL_OF_BOTH,
};
