/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_stable_step against the true limit 2/omega_max: never above it, close to it on the torus, equal to it for one
 * bond. */
#include "hessian.h"
#include "torus.h"

static crowd c;
static web w;
static double scratch[CROWD_MAX];

static double stable(const vti_springs *springs)
{
    double h = NAN;
    const vti_bodies b = crowd_bodies(&c);
    assert_int_equal(vti_stable_step(springs, &b, scratch, &h), VTI_OK);
    return h;
}

/** Masses and inertias over three decades. */
static void weigh(rng *g)
{
    for (int i = 0; i < c.n; ++i) {
        c.mass[i] = pow(10, uniform(g, -1.5, 1.5));
        c.inertia[i] = pow(10, uniform(g, -1.5, 1.5));
    }
}

static void torus_is_close(void **state)
{
    (void)state;
    static torus t;
    torus_start(&t, VTI_SHEAR_OBJECTIVE);
    const vti_springs springs = {&t.w.bonds, NULL, NULL, NULL, 0};
    c = t.c;
    const double limit = hessian_limit(&c, t.effects, 1), h = stable(&springs);
    print_message("torus: h %.10g, 2/omega_max %.10g, ratio %.6f\n", h, limit, h / limit);
    assert_close(limit, 8.328e-3, 0.0005e-3); /* EQUATIONS 5, as printed there */
    assert_true(h >= 0.99 * limit);
    assert_below(h, limit * (1 + HESSIAN_ERROR));
}

/* ---- one bond ---------------------------------------------------------------------------------------------------- */

static void closed_forms(void **state)
{
    (void)state;
    rng g = rng_seed(3071);
    for (int trial = 0; trial < 500; ++trial) {
        crowd_clear(&c, 2, CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.3);
        weigh(&g);
        const vti_springs springs = {&w.bonds, NULL, NULL, NULL, 0};
        web_grow(&w, &g, &c, 0, 0.1, 100);
        const double length = w.rest[0][3];
        /* the bound is some 8 operations and a root away; of a and 1/J it takes off again what is not called for */
        web_terms(&w, 1, AXIAL, 0);
        const double a = (1 / c.mass[0] + 1 / c.mass[1]) / (length * length), axial = w.axial[0] * a;
        assert_close(stable(&springs), 2 / sqrt(axial), 8 * EPS * 2 / sqrt(axial));
        web_terms(&w, 1, MOMENT, 0);
        const double b = 1 / c.inertia[0] + 1 / c.inertia[1], torsion = w.moment[0] * b;
        assert_close(stable(&springs), 2 / sqrt(torsion), 8 * EPS * (1 + a / b) * 2 / sqrt(torsion));
        /* a shear of gamma = u/L0 - (theta_i + theta_j)/2; with unequal inertias the bound may be lower, see below */
        web_terms(&w, 1, SHEAR, VTI_SHEAR_OBJECTIVE);
        c.inertia[1] = c.inertia[0];
        const double shear = w.shear[0] * (a + 0.5 / c.inertia[0]);
        assert_close(stable(&springs), 2 / sqrt(shear), 8 * EPS * (1 + 1 / (a * c.inertia[0])) * 2 / sqrt(shear));
    }
}

/* One bond has no shares to lose by. EQUATIONS 5 reckon its shear as (gamma_i^2 + gamma_j^2)/2 of two angles of its
 * own, which is more than the square of their mean by K/8 (theta_i - theta_j)^2. That is nothing for equal inertias
 * unless bending is what is fastest, and the frequency^2 is at most doubled: limit/sqrt 2 <= h <= limit. */
static void one_bond(void **state)
{
    (void)state;
    rng g = rng_seed(3072);
    int exact = 0;
    for (int trial = 0; trial < 7 * 80; ++trial) {
        crowd_clear(&c, 2, CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.3);
        weigh(&g);
        web_grow(&w, &g, &c, 0, 0.1, 100);
        const int terms = 1 + trial % 7, equal = trial / 7 % 2;
        web_terms(&w, 1, terms, VTI_SHEAR_OBJECTIVE);
        if (equal)
            c.inertia[1] = c.inertia[0];
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        const vti_springs springs = {&w.bonds, NULL, NULL, NULL, 0};
        const double limit = hessian_limit(&c, &effect, 1), h = stable(&springs);
        const double a = (1 / c.mass[0] + 1 / c.mass[1]) / pow(w.rest[0][3], 2);
        const int bends = terms & MOMENT && 2 * w.moment[0] / c.inertia[0] > w.shear[0] * a;
        const int is_limit = !(terms & SHEAR) || (equal && !bends);
        exact += is_limit;
        assert_below(h, limit * (1 + HESSIAN_ERROR));
        assert_true(h >= (is_limit ? 1 : sqrt(0.5)) * limit * (1 - HESSIAN_ERROR));
    }
    assert_true(exact > 300);
}

/** Springs in parallel on one body, or one pair: each has a share of 1/n of it and n equal ones are n times as stiff, so
 *  that the bound is the limit. Hertz: d^2U/dr^2 = (3/2) K sqrt(o)/D^2; arm: m g |rho0|. */
static void parallel_springs(void **state)
{
    (void)state;
    rng g = rng_seed(3076);
    for (int trial = 0; trial < 200; ++trial) {
        const int base = trial / 3 % 2;
        const int64_t pair[3][2] = {{base, base + 1}, {base + 1, base}, {base, base + 1}};
        const double diameter[2] = {uniform(&g, 0.5, 2), uniform(&g, 0.5, 2)}, o = uniform(&g, 0.01, 0.2);
        const double radius = diameter[0] / 2, length = radius + diameter[1] / 2;
        const int n = 1 + trial % 3;
        double plane[3][4];
        crowd_clear(&c, 2, CROWD_ALPHA);
        weigh(&g);
        const vti_contacts contacts = {n, pair[0], base, vti_scalars_array(diameter), uniform(&g, 1, 3000)};
        vti_springs springs = {NULL, &contacts, NULL, NULL, o};
        const double k = n * 1.5 * contacts.stiffness * sqrt(o);
        double omega2 = k * (1 / c.mass[0] + 1 / c.mass[1]) / (length * length);
        assert_close(stable(&springs), 2 / sqrt(omega2), 8 * EPS * 2 / sqrt(omega2));

        /* a wall is a neighbour that does not move */
        c.n = 1;
        for (int p = 0; p < n; ++p)
            random_unit(&g, 3, plane[p]);
        const vti_walls walls = {n, plane[0], vti_scalars_array(diameter), contacts.stiffness};
        springs.contacts = NULL;
        springs.walls = &walls;
        omega2 = k / (c.mass[0] * radius * radius);
        assert_close(stable(&springs), 2 / sqrt(omega2), 8 * EPS * 2 / sqrt(omega2));

        /* an arm alone, and with walls, whose shares it takes though they do not turn */
        vti_pendulum pendulum = {uniform(&g, 0.1, 20), {0, 0, 0}};
        random_vector(&g, 1, pendulum.rho0);
        springs.walls = NULL;
        springs.pendulum = &pendulum;
        const double arm = pendulum.weight * vti_norm(pendulum.rho0) / c.inertia[0];
        assert_close(stable(&springs), 2 / sqrt(arm), 8 * EPS * 2 / sqrt(arm));
        springs.walls = &walls;
        const double both = fmax(arm, omega2 / n) * (n + 1);
        assert_close(stable(&springs), 2 / sqrt(both), 8 * EPS * 2 / sqrt(both));
        springs.walls = NULL;
        springs.pendulum = NULL;
        assert_true(isinf(stable(&springs))); /* nothing oscillates */
    }
}

/* ---- packings ---------------------------------------------------------------------------------------------------- */

/** Bonds at one body, the most. */
static double most_bonds(void)
{
    double z[CROWD_MAX] = {0}, most = 0;
    for (int64_t k = 0; k < w.bonds.count; ++k)
        for (int side = 0; side < 2; ++side)
            z[w.pair[k][side] - w.bonds.base] += 1;
    for (int i = 0; i < c.n; ++i)
        most = fmax(most, z[i]);
    return most;
}

/** Bonds only. With shares of 1/z of its bodies one bond has at most z times the frequency^2 that it has with the
 *  whole bodies, and that is at most the one of the whole packing: the bound cannot be below limit/sqrt(z), or, with
 *  what is said above of shear, limit/sqrt(2 z). */
static void bonded_packings(void **state)
{
    (void)state;
    rng g = rng_seed(3073);
    double low = 1, high = 0;
    for (int trial = 0; trial < 60; ++trial) {
        crowd_clear(&c, 3 + rng_below(&g, 10), trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.4);
        weigh(&g);
        const int64_t count = web_grow(&w, &g, &c, rng_below(&g, 2 * c.n), 0.1, 100);
        web_terms(&w, count, 1 + trial % 7, VTI_SHEAR_OBJECTIVE);
        web_base(&w, trial / 2 % 2);
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        const vti_springs springs = {&w.bonds, NULL, NULL, NULL, 0};
        const double limit = hessian_limit(&c, &effect, 1), ratio = stable(&springs) / limit;
        assert_below(ratio, 1 + HESSIAN_ERROR);
        assert_true(ratio >= (1 - HESSIAN_ERROR) / sqrt(2 * most_bonds()));
        low = fmin(low, ratio);
        high = fmax(high, ratio);
    }
    print_message("packings: between %.3f and %.3f of the limit\n", low, high);
}

/** Contacts, walls and pendulum arms added, overlaps up to what the springs are told. */
static void packings_in_contact(void **state)
{
    (void)state;
    rng g = rng_seed(3074);
    double low = 1, high = 0;
    for (int trial = 0; trial < 60; ++trial) {
        static int64_t pair[CROWD_MAX * CROWD_MAX][2];
        double plane[2][4], diameter[CROWD_MAX], overlap = 0.05;
        int64_t touching = 0;
        crowd_clear(&c, 3 + rng_below(&g, 6), CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.5);
        weigh(&g);
        const int64_t count = web_grow(&w, &g, &c, 2, 0.1, 10);
        web_terms(&w, count, 1 + trial % 7, VTI_SHEAR_OBJECTIVE);
        for (int i = 0; i < c.n; ++i)
            diameter[i] = uniform(&g, 0.5, 1);
        for (int i = 0; i < c.n; ++i)
            for (int j = 0; j < i; ++j) {
                const double d[3] = {c.x[i][0] - c.x[j][0], c.x[i][1] - c.x[j][1], c.x[i][2] - c.x[j][2]};
                const double o = 1 - 2 * vti_norm(d) / (diameter[i] + diameter[j]);
                if (o > 0.01) {
                    overlap = fmax(overlap, o);
                    pair[touching][0] = i;
                    pair[touching++][1] = j;
                }
            }
        for (int k = 0; k < 2; ++k) { /* body k overlaps by 0.04, and others by more or not at all */
            random_unit(&g, 3, plane[k]);
            plane[k][3] = vti_dot(plane[k], c.x[k]) - 0.96 * diameter[k] / 2;
            for (int i = 0; i < c.n; ++i)
                overlap = fmax(overlap, 1 - (vti_dot(plane[k], c.x[i]) - plane[k][3]) / (diameter[i] / 2));
        }
        vti_pendulum pendulum = {uniform(&g, 0, 20), {0, 0, 0}};
        random_vector(&g, 1, pendulum.rho0);
        const vti_contacts contacts = {touching, pair[0], 0, vti_scalars_array(diameter), uniform(&g, 1, 100)};
        const vti_walls walls = {1 + trial % 2, plane[0], vti_scalars_array(diameter), uniform(&g, 1, 100)};
        const vti_effect all[4] = {vti_bonds_effect(&w.bonds), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                   vti_pendulum_effect(&pendulum)};
        const vti_springs springs = {&w.bonds, &contacts, &walls, &pendulum, overlap};
        const double ratio = stable(&springs) / hessian_limit(&c, all, 4);
        assert_below(ratio, 1 + HESSIAN_ERROR);
        low = fmin(low, ratio);
        high = fmax(high, ratio);
    }
    print_message("in contact: between %.3f and %.3f of the limit\n", low, high);
}

/** Bodies behind others that the springs do not name: the same step, and no more scratch than they need. */
static void slice(void **state)
{
    (void)state;
    rng g = rng_seed(3077);
    for (int trial = 0; trial < 50; ++trial) {
        const int first = 1 + trial % 7, n = 5;
        double h;
        crowd_clear(&c, n, CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.4);
        weigh(&g);
        web_terms(&w, web_grow(&w, &g, &c, 3, 0.1, 100), MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        vti_pendulum pendulum = {uniform(&g, 0, 20), {0, 0, 1}};
        const double diameter = 0.5, plane[4] = {0, 0, 1, 0};
        const vti_walls walls = {1, plane, vti_scalars_one(&diameter), 10};
        vti_springs springs = {&w.bonds, NULL, &walls, &pendulum, 0.1};
        const double expected = stable(&springs);
        for (int i = n - 1; i >= 0; --i) { /* body i becomes body first + i; what is before is light */
            c.mass[first + i] = c.mass[i];
            c.inertia[first + i] = c.inertia[i];
        }
        for (int i = 0; i < first; ++i)
            c.mass[i] = c.inertia[i] = 1e-9;
        for (int64_t k = 0; k < w.bonds.count; ++k)
            for (int side = 0; side < 2; ++side)
                w.pair[k][side] += first;
        c.n = first + n;
        scratch[n] = 7;
        const vti_bodies b = vti_bodies_slice(crowd_bodies(&c), first, n);
        assert_int_equal(vti_stable_step(&springs, &b, scratch, &h), VTI_OK);
        assert_true(h == expected && scratch[n] == 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(torus_is_close),  cmocka_unit_test(closed_forms),     cmocka_unit_test(one_bond),
        cmocka_unit_test(bonded_packings), cmocka_unit_test(parallel_springs), cmocka_unit_test(packings_in_contact),
        cmocka_unit_test(slice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
