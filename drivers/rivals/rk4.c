/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The classical Runge-Kutta method on y = (x, v, q, Omega):
 *
 *     k1 = f(y), k2 = f(y + h k1/2), k3 = f(y + h k2/2), k4 = f(y + h k3)
 *     y <- y + h (k1 + 2 k2 + 2 k3 + k4)/6,   q <- q/|q|
 *
 * E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), section II.1. */
#include "rates.h"

enum { STATES = 4 };

/** stage = y + t k, sum += 2 k: one pass for both. */
static void inner(const double *restrict y, double t, const double *restrict k, double *restrict sum,
                  double *restrict stage, int64_t n)
{
    for (int64_t j = 0; j < n; ++j) {
        stage[j] = y[j] + t * k[j];
        sum[j] += 2.0 * k[j];
    }
}

/** stage = y + t k */
static void first(const double *restrict y, double t, const double *restrict k, double *restrict stage, int64_t n)
{
    for (int64_t j = 0; j < n; ++j)
        stage[j] = y[j] + t * k[j];
}

/** y += t (sum + k) */
static void last(double *restrict y, double t, const double *restrict sum, const double *restrict k, int64_t n)
{
    for (int64_t j = 0; j < n; ++j)
        y[j] += t * (sum[j] + k[j]);
}

/** own is y, the sum of slopes, a slope, and where that is taken. */
static int step(struct course *c, int64_t n)
{
    const double h = c->h;
    double *const y = c->own, *const sum = y + n, *const k = sum + n, *const stage = k + n;
    int status = rates(c, y, sum);
    first(y, 0.5 * h, sum, stage, n);
    if (status == VTI_OK)
        status = rates(c, stage, k);
    inner(y, 0.5 * h, k, sum, stage, n);
    if (status == VTI_OK)
        status = rates(c, stage, k);
    inner(y, h, k, sum, stage, n);
    if (status == VTI_OK)
        status = rates(c, stage, k);
    if (status != VTI_OK)
        return status;
    last(y, h / 6.0, sum, k, n);
    rates_normalise(c, y);
    return VTI_OK;
}

static int go(struct course *c, int64_t steps)
{
    const int64_t n = rates_width(c);
    int status = VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        status = step(c, n);
        c->steps += status == VTI_OK;
    }
    return status;
}

static int prepare(struct course *c, struct message *message)
{
    (void)message;
    rates_start(c, c->own);
    return 0;
}

static void show(struct course *c)
{
    rates_look_at(c, c->own);
}

const struct rival rival_rk4 = {
    .stepper =
        RIVAL_STEPPER("rk4", 4, 0.0, 4, 2.8284271247461903,
                      "classical Runge-Kutta on (x, v, q, Omega), quaternion normalised after each step (textbook)"),
    .own_width = STATES * RATES_WIDTH,
    .prepare = prepare,
    .go = go,
    .show = show,
};
