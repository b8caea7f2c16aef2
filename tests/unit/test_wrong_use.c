/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a stateless library can see of wrong use beside bodies (test_status.c has those): arguments that are NULL, lists
 * that name no body, effects and steppers in part. A status where there is one, no number where there is none, never a
 * crash. */
#include "every_call.h"
#include "support.h"

static double x[6] = {0, 0, 0, 1, 0, 0}, v[6], mass = 1;
static vti_bodies b;

static int setup(void **state)
{
    (void)state;
    b = vti_bodies_none(2);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.mass = vti_scalars_one(&mass);
    return 0;
}

/** What is wrong is a list or a number, and with that no quantity of bodies. fault is spoiled for the next. */
static void nothing_of_bodies(vti_fault *fault, int64_t body)
{
    assert_int_equal(fault->body, body);
    assert_int_equal(fault->quantity, VTI_QUANTITY_NONE);
    fault->body = fault->quantity = 7;
}

TEST(rest)
{
    const int64_t good[2] = {0, 1}, below[4] = {0, 1, -1, 1};
    const vti_view part = {{x, NULL, x + 2}, 3, 0}, first = {{NULL, x + 1, x + 2}, 3, 0},
                   last = {{x, x + 1, NULL}, 3, 0};
    double far[6] = {1e308, 0, 0, -1e308, 0, 0};
    const vti_view apart = vti_view_packed(far);
    double r[8] = {7, 7, 7, 7, 7, 7, 7, 7};
    const double before = 7;
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_bonds_rest(1, NULL, 0, &b.x, r, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(1, NULL, 0, &b.x, r, &fault), VTI_E_NULL);
    nothing_of_bodies(&fault, -1);
    assert_int_equal(vti_bonds_rest(1, good, 0, NULL, r, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(1, good, 0, &b.x, NULL, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(1, good, 0, &part, r, NULL), VTI_E_VIEW);
    assert_int_equal(vti_bonds_rest(1, good, 0, &first, r, NULL), VTI_E_VIEW);
    assert_int_equal(vti_bonds_rest(1, good, 0, &last, r, NULL), VTI_E_VIEW);
    assert_int_equal(vti_bonds_rest(1, good, 0, &last, r, &fault), VTI_E_VIEW);
    assert_true(fault.body == -1 && fault.quantity == VTI_QUANTITY_X);
    assert_int_equal(vti_bonds_rest(1, good, 0, &apart, r, &fault), VTI_E_BOND);
    nothing_of_bodies(&fault, 0);
    assert_true(isinf(fault.value));
    assert_int_equal(vti_bonds_rest(-1, good, 0, &b.x, r, NULL), VTI_E_COUNT);
    assert_int_equal(vti_bonds_rest(-1, good, 0, &b.x, r, &fault), VTI_E_COUNT);
    nothing_of_bodies(&fault, -1);
    assert_int_equal(vti_bonds_rest(0, NULL, 0, NULL, NULL, NULL), VTI_OK);
    assert_int_equal(vti_bonds_rest(2, below, 0, &b.x, r, &fault), VTI_E_BOND);
    nothing_of_bodies(&fault, 1);
    assert_true(fault.value == -1.0);
    assert_same_bits(&r[0], &before, 1); /* the first bond was sound, and still nothing is written */
    assert_int_equal(vti_bonds_rest(1, good, 1, &b.x, r, NULL), VTI_E_BOND);
    vti_view shown = b.x;
    shown.count = 1; /* the view knows how many there are */
    assert_int_equal(vti_bonds_rest(1, good, 0, &shown, r, &fault), VTI_E_BOND);
    nothing_of_bodies(&fault, 0);
    assert_true(fault.value == 1.0);
    shown.count = 2;
    assert_int_equal(vti_bonds_rest(1, good, 0, &shown, r, NULL), VTI_OK);
    assert_int_equal(vti_bonds_rest(1, good, 0, &b.x, r, NULL), VTI_OK);
    assert_true(r[0] == -1.0 && r[3] == 1.0);
}

/** With a stiffness of shear its form is one that there is; the fault is the list's, not that of a bond. */
static void forms_of_shear(vti_bonds some)
{
    const double stiffness[] = {0, 3};
    const int64_t wrong[] = {0, 4, 5, -1, INT64_MIN, INT64_MAX, (INT64_C(1) << 32) + 1};
    vti_fault fault = {7, 7, 7};
    for (int i = 0; i < 2; ++i) {
        some.shear = vti_scalars_one(&stiffness[i]);
        for (some.shear_form = VTI_SHEAR_OBJECTIVE; some.shear_form <= VTI_SHEAR_PRINTED; ++some.shear_form)
            assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_OK);
        for (int k = 0; k < 7; ++k) {
            some.shear_form = wrong[k];
            assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_E_BOND);
            nothing_of_bodies(&fault, -1);
            assert_true(fault.value == (double)wrong[k]);
        }
    }
    some.shear.p = NULL; /* a form of what is absent does not matter */
    assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_OK);
}

TEST(bonds)
{
    vti_bonds some = {0};
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_bonds_check(NULL, 2, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_check(NULL, 2, &fault), VTI_E_NULL);
    nothing_of_bodies(&fault, -1);
    assert_int_equal(vti_bonds_check(&some, -1, NULL), VTI_E_COUNT);
    some.count = 1;
    assert_int_equal(vti_bonds_check(&some, 2, NULL), VTI_E_NULL);
    some.count = -1;
    assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_E_COUNT);
    nothing_of_bodies(&fault, -1);
    const int64_t wrong[][3] = {{-1, 1, -1}, {2, 1, 2}, {0, -1, -1}, {0, 2, 2}, {1, 1, 1}}; /* the last is named */
    const double rest[4] = {1, 0, 0, 1}, endless[4] = {1, 0, 0, INFINITY};
    some.count = 1;
    some.rest = rest;
    for (int k = 0; k < 5; ++k) {
        some.pair = wrong[k];
        assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_E_BOND);
        nothing_of_bodies(&fault, 0);
        assert_true(fault.value == (double)wrong[k][2]);
    }
    const int64_t good[2] = {0, 1};
    some.pair = good;
    assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_OK);
    forms_of_shear(some);
    const int64_t twice[4] = {0, 1, 0, 1};
    const double both[8] = {1, 0, 0, 1, 1, 0, 0, 1}, stiffness[2] = {1, 1};
    vti_bonds two = {.count = 2, .pair = twice, .rest = both, .shear_form = VTI_SHEAR_OBJECTIVE};
    vti_scalars *const terms[] = {&two.moment, &two.axial, &two.shear};
    for (int k = 0; k < 3; ++k) { /* fewer stiffnesses than bonds */
        *terms[k] = (vti_scalars){stiffness, 1, 1};
        assert_int_equal(vti_bonds_check(&two, 2, &fault), VTI_E_BOND);
        nothing_of_bodies(&fault, 1);
        assert_true(fault.value == 1);
        terms[k]->count = 2;
        assert_int_equal(vti_bonds_check(&two, 2, &fault), VTI_OK);
    }
    some.rest = endless;
    assert_int_equal(vti_bonds_check(&some, 2, &fault), VTI_E_BOND);
    nothing_of_bodies(&fault, 0);
    assert_true(isinf(fault.value));
}

/** A modulus or a length that is none, or that ends before the list does; a stiffness beside a modulus. */
static void law_of_a_pair(vti_contacts some, double none)
{
    const double few[2] = {3, none};
    const int64_t twice[4] = {1, 2, 2, 1};
    vti_fault fault = {7, 7, 7};
    some.stiffness = 0;
    some.modulus = vti_scalars_array(few);
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
    nothing_of_bodies(&fault, 0);
    assert_same_bits(&fault.value, &none, 1);
    some.modulus.count = 1; /* of bodies 1 and 2 */
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == 0 && fault.value == 2);
    some.modulus = vti_scalars_one(few);
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_OK);
    some.stiffness = 5;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1 && fault.value == 5);
    some.modulus.p = NULL;
    some.length = vti_scalars_array(few + 1);
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
    assert_int_equal(fault.body, 0);
    assert_same_bits(&fault.value, &none, 1);
    some.pair = twice;
    some.count = 2;
    some.length = vti_scalars_array(few);
    some.length.count = 1;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == 1 && fault.value == 1);
}

TEST(contacts)
{
    const double diameter[2] = {1, 2};
    const int64_t good[2] = {1, 2}, two[4] = {1, 2, 2, 1},
                  wrong[][3] = {{0, 2, 0}, {3, 2, 3}, {1, 0, 0}, {1, 3, 3}, {2, 2, 2}};
    const vti_contacts right = {
        .count = 1, .pair = good, .base = 1, .diameter = vti_scalars_array(diameter), .stiffness = 5};
    vti_contacts some = right;
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_contacts_check(NULL, 2, &fault), VTI_E_NULL);
    nothing_of_bodies(&fault, -1);
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_OK);
    assert_int_equal(vti_contacts_check(&some, -1, &fault), VTI_E_COUNT);
    nothing_of_bodies(&fault, -1);
    some.pair = NULL;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_NULL);
    some.count = 0;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_OK);
    some.count = -1;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_COUNT);
    some.diameter.p = NULL;
    assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_NULL);
    some = right;
    for (int k = 0; k < 5; ++k) {
        some.pair = wrong[k];
        assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
        nothing_of_bodies(&fault, 0);
        assert_true(fault.value == (double)wrong[k][2]);
        assert_int_equal(vti_contacts_check(&some, 2, NULL), VTI_E_CONTACT);
    }
    assert_true(vti_contacts_stiffness(&right, 0) == 5 && isnan(vti_contacts_stiffness(NULL, 0)));
    assert_true(isnan(vti_contacts_stiffness(&right, 1)) && isnan(vti_contacts_stiffness(&right, -1)));
    some = right;
    some.diameter.p = NULL;
    assert_true(isnan(vti_contacts_stiffness(&some, 0)));
    some = right;
    some.diameter = (vti_scalars){some.diameter.p, 1, 1}; /* fewer than the pair names */
    assert_true(isnan(vti_contacts_stiffness(&some, 0)));
    some.pair = two + 2; /* which names the larger one first */
    assert_true(isnan(vti_contacts_stiffness(&some, 0)));
    some = right;
    for (int k = 0; k < 2; ++k) { /* bodies below the base, whose diameters no view can hold */
        some.pair = wrong[2 * k];
        assert_true(isnan(vti_contacts_stiffness(&some, 0)));
    }
    some = right;
    some.modulus = (vti_scalars){diameter, 1, 1};
    assert_true(isnan(vti_contacts_stiffness(&some, 0)));
    some.modulus.count = 2;
    assert_true(vti_contacts_stiffness(&some, 0) > 0);
    some.length = (vti_scalars){diameter, 1, 1};
    some.pair = two;
    some.count = 2;
    assert_true(vti_contacts_stiffness(&some, 0) > 0 && isnan(vti_contacts_stiffness(&some, 1)));
    const double none[] = {-1, NAN, INFINITY, 0};
    for (int k = 0; k < 4; ++k) {
        const double sizes[2] = {1, none[k]};
        some = right;
        some.diameter = vti_scalars_array(sizes);
        assert_int_equal(vti_contacts_check(&some, 2, &fault), VTI_E_CONTACT);
        nothing_of_bodies(&fault, 0);
        assert_same_bits(&fault.value, &none[k], 1);
        some = right;
        some.stiffness = none[k];
        assert_int_equal(vti_contacts_check(&some, 2, &fault), none[k] == 0 ? VTI_OK : VTI_E_CONTACT);
        if (none[k] != 0)
            nothing_of_bodies(&fault, -1);
        law_of_a_pair(right, none[k]);
    }
}

/** An effect of nothing is refused, and then forces are as they were. */
TEST(effects)
{
    double force[6] = {3, 3, 3, 3, 3, 3};
    const double before[6] = {3, 3, 3, 3, 3, 3};
    const int64_t pair[2] = {0, 1};
    const vti_bonds half = {.count = 1}, restless = {.count = 1, .pair = pair};
    const vti_contacts sizeless = {.count = 1};
    const vti_walls nowhere = {.count = 1};
    const vti_effect none[] = {vti_pendulum_effect(NULL),  vti_gravity_effect(NULL),       vti_bonds_effect(NULL),
                               vti_contacts_effect(NULL),  vti_walls_effect(NULL),         vti_bonds_effect(&half),
                               vti_walls_effect(&nowhere), vti_contacts_effect(&sizeless), vti_bonds_effect(&restless)};
    b.force = vti_view_packed(force);
    for (size_t k = 0; k < sizeof none / sizeof none[0]; ++k) {
        assert_int_equal(vti_apply(&none[k], 1, &b), VTI_E_NULL);
        assert_same_bits(force, before, 6);
        assert_true(isnan(vti_energy(&none[k], 1, &b)));
    }
    assert_true(isnan(vti_energy(NULL, 1, &b)));
    assert_true(isnan(vti_energy(NULL, -1, &b)));
    assert_true(vti_energy(NULL, 0, &b) == 0.0);
}

TEST(steppers)
{
    vti_stepper own = *vti_stepper_find("vti2");
    own.kick = NULL;
    assert_int_equal(vti_step_begin(&own, 0.1, &b, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_step_check(&own, NULL, 0), VTI_E_STEPPER);
    own = *vti_stepper_find("vti2");
    own.drift = NULL;
    assert_int_equal(vti_step_finish(&own, 0.1, &b), VTI_E_STEPPER);
    assert_int_equal(vti_step_check(&own, NULL, 0), VTI_E_STEPPER);
    own = *vti_stepper_find("vti2");
    own.stages = -1;
    assert_int_equal(vti_step_finish(&own, 0.1, &b), VTI_E_STAGE);
    assert_int_equal(vti_step_start(&own, 0.1, &b), VTI_E_STAGE);
    assert_int_equal(vti_step_check(&own, NULL, 0), VTI_E_STAGE);
    assert_null(vti_stepper_find(NULL));
    assert_null(vti_stepper_at(-1));
}

TEST(measures)
{
    const double about[3] = {0, 0, 0};
    double r[3] = {0, 0, 0};
    measures_are_nan(NULL, &b);
    vti_momentum(&b, NULL);
    vti_spin(&b, NULL);
    vti_angular_momentum(&b, about, NULL);
    vti_angular_momentum(&b, NULL, r);
    assert_true(isnan(r[1]));
    const vti_bodies fewer = vti_bodies_slice(b, 0, 1), less = vti_bodies_none(2);
    assert_true(isnan(vti_h1_distance(&b, &fewer)) && isnan(vti_h1_distance(&b, &less)));
    assert_true(vti_h1_distance(&b, &b) == 0.0);
}

TEST(stable)
{
    const int64_t far[2] = {0, 2}, below[2] = {0, -1}, good[2] = {0, 1};
    const double rest[4] = {1, 0, 0, 1}, one = 1;
    double scratch[2];
    vti_stable found = {7, 7, 7, 7, 7};
    /* what the effects are of is spoilt behind their backs */
    vti_bonds bonds = {.count = 1, .pair = far, .rest = rest, .axial = vti_scalars_one(&one)};
    vti_contacts contacts = {.count = 1, .pair = far, .diameter = vti_scalars_one(&one), .stiffness = 1};
    const vti_effect binder = vti_bonds_effect(&bonds), contact = vti_contacts_effect(&contacts);
    const vti_effect gravity = {.name = "own", .apply = binder.apply};
    const vti_deformation at = {0.1, 0.1, 0}, any = {0.1, 0.1, 1}, *const where[] = {NULL, &at};
    vti_bodies stale = b, all = b;
    double centre[6] = {0, 0, 0, 1, 0, 0};
    stale.abi = VTI_ABI + 1;
    all.x = vti_view_packed(centre);
    for (int k = 0; k < 2; ++k) {
        bonds.count = contacts.count = 1;
        bonds.pair = contacts.pair = far;
        bonds.rest = rest;
        assert_int_equal(vti_stable_step(NULL, 1, &all, where[k], scratch, &found), VTI_E_NULL);
        assert_int_equal(vti_stable_step(NULL, -1, &all, where[k], scratch, &found), VTI_E_COUNT);
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], NULL, &found), VTI_E_NULL);
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], scratch, NULL), VTI_E_NULL);
        assert_int_equal(vti_stable_step(&binder, 1, &stale, where[k], scratch, &found), VTI_E_ABI);
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], scratch, &found), VTI_E_BOND);
        assert_int_equal(vti_stable_step(&contact, 1, &all, where[k], scratch, &found), VTI_E_BOND);
        bonds.pair = contacts.pair = below;
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], scratch, &found), VTI_E_BOND);
        assert_int_equal(vti_stable_step(&contact, 1, &all, where[k], scratch, &found), VTI_E_BOND);
        contacts.length = vti_scalars_one(&one);
        assert_int_equal(vti_stable_step(&contact, 1, &all, &any, scratch, &found), VTI_E_BOND);
        contacts.length.p = NULL;
        bonds.pair = contacts.pair = good;
        bonds.rest = NULL;
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], scratch, &found), VTI_E_NULL);
        contacts.diameter.p = NULL;
        assert_int_equal(vti_stable_step(&contact, 1, &all, where[k], scratch, &found), VTI_E_NULL);
        contacts.diameter.p = &one;
        bonds.count = contacts.count = -1;
        assert_int_equal(vti_stable_step(&binder, 1, &all, where[k], scratch, &found), VTI_E_COUNT);
        assert_int_equal(vti_stable_step(&contact, 1, &all, where[k], scratch, &found), VTI_E_COUNT);
        assert_true(found.h == 7 && found.effect == 7 && found.i == 7); /* nothing is written */
    }
    bonds.count = 1;
    bonds.rest = rest;
    /* an effect that says nothing of its springs leaves no bound, and is named */
    const vti_effect both[] = {binder, gravity};
    assert_int_equal(vti_stable_step(both, 2, &all, &at, scratch, &found), VTI_E_SPRINGS);
    assert_true(isnan(found.h));
    assert_int_equal(found.effect, 1);
    assert_int_equal(found.i, -1);
}

/** Lists of nothing, springs of no stiffness, and springs at bodies that stay where they are: nothing oscillates. */
TEST(nothing_oscillates)
{
    const int64_t pair[2] = {0, 1};
    const double rest[4] = {1, 0, 0, 1}, zero = 0, one = 1, plane[4] = {0, 0, 1, 0};
    const vti_bonds no_bonds = {0}, slack = {.count = 1, .pair = pair, .rest = rest, .axial = vti_scalars_one(&zero)};
    const vti_contacts no_contacts = {.diameter = vti_scalars_one(&one)},
                       touching = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&one), .stiffness = 3};
    const vti_walls no_walls = {0},
                    under = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&one), .stiffness = 3};
    const vti_gravity weight = {{0, 0, -1}};
    const vti_effect lists[] = {vti_bonds_effect(&no_bonds), vti_contacts_effect(&no_contacts),
                                vti_walls_effect(&no_walls), vti_gravity_effect(&weight)};
    const vti_effect slack_bond = vti_bonds_effect(&slack);
    const vti_effect contact[] = {vti_contacts_effect(&touching), vti_walls_effect(&under)};
    const vti_deformation at = {0.1, 0, 0}, rigid = {0, 0, 1};
    double scratch[2], centre[6] = {0, 0, 0.1, 0.9, 0, 0.1};
    vti_stable found = {7, 7, 7, 7, 7};
    vti_bodies all = b;
    all.x = vti_view_packed(centre);
    const struct {
        const vti_effect *effects;
        int64_t n;
        const vti_deformation *at;
        int with_mass;
    } still[] = {{lists, 4, &at, 1}, {lists, 4, NULL, 1},  {&slack_bond, 1, &at, 1}, {&slack_bond, 1, NULL, 1},
                 {NULL, 0, &at, 1},  {contact, 2, &at, 0}, {contact, 2, NULL, 0},    {contact, 2, &rigid, 1}};
    for (size_t k = 0; k < sizeof still / sizeof still[0]; ++k) {
        vti_bodies some = all;
        if (!still[k].with_mass) {
            assert_int_equal(vti_stable_step(still[k].effects, still[k].n, &some, still[k].at, scratch, &found),
                             VTI_OK);
            assert_true(isfinite(found.h) && found.h > 0);
            some.mass.p = NULL;
            assert_int_equal(vti_stable_step(still[k].effects, still[k].n, &some, still[k].at, scratch, &found),
                             VTI_E_MASS);
            some.v = vti_view_none();
        }
        found.h = 7;
        assert_int_equal(vti_stable_step(still[k].effects, still[k].n, &some, still[k].at, scratch, &found), VTI_OK);
        assert_true(isinf(found.h) && found.h > 0);
        assert_true(found.effect == -1 && found.element == -1 && found.i == -1 && found.j == -1);
    }
}

/** Scalars that are members of structs: a size that is no whole number of doubles is no mass. */
TEST(members)
{
    double force[6] = {0};
    const struct {
        double m, other;
    } two[2] = {{2, 7}, {3, 7}};
    b.force = vti_view_packed(force);
    b.mass = vti_scalars_member(&two[0].m, sizeof two[0]);
    assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
    v[0] = v[3] = 1;
    assert_true(vti_kinetic_translation(&b) == 2.5);
    const int64_t wrong[] = {0, 12};
    for (int k = 0; k < 2; ++k) {
        b.mass = vti_scalars_member(&two[0].m, wrong[k]);
        assert_int_equal(vti_bodies_check(&b), VTI_E_MASS);
    }
}

/** What is refused before a body is looked at is about none: no call leaves in a fault what an earlier one has put
 *  there. */
TEST(no_older_fault)
{
    const vti_stepper *const s = vti_stepper_find("vti2");
    const int64_t pair[2] = {0, 1};
    double one[4];
    vti_solid solid;
    for (int k = 0;; ++k) {
        vti_fault f = {7, 7, 7};
        const int status = k == 0    ? vti_bodies_check_values(NULL, &f)
                           : k == 1  ? vti_bonds_rest_now(-1, pair, 0, &b, one, one, &f)
                           : k == 2  ? vti_bonds_rest_now(1, pair, 0, NULL, one, one, &f)
                           : k == 3  ? vti_contacts_check(NULL, 2, &f)
                           : k == 4  ? vti_walls_check(NULL, 2, &f)
                           : k == 5  ? vti_rupture_check(NULL, &f)
                           : k == 6  ? vti_clumps_check(NULL, 2, &f)
                           : k == 7  ? vti_clump_solid(0, one, one, 1, 8, &solid, &f)
                           : k == 8  ? vti_effects_check(NULL, 1, &b, &f)
                           : k == 9  ? vti_effects_begin(NULL, 1, NULL, 0, &b, &f)
                           : k == 10 ? vti_effects_stage(s, 1, 1, NULL, 0, &b, &f)
                           : k == 11 ? vti_multistep_predict(NULL, 1, NULL, &b, &f)
                           : k == 12 ? vti_drift(-1, VTI_FRAME_SPACE, 1, &b, &f)
                           : k == 13 ? vti_step_begin(NULL, 1, &b, &f)
                           : k == 14 ? vti_step_stage(s, 1, 1, &b, &f)
                           : k == 15 ? vti_step_next(NULL, 1, &b, &f)
                                     : 1;
        if (status == 1)
            break;
        assert_int_not_equal(status, VTI_OK);
        nothing_of_bodies(&f, -1);
        assert_true(f.value == 0);
    }
}

RUN_TESTS(cmocka_unit_test_setup(rest, setup), cmocka_unit_test_setup(bonds, setup),
          cmocka_unit_test_setup(contacts, setup), cmocka_unit_test_setup(effects, setup),
          cmocka_unit_test_setup(steppers, setup), cmocka_unit_test_setup(measures, setup),
          cmocka_unit_test_setup(stable, setup), cmocka_unit_test_setup(members, setup),
          cmocka_unit_test_setup(nothing_oscillates, setup), cmocka_unit_test_setup(no_older_fault, setup))
