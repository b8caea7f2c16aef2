/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Effects, seals, probes and measures of bodies that the checks refuse: each returns the same status, or NaN where it
 * returns none. */
#ifndef VTI_TESTS_EVERY_CALL_H
#define VTI_TESTS_EVERY_CALL_H

#include "support.h"

/** Every effect alone and all together; energies are NaN; the bound of the step is not written. */
static inline void effects_refuse(const vti_bodies *bad, int status)
{
    static const double one = 1, rest[4] = {-1, 0, 0, 1}, plane[4] = {0, 0, 1, 0};
    static const int64_t pair[2] = {0, 1};
    static const vti_pendulum pendulum = {1.0, {0, 0, 1}};
    static const vti_gravity gravity = {{0, 0, -1}};
    const vti_scalars k = vti_scalars_one(&one);
    const vti_bonds bonds = {1, pair, 0, rest, k, k, k, VTI_SHEAR_OBJECTIVE, NULL};
    const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = k, .stiffness = 1.0};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = k, .stiffness = 1.0};
    const vti_effect effects[5] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                   vti_gravity_effect(&gravity), vti_pendulum_effect(&pendulum)};
    for (int i = 0; i < 5; ++i) {
        assert_int_equal(vti_apply(&effects[i], 1, bad), status);
        assert_true(isnan(vti_energy(&effects[i], 1, bad)));
    }
    assert_int_equal(vti_apply(effects, 5, bad), status);
    assert_true(isnan(vti_energy(NULL, 0, bad)));
    double scratch[16], arm[3];
    vti_stable found = {7, 7, 7, 7, 7};
    assert_int_equal(vti_stable_step(effects, 5, bad, NULL, scratch, &found), status);
    assert_true(found.h == 7 && found.i == 7);
    vti_pendulum_arm(&pendulum, bad, 0, arm);
    assert_true(isnan(arm[0]));
}

static inline void measures_are_nan(const vti_bodies *bad, const vti_bodies *good)
{
    const double about[3] = {0, 0, 0};
    double r[3][3];
    vti_momentum(bad, r[0]);
    vti_spin(bad, r[1]);
    vti_angular_momentum(bad, about, r[2]);
    const double all[] = {vti_kinetic_translation(bad),
                          vti_kinetic_rotation(bad),
                          vti_max_turn(1, bad),
                          vti_h1_density(bad),
                          vti_h1_distance(bad, good),
                          vti_h1_distance(good, bad),
                          vti_attitude_distance(bad, good),
                          vti_attitude_distance(good, bad),
                          r[0][0],
                          r[1][1],
                          r[2][2]};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        assert_true(isnan(all[k]));
}

/** All calls of this file. The good bodies are those that the bad ones were. */
static inline void every_call_refuses(const vti_bodies *bad, const vti_bodies *good, int status)
{
    const vti_stepper *chin4 = vti_stepper_find("chin4");
    vti_bodies copy = *bad;
    assert_int_equal(vti_bodies_seal(&copy), status);
    assert_int_equal(copy.sealed, 0);
    assert_int_equal(vti_step_probe(chin4, 0, 0.5, bad, good), status);
    assert_int_equal(vti_step_probe(chin4, 0, 0.5, good, bad), status);
    effects_refuse(bad, status);
    measures_are_nan(bad, good);
}

#endif
