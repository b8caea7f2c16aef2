/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Attitude after very many compositions with a steady increment: test_long_attitude [compositions]. The incremental
 * form of (+) does not repeat the same rounding error each time, so the error grows as sqrt(N); the direct form would
 * be off by 4e6 eps after 1e8. The truth is the closed form, axis and N times the angle of one increment. */
#include "support.h"

static long compositions = 1000000;

/* 1e8 compositions may cost 2e4 eps, others sqrt(N) of it; 64 eps for a start, when sqrt is not yet the law */
static double bound(void)
{
    return EPS * (64 + 2e4 * sqrt((double)compositions / 1e8));
}

/** Composes by turn(c, u) and returns the error. */
static double error_after(double c, const double u[3], double side, rotor start)
{
    const double q[4] = {(double)start.x, (double)start.y, (double)start.z, (double)start.w};
    double a[3];
    vti_rrv_from_quat_xyzw(q, a);
    start = quat_of_alpha(a);
    for (long i = 0; i < compositions; ++i)
        vti_rrv_turn_side(c, u, side, a);
    /* N theta has an error of N theta 2^-64, 3e-14 rad at 1e8 times 0.01: 1e2 eps, well below the bound */
    const long double size = sqrtl((long double)u[0] * u[0] + (long double)u[1] * u[1] + (long double)u[2] * u[2]);
    const rotor all = quat_turn(u, fmodl((long double)compositions * 2 * atan2l(size, c), 4 * PI_L));
    const rotor truth = side > 0 ? quat_times(all, start) : quat_times(start, all);
    return quat_distance(quat_of_alpha(a), truth);
}

TEST(steady_spatial_increment)
{
    const double u[3] = {3e-3, 4e-3, -5e-3};
    const rotor identity = {0, 0, 0, 1};
    const double error = error_after(2.0, u, 1, identity);
    print_message("%ld compositions: %.3g eps, bound %.3g eps\n", compositions, error / EPS, bound() / EPS);
    assert_below(error, bound());
}

TEST(steady_increment_in_the_bodys_frame)
{
    const double u[3] = {-1e-3, 7e-3, 2e-3}, start[4] = {0.1, -0.7, 0.5, 0.5};
    const double error = error_after(1.9, u, -1, quat_of_xyzw(start));
    print_message("%ld compositions: %.3g eps, bound %.3g eps\n", compositions, error / EPS, bound() / EPS);
    assert_below(error, bound());
}

int main(int argc, char **argv)
{
    if (argc > 1)
        compositions = strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_spatial_increment),
        cmocka_unit_test(steady_increment_in_the_bodys_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
