/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The bound h|Omega| < 1 of the closed form: one bad body among a thousand, and nothing is written for any of them; the
 * fault names it and its value. */
#include "bodies.h"
#include "support.h"

enum { N = 1000, QUANTITIES = 6, DOUBLES = QUANTITIES * 3 * N + 4 * N };

static double memory[DOUBLES], before[DOUBLES], *const x = memory, *const v = memory + 3 * N, *const f = memory + 6 * N,
                                                       *const a = memory + 9 * N, *const w = memory + 12 * N,
                                                       *const m = memory + 15 * N, *const quaternions = memory + 18 * N;
static const double one = 1.0;
static const vti_stepper *closed[2];
static vti_bodies b;

static int sound(void **state)
{
    (void)state;
    rng g = rng_seed(21);
    closed[0] = vti_stepper_find("vti1");
    closed[1] = vti_stepper_find("vti1-body");
    for (int i = 0; i < DOUBLES; ++i)
        memory[i] = uniform(&g, -1, 1);
    b = vti_bodies_none(N);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(f);
    b.alpha = vti_view_packed(a);
    b.omega = vti_view_packed(w);
    b.moment = vti_view_packed(m);
    b.mass = b.inertia = vti_scalars_one(&one);
    return 0;
}

static void use_quaternions(void)
{
    b.alpha = vti_view_none();
    b.quat = quats_packed(quaternions);
}

/** A step by h = 1/2 is refused because of the body, with the value, and leaves no trace. */
static void refused(int64_t body, double value, double tolerance)
{
    for (int k = 0; k < 2; ++k) {
        vti_fault fault = {-7, -7, 7};
        memcpy(before, memory, sizeof memory);
        assert_int_equal(vti_step_begin(closed[k], 0.5, &b, &fault), VTI_E_TOO_LARGE);
        assert_int_equal(vti_step_begin(closed[k], 0.5, &b, NULL), VTI_E_TOO_LARGE);
        assert_same_bits(before, memory, DOUBLES);
        assert_int_equal(fault.body, body);
        if (isnan(value))
            assert_true(isnan(fault.value));
        else
            assert_close(fault.value, value, tolerance);
    }
}

static void set(double *p, int64_t i, double c0, double c1, double c2)
{
    p[3 * i] = c0;
    p[3 * i + 1] = c1;
    p[3 * i + 2] = c2;
}

/** Every kind of bad value, at both ends, in the middle and at the seams of the blocks of 256. */
TEST(one_bad_body)
{
    const int64_t places[] = {0, 1, 255, 256, 511, 512, N - 1};
    for (int quat = 0; quat < 2; ++quat) {
        if (quat)
            use_quaternions();
        for (int p = 0; p < 7; ++p) {
            const int64_t i = places[p];
            double keep_w[3], keep_m[3];
            memcpy(keep_w, w + 3 * i, sizeof keep_w);
            memcpy(keep_m, m + 3 * i, sizeof keep_m);
            set(m, i, 0, 0, 0);
            set(w, i, 0, 2, 0);
            refused(i, 1, 0);
            set(w, i, 2 + 4 * EPS, 0, 0);
            refused(i, 1 + 2 * EPS, EPS);
            set(w, i, 0, 0, -40);
            refused(i, 20, 0);
            set(w, i, 3, 4, -12);
            refused(i, 6.5, 4 * EPS * 6.5);
            for (int k = 0; k < 3; ++k) {
                set(w, i, 0, 0, 0);
                w[3 * i + k] = NAN;
                refused(i, NAN, 0);
                w[3 * i + k] = -INFINITY;
                refused(i, INFINITY, 0);
                set(w, i, 0, 0, 0);
                m[3 * i + k] = NAN;
                refused(i, NAN, 0);
                m[3 * i + k] = INFINITY;
                refused(i, INFINITY, 0);
                set(m, i, 0, 0, 0);
            }
            /* it is the kicked Omega that counts: 1.9 + (1/4) 0.4 = 2 */
            set(w, i, 1.9, 0, 0);
            set(m, i, 0.5, 0, 0);
            refused(i, 0.5 * (1.9 + 0.125), 2 * EPS);
            set(w, i, 2.5, 0, 0);
            set(m, i, -8, 0, 0);
            vti_fault fault;
            memcpy(before, memory, sizeof memory);
            assert_int_equal(vti_step_begin(closed[0], 0.5, &b, &fault), VTI_OK);
            assert_int_equal(fault.body, -1);
            memcpy(memory, before, sizeof memory);
            memcpy(w + 3 * i, keep_w, sizeof keep_w);
            memcpy(m + 3 * i, keep_m, sizeof keep_m);
        }
    }
}

/** Of several the largest is named, or the first that is not a number; a slice looks at its own bodies only. */
TEST(the_worst_is_named)
{
    b.moment = vti_view_none();
    set(w, 10, 3, 0, 0);
    set(w, 400, 0, 9, 0);
    set(w, 900, 0, 0, 4);
    refused(400, 4.5, 0);
    const vti_bodies all = b;
    b = vti_bodies_slice(all, 401, 599);
    refused(900, 2, 0);
    b = vti_bodies_slice(all, 0, 400);
    refused(10, 1.5, 0);
    vti_bodies good = vti_bodies_slice(all, 11, 389);
    assert_int_equal(vti_step_begin(closed[0], 0.5, &good, NULL), VTI_OK);
    b = all;
    w[3 * 700 + 1] = NAN;
    w[3 * 800 + 2] = NAN;
    refused(700, NAN, 0);
}

/** The largest s below 1 is a turn by nearly a right angle; Cayley steppers know no bound. */
TEST(largest_that_passes)
{
    const double zero[3] = {0, 0, 0};
    b.moment = vti_view_none();
    set(w, 500, 0, 2 - 2 * EPS, 0);
    memcpy(a + 1500, zero, sizeof zero);
    assert_int_equal(vti_step_begin(closed[0], 0.5, &b, NULL), VTI_OK);
    assert_true(all_finite(memory, DOUBLES));
    /* d asin s = ds/sqrt(1 - s^2), and s is off by eps/2 in s^2: sqrt(2 eps) below pi/2 within a factor of 2 */
    assert_close(vti_rrv_angle(a + 1500), asin(1 - EPS), 2 * sqrt(EPS));
    assert_true(vti_rrv_angle(a + 1500) < PI / 2);
    sound(NULL);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        if (vti_stepper_at(k)->law == VTI_LAW_CAYLEY) {
            set(w, 5, 0, 2, 0);
            set(w, 6, 1e9, 2e9, -3e200);
            assert_int_equal(vti_step_begin(vti_stepper_at(k), 0.5, &b, NULL), VTI_OK);
            assert_true(all_finite(a, 3 * N));
        }
}

/** Without an attitude, or without Omega, nothing turns and nothing can turn too far. */
TEST(nothing_turns)
{
    set(w, 3, 1e9, 0, 0);
    b.alpha = vti_view_none();
    assert_int_equal(vti_step_begin(closed[0], 0.5, &b, NULL), VTI_OK);
    sound(NULL);
    b.omega = vti_view_none();
    assert_int_equal(vti_step_begin(closed[0], 0.5, &b, NULL), VTI_OK);
}

/** The primitive by itself: t of either sign, no kick. */
TEST(drift)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        vti_fault fault;
        set(w, 42, 0, 3, 0);
        set(m, 42, 0, -1e6, 0);
        memcpy(before, memory, sizeof memory);
        assert_int_equal(vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, sign * 0.5, &b, &fault), VTI_E_TOO_LARGE);
        assert_same_bits(before, memory, DOUBLES);
        assert_int_equal(fault.body, 42);
        assert_close(fault.value, 1.5, 0);
    }
    set(w, 42, 0, 1, 0);
    assert_int_equal(vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, -0.5, &b, NULL), VTI_OK);
}

/** Bodies within a few roundings of the bound, with residuals: either refused or moved to a finite attitude. */
TEST(residuals_at_the_bound)
{
    rng g = rng_seed(22);
    static double low[3 * N];
    int passed = 0, stopped = 0;
    b.omega_low = vti_view_packed(low);
    for (int trial = 0; trial < 200000; ++trial) {
        const int64_t i = rng_below(&g, N);
        double n[3], turned[3] = {0, 0, 0};
        random_unit(&g, 3, n);
        const double size = 2 * (1 + rng_below(&g, 9) * 0.25 * EPS - EPS);
        set(w, i, size * n[0], size * n[1], size * n[2]);
        for (int k = 0; k < 3; ++k) {
            m[3 * i + k] = uniform(&g, -4, 4) * EPS * n[k];
            low[3 * i + k] = 0.25 * EPS * w[3 * i + k] * uniform(&g, -1, 1);
        }
        memcpy(a + 3 * i, turned, sizeof turned);
        const vti_bodies body = vti_bodies_slice(b, i, 1);
        if (vti_step_begin(closed[0], 0.5, &body, NULL) == VTI_OK) {
            ++passed;
            assert_true(all_finite(a + 3 * i, 3));
        } else {
            ++stopped;
        }
    }
    assert_true(passed > 1000 && stopped > 1000);
}

RUN_TESTS(cmocka_unit_test_setup(one_bad_body, sound), cmocka_unit_test_setup(the_worst_is_named, sound),
          cmocka_unit_test_setup(largest_that_passes, sound), cmocka_unit_test_setup(nothing_turns, sound),
          cmocka_unit_test_setup(drift, sound), cmocka_unit_test_setup(residuals_at_the_bound, sound))
