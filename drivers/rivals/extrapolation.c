/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Extrapolation: a step of h is made K times by a simple method in n_1 < ... < n_K equal parts, whose error is a
 * series in (h/n)^2, and the results are combined so that its first K - 1 terms vanish (Aitken, Neville):
 *
 *     y <- y + sum_k c_k (y_k - y),   c_k = prod_{j != k} n_k^2/(n_k^2 - n_j^2),   q <- q/|q|;   order 2K
 *
 * "gbs" takes the explicit midpoint rule (Gragg) in 2, 4, ..., 2K parts, of which all begin with one evaluation:
 * E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.9.
 *
 *     y_1 = y_0 + t f(y_0),   y_{i+1} = y_{i-1} + 2 t f(y_i),   t = h/n
 *
 * "verlet-x" takes Verlet's method, positions first and attitudes by the exponential map, in 1, 2, ..., K parts: S. A.
 * Chin, Multi-product splitting and Runge-Kutta-Nystroem integrators, Celest. Mech. Dyn. Astron. 106, 391 (2010). */
#include <stdlib.h>
#include <string.h>

#include "combine.h"
#include "rates.h"
#include "verlet.h"

enum { RESULTS_MOST = 6 };

/** The parts of a step are part, 2 part, ..., results part. */
struct extrapolation {
    int results; /* K */
    int part;
    int states; /* that make works on */
    /** From own by h in n parts. *end is where the result is. Returns the status of the forces. */
    int (*make)(struct course *course, int n, double **end);
};

/** States are of rates_room numbers: first what make works on, then where results are added up. */
struct tool {
    double weight[RESULTS_MOST], *work, *sum;
};

/* ---- methods ----------------------------------------------------------------------------------------------------- */

/** Work is f(y_0), a slope, and two states, which take turns. */
static int midpoint(struct course *c, int n, double **end)
{
    struct tool *tool = c->tool;
    const int64_t room = rates_room(c);
    double *const first = tool->work, *const slope = first + room, *old = c->own, *now = slope + room;
    const double t = c->h / n, twice = 2.0 * t;
    int status = n == 2 ? rates(c, c->own, first) : VTI_OK;
    combine(now, old, 1, &t, &first, 0, room);
    for (int i = 1; i < n && status == VTI_OK; ++i) {
        status = rates(c, now, slope);
        double *const next = i == 1 ? now + room : old;
        combine(next, old, 1, &twice, &slope, 0, room);
        old = now;
        now = next;
    }
    *end = now;
    return status;
}

/** Work is where the bodies are. */
static int verlet(struct course *c, int n, double **end)
{
    struct tool *tool = c->tool;
    const double t = c->h / n;
    int status = VTI_OK;
    memcpy(tool->work, c->own, (size_t)rates_room(c) * sizeof *c->own);
    rates_live_in(c, tool->work);
    rates_drift(c, 0.5 * t);
    for (int i = 0; i < n && status == VTI_OK; ++i) {
        status = course_forces(c);
        rival_kick_all(c, t, 0, c->n);
        rates_drift(c, i + 1 < n ? t : 0.5 * t);
    }
    *end = tool->work;
    return status;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static void dismiss(struct course *c)
{
    struct tool *tool = c->tool;
    if (tool != NULL)
        free(tool->work);
    free(tool);
}

static int prepare(struct course *c, struct message *message)
{
    const struct extrapolation *e = c->rival->table;
    struct tool *tool = calloc(1, sizeof *tool);
    (void)message;
    c->tool = tool;
    if (tool == NULL)
        return -1;
    for (int k = 1; k <= e->results; ++k) {
        tool->weight[k - 1] = 1.0;
        for (int j = 1; j <= e->results; ++j)
            tool->weight[k - 1] *= j != k ? (double)(k * k) / (k * k - j * j) : 1.0;
    }
    tool->work = calloc((size_t)((e->states + 1) * rates_room(c)), sizeof *tool->work);
    tool->sum = tool->work + e->states * rates_room(c);
    rates_start(c, c->own);
    return tool->work != NULL ? 0 : -1;
}

/** sum += weight (y_k - y) */
static void add(double *restrict sum, double weight, const double *restrict result, const double *restrict y, int64_t n)
{
    for (int64_t j = 0; j < n; ++j)
        sum[j] += weight * (result[j] - y[j]);
}

static int step(struct course *c)
{
    const struct extrapolation *e = c->rival->table;
    static const double whole = 1.0;
    struct tool *tool = c->tool;
    const int64_t room = rates_room(c);
    memset(tool->sum, 0, (size_t)room * sizeof *tool->sum);
    for (int k = 1; k <= e->results; ++k) {
        double *result;
        const int status = e->make(c, k * e->part, &result);
        if (status != VTI_OK)
            return status;
        add(tool->sum, tool->weight[k - 1], result, c->own, room);
    }
    combine(c->own, c->own, 1, &whole, &tool->sum, 0, room);
    rates_normalise(c, c->own);
    return VTI_OK;
}

static int go(struct course *c, int64_t steps)
{
    return rates_steps(c, steps, step);
}

#define EXTRAPOLATION(NAME, RESULTS, PART, STATES, MAKE, EVALS, ABOUT)                                                 \
    {                                                                                                                  \
        .stepper = RIVAL_STEPPER(NAME, 2 * (RESULTS), 0.0, EVALS, NAN, ABOUT),                                         \
        .table = &(const struct extrapolation){RESULTS, PART, STATES, MAKE}, .own_width = RATES_ROOM,                  \
        .prepare = prepare, .go = go, .show = rates_show, .dismiss = dismiss                                           \
    }

const struct rival rival_gbs8 =
    EXTRAPOLATION("gbs8", 4, 2, 4, midpoint, 17,
                  "extrapolated midpoint rule of order 8, fixed steps (Gragg, Bulirsch, Stoer; Hairer et al. 1993)");
const struct rival rival_gbs12 =
    EXTRAPOLATION("gbs12", 6, 2, 4, midpoint, 37,
                  "extrapolated midpoint rule of order 12, fixed steps (Gragg, Bulirsch, Stoer; Hairer et al. 1993)");
const struct rival rival_verlet_x8 =
    EXTRAPOLATION("verlet-x8", 4, 1, 1, verlet, 10,
                  "extrapolated Verlet of order 8, a multi-product of 1 to 4 parts, exponential map (Chin 2010)");
const struct rival rival_verlet_x12 =
    EXTRAPOLATION("verlet-x12", 6, 1, 1, verlet, 21,
                  "extrapolated Verlet of order 12, a multi-product of 1 to 6 parts, exponential map (Chin 2010)");
