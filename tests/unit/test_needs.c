/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What an effect says of itself is so: it is refused where something is absent that it needs, by one place for all
 * effects, and what it gives is what it writes. */
#include "bodies.h"
#include "support.h"

enum { N = 2, DOUBLES = 3 * N };

static double x[DOUBLES], v[DOUBLES], f[DOUBLES], a[DOUBLES], w[DOUBLES], m[DOUBLES], quat[4 * N];
static const double mass[N] = {1, 2}, inertia[N] = {3, 4};
static vti_bodies b;

static int sound(void **state)
{
    (void)state;
    for (int i = 0; i < DOUBLES; ++i) {
        x[i] = 0.1 * (i + 1) * (i + 1);
        a[i] = 0.2 * i;
        v[i] = w[i] = 0.1;
        f[i] = m[i] = 7;
    }
    b = bodies_packed(N, x, v, f, a, NULL, w, m, mass, inertia);
    return 0;
}

static int applied;

static void count(const void *self, const vti_bodies *some)
{
    (void)self;
    (void)some;
    ++applied;
}

/** Every quantity that may be needed, of a host's effect; the first effect is sound, so that the second is named. */
TEST(refused_by_one_place)
{
    static const int needed[] = {VTI_QUANTITY_X,     VTI_QUANTITY_V,    VTI_QUANTITY_ALPHA,
                                 VTI_QUANTITY_OMEGA, VTI_QUANTITY_MASS, VTI_QUANTITY_INERTIA};
    double scratch[N];
    for (int k = 0; k < 6; ++k) {
        const vti_effect own[] = {
            {.name = "magnet", .apply = count, .springs = vti_springs_none},
            {.name = "magnet", .apply = count, .springs = vti_springs_none, .needs = 1 << needed[k]}};
        vti_fault fault = {7, 7, 7};
        vti_stable found;
        applied = 0;
        assert_int_equal(vti_effects_check(own, 2, &b, &fault), VTI_OK);
        assert_true(fault.body == -1 && fault.quantity == VTI_QUANTITY_NONE);
        assert_int_equal(vti_apply(own, 2, &b), VTI_OK);
        assert_int_equal(applied, 2);
        vti_bodies less = b;
        vti_view *const views[] = {&less.x, &less.v, &less.alpha, &less.omega};
        if (k < 4)
            *views[k] = vti_view_none();
        else {
            less.v = less.omega = vti_view_none(); /* nothing is moved that mass or inertia would divide */
            (k == 4 ? &less.mass : &less.inertia)->p = NULL;
        }
        for (int i = 0; i < DOUBLES; ++i)
            f[i] = 7;
        assert_int_equal(vti_effects_check(own, 2, &less, &fault), VTI_E_NEEDS);
        assert_int_equal(fault.body, 1);
        assert_int_equal(fault.quantity, needed[k]);
        assert_int_equal(vti_effects_check(own, 2, &less, NULL), VTI_E_NEEDS);
        assert_int_equal(vti_apply(own, 2, &less), VTI_E_NEEDS);
        assert_int_equal(vti_stable_step(own, 2, &less, NULL, scratch, &found), VTI_E_NEEDS);
        assert_true(isnan(vti_energy(own, 2, &less)));
        assert_true(applied == 2 && f[0] == 7);
        assert_int_equal(vti_effects_check(own, 1, &less, NULL), VTI_OK);
    }
}

/** Loads and rounding errors are looked at like the others, and bits of nothing are refused. */
TEST(what_few_need)
{
    static double low[DOUBLES];
    static const int seldom[] = {VTI_QUANTITY_FORCE,   VTI_QUANTITY_MOMENT,    VTI_QUANTITY_X_LOW,
                                 VTI_QUANTITY_V_LOW,   VTI_QUANTITY_ALPHA_LOW, VTI_QUANTITY_OMEGA_LOW,
                                 VTI_QUANTITY_SPIN_LOW};
    vti_view *const views[] = {&b.force, &b.moment, &b.x_low, &b.v_low, &b.alpha_low, &b.omega_low, &b.spin_low};
    vti_effect own = {.name = "magnet", .apply = count};
    vti_fault fault = {7, 7, 7};
    for (int k = 0; k < 7; ++k) {
        *views[k] = vti_view_packed(low);
        own.needs = 1 << seldom[k] | 1 << VTI_QUANTITY_X;
        assert_int_equal(vti_effects_check(&own, 1, &b, &fault), VTI_OK);
        *views[k] = vti_view_none();
        assert_int_equal(vti_effects_check(&own, 1, &b, &fault), VTI_E_NEEDS);
        assert_true(fault.body == 0 && fault.quantity == seldom[k]);
        assert_int_equal(vti_apply(&own, 1, &b), VTI_E_NEEDS);
    }
    const int64_t nothing[] = {1, INT64_C(1) << (VTI_QUANTITY_SPIN_LOW + 1), INT64_C(1) << 40, INT64_MIN};
    for (int k = 0; k < 4; ++k) {
        own.needs = nothing[k] | 1 << VTI_QUANTITY_X;
        assert_int_equal(vti_effects_check(&own, 1, &b, &fault), VTI_E_NEEDS);
        assert_true(fault.body == 0 && fault.quantity == VTI_QUANTITY_NONE);
    }
}

/** A quaternion serves whoever needs an attitude, and alpha serves whoever says quaternion. */
TEST(attitudes)
{
    for (int needed = VTI_QUANTITY_ALPHA; needed <= VTI_QUANTITY_QUAT; ++needed) {
        const vti_effect own = {.name = "magnet", .apply = count, .needs = 1 << needed};
        vti_bodies other = b;
        vti_fault fault;
        assert_int_equal(vti_effects_check(&own, 1, &other, NULL), VTI_OK);
        other.alpha = vti_view_none();
        assert_int_equal(vti_effects_check(&own, 1, &other, &fault), VTI_E_NEEDS);
        assert_int_equal(fault.quantity, VTI_QUANTITY_ALPHA);
        for (int k = 0; k < 4; ++k)
            other.quat.xyzw[k] = quat + k;
        other.quat.stride = 4;
        assert_int_equal(vti_effects_check(&own, 1, &other, NULL), VTI_OK);
    }
}

TEST(of_nothing)
{
    const vti_effect none[] = {{.name = "good", .apply = count}, {.name = "nothing"}};
    vti_fault fault;
    assert_int_equal(vti_effects_check(none, 2, &b, &fault), VTI_E_NULL);
    assert_true(fault.body == 1 && fault.quantity == VTI_QUANTITY_NONE);
    assert_int_equal(vti_step_check(vti_stepper_find("vti2"), none, 2), VTI_E_NULL);
    assert_int_equal(vti_effects_check(NULL, 1, &b, &fault), VTI_E_NULL);
    assert_int_equal(vti_effects_check(NULL, -1, &b, &fault), VTI_E_COUNT);
    b.x.stride = 0;
    assert_int_equal(vti_effects_check(none, 1, &b, &fault), VTI_E_STRIDE);
    assert_int_equal(fault.quantity, VTI_QUANTITY_X);
}

/** A slice without bodies may have no arrays: nothing is called, and energies are 0. */
TEST(no_bodies)
{
    static const double plane[4] = {0, 0, 1, 0};
    const vti_walls walls = {.count = 1, .plane = plane, .stiffness = 1, .diameter = vti_scalars_one(mass)};
    const vti_gravity gravity = {{0, 0, -1}};
    const vti_effect all[] = {vti_walls_effect(&walls),
                              vti_gravity_effect(&gravity),
                              {.name = "magnet", .apply = count, .needs = 1 << VTI_QUANTITY_OMEGA}};
    const vti_bodies none = vti_bodies_none(0);
    applied = 0;
    assert_int_equal(vti_apply(all, 3, &none), VTI_OK);
    assert_int_equal(applied, 0);
    assert_true(vti_energy(all, 2, &none) == 0.0);
    assert_int_equal(vti_effects_begin(vti_stepper_find("vti2"), 0.1, all, 3, &none, NULL), VTI_OK);
    assert_int_equal(vti_effects_finish(vti_stepper_find("vti2"), 0.1, all, 3, &none), VTI_OK);
    const vti_bonds bonds = {.moment = vti_scalars_one(mass), .axial = vti_scalars_one(mass)};
    assert_int_equal(vti_bonds_rest_now(0, NULL, 0, &none, NULL, NULL, NULL), VTI_OK);
    assert_int_equal(vti_bonds_loads(&bonds, &none, 0, 0, NULL), VTI_OK);
    assert_int_equal(vti_bonds_sum(&bonds, NULL, 0, 0, &none), VTI_OK);
    const vti_clumps clumps = {.spheres = none};
    assert_int_equal(vti_clumps_spread(&clumps, &none), VTI_OK);
    assert_int_equal(vti_clumps_gather(&clumps, &none), VTI_OK);
    vti_bodies empty = none; /* arrays without numbers may share an address */
    empty.x = empty.v = empty.force = vti_view_packed((double *)plane);
    empty.mass = vti_scalars_one(mass);
    vti_bodies probed = empty;
    assert_int_equal(vti_step_probe(vti_stepper_find("chin4"), 1, 0.1, &empty, &probed), VTI_OK);
    assert_int_equal(vti_multistep_touch(0.1, &empty.x, NULL, &walls, &empty), VTI_OK);
}

/** Who books has memory for it, of all bodies if of each. */
TEST(books)
{
    vti_sum lost = {0, 0};
    vti_effect own = {.name = "magnet", .apply = count, .books = 1};
    assert_int_equal(vti_effects_check(&own, 1, &b, NULL), VTI_E_NULL);
    own.booked = &lost;
    assert_int_equal(vti_effects_check(&own, 1, &b, NULL), VTI_OK);
    own.by_body = &lost;
    assert_int_equal(vti_effects_check(&own, 1, &b, NULL), VTI_E_NULL);
    own.of_body = 1;
    assert_int_equal(vti_effects_check(&own, 1, &b, NULL), VTI_OK);
}

/** The library's effects write forces if they say force, moments if they say moment, and nothing else. */
TEST(gives)
{
    const int64_t pair[2] = {0, 1};
    const double one = 1, large = 30, plane[4] = {0, 0, 1, 0}, zero[DOUBLES] = {0};
    double rest[4];
    const vti_scalars k = vti_scalars_one(&one), d = vti_scalars_one(&large), none = {NULL, 0, 0};
    assert_int_equal(vti_bonds_rest(1, pair, 0, &b.x, rest, NULL), VTI_OK);
    rest[3] *= 0.5;
    const vti_pendulum pendulum = {1, {0.3, 0, 1}};
    const vti_gravity gravity = {{0, 1, 2}};
    const vti_bonds moments = {1, pair, 0, rest, k, none, none, VTI_SHEAR_OBJECTIVE, NULL},
                    axial = {1, pair, 0, rest, none, k, none, VTI_SHEAR_OBJECTIVE, NULL},
                    shear = {1, pair, 0, rest, none, none, k, VTI_SHEAR_OBJECTIVE, NULL};
    const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = d, .stiffness = 5};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = d, .stiffness = 5};
    const int F = 1 << VTI_QUANTITY_FORCE, M = 1 << VTI_QUANTITY_MOMENT;
    const struct {
        vti_effect effect;
        int gives, smooth;
    } all[] = {{vti_pendulum_effect(&pendulum), M, 1}, {vti_gravity_effect(&gravity), F, 1},
               {vti_bonds_effect(&moments), M, 1},     {vti_bonds_effect(&axial), F, 1},
               {vti_bonds_effect(&shear), F | M, 1},   {vti_contacts_effect(&contacts), F, 0},
               {vti_walls_effect(&walls), F, 0}};
    for (size_t e = 0; e < sizeof all / sizeof all[0]; ++e) {
        assert_int_equal(vti_apply(&all[e].effect, 1, &b), VTI_OK);
        assert_int_equal(memcmp(f, zero, sizeof f) != 0 ? F : 0, all[e].gives & F);
        assert_int_equal(memcmp(m, zero, sizeof m) != 0 ? M : 0, all[e].gives & M);
        assert_int_equal(all[e].effect.gives, all[e].gives);
        assert_int_equal(all[e].effect.smooth, all[e].smooth);
        assert_true(all[e].effect.flow == NULL && all[e].effect.carry == NULL && all[e].effect.rupture == NULL);
        assert_true(all[e].effect.dissipates == 0 && all[e].effect.books == 0);
    }
}

RUN_TESTS(cmocka_unit_test_setup(refused_by_one_place, sound), cmocka_unit_test_setup(what_few_need, sound),
          cmocka_unit_test_setup(attitudes, sound), cmocka_unit_test_setup(of_nothing, sound),
          cmocka_unit_test_setup(no_bodies, sound), cmocka_unit_test_setup(books, sound),
          cmocka_unit_test_setup(gives, sound))
