/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds as a list: many at once are the sum of one at a time, to the bit, whatever their number, base, stiffnesses
 * (one each or one for all), storage and slice; rest configurations, and what the check refuses. */
#include "crowd.h"

static crowd c;
static web w;

/** Bodies everywhere, and `extra` bonds more than a tree, at rest elsewhere. */
static int64_t draw(rng *g, int n, int extra, enum crowd_storage storage)
{
    crowd_clear(&c, n, storage);
    crowd_scatter(&c, g, 2, 0.2);
    const int64_t count = web_grow(&w, g, &c, extra, 1, 20);
    crowd_scatter(&c, g, 2, 0.2);
    crowd_tumble(&c, g);
    return count;
}

TEST(many_are_the_sum_of_one_at_a_time)
{
    rng g = rng_seed(3041);
    const int bodies[] = {2, 20, 60, 64, 65, 66, 80, 80}, extra[] = {0, 5, 4, 0, 0, 63, 100, 150};
    for (int trial = 0; trial < 15 * 8; ++trial) {
        static crowd one;
        int terms, form;
        double energies[3] = {0, 0, 0}, single[3], sum[3] = {0, 0, 0};
        const int64_t count = draw(&g, bodies[trial / 15], extra[trial / 15], trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        web_combination(trial % 15, &terms, &form);
        web_terms(&w, count, terms, form);
        assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_OK);
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        const vti_bodies b = crowd_bodies(&c);
        vti_apply(&effect, 1, &b);
        effect.energy(effect.self, &b, energies);
        one = c;
        memset(one.force, 0, sizeof one.force);
        memset(one.moment, 0, sizeof one.moment);
        const vti_bodies alone = crowd_bodies(&one);
        for (int64_t k = 0; k < count; ++k) {
            /* the first bond of a web of its own, with stiffnesses of stride 0, in Fortran's base */
            const int64_t pair[2] = {w.pair[k][0] + 1, w.pair[k][1] + 1};
            vti_bonds bond = w.bonds;
            bond.count = bond.base = 1;
            bond.pair = pair;
            bond.rest = w.rest[k];
            bond.moment.p = terms & MOMENT ? w.moment + k : NULL;
            bond.axial.p = terms & AXIAL ? w.axial + k : NULL;
            bond.shear.p = terms & SHEAR ? w.shear + k : NULL;
            bond.moment.stride = bond.axial.stride = bond.shear.stride = 0;
            const vti_effect e = vti_bonds_effect(&bond);
            e.apply(e.self, &alone);
            e.energy(e.self, &alone, single);
            for (int t = 0; t < e.terms; ++t)
                sum[t] += single[t];
        }
        assert_same_bits(one.force[0], c.force[0], 3 * c.n);
        assert_same_bits(one.moment[0], c.moment[0], 3 * c.n);
        for (int t = 0; t < effect.terms; ++t) /* the sum here is plain */
            assert_close(energies[t], sum[t], (double)count * EPS * sum[t]);
    }
}

/** Stiffnesses with strides: one for all bonds is an array of equal ones, and every third number of an array
 *  another. */
TEST(strides)
{
    rng g = rng_seed(3045);
    for (int trial = 0; trial < 15; ++trial) {
        static double spread[3][3 * WEB_MAX];
        static crowd plain;
        int terms, form;
        const int64_t count = draw(&g, 80, 60, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        const vti_bodies b = crowd_bodies(&c);
        double *const own[3] = {w.moment, w.axial, w.shear};
        web_combination(trial, &terms, &form);
        for (int one = 0; one < 2; ++one) {
            web_terms(&w, count, terms, form);
            vti_scalars *const all[3] = {&w.bonds.moment, &w.bonds.axial, &w.bonds.shear};
            for (int t = 0; t < 3; ++t)
                for (int k = 0; k < count; ++k) {
                    own[t][k] = one ? own[t][0] : own[t][k];
                    spread[t][3 * k] = own[t][k];
                    spread[t][3 * k + 1] = spread[t][3 * k + 2] = NAN;
                }
            vti_effect effect = vti_bonds_effect(&w.bonds);
            vti_apply(&effect, 1, &b);
            plain = c;
            for (int t = 0; t < 3; ++t)
                if (all[t]->p != NULL) {
                    all[t]->p = spread[t];
                    all[t]->stride = one ? 0 : 3;
                }
            effect = vti_bonds_effect(&w.bonds);
            vti_apply(&effect, 1, &b);
            assert_same_bits(c.force[0], plain.force[0], 3 * c.n);
            assert_same_bits(c.moment[0], plain.moment[0], 3 * c.n);
            assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_OK);
        }
    }
}

/** A slice of the bodies has all the bonds; no bonds are no energy. */
TEST(slice_and_nothing)
{
    rng g = rng_seed(3042);
    const int64_t count = draw(&g, 20, 10, CROWD_ALPHA);
    double energies[3] = {7, 7, 7};
    web_terms(&w, count, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    vti_effect effect = vti_bonds_effect(&w.bonds);
    const vti_bodies b = crowd_bodies(&c), slice = vti_bodies_slice(b, 3, 4);
    vti_apply(&effect, 1, &b);
    const crowd whole = c;
    const double nothing[3] = {0};
    memset(c.force, 0, sizeof c.force);
    memset(c.moment, 0, sizeof c.moment);
    effect.apply(effect.self, &slice);
    for (int i = 0; i < c.n; ++i) { /* its own bodies feel all of their bonds, no other body feels any */
        const int own = i >= 3 && i < 7;
        assert_same_bits(c.force[i], own ? whole.force[i] : nothing, 3);
        assert_same_bits(c.moment[i], own ? whole.moment[i] : nothing, 3);
    }
    w.bonds.count = 0;
    effect = vti_bonds_effect(&w.bonds);
    effect.energy(effect.self, &b, energies);
    assert_true(energies[0] == 0 && energies[1] == 0 && energies[2] == 0);
}

TEST(rest_configuration)
{
    rng g = rng_seed(3043);
    for (int trial = 0; trial < 500; ++trial) {
        const int64_t pair[1][2] = {{2, 1}};
        double rest[4], fortran[4];
        vti_fault fault = {-1, -1, 0};
        crowd_clear(&c, 3, CROWD_ALPHA);
        crowd_scatter(&c, &g, 1, 0.1);
        const vti_view x = vti_view_packed(c.x[0]), from_one = vti_view_packed(c.x[1]);
        assert_int_equal(vti_bonds_rest(1, pair[0], 0, &x, rest, NULL), VTI_OK);
        long double r = 0;
        for (int k = 0; k < 3; ++k)
            r += powl((long double)c.x[2][k] - c.x[1][k], 2);
        r = sqrtl(r);
        assert_close(rest[3], r, 4 * EPS * r); /* differences, squares and root: half an eps each, and a bit */
        for (int k = 0; k < 3; ++k)
            assert_close(rest[k], (c.x[2][k] - c.x[1][k]) / r, 4 * EPS);
        assert_int_equal(vti_bonds_rest(1, pair[0], 1, &from_one, fortran, NULL), VTI_OK);
        /* base 1: body 2 is the second from x[1], which is x[2], and body 1 the first */
        assert_same_bits(rest, fortran, 4);
        memcpy(c.x[1], c.x[2], sizeof c.x[1]);
        assert_int_equal(vti_bonds_rest(1, pair[0], 0, &x, rest, &fault), VTI_E_BOND);
        assert_int_equal(fault.body, 0);
        assert_true(fault.value == 0);
    }
}

/** Whatever is wrong with one bond of many is refused with its number and the value. */
TEST(check_names_the_bond)
{
    rng g = rng_seed(3044);
    enum { FAULTS = 13 };
    for (int trial = 0; trial < FAULTS * 20; ++trial) {
        vti_fault fault = {-1, -1, 0};
        const int64_t count = draw(&g, 20, 30, CROWD_ALPHA), k = rng_below(&g, (int)count);
        double value;
        web_terms(&w, count, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        assert_int_equal(vti_bonds_check(&w.bonds, c.n, &fault), VTI_OK);
        double *const stiffness[3] = {w.moment + k, w.axial + k, w.shear + k};
        const double bad[3] = {-1, NAN, INFINITY};
        const int what = trial % FAULTS;
        if (what < 9)
            value = *stiffness[what % 3] = bad[what / 3];
        else if (what == 9)
            value = (double)(w.pair[k][0] = 20);
        else if (what == 10)
            value = (double)(w.pair[k][1] = -1);
        else if (what == 11)
            value = (double)(w.pair[k][1] = w.pair[k][0]);
        else
            value = w.rest[k][3] = -w.rest[k][3];
        assert_int_equal(vti_bonds_check(&w.bonds, c.n, &fault), VTI_E_BOND);
        assert_int_equal(fault.body, k);
        assert_true(fault.value == value || (isnan(value) && isnan(fault.value)));
    }
    const int64_t count = draw(&g, 20, 30, CROWD_ALPHA);
    web_terms(&w, count, AXIAL, 0);
    const double diameter = 1;
    const int64_t named[][3] = {
        {INT64_MIN, 1, 1}, {INT64_MAX, 0, -1}, {INT64_MIN, INT64_MIN + 1, INT64_MAX}}; /* and the base */
    for (int n = 0; n < 3; ++n) { /* whose differences are no numbers */
        const vti_contacts contacts = {1, named[n], named[n][2], vti_scalars_one(&diameter), 1, {0}, {0}};
        vti_bonds one = w.bonds;
        one.count = 1;
        one.pair = named[n];
        one.base = named[n][2];
        assert_int_equal(vti_bonds_check(&one, c.n, NULL), VTI_E_BOND);
        assert_int_equal(vti_contacts_check(&contacts, c.n, NULL), VTI_E_CONTACT);
    }
    w.rest[3][1] += 0.01; /* n0 is not a unit vector */
    assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_E_BOND);
    w.bonds.count = -1;
    assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_E_COUNT);
    const vti_bodies b = crowd_bodies(&c);
    const vti_effect none = vti_bonds_effect(&w.bonds);
    assert_int_equal(vti_effects_check(&none, 1, &b, NULL), VTI_E_COUNT);
    w.bonds.count = 1;
    w.bonds.rest = NULL;
    assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_check(NULL, c.n, NULL), VTI_E_NULL);
}

/** A form of shear that there is not is refused: below the first, above the last. */
TEST(unknown_form_of_shear)
{
    rng g = rng_seed(3049);
    const int64_t count = draw(&g, 20, 5, CROWD_ALPHA);
    const int64_t wrong[] = {0, VTI_SHEAR_PRINTED + 1, INT64_MIN};
    web_terms(&w, count, SHEAR, VTI_SHEAR_OBJECTIVE);
    const vti_bodies b = crowd_bodies(&c);
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
    const crowd right = c;
    for (int k = 0; k < 3; ++k) {
        w.bonds.shear_form = wrong[k];
        const vti_effect none = vti_bonds_effect(&w.bonds);
        assert_int_equal(vti_apply(&none, 1, &b), VTI_E_BOND);
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_E_BOND);
        assert_true(isnan(vti_energy(&none, 1, &b)));
        assert_same_bits(right.force[0], c.force[0], 3 * c.n);
        assert_same_bits(right.moment[0], c.moment[0], 3 * c.n);
    }
}

RUN_TESTS(cmocka_unit_test(many_are_the_sum_of_one_at_a_time), cmocka_unit_test(strides),
          cmocka_unit_test(slice_and_nothing), cmocka_unit_test(rest_configuration),
          cmocka_unit_test(check_names_the_bond), cmocka_unit_test(unknown_form_of_shear))
