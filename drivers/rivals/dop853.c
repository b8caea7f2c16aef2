/* SPDX-License-Identifier: BSD-3-Clause
 *
 * DOP853 with its own choice of steps: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I,
 * 2nd ed. (1993), II.10 and the code of its appendix, without the continuous extension and with beta = 0. Of the slopes
 * k_i of a step two errors, of orders 5 and 3, make one:
 *
 *     E5 = sum_i e5_i k_i,   E3 = sum_i e3_i k_i,   |E|^2 = sum_j (E_j/D_j)^2,   D_j = epsilon (1 + max(|y_j|, |y'_j|))
 *     err = h |E5|^2/(n (|E5|^2 + |E3|^2/100))^{1/2},   h <- h/max(1/6, min(3, err^{1/8}/0.9))
 *
 * with y' the state after the step. A step with err > 1 is made again by its first slope, with h less than before (no
 * 1/6 there), and the next that is taken does not lengthen h. The first step tried is h, and as for rk8pd-adaptive
 *
 *     epsilon = SHARE (h f)^8,   1e-14 to 1e-2,   f = max(omega_max, max |Omega| at t = 0).
 *
 * The last step, cut to end where the caller wants to look, is taken by a copy that is left behind (rk8pd.c). */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"
#include "rates.h"
#include "runge_kutta.h"

enum { ORDER = 8, STATES = 3, STAGES = 12 };
static const double share = 1e-7, least = 1e-14, largest = 1e-2; /* above it bonds are torn and steps shrink */
static const double safety = 0.9, shrink = 3.0, grow = 1.0 / 6.0;
static const double gap = 0.6 - 1.0 / 3.0; /* the largest between nodes c_i */

/** Numbers of a course. */
enum { TIME, STEP, HELD, KNOWS_SLOPE, CUT_EVALS, EPSILON };

/** Where a path is: a state, its slope, the time, the step to be tried, and whether the one before was not taken. */
struct path {
    double *y, *slope, t, h;
    int held;
};

struct tool {
    struct runge_kutta *method;
    int64_t room;
    double *after, *slope; /* the state after a step, and the slope of the copy */
    double memory[];
};

/* ---- one step ---------------------------------------------------------------------------------------------------- */

/** sum_j (sum_i e_i k_i / D_j)^2. */
static double size_of(const double *weight, double *const *k, const double *y, const double *after, double epsilon,
                      int64_t n)
{
    double sum = 0.0;
    for (int64_t j = 0; j < n; ++j) {
        double e = 0.0;
        for (int i = 0; i < STAGES; ++i)
            e += weight[i] * k[i][j];
        e /= epsilon * (1.0 + fmax(fabs(y[j]), fabs(after[j])));
        sum += e * e;
    }
    return sum;
}

static double error_of(const struct course *c, const struct path *p, double h)
{
    const struct tool *tool = c->tool;
    double *const *k = runge_kutta_slopes(tool->method);
    const double epsilon = c->number[EPSILON];
    const int64_t n = rates_width(c);
    const double five = size_of(tableau_dop853_error[0], k, p->y, tool->after, epsilon, n);
    const double three = size_of(tableau_dop853_error[1], k, p->y, tool->after, epsilon, n);
    const double both = five + 0.01 * three;
    return both > 0.0 ? h * five / sqrt((double)n * both) : both; /* NaN stays one */
}

/** A step of h is tried. It is taken, or the path has a shorter one to try next. */
static int try_step(struct course *c, struct path *p, double h)
{
    struct tool *tool = c->tool;
    memcpy(tool->after, p->y, (size_t)tool->room * sizeof *p->y);
    runge_kutta_resize(tool->method, h);
    int status = runge_kutta_step(tool->method, c, tool->after, p->slope);
    if (status != VTI_OK)
        return status;
    const double err = error_of(c, p, h), factor = sqrt(sqrt(sqrt(err))) / safety;
    if (!(err <= 1.0)) {
        p->h = h / fmin(shrink, factor);
        p->held = 1;
        return 0.1 * p->h > p->t * DBL_EPSILON ? VTI_OK : RIVAL_E_DIVERGES;
    }
    const double next = h / fmax(grow, fmin(shrink, factor));
    p->h = fmin(p->held ? fmin(next, h) : next, c->longest);
    p->held = 0;
    p->t += h;
    memcpy(p->y, tool->after, (size_t)tool->room * sizeof *p->y);
    return rates(c, p->y, p->slope);
}

/* ---- as a rival -------------------------------------------------------------------------------------------------- */

static int prepare(struct course *c, struct message *message)
{
    const int64_t room = rates_room(c);
    double most;
    if (course_fastest(c, &most, message) != 0 || course_longest(c, gap, message) != 0)
        return -1;
    struct tool *tool = calloc(1, sizeof *tool + (size_t)(2 * room) * sizeof(double));
    if (tool == NULL)
        return -1;
    c->tool = tool;
    tool->room = room;
    tool->after = tool->memory;
    tool->slope = tool->memory + room;
    tool->method = runge_kutta_create(c->rival->table, c->h, room);
    c->number[STEP] = fmin(c->h, c->longest);
    c->number[EPSILON] = fmin(fmax(share * plain_power(most, ORDER), least), largest);
    rates_start(c, c->own);
    return tool->method != NULL ? 0 : -1;
}

static void dismiss(struct course *c)
{
    struct tool *tool = c->tool;
    if (tool != NULL)
        runge_kutta_destroy(tool->method);
    free(tool);
}

static struct path path_of(const struct course *c, double *y, double *slope)
{
    const struct path p = {y, slope, c->number[TIME], c->number[STEP], c->number[HELD] != 0.0};
    return p;
}

/** All steps that end before the time end. */
static int free_steps(struct course *c, double end)
{
    struct path p = path_of(c, c->own, c->own + ((struct tool *)c->tool)->room);
    int status = c->number[KNOWS_SLOPE] != 0.0 ? VTI_OK : rates(c, p.y, p.slope);
    c->number[KNOWS_SLOPE] = 1.0;
    while (status == VTI_OK && p.t + p.h < end)
        status = try_step(c, &p, p.h);
    c->number[TIME] = p.t;
    c->number[STEP] = p.h;
    c->number[HELD] = p.held;
    return status;
}

/** The copy's way from there to end. */
static int cut(struct course *c, double end)
{
    const struct tool *tool = c->tool;
    const size_t size = (size_t)tool->room * sizeof(double);
    struct path p = path_of(c, c->own + 2 * tool->room, tool->slope);
    memcpy(p.y, c->own, size);
    memcpy(p.slope, c->own + tool->room, size);
    int status = VTI_OK;
    while (status == VTI_OK && p.t < end) {
        const double left = end - p.t, h = fmin(p.h, left), t = p.t;
        status = try_step(c, &p, h);
        p.t = h == left && p.t != t ? end : p.t;
    }
    return status;
}

static int go(struct course *c, int64_t steps)
{
    const double end = (double)(c->steps + steps) * c->h;
    c->evals -= (int64_t)c->number[CUT_EVALS];
    int status = free_steps(c, end);
    const int64_t evals = c->evals;
    if (status == VTI_OK)
        status = cut(c, end);
    c->number[CUT_EVALS] = (double)(c->evals - evals);
    c->steps += status == VTI_OK ? steps : 0;
    return status;
}

static void show(struct course *c)
{
    double *const copy = c->own + 2 * ((struct tool *)c->tool)->room;
    if (c->steps == 0)
        rates_start(c, copy);
    rates_look_at(c, copy);
    rates_momenta(c);
}

const struct rival rival_dop853_adaptive = {
    .stepper = RIVAL_STEPPER("dop853-adaptive", ORDER, 0.0, 0, NAN,
                             "DOP853 with its own step size control, whose tolerance is proportional to h^8 (Hairer, "
                             "Norsett, Wanner 1993)"),
    .table = &tableau_dop853,
    .own_width = STATES * RATES_ROOM,
    .prepare = prepare,
    .go = go,
    .show = show,
    .dismiss = dismiss,
    .general = RIVAL_OF_BOTH,
};
