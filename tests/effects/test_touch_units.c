/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Touches done many at once, by the kernels of every vector width, have the bits of one after the other: all layouts
 * and laws, materials, pairs that part, that meet, that pass through each other and that no list need have. The
 * kernels' tables are private to the library. */
#include "touch_alone.h"

#include "../../src/dissipation/vti_bond_flow.h"
#include "../../src/dissipation/vti_dashpot_flow.h"
#include "../../src/contacts/vti_touch_table.h"

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

static vti_held entries[4 * PAIRS];
static int64_t slots[4 * PAIRS];

/** The flow of each pair alone. */
static void expect_flow(const struct vti_sweep *s)
{
    for (int64_t k = 0; k < PAIRS; ++k) {
        struct place at = {.damping = {.zeta = s->p->zeta}};
        if (!vti_touch_pair(&at.touch, s->p->contacts, s->b, k, INFINITY))
            continue;
        touch_load(&at.touch, s->b, &at.motion);
        touch_masses(&at.touch, s->b);
        const vti_held *held = vti_damping_held(s->p, &at.touch);
        for (int c = 0; c < 3; ++c) {
            at.held.sliding[c] = held->sliding[c];
            at.held.rolling[c] = held->rolling[c];
        }
        at.held.twisting = held->twisting;
        if (!flow_touch(s, &at))
            continue;
        touch_store(&at.touch, s->b, &at.motion);
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
        vti_history history = {4 * PAIRS, 0, 0, entries, slots};
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

/* ---- what Hertzian contact does ---------------------------------------------------------------------------------- */

enum { LISTED = 200 };
static struct {
    double x[ROOM], force[2][ROOM], length[LISTED];
    int64_t pair[LISTED][2];
} crowd;

/** (K/L) o^{3/2} along d, which is r long, onto body i if it is of the slice. */
static void push_alone(const vti_bodies *b, int64_t i, double stiffness, double length, double r, double by,
                       const double d[3])
{
    const double o = 1.0 - r / length, f = stiffness / length * o * sqrt(o) * by;
    for (int k = 0; k < 3 && i >= b->first && i < b->first + b->count; ++k)
        b->force.c[k][i * b->force.stride] += f * d[k];
}

static void press_alone(const vti_contacts *p, const vti_bodies *b)
{
    for (int64_t k = 0; k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        double d[3], back[3];
        for (int c = 0; c < 3; ++c) {
            d[c] = b->x.c[c][i * b->x.stride] - b->x.c[c][j * b->x.stride];
            back[c] = -d[c];
        }
        const double *const D = p->diameter.p, r2 = vti_dot(d, d), r = sqrt(r2);
        const double length =
            p->length.p != NULL ? p->length.p[k] : 0.5 * D[i * p->diameter.stride] + 0.5 * D[j * p->diameter.stride];
        if (r2 >= length * length)
            continue;
        const double by = r > VTI_COINCIDENT ? 1.0 / r : 0.0, stiffness = vti_contacts_stiffness(p, k);
        push_alone(b, i, stiffness, length, r, by, d);
        push_alone(b, j, stiffness, length, r, by, back);
    }
}

static void press_alone_at(const vti_walls *p, const vti_bodies *b, int64_t w)
{
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double x[3], n[3];
        for (int k = 0; k < 3; ++k)
            x[k] = b->x.c[k][i * b->x.stride];
        const double gap = vti_walls_gap(p, w, x, n), radius = 0.5 * p->diameter.p[i * p->diameter.stride];
        if (!(gap >= radius))
            push_alone(b, i, vti_walls_stiffness(p, w, i), radius, gap, 1.0, n);
    }
}

/** To the bit, but for the signs of NaN, which C leaves open. */
static void same_forces(void)
{
    for (int64_t k = 0; k < ROOM; ++k)
        if (isnan(crowd.force[0][k]) && isnan(crowd.force[1][k]))
            crowd.force[0][k] = crowd.force[1][k] = NAN;
    assert_same_bits(crowd.force[0], crowd.force[1], ROOM);
}

/** Lists of any length in which bodies come more than once, in any order, and walls; layouts of places and forces that
 *  differ; slices; one diameter, more, materials, lengths of their own; places that are one, or NaN. */
static void presses(const struct vti_touch_kernels *kernels)
{
    static const double plane[2][4] = {{0.6, 0.0, 0.8, -0.3}, {0.0, 1.0, 0.0, 0.2}},
                        cylinder[7] = {0.0, 1.0, 0.0, 0.1, 0.0, 0.0, 1.0};
    static const vti_scalars none = {NULL, 0, 0};
    rng g = rng_seed(77);
    for (int trial = 0; trial < LAYOUTS * LAYOUTS * 4 * 12; ++trial) {
        const int kind = trial / (LAYOUTS * LAYOUTS) % 4, base = trial % 2;
        vti_bodies b[2];
        for (int k = 0; k < 2; ++k) {
            b[k] = vti_bodies_none(N);
            b[k].x = view_in(trial % LAYOUTS, crowd.x);
            b[k].force = view_in(trial / LAYOUTS % LAYOUTS, crowd.force[k]);
            b[k].first = trial % 5 ? 0 : 7;
            b[k].count = trial % 5 ? N : N - 20;
        }
        for (int64_t i = 0; i < N; ++i) {
            put(&b[0].x, i, uniform(&g, -1, 1), uniform(&g, -1, 1), uniform(&g, -1, 1));
            bodies.diameter[i] = uniform(&g, 0.8, 1.2);
            bodies.modulus[i] = uniform(&g, 1, 3);
        }
        for (int64_t k = 0; k < ROOM; ++k)
            crowd.force[0][k] = crowd.force[1][k] = uniform(&g, -1, 1);
        put(&b[0].x, 3, 0.1, 0.2, 0.3);
        put(&b[0].x, 4, 0.1, 0.2, 0.3);
        if (trial % 3 == 0)
            put(&b[0].x, 5, 0.1, NAN, 0.3);
        for (int64_t k = 0; k < LISTED; ++k) {
            crowd.pair[k][0] = k % 9 ? rng_below(&g, N) : 3;
            crowd.pair[k][1] = k % 9 ? (crowd.pair[k][0] + 1 + rng_below(&g, N - 1)) % N : 4;
            for (int side = 0; side < 2; ++side)
                crowd.pair[k][side] += base;
            crowd.length[k] = uniform(&g, 0.5, 1.1);
        }
        const vti_contacts contacts = {.count = trial % 7 ? rng_below(&g, LISTED + 1) : trial % 17,
                                       .pair = crowd.pair[0],
                                       .base = base,
                                       .diameter =
                                           kind ? vti_scalars_array(bodies.diameter) : vti_scalars_one(bodies.diameter),
                                       .modulus = kind == 2 ? vti_scalars_array(bodies.modulus) : none,
                                       .length = kind == 3 ? vti_scalars_array(crowd.length) : none,
                                       .stiffness = kind == 2 ? 0.0 : 2.5};
        const vti_walls walls = {.count = 2,
                                 .plane = plane[0],
                                 .cylinders = 1,
                                 .cylinder = cylinder,
                                 .diameter = contacts.diameter,
                                 .modulus = contacts.modulus,
                                 .stiffness = contacts.stiffness};
        kernels->press(&contacts, &b[0]);
        press_alone(&contacts, &b[1]);
        same_forces();
        kernels->press_at(&walls, &b[0], trial % 3, b[0].first, b[0].count);
        press_alone_at(&walls, &b[1], trial % 3);
        same_forces();
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

/* ---- the units --------------------------------------------------------------------------------------------------- */

static void agree(const struct vti_touch_kernels *kernels)
{
    presses(kernels);
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

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
