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

/** How many spheres of radius least and more, of the n that there are, a sphere may touch with an overlap of up to the
 *  share o: they are 2 psi apart and more, seen from it, sin psi = (1 - o) least/(radius + least), and z caps of that
 *  angle cover a sphere at most: z (1 - cos psi) <= 2. */
static inline double vti_cage(int64_t n, double radius, double least, double o)
{
    const double sine = o < 1.0 ? (1.0 - o) * (least / (radius + least)) : 0.0, s2 = sine * sine;
    return fmin((double)(n - 1), 2.0 * (1.0 + sqrt(1.0 - s2)) / s2);
}

#endif
