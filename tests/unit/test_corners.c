/* SPDX-License-Identifier: BSD-3-Clause
 * What seldom happens to the stable step, to lists that know where their values end, and to moves: each is refused, or
 * done as body by body. */
#include "support.h"

static double x[20][3], v[20][3], force[20][3], v_low[20][3], alpha[20][3], omega[20][3], moment[20][3];
static double unit[20][3];
static const double one = 1.0;

static vti_bodies bodies(int64_t n)
{
    vti_bodies b = vti_bodies_none(n);
    rng g = rng_seed(11);
    for (int64_t i = 0; i < n; ++i) {
        double *const all[] = {x[i], v[i], force[i], alpha[i], omega[i], moment[i]};
        for (int k = 0; k < 6; ++k)
            random_vector(&g, 1, all[k]);
    }
    memset(v_low, 0, sizeof v_low);
    for (int k = 0; k < 60; ++k)
        unit[k / 3][k % 3] = 1;
    b.x = vti_view_packed(x[0]);
    b.v = vti_view_packed(v[0]);
    b.force = vti_view_packed(force[0]);
    b.alpha = vti_view_packed(alpha[0]);
    b.omega = vti_view_packed(omega[0]);
    b.moment = vti_view_packed(moment[0]);
    b.mass = b.inertia = vti_scalars_one(&one);
    return b;
}

/* ---- springs that a host reports --------------------------------------------------------------------------------- */

/** Springs, and another one from the second time on that they are asked for, where there is one. */
struct host {
    const vti_spring *spring;
    int64_t count;
    const vti_spring *later;
};
static int asked;

static void pushes(const void *self, const vti_bodies *b)
{
    (void)self, (void)b;
}

static int reports(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const struct host *const host = self;
    (void)b, (void)at;
    for (int64_t k = 0; k < host->count; ++k)
        visit(context, &host->spring[k]);
    if (host->later != NULL && asked++ > 0)
        visit(context, host->later);
    return VTI_OK;
}

static int stable(const vti_bodies *b, const vti_spring *spring, int64_t count, const vti_spring *later,
                  vti_stable *found)
{
    double scratch[20];
    const struct host host = {spring, count, later};
    const vti_effect effects[2] = {{.name = "host", .apply = pushes, .springs = reports, .self = &host},
                                   {.name = "none", .apply = pushes, .springs = vti_springs_none}};
    asked = 0;
    return vti_stable_step(effects, 2, b, NULL, scratch, found);
}

static vti_spring between(int64_t i, int64_t j, double axial)
{
    const vti_spring s = {.i = i, .j = j, .length = 1.0, .axial = axial};
    return s;
}

TEST(springs_of_bodies_that_are_not_there)
{
    const int64_t pair[][2] = {{0, 2}, {5, 2}, {1, -2}, {1, 5}, {1, 0}};
    const vti_bodies b = vti_bodies_slice(bodies(6), 1, 4);
    vti_stable found;
    for (size_t k = 0; k < sizeof pair / sizeof pair[0]; ++k) {
        const vti_spring good = between(1, 2, 1.0), bad = between(pair[k][0], pair[k][1], 1.0);
        assert_int_equal(stable(&b, &bad, 1, NULL, &found), VTI_E_BOND);
        assert_int_equal(stable(&b, &good, 1, &bad, &found), VTI_E_BOND); /* the host changes its mind */
        assert_int_equal(stable(&b, &good, 1, NULL, &found), VTI_OK);
        assert_close(found.h, sqrt(2.0), 4 * EPS); /* 2/omega, omega^2 = K (1/m + 1/m) */
    }
    const vti_effect nothing = {.name = "nothing"};
    double scratch[6];
    assert_int_equal(vti_stable_step(&nothing, 1, &b, NULL, scratch, &found), VTI_E_NULL);
}

/** What is infinitely stiff, or NaN, is infinitely fast, wherever it stands in the list. */
TEST(springs_without_a_number)
{
    const double stiff[] = {INFINITY, NAN};
    const vti_bodies b = bodies(4);
    for (int k = 0; k < 2; ++k) {
        const vti_spring list[3] = {between(0, 1, 1.0), between(1, 2, stiff[k]), between(2, 3, stiff[1 - k])};
        const vti_spring reversed[3] = {list[2], list[1], list[0]};
        vti_stable found;
        for (int64_t n = 2; n <= 3; ++n) {
            assert_int_equal(stable(&b, list, n, NULL, &found), VTI_OK);
            assert_true(found.h == 0.0);
            assert_int_equal(stable(&b, reversed, n, NULL, &found), VTI_OK);
            assert_true(found.h == 0.0);
        }
    }
}

/** A spring that pulls asks for a mass, one that turns for an inertia; of bodies that stay where they are, or do not
 *  turn, neither. The other end of a spring is held where j is -1. */
TEST(springs_of_bodies_that_weigh_nothing)
{
    const struct {
        vti_spring s;
        int pulls, turns;
    } all[] = {{{.i = 1, .j = 2, .length = 1, .axial = 1}, 1, 0},
               {{.i = 1, .j = 2, .length = 1, .across = 1}, 1, 0},
               {{.i = 1, .j = 2, .length = 1, .shear = 1, .arm_j = 1}, 1, 1},
               {{.i = 1, .j = 2, .length = 1, .shear = 1, .arm_i = 1}, 1, 1},
               {{.i = 1, .j = -1, .length = 1, .shear = 1, .arm_j = 1, .lever_j = 1}, 1, 0},
               {{.i = 1, .j = 2, .length = 1, .axial = 1, .lever_i = 1}, 1, 1},
               {{.i = 1, .j = 2, .length = 1, .axial = 1, .lever_j = 1}, 1, 1},
               {{.i = 1, .j = 2, .length = 1, .lever_j = 1}, 0, 0},
               {{.i = 1, .j = -1, .length = 1, .bend = 1}, 0, 1},
               {{.i = 1, .j = -1, .length = 1, .twist = 1}, 0, 1}};
    vti_stable found;
    for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k) {
        vti_bodies light = bodies(4);
        light.force = light.moment = vti_view_none();
        light.mass.p = NULL;
        assert_int_equal(stable(&light, &all[k].s, 1, NULL, &found), all[k].pulls ? VTI_E_MASS : VTI_OK);
        light.v = vti_view_none();
        assert_int_equal(stable(&light, &all[k].s, 1, NULL, &found), VTI_OK);
        light = bodies(4);
        light.moment = vti_view_none();
        light.inertia.p = NULL;
        assert_int_equal(stable(&light, &all[k].s, 1, NULL, &found), all[k].turns ? VTI_E_INERTIA : VTI_OK);
        light.omega = vti_view_none();
        assert_int_equal(stable(&light, &all[k].s, 1, NULL, &found), VTI_OK);
        light = bodies(4);
        light.inertia.p = NULL;
        light.moments = vti_view_packed(unit[0]);
        assert_int_equal(stable(&light, &all[k].s, 1, NULL, &found), VTI_OK);
    }
}

TEST(strains_and_contacts_of_no_use)
{
    const int64_t pair[2] = {0, 1};
    double rest[4], scratch[2];
    const double diameter = 0.1;
    const vti_bodies b = bodies(2), lone = vti_bodies_slice(b, 0, 1);
    vti_bonds bonds = {.count = 1, .pair = pair, .rest = rest, .shear_form = VTI_SHEAR_OBJECTIVE};
    bonds.axial = bonds.shear = vti_scalars_one(&one);
    assert_int_equal(vti_bonds_rest(1, pair, 0, &b.x, rest, NULL), VTI_OK);
    const vti_effect binder = vti_bonds_effect(&bonds);
    const double strain[] = {1.0, 2.0, -0.1, NAN};
    vti_stable found;
    for (int k = 0; k < 4; ++k) {
        const vti_deformation at = {.strain = strain[k]};
        assert_int_equal(vti_stable_step(&binder, 1, &b, &at, scratch, &found), VTI_OK);
        assert_true(!(found.h > 0.0));
    }
    const vti_contacts contacts = {.diameter = vti_scalars_one(&diameter), .stiffness = 1.0};
    const vti_effect touch = vti_contacts_effect(&contacts);
    const vti_deformation any = {.overlap = 0.1, .meet = 1}, deep = {.overlap = 1.0, .meet = 1};
    assert_int_equal(vti_stable_step(&touch, 1, &lone, &any, scratch, &found), VTI_OK);
    assert_true(isinf(found.h)); /* whom should it meet? */
    assert_int_equal(vti_stable_step(&touch, 1, &b, &deep, scratch, &found), VTI_OK);
    assert_true(found.h > 0.0 && isfinite(found.h));
    vti_walls walls = {.diameter = vti_scalars_one(&diameter), .stiffness = 1.0};
    const vti_effect wall = vti_walls_effect(&walls);
    walls.count = -1;
    assert_int_equal(vti_stable_step(&wall, 1, &b, NULL, scratch, &found), VTI_E_COUNT);
}

/* ---- lists that know where their values end ---------------------------------------------------------------------- */

TEST(lists_longer_than_their_values)
{
    const int64_t pair[4] = {0, 1, 1, 2};
    const double stiffness[2] = {1.0, -1.0};
    double rest[8];
    vti_fault fault;
    const vti_bodies b = bodies(3);
    vti_bonds bonds = {.count = 2, .pair = pair, .rest = rest};
    bonds.axial = vti_scalars_array(stiffness);
    assert_int_equal(vti_bonds_rest(2, pair, 0, &b.x, rest, NULL), VTI_OK);
    assert_int_equal(vti_bonds_check(&bonds, 3, &fault), VTI_E_BOND);
    assert_true(fault.body == 1 && fault.value == -1.0);
    bonds.axial.count = 1;
    assert_int_equal(vti_bonds_check(&bonds, 3, &fault), VTI_E_BOND);
    assert_true(fault.body == 1 && fault.value == 1.0);
    vti_contacts contacts = {.count = 2, .pair = pair, .diameter = vti_scalars_one(&one), .stiffness = 1.0};
    contacts.diameter.count = 2;
    assert_int_equal(vti_contacts_check(&contacts, 3, &fault), VTI_E_CONTACT);
    assert_true(fault.body == 1 && fault.value == 2.0);
    contacts.diameter.count = 3;
    assert_int_equal(vti_contacts_check(&contacts, 3, &fault), VTI_OK);
}

/* ---- moves ------------------------------------------------------------------------------------------------------- */

TEST(a_stepper_of_ones_own)
{
    static const double kick[2] = {0.0, 1.0}, huge[2] = {0.5, 1e308}, drift[2] = {1.0, 0.0};
    vti_stepper late = *vti_stepper_find("vti2");
    late.kick = kick;
    late.drift = drift;
    vti_bodies b = bodies(3);
    assert_int_equal(vti_step_finish(&late, 0.1, &b), VTI_OK);
    assert_int_equal(vti_step_begin(&late, 0.1, &b, NULL), VTI_OK);
    double expected[3][3], turned[3][3];
    memcpy(expected, x, sizeof expected);
    memcpy(turned, alpha, sizeof turned);
    b = bodies(3);
    assert_int_equal(vti_step_next(&late, 0.1, &b, NULL), VTI_OK);
    assert_same_bits(x, expected, 9);
    assert_same_bits(alpha, turned, 9);
    assert_int_equal(vti_step_next(&late, -0.1, &b, NULL), VTI_E_TIME);
    late.kick = huge;
    assert_int_equal(vti_step_finish(&late, 10.0, &b), VTI_E_TIME);
    assert_same_bits(x, expected, 9);
}

/** Many bodies that carry the residuals of velocities alone, or whose quaternions lie in parts, are moved as each by
 *  itself. */
TEST(what_no_kernel_takes)
{
    static double quat[60][3], expected[60][3];
    const vti_stepper *const vti2 = vti_stepper_find("vti2");
    for (int parts = 0; parts < 3; ++parts) {
        double first[20][3];
        for (int lone = 1; lone >= 0; --lone) {
            vti_bodies b = bodies(20);
            for (int i = 0; i < 60; ++i)
                quat[i][0] = quat[i][1] = quat[i][2] = 0.5;
            if (parts == 0)
                b.v_low = vti_view_packed(v_low[0]);
            else {
                double *const q = quat[0];
                const vti_quat_view apart = {{q, q + 1, parts == 1 ? q + 60 : q + 2, q + 120}, 3, 0};
                b.alpha = vti_view_none();
                b.quat = apart;
            }
            for (int64_t i = 0; i < (lone ? 20 : 1); ++i) {
                const vti_bodies slice = lone ? vti_bodies_slice(b, i, 1) : b;
                assert_int_equal(vti_step_begin(vti2, 0.1, &slice, NULL), VTI_OK);
            }
            if (lone) {
                memcpy(first, x, sizeof first);
                memcpy(expected, quat, sizeof expected);
            }
        }
        assert_same_bits(x, first, 60);
        assert_same_bits(quat, expected, 180);
    }
}

/* ---- what is not there ------------------------------------------------------------------------------------------- */

TEST(what_is_not_there)
{
    enum { MANY = 300 };
    static double place[MANY][3], push[MANY][3];
    static const double plane[4] = {0, 0, 1, 0}, stiff = 1;
    static const int64_t pair[2] = {0, 1};
    const double rest[4] = {1, 1, 0, 0}, loads[24] = {0};
    vti_bodies b = bodies(2);
    double arm[3];
    vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&one), .stiffness = 2};
    const vti_effect wall = vti_walls_effect(&walls);
    const vti_pendulum pendulum = {1, {0, 0, -1}};
    const vti_bonds bonds = {.count = 1, .pair = pair, .rest = rest, .axial = vti_scalars_one(&stiff)},
                    negative = {.count = -1, .pair = pair, .rest = rest};
    assert_true(isnan(vti_booked_of_body(&wall, -1, 0)) && isnan(vti_booked_of_body(&wall, 1, -1)) &&
                isnan(vti_booked_of_body(NULL, 1, 0)) && vti_booked_of_body(NULL, 0, 0) == 0);
    const struct {
        const vti_pendulum *of;
        int64_t i;
    } arms[] = {{NULL, 0}, {&pendulum, -1}, {&pendulum, 2}};
    for (int k = 0; k < 3; ++k) {
        vti_pendulum_arm(arms[k].of, &b, arms[k].i, arm);
        assert_true(isnan(arm[0]) && isnan(arm[1]) && isnan(arm[2]));
    }
    vti_pendulum_arm(&pendulum, &b, 0, NULL);
    assert_int_equal(vti_bonds_sum(NULL, loads, 0, 1, &b), VTI_E_NULL);
    assert_int_equal(vti_bonds_sum(&bonds, NULL, 0, 1, &b), VTI_E_NULL);
    assert_int_equal(vti_bonds_sum(&bonds, loads, 0, 1, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_sum(&negative, loads, 0, 0, &b), VTI_E_COUNT);
    assert_int_equal(vti_bonds_sum(&bonds, loads, 0, 2, &b), VTI_E_COUNT);
    assert_int_equal(vti_walls_check(&walls, -1, NULL), VTI_E_COUNT);
    assert_true(isnan(vti_walls_stiffness(&walls, 1, 0)) && isnan(vti_walls_stiffness(NULL, 0, 0)));
    /* more bodies than one pass has */
    b = vti_bodies_none(MANY);
    b.x = vti_view_packed(place[0]);
    b.force = vti_view_packed(push[0]);
    for (int i = 0; i < MANY; ++i)
        place[i][2] = i == MANY - 2 ? 0.25 : 3;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_OK);
    for (int i = 0; i < MANY; ++i)
        assert_close(push[i][2], i == MANY - 2 ? 2 / 0.5 * pow(0.5, 1.5) : 0, 4 * EPS);
    walls.count = walls.cylinders = -1;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_E_COUNT);
    assert_int_equal(vti_walls_check(&walls, 2, NULL), VTI_E_COUNT);
    walls.count = 1;
    assert_int_equal(vti_walls_check(&walls, 2, NULL), VTI_E_COUNT);
    walls.cylinders = 0;
    walls.plane = NULL;
    assert_int_equal(vti_apply(&wall, 1, &b), VTI_E_NULL);
}

RUN_TESTS(cmocka_unit_test(springs_of_bodies_that_are_not_there), cmocka_unit_test(springs_without_a_number),
          cmocka_unit_test(springs_of_bodies_that_weigh_nothing), cmocka_unit_test(strains_and_contacts_of_no_use),
          cmocka_unit_test(lists_longer_than_their_values), cmocka_unit_test(a_stepper_of_ones_own),
          cmocka_unit_test(what_no_kernel_takes), cmocka_unit_test(what_is_not_there))
