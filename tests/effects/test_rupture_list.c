/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What bonds hold, which of them break, and the list that is left: its order, and the bits of all that reads it. */
#include "crowd.h"

static crowd c, alone;
static web w, left;
static int64_t id[WEB_MAX];
static double limit[6][WEB_MAX], measures[WEB_MAX][VTI_BOND_MEASURES];
static vti_sum lost;

/** A crowd whose bonds are strained, twisted and bent. */
static int64_t strained(rng *g, int trial, int *terms)
{
    int form;
    const int n = 2 + trial % 12 * 7;
    crowd_clear(&c, n, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
    crowd_scatter(&c, g, 2, 0.2);
    const int64_t count = web_grow(&w, g, &c, n, 1, 20);
    crowd_scatter(&c, g, 2, 0.2);
    crowd_tumble(&c, g);
    web_combination(trial % 15, terms, &form);
    web_terms(&w, count, *terms, form);
    for (int k = 0; k < WEB_MAX; ++k)
        id[k] = k;
    lost.high = lost.low = 0;
    return count;
}

/** The loads of bond k by one of its terms, as the effect gives them to its first body. */
static void by_effect(int64_t k, int term, double force[3], double moment[3], double *energy)
{
    const int i = (int)w.pair[k][0];
    vti_bonds one = w.bonds;
    double energies[3];
    one.count = 1;
    one.pair = w.pair[k];
    one.rest = w.rest[k];
    one.moment = term == MOMENT ? vti_scalars_one(&w.moment[k]) : (vti_scalars){0};
    one.axial = term == AXIAL ? vti_scalars_one(&w.axial[k]) : (vti_scalars){0};
    one.shear = term == SHEAR ? vti_scalars_one(&w.shear[k]) : (vti_scalars){0};
    alone = c;
    const vti_bodies b = crowd_bodies(&alone);
    const vti_effect effect = vti_bonds_effect(&one);
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
    effect.energy(effect.self, &b, energies);
    *energy += energies[0];
    memcpy(force, alone.force[i], sizeof alone.force[i]);
    memcpy(moment, alone.moment[i], sizeof alone.moment[i]);
}

/** N, V, M_b and M_t are what the forces and moments of the terms are, along n and across it. */
TEST(what_bonds_hold)
{
    rng g = rng_seed(1451);
    for (int trial = 0; trial < 15 * 4; ++trial) {
        int terms;
        const int64_t count = strained(&g, trial, &terms);
        const vti_bodies b = crowd_bodies(&c);
        assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, count / 2, measures[0]), VTI_OK);
        assert_int_equal(vti_bonds_measure(&w.bonds, &b, count / 2, count, measures[count / 2]), VTI_OK);
        for (int64_t k = 0; k < count; ++k) {
            double n[3], f[3], t[3], none[3], energy = 0, expected[VTI_BOND_MEASURES] = {0};
            for (int q = 0; q < 3; ++q)
                n[q] = c.x[w.pair[k][0]][q] - c.x[w.pair[k][1]][q];
            const double r = vti_norm(n);
            expected[VTI_BOND_STRETCH] = r / w.rest[k][3] - 1;
            if (terms & MOMENT) {
                by_effect(k, MOMENT, none, t, &energy);
                const double twist = vti_dot(t, n) / r;
                expected[VTI_BOND_TORSION] = fabs(twist);
                for (int q = 0; q < 3; ++q)
                    t[q] -= twist * n[q] / r;
                expected[VTI_BOND_BENDING] = vti_norm(t);
            }
            if (terms & AXIAL) {
                by_effect(k, AXIAL, f, none, &energy);
                expected[VTI_BOND_NORMAL] = -vti_dot(f, n) / r;
            }
            if (terms & SHEAR) {
                by_effect(k, SHEAR, f, none, &energy);
                expected[VTI_BOND_ACROSS] = vti_norm(f);
            }
            expected[VTI_BOND_ENERGY] = energy;
            for (int m = 0; m < VTI_BOND_MEASURES; ++m)
                assert_close(measures[k][m], expected[m], 200 * EPS * (fabs(expected[m]) + 20 / w.rest[k][3] + 20));
        }
    }
}

/** One bond of unit length that holds N = 2, V = 0, M_b = 3, M_t = 4 and U = 2/5 + (9 + 16)/20, with these limits. */
static int64_t breaks(double stretch, double normal, double bending, double torsion, double energy)
{
    const double stiffness = 10, axis[3] = {0.4, 0.3, 0}, all[] = {stretch, normal, bending, torsion, energy};
    crowd_clear(&c, 2, CROWD_QUAT);
    memset(&w, 0, sizeof w);
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = 1;
    w.moment[0] = w.axial[0] = stiffness;
    web_terms(&w, 1, MOMENT | AXIAL, VTI_SHEAR_OBJECTIVE);
    c.x[0][0] = 1.2;
    crowd_turn(&c, 0, axis, 0.5L);
    id[0] = 0;
    lost.high = lost.low = 0;
    vti_rupture rupture = {.bonds = &w.bonds, .id = id, .lost = &lost};
    vti_scalars *const to[] = {&rupture.stretch, &rupture.normal, &rupture.bending, &rupture.torsion, &rupture.energy};
    for (int k = 0; k < 5; ++k)
        if (all[k] != 0)
            *to[k] = vti_scalars_one(&all[k]);
    const vti_effect effects[] = {vti_bonds_effect(&w.bonds), vti_rupture_effect(&rupture)};
    const vti_bodies b = crowd_bodies(&c);
    int64_t broken = -1;
    assert_int_equal(vti_rupture_check(&rupture, NULL), VTI_OK);
    const double before = vti_energy(effects, 2, &b) + vti_booked(effects, 2);
    assert_int_equal(vti_effects_rupture(effects, 2, &b, &broken), VTI_OK);
    assert_int_equal(w.bonds.count, 1 - broken);
    assert_close(vti_energy(effects, 2, &b) + vti_booked(effects, 2), before, 4 * EPS);
    assert_close(vti_sum_value(&lost), broken ? 0.2 + 1.25 : 0, 20 * EPS);
    return broken;
}

TEST(limits)
{
    const double more = 1 + 1e-12, less = 1 - 1e-12;
    assert_int_equal(breaks(0, 0, 0, 0, 0), 0);
    assert_int_equal(breaks(INFINITY, INFINITY, INFINITY, INFINITY, INFINITY), 0);
    assert_int_equal(breaks(0.2 * more, 0, 0, 0, 0), 0);
    assert_int_equal(breaks(0.2 * less, 0, 0, 0, 0), 1);
    assert_int_equal(breaks(0, 2 * more, 0, 0, 0), 0);
    assert_int_equal(breaks(0, 2 * less, 0, 0, 0), 1);
    assert_int_equal(breaks(0, 0, 3 * more, 0, 0), 0);
    assert_int_equal(breaks(0, 0, 3 * less, 0, 0), 1);
    assert_int_equal(breaks(0, 0, 0, 4 * more, 0), 0);
    assert_int_equal(breaks(0, 0, 0, 4 * less, 0), 1);
    assert_int_equal(breaks(0, 0, 0, 0, 1.45 * more), 0);
    assert_int_equal(breaks(0, 0, 0, 0, 1.45 * less), 1);
    /* forces and moments add up, stretch and energy stand alone */
    assert_int_equal(breaks(0, 6, 9, 12 * more, 0), 0);
    assert_int_equal(breaks(0, 6, 9, 12 * less, 0), 1);
    assert_int_equal(breaks(0.21, 2.1, 0, 0, 1.5), 0);
}

/** Pressure delays, and a force across counts as the others do. */
TEST(pressure_and_shear)
{
    const double axial = 10, shear = 8, normal_limit = 4, shear_limit = 2;
    for (int k = 0; k < 200; ++k) {
        const double r = 0.5 + 0.004 * k, angle = 0.02 * (k % 17);
        crowd_clear(&c, 2, CROWD_ALPHA);
        memset(&w, 0, sizeof w);
        w.pair[0][1] = 1;
        w.rest[0][0] = w.rest[0][3] = 1;
        w.axial[0] = axial;
        w.shear[0] = shear;
        web_terms(&w, 1, AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        c.x[0][0] = r * cos(angle);
        c.x[0][1] = r * sin(angle);
        id[0] = 0;
        lost.high = lost.low = 0;
        const vti_rupture rupture = {.bonds = &w.bonds,
                                     .id = id,
                                     .normal = vti_scalars_one(&normal_limit),
                                     .shear = vti_scalars_one(&shear_limit),
                                     .lost = &lost};
        const vti_effect effect = vti_rupture_effect(&rupture);
        const vti_bodies b = crowd_bodies(&c);
        const double share = axial * (r - 1) / normal_limit + shear * sin(angle) / r / shear_limit;
        int64_t broken;
        assert_int_equal(vti_effects_rupture(&effect, 1, &b, &broken), VTI_OK);
        if (fabs(share - 1) > 1e-9)
            assert_int_equal(broken, share > 1);
    }
}

/** What is left of a list is the list without what broke, in its order; what broke stands behind it. */
TEST(what_is_left)
{
    rng g = rng_seed(1452);
    int64_t all_broken = 0;
    for (int trial = 0; trial < 60; ++trial) {
        int terms;
        const int64_t count = strained(&g, trial, &terms), base = trial % 2;
        const int shared = trial % 5 == 4, one = trial % 5 == 3;
        web_base(&w, base);
        if (shared) {
            w.bonds.moment.p = w.bonds.moment.p != NULL ? w.shear : NULL;
            w.bonds.axial = vti_scalars_array(w.shear);
        }
        if (one)
            w.bonds.axial = vti_scalars_one(&w.axial[0]);
        static web was;
        was = w;
        for (int64_t k = 0; k < count; ++k) {
            id[k] = k + base;
            limit[0][k] = rng_below(&g, 3) ? 1e-300 : INFINITY;
        }
        vti_rupture rupture = {.bonds = &w.bonds, .id = id, .energy = vti_scalars_array(limit[0]), .lost = &lost};
        rupture.energy.count = count;
        assert_int_equal(vti_rupture_check(&rupture, NULL), VTI_OK);
        const vti_bodies b = crowd_bodies(&c);
        assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, count, measures[0]), VTI_OK);
        const vti_effect effects[] = {vti_bonds_effect(&w.bonds), vti_rupture_effect(&rupture)};
        int64_t broken, kept = 0;
        vti_sum expected = {0, 0};
        assert_int_equal(vti_effects_rupture(effects, 2, &b, &broken), VTI_OK);
        memset(&left, 0, sizeof left);
        for (int64_t k = 0; k < count; ++k) {
            if (measures[k][VTI_BOND_ENERGY] >= limit[0][k]) {
                vti_sum_add(&expected, measures[k][VTI_BOND_ENERGY]);
                continue;
            }
            assert_int_equal(id[kept], k + base);
            memcpy(left.pair[kept], was.pair[k], sizeof was.pair[k]);
            memcpy(left.rest[kept], was.rest[k], sizeof was.rest[k]);
            left.moment[kept] = was.moment[k];
            left.axial[kept] = was.axial[k];
            left.shear[kept++] = was.shear[k];
        }
        assert_int_equal(w.bonds.count, kept);
        assert_int_equal(broken, count - kept);
        assert_true(vti_sum_value(&lost) == vti_sum_value(&expected));
        assert_memory_equal(w.pair, left.pair, (size_t)kept * sizeof w.pair[0]);
        assert_same_bits(w.rest[0], left.rest[0], (int)(4 * kept));
        if (terms & SHEAR || shared)
            assert_same_bits(w.shear, left.shear, (int)kept);
        if (terms & MOMENT && !shared)
            assert_same_bits(w.moment, left.moment, (int)kept);
        if (terms & AXIAL && !shared && !one)
            assert_same_bits(w.axial, left.axial, (int)kept);
        /* nothing is lost: the arrays hold the same bonds, in another order */
        for (int64_t k = 0; k < count; ++k) {
            assert_memory_equal(w.pair[k], was.pair[id[k] - base], sizeof was.pair[0]);
            assert_true(w.rest[k][3] == was.rest[id[k] - base][3]);
        }
        all_broken += broken;
        /* and the same again breaks nothing */
        assert_int_equal(vti_effects_rupture(effects, 2, &b, &broken), VTI_OK);
        assert_int_equal(broken, 0);
    }
    assert_true(all_broken > 500);
}

TEST(take_out)
{
    rng g = rng_seed(1453);
    int terms;
    const int64_t count = strained(&g, 33, &terms), out[] = {0, 2, 3, count - 1}, not_there[] = {1, 3}, down[] = {5, 4};
    static web was;
    was = w;
    vti_rupture rupture = {.bonds = &w.bonds, .id = id, .lost = &lost};
    assert_int_equal(vti_rupture_take_out(&rupture, 4, out), VTI_OK);
    assert_int_equal(w.bonds.count, count - 4);
    assert_int_equal(id[0], 1);
    assert_int_equal(id[1], 4);
    assert_memory_equal(w.pair[1], was.pair[4], sizeof was.pair[0]);
    assert_true(lost.high == 0);
    assert_int_equal(vti_rupture_take_out(&rupture, 2, not_there), VTI_E_BOND);
    assert_int_equal(vti_rupture_take_out(&rupture, 2, down), VTI_E_BOND);
    assert_int_equal(w.bonds.count, count - 4);
    assert_int_equal(vti_rupture_take_out(&rupture, 0, NULL), VTI_OK);
    assert_int_equal(vti_rupture_take_out(&rupture, 1, NULL), VTI_E_NULL);
    assert_int_equal(vti_rupture_take_out(&rupture, -1, out), VTI_E_COUNT);
    assert_int_equal(vti_rupture_take_out(NULL, 0, NULL), VTI_E_NULL);
    rupture.id = NULL;
    assert_int_equal(vti_rupture_take_out(&rupture, 0, NULL), VTI_E_NULL);
    rupture.id = id;
    const double *const rest = w.bonds.rest;
    w.bonds.rest = NULL;
    assert_int_equal(vti_rupture_take_out(&rupture, 1, id), VTI_E_NULL);
    w.bonds.rest = rest;
    rupture.bonds = NULL;
    assert_int_equal(vti_rupture_take_out(&rupture, 0, NULL), VTI_E_NULL);
}

TEST(refusals)
{
    rng g = rng_seed(1454);
    int terms;
    const int64_t count = strained(&g, 6 + 15, &terms);
    vti_bodies b = crowd_bodies(&c);
    vti_fault fault;
    for (int k = 0; k < 6; ++k)
        for (int64_t m = 0; m < count; ++m)
            limit[k][m] = 1;
    vti_rupture good = {.bonds = &w.bonds, .id = id, .lost = &lost};
    vti_scalars *const limits[] = {&good.stretch, &good.normal,  &good.shear,
                                   &good.bending, &good.torsion, &good.energy};
    for (int k = 0; k < 6; ++k) {
        *limits[k] = vti_scalars_array(limit[k]);
        assert_int_equal(vti_rupture_check(&good, &fault), VTI_OK);
        static const double bad[] = {0, -1, NAN};
        for (int m = 0; m < 3; ++m) {
            limit[k][3] = bad[m];
            assert_int_equal(vti_rupture_check(&good, &fault), VTI_E_BOND);
            assert_int_equal(fault.body, 3);
            assert_true(isnan(bad[m]) ? isnan(fault.value) : fault.value == bad[m]);
        }
        limit[k][3] = 1;
    }
    w.bonds.count = -1;
    assert_int_equal(vti_rupture_check(&good, &fault), VTI_E_COUNT);
    w.bonds.count = count;
    good.energy.count = count - 1;
    assert_int_equal(vti_rupture_check(&good, &fault), VTI_E_BOND);
    assert_true(fault.body == count - 1 && fault.value == (double)(count - 1));
    good.energy.count = 0;
    id[2] = 1;
    assert_int_equal(vti_rupture_check(&good, &fault), VTI_E_BOND);
    assert_true(fault.body == 2 && fault.value == 1);
    id[2] = 2;
    id[0] = -1;
    assert_int_equal(vti_rupture_check(&good, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == -1);
    id[0] = 0;

    /* of numbers from 1 none is 0; those of the bonds that are left tell how many limits there have to be */
    vti_rupture few = {.bonds = &w.bonds, .id = id, .lost = &lost};
    web_base(&w, 1);
    assert_int_equal(vti_rupture_check(&few, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == 0);
    web_base(&w, 0);
    few.energy = vti_scalars_array(limit[0]);
    few.energy.count = 5;
    w.bonds.count = 2;
    for (id[1] = 4; id[1] < 6; ++id[1])
        assert_int_equal(vti_rupture_check(&few, &fault), id[1] < 5 ? VTI_OK : VTI_E_BOND);
    assert_true(fault.body == 1 && fault.value == 5);
    id[1] = 1;
    w.bonds.count = count;

    /* what is missing */
    vti_effect effect = vti_rupture_effect(&good);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    good.lost = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
    good.lost = &lost;
    assert_int_equal(vti_step_check(vti_stepper_find("srkn14"), &effect, 1), VTI_E_DISSIPATES);
    assert_int_equal(vti_step_check(vti_stepper_find("chin4"), &effect, 1), VTI_OK);
    w.bonds.shear_form = 9;
    w.bonds.shear = vti_scalars_array(w.shear);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_BOND);
    w.bonds.shear_form = VTI_SHEAR_OBJECTIVE;
    w.bonds.rest = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
    w.bonds.rest = w.rest[0];
    b.x = vti_view_none();
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NEEDS);
    assert_int_equal(fault.quantity, VTI_QUANTITY_X);
    w.bonds.shear.p = w.bonds.axial.p = NULL;
    b.v = b.force = vti_view_none();
    assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, 1, measures[0]), VTI_E_NEEDS);
    assert_int_equal(vti_bonds_measure(&w.bonds, &b, 1, 1, NULL), VTI_OK);
    assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, 1, NULL), VTI_E_NULL);
    for (int k = 0; k < 3; ++k) {
        vti_rupture bad = good;
        if (k == 0)
            bad.bonds = NULL;
        if (k == 1)
            bad.id = NULL;
        if (k == 2)
            bad.lost = NULL;
        effect = vti_rupture_effect(&bad);
        assert_int_equal(vti_rupture_check(&bad, NULL), VTI_E_NULL);
        assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
    }
    assert_int_equal(vti_rupture_check(NULL, NULL), VTI_E_NULL);
    effect = vti_rupture_effect(NULL);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
}

RUN_TESTS(cmocka_unit_test(what_bonds_hold), cmocka_unit_test(limits), cmocka_unit_test(pressure_and_shear),
          cmocka_unit_test(what_is_left), cmocka_unit_test(take_out), cmocka_unit_test(refusals))
