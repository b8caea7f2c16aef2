/* SPDX-License-Identifier: BSD-3-Clause
 * One vector of many is made a little longer than the limit, or a little shorter, wherever it stands and whatever its
 * direction, or NaN in one component. */
#include "far.h"
#include "support.h"

enum { MOST = 75 };

static double at[3 * MOST], apart[3][2 * MOST], from[3 * MOST];
static const double shared[3] = {0.3, -7.0, 1e3}, none[3], limit = 2.25;

/** Packed, and with components apart from each other. */
static void assert_far(int is_far, int64_t begin, int64_t end, int displaced)
{
    const vti_view packed = vti_view_packed(at), strided = {{apart[0], apart[1], apart[2]}, 2, 0};
    for (int k = 0; k < 3; ++k)
        for (int64_t i = 0; i < MOST; ++i)
            apart[k][2 * i] = at[3 * i + k];
    assert_int_equal(far_any(&packed, begin, end, displaced ? from : NULL, displaced ? shared : none, limit), is_far);
    assert_int_equal(far_any(&strided, begin, end, displaced ? from : NULL, displaced ? shared : none, limit), is_far);
}

/** All others are as long as half of the limit allows, along the diagonal. */
static void place(int displaced)
{
    for (int64_t j = 0; j < 3 * MOST; ++j) {
        from[j] = (double)(j % 11);
        at[j] = sqrt(limit / 6.0) * (j % 2 ? 1.0 : -1.0) + (displaced ? from[j] + shared[j % 3] : 0.0);
    }
}

static void put(int64_t i, const double d[3], double length, int displaced)
{
    for (int k = 0; k < 3; ++k)
        at[3 * i + k] = length * d[k] / vti_norm(d) + (displaced ? from[3 * i + k] + shared[k] : 0.0);
}

TEST(one_of_many)
{
    static const double directions[][3] = {{1, 1, 1}, {-1, 1, -1}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {3, -4, 0.1}};
    for (int64_t i = 0; i < MOST; ++i)
        for (int r = 0; r < 12; ++r) {
            const int displaced = r >= 6;
            place(displaced);
            put(i, directions[r % 6], 1.5 * (1.0 - 1e-12), displaced);
            assert_far(0, 0, MOST, displaced);
            put(i, directions[r % 6], 1.5 * (1.0 + 1e-12), displaced);
            assert_far(1, 0, MOST, displaced);
            assert_far(1, i, i + 1, displaced);
            assert_far(0, 0, i, displaced);
            assert_far(0, i + 1, MOST, displaced);
        }
}

TEST(no_numbers)
{
    place(0);
    for (int64_t j = 0; j < 3 * MOST; ++j)
        for (int sign = -1; sign <= 1; sign += 2) {
            const double was = at[j];
            at[j] = sign < 0 ? -NAN : NAN;
            assert_far(1, 0, MOST, 0);
            at[j] = was;
        }
    assert_far(0, 0, MOST, 0);
    assert_far(0, 5, 5, 0);
}

RUN_TESTS(cmocka_unit_test(one_of_many), cmocka_unit_test(no_numbers))
