/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The exponential map: a body turns by exactly h|Omega| about Omega,
 *
 *     q <- (sin(s/2) Omega/|Omega|, cos(s/2)) q,   s = h|Omega|
 *
 * YADE, for spheres, does so in a leapfrog, Omega at half steps, and normalises: V. Smilauer et al., Yade
 * documentation 3rd ed. (2021), DEM formulation, "Motion integration", doi 10.5281/zenodo.5705394. Its velocities
 * are started and read here with half kicks, as their order demands. yade-exp-verlet is the same with velocities at
 * whole steps.
 *
 * SPIRAL in its leapfrog form multiplies from the other side by the same increment of the body's Omega, and need not
 * normalise: C. A. del Valle, V. Angelidakis, S. Roy, J. D. Munoz, T. Poeschel, SPIRAL: An efficient algorithm for
 * the integration of the equation of rotational motion, Comput. Phys. Commun. 297, 109077 (2024). Its third-order
 * Runge-Kutta step for Euler's equations becomes a kick by the moment alone, for a sphere has no gyroscopic term;
 * and as a step about Omega does not change Omega, the inertial frame gives the same numbers as the body's without
 * turning moments into it. The third order that it is named for is that of one step: what it leads to is of second
 * order, as with every leapfrog. */
#include "quaternion.h"
#include "verlet.h"

VTI_INLINE void turn(const double u[3], double q[4])
{
    double r[4];
    if (!quat_turned_exactly(u, q, r))
        return;
    for (int k = 0; k < 4; ++k)
        q[k] = r[k];
}

static int exp_verlet(struct course *c, int64_t steps)
{
    return rival_verlet(c, steps, quat_turn_exactly);
}

static int leapfrog(struct course *c, int64_t steps)
{
    return rival_leapfrog(c, steps, quat_turn_exactly);
}

static int spiral(struct course *c, int64_t steps)
{
    return rival_leapfrog(c, steps, turn);
}

const struct rival rival_yade_exp_verlet = {
    .stepper = RIVAL_STEPPER(
        "yade-exp-verlet", 2, 0.0, 1, 2.0,
        "velocity Verlet, quaternion by the exponential map (YADE's leapfrog with velocities at whole steps)"),
    .go = exp_verlet,
    .takes_forces = 1,
};

const struct rival rival_yade_leapfrog = {
    .stepper = RIVAL_STEPPER("yade-leapfrog", 2, 0.5, 1, 2.0,
                             "leapfrog, quaternion by the exponential map (YADE for spheres; Smilauer et al. 2021)"),
    .go = leapfrog,
    .takes_forces = 1,
};

const struct rival rival_spiral = {
    .stepper =
        RIVAL_STEPPER("spiral", 2, 0.5, 1, 2.0,
                      "leapfrog, quaternion by the exponential map, not normalised (SPIRAL; del Valle et al. 2024)"),
    .go = spiral,
    .takes_forces = 1,
};
