/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_step_check: which steppers go with an effect that takes energy out of the motion. */
#include "support.h"

/** Dissipation stepped back in time is gain: steppers with a negative kick or drift refuse it, and no others. */
TEST(no_step_back)
{
    const char *const forwards[] = {"vti1", "vti2", "vti3", "vti3-leapfrog", "vti1-body", "exact", "chin4"};
    const vti_gravity gravity = {{0, 0, 1}};
    vti_effect effects[2] = {vti_gravity_effect(&gravity), vti_gravity_effect(&gravity)};
    int64_t passed = 0;
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int where = 0; where < 3; ++where) {
            const vti_stepper *method = vti_stepper_at(k);
            int expected = where == 2 ? VTI_OK : VTI_E_DISSIPATES;
            for (int i = 0; i < 7; ++i)
                if (strcmp(method->name, forwards[i]) == 0)
                    expected = VTI_OK;
            effects[0].dissipates = where == 0;
            effects[1].dissipates = where == 1;
            assert_int_equal(vti_step_check(method, effects, 2), expected);
            assert_int_equal(vti_step_check(method, effects, 0), VTI_OK);
            passed += expected == VTI_OK;
        }
    assert_int_equal(passed, 7 * 3 + vti_stepper_count() - 7);
    assert_non_null(strstr(vti_status_text(VTI_E_DISSIPATES), "negative coefficients: vti2, exact or chin4"));

    /* each coefficient counts, the last ones too */
    effects[0].dissipates = 1;
    for (int k = 0; k < 4; ++k) {
        double kick[] = {0.5, 0.5}, drift[] = {0.5, 0.5};
        const vti_stepper own = {
            .name = "own", .law = VTI_LAW_CAYLEY, .frame = 1, .stages = 1, .kick = kick, .drift = drift};
        assert_int_equal(vti_step_check(&own, effects, 1), VTI_OK);
        (k < 2 ? kick : drift)[k % 2] = -0.5;
        assert_int_equal(vti_step_check(&own, effects, 1), VTI_E_DISSIPATES);
    }
    /* the library's own effects take nothing out */
    const vti_pendulum pendulum = {1, {0, 0, 1}};
    const vti_bonds bonds = {0};
    const double one = 1;
    const vti_contacts contacts = {.diameter = vti_scalars_one(&one)};
    const vti_walls walls = {0};
    const vti_effect all[] = {vti_pendulum_effect(&pendulum), vti_gravity_effect(&gravity), vti_bonds_effect(&bonds),
                              vti_contacts_effect(&contacts), vti_walls_effect(&walls)};
    assert_int_equal(vti_step_check(vti_stepper_find("kl8"), all, 5), VTI_OK);
}

RUN_TESTS(cmocka_unit_test(no_step_back))
