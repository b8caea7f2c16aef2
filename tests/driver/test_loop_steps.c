/* SPDX-License-Identifier: BSD-3-Clause
 * How many whole steps fit into a time, where both numbers are rounded. */
#include "support.h"

#include "loop.h"

/** The ends and steps that people write; k/10 over 1/10 falls short of k for k = 3, 6, 7, 12, ... */
TEST(decimals)
{
    static const double steps[] = {0.1, 0.01, 0.001, 0.3, 0.7, 1e-4, 2.1e-3, 1.0 / 64.0};
    int64_t short_ones = 0;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; ++i)
        for (int64_t k = 1; k <= 3000; ++k) {
            char text[40]; /* k h as somebody would write it, rounded once more */
            const long double exact = (long double)k * (long double)steps[i];
            snprintf(text, sizeof text, "%.15Lg", exact);
            const double t_end = strtod(text, NULL);
            short_ones += floor(t_end / steps[i]) < (double)k;
            assert_int_equal(loop_steps(t_end, steps[i]), k);
        }
    assert_true(short_ones > 100); /* or this test would not need to be */
}

TEST(not_one_too_many)
{
    for (int64_t k = 1; k <= 3000; ++k) {
        assert_int_equal(loop_steps((double)k * 0.1 * (1.0 - 1e-13), 0.1), k - 1);
        assert_int_equal(loop_steps((double)k * 0.1 + 0.0999, 0.1), k);
    }
}

TEST(no_more_than_can_be_counted)
{
    const int64_t most = INT64_C(1) << 53;
    assert_int_equal(loop_steps(0x1p53 - 1.0, 1.0), most);
    assert_int_equal(loop_steps(1e300, 0.0625), most);
    assert_int_equal(loop_steps(1e300, 1e-300), most);
}

RUN_TESTS(cmocka_unit_test(decimals), cmocka_unit_test(not_one_too_many), cmocka_unit_test(no_more_than_can_be_counted))
