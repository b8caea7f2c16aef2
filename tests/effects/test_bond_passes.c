/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Loads of bonds by ranges, summed for slices of bodies: the bits of the effect, wherever the ranges and slices end. */
#include "crowd.h"

static crowd c, parts;
static web w;
static double loads[WEB_MAX * VTI_BOND_LOADS];

/** The effect of the web on parts, its bonds in ranges and its bodies in slices that end at random. */
static void by_parts(rng *g)
{
    vti_bodies b = crowd_bodies(&parts);
    for (int64_t first = 0, last; first < w.bonds.count; first = last) {
        last = first + 1 + (int64_t)(uniform(g, 0, 1) * 20);
        last = last < w.bonds.count ? last : w.bonds.count;
        assert_int_equal(vti_bonds_loads(&w.bonds, &b, first, last, loads + first * VTI_BOND_LOADS), VTI_OK);
    }
    for (int64_t first = 0; first < parts.n; first += b.count) {
        b.first = first;
        b.count = 1 + (int64_t)(uniform(g, 0, 1) * 10);
        b.count = b.count < parts.n - first ? b.count : parts.n - first;
        const int64_t half = w.bonds.count / 2;
        assert_int_equal(vti_bonds_sum(&w.bonds, loads, 0, half, &b), VTI_OK);
        assert_int_equal(vti_bonds_sum(&w.bonds, loads + half * VTI_BOND_LOADS, half, w.bonds.count, &b), VTI_OK);
    }
}

TEST(ranges_and_slices)
{
    rng g = rng_seed(77);
    for (int trial = 0; trial < 60; ++trial) {
        const int n = 2 + trial % 12 * 7;
        int terms, form;
        crowd_clear(&c, n, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        crowd_scatter(&c, &g, 2, 0.2);
        const int64_t count = web_grow(&w, &g, &c, n, 1, 20);
        crowd_scatter(&c, &g, 2, 0.2);
        crowd_tumble(&c, &g);
        web_combination(trial % 15, &terms, &form);
        web_terms(&w, count, terms, form);
        parts = c;
        const vti_bodies b = crowd_bodies(&c);
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        effect.apply(effect.self, &b);
        by_parts(&g);
        assert_same_bits(parts.force[0], c.force[0], 3 * n);
        assert_same_bits(parts.moment[0], c.moment[0], 3 * n);
    }
}

TEST(refused)
{
    rng g = rng_seed(78);
    crowd_clear(&c, 5, CROWD_ALPHA);
    crowd_scatter(&c, &g, 2, 0.2);
    const int64_t count = web_grow(&w, &g, &c, 5, 1, 4);
    web_terms(&w, count, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    vti_bodies b = crowd_bodies(&c);
    assert_int_equal(vti_bonds_loads(NULL, &b, 0, 1, loads), VTI_E_NULL);
    assert_int_equal(vti_bonds_loads(&w.bonds, NULL, 0, 1, loads), VTI_E_NULL);
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 0, 1, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 1, 1, NULL), VTI_OK);
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, -1, 1, loads), VTI_E_COUNT);
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 1, 0, loads), VTI_E_COUNT);
    assert_int_equal(vti_bonds_sum(&w.bonds, loads, 0, count + 1, &b), VTI_E_COUNT);
    w.bonds.shear_form = 7;
    assert_int_equal(vti_bonds_sum(&w.bonds, loads, 0, 1, &b), VTI_E_BOND);
    w.bonds.shear_form = VTI_SHEAR_PRINTED;
    b.alpha = vti_view_none();
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 0, 1, loads), VTI_E_NEEDS);
    w.bonds.moment.p = w.bonds.shear.p = NULL;
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 0, 1, loads), VTI_OK);
    b.x = vti_view_none();
    assert_int_equal(vti_bonds_loads(&w.bonds, &b, 0, 1, loads), VTI_E_NEEDS);
}

RUN_TESTS(cmocka_unit_test(ranges_and_slices), cmocka_unit_test(refused))
