/* SPDX-License-Identifier: BSD-3-Clause
 * Places that are too far from the origin for a step: x += h v is rounded to the spacing of doubles at x. */
#include <float.h>
#include <math.h>

#include "verdict_parts.h"

/** Slower ones, such as bodies where they turn back, stand for nothing. */
static const double slow = 0.01; /* of the fastest of the run */

static double largest_of(const vti_view *view, int64_t i)
{
    const int64_t at = i * view->stride;
    return fmax(fmax(fabs(view->c[0][at]), fabs(view->c[1][at])), fabs(view->c[2][at]));
}

double verdict_rounding(const struct verdict *v, const vti_bodies *bodies, double *fastest)
{
    double most = 0.0;
    for (int64_t i = 0; i < bodies->count; ++i)
        *fastest = fmax(*fastest, largest_of(&bodies->v, i));
    for (int64_t i = 0; i < bodies->count; ++i) {
        const double speed = largest_of(&bodies->v, i);
        if (speed > slow * *fastest && v->h > 0.0) /* where steps vary, it is not known of the first row */
            most = fmax(most, 0.5 * DBL_EPSILON * largest_of(&bodies->x, i) / (v->h * speed));
    }
    return most;
}
