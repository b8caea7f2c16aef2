/* SPDX-License-Identifier: BSD-3-Clause
 * The choice of steps in plain arithmetic is GSL's, to the last bits, and so are Student's quantiles. */
#include <gsl/gsl_cdf.h>

#include "control.h"
#include "fit.h"
#include "support.h"

enum { CASES = 100000, NUMBERS = 3 };

TEST(steps_as_gsl_chooses_them)
{
    static const double epsilon = 1e-3;
    gsl_odeiv2_control *ours = control_new(epsilon), *theirs = gsl_odeiv2_control_y_new(epsilon, epsilon);
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, NUMBERS);
    rng g = rng_seed(5);
    int changed[3] = {0};
    for (int i = 0; i < CASES; ++i) {
        const double size = i % 2 ? 10.0 : 1.0, rate[NUMBERS] = {0.0};
        double y[NUMBERS], error[NUMBERS], h = 0.1, expected = 0.1;
        for (int k = 0; k < NUMBERS; ++k) {
            y[k] = uniform(&g, -2, 2);
            error[k] = epsilon * pow(10.0, size * uniform(&g, -0.6, 0.4)) * (k - 1);
        }
        const int way = gsl_odeiv2_control_hadjust(ours, step, y, error, rate, &h);
        assert_int_equal(way, gsl_odeiv2_control_hadjust(theirs, step, y, error, rate, &expected));
        assert_close(h, expected, 4 * EPS * expected);
        ++changed[way + 1];
    }
    for (int way = 0; way < 3; ++way)
        assert_true(changed[way] > CASES / 20);
    gsl_odeiv2_step_free(step);
    gsl_odeiv2_control_free(ours);
    gsl_odeiv2_control_free(theirs);
}

/** The largest of errors one of which is NaN is not that of the others. */
TEST(nan_is_no_small_error)
{
    gsl_odeiv2_control *ours = control_new(1e-3);
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, NUMBERS);
    for (int k = 0; k < 2 * NUMBERS; ++k) {
        double y[NUMBERS] = {1.0, 1.0, 1.0}, error[NUMBERS] = {0.0}, h = 0.1;
        const double rate[NUMBERS] = {0.0};
        (k < NUMBERS ? y : error)[k % NUMBERS] = NAN;
        assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, error, rate, &h), GSL_ODEIV_HADJ_DEC);
        assert_close(h, 0.02, EPS);
    }
    gsl_odeiv2_step_free(step);
    gsl_odeiv2_control_free(ours);
}

/** With a floor an error is small that is below the floor, and it is noted; without it, or above it, it is not. */
TEST(no_less_than_rounding_leaves)
{
    enum { STEPS = 4 };
    const double noise[NUMBERS] = {0.0, 1e-9, 1e-10}, rate[NUMBERS] = {0.0}, y[NUMBERS] = {1.0, 1.0, 1.0};
    const double at[NUMBERS] = {0.0, 0.8e-10, 0.0}, below[NUMBERS] = {0.0, 1e-13, 1e-13};
    const double other[NUMBERS] = {1e-13, 0.0, 0.0}, above[NUMBERS] = {0.0, 0.0, 2e-11};
    struct control_floor floor = {noise, 0.0, 0.0};
    gsl_odeiv2_control *ours = control_new(1e-14);
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, NUMBERS);
    double h = 0.1;
    assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, at, rate, &h), GSL_ODEIV_HADJ_DEC);
    control_stop_at(ours, &floor);
    h = 0.1;
    assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, other, rate, &h), GSL_ODEIV_HADJ_DEC);
    h = 0.1;
    assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, above, rate, &h), GSL_ODEIV_HADJ_DEC);
    assert_true(floor.highest == 0.0 && floor.squares == 0.0);
    for (int k = 0; k < STEPS; ++k) {
        h = 0.1;
        assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, at, rate, &h), GSL_ODEIV_HADJ_NIL);
        assert_int_equal(gsl_odeiv2_control_hadjust(ours, step, y, below, rate, &h), GSL_ODEIV_HADJ_INC);
    }
    assert_close(floor.highest, 1e-10, 4 * EPS * 1e-10);
    assert_close(floor.squares, 2 * STEPS * 1e-20, 16 * EPS * 1e-19);
    gsl_odeiv2_step_free(step);
    gsl_odeiv2_control_free(ours);
}

TEST(quantiles)
{
    for (int freedom = 1; freedom < 64; ++freedom)
        assert_close(fit_student(freedom), gsl_cdf_tdist_Pinv(0.975, freedom), 1e-12 * fit_student(freedom));
}

RUN_TESTS(cmocka_unit_test(steps_as_gsl_chooses_them), cmocka_unit_test(nan_is_no_small_error),
          cmocka_unit_test(no_less_than_rounding_leaves), cmocka_unit_test(quantiles))
