/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A free body turns in each step about Omega by exactly asin(h|Omega|) (VTI-1) or 2 atan(h|Omega|/2) (VTI-2, VTI-3), and
 * its Omega keeps every bit. */
#include "rig.h"

static long double angle_of_step(const vti_stepper *method, long double s)
{
    return method->law == VTI_LAW_CLOSED ? asinl(s) : 2 * atanl(s / 2);
}

/** The attitude after a turn by angle about omega, in space or in the body's frame. */
static rotor turned(const vti_stepper *method, rotor q, const double omega[3], long double angle)
{
    const rotor d = quat_turn(omega, angle);
    return method->frame == VTI_FRAME_SPACE ? quat_times(d, q) : quat_times(q, d);
}

static long double length(const double v[3])
{
    return sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
}

static void one_step(void **state)
{
    (void)state;
    const double sizes[] = {1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.5, 3, 1e3};
    rng g = rng_seed(201);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 20000; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            const double s = sizes[trial % 10], h = uniform(&g, 0.01, 2);
            if (method->law == VTI_LAW_CLOSED && s >= 1)
                continue;
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            random_unit(&g, 3, p.omega);
            for (int c = 0; c < 3; ++c)
                p.omega[c] *= s / h;
            const rig start = p;
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            assert_int_equal(vti_step_begin(method, h, &b, NULL), VTI_OK);
            assert_int_equal(vti_step_finish(method, h, &b), VTI_OK);
            assert_same_bits(p.omega, start.omega, 3);
            const long double turn = h * length(start.omega);
            const rotor expected = turned(method, rig_attitude(&start), start.omega, angle_of_step(method, turn));
            /* 8 eps of a composition; h Omega is rounded by 2 eps, which asin' = 1/sqrt(1 - s^2) may enlarge */
            const double slope = method->law == VTI_LAW_CLOSED ? s / sqrt(1 - s * s) : 1;
            assert_close(quat_distance(rig_attitude(&p), expected), 0, (8 + 2 * slope) * EPS);
        }
}

/** Thousands of steps, through theta = pi many times: the errors of single steps at worst add up. */
static void many_steps(void **state)
{
    (void)state;
    enum { STEPS = 10000 };
    const double h = 0.125;
    rng g = rng_seed(202);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 30; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            if (trial < 6) {
                /* about an axis of the frame from rest: alpha goes through infinity on a straight line */
                memset(p.omega, 0, sizeof p.omega);
                memset(p.alpha, 0, sizeof p.alpha);
                memset(p.quat, 0, sizeof p.quat);
                p.quat[3] = 1;
                p.omega[trial % 3] = trial < 3 ? 4 : -1;
            }
            const rotor start = rig_attitude(&p);
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            const long double angle = angle_of_step(method, h * length(p.omega));
            double most = 0;
            for (int i = 1; i <= STEPS; ++i) {
                vti_step_begin(method, h, &b, NULL);
                vti_step_finish(method, h, &b);
                if (i % 100 == 0)
                    most = fmax(most, quat_distance(rig_attitude(&p), turned(method, start, p.omega, i * angle)));
            }
            assert_below(most, 4 * EPS * STEPS);
        }
}

/** Right angles in VTI-2: h|Omega| = 2 turns by pi/2 exactly, so four steps are a whole turn through alpha = infinity. */
static void right_angles(void **state)
{
    (void)state;
    const vti_stepper *vti2 = vti_stepper_find("vti2");
    for (int storage = 0; storage < 3; ++storage)
        for (int axis = 0; axis < 3; ++axis) {
            rig p = rig_of_the_paper((enum rig_storage)storage);
            memset(p.omega, 0, sizeof p.omega);
            p.omega[axis] = axis == 1 ? -4 : 4;
            const rotor start = rig_attitude(&p);
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            for (int i = 1; i <= 4000; ++i) {
                vti_step_begin(vti2, 0.5, &b, NULL);
                assert_true(all_finite(p.alpha, 3) && all_finite(p.quat, 4));
                const rotor expected = turned(vti2, start, p.omega, (i % 4) * PI_L / 2);
                assert_close(quat_distance(rig_attitude(&p), expected), 0, 4 * EPS * (i + 2));
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_step),
        cmocka_unit_test(many_steps),
        cmocka_unit_test(right_angles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
