/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Touches of a crowd of bodies and of walls: the order in which pairs and bonds are worked (EQUATIONS 6.4), and all at
 * once the bits of one after the other, however many are handed to a kernel. */
#include "touch_alone.h"

#include "../../src/dissipation/vti_dashpot_flow.h"
#include "../../src/contacts/vti_touch_table.h"

enum { MANY = 130, LIST = 2600, TOGETHER = 256 };

static double place_of[MANY][3], velocity[MANY][3], spin[MANY][3];
static int64_t listed[LIST][2], order[LIST], count, all;

static int64_t near_pairs(double reach)
{
    int64_t n = 0;
    for (int64_t k = 0; k < all; ++k) {
        double d[3];
        for (int c = 0; c < 3; ++c)
            d[c] = place_of[listed[k][0]][c] - place_of[listed[k][1]][c];
        if (sqrt(vti_dot(d, d)) <= 1.0 + reach)
            order[n++] = k;
    }
    return n;
}

/** Of the pairs within reach, as many together as TOGETHER, into order: colour by colour, the smallest that neither
 *  body has; what finds none below 63 comes last. */
static void expect_order(double reach)
{
    static int has[MANY][64];
    int64_t sorted[LIST], to = 0;
    count = near_pairs(reach);
    for (int64_t from = 0; from < count; from += TOGETHER) {
        const int64_t end = from + TOGETHER < count ? from + TOGETHER : count;
        int colour[LIST];
        memset(has, 0, sizeof has);
        for (int64_t n = from; n < end; ++n) {
            const int64_t i = listed[order[n]][0], j = listed[order[n]][1];
            int c = 0;
            while (c < 63 && (has[i][c] || has[j][c]))
                ++c;
            has[i][c] = has[j][c] = 1;
            colour[n] = c;
        }
        for (int c = 0; c < 64; ++c)
            for (int64_t n = from; n < end; ++n)
                if (colour[n] == c)
                    sorted[to++] = order[n];
    }
    memcpy(order, sorted, (size_t)count * sizeof *order);
}

/** A crowd of which the first touches nearly all, so that it has more pairs than there are colours. */
static void draw_crowd(rng *g)
{
    all = 0;
    for (int i = 0; i < MANY; ++i) {
        random_vector(g, i ? 1.0 : 0.05, place_of[i]);
        random_vector(g, 1.0, velocity[i]);
        random_vector(g, 1.0, spin[i]);
    }
    for (int64_t i = 0; i < MANY; ++i)
        for (int64_t j = i + 1; j < MANY && all < LIST; ++j)
            if (i == 0 || (i + j) % 3 == 0) {
                listed[all][0] = i;
                listed[all++][1] = j;
            }
}

/** The crowd as spheres of one mass and one inertia. */
static vti_bodies bodies_of_crowd(void)
{
    static const double one = 1.0;
    vti_bodies b = vti_bodies_none(MANY);
    b.x = vti_view_packed(place_of[0]);
    b.v = vti_view_packed(velocity[0]);
    b.omega = vti_view_packed(spin[0]);
    b.mass = b.inertia = vti_scalars_one(&one);
    return b;
}

TEST(order_of_the_pairs)
{
    static const double one = 1.0;
    rng g = rng_seed(17);
    for (int trial = 0; trial < 12; ++trial) {
        vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}}, lost_too[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}};
        double v[MANY][3], w[MANY][3];
        draw_crowd(&g);
        assert_int_equal(all, LIST);
        all = trial % 4 < 2 ? LIST : 700; /* pairs of more windows than are found at once, and of fewer */
        memcpy(v, velocity, sizeof v);
        memcpy(w, spin, sizeof w);
        vti_bodies b = bodies_of_crowd();
        const double reach = trial % 3 ? 0.2 : INFINITY, drift = trial % 2 ? -0.01 : 0.01;
        vti_contacts contacts = {.count = all, .pair = listed[0], .diameter = vti_scalars_one(&one), .stiffness = 1.0};
        vti_dashpots p = {
            .contacts = &contacts, .zeta = 0.3, .ratio = 0.5, .rolling = 0.1, .reach = reach, .lost = lost};
        vti_effect effect = vti_dashpots_effect(&p);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &b), VTI_OK);
        expect_order(reach);
        assert_true(count > TOGETHER);
        p.lost = lost_too;
        b.v = vti_view_packed(v[0]);
        b.omega = vti_view_packed(w[0]);
        contacts.count = 1;
        for (int64_t n = 0; n < count; ++n) {
            contacts.pair = listed[order[drift < 0.0 ? count - 1 - n : n]];
            effect = vti_dashpots_effect(&p);
            assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &b), VTI_OK);
        }
        assert_same_bits(velocity, v, 3 * MANY);
        assert_same_bits(spin, w, 3 * MANY);
        assert_same_bits(lost, lost_too, 2 * VTI_DASHPOT_BOOKS);
    }
}

/** Bonds of a crowd, all of one list: in the order of contacts' pairs. */
TEST(order_of_the_bonds)
{
    static double rest[LIST][4];
    rng g = rng_seed(37);
    for (int trial = 0; trial < 4; ++trial) {
        vti_sum lost[2][VTI_BOND_DASHPOT_BOOKS] = {{{0.0, 0.0}}};
        double v[MANY][3], w[MANY][3];
        draw_crowd(&g);
        all = 700;
        memcpy(v, velocity, sizeof v);
        memcpy(w, spin, sizeof w);
        vti_bodies b = bodies_of_crowd();
        const double drift = trial % 2 ? -0.01 : 0.01;
        for (int64_t k = 0; k < all; ++k)
            rest[k][3] = 1.0;
        vti_bonds bonds = {.count = all, .pair = listed[0], .rest = rest[0]};
        vti_bond_dashpots p = {.bonds = &bonds, .axial = 0.3, .shear = 0.2, .bending = 0.1, .lost = lost[0]};
        vti_effect effect = vti_bond_dashpots_effect(&p);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &b), VTI_OK);
        expect_order(INFINITY);
        assert_int_equal(count, all);
        p.lost = lost[1];
        b.v = vti_view_packed(v[0]);
        b.omega = vti_view_packed(w[0]);
        bonds.count = 1;
        for (int64_t n = 0; n < count; ++n) {
            bonds.pair = listed[order[drift < 0.0 ? count - 1 - n : n]];
            assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &b), VTI_OK);
        }
        assert_same_bits(velocity, v, 3 * MANY);
        assert_same_bits(spin, w, 3 * MANY);
        assert_same_bits(lost[0], lost[1], 2 * VTI_BOND_DASHPOT_BOOKS);
    }
}

/** Springs of a crowd, and of its bodies at a plane, carried all at once and pair by pair: the same loads and losses. A
 *  table without room says for how many it had none. */
TEST(springs_of_a_crowd)
{
    static const double one = 1.0, plane[4] = {0.0, 0.0, 1.0, -0.6};
    static double alpha[MANY][3];
    static vti_held table[2][4096];
    static int64_t slot[2][4096];
    rng g = rng_seed(23);
    vti_sum lost[2][VTI_FRICTION_BOOKS] = {{{0.0, 0.0}}};
    vti_history history[2] = {{4096, 0, 0, table[0], slot[0]}, {4096, 0, 0, table[1], slot[1]}};
    draw_crowd(&g);
    vti_bodies b = vti_bodies_none(MANY);
    b.x = vti_view_packed(place_of[0]);
    b.v = vti_view_packed(velocity[0]);
    b.omega = vti_view_packed(spin[0]);
    b.alpha = vti_view_packed(alpha[0]);
    b.mass = b.inertia = vti_scalars_one(&one);
    const vti_contacts whole = {.count = all, .pair = listed[0], .diameter = vti_scalars_one(&one), .stiffness = 2.0};
    const vti_walls floor_of = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&one), .stiffness = 2.0};
    vti_contacts pair = whole;
    pair.count = 1;
    vti_friction friction = {
        .sliding = 0.3, .mindlin = 0.8, .rolling = 0.1, .rolling_stiffness = 1.0, .reach = INFINITY};
    const vti_drifted drifted = {.t = 0.01, .law = VTI_LAW_EXACT, .frame = VTI_FRAME_SPACE};
    for (int step = 0; step < 3; ++step) {
        friction.contacts = &whole;
        friction.history = &history[0];
        friction.lost = lost[0];
        vti_effect effect = vti_friction_effect(&friction);
        assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
        friction.contacts = &pair;
        friction.history = &history[1];
        friction.lost = lost[1];
        effect = vti_friction_effect(&friction);
        for (int64_t k = 0; k < all; ++k) {
            pair.pair = listed[k];
            assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
        }
        for (int i = 0; i < 3 * MANY; ++i)
            place_of[i / 3][i % 3] += 0.01 * velocity[i / 3][i % 3];
    }
    assert_int_equal(history[0].used, history[1].used);
    for (int64_t k = 0; k < history[0].used; ++k)
        assert_memory_equal(&table[0][k], vti_history_find(&history[1], table[0][k].i, table[0][k].j),
                            sizeof table[0][k]);
    assert_same_bits(lost[0], lost[1], 2 * VTI_FRICTION_BOOKS);

    vti_history small = {8, 0, 0, table[1], slot[1]};
    memset(slot[1], 0, sizeof slot[1]);
    friction.history = &small;
    friction.contacts = &whole;
    friction.walls = &floor_of;
    vti_effect effect = vti_friction_effect(&friction);
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
    assert_true(small.used == 7 && small.missed > 100);
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_E_HISTORY);
}

/** Bodies at walls that stand and move, all at once and one by one, packed and component by component: the same bits
 *  of each. */
TEST(walls)
{
    static const double plane[2][4] = {{0.0, 0.0, 1.0, -0.8}, {0.6, 0.8, 0.0, -0.7}},
                        cylinder[1][7] = {{0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.9}};
    rng g = rng_seed(19);
    for (int trial = 0; trial < 48; ++trial) {
        vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}}, lost_too[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}},
                work[2] = {{0.0, 0.0}};
        double v[3][MANY], w[MANY][3], diameter[MANY];
        draw_crowd(&g);
        for (int i = 0; i < MANY; ++i)
            diameter[i] = uniform(&g, 0.1, 0.4);
        for (int i = 0; i < 3 * MANY; ++i)
            v[i % 3][i / 3] = velocity[i / 3][i % 3];
        memcpy(w, spin, sizeof w);
        vti_wall_motion motion[3] = {
            {{0.1, 0.0, 0.2}, 0.3, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {.spin = 0.5}, {.spin = 2.0}};
        vti_walls of = {.count = 2,
                        .plane = plane[0],
                        .diameter = vti_scalars_array(diameter),
                        .stiffness = 3.0,
                        .cylinders = 1,
                        .cylinder = cylinder[0],
                        .motion = trial % 2 ? motion : NULL,
                        .work = &work[0]};
        vti_held table[512];
        int64_t slot[512] = {0};
        vti_history history = {512, 0, 0, table, slot};
        for (int i = 0; i < MANY; i += 2) {
            const vti_held held = {1 + i, -1 - i % 3, {0.01, 0.02, 0.0}, {0.0, 0.01, 0.0}, 0.003};
            assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        }
        const vti_friction friction = {
            .walls = &of, .sliding = 0.4, .rolling = 0.1, .twisting = 0.1, .history = &history};
        static const double zeta[3] = {0.1, 0.5, 0.9};
        vti_dashpots p = {.walls = &of,
                          .friction = trial % 3 ? &friction : NULL,
                          .zeta = 0.3,
                          .wall_zeta = trial % 5 ? zeta : NULL,
                          .ratio = 0.5,
                          .rolling = trial % 7 ? 0.1 : 0.0,
                          .twisting = trial % 7 ? 0.2 : 0.0,
                          .reach = trial % 4 ? 0.1 : INFINITY,
                          .lost = lost};
        vti_bodies b = vti_bodies_none(MANY);
        b.x = vti_view_packed(place_of[0]);
        b.v = vti_view_packed(velocity[0]);
        if (trial % 7)
            b.omega = vti_view_packed(spin[0]);
        b.mass = b.inertia = vti_scalars_array(diameter);
        const double drift = trial % 8 < 4 ? 0.05 : -0.05;
        vti_effect effect = vti_dashpots_effect(&p);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &b), VTI_OK);
        const vti_view by_component = {{v[0], v[1], v[2]}, 1, 0};
        b.v = by_component;
        if (trial % 7)
            b.omega = vti_view_packed(w[0]);
        p.lost = lost_too;
        of.work = &work[1];
        for (int64_t i = 0; i < MANY; ++i) {
            const vti_bodies slice = vti_bodies_slice(b, i, 1);
            assert_int_equal(vti_effects_flow(&effect, 1, 0.1, drift, &slice), VTI_OK);
        }
        for (int i = 0; i < 3 * MANY; ++i)
            assert_same_bits(&velocity[i / 3][i % 3], &v[i % 3][i / 3], 1);
        assert_same_bits(spin, w, 3 * MANY);
        for (int k = 0; k < VTI_DASHPOT_BOOKS; ++k) /* compensated: in any order within the rounding of the whole */
            assert_close(vti_sum_value(&lost[k]), vti_sum_value(&lost_too[k]), 4 * EPS * (1.0 + fabs(lost[k].high)));
        assert_close(vti_sum_value(&work[0]), vti_sum_value(&work[1]), 4 * EPS * (1.0 + fabs(work[0].high)));
        assert_true(lost[NORMAL].high > 0.0 && (trial % 2 == 0 || work[0].high != 0.0));
    }
}

enum { WALLS = 4 };

/** The springs of each body at each wall alone, as rows of a table. Returns how many hold something. */
static int expect_at_walls(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted,
                           vti_held held[MANY][WALLS])
{
    const vti_held none = {.i = 0};
    int holds = 0;
    for (int64_t w = 0; w < WALLS; ++w)
        for (int64_t i = 0; i < MANY; ++i) {
            struct vti_carry c = {.delta0 = 0.0};
            assert_true(vti_touch_wall(&c.touch, p->walls, b, w, i, INFINITY));
            if (c.touch.delta <= 0.0 && held[i][w].i == 0)
                continue;
            held[i][w].i = 1 + i;
            held[i][w].j = -1 - w;
            go_along_wall(&c, p->walls, b, drifted);
            hold_on(p, &c, vti_friction_of_wall(p, w), &held[i][w]);
            if (c.touch.delta <= 0.0)
                held[i][w] = none;
            holds += held[i][w].i != 0;
        }
    return holds;
}

/** Springs of bodies at walls that stand and move, all at once, have the bits of one after the other; also of bodies
 *  that a long drift has taken farther away than lists reach. */
TEST(springs_at_walls)
{
    static const double plane[WALLS - 1][4] = {{0.0, 0.0, 1.0, -0.8}, {0.6, 0.8, 0.0, -0.7}, {-1.0, 0.0, 0.0, -0.6}},
                                      cylinder[7] = {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.9},
                                      mu[WALLS] = {0.3, 0.0, 0.5, 0.4};
    static double alpha[MANY][3];
    rng g = rng_seed(41);
    for (int trial = 0; trial < 48; ++trial) {
        vti_sum lost[2][VTI_FRICTION_BOOKS] = {{{0.0, 0.0}}}, work[2] = {{0.0, 0.0}};
        vti_held table[512], held[MANY][WALLS];
        int64_t slot[512] = {0};
        vti_history history = {512, 0, 0, table, slot};
        double diameter[MANY];
        memset(held, 0, sizeof held);
        draw_crowd(&g);
        for (int i = 0; i < MANY; ++i)
            diameter[i] = uniform(&g, 0.1, 0.4);
        vti_wall_motion motion[WALLS] = {
            {.velocity = {0.1, 0.0, 0.2}, .spin = 0.3}, {.spin = 0.5}, {.spin = 0.1}, {.spin = 2.0}};
        vti_walls of = {.count = WALLS - 1,
                        .plane = plane[0],
                        .diameter = vti_scalars_array(diameter),
                        .stiffness = 3.0,
                        .cylinders = 1,
                        .cylinder = cylinder,
                        .motion = trial % 2 ? motion : NULL,
                        .work = &work[0]};
        vti_friction p = {.walls = &of,
                          .sliding = trial % 5 ? 0.4 : 0.0,
                          .mindlin = trial % 5 ? 0.8 : 0.0,
                          .rolling = trial % 3 ? 0.1 : 0.0,
                          .rolling_stiffness = 1.0,
                          .twisting = trial % 3 != 1 ? 0.1 : 0.0,
                          .twisting_stiffness = 1.0,
                          .reach = trial % 4 ? 0.01 : INFINITY,
                          .history = &history,
                          .lost = lost[0],
                          .wall_sliding = trial % 7 ? mu : NULL};
        vti_bodies b = bodies_of_crowd();
        b.alpha = vti_view_packed(alpha[0]);
        vti_effect effect = vti_friction_effect(&p);
        int holds = 0;
        for (int step = 0; step < 4; ++step) {
            const vti_drifted drifted = {.t = step == 3 ? 0.3 : 0.02, .law = 1 + trial % 4, .frame = VTI_FRAME_SPACE};
            for (int i = 0; i < 3 * MANY; ++i)
                place_of[i / 3][i % 3] += drifted.t * velocity[i / 3][i % 3];
            p.lost = lost[1];
            of.work = &work[1];
            holds = expect_at_walls(&p, &b, &drifted, held);
            p.lost = lost[0];
            of.work = &work[0];
            assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
            assert_int_equal(history.used, holds);
        }
        for (int64_t i = 0; i < MANY; ++i)
            for (int64_t w = 0; w < WALLS; ++w)
                if (held[i][w].i != 0)
                    assert_memory_equal(&held[i][w], vti_history_find(&history, 1 + i, -1 - w), sizeof held[i][w]);
        assert_true(holds > 10);
        assert_same_bits(lost[0], lost[1], 2 * VTI_FRICTION_BOOKS);
        assert_same_bits(&work[0], &work[1], 2);
    }
}

RUN_TESTS(cmocka_unit_test(order_of_the_pairs), cmocka_unit_test(order_of_the_bonds),
          cmocka_unit_test(springs_of_a_crowd), cmocka_unit_test(walls), cmocka_unit_test(springs_at_walls))
