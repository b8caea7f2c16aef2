/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The methods are of the literature:
 *
 *     rk4      E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.1
 *     pd8      P. J. Prince, J. R. Dormand, High order embedded Runge-Kutta formulae, J. Comput. Appl. Math. 7, 67
 *              (1981), RK8(7)13M: what GSL calls rk8pd, without its error estimate
 *     dop853   Hairer, Norsett, Wanner, II.5 and II.10: of order 8, without its error estimates (dop853.c has them)
 *     vern9    J. H. Verner, Explicit Runge-Kutta pairs with lower stage-order, Numer. Algorithms 65, 555 (2013): the
 *              efficient pair 9(8), whose last stage serves the estimate alone and is left out */
#include "runge_kutta.h"

#include <stdlib.h>
#include <string.h>

#include "combine.h"
#include "rates.h"

/** h times the weights that are not zero, and the slopes that they belong to. */
struct sum {
    int count;
    double weight[TABLEAU_STAGES];
    double *slope[TABLEAU_STAGES];
};

struct runge_kutta {
    const struct tableau *tableau;
    int stages;
    int64_t n;
    struct sum sum[TABLEAU_STAGES + 1]; /* of the stages, and of the step */
    double *slope[TABLEAU_STAGES], *stage;
};

static void list(struct sum *sum, const double *weight, double h, int count, double *const *slope)
{
    sum->count = 0;
    for (int s = 0; s < count; ++s)
        if (weight[s] != 0.0) {
            sum->weight[sum->count] = h * weight[s];
            sum->slope[sum->count++] = slope[s];
        }
}

struct runge_kutta *runge_kutta_create(const struct tableau *tableau, double h, int64_t n)
{
    struct runge_kutta *m = calloc(1, sizeof *m);
    if (m == NULL)
        return NULL;
    m->tableau = tableau;
    m->stages = tableau->stages;
    m->n = n;
    m->stage = calloc((size_t)((m->stages + 1) * n), sizeof *m->stage);
    if (m->stage == NULL) {
        free(m);
        return NULL;
    }
    for (int s = 0; s < m->stages; ++s)
        m->slope[s] = m->stage + (s + 1) * n;
    runge_kutta_resize(m, h);
    return m;
}

void runge_kutta_resize(struct runge_kutta *m, double h)
{
    for (int s = 0; s < m->stages; ++s)
        list(&m->sum[s], m->tableau->a[s], h, s, m->slope);
    list(&m->sum[m->stages], m->tableau->b, h, m->stages, m->slope);
}

double *const *runge_kutta_slopes(const struct runge_kutta *m)
{
    return m->slope;
}

void runge_kutta_destroy(struct runge_kutta *m)
{
    if (m != NULL)
        free(m->stage);
    free(m);
}

static void add_up(const struct runge_kutta *m, const struct sum *sum, const double *y, double *to)
{
    combine(to, y, sum->count, sum->weight, sum->slope, 0, m->n);
}

int runge_kutta_step(struct runge_kutta *m, struct course *c, double *y, const double *first)
{
    int status = VTI_OK;
    if (first != NULL)
        memcpy(m->slope[0], first, (size_t)m->n * sizeof *first);
    else
        status = rates(c, y, m->slope[0]);
    for (int s = 1; s < m->stages && status == VTI_OK; ++s) {
        add_up(m, &m->sum[s], y, m->stage);
        status = rates(c, m->stage, m->slope[s]);
    }
    if (status != VTI_OK)
        return status;
    add_up(m, &m->sum[m->stages], y, y);
    rates_normalise(c, y);
    return VTI_OK;
}

/* ---- as rivals --------------------------------------------------------------------------------------------------- */

static int prepare(struct course *c, struct message *message)
{
    (void)message;
    rates_start(c, c->own);
    c->tool = runge_kutta_create(c->rival->table, c->h, rates_room(c));
    return c->tool != NULL ? 0 : -1;
}

static int step(struct course *c)
{
    return runge_kutta_step(c->tool, c, c->own, NULL);
}

static int go(struct course *c, int64_t steps)
{
    return rates_steps(c, steps, step);
}

static void dismiss(struct course *c)
{
    runge_kutta_destroy(c->tool);
}

#define RUNGE_KUTTA(NAME, ORDER, EVALS, REACH, TABLEAU, ABOUT)                                                         \
    {                                                                                                                  \
        .stepper = RIVAL_STEPPER(NAME, ORDER, 0.0, EVALS, REACH, ABOUT), .table = &(TABLEAU), .own_width = RATES_ROOM, \
        .prepare = prepare, .go = go, .show = rates_show, .dismiss = dismiss, .general = RIVAL_OF_BOTH                 \
    }

const struct rival rival_rk4 =
    RUNGE_KUTTA("rk4", 4, 4, 2.8284271247461903, tableau_rk4,
                "classical Runge-Kutta on (x, v, q, Omega), quaternion normalised after each step (textbook)");
const struct rival rival_pd8 =
    RUNGE_KUTTA("pd8", 8, 13, NAN, tableau_pd8,
                "Runge-Kutta of order 8 with the tableau of rk8pd, compiled here (Prince and Dormand 1981)");
const struct rival rival_dop853 =
    RUNGE_KUTTA("dop853", 8, 12, NAN, tableau_dop853,
                "Runge-Kutta of order 8 with the tableau of DOP853 and fixed steps (Hairer, Norsett, Wanner 1993)");
const struct rival rival_vern9 =
    RUNGE_KUTTA("vern9", 9, 15, NAN, tableau_vern9,
                "Runge-Kutta of order 9 with the tableau of the efficient 9(8) and fixed steps (Verner 2013)");
