/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Motions that repeat the same small sum very often: test_steady [drifts]. Steady spin, steady precession, and
 * rotations so small that plain sums lose them. Every stepper plays as many drifts, so that those of more stages play
 * fewer steps. */
#include <time.h>

#include "rig.h"

#include "hard.h"

static long drifts = 1000000;

static long steps_of(const vti_stepper *method)
{
    return drifts / (long)method->stages;
}

/* ---- spin -------------------------------------------------------------------------------------------------------- */

/** Independent roundings: after 1e8 drifts 2e4 eps, else sqrt(N) of it, and 64 eps for a start. The increment itself,
 *  where it is not t Omega, rounds too and alike in every step: eps of the whole angle. So does R^T Omega in the body's
 *  frame. N h|Omega| in long double is good to N 2^-64. */
TEST(steady_spin)
{
    const double alpha[3] = {0.5, -0.25, 1}, omega[3] = {7e-3, 1e-2, -4e-3};
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        static troupe t;
        const vti_stepper *method = vti_stepper_at(k);
        const long steps = steps_of(method);
        troupe_free(&t, method, alpha, omega);
        double kept[3];
        memcpy(kept, t.c.omega[0], sizeof kept);
        for (long i = 0; i < steps; ++i)
            troupe_step(&t, 1, NULL);
        assert_same_bits(kept, t.c.omega[0], 3);
        const long double s = sqrtl((long double)omega[0] * omega[0] + (long double)omega[1] * omega[1] +
                                    (long double)omega[2] * omega[2]);
        const rotor all = quat_turn(omega, fmodl((long double)steps * step_angle(method, s), 4 * PI_L));
        const int alike = (method->frame == VTI_FRAME_BODY) + (method->law != VTI_LAW_CAYLEY);
        const double increments = alike * 2 * EPS * (double)steps * (double)s;
        const double off = quat_distance(quat_of_alpha(t.c.alpha[0]), quat_times(all, quat_of_alpha(alpha)));
        assert_below(off, EPS * (64 + 2e4 * sqrt((double)drifts / 1e8)) + increments);
        robust("steady spin, 1e6 drifts (1e8 in the long test)", method->name,
               "exact: by the closed form within 2 eps sqrt(N)%s", alike == 0 ? "" : " and 2 eps of the whole angle");
    }
}

/* ---- precession -------------------------------------------------------------------------------------------------- */

/** A fast pendulum with its arm at 60 degrees to the field: Omega = a e3 + b arm goes round with it if a b = -m g/J. */
static rig top(const vti_stepper *method)
{
    rig p = rig_of_the_paper(RIG_ALPHA);
    const double b = 4, a = -1 / b, e1[3] = {1, 0, 0};
    double arm[3];
    rig_set_attitude(&p, quat_turn(e1, PI_L / 3));
    p.frame = (int)method->frame;
    vti_rrv_rotate(p.alpha, p.pendulum.rho0, arm);
    for (int k = 0; k < 3; ++k)
        p.omega[k] = (k == 2 ? a : 0) + b * arm[k];
    if (p.frame == VTI_FRAME_BODY)
        vti_rrv_rotate_back(p.alpha, p.omega, p.omega);
    return p;
}

/** The inclination cos = arm.e3 has the same band in the last tenth as in the first: nutation, which the step's own
 *  error starts, does not grow. */
TEST(steady_precession)
{
    const double h = 1.0 / 16;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        rig p = top(method);
        const vti_bodies b = rig_bodies(&p);
        const long n = steps_of(method) / 100;
        double low[2] = {1, 1}, high[2] = {-1, -1};
        rig_moment(&p);
        vti_step_start(method, h, &b);
        for (long i = 0; i < 100; ++i) {
            const int tenth = i < 10 ? 0 : 1;
            if (i < 10 || i >= 90)
                for (long j = 0; j < n; ++j) {
                    double arm[3];
                    rig_steps(&p, method, h, 1);
                    vti_pendulum_arm(&p.pendulum, &b, 0, arm);
                    low[tenth] = fmin(low[tenth], arm[2]);
                    high[tenth] = fmax(high[tenth], arm[2]);
                }
            else
                rig_steps(&p, method, h, n);
        }
        /* nutation is sampled at 10 n places of its circle: they miss its rim by 1/n of the width; and roundings
         * walk */
        const double slack = (high[0] - low[0]) * 10 / (double)n + 4 * EPS * sqrt((double)drifts);
        print_message("%-14s arm.e3 from %.12f to %.12f, then from %.12f to %.12f\n", method->name, low[0], high[0],
                      low[1], high[1]);
        assert_close(low[1], low[0], slack);
        assert_close(high[1], high[0], slack);
        /* the step's top is h^2 off the true one, of forces of the size 1; where it is of order 1, h */
        assert_close(low[0], 0.5, method->order == 1 ? h : h * h);
        assert_close(high[0], 0.5, method->order == 1 ? h : h * h);
        robust("steady precession, 1e6 drifts (1e8 in the long test)", method->name, "bounded: nutation does not grow");
    }
}

/* ---- tiny rotations ---------------------------------------------------------------------------------------------- */

/** N steps by `turn` rad from |alpha| = 1.5 about the same axis; the share of the rotation that is lost, and the
 *  time. */
static double lost(const vti_stepper *method, enum rig_storage storage, double turn, long steps, double *seconds)
{
    rig p;
    memset(&p, 0, sizeof p);
    p.alpha[0] = 1.5;
    p.omega[0] = turn;
    p.inertia = 1;
    p.storage = storage;
    vti_bodies b = rig_bodies(&p);
    b.moment = vti_view_none();
    vti_bodies_seal(&b);
    const rotor start = quat_of_alpha(p.alpha);
    const clock_t before = clock();
    for (long i = 0; i < steps; ++i) {
        for (int64_t k = 0; k < method->stages; ++k)
            vti_step_stage(method, k, 1, &b, NULL);
        vti_step_finish(method, 1, &b);
    }
    *seconds = (double)(clock() - before) / CLOCKS_PER_SEC;
    rotor at = quat_of_alpha(p.alpha);
    if (storage == RIG_RESIDUALS) { /* alpha + alpha_low, so that what is left out of alpha counts too */
        const rotor both = {(long double)p.alpha[0] + p.alpha_low[0], (long double)p.alpha[1] + p.alpha_low[1],
                            (long double)p.alpha[2] + p.alpha_low[2], 2};
        at = quat_unit(both);
    }
    const rotor d = quat_times(at, quat_conj(start));
    return fabs((double)(2 * atan2l(d.x, d.w) / ((long double)steps * turn)) - 1);
}

TEST(tiny_rotations)
{
    const long steps = drifts / 10; /* 1e7 in the long test */
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        double plain, carried, none;
        /* |alpha| = 1.5 is spaced by eps, and its increment is 25/16 of the turn: a sum rounds by eps/2 and always the
         * same way. The quotient of two angles rounds by 2^-63/(N 1e-12) on the way out. */
        const double loss = lost(method, RIG_ALPHA, 1e-12, steps, &plain);
        assert_below(loss, (double)method->stages * 0.5 * EPS / (25.0 / 16 * 1e-12));
        const double kept = lost(method, RIG_RESIDUALS, 1e-12, steps, &carried);
        assert_below(kept, 16 * EPS + 0x1p-62 / ((double)steps * 1e-12));
        /* less than half a spacing of alpha: a plain sum stands still */
        assert_close(lost(method, RIG_ALPHA, 1e-17, 10000, &none), 1, 1e-3);
        const double rest = lost(method, RIG_RESIDUALS, 1e-17, 10000, &none);
        assert_below(rest, 16 * EPS + 0x1p-60 / (10000 * 1e-17));
        print_message("%-14s loses %.1e of rotations by 1e-12, residuals carried %.1e, at %.2f times the time\n",
                      method->name, loss, kept, carried / plain);
        robust("rotations of 1e-12 rad per step, alpha alone", method->name,
               "silent loss of up to 7e-5 of the rotation per drift: carry residuals");
        robust("rotations of 1e-12 rad per step, alpha_low carried", method->name, "exact: nothing is lost");
        robust("rotations of 1e-17 rad per step, alpha alone", method->name,
               "silent loss: |alpha| = 1.5 stands still; carry residuals");
        robust("rotations of 1e-17 rad per step, alpha_low carried", method->name, "exact: nothing is lost");
    }
}

/** The same for Omega: kicks of 1e-17 on Omega = 1. */
TEST(tiny_kicks)
{
    rig p;
    memset(&p, 0, sizeof p);
    p.inertia = 1;
    p.moment[0] = 1e-17;
    for (int storage = RIG_ALPHA; storage <= RIG_RESIDUALS; storage += RIG_RESIDUALS - RIG_ALPHA) {
        p.storage = (enum rig_storage)storage;
        p.omega[0] = 1;
        const vti_bodies b = rig_bodies(&p);
        for (long i = 0; i < 1000000; ++i)
            vti_kick(1, &b);
        const long double gained = (long double)p.omega[0] - 1 + p.omega_low[0];
        if (storage == RIG_ALPHA)
            assert_true(gained == 0);
        else
            assert_close(gained, 1e-11, 1e-11 * 1e6 * 0x1p-52 * EPS + EPS * EPS * 1e6 + 0x1p-63);
        robust("kicks of 1e-17 on Omega = 1", storage == RIG_ALPHA ? "omega alone" : "omega_low carried",
               storage == RIG_ALPHA ? "silent loss: Omega stands still; carry residuals" : "exact: nothing is lost");
    }
}

int main(int argc, char **argv)
{
    if (argc > 1)
        drifts = strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_spin),
        cmocka_unit_test(steady_precession),
        cmocka_unit_test(tiny_rotations),
        cmocka_unit_test(tiny_kicks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
