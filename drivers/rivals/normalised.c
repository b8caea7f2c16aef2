/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A quaternion moved along its derivative and normalised:
 *
 *     q <- (q + (h/2) Omega q) / |q + (h/2) Omega q|
 *
 * which turns by 2 atan(h|Omega|/2), as the Cayley map does. In velocity Verlet (v += h/2 F/m, x += h v, Omega +=
 * h/2 RM/J, q as above, forces, v += h/2 F/m, Omega += h/2 RM/J) it is what MercuryDPM does with a particle's
 * orientation: T. Weinhart et al., Fast, flexible particle simulations - An introduction to MercuryDPM, Comput.
 * Phys. Commun. 249, 107129 (2020), and its reference for Quaternion::updateAngularDisplacement. That is VTI-2 on
 * quaternions. In semi-implicit Euler (velocities first, by a whole step) it is the update of simple DEM codes, and
 * VTI-3 on quaternions. */
#include "quaternion.h"
#include "verlet.h"

static int verlet(struct course *c, int64_t steps)
{
    return rival_verlet(c, steps, quat_turn_normalised);
}

/** Semi-implicit Euler has the operations of a leapfrog and no half kick at its ends. */
static int euler(struct course *c, int64_t steps)
{
    return rival_leapfrog(c, steps, quat_turn_normalised);
}

const struct rival rival_mercury = {
    .stepper =
        RIVAL_STEPPER("mercury", 2, 0.0, 1, 2.0,
                      "velocity Verlet, quaternion along its derivative and normalised: VTI-2's map on quaternions "
                      "(MercuryDPM; Weinhart et al. 2020)"),
    .go = verlet,
    .takes_forces = 1,
};

const struct rival rival_quat_euler = {
    .stepper =
        RIVAL_STEPPER("quat-euler", 1, 0.0, 1, 2.0,
                      "semi-implicit Euler, quaternion along its derivative and normalised: VTI-3's map on quaternions "
                      "(simple DEM codes)"),
    .go = euler,
    .takes_forces = 1,
};

/* ---- by the midpoint rule ---------------------------------------------------------------------------------------- */

/* Omelyan's leapfrog: the quaternion's derivative acts on the mean of old and new, q+ = q + (h/2) Omega (q + q+)/2,
 * which has the solution
 *
 *     q <- [(1 - s^2/16) + (h/2) Omega] q / (1 + s^2/16),   s = h|Omega|
 *
 * Turns by 4 atan(s/4) and keeps |q| without normalising. I. P. Omelyan, Algorithm for numerical integration of the
 * rigid-body equations of motion, Phys. Rev. E 58, 1169 (1998); A new leapfrog integrator of rotational motion. The
 * revised angular-momentum approach, Mol. Simul. 22, 213 (1999). His iteration for Omega falls away: a sphere has no
 * gyroscopic term. */
VTI_INLINE void turn_midpoint(const double u[3], double q[4])
{
    const double s = 0.0625 * vti_dot(u, u), k = 1.0 / (1.0 + s), c = (1.0 - s) * k, half = 0.5 * k;
    const double v[3] = {half * u[0], half * u[1], half * u[2]};
    double r[4];
    quat_turned(c, v, q, r);
    for (int i = 0; i < 4; ++i)
        q[i] = r[i];
}

static int leapfrog(struct course *c, int64_t steps)
{
    return rival_leapfrog(c, steps, turn_midpoint);
}

const struct rival rival_omelyan = {
    .stepper =
        RIVAL_STEPPER("omelyan", 2, 0.5, 1, 2.0, "leapfrog, quaternion by the midpoint rule (Omelyan 1998, 1999)"),
    .go = leapfrog,
    .takes_forces = 1,
};

/* Velocity Verlet whose quaternion takes one whole and two half normalised steps and combines them by Richardson's
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
VTI_INLINE void turn_by_richardson(const double u[3], double q[4])
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

static int extrapolated(struct course *c, int64_t steps)
{
    return rival_verlet(c, steps, turn_by_richardson);
}

const struct rival rival_lammps = {
    .stepper =
        RIVAL_STEPPER("lammps-richardson", 2, 0.0, 1, 2.0,
                      "velocity Verlet, quaternion by Richardson iteration (LAMMPS fix nve/asphere and nve/bpm/sphere; "
                      "Thompson et al. 2022)"),
    .go = extrapolated,
    .takes_forces = 1,
};
