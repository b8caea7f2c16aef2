/* SPDX-License-Identifier: BSD-3-Clause
 * A new list of neighbours against brute force, and what is refused. */
#include "packing.h"

#include <sys/resource.h>

#include "cells.h"
#include "threads.h"

static packing b;

/** Under the address sanitizer memory is to run out as it does without. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "allocator_may_return_null=1";
}

/* ---- one build --------------------------------------------------------------------------------------------------- */

/** A new list holds the pairs with a gap below the skin and no others. Returns how many. */
static int64_t holds_the_near(double skin)
{
    packing_create(&b, skin);
    assert_int_equal(packing_update(&b), 1);
    const int64_t count = b.list.count;
    assert_int_equal(assert_complete(&b, b.list.skin), count);
    neighbours_destroy(&b.list);
    return count;
}

/** By one thread and by several. */
TEST(finds_the_near_of_random_packings)
{
    int64_t found = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        rng g = rng_seed(seed);
        const double ratio = seed % 3 == 0 ? 6.0 : 1.0 + 0.5 * (double)(seed % 3);
        packing_scatter(&b, &g, 1 + rng_below(&g, PACKING_MAX), uniform(&g, 0.4, 9.0), ratio);
        if (seed % 2 == 0)
            packing_exclude(&b, &g, PACKING_MAX);
        threads_use(1 + (int64_t)(seed % 4));
        found += holds_the_near(seed % 5 == 0 ? 0.0 : uniform(&g, 0.01, 1.5));
    }
    threads_use(1);
    assert_true(found > 10000);
}

/** Of diameters from 1 to 200, most of them small, a few among the long ones; the long ones overlap many. */
TEST(finds_the_near_of_any_sizes)
{
    int64_t found = 0;
    for (uint64_t seed = 1; seed <= 80; ++seed) {
        rng g = rng_seed(1000 + seed);
        const double most = seed % 2 == 0 ? 200.0 : 10.0, far = seed % 8 == 0 ? 1e15 : seed % 8 == 1 ? -1e300 : 0.0;
        packing_scatter(&b, &g, 1 + rng_below(&g, PACKING_MAX), uniform(&g, 4.0, 40.0), 1.0);
        for (int i = 0; i < b.n; ++i) {
            const double u = uniform(&g, 0.0, 1.0);
            b.diameter[i] = seed % 3 == 0 ? (u < 0.01 ? most : 1.0 + u) : pow(most, seed % 3 == 1 ? u : u * u * u);
            b.x[i][i % 3] += i % 2 == 0 ? far : 0.0;
        }
        threads_use(1 + (int64_t)(seed % 4));
        found += holds_the_near(seed % 5 == 0 ? 0.0 : uniform(&g, 0.01, 3.0));
    }
    threads_use(1);
    assert_true(found > 100000);
}

/** A long sphere beside a lattice of short ones: they stay in cells of a few, and so does the work. */
TEST(a_long_one_widens_no_cell)
{
    enum { SIDE = 20, SMALL = SIDE * SIDE * SIDE, FEW = 4 * 4 * 4 };
    static int64_t members[SMALL + 1];
    struct cells cells;
    struct pairs found = {0, 0, NULL};
    assert_int_equal(cells_create(&cells, SMALL + 1), 0);
    for (int i = 0; i < SMALL; ++i) {
        cells.x[3 * i] = 1.3 * (i % SIDE);
        cells.x[3 * i + 1] = 1.3 * (i / SIDE % SIDE);
        cells.x[3 * i + 2] = 1.3 * (i / SIDE / SIDE);
        cells.radius[i] = 0.5;
    }
    cells.x[3 * SMALL + 2] = -50.6; /* just in reach of the corner and a few around it */
    cells.radius[SMALL] = 50.0;
    assert_int_equal(cells_search(&cells, 50.0, 0.2, &found), 0);
    assert_int_equal(found.count, 8); /* up to (50.7^2 - 50.6^2)^(1/2) = 2.4 (1.3) from the corner */
    for (int64_t k = 0; k < found.count; ++k)
        assert_int_equal(found.pair[2 * k + 1], SMALL);
    /* cells are less than four times as wide as a short pair needs, 4 (1 + 0.2): four bodies along each axis */
    for (int64_t i = 0; i <= SMALL; ++i)
        assert_true(++members[cells.home[i]] <= FEW);
    free(found.pair);
    cells_destroy(&cells);
}

TEST(finds_the_near_in_any_place)
{
    const double far[] = {0.0, -1e3, 1e6, -1e6, 1e9, 1e13, -1e15, 1e19, -1e300, DBL_MAX};
    for (size_t k = 0; k < sizeof far / sizeof far[0]; ++k) {
        rng g = rng_seed(100 + k);
        packing_scatter(&b, &g, 300, 3.0, 2.0);
        for (int i = 0; i < b.n; ++i)
            for (int c = 0; c < 3; ++c)
                b.x[i][c] += i % 2 == 0 ? far[k] : -0.5 * far[k]; /* two groups */
        assert_true(holds_the_near(0.3) > 0);
    }
}

/** Spheres on a lattice, each with those around it just in reach: every direction from cell to cell, and every face. */
TEST(finds_the_near_of_lattices)
{
    for (int shift = 0; shift < 40; ++shift) {
        memset(&b, 0, sizeof b);
        b.n = 8 * 8 * 8;
        for (int i = 0; i < b.n; ++i) {
            const double place[3] = {i % 8, i / 8 % 8, i / 64};
            for (int c = 0; c < 3; ++c)
                b.x[i][c] = 0.999999 * place[c] - 4.0 + 0.1 * shift;
            b.diameter[i] = 0.5;
        }
        assert_int_equal(holds_the_near(0.5), 3 * 7 * 8 * 8);
        assert_int_equal(holds_the_near(0.5 + 0.7321), 3 * 7 * 8 * 8 + 6 * 7 * 7 * 8 + 4 * 7 * 7 * 7);
    }
}

/** Pairs that are as far apart as they may be, anywhere: also where numbers are so large that cells round. */
TEST(finds_the_near_across_faces)
{
    rng g = rng_seed(7);
    for (int k = 0; k < 100000; ++k) {
        memset(&b, 0, sizeof b);
        b.n = 2;
        b.diameter[0] = b.diameter[1] = 0.5;
        const double skin = uniform(&g, 0.01, 2.0), reach = 0.5 + skin;
        const double place[3] = {uniform(&g, -1.0, 1.0), 1.0, 1.0 + 0x1p-10}; /* faces of cells as wide as the reach */
        double *const low = &b.x[0][k % 3], *const high = &b.x[1][k % 3];
        *low = nextafter(ldexp(reach * place[k / 3 % 3], rng_below(&g, 54)), -INFINITY);
        *high = *low + reach;
        while (!(packing_gap(&b, 0, 1) < skin))
            *high = nextafter(*high, -INFINITY);
        assert_int_equal(holds_the_near(skin), 1);
    }
}

TEST(few_bodies_and_coincident_ones)
{
    rng g = rng_seed(3);
    packing_scatter(&b, &g, 0, 1.0, 1.0);
    assert_int_equal(holds_the_near(0.0), 0);
    assert_int_equal(holds_the_near(1.0), 0);
    packing_scatter(&b, &g, 1, 1.0, 1.0);
    assert_int_equal(holds_the_near(0.0), 0);
    packing_scatter(&b, &g, 2, 0.2, 1.0);
    assert_int_equal(holds_the_near(0.0), 1);
    packing_scatter(&b, &g, 2, 0.2, 1.0);
    b.x[1][2] += 2.0;
    assert_int_equal(holds_the_near(0.01), 0);
    packing_scatter(&b, &g, 100, 0.0, 1.0); /* all in one place */
    assert_int_equal(holds_the_near(0.0), 100 * 99 / 2);
}

TEST(default_skin_is_a_share_of_the_mean_diameter)
{
    const double diameters[3] = {1.0, 2.0, 6.0};
    const vti_scalars many = vti_scalars_array(diameters), one = vti_scalars_one(&diameters[1]);
    struct neighbours list;
    assert_int_equal(neighbours_create(&list, 3, &many, 0.0, 0, NULL, &b.message), 0);
    assert_close(list.skin, 0.2 * 3.0, 8 * EPS);
    neighbours_destroy(&list);
    neighbours_destroy(&list);
    assert_int_equal(neighbours_create(&list, 5, &one, 0.0, 0, NULL, &b.message), 0);
    assert_close(list.skin, 0.2 * 2.0, 8 * EPS);
    neighbours_destroy(&list);
}

/* ---- refused ----------------------------------------------------------------------------------------------------- */

static void assert_message(const char *part)
{
    if (strstr(b.message.text, part) == NULL)
        fail_msg("'%s' is not in: %s", part, b.message.text);
}

TEST(refuses_positions_that_are_no_numbers)
{
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 18; ++k) {
        rng g = rng_seed((uint64_t)k);
        packing_scatter(&b, &g, 20, 1.0, 1.0);
        packing_create(&b, 0.0);
        const vti_view x = packing_x(&b);
        if (k < 9)
            packing_update(&b);
        const double good = b.x[17][k % 3];
        b.x[17][k % 3] = bad[k / 3 % 3];
        for (int again = 0; again < 2; ++again) {
            assert_int_equal(neighbours_update(&b.list, &x, &b.message), -1);
            assert_message("body 17 ");
            assert_int_equal(b.list.count, 0);
        }
        b.x[17][k % 3] = good;
        assert_int_equal(packing_update(&b), 1);
        assert_true(assert_complete(&b, b.list.skin) > 0);
        neighbours_destroy(&b.list);
    }
}

static void assert_refused(int64_t n, const double *diameter, double skin, const int64_t pair[2], const char *part)
{
    const vti_scalars diameters = vti_scalars_array(diameter);
    struct neighbours list;
    memset(&list, 1, sizeof list);
    assert_int_equal(neighbours_create(&list, n, &diameters, skin, pair ? 1 : 0, pair, &b.message), -1);
    assert_message(part);
    assert_true(list.pair == NULL && list.search == NULL && list.count == 0);
}

TEST(refuses_what_makes_no_list)
{
    const double good[3] = {1.0, 2.0, 1.0}, zero[3] = {1.0, 0.0, 1.0}, negative[3] = {1.0, 1.0, -1.0},
                 none[3] = {NAN, 1.0, 1.0}, infinite[3] = {1.0, INFINITY, 1.0};
    const int64_t low[2] = {-1, 2}, high[2] = {0, 3};
    assert_refused(3, zero, 0.0, NULL, "body 1 ");
    assert_refused(3, negative, 0.0, NULL, "body 2 ");
    assert_refused(3, none, 0.0, NULL, "body 0 ");
    assert_refused(3, infinite, 0.0, NULL, "body 1 ");
    assert_refused(3, good, -0.1, NULL, "skin");
    assert_refused(3, good, NAN, NULL, "skin");
    assert_refused(3, good, INFINITY, NULL, "skin");
    assert_refused(3, good, 0.0, low, "body -1;");
    assert_refused(3, good, 0.0, high, "body 3;");
    assert_refused(INT64_MAX / 4, good, 0.0, NULL, "out of memory");
}

static void limit_memory(rlim_t bytes)
{
    struct rlimit limit;
    assert_int_equal(getrlimit(RLIMIT_DATA, &limit), 0);
    limit.rlim_cur = bytes < limit.rlim_max ? bytes : limit.rlim_max;
    assert_int_equal(setrlimit(RLIMIT_DATA, &limit), 0);
}

/** As long as the pairs do not fit into memory there is no list; as soon as they do there is one. */
static void memory_is_out(int n, rlim_t bytes, int times)
{
    double *x = calloc(3 * (size_t)n, sizeof *x), one = 1.0;
    const vti_scalars diameter = vti_scalars_one(&one);
    const vti_view view = vti_view_packed(x);
    struct neighbours list;
    assert_non_null(x);
    assert_int_equal(neighbours_create(&list, n, &diameter, 0.0, 0, NULL, &b.message), 0);
    for (int time = 0; time <= times; ++time) {
        for (int i = 0; i < n; ++i)
            x[3 * i] = 1.1 * i;
        assert_int_equal(neighbours_update(&list, &view, &b.message), 1);
        assert_int_equal(list.count, n - 1);
        memset(x, 0, 3 * (size_t)n * sizeof *x);
        for (int again = 0; again < 2 && time < times; ++again) {
            limit_memory(bytes);
            const int result = neighbours_update(&list, &view, &b.message);
            limit_memory(RLIM_INFINITY);
            assert_int_equal(result, -1);
            assert_message("out of memory for the pairs of ");
            assert_int_equal(list.count, 0);
        }
    }
    neighbours_destroy(&list);
    free(x);
}

TEST(tells_when_memory_is_out)
{
    memory_is_out(20000, 128u << 20, 2); /* 320 MB to find the pairs of a crowd */
    memory_is_out(2000, 50u << 20, 1);   /* 34 MB to find them, as much to sort them */
}

/** Spheres that all are in one place, as where positions are in metres and diameters in millimetres, have pairs by the
 *  square of their number: some are refused long before memory is out; few, and many that just touch, are not. */
TEST(refuses_a_crowd)
{
    enum { N = 6000, FEW = 2000 };
    static double x[N][3];
    double one = 1.0;
    const vti_scalars diameter = vti_scalars_one(&one);
    const vti_view view = vti_view_packed(x[0]);
    struct neighbours list;
    for (int64_t threads = 1; threads <= 3; ++threads) {
        threads_use(threads);
        memset(x, 0, sizeof x);
        assert_int_equal(neighbours_create(&list, N, &diameter, 0.0, 0, NULL, &b.message), 0);
        assert_int_equal(neighbours_update(&list, &view, &b.message), -1);
        assert_message("each of 6000 spheres has more than 1000 others");
        assert_message("have positions and diameters the same unit?");
        assert_int_equal(list.count, 0);
        for (int i = 0; i < N; ++i)
            x[i][i % 3] = 1.1 * i;
        assert_int_equal(neighbours_update(&list, &view, &b.message), 1);
        neighbours_destroy(&list);
        memset(x, 0, sizeof x);
        assert_int_equal(neighbours_create(&list, FEW, &diameter, 0.0, 0, NULL, &b.message), 0);
        assert_int_equal(neighbours_update(&list, &view, &b.message), 1);
        assert_int_equal(list.count, FEW * (FEW - 1) / 2);
        neighbours_destroy(&list);
    }
    threads_use(1);
}

RUN_TESTS(cmocka_unit_test(finds_the_near_of_random_packings), cmocka_unit_test(finds_the_near_in_any_place),
          cmocka_unit_test(finds_the_near_of_any_sizes), cmocka_unit_test(a_long_one_widens_no_cell),
          cmocka_unit_test(finds_the_near_of_lattices), cmocka_unit_test(finds_the_near_across_faces),
          cmocka_unit_test(few_bodies_and_coincident_ones),
          cmocka_unit_test(default_skin_is_a_share_of_the_mean_diameter),
          cmocka_unit_test(refuses_positions_that_are_no_numbers), cmocka_unit_test(refuses_what_makes_no_list),
          cmocka_unit_test(tells_when_memory_is_out), cmocka_unit_test(refuses_a_crowd))
