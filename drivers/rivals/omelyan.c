/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Omelyan's leapfrog: the quaternion's derivative acts on the mean of old and new, q+ = q + (h/2) Omega (q + q+)/2,
 * which has the solution
 *
 *     q <- [(1 - s^2/16) + (h/2) Omega] q / (1 + s^2/16),   s = h|Omega|
 *
 * Turns by 4 atan(s/4) and keeps |q| without normalising. I. P. Omelyan, Algorithm for numerical integration of the
 * rigid-body equations of motion, Phys. Rev. E 58, 1169 (1998); A new leapfrog integrator of rotational motion. The
 * revised angular-momentum approach, Mol. Simul. 22, 213 (1999). His iteration for Omega falls away: a sphere has no
 * gyroscopic term. */
#include "quaternion.h"
#include "verlet.h"

VTI_INLINE void turn(const double u[3], double q[4])
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
    return rival_leapfrog(c, steps, turn);
}

const struct rival rival_omelyan = {
    .stepper =
        RIVAL_STEPPER("omelyan", 2, 0.5, 1, 2.0, "leapfrog, quaternion by the midpoint rule (Omelyan 1998, 1999)"),
    .go = leapfrog,
    .takes_forces = 1,
};
