/* SPDX-License-Identifier: BSD-3-Clause
 * Where contact begins between bodies whose bond has broken, and the list of neighbours that they come into. */
#include "neighbours.h"
#include "partings.h"
#include "support.h"

enum { N = 30 };

static double x[N][3], diameter[N];
static int64_t pairs[N * N][2];
static double length[N * N];

/** Bodies in a row, overlapping for every second gap. */
static vti_view place(void)
{
    memset(x, 0, sizeof x);
    for (int i = 0; i < N; ++i) {
        diameter[i] = 1.0 + 0.01 * i;
        x[i][0] = i * (i % 2 ? 1.0 : 1.07);
    }
    return vti_view_packed(x[0]);
}

TEST(lengths)
{
    const vti_view view = place();
    const vti_scalars d = vti_scalars_array(diameter);
    struct partings p = {0, 0, 0, NULL}, again = {0, 0, 0, NULL};
    double memory[1 + 3 * N];
    int64_t own = 0, count = 0;
    for (int k = 0; k + 1 < N; ++k) { /* in no order, either way round */
        const int i = k * 7 % (N - 1), j = i + 1;
        const double r = partings_distance(&view, i, j);
        assert_close(r, fabs(x[j][0] - x[i][0]), 0);
        assert_int_equal(partings_add(&p, k % 2 ? i : j, k % 2 ? j : i, r, &d), 0);
        own += r < 0.5 * diameter[i] + 0.5 * diameter[j];
    }
    assert_int_equal(p.count, N - 1);
    assert_int_equal(p.own, own);
    assert_true(own > 5 && own < N - 6);
    for (int i = 0; i < N; ++i)
        for (int j = i + 1; j < N && j < i + 4; ++j, ++count) {
            pairs[count][0] = i;
            pairs[count][1] = j;
        }
    partings_lengths(&p, &d, count, pairs[0], length);
    for (int64_t k = 0; k < count; ++k) {
        const int64_t i = pairs[k][0], j = pairs[k][1];
        const double touching = 0.5 * diameter[i] + 0.5 * diameter[j], r = partings_distance(&view, i, j);
        assert_true(length[k] == (j == i + 1 && r < touching ? r : touching));
    }
    /* what is kept says the same */
    assert_true(partings_size(&p) <= 1 + 3 * N);
    partings_get(&p, memory);
    assert_int_equal(partings_put(&again, memory, partings_size(&p)), partings_size(&p));
    assert_int_equal(again.own, own);
    assert_memory_equal(again.list, p.list, (size_t)p.count * sizeof *p.list);
    assert_int_equal(partings_put(&again, memory, partings_size(&p) - 1), -1);
    assert_int_equal(partings_put(&again, memory, 0), -1);
    memory[0] = -1;
    assert_int_equal(partings_put(&again, memory, 10), -1);
    /* bodies that come apart have none of their own, and keep none when they meet again */
    assert_int_equal(partings_end(&p, &view, &d), 0);
    x[2][0] -= 100;
    int64_t ended = partings_end(&p, &view, &d);
    assert_in_range(ended, 1, 2);
    x[2][0] += 100;
    partings_lengths(&p, &d, count, pairs[0], length);
    for (int64_t k = 0; k < count; ++k)
        if (pairs[k][0] == 2 || pairs[k][1] == 2)
            assert_true(length[k] == 0.5 * diameter[pairs[k][0]] + 0.5 * diameter[pairs[k][1]]);
    assert_int_equal(p.own, own - ended);
    partings_destroy(&p);
    partings_destroy(&again);
}

TEST(neighbours_that_were_excluded)
{
    const vti_view view = place();
    const vti_scalars d = vti_scalars_array(diameter);
    struct neighbours list;
    struct message message;
    int64_t excluded[N - 1][2];
    for (int k = 0; k + 1 < N; ++k) {
        excluded[k][k % 2] = k;
        excluded[k][1 - k % 2] = k + 1;
    }
    assert_int_equal(neighbours_create(&list, N, &d, 0.05, N - 1, excluded[0], &message), 0);
    assert_int_equal(neighbours_update(&list, &view, &message), 1);
    const int64_t before = list.count;
    neighbours_release(&list, 3, 9); /* was not */
    assert_int_equal(neighbours_update(&list, &view, &message), 0);
    int64_t added = 0;
    for (int k = 0; k + 1 < N; k += 3) {
        neighbours_release(&list, k % 2 ? k : k + 1, k % 2 ? k + 1 : k);
        added += partings_distance(&view, k, k + 1) < 0.5 * (diameter[k] + diameter[k + 1]) + 0.05;
    }
    assert_int_equal(neighbours_update(&list, &view, &message), 1);
    assert_int_equal(list.count, before + added);
    assert_true(added > 3);
    neighbours_destroy(&list);
}

RUN_TESTS(cmocka_unit_test(lengths), cmocka_unit_test(neighbours_that_were_excluded))
