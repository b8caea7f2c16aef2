/* SPDX-License-Identifier: BSD-3-Clause
 * What Hertzian contact between spheres and with walls have in common. */
#ifndef VTI_EFFECTS_HERTZ_H
#define VTI_EFFECTS_HERTZ_H

#include <math.h>

#include "plain.h"
#include "vti.h"

/** Raises the overlap o of *at to that at which a contact has taken up the energy, 2/5 K o^{5/2} = e; at most 1. */
static inline void hertz_deform(double stiffness, double energy, vti_deformation *at)
{
    at->overlap = fmax(at->overlap, fmin(plain_power(2.5 * energy / stiffness, 0.4), 1.0));
}

/** 2/5 K o^{5/2}; what rounding makes of positions that just touch is no overlap. */
static inline double hertz_held(double stiffness, double overlap)
{
    return overlap > 1e-10 ? 0.4 * stiffness * overlap * overlap * sqrt(overlap) : 0.0;
}

/** What a touch of that time changes a momentum by, o being the overlap at its deepest, as a share of the length L at
 *  which it begins. The force there is F = K/L o^{3/2}; with the overlap going as 1 - tau^2, tau from -1 to 1 over the
 *  time, its mean is (3 pi/16) F. */
static inline double hertz_impulse(double stiffness, double length, double overlap, double time)
{
    const double force = stiffness / length * overlap * sqrt(overlap);
    return 0.589 * force * time;
}

/** E/(1 - nu^2) of a material. */
static inline double hertz_modulus(double young, double poisson)
{
    return young / (1.0 - poisson * poisson);
}

#endif
