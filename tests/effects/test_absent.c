/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Effects on bodies of which something is absent: with all that an effect reads its loads and energy are those of full
 * company, to the bit; without, it is refused, nothing is touched and no number is its energy. */
#include "crowd.h"

enum { NO_X = 1, NO_FORCE = 2, NO_ATTITUDE = 4, NO_MOMENT = 8, NO_MASS = 16, NO_INERTIA = 32, ALL = 64 };

static crowd c;

/** Velocities have to go with what they would be divided by. */
static vti_bodies without(int absent)
{
    vti_bodies b = crowd_bodies(&c);
    if (absent & NO_X)
        b.x = vti_view_none();
    if (absent & NO_FORCE)
        b.force = vti_view_none();
    if (absent & NO_ATTITUDE)
        b.alpha = vti_view_none();
    if (absent & NO_MOMENT)
        b.moment = vti_view_none();
    if (absent & NO_MASS) {
        b.mass.p = NULL;
        b.v = vti_view_none();
    }
    if (absent & NO_INERTIA) {
        b.inertia.p = NULL;
        b.omega = vti_view_none();
    }
    return b;
}

/** Potential energy; NAN if it is refused. Loads that are not touched are 7. */
static double act(const vti_effect *effect, int absent, int status)
{
    const vti_bodies b = without(absent);
    double energy = NAN;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            c.force[i][k] = c.moment[i][k] = 7;
    assert_int_equal(vti_apply(effect, 1, &b), status);
    if (status == VTI_OK)
        effect->energy(effect->self, &b, &energy);
    else
        assert_true(isnan(vti_energy(effect, 1, &b)));
    return energy;
}

TEST(effects_need_what_they_read)
{
    rng g = rng_seed(41);
    const int64_t pair[4] = {0, 1, 1, 2};
    const double diameter = 3, plane[4] = {0, 0.6, 0.8, 0};
    const vti_gravity gravity = {{1, -2, 3}};
    const vti_pendulum pendulum = {2, {0.5, 1, -1}};
    const vti_contacts contacts = {.count = 2, .pair = pair, .diameter = vti_scalars_one(&diameter), .stiffness = 7};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&diameter), .stiffness = 5};
    const struct {
        vti_effect effect;
        int needs, refusal, for_energy;
    } all[] = {{vti_gravity_effect(&gravity), NO_MASS, VTI_E_NEEDS, NO_X},
               {vti_pendulum_effect(&pendulum), NO_ATTITUDE, VTI_E_NEEDS, 0},
               {vti_contacts_effect(&contacts), NO_X, VTI_E_NEEDS, 0},
               {vti_walls_effect(&walls), NO_X, VTI_E_NEEDS, 0}};
    crowd_clear(&c, 3, CROWD_ALPHA);
    crowd_scatter(&c, &g, 1, 0.5);
    crowd_tumble(&c, &g);
    for (size_t e = 0; e < sizeof all / sizeof all[0]; ++e) {
        const double energy = act(&all[e].effect, 0, VTI_OK);
        const crowd loaded = c;
        assert_true(energy != 0 && (c.force[1][0] != 0 || c.force[1][1] != 0 || c.moment[1][0] != 0));
        for (int absent = 0; absent < ALL; ++absent) {
            const int refused = absent & all[e].needs;
            const double found = act(&all[e].effect, absent, refused ? all[e].refusal : VTI_OK);
            if (refused || absent & all[e].for_energy)
                assert_true(isnan(found));
            else
                assert_same_bits(&found, &energy, 1);
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 3; ++k) {
                    assert_true(c.force[i][k] == (refused || absent & NO_FORCE ? 7 : loaded.force[i][k]));
                    assert_true(c.moment[i][k] == (refused || absent & NO_MOMENT ? 7 : loaded.moment[i][k]));
                }
        }
    }
}

/** Planes that are not there do nothing. */
TEST(no_walls)
{
    const double diameter = 3;
    const vti_walls none = {.count = 0, .plane = NULL, .diameter = {NULL, 0, 0}, .stiffness = 5},
                    nowhere = {.count = 1, .plane = NULL, .diameter = vti_scalars_one(&diameter), .stiffness = 5};
    const vti_effect effect = vti_walls_effect(&none);
    crowd_clear(&c, 3, CROWD_ALPHA);
    assert_true(act(&effect, 0, VTI_OK) == 0 && c.force[0][0] == 0);
    assert_null(vti_walls_effect(&nowhere).apply);
}

/** Bonds have no meaning on bodies without what their terms read: refused, and forces are as they were. */
TEST(bonds_are_refused)
{
    rng g = rng_seed(42);
    web w;
    crowd_clear(&c, 5, CROWD_ALPHA);
    crowd_scatter(&c, &g, 1, 0.3);
    const int64_t count = web_grow(&w, &g, &c, 3, 1, 5);
    for (int terms = 0; terms < 8; ++terms)
        for (int absent = 0; absent < ALL; ++absent) {
            const int lacks =
                (terms & (AXIAL | SHEAR) && absent & NO_X) || (terms & (MOMENT | SHEAR) && absent & NO_ATTITUDE);
            const vti_bodies b = without(absent);
            web_terms(&w, count, terms, VTI_SHEAR_OBJECTIVE);
            const vti_effect effect = vti_bonds_effect(&w.bonds);
            for (int i = 0; i < 5; ++i)
                c.force[i][0] = c.moment[i][1] = 7;
            assert_int_equal(vti_apply(&effect, 1, &b), lacks ? VTI_E_NEEDS : VTI_OK);
            assert_int_equal(isnan(vti_energy(&effect, 1, &b)) != 0, lacks);
            assert_int_equal(c.force[4][0] == 7, lacks || absent & NO_FORCE ? 1 : 0);
            assert_int_equal(c.moment[4][1] == 7, lacks || absent & NO_MOMENT ? 1 : 0);
            w.bonds.count = 0;
            assert_int_equal(vti_apply(&effect, 1, &b), lacks ? VTI_E_NEEDS : VTI_OK); /* of none of them too */
        }
    /* and bonds that have lost their list */
    const vti_bodies b = without(0);
    web_terms(&w, count, AXIAL, VTI_SHEAR_OBJECTIVE);
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    const vti_bonds right = w.bonds;
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
    w.bonds.pair = NULL;
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_E_NULL);
    w.bonds = right;
    w.bonds.rest = NULL;
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_E_NULL);
}

/** Says of the effect what it says where something is absent. */
static void refuses(const vti_effect *effect, int absent)
{
    const vti_bodies all = without(0), b = without(absent);
    assert_int_equal(vti_effects_check(effect, 1, &all, NULL), VTI_OK);
    assert_int_equal(vti_effects_check(effect, 1, &b, NULL), VTI_E_NEEDS);
    assert_int_equal(vti_apply(effect, 1, &b), VTI_E_NEEDS);
    assert_int_equal(vti_effects_flow(effect, 1, 0.1, 0.1, &b), VTI_E_NEEDS);
}

/** Effects that were made before a term of theirs was there are refused by bodies that lack what it reads. */
TEST(terms_that_come_later)
{
    rng g = rng_seed(43);
    web w;
    vti_sum lost[4] = {{0, 0}};
    const double one = 1;
    crowd_clear(&c, 3, CROWD_ALPHA);
    crowd_scatter(&c, &g, 1, 0.3);
    const int64_t count = web_grow(&w, &g, &c, 1, 1, 5);
    web_terms(&w, count, 0, VTI_SHEAR_OBJECTIVE);
    const vti_effect bonds = vti_bonds_effect(&w.bonds);
    for (int terms = 1; terms < 8; ++terms) {
        web_terms(&w, count, terms, VTI_SHEAR_OBJECTIVE);
        if (terms & (MOMENT | SHEAR))
            refuses(&bonds, NO_ATTITUDE);
        if (terms & (AXIAL | SHEAR))
            refuses(&bonds, NO_X);
    }
    vti_drag drag = {.lost = lost};
    const vti_effect slows = vti_drag_effect(&drag);
    drag.angular = vti_scalars_one(&one);
    refuses(&slows, NO_INERTIA);
    drag = (vti_drag){.lost = lost, .quadratic = vti_scalars_one(&one)};
    refuses(&slows, NO_MASS);
    vti_bond_dashpots brakes = {.bonds = &w.bonds, .zeta = 0.1, .lost = lost};
    web_terms(&w, count, AXIAL, VTI_SHEAR_OBJECTIVE);
    const vti_effect braked = vti_bond_dashpots_effect(&brakes);
    brakes.bending = 1;
    refuses(&braked, NO_INERTIA);
    brakes.bending = 0;
    web_terms(&w, count, AXIAL | MOMENT, VTI_SHEAR_OBJECTIVE);
    refuses(&braked, NO_INERTIA);
    const vti_contacts none = {.diameter = vti_scalars_one(&one), .stiffness = 1};
    vti_dashpots dashpots = {.contacts = &none, .zeta = 0.1, .reach = 1, .lost = lost};
    const vti_effect damps = vti_dashpots_effect(&dashpots);
    dashpots.rolling = 1;
    refuses(&damps, NO_INERTIA);
}

/** Walls that moved when the effect was made, and have no motion any more, stand still. */
TEST(walls_that_come_to_stand)
{
    const double diameter = 3, plane[4] = {0, 0, 1, 0};
    vti_wall_motion motion = {.velocity = {0, 0, 1}};
    vti_sum work = {0, 0};
    vti_walls walls = {.count = 1,
                       .plane = plane,
                       .diameter = vti_scalars_one(&diameter),
                       .stiffness = 5,
                       .motion = &motion,
                       .work = &work};
    const vti_effect effect = vti_walls_effect(&walls);
    const vti_drifted drifted = {.t = 1, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    crowd_clear(&c, 3, CROWD_ALPHA);
    const vti_bodies b = without(0);
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
    assert_true(motion.moved[2] == 1);
    walls.motion = NULL;
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
    assert_true(motion.moved[2] == 1);
}

static int applied;

static void count_calls(const void *self, const vti_bodies *b)
{
    (void)self;
    (void)b;
    ++applied;
}

static int no_field(const void *self, const vti_bodies *b)
{
    (void)b;
    return self == NULL ? VTI_E_BOND : VTI_OK;
}

/** Somebody else's effect reads what it likes, and may refuse as it likes, before any effect has touched anything. */
TEST(others_may_refuse)
{
    const double field = 1;
    const vti_bodies none = vti_bodies_none(1);
    vti_effect own[2] = {{.name = "magnet", .apply = count_calls, .self = &field},
                         {.name = "magnet", .apply = count_calls, .check = no_field, .self = &field}};
    applied = 0;
    assert_int_equal(vti_apply(own, 2, &none), VTI_OK);
    assert_int_equal(applied, 2);
    own[1].self = NULL;
    assert_int_equal(vti_apply(own, 2, &none), VTI_E_BOND);
    assert_int_equal(applied, 2);
}

/** A list of contacts may change after the effect was made, and then lack something: refused, and no number is its
 *  energy. */
TEST(contacts_are_looked_at_again)
{
    const int64_t pair[2] = {0, 1};
    const double diameter = 3;
    const vti_contacts right = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&diameter), .stiffness = 7};
    vti_contacts contacts = right;
    const vti_effect effect = vti_contacts_effect(&contacts);
    crowd_clear(&c, 2, CROWD_ALPHA);
    c.x[1][0] = 2;
    const vti_bodies b = crowd_bodies(&c);
    for (int k = 0; k < 3; ++k) {
        contacts = right;
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        assert_true(c.force[1][0] > 0);
        const crowd before = c;
        if (k == 0)
            contacts.count = -1;
        else if (k == 1)
            contacts.pair = NULL;
        else
            contacts.diameter.p = NULL;
        assert_int_equal(vti_apply(&effect, 1, &b), k == 0 ? VTI_E_COUNT : VTI_E_NULL);
        assert_true(isnan(vti_energy(&effect, 1, &b)));
        assert_null(vti_contacts_effect(&contacts).apply);
        assert_memory_equal(&c, &before, sizeof c);
    }
    contacts = right;
    contacts.count = 0;
    contacts.pair = NULL;
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
    assert_true(c.force[1][0] == 0 && vti_energy(&effect, 1, &b) == 0);
}

RUN_TESTS(cmocka_unit_test(effects_need_what_they_read), cmocka_unit_test(no_walls),
          cmocka_unit_test(bonds_are_refused), cmocka_unit_test(terms_that_come_later),
          cmocka_unit_test(walls_that_come_to_stand), cmocka_unit_test(others_may_refuse),
          cmocka_unit_test(contacts_are_looked_at_again))
