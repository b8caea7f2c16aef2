/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The pendulum's moment is minus the derivative of its energy by a spatial rotation: RM . e = -dU(exp(t e) R)/dt. */
#include "rig.h"

static double energy_turned(const rig *p, const double axis[3], double angle)
{
    rig q = *p;
    vti_bodies b = rig_bodies(&q);
    b.omega = vti_view_none();
    const vti_effect effect = vti_pendulum_effect(&q.pendulum);
    rig_set_attitude(&q, quat_times(quat_turn(axis, angle), rig_attitude(p)));
    return vti_energy(&effect, 1, &b);
}

TEST(moment_is_minus_the_gradient)
{
    rng g = rng_seed(211);
    for (int trial = 0; trial < 3000; ++trial) {
        rig p = rig_random(&g, trial % 2 ? RIG_QUAT : RIG_ALPHA);
        const double size = p.pendulum.weight * vti_norm(p.pendulum.rho0), t = cbrt(EPS);
        rig_moment(&p);
        for (int k = 0; k < 4; ++k) {
            double e[3] = {k == 0, k == 1, k == 2};
            if (k == 3)
                random_unit(&g, 3, e);
            const double slope = (energy_turned(&p, e, t) - energy_turned(&p, e, -t)) / (2 * t);
            /* t^2/6 |U'''| of the difference quotient, |U'''| <= size; energies rounded by 16 eps, over t */
            assert_close(vti_dot(p.moment, e), -slope, size * (t * t / 6 + 16 * EPS / t));
        }
    }
}

RUN_TESTS(cmocka_unit_test(moment_is_minus_the_gradient))
