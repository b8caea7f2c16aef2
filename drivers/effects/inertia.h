/* SPDX-License-Identifier: BSD-3-Clause
 * Moments of inertia of bodies. */
#ifndef VTI_INERTIA_H
#define VTI_INERTIA_H

#include "vti.h"

#include <math.h>

/** J of a solid sphere, 2/5 m R^2. */
static inline double inertia_of_sphere(double mass, double diameter)
{
    return 0.4 * mass * (0.5 * diameter) * (0.5 * diameter);
}

/** The least moment of inertia of body i; infinite where there is none. */
static inline double inertia_least(const vti_bodies *b, int64_t i)
{
    const int64_t at = i * b->moments.stride;
    if (b->moments.c[0] != NULL)
        return fmin(fmin(b->moments.c[0][at], b->moments.c[1][at]), b->moments.c[2][at]);
    return b->inertia.p != NULL ? b->inertia.p[i * b->inertia.stride] : INFINITY;
}

#endif
