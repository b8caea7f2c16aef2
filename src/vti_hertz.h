/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hertz's law (EQUATIONS 3, E4), for contacts and walls. With o = [1 - gap/D]_+ the overlap as a share of D:
 *
 *     U = 2/5 K o^{5/2},     |F| = (K/D) o^{3/2}                                                                     */
#ifndef VTI_HERTZ_H
#define VTI_HERTZ_H

#include "vti_internal.h"

/** |F| of the overlap o > 0 on the length D. */
static inline double vti_hertz_force(double stiffness, double length, double o)
{
    return stiffness / length * o * sqrt(o);
}

static inline double vti_hertz_energy(double stiffness, double o)
{
    return 0.4 * stiffness * o * o * sqrt(o);
}

/** d^2U/do^2 = (3/2) K o^{1/2} */
static inline double vti_hertz_stiffness(double stiffness, double o)
{
    return 1.5 * stiffness * sqrt(o >= 0.0 ? o : NAN);
}

#endif
