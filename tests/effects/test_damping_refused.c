/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What friction and dashpots refuse: every coefficient that is negative, infinite or not a number, stiffnesses that are
 * missing or one too many, lists and tables that are not there. */
#include <stddef.h>

#include "impact.h"

static impact m;
static vti_held entries[8];
static int64_t slots[8];
static vti_history history;
static web w;

static const double wrong[] = {-1, INFINITY, -INFINITY, NAN};

/** Two bodies and a plane. */
static void two_bodies(void)
{
    impact_clear(&m, 2, 1, 1e4);
    m.c.x[0][2] = 0.9;
    m.plane[0][2] = 1;
    memset(slots, 0, sizeof slots);
    history = (vti_history){8, 0, 0, entries, slots};
}

static void says(const vti_effect effect, int status)
{
    double before[2][3];
    memcpy(before, m.c.v, sizeof before);
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), status);
    if (status == VTI_OK)
        return;
    assert_int_equal(vti_effects_flow(&effect, 1, 1, 1, &m.b), status);
    assert_int_equal(vti_apply(&effect, 1, &m.b), status);
    assert_same_bits(before[0], m.c.v[0], 6);
}

/* ---- friction ---------------------------------------------------------------------------------------------------- */

static vti_friction all_friction(void)
{
    return (vti_friction){.contacts = &m.contacts,
                          .walls = &m.walls,
                          .sliding = 0.5,
                          .rolling = 0.1,
                          .twisting = 0.1,
                          .stiffness = 100,
                          .rolling_stiffness = 10,
                          .twisting_stiffness = 10,
                          .reach = 1,
                          .history = &history,
                          .lost = m.lost};
}

TEST(coefficients_of_friction)
{
    static const size_t at[] = {offsetof(vti_friction, sliding),           offsetof(vti_friction, rolling),
                                offsetof(vti_friction, twisting),          offsetof(vti_friction, stiffness),
                                offsetof(vti_friction, rolling_stiffness), offsetof(vti_friction, twisting_stiffness),
                                offsetof(vti_friction, mindlin),           offsetof(vti_friction, reach)};
    two_bodies();
    vti_friction p = all_friction();
    says(vti_friction_effect(&p), VTI_OK);
    for (int k = 0; k < 8; ++k)
        for (int bad = 0; bad < 4; ++bad) {
            p = all_friction();
            memcpy((char *)&p + at[k], &wrong[bad], sizeof(double));
            says(vti_friction_effect(&p), k == 7 && bad == 1 ? VTI_OK : VTI_E_DAMPING); /* any reach, even INFINITY */
        }
    p = all_friction();
    p.reach = 0;
    says(vti_friction_effect(&p), VTI_E_DAMPING);
}

/** One stiffness for each motion that there is, and for sliding one of two; those of motions that there are not do not
 *  matter. */
TEST(stiffnesses_of_friction)
{
    static const struct {
        double sliding, stiffness, mindlin, rolling, rolling_stiffness, twisting, twisting_stiffness;
        int status;
    } cases[] = {{0.5, 0, 0, 0, 0, 0, 0, VTI_E_DAMPING}, {0.5, 1, 1, 0, 0, 0, 0, VTI_E_DAMPING},
                 {0, 1, 0, 0, 0, 0, 0, VTI_OK},          {0, 0, 1, 0, 0, 0, 0, VTI_OK},
                 {0, 0, 0, 1, 0, 0, 0, VTI_E_DAMPING},   {0, 0, 0, 0, 0, 1, 0, VTI_E_DAMPING},
                 {0.5, 1, 0, 0, 0, 0, 0, VTI_OK},        {0.5, 0, 1, 0, 0, 0, 0, VTI_OK},
                 {0, 0, 0, 1, 1, 0, 0, VTI_OK},          {0, 0, 0, 0, 0, 1, 1, VTI_OK},
                 {0, 0, 0, 0, 1, 0, 1, VTI_OK}};
    two_bodies();
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        vti_friction p = all_friction();
        p.sliding = cases[k].sliding;
        p.stiffness = cases[k].stiffness;
        p.mindlin = cases[k].mindlin;
        p.rolling = cases[k].rolling;
        p.rolling_stiffness = cases[k].rolling_stiffness;
        p.twisting = cases[k].twisting;
        p.twisting_stiffness = cases[k].twisting_stiffness;
        says(vti_friction_effect(&p), cases[k].status);
    }
}

static vti_dashpots all_dashpots(void)
{
    return (vti_dashpots){.contacts = &m.contacts,
                          .walls = &m.walls,
                          .zeta = 0.1,
                          .normal = 1,
                          .tangential = 1,
                          .ratio = 1,
                          .rolling = 1,
                          .twisting = 1,
                          .reach = 1,
                          .lost = m.lost};
}

/** Walls are looked at as their own effect does. */
static void walls_are_looked_at(const vti_effect *effect)
{
    static const double skew[4] = {0, 0, 2, 0};
    const vti_walls good = m.walls;
    says(*effect, VTI_OK);
    m.walls.plane = skew;
    says(*effect, VTI_E_CONTACT);
    m.walls.plane = NULL;
    says(*effect, VTI_E_NULL);
    m.walls = good;
    m.walls.diameter.p = NULL;
    says(*effect, VTI_E_NULL);
    m.walls = good;
    m.walls.count = -1;
    says(*effect, VTI_E_COUNT);
    m.walls = good;
}

TEST(walls)
{
    two_bodies();
    const vti_friction friction = all_friction();
    const vti_dashpots dashpots = all_dashpots();
    const vti_effect both[] = {vti_friction_effect(&friction), vti_dashpots_effect(&dashpots)};
    walls_are_looked_at(&both[0]);
    walls_are_looked_at(&both[1]);
}

/** Bodies that have all gone leave lists behind. */
TEST(no_bodies_but_pairs)
{
    two_bodies();
    const vti_friction p = all_friction();
    const vti_effect effect = vti_friction_effect(&p);
    const vti_bodies none = vti_bodies_none(0);
    vti_stable stable;
    double scratch[1];
    assert_int_equal(vti_stable_step(&effect, 1, &none, NULL, scratch, &stable), VTI_E_BOND);
}

TEST(lists_and_tables_of_friction)
{
    two_bodies();
    vti_friction p = all_friction();
    m.contacts.pair = NULL;
    says(vti_friction_effect(&p), VTI_E_NULL);
    m.contacts.count = 0; /* an empty list needs no memory */
    says(vti_friction_effect(&p), VTI_OK);
    m.contacts.diameter.p = NULL;
    says(vti_friction_effect(&p), VTI_E_NULL);
    p.contacts = NULL;
    says(vti_friction_effect(&p), VTI_OK);
    history.slot = NULL;
    says(vti_friction_effect(&p), VTI_E_NULL);
    history.slot = slots;
    history.held = NULL;
    says(vti_friction_effect(&p), VTI_E_NULL);
    history.held = entries;
    history.slots = INT64_C(1) << 32;
    says(vti_friction_effect(&p), VTI_E_HISTORY);
    for (int64_t n = -1; n < 8; ++n) {
        history.slots = n;
        says(vti_friction_effect(&p), n == 1 || n == 2 || n == 4 ? VTI_OK : VTI_E_HISTORY);
    }
    history.slots = 8;
    const vti_effect made_before = vti_friction_effect(&p);
    says(made_before, VTI_OK);
    p.history = NULL;
    says(made_before, VTI_E_NULL);
    says(vti_friction_effect(&p), VTI_E_NULL);
    p = all_friction();
    p.lost = NULL;
    says(made_before, VTI_E_NULL);
    says(vti_friction_effect(&p), VTI_E_NULL);
    p = all_friction();
    p.contacts = NULL;
    p.walls = NULL;
    says(vti_friction_effect(&p), VTI_E_NULL);
    says(vti_friction_effect(NULL), VTI_E_NULL);
}

/** A history takes what there is room for, one slot staying empty, and a touch once. */
TEST(adding_to_a_table)
{
    vti_held held = {1, 9, {3, 0, 0}, {0, 0, 0}, 0};
    static const vti_held bad[] = {{-1, 9, {0}, {0}, 0}, {0, 9, {0}, {0}, 0},         {1, 0, {0}, {0}, 0},
                                   {9, 9, {0}, {0}, 0},  {1, 9, {0, NAN, 0}, {0}, 0}, {1, 9, {0}, {0, 0, INFINITY}, 0},
                                   {1, 9, {0}, {0}, NAN}};
    two_bodies();
    assert_int_equal(vti_history_add(NULL, &held), VTI_E_NULL);
    assert_int_equal(vti_history_add(&history, NULL), VTI_E_NULL);
    history.slot = NULL;
    assert_int_equal(vti_history_add(&history, &held), VTI_E_NULL);
    history.slot = slots;
    history.held = NULL;
    assert_int_equal(vti_history_add(&history, &held), VTI_E_NULL);
    history.held = entries;
    for (int64_t n = -2; n < 8; n += n == 0 ? 3 : 2) { /* -2, 0, 3, 5, 7 */
        history.slots = n;
        assert_int_equal(vti_history_add(&history, &held), VTI_E_HISTORY);
    }
    history.slots = 8;
    for (int k = 0; k < 7; ++k)
        assert_int_equal(vti_history_add(&history, &bad[k]), VTI_E_HISTORY);
    assert_int_equal(history.used, 0);
    for (int again = 0; again < 2; ++again)
        for (held.i = 1; held.i <= 8; ++held.i) {
            held.sliding[0] = (double)(10 * again + held.i);
            assert_int_equal(vti_history_add(&history, &held), held.i < 8 ? VTI_OK : VTI_E_HISTORY);
            assert_int_equal(history.used, again == 0 && held.i < 8 ? held.i : 7);
        }
    double sum = 0;
    for (int k = 0; k < 7; ++k)
        sum += entries[k].sliding[0];
    assert_close(sum, 7 * 10 + 28, 0);
    history.used = 8; /* as a damaged restart says */
    assert_int_equal(vti_history_add(&history, &held), VTI_E_HISTORY);
}

/** A restart fills an empty table by vti_history_add: what was held beside slots that do not know it is refused, as is
 *  a number of entries that cannot be. */
TEST(a_table_of_its_own)
{
    two_bodies();
    const vti_friction p = all_friction();
    for (int64_t k = 0; k < 3; ++k)
        assert_int_equal(vti_history_add(&history, &(vti_held){1 + k, 5 + k, {0}, {0}, 0}), VTI_OK);
    says(vti_friction_effect(&p), VTI_OK);
    const int64_t counts[] = {-1, 4, 8, 9};
    for (int k = 0; k < 4; ++k) {
        history.used = counts[k];
        entries[3] = (vti_held){6, 8, {0}, {0}, 0}; /* of which the slots know nothing */
        says(vti_friction_effect(&p), VTI_E_HISTORY);
    }
    history.used = -1;
    assert_int_equal(vti_history_add(&history, &entries[3]), VTI_E_HISTORY);
    history.used = 3;
    entries[0].i = 4;
    says(vti_friction_effect(&p), VTI_E_HISTORY);
    entries[0].i = 1;
    says(vti_friction_effect(&p), VTI_OK);
    memset(slots, 0, sizeof slots);
    says(vti_friction_effect(&p), VTI_E_HISTORY);
    memset(slots, 1, sizeof slots); /* none is empty, and none leads anywhere */
    says(vti_friction_effect(&p), VTI_E_HISTORY);
}

/* ---- dashpots ---------------------------------------------------------------------------------------------------- */

TEST(coefficients_of_dashpots)
{
    static const size_t at[] = {offsetof(vti_dashpots, zeta),       offsetof(vti_dashpots, normal),
                                offsetof(vti_dashpots, tangential), offsetof(vti_dashpots, ratio),
                                offsetof(vti_dashpots, rolling),    offsetof(vti_dashpots, twisting),
                                offsetof(vti_dashpots, reach)};
    two_bodies();
    for (int k = 0; k < 7; ++k)
        for (int bad = 0; bad < 4; ++bad) {
            vti_dashpots p = all_dashpots();
            says(vti_dashpots_effect(&p), VTI_OK);
            memcpy((char *)&p + at[k], &wrong[bad], sizeof(double));
            says(vti_dashpots_effect(&p), k == 6 && bad == 1 ? VTI_OK : VTI_E_DAMPING);
        }
    vti_dashpots p = all_dashpots();
    p.reach = 0; /* as a struct of zeros has it */
    says(vti_dashpots_effect(&p), VTI_E_DAMPING);
}

/** Dashpots look at the friction whose limits they obey, whether its effect is there or not. */
TEST(limits_of_dashpots)
{
    static const size_t at[] = {offsetof(vti_friction, sliding), offsetof(vti_friction, rolling),
                                offsetof(vti_friction, twisting)};
    two_bodies();
    vti_friction friction = all_friction();
    vti_dashpots p = all_dashpots();
    p.friction = &friction;
    says(vti_dashpots_effect(&p), VTI_OK);
    for (int k = 0; k < 3; ++k)
        for (int bad = 0; bad < 4; ++bad) {
            friction = all_friction();
            memcpy((char *)&friction + at[k], &wrong[bad], sizeof(double));
            says(vti_dashpots_effect(&p), VTI_E_DAMPING);
        }
    friction = all_friction();
    for (int bad = 0; bad < 4; ++bad) {
        friction.wall_sliding = &wrong[bad];
        says(vti_dashpots_effect(&p), VTI_E_DAMPING);
        says(vti_friction_effect(&friction), VTI_E_DAMPING);
    }
}

TEST(lists_of_dashpots)
{
    two_bodies();
    vti_dashpots p = all_dashpots();
    const vti_effect made_before = vti_dashpots_effect(&p);
    p.lost = NULL;
    says(made_before, VTI_E_NULL);
    p = all_dashpots();
    m.contacts.pair = NULL;
    says(vti_dashpots_effect(&p), VTI_E_NULL);
    m.contacts.count = 0;
    says(vti_dashpots_effect(&p), VTI_OK);
    m.contacts.diameter.p = NULL;
    says(vti_dashpots_effect(&p), VTI_E_NULL);
    p.contacts = NULL;
    says(vti_dashpots_effect(&p), VTI_OK);
    p.walls = NULL;
    says(vti_dashpots_effect(&p), VTI_E_NULL);
    p = all_dashpots();
    p.lost = NULL;
    says(vti_dashpots_effect(&p), VTI_E_NULL);
    says(vti_dashpots_effect(NULL), VTI_E_NULL);
}

TEST(dashpots_of_bonds)
{
    static const size_t at[] = {offsetof(vti_bond_dashpots, zeta), offsetof(vti_bond_dashpots, axial),
                                offsetof(vti_bond_dashpots, shear), offsetof(vti_bond_dashpots, bending),
                                offsetof(vti_bond_dashpots, twisting)};
    rng g = rng_seed(1430);
    two_bodies();
    web_terms(&w, web_grow(&w, &g, &m.c, 0, 1, 2), MOMENT, VTI_SHEAR_OBJECTIVE);
    const vti_bond_dashpots good = {&w.bonds, 0.1, 1, 1, 1, 1, m.lost, NULL};
    for (int k = 0; k < 5; ++k)
        for (int bad = 0; bad < 4; ++bad) {
            vti_bond_dashpots p = good;
            says(vti_bond_dashpots_effect(&p), VTI_OK);
            memcpy((char *)&p + at[k], &wrong[bad], sizeof(double));
            says(vti_bond_dashpots_effect(&p), VTI_E_DAMPING);
        }
    vti_bond_dashpots p = good;
    w.bonds.rest = NULL;
    says(vti_bond_dashpots_effect(&p), VTI_E_NULL);
    w.bonds.pair = NULL;
    says(vti_bond_dashpots_effect(&p), VTI_E_NULL);
    w.bonds.count = 0;
    const vti_effect made_before = vti_bond_dashpots_effect(&p);
    says(made_before, VTI_OK);
    p.lost = NULL;
    says(made_before, VTI_E_NULL);
    says(vti_bond_dashpots_effect(&p), VTI_E_NULL);
    says(vti_bond_dashpots_effect(NULL), VTI_E_NULL);
}

/** Each motion that turns bodies, weak or not, needs to know how they turn, by itself or as a share of a stiffness. */
TEST(bonds_that_turn)
{
    rng g = rng_seed(1432);
    two_bodies();
    m.b.omega = m.b.moment = vti_view_none();
    for (int k = 0; k < 5; ++k) {
        web_terms(&w, web_grow(&w, &g, &m.c, 0, 1, 2), k == 3 ? MOMENT : AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        vti_bond_dashpots p = {.bonds = &w.bonds, .zeta = k >= 3 ? 1e-9 : 0, .lost = m.lost};
        p.bending = k == 1 ? 1e-9 : 0;
        p.twisting = k == 2 ? 1e-9 : 0;
        says(vti_bond_dashpots_effect(&p), k == 0 || k == 4 ? VTI_OK : VTI_E_NEEDS);
    }
}

/** Dashpots divide by the inertia of bodies that turn, where nothing else asks for it. */
TEST(inertia_of_what_turns)
{
    rng g = rng_seed(1431);
    two_bodies();
    web_terms(&w, web_grow(&w, &g, &m.c, 0, 1, 2), MOMENT, VTI_SHEAR_OBJECTIVE);
    const vti_dashpots p = all_dashpots();
    const vti_bond_dashpots bonds = {&w.bonds, 0.1, 1, 1, 1, 1, m.lost, NULL};
    m.b.moment = vti_view_none();
    says(vti_dashpots_effect(&p), VTI_OK);
    says(vti_bond_dashpots_effect(&bonds), VTI_OK);
    m.b.inertia.p = NULL;
    says(vti_dashpots_effect(&p), VTI_E_INERTIA);
    says(vti_bond_dashpots_effect(&bonds), VTI_E_INERTIA);
    double moments[2][3] = {{1, 1, 1}, {1, 1, 1}};
    m.b.moments = vti_view_packed(moments[0]);
    says(vti_dashpots_effect(&p), VTI_OK);
    says(vti_bond_dashpots_effect(&bonds), VTI_OK);
}

RUN_TESTS(cmocka_unit_test(coefficients_of_friction), cmocka_unit_test(stiffnesses_of_friction),
          cmocka_unit_test(walls), cmocka_unit_test(no_bodies_but_pairs),
          cmocka_unit_test(lists_and_tables_of_friction), cmocka_unit_test(adding_to_a_table),
          cmocka_unit_test(a_table_of_its_own), cmocka_unit_test(coefficients_of_dashpots),
          cmocka_unit_test(limits_of_dashpots), cmocka_unit_test(lists_of_dashpots),
          cmocka_unit_test(dashpots_of_bonds), cmocka_unit_test(bonds_that_turn),
          cmocka_unit_test(inertia_of_what_turns))
