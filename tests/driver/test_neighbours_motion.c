/* SPDX-License-Identifier: BSD-3-Clause
 * The list of neighbours over time: no touching pair is missed, and what a list went through leaves no trace in the
 * forces. */
#include "packing.h"

static packing b, other;

static void move(packing *bodies, double h)
{
    for (int i = 0; i < bodies->n; ++i)
        for (int c = 0; c < 3; ++c)
            bodies->x[i][c] += h * bodies->v[i][c];
}

/** Forces of the contacts of the list, for the bits. */
static void contact_forces(packing *bodies, double force[][3])
{
    const vti_contacts contacts = {.count = bodies->list.count,
                                   .pair = bodies->list.pair,
                                   .diameter = vti_scalars_array(bodies->diameter),
                                   .stiffness = 1.0};
    const vti_effect effect = vti_contacts_effect(&contacts);
    vti_bodies view = vti_bodies_none(bodies->n);
    const double mass = 1.0;
    view.x = packing_x(bodies);
    view.force = vti_view_packed(force[0]);
    view.mass = vti_scalars_one(&mass);
    assert_int_equal(vti_apply(&effect, 1, &view), VTI_OK);
}

/** Whatever happened before, no touching pair is missed, and the forces have the bits that a new list gives. */
TEST(no_touch_is_missed_in_motion)
{
    static double force[PACKING_MAX][3], expected[PACKING_MAX][3];
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        rng g = rng_seed(seed);
        int kept = 0;
        packing_scatter(&b, &g, 300, 3.0, seed % 2 ? 1.0 : 3.0);
        packing_exclude(&b, &g, 200);
        for (int i = 0; i < b.n; ++i)
            random_vector(&g, 1.0, b.v[i]);
        packing_create(&b, 0.0);
        for (int step = 0; step < 300; ++step) {
            kept += packing_update(&b) == 0;
            assert_true(assert_complete(&b, 0.0) > 0);
            other = b;
            packing_create(&other, 0.05);
            packing_update(&other);
            contact_forces(&b, force);
            contact_forces(&other, expected);
            assert_same_bits(force, expected, 3 * b.n);
            neighbours_destroy(&other.list);
            move(&b, step % 60 == 59 ? -1.0 : 0.01); /* now and then far, and back */
        }
        assert_int_equal(b.list.builds, 300 - kept);
        assert_true(kept > 150 && kept < 295);
        neighbours_destroy(&b.list);
    }
}

/** Two spheres approach each other: the worst case of the criterion. They must be listed before they touch. */
TEST(a_head_on_pair_is_listed_in_time)
{
    for (int k = 0; k < 2000; ++k) {
        rng g = rng_seed((uint64_t)k);
        const double h = uniform(&g, 1e-3, 0.1), offset = uniform(&g, -1e3, 1e3);
        packing_scatter(&b, &g, 2, 0.0, 1.0);
        b.x[0][k % 3] = offset - 1.0;
        b.x[1][k % 3] = offset + 1.0;
        b.v[0][k % 3] = 1.0;
        b.v[1][k % 3] = -1.0;
        packing_create(&b, uniform(&g, 0.01, 0.5));
        for (int step = 0; (double)step * h < 1.0; ++step) {
            packing_update(&b);
            assert_complete(&b, 0.0);
            move(&b, h);
        }
        neighbours_destroy(&b.list);
    }
}

/** The same for skins of a few roundings, with distances as the contact computes them. */
TEST(rounding_hides_no_touch)
{
    rng g = rng_seed(11);
    for (int k = 0; k < 200000; ++k) {
        const double skin = uniform(&g, 0.5, 8.0) * EPS, r = 1.0 + skin + uniform(&g, -4.0, 4.0) * EPS;
        double n[3];
        random_unit(&g, 3, n);
        packing_scatter(&b, &g, 2, 1e-16, 1.0);
        for (int c = 0; c < 3; ++c) {
            b.v[0][c] = n[c];
            b.v[1][c] = -n[c];
            b.x[1][c] = r * n[c];
        }
        packing_create(&b, skin);
        packing_update(&b);
        move(&b, 0.5 * skin);
        packing_update(&b);
        const double d[3] = {b.x[0][0] - b.x[1][0], b.x[0][1] - b.x[1][1], b.x[0][2] - b.x[1][2]};
        assert_true(b.list.count == 1 || !(vti_dot(d, d) < 1.0));
        neighbours_destroy(&b.list);
    }
}

TEST(grows_and_shrinks_with_the_pairs)
{
    const double sizes[] = {1e3, 6.0, 0.3, 6.0, 1e3, 0.0};
    rng g = rng_seed(13);
    packing_scatter(&b, &g, PACKING_MAX, 1e3, 1.5);
    packing_create(&b, 0.0);
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
        for (int i = 0; i < b.n; ++i)
            random_vector(&g, sizes[k], b.x[i]);
        assert_int_equal(packing_update(&b), 1);
        assert_int_equal(assert_complete(&b, b.list.skin), b.list.count);
    }
    assert_int_equal(b.list.count, PACKING_MAX * (PACKING_MAX - 1) / 2);
    neighbours_destroy(&b.list);
}

TEST(is_built_anew_after_half_the_skin)
{
    rng g = rng_seed(5);
    const double alone = 30.0 / 29.0; /* of one in 30 that moves a thirtieth of its way is shared */
    packing_scatter(&b, &g, 30, 2.5, 1.0);
    packing_create(&b, 0.5);
    assert_int_equal(packing_update(&b), 1);
    assert_int_equal(packing_update(&b), 0);
    for (int i = 0; i < b.n; ++i)
        for (int c = 0; c < 3; ++c) {
            const double x = b.x[i][c];
            b.x[i][c] = x + 0.2499 * alone;
            assert_int_equal(packing_update(&b), 0);
            b.x[i][c] = x - 0.2501 * alone;
            assert_int_equal(packing_update(&b), 1);
            assert_complete(&b, 0.5);
            b.x[i][c] = x;
            packing_update(&b);
        }
    assert_int_equal(b.list.builds, 1 + 2 * 3 * b.n);
    b.x[0][0] += 0.2;
    assert_int_equal(packing_update(&b), 0);
    b.x[0][1] -= 0.2; /* 0.28 across */
    assert_int_equal(packing_update(&b), 1);
    neighbours_destroy(&b.list);
}

/** What all bodies move by calls for no new list, however far; the list forgets none of it. */
TEST(what_moves_as_one_keeps_its_list)
{
    static double force[PACKING_MAX][3], expected[PACKING_MAX][3];
    rng g = rng_seed(17);
    packing_scatter(&b, &g, PACKING_MAX, 4.0, 1.5);
    for (int i = 0; i < b.n; ++i) {
        random_vector(&g, 0.001, b.v[i]);
        b.v[i][1] += 1.0;
    }
    packing_create(&b, 0.0);
    for (int step = 0; step < 50; ++step) {
        packing_update(&b);
        assert_true(assert_complete(&b, 0.0) > 0);
        move(&b, 1.0);
    }
    assert_int_equal(b.list.builds, 1);
    other = b;
    packing_create(&other, 0.05);
    packing_update(&b);
    packing_update(&other);
    contact_forces(&b, force);
    contact_forces(&other, expected);
    assert_same_bits(force, expected, 3 * b.n);
    neighbours_destroy(&other.list);
    for (int i = 0; i < b.n; ++i)
        b.x[i][0] += 1e16; /* where no digit is left of the skin */
    assert_int_equal(packing_update(&b), 1);
    neighbours_destroy(&b.list);
}

/** Few pairs that fly fast are looked at less often with a wide skin, many that hardly move are fewer with a narrow
 *  one; none that touches is missed on the way. */
TEST(the_skin_follows_the_cost)
{
    rng g = rng_seed(19);
    packing_scatter(&b, &g, 200, 6.0, 1.0);
    for (int i = 0; i < b.n; ++i)
        random_vector(&g, 0.02, b.v[i]);
    packing_create(&b, 0.0);
    for (int step = 0; step < 400; ++step) {
        packing_update(&b);
        assert_complete(&b, 0.0);
        move(&b, 1.0);
    }
    assert_true(b.list.skin > 0.99 && b.list.skin < 1.01);
    for (int i = 0; i < b.n; ++i)
        random_vector(&g, 2.0, b.x[i]);
    for (int step = 0; step < 2000; ++step) {
        packing_update(&b);
        if (step % 50 == 0)
            assert_complete(&b, 0.0);
        move(&b, 0.05);
    }
    assert_true(b.list.skin >= 0.2 && b.list.skin < 0.5);
    neighbours_destroy(&b.list);
}

/** A ring of bonded spheres that turns has nothing to look at, unless the skin comes to all those next but one, whose
 *  gap is just below the widest skin: that is tried now and then only. */
TEST(a_skin_that_finds_too_much_is_taken_back)
{
    enum { RING = 80, STEPS = 20000 };
    const double radius = 0.5 / sin(PI / RING);
    int64_t looks = 0, most = 0;
    memset(&b, 0, sizeof b);
    b.n = b.excluded_count = RING;
    for (int i = 0; i < RING; ++i) {
        b.diameter[i] = 1.0;
        b.excluded[i][0] = i;
        b.excluded[i][1] = (i + 1) % RING;
    }
    packing_create(&b, 0.0);
    for (int step = 0; step < STEPS; ++step) {
        for (int i = 0; i < RING; ++i) {
            b.x[i][0] = radius * cos(2.0 * PI * i / RING + 5e-4 * step);
            b.x[i][1] = radius * sin(2.0 * PI * i / RING + 5e-4 * step);
        }
        packing_update(&b);
        looks += b.list.count;
        most = b.list.count > most ? b.list.count : most;
    }
    assert_int_equal(most, RING);
    assert_true(looks < RING * STEPS / 6);
    neighbours_destroy(&b.list);
}

RUN_TESTS(cmocka_unit_test(no_touch_is_missed_in_motion), cmocka_unit_test(a_head_on_pair_is_listed_in_time),
          cmocka_unit_test(rounding_hides_no_touch), cmocka_unit_test(grows_and_shrinks_with_the_pairs),
          cmocka_unit_test(is_built_anew_after_half_the_skin), cmocka_unit_test(what_moves_as_one_keeps_its_list),
          cmocka_unit_test(the_skin_follows_the_cost), cmocka_unit_test(a_skin_that_finds_too_much_is_taken_back))
