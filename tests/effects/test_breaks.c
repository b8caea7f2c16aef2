/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_effect.breaks names the momenta that an effect does not conserve, and no others: random scenes of one effect
 * each are run, and of the nine momenta exactly those that are not named stay as they are. */
#include "crowd.h"

enum { BODIES = 6, PAIRS = BODIES * (BODIES - 1) / 2, STEPS = 400 };

static crowd c;

/** Bodies that overlap, move and turn, away from the origin. */
static void draw(rng *g, enum crowd_storage storage)
{
    crowd_clear(&c, BODIES, storage);
    crowd_scatter(&c, g, 1, 0.5);
    for (int i = 0; i < BODIES; ++i) {
        c.mass[i] = uniform(g, 0.5, 2);
        c.inertia[i] = uniform(g, 0.5, 2);
        random_vector(g, 0.5, c.v[i]);
        random_vector(g, 0.5, c.omega[i]);
        for (int k = 0; k < 3; ++k)
            c.x[i][k] += 1;
    }
}

static void run(const vti_effect *effect)
{
    double start[9], now[9];
    crowd_momenta(&c, start);
    crowd_steps(&c, vti_stepper_find("vti2"), 0.01, STEPS, effect, 1);
    crowd_momenta(&c, now);
    for (int k = 0; k < 9; ++k) {
        const double change = fabs(now[k] - start[k]);
        if (effect->breaks >> k & 1 ? change > 1e-6 : change <= 1e-12)
            continue;
        print_error("%s, breaks %#x: momentum %d changes by %g\n", effect->name, (unsigned)effect->breaks, k, change);
        fail();
    }
}

/* Not named: 400 steps of some 20 roundings of momenta up to 10, at random, sqrt(8000) * 10 * eps = 2e-13, below 1e-12.
 * Named: they change by loads of order 1 over a time of 4, and one that does so by less than 1e-6 is not generic. */

TEST(bonds)
{
    rng g = rng_seed(3061);
    for (int trial = 0; trial < 15 * 10; ++trial) {
        static web w;
        int terms, form;
        draw(&g, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        const int64_t count = web_grow(&w, &g, &c, 4, 5, 20);
        for (int i = 0; i < BODIES; ++i) { /* strained from the start, which the quartic forms need to act at once */
            double axis[3];
            random_unit(&g, 3, axis);
            crowd_turn(&c, i, axis, uniform(&g, 0.5, 1));
        }
        web_combination(trial % 15, &terms, &form);
        web_terms(&w, count, terms, form);
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        assert_int_equal(effect.breaks, form == VTI_SHEAR_PRINTED ? VTI_BREAKS_ANGULAR
                                        : form != 0               ? VTI_BREAKS_SPINS
                                                                  : 0);
        run(&effect);
    }
}

TEST(contacts)
{
    rng g = rng_seed(3062);
    for (int trial = 0; trial < 50; ++trial) {
        int64_t pair[PAIRS][2], count = 0;
        const double diameter = 1.5;
        draw(&g, CROWD_ALPHA);
        for (int i = 0; i < BODIES; ++i)
            for (int j = 0; j < i; ++j, ++count) {
                pair[count][0] = i;
                pair[count][1] = j;
            }
        const vti_contacts list = {
            .count = PAIRS, .pair = pair[0], .diameter = vti_scalars_one(&diameter), .stiffness = 20};
        const vti_effect effect = vti_contacts_effect(&list);
        const double v = c.v[0][0];
        assert_int_equal(effect.breaks, 0);
        run(&effect);
        assert_true(fabs(c.v[0][0] - v) > 1e-6); /* they did collide */
    }
}

/** Bits of a direction: momentum along it and angular momentum across it. */
static int64_t bits_of(const double n[3])
{
    const int64_t along = (n[0] != 0) | (n[1] != 0) << 1 | (n[2] != 0) << 2;
    const int64_t across = (n[1] != 0 || n[2] != 0) | (n[0] != 0 || n[2] != 0) << 1 | (n[0] != 0 || n[1] != 0) << 2;
    return along | across << 3;
}

/** A direction with the components of the mask, 1-7. */
static void direction(rng *g, int mask, double n[3])
{
    do {
        random_unit(g, 3, n);
        for (int k = 0; k < 3; ++k)
            n[k] = mask >> k & 1 ? n[k] : 0;
    } while ((mask & 1 && fabs(n[0]) < 0.1) || (mask & 2 && fabs(n[1]) < 0.1) || (mask & 4 && fabs(n[2]) < 0.1));
    const double norm = vti_norm(n);
    for (int k = 0; k < 3; ++k)
        n[k] /= norm;
}

TEST(walls)
{
    rng g = rng_seed(3063);
    for (int trial = 0; trial < 7 * 8 * 4; ++trial) {
        double plane[2][4];
        const double diameter = 1;
        const int masks[2] = {1 + trial % 7, trial / 7 % 8}, planes = masks[1] == 0 ? 1 : 2;
        int64_t expected = 0;
        draw(&g, CROWD_ALPHA);
        for (int k = 0; k < planes; ++k) {
            direction(&g, masks[k], plane[k]);
            plane[k][3] = vti_dot(plane[k], c.x[k]) - 0.2; /* body k touches it */
            expected |= bits_of(plane[k]);
        }
        const vti_walls list = {
            .count = planes, .plane = plane[0], .diameter = vti_scalars_one(&diameter), .stiffness = 5};
        const vti_effect effect = vti_walls_effect(&list);
        assert_int_equal(effect.breaks, expected);
        run(&effect);
    }
    const vti_walls none = {.count = 0, .plane = NULL, .diameter = {NULL, 0, 0}, .stiffness = 1};
    assert_int_equal(vti_walls_effect(&none).breaks, 0);
}

TEST(gravity)
{
    rng g = rng_seed(3064);
    for (int trial = 0; trial < 8 * 5; ++trial) {
        vti_gravity field = {{0, 0, 0}};
        draw(&g, CROWD_ALPHA);
        if (trial % 8 != 0)
            direction(&g, trial % 8, field.g);
        const vti_effect effect = vti_gravity_effect(&field);
        assert_int_equal(effect.breaks, bits_of(field.g));
        run(&effect);
    }
}

RUN_TESTS(cmocka_unit_test(bonds), cmocka_unit_test(contacts), cmocka_unit_test(walls), cmocka_unit_test(gravity))
