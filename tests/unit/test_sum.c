/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Compensated sums and the trapezoid rule against sums that are exact in integers. */
#include "support.h"

TEST(cancellation)
{
    const double terms[][4] = {{1, 1e100, 1, -1e100}, {1e100, 1, -1e100, 1}, {1, 1, 1e100, -1e100}};
    for (int i = 0; i < 3; ++i) {
        vti_sum s = {0, 0};
        for (int k = 0; k < 4; ++k)
            vti_sum_add(&s, terms[i][k]);
        assert_close(vti_sum_value(&s), 2, 0);
    }
    const vti_sum none = {0, 0};
    assert_close(vti_sum_value(&none), 0, 0);
}

/** Multiples of 2^-40 of many sizes, of which an int64_t holds the exact sum. */
TEST(random_terms)
{
    rng g = rng_seed(41);
    for (int trial = 0; trial < 200; ++trial) {
        enum { TERMS = 1000 };
        vti_sum s = {0, 0};
        int64_t exact = 0;
        double absolute = 0;
        for (int i = 0; i < TERMS; ++i) {
            const int64_t term = (int64_t)(rng_bits(&g) >> (12 + rng_below(&g, 40))) * (rng_below(&g, 2) ? 1 : -1);
            /* 1000 terms below 2^52 stay below 2^62 */
            exact += term;
            absolute += fabs((double)term) * 0x1p-40;
            vti_sum_add(&s, (double)term * 0x1p-40);
        }
        const double expected = (double)exact * 0x1p-40;
        /* one rounding of the result, one of the reference, and n^2 eps^2 of the sum of the moduli */
        assert_close(vti_sum_value(&s), expected, EPS * fabs(expected) + 1e6 * EPS * EPS * absolute);
    }
}

/** A million times 0.1, whose plain sum is off by 1.3e-6: 2^-55 times an integer. */
TEST(many_equal_terms)
{
    const int64_t numerator = (int64_t)(0.1 * 0x1p55);
    assert_true((double)numerator == 0.1 * 0x1p55);
    vti_sum s = {0, 0};
    for (int i = 0; i < 1000000; ++i)
        vti_sum_add(&s, 0.1);
    /* the exact product in two parts that fit */
    const double expected =
        (double)((numerator >> 28) * 1000000) * 0x1p-27 + (double)((numerator & 0xfffffff) * 1000000) * 0x1p-55;
    assert_close(vti_sum_value(&s), expected, EPS * expected);
}

TEST(integral)
{
    vti_integral q = {{0, 0}, 0, 0};
    assert_close(vti_integral_value(&q), 0, 0);
    vti_integral_add(&q, NAN, 3.0); /* the step before the first value does not exist */
    assert_close(vti_integral_value(&q), 0, 0);
    vti_integral_add(&q, 0.5, 5.0);
    assert_close(vti_integral_value(&q), 2, 0);
    vti_integral_add(&q, 2.0, -1.0);
    assert_close(vti_integral_value(&q), 6, 0);
    assert_int_equal(q.values, 3);
}

/** Exact for a straight line and off by h^2/6 for t^2 over [0, 1], whatever the number of steps. */
TEST(trapezoids)
{
    for (int n = 1; n <= 1 << 20; n *= 4) {
        const double h = 1.0 / n;
        vti_integral line = {{0, 0}, 0, 0}, square = {{0, 0}, 0, 0};
        for (int i = 0; i <= n; ++i) {
            vti_integral_add(&line, h, 1 + 2 * (i * h));
            vti_integral_add(&square, h, (i * h) * (i * h));
        }
        assert_close(vti_integral_value(&line), 2, 2 * EPS);
        /* every value rounds by eps/2 */
        assert_close(vti_integral_value(&square), 1.0 / 3 + h * h / 6, 2 * EPS);
    }
}

RUN_TESTS(cmocka_unit_test(cancellation), cmocka_unit_test(random_terms), cmocka_unit_test(many_equal_terms),
          cmocka_unit_test(integral), cmocka_unit_test(trapezoids))
