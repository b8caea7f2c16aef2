/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What each body has lost: of pairs that stand apart from each other, some at a wall, each pair's books are what it
 * loses of its kinetic energy, halves are equal, and all else is what it is without these books, to the bit. */
#include "impact.h"
#include "troop.h"

enum { PAIRS = 37, BODIES = 2 * PAIRS, FORCES = 4 };

/** Pairs at a distance from each other, in lists that count bodies from 1, as Fortran does; every third one's first
 *  body is at a plane that moves and turns. */
struct world {
    crowd c;
    web w;
    double moments[BODIES][3], plane[4];
    vti_contacts contacts;
    vti_walls walls;
    vti_wall_motion motion;
    vti_friction friction;
    vti_history history;
    vti_held entries[256];
    int64_t slot[256];
    vti_sum lost[4], rubbed[3], work, of[BODIES][4], rubbing[BODIES][3], worked[BODIES];
    vti_bodies b;
};

static struct world on, off;
static const double diameter = 1;

static void make(struct world *m, uint64_t seed, int uneven)
{
    rng g = rng_seed(seed);
    memset(m, 0, sizeof *m);
    crowd_clear(&m->c, BODIES, CROWD_ALPHA);
    for (int p = 0; p < PAIRS; ++p) {
        double d[3] = {0, 0, 0};
        random_vector(&g, 1, d);
        d[2] = 1 + fabs(d[2]); /* the second one is above the plane */
        const double r = vti_norm(d), gap = uniform(&g, 0.8, 1.02);
        for (int k = 0; k < 3; ++k) {
            m->c.x[2 * p][k] = k == 0 ? 5 * p : k == 2 ? (p % 3 == 0 ? 0.45 : 5) : 0;
            m->c.x[2 * p + 1][k] = m->c.x[2 * p][k] + gap * d[k] / r;
        }
        m->w.pair[p][1 - p % 2] = 2 * p; /* body 0 is the second one of its pair, others are the first */
        m->w.pair[p][p % 2] = 2 * p + 1;
        m->w.moment[p] = m->w.axial[p] = m->w.shear[p] = uniform(&g, 1, 20);
    }
    for (int i = 0; i < BODIES; ++i) {
        m->c.mass[i] = uniform(&g, 0.5, 2);
        m->c.inertia[i] = uniform(&g, 0.1, 0.2);
        random_vector(&g, 1, m->c.v[i]);
        random_vector(&g, 2, m->c.omega[i]);
        for (int k = 0; k < 3; ++k)
            m->moments[i][k] = uniform(&g, 0.1, 0.15);
    }
    m->b = crowd_bodies(&m->c);
    if (uneven) {
        m->b.inertia.p = NULL;
        m->b.moments = vti_view_packed(m->moments[0]);
    }
    const vti_view x = vti_view_packed(m->c.x[0]);
    assert_int_equal(vti_bonds_rest(PAIRS, m->w.pair[0], 0, &x, m->w.rest[0], NULL), VTI_OK);
    web_terms(&m->w, PAIRS, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    web_base(&m->w, 1);
    m->contacts = (vti_contacts){.count = PAIRS,
                                 .pair = m->w.pair[0],
                                 .base = m->w.bonds.base,
                                 .diameter = vti_scalars_one(&diameter),
                                 .stiffness = 50};
    m->plane[2] = 1;
    m->motion = (vti_wall_motion){.velocity = {0.2, 0, 0.3}, .spin = 0.05};
    m->walls = (vti_walls){.count = 1,
                           .plane = m->plane,
                           .diameter = vti_scalars_one(&diameter),
                           .stiffness = 50,
                           .motion = &m->motion,
                           .work = &m->work};
    m->history = (vti_history){.slots = 256, .held = m->entries, .slot = m->slot};
    m->friction = (vti_friction){.contacts = &m->contacts,
                                 .walls = &m->walls,
                                 .sliding = 0.1,
                                 .stiffness = 40,
                                 .rolling = 0.05,
                                 .rolling_stiffness = 5,
                                 .twisting = 0.05,
                                 .twisting_stiffness = 5,
                                 .reach = INFINITY,
                                 .history = &m->history,
                                 .lost = m->rubbed};
}

static double kinetic(const vti_bodies *b, int first, int count)
{
    const vti_bodies part = vti_bodies_slice(*b, first, count);
    return vti_kinetic_translation(&part) + vti_kinetic_rotation(&part);
}

static double value(const vti_sum *sum, int count)
{
    double all = 0;
    for (int k = 0; k < count; ++k)
        all += vti_sum_value(&sum[k]);
    return all;
}

/** The same state and sums with and without books of bodies. */
static void assert_unchanged(void)
{
    assert_same_bits(on.c.v[0], off.c.v[0], 3 * BODIES);
    assert_same_bits(on.c.omega[0], off.c.omega[0], 3 * BODIES);
    assert_memory_equal(on.lost, off.lost, sizeof on.lost);
    assert_memory_equal(on.rubbed, off.rubbed, sizeof on.rubbed);
    assert_memory_equal(&on.work, &off.work, sizeof on.work);
}

/** Entry by entry the sum over the bodies is that of the effect: as many numbers, rounded once each. */
static void assert_sums(const vti_effect *e)
{
    for (int64_t k = 0; k < e->books; ++k) {
        double sum = 0, size = 0;
        for (int64_t i = 0; i < BODIES; ++i) {
            const double share = vti_sum_value(&e->by_body[e->of_body * i + k]);
            sum += share;
            size += fabs(share);
        }
        assert_true(size > 0);
        assert_close(sum, vti_sum_value(&e->booked[k]), BODIES * EPS * size);
    }
}

/* ---- flows, which lower the kinetic energy by what they book ----------------------------------------------------- */

enum flowing { TOUCHES, BONDS, MEDIUM };

static void flow_both(enum flowing which, double drift)
{
    struct world *const both[2] = {&on, &off};
    for (int k = 0; k < 2; ++k) {
        struct world *m = both[k];
        vti_sum *of = k == 0 ? m->of[0] : NULL;
        m->walls.by_body = k == 0 ? m->worked : NULL;
        const vti_dashpots dashpots = {.contacts = &m->contacts,
                                       .walls = &m->walls,
                                       .zeta = 0.3,
                                       .tangential = 2,
                                       .rolling = 0.5,
                                       .twisting = 0.4,
                                       .reach = INFINITY,
                                       .lost = m->lost,
                                       .by_body = of};
        const vti_bond_dashpots bonds = {.bonds = &m->w.bonds, .zeta = 0.4, .lost = m->lost, .by_body = of};
        const vti_scalars one = vti_scalars_one(&diameter);
        const vti_drag drag = {.linear = one, .quadratic = one, .angular = one, .lost = m->lost, .by_body = of};
        const vti_effect effect = which == TOUCHES ? vti_dashpots_effect(&dashpots)
                                  : which == BONDS ? vti_bond_dashpots_effect(&bonds)
                                                   : vti_drag_effect(&drag);
        assert_true(effect.by_body == of);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.05, drift, &m->b), VTI_OK);
        if (k == 0)
            assert_sums(&effect);
        if (k == 0)
            assert_close(vti_booked_of_body(&effect, 1, 5), value(of + 5 * effect.of_body, (int)effect.books), 8 * EPS);
    }
    assert_unchanged();
}

/** By touches, bonds and a medium, of spheres and of bodies of any inertia, forwards and backwards. */
TEST(flows)
{
    for (int kind = 0; kind < 12; ++kind) {
        const enum flowing which = (enum flowing)(kind % 3);
        const int uneven = kind / 3 % 2, books = which == MEDIUM ? 2 : 4;
        double before[PAIRS];
        make(&on, 77, uneven);
        make(&off, 77, uneven);
        for (int p = 0; p < PAIRS; ++p)
            before[p] = kinetic(&on.b, 2 * p, 2);
        flow_both(which, kind < 6 ? 1e-3 : -1e-3);
        const vti_sum *of = on.of[0]; /* entries of a body lie one behind the other */
        for (int p = 0; p < PAIRS; ++p) {
            const vti_sum *i = of + 2 * p * books, *j = i + books;
            const double lost = value(i, books) + value(j, books) + value(&on.worked[2 * p], 2);
            const double after = kinetic(&on.b, 2 * p, 2);
            assert_close(before[p] - after, lost, 400 * EPS * (before[p] + after)); /* operations of a touch */
            assert_true(which == MEDIUM || p % 3 == 0 || memcmp(i, j, (size_t)books * sizeof *i) == 0);
            assert_true((which == TOUCHES && p % 3 == 0) == (on.worked[2 * p].high != 0));
            assert_true(on.worked[2 * p + 1].high == 0);
        }
    }
}

/** Drag takes from each body what that body loses. */
TEST(each_body_to_the_medium)
{
    double before[BODIES];
    make(&on, 78, 0);
    make(&off, 78, 0);
    for (int i = 0; i < BODIES; ++i)
        before[i] = kinetic(&on.b, i, 1);
    flow_both(MEDIUM, 1);
    const vti_sum *of = on.of[0]; /* entries of a body lie one behind the other */
    for (int i = 0; i < BODIES; ++i)
        assert_close(value(of + 2 * i, 2), before[i] - kinetic(&on.b, i, 1), 40 * EPS * before[i]);

    const vti_scalars one = vti_scalars_one(&diameter); /* and of a slice from its own */
    const vti_drag drag = {.linear = one, .lost = on.lost, .by_body = on.of[0]};
    const vti_effect effect = vti_drag_effect(&drag);
    const vti_bodies some = vti_bodies_slice(on.b, 5, 7);
    const crowd was = on.c;
    memset(on.of, 0, sizeof on.of);
    assert_int_equal(vti_effects_flow(&effect, 1, 0.05, 1, &some), VTI_OK);
    for (int i = 0; i < BODIES; ++i) {
        const int in_slice = i >= 5 && i < 12;
        assert_true((memcmp(on.c.v[i], was.v[i], sizeof was.v[i]) != 0) == in_slice);
        assert_true((vti_booked_of_body(&effect, 1, i) != 0) == in_slice);
    }
}

/** Of a medium that only slows turning, books of bodies are those of that, beside which an entry is left out. */
TEST(each_body_that_turns)
{
    double before[BODIES];
    make(&on, 83, 0);
    const vti_drag drag = {.angular = vti_scalars_one(&diameter), .lost = on.lost, .by_body = on.of[0]};
    const vti_effect effect = vti_drag_effect(&drag);
    for (int i = 0; i < BODIES; ++i)
        before[i] = kinetic(&on.b, i, 1);
    assert_int_equal(vti_effects_flow(&effect, 1, 0.05, 1, &on.b), VTI_OK);
    assert_sums(&effect);
    for (int i = 0; i < BODIES; ++i)
        assert_close(vti_booked_of_body(&effect, 1, i), before[i] - kinetic(&on.b, i, 1), 40 * EPS * before[i]);
}

/** And from the spheres of each clump what that clump loses. */
TEST(each_clump_to_the_medium)
{
    static troop t;
    static vti_sum of[CROWD_MAX][VTI_DRAG_BOOKS];
    static double before[CROWD_MAX];
    rng g = rng_seed(81);
    const double coefficient = 0.3;
    vti_sum lost[VTI_DRAG_BOOKS] = {{0, 0}};
    troop_draw(&t, &g, 12, 3, 1, CROWD_ALPHA, CROWD_ALPHA);
    const vti_scalars each = vti_scalars_one(&coefficient);
    const vti_drag drag = {.linear = each, .quadratic = each, .angular = each, .lost = lost, .by_body = of[0]};
    const vti_effect inner = vti_drag_effect(&drag);
    const vti_clumped clumped = {&t.clumps, &inner};
    const vti_effect effect = vti_clumped_effect(&clumped);
    const vti_bodies b = crowd_bodies(&t.c);
    assert_true(effect.by_body == NULL && t.s.n > 12);
    for (int i = 0; i < t.c.n; ++i)
        before[i] = kinetic(&b, i, 1);
    for (int step = 0; step < 2; ++step)
        assert_int_equal(vti_effects_flow(&effect, 1, 0.05, step == 0 ? 1e-3 : -1e-3, &b), VTI_OK);
    for (int s = 0; s < t.s.n; ++s) /* each clump gives back what its spheres have taken */
        before[t.body[s]] -= vti_booked_of_body(&inner, 1, s);
    for (int i = 0; i < t.c.n; ++i) /* six flows of 200 operations at most */
        assert_close(before[i], kinetic(&b, i, 1), 1200 * EPS * (before[i] + 1));
}

/* ---- friction ---------------------------------------------------------------------------------------------------- */

static double by_pair[PAIRS + 1][VTI_FRICTION_BOOKS], told[PAIRS][VTI_FRICTION_BOOKS];

/** Over drifts in which springs stretch and slide, touches begin and end. told: what pairs have lost is told pair by
 *  pair. */
static void rub(int tells, int uneven)
{
    const vti_drifted drifted = {.t = 0.02, .law = VTI_LAW_EXACT9, .frame = VTI_FRAME_SPACE};
    make(&on, 79, uneven);
    make(&off, 79, uneven);
    memset(told, 0, sizeof told);
    by_pair[PAIRS][0] = 7; /* behind them, which stays */
    on.friction.by_body = on.rubbing[0];
    on.friction.by_pair = tells ? by_pair[0] : NULL;
    on.walls.by_body = on.worked;
    const vti_effect with = vti_friction_effect(&on.friction), without = vti_friction_effect(&off.friction);
    for (int step = 0; step < 12; ++step) {
        assert_int_equal(vti_drift(VTI_LAW_EXACT9, VTI_FRAME_SPACE, drifted.t, &on.b, NULL), VTI_OK);
        assert_int_equal(vti_drift(VTI_LAW_EXACT9, VTI_FRAME_SPACE, drifted.t, &off.b, NULL), VTI_OK);
        assert_int_equal(vti_effects_carry(&with, 1, &drifted, &on.b), VTI_OK);
        assert_int_equal(vti_effects_carry(&without, 1, &drifted, &off.b), VTI_OK);
        assert_unchanged();
        for (int p = 0; p < PAIRS && tells; ++p)
            for (int k = 0; k < VTI_FRICTION_BOOKS; ++k)
                told[p][k] += by_pair[p][k];
    }
    assert_true(on.history.used == off.history.used && on.work.high != 0 && by_pair[PAIRS][0] == 7);
    if (!tells)
        assert_sums(&with);
}

/** Halves are equal where there is no plane, and what pairs are told to have lost is what their bodies have. */
static void share(int uneven)
{
    static vti_sum shared[BODIES][VTI_FRICTION_BOOKS];
    rub(0, uneven);
    memcpy(shared, on.rubbing, sizeof shared);
    rub(1, uneven);
    for (int p = 0; p < PAIRS; ++p) {
        const int i = 2 * p, j = i + 1, at_plane = p % 3 == 0;
        assert_true((on.worked[i].high != 0) == at_plane && on.worked[j].high == 0);
        assert_true((on.rubbing[i][0].high != 0) == at_plane && on.rubbing[j][0].high == 0);
        assert_true(at_plane || memcmp(shared[i], shared[j], sizeof shared[i]) == 0);
        for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) /* of 12 drifts */
            for (int side = 0; side < 2; ++side)
                assert_close(vti_sum_value(&shared[i + side][k]),
                             vti_sum_value(&on.rubbing[i + side][k]) + 0.5 * told[p][k],
                             12 * EPS * (told[p][k] + vti_sum_value(&shared[i + side][k])));
    }
}

TEST(friction)
{
    share(0);
    share(1); /* bodies whose turns are known before */
}

/* ---- walls that move --------------------------------------------------------------------------------------------- */

/** What a wall puts into each body is what it puts into that body alone. */
TEST(walls)
{
    const vti_drifted drifted = {.t = 0.02, .law = VTI_LAW_EXACT9, .frame = VTI_FRAME_SPACE};
    make(&on, 82, 0);
    make(&off, 82, 0);
    on.walls.by_body = on.worked;
    const vti_effect with = vti_walls_effect(&on.walls), without = vti_walls_effect(&off.walls);
    for (int step = 0; step < 12; ++step) {
        assert_int_equal(vti_drift(VTI_LAW_EXACT9, VTI_FRAME_SPACE, drifted.t, &on.b, NULL), VTI_OK);
        const vti_wall_motion motion = on.motion;
        assert_int_equal(vti_effects_carry(&with, 1, &drifted, &on.b), VTI_OK);
        for (int i = 0; i < BODIES; ++i) {
            off.motion = motion; /* which a carry moves */
            const vti_bodies alone = vti_bodies_slice(on.b, i, 1);
            memset(&off.work, 0, sizeof off.work);
            assert_int_equal(vti_effects_carry(&without, 1, &drifted, &alone), VTI_OK);
            vti_sum_add(&off.worked[i], vti_sum_value(&off.work));
        }
    }
    assert_sums(&with);
    for (int i = 0; i < BODIES; ++i) {
        assert_true((i % 6 == 0) == (on.worked[i].high != 0));
        assert_close(vti_sum_value(&on.worked[i]), vti_sum_value(&off.worked[i]), 12 * EPS * fabs(on.worked[i].high));
    }
}

/* ---- rupture ----------------------------------------------------------------------------------------------------- */

/** Of what a bond held when it broke each of its bodies has half. */
TEST(rupture)
{
    static int64_t id[PAIRS];
    static double energy[PAIRS], limit;
    make(&on, 80, 0);
    for (int p = 0; p < PAIRS; ++p) {
        vti_bonds one = on.w.bonds;
        const vti_effect bond = vti_bonds_effect(&one);
        double terms[3];
        on.c.x[2 * p][0] += 0.01 * p;
        one.count = 1;
        one.pair += 2 * p;
        one.rest += 4 * p;
        one.moment.p += p;
        one.axial.p += p;
        one.shear.p += p;
        bond.energy(&one, &on.b, terms);
        energy[p] = terms[0] + terms[1] + terms[2];
        limit = p == PAIRS / 2 ? energy[p] : limit;
        id[p] = p + one.base;
    }
    const vti_rupture rupture = {
        .bonds = &on.w.bonds, .id = id, .energy = vti_scalars_one(&limit), .lost = on.lost, .by_body = on.worked};
    const vti_effect effect = vti_rupture_effect(&rupture);
    int64_t broken;
    assert_int_equal(vti_effects_rupture(&effect, 1, &on.b, &broken), VTI_OK);
    assert_in_range(broken, 1, PAIRS - 1);
    for (int i = 0; i < BODIES; ++i)
        assert_close(vti_sum_value(&on.worked[i]), energy[i / 2] >= limit ? 0.5 * energy[i / 2] : 0,
                     4 * EPS * energy[i / 2]);
    assert_sums(&effect);
}

/** What every call refuses has no sum. */
TEST(books_without_memory)
{
    const vti_drag drag = {.linear = vti_scalars_one(&diameter), .lost = on.lost};
    vti_effect effect = vti_drag_effect(&drag);
    effect.booked = NULL;
    assert_true(effect.books > 0 && isnan(vti_booked(&effect, 1)));
    effect.booked = on.lost;
    effect.by_body = on.of[0];
    effect.of_body = effect.books - 1;
    assert_true(isnan(vti_booked_of_body(&effect, 1, 0)) && !isnan(vti_booked(&effect, 1)));
}

RUN_TESTS(cmocka_unit_test(flows), cmocka_unit_test(each_body_to_the_medium), cmocka_unit_test(each_body_that_turns),
          cmocka_unit_test(each_clump_to_the_medium), cmocka_unit_test(friction), cmocka_unit_test(walls),
          cmocka_unit_test(rupture), cmocka_unit_test(books_without_memory))
