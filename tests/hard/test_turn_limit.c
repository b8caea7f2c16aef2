/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Large rotations per step, h|Omega| = 0.99 to 1e6 and beyond: each stepper refuses them and says why, or turns by the
 * angle that its laws have in closed form. */
#include "hard.h"

/* exact, so that h|Omega| = 1 is just that */
static const double axis[3] = {0, 0, -1};

/** An angle as one in (-pi, pi]. */
static double wrapped(long double angle)
{
    return (double)remainderl(angle, 2 * PI_L);
}

static void refusal(const vti_stepper *method, double s, troupe *t)
{
    const crowd before = t->c;
    vti_fault fault = {-1, 0, 0};
    char what[64];
    assert_int_equal(troupe_step(t, 1, &fault), VTI_E_TOO_LARGE);
    assert_memory_equal(&before, &t->c, sizeof before);
    assert_int_equal(fault.body, 0);
    assert_close(fault.value, s, 4 * EPS * s);
    snprintf(what, sizeof what, "free spin, h|Omega| = %g", s);
    robust(what, method->name, "reported, bodies unchanged: %s", vti_status_text(VTI_E_TOO_LARGE));
}

/** From two attitudes, so that the angle does not depend on where it starts. Rounding: each drift's pair (c, u) is good
 *  to 8 eps, and so is its angle. */
static void turn(const vti_stepper *method, double s, const double alpha[3])
{
    static troupe t;
    const double omega[3] = {s * axis[0], s * axis[1], s * axis[2]}, size = vti_norm(omega);
    const long double angle = step_angle(method, size);
    char what[64];
    troupe_free(&t, method, alpha, omega);
    if (isnan((double)angle) || (method->law == VTI_LAW_CLOSED && !(vti_dot(t.c.omega[0], t.c.omega[0]) < 1))) {
        refusal(method, s, &t);
        return;
    }
    const rotor start = quat_of_alpha(t.c.alpha[0]);
    assert_int_equal(troupe_step(&t, 1, NULL), VTI_OK);
    assert_true(troupe_is_finite(&t));
    const double off = quat_distance(quat_of_alpha(t.c.alpha[0]), quat_times(quat_turn(omega, angle), start));
    assert_below(off, (double)(method->stages + 1) * (16 * EPS + CUT));
    snprintf(what, sizeof what, "free spin, h|Omega| = %g", s);
    if (s < 2 && fabs((double)angle - s) < 1e-3)
        robust(what, method->name, "turns by h|Omega| to %s", fabs((double)angle - s) < 1e-5 ? "1e-5" : "1e-3");
    else if (method->law == VTI_LAW_CLOSED)
        robust(what, method->name, "turns by asin(h|Omega|) = %.4f", (double)angle);
    else if (method->law == VTI_LAW_CAYLEY)
        robust(what, method->name, "turns by 2 atan(h|Omega|/2) = %.4f", (double)angle);
    else
        robust(what, method->name, "finite: by the closed form of its laws, which is %.4f modulo a full turn",
               wrapped(angle));
}

TEST(rotation_per_step)
{
    const double turns[] = {0.99, 1, 1.01, 10, 1e6}, start[3] = {0.3, -2, 5}, none[3] = {0, 0, 0};
    for (int i = 0; i < 5; ++i)
        for (int64_t k = 0; k < vti_stepper_count(); ++k) {
            const vti_stepper *method = vti_stepper_at(k);
            turn(method, turns[i], method->frame == VTI_FRAME_BODY ? none : start); /* R^T Omega would round */
        }
}

/** Up to the largest angular velocities that there are: finite, and of the closed form no trace. */
TEST(beyond_all_bounds)
{
    const double sizes[] = {1e9, 1e20, 1e100, 1e200, 1e300};
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        for (int i = 0; i < 5; ++i) {
            static troupe t;
            const double alpha[3] = {0.3, -2, 5}, omega[3] = {sizes[i], 0, -0.5 * sizes[i]};
            vti_fault fault;
            troupe_free(&t, method, alpha, omega);
            const int status = troupe_step(&t, 1, &fault);
            assert_int_equal(status, method->law == VTI_LAW_CLOSED ? VTI_E_TOO_LARGE : VTI_OK);
            assert_true(troupe_is_finite(&t));
        }
        robust("free spin, h|Omega| = 1e9 to 1e300", method->name,
               method->law == VTI_LAW_CLOSED ? "reported, bodies unchanged: %s" : "finite; the angle means nothing",
               vti_status_text(VTI_E_TOO_LARGE));
    }
}

RUN_TESTS(cmocka_unit_test(rotation_per_step), cmocka_unit_test(beyond_all_bounds))
