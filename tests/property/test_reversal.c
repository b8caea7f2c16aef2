/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Time reversal: N steps, Omega turned about, N steps, and the body is back. VTI-3 is not reversible, and shows it. */
#include "rig.h"

enum { STEPS = 1000 };

static double return_error(const vti_stepper *method, rig p, double h)
{
    const rig start = p;
    rig_run(&p, method, h, STEPS);
    for (int k = 0; k < 3; ++k) {
        p.omega[k] = -p.omega[k];
        p.omega_low[k] = -p.omega_low[k];
    }
    rig_run(&p, method, h, STEPS);
    for (int k = 0; k < 3; ++k)
        p.omega[k] = -p.omega[k];
    return rig_difference(&p, &start);
}

/** Each of 2 N stages errs by 8 eps at worst in Omega and attitude; an error in Omega grows linearly, by h each step,
 *  as the pendulum's motion is regular: after n steps 8 eps sqrt(n) (1 + n h) if the errors are independent. */
static double rounding(const vti_stepper *method, double h)
{
    const double n = 2.0 * STEPS;
    return 8 * EPS * sqrt(n * (double)method->stages) * (1 + n * h);
}

TEST(methods_return_if_they_say_so)
{
    const double h = 1.0 / 64;
    rng g = rng_seed(221);
    int reversible = 0;
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 24; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            const enum rig_storage storage = (enum rig_storage)(trial % 3);
            rig p = trial < 3 ? rig_of_the_paper(storage) : rig_random(&g, storage);
            p.frame = (int)method->frame;
            const double error = return_error(method, p, h);
            reversible += (int)method->reversible;
            if (method->reversible)
                assert_below(error, rounding(method, h));
            else
                assert_true(error > 1e-4); /* first order: h times the moment, which is not 0 */
        }
    assert_int_equal(reversible, 24 * (vti_stepper_count() - 1)); /* all but vti3 */
}

RUN_TESTS(cmocka_unit_test(methods_return_if_they_say_so))
