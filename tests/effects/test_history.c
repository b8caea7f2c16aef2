/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What many touches hold: where it stands in memory, which is the order of the list after a while, and that nothing
 * depends on it. */
#include "support.h"

#include "../../src/contacts/vti_history.h"

enum { BODIES = 9000, PAIRS = BODIES - 1, SLOTS = 16384, FAR = 15, PIECE = 256 };

static double x[BODIES][3], v[BODIES][3], omega[BODIES][3], alpha[BODIES][3];
static int64_t chain[PAIRS][2], listed[PAIRS * (1 + FAR)][2], slot[2][SLOTS];
static vti_held entries[2][SLOTS];
static vti_sum rubbed[2][VTI_FRICTION_BOOKS], damped[2][VTI_DASHPOT_BOOKS];
static vti_history history[2];
static vti_contacts contacts;
static const double one = 1.0;

/** A chain along x, whose neighbours overlap by a tenth. */
static vti_bodies draw(rng *g)
{
    for (int i = 0; i < BODIES; ++i) {
        const double there[3] = {0.9 * i, 0.0, 0.0};
        memcpy(x[i], there, sizeof there);
        random_vector(g, 0.1, v[i]);
        random_vector(g, 0.1, omega[i]);
    }
    for (int k = 0; k < PAIRS; ++k) {
        chain[k][0] = k;
        chain[k][1] = k + 1;
    }
    vti_bodies b = vti_bodies_none(BODIES);
    b.x = vti_view_packed(x[0]);
    b.v = vti_view_packed(v[0]);
    b.omega = vti_view_packed(omega[0]);
    b.alpha = vti_view_packed(alpha[0]);
    b.mass = b.inertia = vti_scalars_one(&one);
    contacts = (vti_contacts){.count = PAIRS, .pair = chain[0], .diameter = vti_scalars_one(&one), .stiffness = 1.0};
    return b;
}

static void empty(int64_t k)
{
    memset(slot[k], 0, sizeof slot[k]);
    memset(rubbed[k], 0, sizeof rubbed[k]);
    memset(damped[k], 0, sizeof damped[k]);
    history[k] = (vti_history){SLOTS, 0, 0, entries[k], slot[k]};
}

static vti_friction friction_of(int64_t k)
{
    const vti_friction friction = {.contacts = &contacts,
                                   .sliding = 0.5,
                                   .stiffness = 0.5,
                                   .reach = 0.25,
                                   .history = &history[k],
                                   .lost = rubbed[k]};
    return friction;
}

static void shuffle(rng *g, int64_t (*pair)[2], int64_t count)
{
    for (int64_t k = count - 1; k > 0; --k) {
        const int64_t other = rng_below(g, (int)k + 1), i = pair[k][0], j = pair[k][1];
        memcpy(pair[k], pair[other], sizeof pair[k]);
        pair[other][0] = i;
        pair[other][1] = j;
    }
}

/** Springs carried by a list that changes its order have the loads of those by one that stays, and come into its
 *  order. */
TEST(order_of_the_list)
{
    const vti_drifted drifted = {.t = 0.01, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    rng g = rng_seed(2909);
    vti_bodies b = draw(&g);
    for (int k = 0; k < 2; ++k)
        empty(k);
    for (int step = 0; step < 4; ++step) {
        if (step % 2 == 1)
            shuffle(&g, chain, PAIRS);
        for (int k = 0; k < 2; ++k) {
            const vti_friction friction = friction_of(k);
            const vti_effect effect = vti_friction_effect(&friction);
            contacts.pair = k == 0 ? chain[0] : listed[0];
            if (k == 1 && step == 0)
                memcpy(listed, chain, sizeof chain);
            assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
        }
        for (int64_t k = 0; k < PAIRS; ++k)
            assert_true(vti_history_is(&entries[0][k], 1 + chain[k][0], 1 + chain[k][1]) &&
                        memcmp(&entries[0][k], vti_history_find(&history[1], entries[0][k].i, entries[0][k].j),
                               sizeof entries[0][k]) == 0);
    }
    assert_true(history[0].used == PAIRS && history[1].used == PAIRS);
}

/** Of pairs that part at once, many one behind the other, nothing is left, and of the others all. */
TEST(many_part)
{
    const vti_drifted drifted = {.t = 0.01, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    rng g = rng_seed(2911);
    vti_bodies b = draw(&g);
    empty(0);
    const vti_friction friction = friction_of(0);
    const vti_effect effect = vti_friction_effect(&friction);
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
    assert_int_equal(history[0].used, PAIRS);
    int64_t stay = 0;
    for (int i = 0; i < BODIES; ++i) /* apart, but for one of seven */
        x[i][0] = 1.05 * i - 0.1 * (i % 7 == 3);
    for (int round = 0; round < 2; ++round) {
        assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
        stay = 0;
        for (int64_t k = 0; k < PAIRS; ++k) {
            const int holds = vti_history_find(&history[0], 1 + k, 2 + k) != NULL;
            assert_int_equal(holds, x[k + 1][0] - x[k][0] < 1.0);
            stay += holds;
        }
        assert_int_equal(history[0].used, stay);
    }
    int64_t taken = 0;
    for (int64_t k = 0; k < SLOTS; ++k)
        taken += slot[0][k] != 0;
    assert_true(taken == stay && stay > PAIRS / 8);
}

/** Dashpots of all pairs at once, also where the list has others far apart between them, as window by window with no
 *  more than its own springs: the same bits. */
TEST(springs_between_dashpots)
{
    static double start[BODIES][3], first[BODIES][3];
    for (int far = 0; far < 2; ++far)
        for (int piece = 0; piece < 2; ++piece) {
            rng g = rng_seed(2910);
            vti_bodies b = draw(&g);
            vti_friction friction = friction_of(0);
            vti_dashpots dashpots = {
                .contacts = &contacts, .friction = &friction, .zeta = 0.1, .ratio = 0.5, .reach = 0.25};
            vti_effect effect = {0};
            dashpots.lost = damped[0];
            empty(0);
            memcpy(start, v, sizeof v);
            for (int64_t k = 0; k < PAIRS; ++k) {
                const vti_held held = {1 + k, 2 + k, {0.0, 0.015 * uniform(&g, -1, 1), 0.0}, {0.0, 0.0, 0.0}, 0.0};
                for (int n = 0; n < (far ? 1 + FAR : 1); ++n) {
                    int64_t *const pair = listed[far ? k * (1 + FAR) + n : k];
                    pair[0] = n == 0 ? k : 0;
                    pair[1] = n == 0 ? k + 1 : BODIES - 1;
                }
                if (!piece)
                    assert_int_equal(vti_history_add(&history[0], &held), VTI_OK);
                else
                    entries[1][k] = held;
            }
            contacts.pair = listed[0];
            contacts.count = far ? PAIRS * (1 + FAR) : PAIRS;
            effect = vti_dashpots_effect(&dashpots);
            if (!piece)
                effect.flow(effect.self, &b, 0.01, 0.01);
            for (int64_t k = 0; piece && k < PAIRS; k += PIECE) {
                const int64_t some = PAIRS - k < PIECE ? PAIRS - k : PIECE;
                empty(0);
                for (int64_t n = 0; n < some; ++n)
                    assert_int_equal(vti_history_add(&history[0], &entries[1][k + n]), VTI_OK);
                contacts.pair = listed[far ? k * (1 + FAR) : k];
                contacts.count = far ? some * (1 + FAR) : some;
                effect.flow(effect.self, &b, 0.01, 0.01);
            }
            if (far == 0 && piece == 0)
                memcpy(first, v, sizeof v);
            assert_memory_equal(v, first, sizeof v);
        }
    assert_true(memcmp(start, first, sizeof start) != 0);
}

RUN_TESTS(cmocka_unit_test(order_of_the_list), cmocka_unit_test(many_part), cmocka_unit_test(springs_between_dashpots))
