/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Memory for a list of pairs (vti_touching) changes no bit, whatever happens between two steps: other pairs of the same
 * number, other bodies' numbers, a table of another size or with its touches elsewhere, bodies put elsewhere; and what is
 * kept there is used. */
#include "support.h"

enum { EDGE = 4, LAYERS = 5, N = EDGE * EDGE * LAYERS, MOST = N * (N - 1) / 2, SLOTS = 512, STEPS = 160 };

/** A block of spheres that touch and slide; of its own all that steps change. */
struct world {
    double x[N][3], v[N][3], omega[N][3], alpha[N][3], force[N][3], moment[N][3];
    vti_held slot[2][2 * SLOTS];
    vti_history history;
    vti_sum lost[4], rubbed[3];
    vti_touching touching[2]; /* of friction and of dashpots */
    int64_t memory[2][8 * MOST];
    int64_t pair[MOST][2];
    vti_contacts contacts;
    vti_friction friction;
    vti_dashpots dashpots;
    vti_bodies b;
};

static struct world with, without;
static double diameter[N];
static const double one = 1.0, inertia = 0.1, stiffness_of_all = 300.0;

static void make(struct world *m, int shared)
{
    rng g = rng_seed(71);
    memset(m, 0, sizeof *m);
    m->b = vti_bodies_none(N);
    for (int64_t i = 0; i < N; ++i) {
        const int64_t at[3] = {i % EDGE, i / EDGE % EDGE, i / (EDGE * EDGE)};
        diameter[i] = uniform(&g, 0.95, 1.05);
        for (int k = 0; k < 3; ++k)
            m->x[i][k] = 0.98 * (double)at[k] + uniform(&g, -0.02, 0.02);
        random_vector(&g, 0.5, m->v[i]);
        for (int k = 0; k < 3; ++k)
            m->v[i][k] -= 0.2 * (m->x[i][k] - 1.5); /* inwards */
        random_vector(&g, 2.0, m->omega[i]);
    }
    m->b.x = vti_view_packed(m->x[0]);
    m->b.v = vti_view_packed(m->v[0]);
    m->b.alpha = vti_view_packed(m->alpha[0]);
    m->b.omega = vti_view_packed(m->omega[0]);
    m->b.force = vti_view_packed(m->force[0]);
    m->b.moment = vti_view_packed(m->moment[0]);
    m->b.mass = vti_scalars_one(&one);
    m->b.inertia = vti_scalars_one(&inertia);
    m->contacts =
        (vti_contacts){.pair = m->pair[0], .diameter = vti_scalars_array(diameter), .stiffness = stiffness_of_all};
    m->history = (vti_history){.slots = SLOTS, .slot = m->slot[0]};
    for (int k = 0; k < 2; ++k)
        m->touching[k] = (vti_touching){.room = 8 * MOST, .memory = m->memory[k]};
    m->friction = (vti_friction){.contacts = &m->contacts,
                                 .sliding = 0.4,
                                 .mindlin = 0.8,
                                 .rolling = 0.05,
                                 .rolling_stiffness = 5.0,
                                 .reach = 0.3,
                                 .history = &m->history,
                                 .lost = m->rubbed,
                                 .touching = &m->touching[0]};
    m->dashpots = (vti_dashpots){.contacts = &m->contacts,
                                 .friction = &m->friction,
                                 .zeta = 0.2,
                                 .ratio = 0.5,
                                 .rolling = 0.01,
                                 .reach = 0.3,
                                 .lost = m->lost,
                                 .touching = &m->touching[shared ? 0 : 1]};
}

/** The pairs whose centres are less than that apart. */
static void list_pairs(struct world *m, double far)
{
    m->contacts.count = 0;
    for (int64_t i = 0; i < N; ++i)
        for (int64_t j = i + 1; j < N; ++j) {
            const double d[3] = {m->x[i][0] - m->x[j][0], m->x[i][1] - m->x[j][1], m->x[i][2] - m->x[j][2]};
            int64_t *const pair = m->pair[m->contacts.count];
            pair[0] = i + m->contacts.base;
            pair[1] = j + m->contacts.base;
            m->contacts.count += vti_dot(d, d) < far * far;
        }
}

/** The touches go to the other half of the memory, in another order, into a table of so many slots. */
static void move_table(struct world *m, int64_t slots)
{
    vti_history next = {.slots = slots, .slot = m->history.slot == m->slot[0] ? m->slot[1] : m->slot[0]};
    memset(next.slot, 0, sizeof m->slot[0]);
    for (int64_t k = m->history.slots - 1; k >= 0; --k)
        if (m->history.slot[k].i != 0)
            assert_int_equal(vti_history_add(&next, &m->history.slot[k]), VTI_OK);
    m->history = next;
}

/** What a host may do between two steps. */
static void disturb(struct world *m, int step)
{
    if (step % 7 == 3) /* the same number of pairs, in another order: pairs of a number are others */
        for (int64_t k = 0; k + 1 < m->contacts.count; k += 2)
            for (int side = 0; side < 2; ++side) {
                const int64_t other = m->pair[k][side];
                m->pair[k][side] = m->pair[k + 1][side];
                m->pair[k + 1][side] = other;
            }
    if (step % 10 == 0)
        list_pairs(m, step % 40 == 0 ? 100.0 : 1.6);
    if (step % 23 == 22) {
        m->contacts.base = 1 - m->contacts.base;
        list_pairs(m, 1.5);
    }
    if (step % 11 == 10)
        move_table(m, step % 22 == 10 ? 2 * SLOTS : SLOTS);
    if (step % 13 == 12)
        for (int k = 0; k < 3; ++k)
            m->x[step % N][k] += 0.05;
    if (step == 100) /* too little: it is not used */
        m->touching[0].room = 5;
    if (step == 110)
        m->touching[0].room = 8 * MOST;
}

static void step_on(struct world *m)
{
    const vti_stepper *const method = vti_stepper_find("vti2");
    const vti_effect effects[] = {vti_contacts_effect(&m->contacts), vti_friction_effect(&m->friction),
                                  vti_dashpots_effect(&m->dashpots)};
    assert_int_equal(vti_effects_begin(method, 0.004, effects, 3, &m->b, NULL), VTI_OK);
    assert_int_equal(vti_apply(effects, 3, &m->b), VTI_OK);
    assert_int_equal(vti_effects_finish(method, 0.004, effects, 3, &m->b), VTI_OK);
}

static void same_bits(int shared)
{
    int64_t most = 0, pairs = 0;
    make(&with, shared);
    make(&without, shared);
    without.friction.touching = without.dashpots.touching = NULL;
    for (int step = 0; step < STEPS; ++step) {
        disturb(&with, step);
        disturb(&without, step);
        step_on(&with);
        step_on(&without);
        assert_same_bits(with.x[0], without.x[0], 3 * N);
        assert_same_bits(with.v[0], without.v[0], 3 * N);
        assert_same_bits(with.omega[0], without.omega[0], 3 * N);
        assert_memory_equal(with.lost, without.lost, sizeof with.lost);
        assert_memory_equal(with.rubbed, without.rubbed, sizeof with.rubbed);
        assert_int_equal(with.history.used, without.history.used);
        most = with.history.used > most ? with.history.used : most;
        pairs = with.contacts.count > pairs ? with.contacts.count : pairs;
    }
    assert_true(most > 100 && pairs == MOST && with.rubbed[0].high > 0.0 && with.lost[1].high > 0.0);
}

static void bits_of_one_for_both_effects(void **state)
{
    (void)state;
    same_bits(1);
}

static void bits_of_one_for_each(void **state)
{
    (void)state;
    same_bits(0);
}

/** A list that the memory says is kept there is not copied again: the memory is as it was, but for slots. */
static void it_is_used(void **state)
{
    (void)state;
    make(&with, 1);
    list_pairs(&with, 1.6);
    for (int step = 0; step < 3; ++step)
        step_on(&with);
    const int64_t room = vti_touching_room(with.contacts.count);
    int64_t changed = 0;
    memcpy(without.memory[0], with.memory[0], sizeof with.memory[0]);
    step_on(&with);
    for (int64_t n = 0; n < room; ++n)
        changed += with.memory[0][n] != without.memory[0][n];
    assert_true(changed < with.contacts.count / 4);
    assert_true(memcmp(with.memory[0] + room, with.memory[1], sizeof(int64_t)) == 0); /* and no more than that */
    assert_int_equal(vti_touching_room(0), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bits_of_one_for_both_effects),
                                       cmocka_unit_test(bits_of_one_for_each), cmocka_unit_test(it_is_used)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
