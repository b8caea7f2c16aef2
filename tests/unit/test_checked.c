/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The library of -Dchecked=true: what goes wrong after a seal, or in a list after its check, is refused by the next
 * call, and nothing is written. Linked with the other library each of these would be a crash, or NaN somewhere
 * later. */
#include "bodies.h"
#include "support.h"

enum { N = 4, DOUBLES = 3 * N };

static const double h = 0.125;
static double x[DOUBLES], v[DOUBLES], f[DOUBLES], a[DOUBLES], w[DOUBLES], m[DOUBLES], mass[N], inertia[N], rest[4];
static int64_t pair[2];
static vti_bodies b;
static vti_bonds bonds;
static vti_contacts contacts;
static vti_walls walls;

/** Sealed bodies and checked lists. */
static int sound(void **state)
{
    (void)state;
    static const double one = 1.0, plane[4] = {0, 0, 1, -5};
    for (int i = 0; i < DOUBLES; ++i) {
        x[i] = i;
        v[i] = f[i] = a[i] = w[i] = m[i] = 0.01 * i;
    }
    for (int i = 0; i < N; ++i)
        mass[i] = inertia[i] = 1;
    b = bodies_packed(N, x, v, f, a, NULL, w, m, mass, inertia);
    pair[0] = 0;
    pair[1] = 1;
    assert_int_equal(vti_bonds_rest(1, pair, 0, &b.x, rest, NULL), VTI_OK);
    const vti_scalars k = vti_scalars_one(&one);
    bonds = (vti_bonds){1, pair, 0, rest, k, k, k, VTI_SHEAR_OBJECTIVE, NULL};
    contacts = (vti_contacts){.count = 1, .pair = pair, .diameter = k, .stiffness = 5};
    walls = (vti_walls){.count = 1, .plane = plane, .diameter = k, .stiffness = 5};
    assert_int_equal(vti_bodies_seal(&b), VTI_OK);
    return 0;
}

/** Every call refuses, says what, and writes nothing. */
static void refused(int status, int64_t body, int64_t quantity)
{
    const vti_stepper *vti2 = vti_stepper_find("vti2");
    double *const all[6] = {x, v, f, a, w, m};
    double before[6][DOUBLES];
    for (int k = 0; k < 6; ++k)
        memcpy(before[k], all[k], sizeof x);
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_step_begin(vti2, h, &b, &fault), status);
    assert_true(fault.body == body && fault.quantity == quantity);
    assert_int_equal(vti_step_finish(vti2, h, &b), status);
    assert_int_equal(vti_step_start(vti2, h, &b), status);
    assert_int_equal(vti_step_sync(vti2, h, &b), status);
    assert_int_equal(vti_kick(h, &b), status);
    assert_int_equal(vti_drift(VTI_LAW_EXACT, VTI_FRAME_SPACE, h, &b, NULL), status);
    assert_int_equal(vti_apply(NULL, 0, &b), status);
    assert_true(isnan(vti_kinetic_translation(&b)));
    for (int k = 0; k < 6; ++k)
        assert_same_bits(before[k], all[k], DOUBLES);
}

TEST(views_after_the_seal)
{
    b.x.c[1] = NULL;
    refused(VTI_E_VIEW, -1, VTI_QUANTITY_X);
    b.x.c[1] = x + 1;
    b.omega.stride = 1;
    refused(VTI_E_STRIDE, -1, VTI_QUANTITY_OMEGA);
    b.omega.stride = 3;
    b.mass.p = NULL;
    refused(VTI_E_MASS, -1, VTI_QUANTITY_MASS);
}

TEST(numbers_after_the_seal)
{
    v[3 * 2 + 1] = NAN;
    refused(VTI_E_STATE, 2, VTI_QUANTITY_V);
    v[3 * 2 + 1] = 0;
    a[3 * 3] = INFINITY;
    refused(VTI_E_STATE, 3, VTI_QUANTITY_ALPHA);
    a[3 * 3] = 0;
    mass[1] = -1;
    refused(VTI_E_MASS, 1, VTI_QUANTITY_MASS);
}

/** Effects that share the list of another one look at it, too. */
TEST(lists_that_are_shared)
{
    static vti_sum lost[VTI_DASHPOT_BOOKS];
    static vti_held entries[2];
    static int64_t slots[2];
    vti_history history = {2, 0, 0, entries, slots};
    const vti_dashpots dashpots = {.contacts = &contacts, .normal = 1, .reach = 1, .lost = lost};
    const vti_friction friction = {
        .contacts = &contacts, .sliding = 1, .stiffness = 1, .reach = 1, .history = &history, .lost = lost};
    const vti_bond_dashpots of_bonds = {.bonds = &bonds, .axial = 1, .lost = lost};
    const vti_effect all[] = {vti_dashpots_effect(&dashpots), vti_friction_effect(&friction),
                              vti_bond_dashpots_effect(&of_bonds)};
    for (int k = 0; k < 3; ++k) {
        assert_int_equal(vti_effects_check(&all[k], 1, &b, NULL), VTI_OK);
        pair[0] = -3;
        assert_int_equal(vti_effects_check(&all[k], 1, &b, NULL), k < 2 ? VTI_E_CONTACT : VTI_E_BOND);
        pair[0] = 0;
    }
}

static void list_refused(const vti_effect *effect, int status)
{
    double before[2][DOUBLES];
    memcpy(before[0], f, sizeof f);
    memcpy(before[1], m, sizeof m);
    assert_int_equal(vti_apply(effect, 1, &b), status);
    assert_true(isnan(vti_energy(effect, 1, &b)));
    assert_same_bits(before[0], f, DOUBLES);
    assert_same_bits(before[1], m, DOUBLES);
}

TEST(lists_after_their_check)
{
    const vti_effect bond = vti_bonds_effect(&bonds), contact = vti_contacts_effect(&contacts);
    assert_int_equal(vti_apply(&bond, 1, &b), VTI_OK);
    assert_int_equal(vti_apply(&contact, 1, &b), VTI_OK);
    const int64_t wrong[] = {100000000, -1, 0, N};
    for (int k = 0; k < 4; ++k) {
        pair[1] = wrong[k];
        list_refused(&bond, VTI_E_BOND);
        list_refused(&contact, VTI_E_CONTACT);
    }
    pair[1] = 1;
    rest[3] = NAN;
    list_refused(&bond, VTI_E_BOND);
    contacts.stiffness = -1;
    list_refused(&contact, VTI_E_CONTACT);
    const vti_effect wall = vti_walls_effect(&walls);
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    const double skew[4] = {0, 0, 2, -5};
    walls.plane = skew;
    list_refused(&wall, VTI_E_CONTACT);
}

/** Every number of planes that is wrong, one after the other. */
TEST(planes_after_their_check)
{
    static const double good[4] = {0, 0, 1, -5};
    static const double bad[][4] = {{0, 0, 2, -5}, {NAN, 0, 1, -5}, {0, 0, 1, INFINITY}, {0, 0, 1, NAN}};
    static const double not_positive[] = {0, -1, INFINITY, NAN}, negative[] = {-1, INFINITY, NAN};
    const vti_walls all = walls;
    const vti_effect wall = vti_walls_effect(&walls);
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    for (int k = 0; k < 4; ++k) {
        walls = all;
        walls.plane = bad[k];
        list_refused(&wall, VTI_E_CONTACT);
        walls.plane = good;
        walls.diameter = vti_scalars_one(&not_positive[k]);
        list_refused(&wall, VTI_E_CONTACT);
        walls.diameter = all.diameter;
        walls.stiffness = negative[k % 3];
        list_refused(&wall, VTI_E_CONTACT);
    }
    walls = all;
    static double moduli[1] = {2};
    static const double soft = 3, none[] = {0, NAN, INFINITY};
    walls.modulus = vti_scalars_one(&soft); /* and a stiffness */
    list_refused(&wall, VTI_E_CONTACT);
    walls.stiffness = 0;
    walls.moduli = moduli;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    walls.each = moduli;
    list_refused(&wall, VTI_E_CONTACT);
    walls.each = NULL;
    for (int k = 0; k < 3; ++k) {
        moduli[0] = none[k];
        list_refused(&wall, VTI_E_CONTACT);
        moduli[0] = 2;
        walls.modulus = vti_scalars_one(&none[k]);
        list_refused(&wall, VTI_E_CONTACT);
        walls.modulus = vti_scalars_one(&soft);
    }
    walls = all;
    walls.plane = NULL;
    list_refused(&wall, VTI_E_NULL);
    walls.plane = good;
    walls.diameter.p = NULL;
    list_refused(&wall, VTI_E_NULL);
    walls.count = 0; /* none needs nothing */
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
}

/** Cylinders and motions that are wrong, one number after the other. */
TEST(cylinders_and_motion_after_their_check)
{
    static double cylinder[7] = {0, 0, 1, 0, 0, 0, 50};
    static vti_wall_motion motion[2];
    static vti_sum work;
    const vti_effect wall = vti_walls_effect(&walls);
    double *const numbers[] = {cylinder,        cylinder + 4,     cylinder + 6,       motion[1].velocity + 1,
                               &motion[1].spin, motion[1].centre, motion[1].moved + 2};
    walls.cylinders = 1;
    walls.cylinder = cylinder;
    walls.motion = motion;
    walls.work = &work;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k) {
        const double good = *numbers[k];
        *numbers[k] = NAN;
        list_refused(&wall, VTI_E_CONTACT);
        *numbers[k] = good;
    }
    cylinder[6] = 0;
    list_refused(&wall, VTI_E_CONTACT);
    cylinder[6] = 50;
    walls.work = NULL;
    list_refused(&wall, VTI_E_NULL);
    walls.motion = NULL;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    walls.cylinder = NULL;
    list_refused(&wall, VTI_E_NULL);
    walls.cylinders = 0;
    walls.cylinder = NULL;
}

/** The two passes of threads, and what bonds hold. */
TEST(passes_after_the_check)
{
    double loads[VTI_BOND_LOADS], measures[VTI_BOND_MEASURES];
    assert_int_equal(vti_bonds_loads(&bonds, &b, 0, 1, loads), VTI_OK);
    assert_int_equal(vti_bonds_measure(&bonds, &b, 0, 1, measures), VTI_OK);
    pair[1] = N;
    assert_int_equal(vti_bonds_loads(&bonds, &b, 0, 1, loads), VTI_E_BOND);
    assert_int_equal(vti_bonds_measure(&bonds, &b, 0, 1, measures), VTI_E_BOND);
}

/** The shortest view of what is read says which bodies there are; what is not read does not. */
TEST(views_of_several_lengths)
{
    static vti_sum lost[VTI_DASHPOT_BOOKS];
    const vti_dashpots dashpots = {.contacts = &contacts, .normal = 1, .reach = 1, .lost = lost};
    const vti_bond_dashpots of_bonds = {.bonds = &bonds, .axial = 1, .lost = lost};
    const vti_effect bond = vti_bonds_effect(&bonds), contact = vti_contacts_effect(&contacts),
                     damper = vti_dashpots_effect(&dashpots), bond_damper = vti_bond_dashpots_effect(&of_bonds);
    pair[1] = N - 1;
    b = vti_bodies_slice(b, 0, 1);
    b.x.count = N;
    assert_int_equal(vti_apply(&bond, 1, &b), VTI_OK);
    b.alpha.count = 2;
    list_refused(&bond, VTI_E_BOND);
    assert_int_equal(vti_apply(&contact, 1, &b), VTI_OK);
    assert_int_equal(vti_effects_check(&damper, 1, &b, NULL), VTI_OK);
    b.alpha.count = 0;
    b.v.count = 2;
    assert_int_equal(vti_apply(&bond, 1, &b), VTI_OK);
    assert_int_equal(vti_effects_check(&damper, 1, &b, NULL), VTI_E_CONTACT);
    assert_int_equal(vti_effects_check(&bond_damper, 1, &b, NULL), VTI_E_BOND);
    b.x.count = 0; /* then what else is known */
    b.alpha.count = N;
    assert_int_equal(vti_apply(&contact, 1, &b), VTI_OK);
}

/** Arrays may be longer than there are bodies: a wall acts on those of the slice, and what lies behind them is nobody's
 *  diameter. */
TEST(room_for_more)
{
    static const double diameter[N] = {0, 1, 0, NAN};
    const vti_effect wall = vti_walls_effect(&walls);
    walls.diameter = vti_scalars_array(diameter);
    b = vti_bodies_slice(b, 1, 1);
    b.x.count = N;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    b = vti_bodies_slice(b, 1, 2);
    list_refused(&wall, VTI_E_CONTACT);
}

/** Bodies that are held lie outside the slice that is stepped: the views say that they exist. */
TEST(held_bodies)
{
    const vti_effect bond = vti_bonds_effect(&bonds);
    b = vti_bodies_slice(b, 0, 1);
    list_refused(&bond, VTI_E_BOND);
    b.x.count = N;
    assert_int_equal(vti_apply(&bond, 1, &b), VTI_OK);
}

RUN_TESTS(cmocka_unit_test_setup(views_after_the_seal, sound), cmocka_unit_test_setup(numbers_after_the_seal, sound),
          cmocka_unit_test_setup(lists_after_their_check, sound), cmocka_unit_test_setup(lists_that_are_shared, sound),
          cmocka_unit_test_setup(planes_after_their_check, sound),
          cmocka_unit_test_setup(cylinders_and_motion_after_their_check, sound),
          cmocka_unit_test_setup(passes_after_the_check, sound),
          cmocka_unit_test_setup(views_of_several_lengths, sound), cmocka_unit_test_setup(room_for_more, sound),
          cmocka_unit_test_setup(held_bodies, sound))
