/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The paper's pendulum over very many steps: test_long_pendulum [steps]. |R rho0| = 1 and R rho0 . Omega = 0 are exact
 * invariants of every stepper here (the kick is normal to the arm, the drift turns both), so that what is seen of them
 * is rounding; the energy of a symplectic map keeps its band. */
#include "rig.h"

static long steps = 100000;

typedef struct band {
    double low, high;
} band;

typedef struct record {
    double arm_length, arm_spin; /* the largest | |R rho0| - 1 |, and |R rho0 . Omega| */
    band first, last;            /* of the energy in the first and the last tenth */
} record;

static void widen(band *b, double value)
{
    b->low = fmin(b->low, value);
    b->high = fmax(b->high, value);
}

static record run(const vti_stepper *method, enum rig_storage storage)
{
    const double h = 1.0 / 64;
    rig p = rig_of_the_paper(storage);
    const vti_bodies b = rig_bodies(&p);
    record r = {0, 0, {INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    rig_moment(&p);
    vti_step_start(method, h, &b);
    for (long i = 0; i < steps; ++i) {
        vti_step_begin(method, h, &b, NULL);
        rig_moment(&p);
        vti_step_finish(method, h, &b);
        rig read = p;
        const vti_bodies copy = rig_bodies(&read);
        vti_step_sync(method, h, &copy);
        double arm[3];
        vti_pendulum_arm(&p.pendulum, &b, 0, arm);
        r.arm_length = fmax(r.arm_length, fabs(vti_norm(arm) - 1));
        r.arm_spin = fmax(r.arm_spin, fabs(vti_dot(arm, read.omega)));
        if (i < steps / 10)
            widen(&r.first, rig_energy(&read));
        else if (i >= steps - steps / 10)
            widen(&r.last, rig_energy(&read));
    }
    return r;
}

static const char *const names[] = {"vti1", "vti2", "vti3", "vti3-leapfrog"};

/** Brouwer's law: in each step roundings add to R rho0 . Omega, at random, 0.6 eps of its factors' sizes; residuals
 *  leave a twentieth of that, the arm's own rounding. 8 eps for the evaluation itself. */
static double random_walk(enum rig_storage storage)
{
    const double omega = 1.87; /* sqrt(2 (E0 + 1)), at the bottom */
    return EPS * omega * (8 + (storage == RIG_RESIDUALS ? 0.03 : 0.6) * sqrt((double)steps));
}

static void check(const char *name, enum rig_storage storage)
{
    const record r = run(vti_stepper_find(name), storage);
    const double width = r.first.high - r.first.low, width_last = r.last.high - r.last.low;
    print_message("%-14s %s: arm %.2g, arm.Omega %.2g, energy %.6g .. %.6g, then %.2g and %.2g of the band off\n", name,
                  storage == RIG_RESIDUALS ? "residuals"
                  : storage == RIG_QUAT    ? "quaternion"
                                           : "plain",
                  r.arm_length, r.arm_spin, r.first.low, r.first.high, (r.last.low - r.first.low) / width,
                  (r.last.high - r.first.high) / width);
    assert_below(r.arm_length, 1e-15);
    assert_below(r.arm_spin, random_walk(storage));
    if (storage == RIG_RESIDUALS)
        assert_below(r.arm_spin, 2e-13);
    /* The motion is quasi-periodic with two phases, so both tenths sample one band, and n samples miss its rim by about
     * 1/n of its width. A drift would move the band, a loss of stability would widen it. */
    const double slack = 10 / (double)(steps / 10) * width;
    assert_close(width_last, width, slack);
    assert_close(r.last.low, r.first.low, slack);
    assert_close(r.last.high, r.first.high, slack);
}

TEST(with_residuals)
{
    for (int k = 0; k < 4; ++k)
        check(names[k], RIG_RESIDUALS);
}

TEST(plain)
{
    for (int k = 0; k < 4; ++k)
        check(names[k], RIG_ALPHA);
}

TEST(as_quaternion)
{
    for (int k = 0; k < 4; ++k)
        check(names[k], RIG_QUAT);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        steps = strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_residuals),
        cmocka_unit_test(plain),
        cmocka_unit_test(as_quaternion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
