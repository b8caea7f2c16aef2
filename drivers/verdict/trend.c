/* SPDX-License-Identifier: BSD-3-Clause */
#include "verdict.h"

#include <math.h>

/** Neighbours become one. */
static void merge(struct trend *s)
{
    enum { HALF = TREND_BLOCKS / 2 };
    for (int k = 0; k < HALF; ++k) {
        s->t[k] = 0.5 * (s->t[2 * k] + s->t[2 * k + 1]);
        s->y[k] = 0.5 * (s->y[2 * k] + s->y[2 * k + 1]);
    }
    s->blocks = HALF;
    s->width *= 2.0;
}

void trend_add(struct trend *s, double t, double y)
{
    if (s->width == 0.0)
        s->width = 1.0;
    if (s->blocks == TREND_BLOCKS)
        merge(s);
    s->t_sum += t;
    s->y_sum += y;
    s->filled += 1.0;
    if (s->filled < s->width)
        return;
    s->t[(int)s->blocks] = s->t_sum / s->width;
    s->y[(int)s->blocks] = s->y_sum / s->width;
    s->blocks += 1.0;
    s->t_sum = s->y_sum = s->filled = 0.0;
}

void trend_slope(const struct trend *s, double *slope, double *error)
{
    enum { LEAST = 4 };
    const int n = (int)s->blocks;
    double t0 = 0.0, y0 = 0.0, tt = 0.0, ty = 0.0, rest = 0.0;
    *slope = *error = NAN;
    if (n < LEAST)
        return;
    for (int k = 0; k < n; ++k) {
        t0 += s->t[k] / n;
        y0 += s->y[k] / n;
    }
    for (int k = 0; k < n; ++k) {
        tt += (s->t[k] - t0) * (s->t[k] - t0);
        ty += (s->t[k] - t0) * (s->y[k] - y0);
    }
    *slope = ty / tt;
    for (int k = 0; k < n; ++k) {
        const double off = s->y[k] - y0 - *slope * (s->t[k] - t0);
        rest += off * off;
    }
    *error = sqrt(rest / (n - 2) / tt);
}
