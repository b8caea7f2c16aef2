/* SPDX-License-Identifier: BSD-3-Clause */
#include "verdict.h"

#include <stddef.h>

#include "plain.h"

static const double pi = PLAIN_PI;

/** The angle of the point (x, y), in [0, 2 pi). */
static double direction(double x, double y)
{
    const double acute = vti_arc(fabs(y), fabs(x));
    if (y >= 0.0)
        return x >= 0.0 ? acute : pi - acute;
    return x < 0.0 ? pi + acute : 2.0 * pi - acute;
}

double turning_angle(int64_t law, double s)
{
    const double far = 0x1p30, s2 = s * s; /* where the laws themselves settle on a half turn */
    if (!(s > 0.0))
        return 0.0;
    if (law == VTI_LAW_CLOSED)
        return s < 1.0 ? 2.0 * direction(1.0 + sqrt(1.0 - s2), s) : 0.5 * pi;
    if (!(s < far))
        return pi;
    if (law == VTI_LAW_CAYLEY)
        return 2.0 * direction(2.0, s);
    if (law == VTI_LAW_EXACT)
        return 2.0 * direction(1.0 - s2 / 10.0, (0.5 - s2 / 120.0) * s);
    return 2.0 * direction(1.0 - s2 * (180.0 - s2) / 1680.0, (0.5 - s2 / 84.0) * s);
}

double turning_error(const vti_stepper *stepper, double s)
{
    double sum = 0.0;
    for (int64_t k = 0; stepper->drift != NULL && k <= stepper->stages; ++k) {
        const double part = fabs(stepper->drift[k]) * s;
        sum += fabs(turning_angle(stepper->law, part) - part);
    }
    return s > 0.0 ? sum / s : 0.0;
}

double turning_tolerance(const vti_stepper *stepper)
{
    return stepper->law == VTI_LAW_EXACT || stepper->law == VTI_LAW_EXACT9 ? 1e-3 : 0.1;
}
