/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Touches done many at once, by the kernels of every vector width, have the bits of one after the other: all layouts
 * and laws, materials, pairs that part, that meet, that pass through each other and that no list need have. The
 * kernels' tables are private to the library. */
#include "support.h"

#include "../../src/dissipation/vti_bond_flow.h"
#include "../../src/contacts/vti_touch.h"
#include "../../src/dissipation/vti_carry.h"
#include "../../src/dissipation/vti_dashpot_flow.h"
#include "../../src/dissipation/vti_touch_table.h"

enum { PAIRS = 21, N = 2 * PAIRS, ROOM = 8 * N };
enum { PACKED, SEPARATE, STRIDED, LAYOUTS };

static struct {
    double all[4][ROOM], diameter[N], modulus[N], length[PAIRS];
    int64_t pair[PAIRS][2];
    vti_held held[2 * PAIRS];
} bodies, start;

static vti_view view_in(int layout, double *p)
{
    const vti_view strided = {{p + 4, p + 1, p + 7}, 8, 0};
    return layout == PACKED     ? vti_view_packed(p)
           : layout == SEPARATE ? vti_view_separate(p, p + N, p + 2 * N)
                                : strided;
}

static vti_bodies bodies_in(int layout)
{
    vti_bodies b = vti_bodies_none(N);
    b.x = view_in(layout, bodies.all[0]);
    b.v = view_in(layout, bodies.all[1]);
    b.omega = view_in(layout, bodies.all[2]);
    return b;
}

static void put(const vti_view *view, int64_t i, double x, double y, double z)
{
    const double r[3] = {x, y, z};
    for (int k = 0; k < 3; ++k)
        view->c[k][i * view->stride] = r[k];
}

/** Pairs of bodies of their own, about as far apart as they touch; the first pass through each other in a drift of 0.5,
 *  the second come from afar, the third leave. */
static void draw(rng *g, const vti_bodies *b)
{
    for (int64_t k = 0; k < PAIRS; ++k) {
        const int64_t i = 2 * k + k % 2, j = 2 * k + 1 - k % 2;
        double n[3], f[3];
        bodies.pair[k][0] = 1 + i;
        bodies.pair[k][1] = 1 + j;
        bodies.length[k] = uniform(g, 0.9, 1.1);
        for (int s = 0; s < 2; ++s) {
            bodies.diameter[2 * k + s] = uniform(g, 0.8, 1.2);
            bodies.modulus[2 * k + s] = uniform(g, 1, 3);
            put(&b->omega, 2 * k + s, uniform(g, -3, 3), uniform(g, -3, 3), uniform(g, -3, 3));
            put(&b->v, 2 * k + s, uniform(g, -0.1, 0.1), uniform(g, -0.1, 0.1), uniform(g, -0.1, 0.1));
            put(&b->x, 2 * k + s, 0.0, 0.0, 0.0);
        }
        random_unit(g, 3, n);
        const double r = uniform(g, 0.7, 1.0);
        put(&b->x, i, k ? r * n[0] : 0.5, k ? r * n[1] : 0.0, k ? r * n[2] : 0.0);
        if (k < 3)
            put(&b->v, j, 0.0, 0.0, 0.0);
        if (k == 0)
            put(&b->v, i, 2.0, 0.0, 0.0);
        else if (k < 3)
            put(&b->v, i, (k == 1 ? -9.0 : 1.0) * n[0], (k == 1 ? -9.0 : 1.0) * n[1], (k == 1 ? -9.0 : 1.0) * n[2]);
        if (k == 2)
            put(&b->x, i, 1.3 * n[0], 1.3 * n[1], 1.3 * n[2]);
        random_unit(g, 3, f);
        const double size = k % 4 == 3 ? 0.0 : uniform(g, 0, 0.2);
        const double along = k ? vti_dot(f, n) : f[0];
        vti_held *const held = &bodies.held[k];
        held->i = 1 + i;
        held->j = 1 + j;
        held->twisting = size * uniform(g, -1, 1);
        for (int c = 0; c < 3; ++c) {
            const double normal = k ? n[c] : c == 0;
            held->sliding[c] = size * (f[c] - along * normal);
            held->rolling[c] = 0.3 * held->sliding[c];
        }
    }
}

/** All springs of one touch, and what they take. */
static void hold_on(const vti_friction *p, const struct vti_carry *c, double mu, vti_held *held)
{
    const double coefficient[VTI_FRICTION_BOOKS] = {p->sliding, p->rolling, p->twisting};
    struct vti_loads loads = {.twisting = held->twisting};
    struct vti_taken taken;
    memcpy(loads.sliding, held->sliding, sizeof loads.sliding);
    memcpy(loads.rolling, held->rolling, sizeof loads.rolling);
    vti_carry_loads(p, c, mu, &loads, &taken);
    memcpy(held->sliding, loads.sliding, sizeof loads.sliding);
    memcpy(held->rolling, loads.rolling, sizeof loads.rolling);
    held->twisting = loads.twisting;
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) {
        if (coefficient[k] > 0.0)
            vti_sum_add(&p->lost[k], taken.lost[k]);
    }
    if (c->touch.j < 0 && c->touch.moves)
        vti_sum_add(p->walls->work, taken.worked[0] + taken.worked[1] + taken.worked[2]);
}

/** The increments of attitude of a body and of what it touches, by the law. */
static void turn_both(const vti_drifted *drifted, const double w_i[3], const double w_j[3], double a_i[3],
                      double a_j[3])
{
    vti_drift_increment((int)drifted->law, drifted->t, w_i, a_i);
    vti_drift_increment((int)drifted->law, drifted->t, w_j, a_j);
}

/** What one pair has been through. */
static void go_along(struct vti_carry *c, const vti_bodies *b, const vti_drifted *drifted)
{
    struct vti_touch_motion m;
    double d0[3], a_i[3], a_j[3];
    vti_touch_load(&c->touch, b, &m);
    for (int k = 0; k < 3; ++k)
        c->slid[k] = drifted->t * (m.v_i[k] - m.v_j[k]);
    turn_both(drifted, m.w_i, m.w_j, a_i, a_j);
    vti_carry_apart(c, c->slid, d0);
    vti_carry_stretch(c, d0, a_i, a_j);
}

/** What one body at a wall has. */
static void go_along_wall(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b, const vti_drifted *drifted)
{
    double x[3], v[3], w[3], d0[3], a_i[3], a_j[3];
    vti_load(&b->x, c->touch.i, x);
    vti_load(&b->v, c->touch.i, v);
    vti_load(&b->omega, c->touch.i, w);
    turn_both(drifted, w, c->touch.w_j, a_i, a_j);
    for (int k = 0; k < 3 && c->touch.wall < walls->count; ++k) {
        a_i[k] = drifted->t * w[k];
        a_j[k] = drifted->t * c->touch.w_j[k];
    }
    vti_carry_at_wall(c, walls, drifted->t, x, v, a_j, d0);
    vti_carry_stretch(c, d0, a_i, a_j);
}

/** The springs of each pair alone. */
static void expect(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, vti_held *held,
                   double delta[PAIRS])
{
    for (int64_t k = 0; k < PAIRS; ++k) {
        struct vti_carry c = {.delta0 = 0.0};
        assert_true(vti_touch_pair(&c.touch, p->contacts, b, k, INFINITY));
        go_along(&c, b, drifted);
        delta[k] = c.touch.delta;
        if (!(c.delta0 >= -p->reach))
            delta[k] = INFINITY;
        else
            hold_on(p, &c, p->sliding, &held[k]);
    }
}

/** What is drawn: of bits the contacts' law, of more the springs'. */
static vti_friction friction_in(int trial, const vti_contacts *contacts, vti_sum *lost)
{
    const vti_friction p = {.contacts = contacts,
                            .sliding = trial % 5 != 4 ? 0.4 : 0.0,
                            .mindlin = trial % 2 && trial % 5 != 4 ? 0.8 : 0.0,
                            .stiffness = trial % 2 == 0 && trial % 5 != 4 ? 3.0 : 0.0,
                            .rolling = trial % 3 ? 0.05 : 0.0,
                            .rolling_stiffness = 1.5,
                            .twisting = trial % 7 ? 0.03 : 0.0,
                            .twisting_stiffness = 0.7,
                            .reach = trial % 6 ? 1.0 : INFINITY,
                            .lost = lost};
    return p;
}

static vti_contacts contacts_in(int trial)
{
    const vti_scalars none = {NULL, 0, 0};
    const int material = trial / 2 % 2, one = trial / 4 % 2, own = trial / 8 % 2;
    const vti_contacts contacts = {.count = PAIRS,
                                   .pair = bodies.pair[0],
                                   .base = 1,
                                   .diameter =
                                       one ? vti_scalars_one(bodies.diameter) : vti_scalars_array(bodies.diameter),
                                   .stiffness = material ? 0.0 : 2.0,
                                   .modulus = material ? vti_scalars_array(bodies.modulus) : none,
                                   .length = own ? vti_scalars_array(bodies.length) : none};
    return contacts;
}

static void carries(const struct vti_touch_kernels *kernels)
{
    rng g = rng_seed(11);
    for (int trial = 0; trial < LAYOUTS * 4 * 64; ++trial) {
        const vti_bodies b = bodies_in(trial % LAYOUTS);
        vti_sum lost[VTI_FRICTION_BOOKS] = {{0.0, 0.0}}, lost_too[VTI_FRICTION_BOOKS] = {{0.0, 0.0}};
        double delta[PAIRS];
        draw(&g, &b);
        const vti_contacts contacts = contacts_in(trial / LAYOUTS);
        const vti_friction one = friction_in(trial / LAYOUTS, &contacts, lost);
        vti_friction many = one;
        many.lost = lost_too;
        const vti_drifted drifted = {
            .t = trial % 4 ? 0.1 : 0.5, .law = 1 + trial / LAYOUTS % 4, .frame = VTI_FRAME_SPACE};
        if (drifted.law == VTI_LAW_CLOSED) /* all turn by less than 1 */
            for (int64_t i = 0; i < N; ++i)
                put(&b.omega, i, uniform(&g, -1, 1), uniform(&g, -1, 1), uniform(&g, -1, 1));
        else if (trial % 8 == 5)
            put(&b.omega, 7, 1e30, 1.0, 2.0);
        start = bodies;
        struct vti_carried pairs = {.count = PAIRS};
        for (int64_t k = 0; k < VTI_TOUCHES; ++k) {
            const int64_t at = k < PAIRS ? k : PAIRS - 1;
            pairs.which[k] = at;
            pairs.held[k] = &bodies.held[at];
        }
        kernels->carry(&many, &b, &drifted, &pairs);
        expect(&one, &b, &drifted, start.held, delta);
        assert_memory_equal(bodies.held, start.held, sizeof bodies.held);
        assert_same_bits(pairs.delta, delta, PAIRS);
        assert_same_bits(lost_too, lost, 2 * VTI_FRICTION_BOOKS);
    }
}

/* ---- dashpots ---------------------------------------------------------------------------------------------------- */

static vti_held slots[4 * PAIRS];

/** The flow of each pair alone. */
static void expect_flow(const struct vti_sweep *s)
{
    for (int64_t k = 0; k < PAIRS; ++k) {
        struct place at = {.damping = {.zeta = s->p->zeta}};
        if (!vti_touch_pair(&at.touch, s->p->contacts, s->b, k, INFINITY))
            continue;
        vti_touch_load(&at.touch, s->b, &at.motion);
        vti_touch_masses(&at.touch, s->b);
        const vti_held *held = vti_damping_held(s->p, &at.touch);
        for (int c = 0; c < 3; ++c) {
            at.held.sliding[c] = held->sliding[c];
            at.held.rolling[c] = held->rolling[c];
        }
        at.held.twisting = held->twisting;
        if (!flow_touch(s, &at))
            continue;
        vti_touch_store(&at.touch, s->b, &at.motion);
        for (int m = 0; m < MOTIONS; ++m)
            if (s->damped[m])
                vti_sum_add(&s->p->lost[m], at.lost[m]);
    }
}

static vti_dashpots dashpots_in(int trial, const vti_contacts *contacts, const vti_friction *friction, vti_sum *lost)
{
    const vti_dashpots p = {.contacts = contacts,
                            .friction = trial % 4 ? friction : NULL,
                            .zeta = trial % 3 ? 0.4 : 0.0,
                            .normal = trial % 5 ? 0.2 : 0.0,
                            .tangential = trial % 7 ? 0.3 : 0.0,
                            .ratio = trial % 2 ? 0.5 : 0.0,
                            .rolling = trial % 11 ? 0.1 : 0.0,
                            .twisting = trial % 13 ? 1e3 : 0.0,
                            .pull = trial / 2 % 2,
                            .reach = INFINITY,
                            .lost = lost};
    return p;
}

static void flows(const struct vti_touch_kernels *kernels)
{
    rng g = rng_seed(13);
    double weight[2][N];
    for (int trial = 0; trial < LAYOUTS * 4 * 64; ++trial) {
        vti_bodies b = bodies_in(trial % LAYOUTS);
        vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}}, lost_too[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}};
        draw(&g, &b);
        for (int i = 0; i < 2 * N; ++i)
            weight[i / N][i % N] = uniform(&g, 0.5, 2);
        b.mass = trial % 5 ? vti_scalars_array(weight[0]) : vti_scalars_one(weight[0]);
        b.inertia = trial % 3 ? vti_scalars_array(weight[1]) : vti_scalars_one(weight[1]);
        const vti_contacts contacts = contacts_in(trial / LAYOUTS);
        vti_history history = {4 * PAIRS, 0, 0, slots};
        while (history.slots & (history.slots - 1))
            history.slots &= history.slots - 1;
        memset(slots, 0, sizeof slots);
        for (int64_t k = 0; k < PAIRS; k += 1 + k % 2) /* some hold nothing */
            assert_int_equal(vti_history_add(&history, &bodies.held[k]), VTI_OK);
        vti_friction friction = friction_in(trial / LAYOUTS, &contacts, NULL);
        friction.history = trial % 8 == 7 ? NULL : &history;
        const vti_dashpots one = dashpots_in(trial / LAYOUTS, &contacts, &friction, lost);
        vti_dashpots many = one;
        many.lost = lost_too;
        struct vti_sweep s = {.p = &one, .b = &b, .t = 0.05, .drift = trial % 2 ? 0.1 : -0.1};
        vti_damping_all(&one, s.damped);
        if (trial / LAYOUTS % 9 == 0) {
            b.omega = vti_view_none();
            s.damped[ROLLING] = s.damped[TWISTING] = 0;
        }
        start = bodies;
        expect_flow(&s);
        double moved[2][ROOM];
        memcpy(moved, bodies.all[1], sizeof moved);
        bodies = start;
        s.p = &many;
        int64_t pair[VTI_TOUCHES];
        for (int64_t k = 0; k < VTI_TOUCHES; ++k) {
            const int64_t at = k < PAIRS ? k : PAIRS - 1;
            pair[k] = at;
        }
        kernels->flow(&s, PAIRS, pair);
        assert_same_bits(bodies.all[1], moved, 2 * ROOM);
        assert_same_bits(lost_too, lost, 2 * VTI_DASHPOT_BOOKS);
    }
}

/* ---- which pairs are near, and what their springs do to them ----------------------------------------------------- */

static void nears(const struct vti_touch_kernels *kernels)
{
    rng g = rng_seed(19);
    for (int trial = 0; trial < LAYOUTS * 4 * 16; ++trial) {
        const vti_bodies b = bodies_in(trial % LAYOUTS);
        const double reach = trial % 4 ? 0.1 * (trial % 4 - 1) : INFINITY;
        const int64_t first = trial % 5, end = PAIRS - trial % 4;
        int64_t found[PAIRS], expected[PAIRS], count = 0;
        draw(&g, &b);
        put(&b.x, 14, 0.0, 0.0, 0.0); /* where the other of pair 7 is: no direction */
        put(&b.x, 15, 0.0, 0.0, 0.0);
        put(&b.x, 16, NAN, 0.0, 0.0);
        const vti_contacts contacts = contacts_in(trial / LAYOUTS);
        for (int64_t k = first; k < end; ++k) {
            struct vti_touch touch;
            if (k != 8 && vti_touch_pair(&touch, &contacts, &b, k, reach))
                expected[count++] = touch.delta > 0.0 ? k : -1 - k;
        }
        assert_int_equal(kernels->near(&contacts, &b, reach, first, end - first, found), count);
        assert_memory_equal(found, expected, (size_t)count * sizeof *found);
    }
}

/** Bodies near planes and inside a cylinder. One has left the wall in the drift, or the wall has left it. */
static void nears_wall(const struct vti_touch_kernels *kernels)
{
    static const double plane[2][4] = {{0.6, 0.0, 0.8, -0.3}, {0.0, 1.0, 0.0, 0.2}},
                        cylinder[7] = {0.0, 1.0, 0.0, 0.1, 0.0, 0.0, 2.0}, inside[3] = {-1.0, 0.0, 0.0};
    rng g = rng_seed(43);
    for (int trial = 0; trial < LAYOUTS * 24; ++trial) {
        const vti_bodies b = bodies_in(trial % LAYOUTS);
        vti_wall_motion motion[3] = {{.spin = 0.0}};
        vti_walls walls = {.count = 2,
                           .plane = plane[0],
                           .cylinders = 1,
                           .cylinder = cylinder,
                           .diameter = vti_scalars_array(bodies.diameter),
                           .stiffness = 1.0};
        const double reach = trial % 5 ? 0.1 * (trial % 5 - 1) : INFINITY;
        const int64_t w = trial % 3, first = trial % 4, count = N - trial % 5;
        struct vti_touch touch;
        draw(&g, &b);
        const uint64_t near = kernels->near_wall(&walls, &b, reach, 0.0, w, first, count);
        for (int64_t k = 0; k < count; ++k)
            assert_int_equal(near >> k & 1, vti_touch_wall(&touch, &walls, &b, w, first + k, reach));
        assert_true(near >> (count - 1) >> 1 == 0);
        const double *const n = w < 2 ? plane[w] : inside; /* of the cylinder where x is largest */
        const double r = uniform(&g, 0.01, 1.0), *const at = w < 2 ? NULL : cylinder + 3;
        const double away = (w < 2 ? n[3] : -cylinder[6]) + 0.5 * bodies.diameter[9] + 0.999 * r;
        put(&b.x, 9, away * n[0] + (at ? at[0] : 0.0), away * n[1], away * n[2]);
        put(&b.v, 9, 10.0 * r * n[0], 10.0 * r * n[1], 10.0 * r * n[2]);
        assert_true(kernels->near_wall(&walls, &b, 0.0, 0.1, w, first, count) >> (9 - first) & 1);
        put(&b.v, 9, 0.0, 0.0, 0.0);
        assert_false(kernels->near_wall(&walls, &b, 0.0, 0.1, w, first, count) >> (9 - first) & 1);
        for (int k = 0; k < 3; ++k)
            motion[w].velocity[k] = -10.0 * r * n[k];
        walls.motion = motion;
        assert_true(kernels->near_wall(&walls, &b, 0.0, 0.1, w, first, count) >> (9 - first) & 1);
    }
}

static double loads[2][2][ROOM];

/** What the springs of pair k do to its bodies, if they touch and are of the slice. */
static void expect_push(const vti_friction *p, const vti_bodies *b, int64_t k)
{
    struct vti_touch touch = {.j = 0};
    const vti_held *const held = &bodies.held[k];
    const double none[3] = {0.0, 0.0, 0.0}, *const f = p->sliding > 0.0 ? held->sliding : none,
                 *const roll = p->rolling > 0.0 ? held->rolling : none;
    double across[3];
    if (!vti_touch_pair(&touch, p->contacts, b, k, 0.0))
        return;
    vti_cross(touch.n, f, across);
    for (int c = 0; c < 3; ++c) {
        const double moment = roll[c] + (p->twisting > 0.0 ? held->twisting : 0.0) * touch.n[c];
        for (int side = 0; side < 2; ++side) {
            const int64_t i = side ? touch.j : touch.i;
            const double sign = side ? 1.0 : -1.0;
            if (i < b->first || i >= b->first + b->count)
                continue;
            b->force.c[c][i * b->force.stride] += sign * f[c];
            b->moment.c[c][i * b->moment.stride] +=
                (side ? touch.s_j : touch.s_i) * touch.r * across[c] + sign * moment;
        }
    }
}

static void pushes(const struct vti_touch_kernels *kernels)
{
    rng g = rng_seed(29);
    for (int trial = 0; trial < LAYOUTS * 4 * 16; ++trial) {
        vti_bodies b = bodies_in(trial % LAYOUTS), too;
        vti_held *held[PAIRS];
        int64_t pair[PAIRS];
        draw(&g, &b);
        const vti_contacts contacts = contacts_in(trial / LAYOUTS);
        const vti_friction friction = friction_in(trial / LAYOUTS, &contacts, NULL);
        for (int n = 0; n < 2 * ROOM; ++n)
            loads[0][n / ROOM][n % ROOM] = loads[1][n / ROOM][n % ROOM] = uniform(&g, -1, 1);
        for (int64_t k = 0; k < PAIRS; ++k) {
            pair[k] = (k * 5 + trial) % PAIRS; /* in any order */
            held[k] = &bodies.held[pair[k]];
        }
        b.first = trial % 3;
        b.count = trial % 7 ? N - b.first : 11;
        b.force = view_in(trial % LAYOUTS, loads[0][0]);
        b.moment = view_in(trial % LAYOUTS, loads[0][1]);
        too = b;
        too.force = view_in(trial % LAYOUTS, loads[1][0]);
        too.moment = view_in(trial % LAYOUTS, loads[1][1]);
        kernels->push(&friction, &b, PAIRS, pair, held);
        for (int64_t k = 0; k < PAIRS; ++k)
            expect_push(&friction, &too, pair[k]);
        assert_same_bits(loads[0], loads[1], 2 * ROOM);
    }
}

/** The same at a plane and inside a cylinder, some bodies not touching it. */
static void pushes_at_wall(const struct vti_touch_kernels *kernels)
{
    static const double plane[4] = {0.6, 0.0, 0.8, -0.3}, cylinder[7] = {0.0, 1.0, 0.0, 0.1, 0.0, 0.0, 0.7};
    rng g = rng_seed(47);
    int touching = 0;
    for (int trial = 0; trial < LAYOUTS * 4 * 16; ++trial) {
        vti_bodies b = bodies_in(trial % LAYOUTS), too;
        const vti_walls walls = {.count = 1,
                                 .plane = plane,
                                 .cylinders = 1,
                                 .cylinder = cylinder,
                                 .diameter = vti_scalars_array(bodies.diameter),
                                 .stiffness = 1.0};
        vti_friction friction = friction_in(trial / LAYOUTS, NULL, NULL);
        friction.walls = &walls;
        vti_held *held[PAIRS];
        int64_t body[PAIRS];
        draw(&g, &b);
        for (int n = 0; n < 2 * ROOM; ++n)
            loads[0][n / ROOM][n % ROOM] = loads[1][n / ROOM][n % ROOM] = uniform(&g, -1, 1);
        b.force = view_in(trial % LAYOUTS, loads[0][0]);
        b.moment = view_in(trial % LAYOUTS, loads[0][1]);
        too = b;
        too.force = view_in(trial % LAYOUTS, loads[1][0]);
        too.moment = view_in(trial % LAYOUTS, loads[1][1]);
        for (int64_t k = 0; k < PAIRS; ++k) {
            body[k] = (2 * k + trial) % N;
            held[k] = &bodies.held[k];
        }
        kernels->push_at(&friction, &b, trial % 2, PAIRS, body, held);
        for (int64_t k = 0; k < PAIRS; ++k) {
            struct vti_touch touch;
            double force[3], moment[3];
            if (!vti_touch_wall(&touch, &walls, &b, trial % 2, body[k], 0.0))
                continue;
            const int slides = friction.sliding > 0.0, rolls = friction.rolling > 0.0, twists = friction.twisting > 0.0;
            vti_cross(touch.n, held[k]->sliding, moment);
            for (int c = 0; c < 3; ++c) {
                force[c] = slides ? -held[k]->sliding[c] : -0.0;
                moment[c] = (slides ? touch.r * moment[c] : 0.0) -
                            ((rolls ? held[k]->rolling[c] : 0.0) + (twists ? held[k]->twisting : 0.0) * touch.n[c]);
            }
            vti_add(&too.force, body[k], force);
            vti_add(&too.moment, body[k], moment);
            ++touching;
        }
        assert_same_bits(loads[0], loads[1], 2 * ROOM);
    }
    assert_true(touching > 100);
}

/* ---- dashpots of bonds ------------------------------------------------------------------------------------------- */

/** All bonds at once, and one by one by the kernel for any processor. What one does test bond_dashpot says. */
static void bond_flows(const struct vti_touch_kernels *kernels)
{
    static double rest[PAIRS][4], stiffness[3][PAIRS], weight[2][N];
    rng g = rng_seed(31);
    int changes = 0;
    for (int trial = 0; trial < LAYOUTS * 4 * 16; ++trial) {
        const int kind = trial / LAYOUTS;
        vti_bodies b = bodies_in(trial % LAYOUTS);
        vti_sum lost[2][VTI_BOND_DASHPOT_BOOKS] = {{{0.0, 0.0}}};
        double moved[2][ROOM];
        int64_t bond[PAIRS];
        draw(&g, &b);
        put(&b.x, 14, 0.0, 0.0, 0.0); /* where the other of bond 7 is */
        put(&b.x, 15, 0.0, 0.0, 0.0);
        for (int64_t k = 0; k < PAIRS; ++k) {
            bond[k] = (5 * k + trial) % PAIRS;
            rest[k][3] = uniform(&g, 0.5, 1.5);
            for (int m = 0; m < 3; ++m)
                stiffness[m][k] = uniform(&g, 0, 100);
        }
        for (int i = 0; i < 2 * N; ++i)
            weight[i / N][i % N] = uniform(&g, 0.5, 2);
        b.mass = trial % 5 ? vti_scalars_array(weight[0]) : vti_scalars_one(weight[0]);
        b.inertia = trial % 3 ? vti_scalars_array(weight[1]) : vti_scalars_one(weight[1]);
        if (trial % 7 == 0)
            b.omega = vti_view_none();
        const vti_scalars none = {NULL, 0, 0};
        const vti_bonds bonds = {.count = PAIRS,
                                 .pair = bodies.pair[0],
                                 .base = 1,
                                 .rest = rest[0],
                                 .moment = kind % 2 ? vti_scalars_array(stiffness[0]) : none,
                                 .axial = kind % 3 ? vti_scalars_one(stiffness[1]) : none,
                                 .shear = kind % 5 ? vti_scalars_array(stiffness[2]) : none};
        vti_bond_dashpots p = {.bonds = &bonds,
                               .zeta = kind % 4 ? 0.3 : 0.0,
                               .axial = kind % 7 ? 0.5 : 0.0,
                               .shear = kind % 4 == 2 ? 0.4 : 0.0,
                               .bending = kind % 4 == 1 ? 0.2 : 0.0,
                               .twisting = 0.1,
                               .lost = lost[0]};
        const struct vti_bond_sweep s = {.p = &p, .b = &b, .t = 0.2, .drift = trial % 2 ? 0.1 : -0.1};
        start = bodies;
        for (int64_t k = 0; k < PAIRS; ++k)
            vti_touch_baseline.flow_bonds(&s, 1, &bond[k]);
        memcpy(moved, bodies.all[1], sizeof moved);
        changes += memcmp(moved, start.all[1], sizeof moved) != 0;
        bodies = start;
        p.lost = lost[1];
        kernels->flow_bonds(&s, PAIRS, bond);
        assert_same_bits(bodies.all[1], moved, 2 * ROOM);
        assert_same_bits(lost[0], lost[1], 2 * VTI_BOND_DASHPOT_BOOKS);
    }
    assert_true(changes > LAYOUTS * 4 * 14);
}

/* ---- the order of the pairs (EQUATIONS 6.4) ---------------------------------------------------------------------- */

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
    rng g = rng_seed(23);
    vti_sum lost[2][VTI_FRICTION_BOOKS] = {{{0.0, 0.0}}};
    vti_history history[2] = {{4096, 0, 0, table[0]}, {4096, 0, 0, table[1]}};
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
    for (int64_t k = 0; k < history[0].slots; ++k)
        if (table[0][k].i != 0)
            assert_memory_equal(&table[0][k], vti_history_find(&history[1], table[0][k].i, table[0][k].j),
                                sizeof table[0][k]);
    assert_same_bits(lost[0], lost[1], 2 * VTI_FRICTION_BOOKS);

    vti_history small = {8, 0, 0, table[1]};
    memset(table[1], 0, sizeof table[1]);
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
        memset(table, 0, sizeof table);
        vti_history history = {512, 0, 0, table};
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
        vti_history history = {512, 0, 0, table};
        double diameter[MANY];
        memset(table, 0, sizeof table);
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

/* ---- the units --------------------------------------------------------------------------------------------------- */

static void agree(const struct vti_touch_kernels *kernels)
{
    nears(kernels);
    nears_wall(kernels);
    pushes(kernels);
    pushes_at_wall(kernels);
    carries(kernels);
    flows(kernels);
    bond_flows(kernels);
}

TEST(baseline)
{
    agree(&vti_touch_baseline);
}

TEST(avx2)
{
#ifdef VTI_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) {
        agree(&vti_touch_avx2);
        return;
    }
#endif
    skip();
}

TEST(avx512)
{
#ifdef VTI_HAS_AVX512
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
        agree(&vti_touch_avx512);
        return;
    }
#endif
    skip();
}

RUN_TESTS(cmocka_unit_test(order_of_the_pairs), cmocka_unit_test(order_of_the_bonds),
          cmocka_unit_test(springs_of_a_crowd), cmocka_unit_test(walls), cmocka_unit_test(springs_at_walls),
          cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
