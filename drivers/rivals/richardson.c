/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Velocity Verlet whose quaternion takes one whole and two half normalised steps and combines them by Richardson's
 * extrapolation:
 *
 *     a = normalise(q + (h/2) Omega q)
 *     b = normalise(q + (h/4) Omega q),   b <- normalise(b + (h/4) Omega b)
 *     q <- normalise(2 b - a)
 *
 * The documentation of LAMMPS names it for the quaternions of fix nve/asphere and fix nve/bpm/sphere: A. P. Thompson
 * et al., LAMMPS - a flexible simulation tool for particle-based materials modeling, Comput. Phys. Commun. 271,
 * 108171 (2022). LAMMPS finds Omega again from the angular momentum at the half step; of a sphere both keep their
 * ratio, so that is left out, as in its form for spheres. */
#include "quaternion.h"
#include "verlet.h"

VTI_INLINE void turn(const double u[3], double q[4])
{
    const double half[3] = {0.5 * u[0], 0.5 * u[1], 0.5 * u[2]}, quarter[3] = {0.25 * u[0], 0.25 * u[1], 0.25 * u[2]};
    double a[4], b[4], r[4];
    quat_turned(1.0, half, q, a);
    quat_unit_of(a, a);
    quat_turned(1.0, quarter, q, b);
    quat_unit_of(b, b);
    quat_turned(1.0, quarter, b, r);
    quat_unit_of(r, r);
    for (int k = 0; k < 4; ++k)
        r[k] = 2.0 * r[k] - a[k];
    quat_unit_of(r, q);
}

static int verlet(struct course *c, int64_t steps)
{
    return rival_verlet(c, steps, turn);
}

const struct rival rival_lammps = {
    .stepper =
        RIVAL_STEPPER("lammps-richardson", 2, 0.0, 1, 2.0,
                      "velocity Verlet, quaternion by Richardson iteration (LAMMPS fix nve/asphere and nve/bpm/sphere; "
                      "Thompson et al. 2022)"),
    .go = verlet,
    .takes_forces = 1,
};
