/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Adams-Bashforth-Moulton methods of fixed step on y = (x, v, q, Omega), predict-evaluate-correct-evaluate: with
 * N^0 f = f_n, N^j f_n = N^{j-1} f_n - N^{j-1} f_{n-1},
 *
 *     y_p = y_n + h sum_{j<K} g_j N^j f_n,   y = y_p + h g_K N^K f(y_p),   q <- q/|q|,   f_{n+1} = f(y)
 *
 * The predictor is of order K and the corrector of order K + 1, by which the methods are named: L. F. Shampine, M. K.
 * Gordon, Computer Solution of Ordinary Differential Equations (1975); E. Hairer, S. P. Norsett, G. Wanner, Solving
 * Ordinary Differential Equations I, 2nd ed. (1993), III.1. The first K - 1 steps are DOP853's, whose evaluations
 * count. g_j = int_0^1 C(s+j-1, j) ds follows from its recurrence.
 *
 * "gear" is the predictor-corrector of molecular dynamics and DEM codes, which evaluates once a step: C. W. Gear,
 * Numerical Initial Value Problems in Ordinary Differential Equations (1971); M. P. Allen, D. J. Tildesley, Computer
 * Simulation of Liquids (1987), 3.2, 3.3.1 and appendix E; T. Poeschel, T. Schwager, Computational Granular Dynamics
 * (2005), 2.4. Positions go by six values as an equation of second order, q and Omega by five as one of first order.
 * Its scaled derivatives are those of the polynomial through the last K = 4 slopes, so that the same numbers come
 * from these: prediction is the Taylor series of both, and the corrector's coefficients 3/20, 251/360 and 251/720
 * are, times the step's powers, (4/5) d_4, g_4 and g_4:
 *
 *     x_p = x_n + h v_n + h^2 sum_{j<K} d_j N^j a_n,   x = x_p + (4/5) h^2 d_K N^K a,
 *     d_j = int_0^1 (1-s) C(s+j-1, j) ds
 *
 * and f_{n+1} = f(y_p) stays as it is. The codes begin with derivatives of zero, which costs them their order; here
 * they begin as the others. */
#include <stdlib.h>

#include "combine.h"
#include "rates.h"
#include "runge_kutta.h"

enum { PAST_MOST = 11, TERMS = PAST_MOST + 2 };

struct adams {
    int past;          /* K */
    int evaluates_end; /* 0: f(y_p) is kept */
    double share;      /* of d_K in the corrector of positions, as an equation of second order; 0: of first */
};

/** A sum over slopes of rising age, of which the first is at y_p. Weights contain h. */
struct sum {
    int count;
    double weight[TERMS];
    double *slope[TERMS];
};

struct tool {
    struct runge_kutta *start;
    double *predicted;
    struct sum predict, correct;     /* of y */
    struct sum predict_x, correct_x; /* of positions, as an equation of second order */
};

/* ---- coefficients ------------------------------------------------------------------------------------------------ */

static double binomial(int n, int k)
{
    double c = 1.0;
    for (int i = 1; i <= k; ++i)
        c = c * (n - k + i) / i;
    return c;
}

/** g_j: sum_{i<=j} g_i/(j + 1 - i) = 1 */
static void once(double g[TERMS])
{
    for (int j = 0; j < TERMS; ++j) {
        g[j] = 1.0;
        for (int i = 0; i < j; ++i)
            g[j] -= g[i] / (j + 1 - i);
    }
}

/** d_j: sum_{i<=j} d_i/(j + 1 - i) = g_{j+1} */
static void twice(const double g[TERMS], double d[TERMS])
{
    for (int j = 0; j + 1 < TERMS; ++j) {
        d[j] = g[j + 1];
        for (int i = 0; i < j; ++i)
            d[j] -= d[i] / (j + 1 - i);
    }
}

/** The sums of differences as sums of slopes, f_n first; the corrector's has f(y_p) before them. scale: h or h^2. */
static void weigh(const double *of_difference, int past, double last, double scale, struct sum *predict,
                  struct sum *correct)
{
    predict->count = past;
    correct->count = past + 1;
    correct->weight[0] = scale * last;
    for (int i = 0; i < past; ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        double w = 0.0;
        for (int j = past - 1; j >= i; --j)
            w += of_difference[j] * binomial(j, i);
        predict->weight[i] = scale * sign * w;
        correct->weight[i + 1] = scale * sign * (w - last * binomial(past, i + 1));
    }
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

/** The slope at step n, of the last K and the one that is made: they follow y in own. */
static double *slope_at(const struct course *c, const struct adams *a, int64_t step)
{
    return c->own + (1 + step % (a->past + 1)) * rates_room(c);
}

static int prepare(struct course *c, struct message *message)
{
    const struct adams *a = c->rival->table;
    double g[TERMS], d[TERMS];
    struct tool *tool = calloc(1, sizeof *tool);
    (void)message;
    if (tool == NULL)
        return -1;
    c->tool = tool;
    once(g);
    twice(g, d);
    weigh(g, a->past, g[a->past], c->h, &tool->predict, &tool->correct);
    weigh(d, a->past, a->share * d[a->past], c->h * c->h, &tool->predict_x, &tool->correct_x);
    tool->start = runge_kutta_create(&tableau_dop853, c->h, rates_room(c));
    tool->predicted = calloc((size_t)rates_room(c), sizeof *tool->predicted);
    rates_start(c, c->own);
    return tool->start != NULL && tool->predicted != NULL ? 0 : -1;
}

static void dismiss(struct course *c)
{
    struct tool *tool = c->tool;
    if (tool == NULL)
        return;
    runge_kutta_destroy(tool->start);
    free(tool->predicted);
    free(tool);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

/** Points the sums to the slopes: from the one at step n back, after the one of the step to come. */
static void point_to_slopes(const struct course *c, const struct adams *a, struct tool *tool)
{
    const int64_t n = c->steps, v = rates_velocities(c);
    for (int i = 0; i <= a->past; ++i) {
        double *slope = slope_at(c, a, n + 1 - i);
        tool->correct.slope[i] = slope;
        tool->correct_x.slope[i] = slope + v;
        if (i > 0) {
            tool->predict.slope[i - 1] = slope;
            tool->predict_x.slope[i - 1] = slope + v;
        }
    }
}

/** to = y + sum, of positions x + h v + sum_x if they are of second order: first, for to may be y. */
static void advance(const struct course *c, const struct adams *a, const struct sum *sum, struct sum *sum_x, double *to)
{
    double *const y = c->own;
    const int64_t v = rates_velocities(c), rest = a->share > 0.0 ? v : 0;
    sum_x->weight[sum_x->count] = c->h;
    sum_x->slope[sum_x->count] = y + v;
    combine(to, y, sum_x->count + 1, sum_x->weight, sum_x->slope, 0, rest);
    combine(to, y, sum->count, sum->weight, sum->slope, rest, rates_room(c));
}

static int step(struct course *c)
{
    const struct adams *a = c->rival->table;
    struct tool *tool = c->tool;
    double *const y = c->own, *const now = slope_at(c, a, c->steps), *const next = slope_at(c, a, c->steps + 1);
    int status = c->steps < a->past ? rates(c, y, now) : VTI_OK;
    if (status == VTI_OK && c->steps < a->past - 1)
        return runge_kutta_step(tool->start, c, y, now);
    if (status != VTI_OK)
        return status;
    point_to_slopes(c, a, tool);
    advance(c, a, &tool->predict, &tool->predict_x, tool->predicted);
    status = rates(c, tool->predicted, next);
    if (status != VTI_OK)
        return status;
    advance(c, a, &tool->correct, &tool->correct_x, y);
    rates_normalise(c, y);
    return a->evaluates_end ? rates(c, y, next) : VTI_OK;
}

static int go(struct course *c, int64_t steps)
{
    return rates_steps(c, steps, step);
}

#define ADAMS(NAME, PAST, SHARE, ABOUT)                                                                                \
    {                                                                                                                  \
        .stepper = RIVAL_STEPPER(NAME, (PAST) + 1, 0.0, 0, NAN, ABOUT),                                                \
        .table = &(const struct adams){PAST, (SHARE) == 0.0, SHARE}, .own_width = ((PAST) + 2) * RATES_ROOM,           \
        .prepare = prepare, .go = go, .show = rates_show, .dismiss = dismiss                                           \
    }
#define PECE "Adams-Bashforth-Moulton PECE of fixed step and order "

const struct rival rival_abm4 = ADAMS("abm4", 3, 0.0, PECE "4, started by DOP853 (textbook)");
const struct rival rival_abm6 = ADAMS("abm6", 5, 0.0, PECE "6, started by DOP853 (textbook)");
const struct rival rival_abm8 = ADAMS("abm8", 7, 0.0, PECE "8, started by DOP853 (textbook)");
const struct rival rival_abm10 = ADAMS("abm10", 9, 0.0, PECE "10, started by DOP853 (textbook)");
const struct rival rival_abm12 = ADAMS("abm12", 11, 0.0, PECE "12, started by DOP853 (textbook)");
const struct rival rival_gear =
    ADAMS("gear", 4, 0.8,
          "Gear's predictor-corrector, six values of positions, five of q and Omega (DEM codes; Allen "
          "and Tildesley 1987)");
