/* SPDX-License-Identifier: BSD-3-Clause
 * Where formulas put bodies, which of them they bond, how large they are, and the velocities that a seed gives them. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "arrange.h"
#include "random.h"

static const char *torus;

static double at(const vti_view *view, int64_t i, int k)
{
    return view->c[k][i * view->stride];
}

static void assert_pair(const vti_bonds *bonds, int64_t k, int64_t i, int64_t j)
{
    assert_int_equal(bonds->pair[2 * k], i);
    assert_int_equal(bonds->pair[2 * k + 1], j);
}

/** EQUATIONS 3, Torus: D_p, particle k at 2 pi k/80, bonds (k, k + 1 mod 80), particle 40 just at the wall, E_0 =
 *  40. */
TEST(the_torus)
{
    struct scene scene;
    struct model model;
    struct message message;
    assert_int_equal(scene_read(torus, NULL, 0, &scene, &message), 0);
    assert_int_equal(model_create(&scene, &model, &message), 0);
    const vti_view *x = &model.bodies.x;
    const vti_bonds bonds = bonds_of(&model);
    assert_int_equal(model.bodies.count, 80);
    assert_int_equal(bonds.count, 80);
    assert_close(model.diameter.p[0], 0.1177794472772058270624, 1e-17);
    assert_int_equal(model.diameter.stride, 0);
    for (int64_t k = 0; k < 80; ++k) {
        const long double angle = 2 * PI_L * k / 80;
        assert_close(at(x, k, 0), 1.5L * (1 + cosl(angle)) + 0.1177794472772058270624L / 2, 4 * EPS);
        assert_close(at(x, k, 1), 1.5L * sinl(angle), 4 * EPS);
        assert_true(at(x, k, 2) == 0.0);
        assert_pair(&bonds, k, k, (k + 1) % 80);
        /* a difference of coordinates each of which is off by 4 EPS at most */
        assert_close(bonds.rest[4 * k + 3], 0.1177794472772058270624, 2 * sqrt(2.0) * 4 * EPS);
    }
    /* its surface is at x = 0, to the rounding of numbers of size 3, so that its overlap is 0 to the same over D/2 */
    assert_close(at(x, 40, 0) - 0.5 * model.diameter.p[0], 0.0, 2 * EPS);
    assert_true(model_energy(&model, &model.bodies) == 40.0);
    model_destroy(&model);
}

TEST(a_ring_touches_its_neighbours)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {mass: 2, ring: {count: 6, diameter: 2, center: [1, 2, 3]}, omega: [0, 0, 1]}\n"
               "contact: {stiffness: 1}\n" TIME,
               &scene, &model);
    const vti_view *x = &model.bodies.x;
    assert_close(model.diameter.p[0], 1.0, 2 * EPS); /* the side of a hexagon of radius 1 */
    assert_close(at(x, 1, 0), 1.5, 2 * EPS);
    assert_close(at(x, 1, 1), 2.0 + sqrt(0.75), 2 * EPS);
    assert_true(at(x, 4, 2) == 3.0);
    assert_close(model.bodies.inertia.p[0], 0.2, EPS); /* 2/5 m (D/2)^2 of a solid sphere */
    assert_int_equal(bonds_of(&model).count, 0);
    model_destroy(&model);
}

TEST(a_chain)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {mass: 1, chain: {count: 4, spacing: 2, start: [1, 1, 1], direction: [0, 3, -4]}}\n"
               "binder: {axial: 1}\n" TIME,
               &scene, &model);
    for (int64_t k = 0; k < 4; ++k) {
        assert_true(at(&model.bodies.x, k, 0) == 1.0);
        assert_close(at(&model.bodies.x, k, 1), 1.0 + 1.2 * (double)k, 8 * EPS);
        assert_close(at(&model.bodies.x, k, 2), 1.0 - 1.6 * (double)k, 8 * EPS);
    }
    const vti_bonds bonds = bonds_of(&model);
    assert_int_equal(bonds.count, 3);
    for (int64_t k = 0; k < 3; ++k)
        assert_pair(&bonds, k, k, k + 1);
    assert_true(model.diameter.p[0] == 2.0);
    model_destroy(&model);
    make_model("bodies: {mass: 1, chain: {count: 3, spacing: 0.5}}\n" TIME, &scene, &model);
    assert_true(at(&model.bodies.x, 2, 0) == 1.0 && at(&model.bodies.x, 2, 1) == 0.0); /* along x from the origin */
    model_destroy(&model);
}

/** Neighbours are the pairs at distance one, each once; counted by looking at all pairs. */
TEST(a_lattice)
{
    struct scene scene;
    struct model model;
    int64_t k = 0;
    make_model("bodies: {mass: 1, lattice: {counts: [3, 4, 2], spacing: 0.5, corner: [-1, 0, 1]}}\n"
               "binder: {axial: 1}\n" TIME,
               &scene, &model);
    const vti_view *x = &model.bodies.x;
    const vti_bonds bonds = bonds_of(&model);
    assert_int_equal(model.bodies.count, 24);
    assert_true(at(x, 1, 0) == -0.5 && at(x, 3, 1) == 0.5 && at(x, 12, 2) == 1.5);
    assert_true(at(x, 23, 0) == 0.0 && at(x, 23, 1) == 1.5 && at(x, 23, 2) == 1.5);
    for (int64_t i = 0; i < 24; ++i)
        for (int64_t j = i + 1; j < 24; ++j)
            if (fabs(at(x, i, 0) - at(x, j, 0)) + fabs(at(x, i, 1) - at(x, j, 1)) + fabs(at(x, i, 2) - at(x, j, 2)) <
                0.75)
                assert_pair(&bonds, k++, i, j);
    assert_int_equal(bonds.count, k);
    assert_int_equal(k, 2 * 4 * 2 + 3 * 3 * 2 + 3 * 4);
    model_destroy(&model);
}

TEST(one_body_of_each)
{
    static const char *const texts[] = {"bodies: {mass: 1, chain: {count: 1, spacing: 1}}\n" TIME,
                                        "bodies: {mass: 1, lattice: {counts: [1, 1, 1], spacing: 1}}\n" TIME};
    struct scene scene;
    struct model model;
    for (int k = 0; k < 2; ++k) {
        make_model(texts[k], &scene, &model);
        assert_int_equal(model.bodies.count, 1);
        assert_int_equal(arrange_bonds(&scene), 0);
        model_destroy(&model);
    }
}

/* ---- random velocities ------------------------------------------------------------------------------------------- */

/** splitmix64 as published (seed 1234567), and its doubles, computed in Python by the sequential form of the
 *  generator. */
TEST(the_generator)
{
    static const uint64_t published[] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                         4593380528125082431u, 16408922859458223821u};
    for (uint64_t k = 0; k < 5; ++k)
        assert_true(random_bits(1234567, k) == published[k]);
}

TEST(random_velocities)
{
    static const char text[] = "bodies: {mass: 1, chain: {count: 10, spacing: 1}, random: {seed: 7, v: 0.1, omega: "
                               "0.5}}\n" TIME;
    static const double v[2][3] = {{-0x1.69018161f0b2dp-6, -0x1.8bd8d6e68c0bap-4, 0x1.484d9b35889d5p-4},
                                   {0x1.e1d4e7f91b134p-7, -0x1.c7425f1efd74ap-5, -0x1.2123972358b33p-12}};
    static const double omega[2][3] = {{0x1.53aeb70673e28p-4, -0x1.85989332bc3c0p-5, -0x1.009505e4d1056p-2},
                                       {-0x1.507d60946f420p-3, 0x1.211e20229fc18p-4, 0x1.dc443bfb29af0p-4}};
    struct scene scene;
    struct model model;
    make_model(text, &scene, &model);
    assert_same_bits(&model.bodies.v.c[0][0], v[0], 3);
    assert_same_bits(&model.bodies.v.c[0][27], v[1], 3);
    assert_same_bits(&model.bodies.omega.c[0][0], omega[0], 3);
    assert_same_bits(&model.bodies.omega.c[0][27], omega[1], 3);
    model_destroy(&model);
    /* one alone is the same numbers, and they come on top of what all bodies have */
    make_model(
        "bodies: {mass: 1, chain: {count: 10, spacing: 1}, omega: [1, 2, 3], random: {seed: 7, omega: 0.5}}\n" TIME,
        &scene, &model);
    for (int c = 0; c < 3; ++c) {
        assert_true(model.bodies.omega.c[c][27] == 1.0 + c + omega[1][c]);
        assert_true(model.bodies.v.c[c][27] == 0.0);
    }
    model_destroy(&model);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_torus),        cmocka_unit_test(a_ring_touches_its_neighbours),
        cmocka_unit_test(a_chain),          cmocka_unit_test(a_lattice),
        cmocka_unit_test(one_body_of_each), cmocka_unit_test(the_generator),
        cmocka_unit_test(random_velocities)};
    torus = argc > 1 ? argv[1] : "torus.yaml";
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
