/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_multistep_touch. Hertz's impact has a closed form: a sphere leaves as fast as it came, after a time of contact
 * that he worked out; of an oblique one energy and angular momentum are known after it. A multistep method has them
 * to order 2.5 without the call, to order 4.5 with it. */
#include "support.h"

enum { BODIES = 2, DEPTH = 10, PHASES = 8 };

/** k = K/L^{5/2} = 1 for the wall and for the pair. */
struct scene {
    double x[BODIES][3], v[BODIES][3], f[BODIES][3], before[BODIES][3], mass[BODIES], diameter[BODIES], plane[2][4];
    double cylinder[7], memory[BODIES][DEPTH][6], stiffness;
    int64_t pair[2];
    vti_contacts contacts;
    vti_walls walls;
    vti_past past;
    vti_bodies b;
    int of_pair;
};

static void clear(struct scene *s, int64_t bodies, int64_t depth)
{
    memset(s, 0, sizeof *s);
    const vti_past none = {s->memory[0][0], depth, 0};
    s->past = none;
    s->mass[0] = 1.0;
    s->mass[1] = 3.0;
    s->diameter[0] = s->diameter[1] = 4.0;
    s->pair[1] = 1;
    s->plane[0][0] = 0.6; /* through the origin, with the bodies on its side */
    s->plane[0][2] = 0.8;
    s->contacts = (vti_contacts){
        .count = 1, .pair = s->pair, .diameter = vti_scalars_array(s->diameter), .stiffness = pow(4.0, 2.5)};
    s->walls = (vti_walls){
        .count = 1, .plane = s->plane[0], .diameter = vti_scalars_array(s->diameter), .stiffness = pow(2.0, 2.5)};
    s->b = vti_bodies_none(bodies);
    s->b.x = vti_view_packed(s->x[0]);
    s->b.v = vti_view_packed(s->v[0]);
    s->b.force = vti_view_packed(s->f[0]);
    s->b.mass = vti_scalars_array(s->mass);
}

static void load(struct scene *s)
{
    const vti_effect effect = s->of_pair ? vti_contacts_effect(&s->contacts) : vti_walls_effect(&s->walls);
    assert_int_equal(vti_apply(&effect, 1, &s->b), VTI_OK);
}

/** Nothing touches at first, so that the past is all zeros. */
static void fly(struct scene *s, const vti_multistep *m, double h, int steps, int touch)
{
    const vti_view before = vti_view_packed(s->before[0]);
    load(s);
    while (s->past.known < m->depth)
        assert_int_equal(vti_multistep_record(&s->past, &s->b), VTI_OK);
    for (int k = 0; k < steps; ++k) {
        memcpy(s->before, s->x, sizeof s->x);
        assert_int_equal(vti_multistep_predict(m, h, &s->past, &s->b, NULL), VTI_OK);
        load(s);
        assert_int_equal(vti_multistep_correct(m, h, &s->past, &s->b), VTI_OK);
        if (touch)
            assert_int_equal(
                vti_multistep_touch(h, &before, s->of_pair ? &s->contacts : NULL, s->of_pair ? NULL : &s->walls, &s->b),
                VTI_OK);
    }
}

/** Of k = 1 and a reduced mass that meets at the speed 1: 4 sqrt(pi) Gamma(2/5)/(5 Gamma(9/10)) (5 m/4)^{2/5}. */
static double duration(double m)
{
    return 4.0 * sqrt(PI) * tgamma(0.4) / (5.0 * tgamma(0.9)) * pow(1.25 * m, 0.4);
}

enum { T_END = 6 };

/** A sphere that comes at the wall obliquely, from a gap of 0.5 and a part of a step more: v and x at t = 6. */
static void at_wall(const vti_multistep *m, int steps, double phase, int touch, double error[2])
{
    struct scene s;
    const double h = (double)T_END / steps, gap = 0.5 + phase * h, after = T_END - gap - duration(1.0);
    clear(&s, 1, m->depth);
    for (int k = 0; k < 3; ++k) {
        s.x[0][k] = (2.0 + gap) * s.plane[0][k];
        s.v[0][k] = -s.plane[0][k];
    }
    s.v[0][1] = 0.7;
    fly(&s, m, h, steps, touch);
    error[0] = error[1] = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double along = k == 1 ? 0.7 : 0.0;
        error[0] = hypot(error[0], s.v[0][k] - s.plane[0][k] - along);
        error[1] = hypot(error[1], s.x[0][k] - (2.0 + after) * s.plane[0][k] - along * T_END);
    }
}

/** Two spheres that meet obliquely: the energy when they are apart again. Linear momentum is kept to rounding, angular
 *  momentum to the order of the method, which is 5 at least: 0.03 h^5. */
static void of_two(const vti_multistep *m, int steps, double phase, int touch, double error[2])
{
    struct scene s;
    const double h = (double)T_END / steps, p[3] = {0.3, -0.5, 0.25}, zero[3] = {0.0, 0.0, 0.0};
    double momentum[3], spin[2][3];
    clear(&s, 2, m->depth);
    s.of_pair = 1;
    s.x[1][0] = 4.2 + phase * h;
    s.x[1][1] = 0.9;
    s.v[0][0] = 1.0 + p[0];
    for (int k = 0; k < 3; ++k) {
        s.v[0][k] = p[k] + (k == 0);
        s.v[1][k] = p[k];
    }
    const double energy = vti_kinetic_translation(&s.b);
    vti_angular_momentum(&s.b, zero, spin[0]);
    fly(&s, m, h, steps, touch);
    vti_momentum(&s.b, momentum);
    vti_angular_momentum(&s.b, zero, spin[1]);
    for (int k = 0; k < 3; ++k) {
        assert_close(momentum[k], 4.0 * p[k] + (k == 0), 4.0 * steps * EPS);
        spin[1][k] -= spin[0][k];
    }
    error[0] = fabs(vti_kinetic_translation(&s.b) - energy);
    assert_below(vti_norm(spin[1]), 0.03 * pow(h, 5.0));
}

typedef void impact(const vti_multistep *m, int steps, double phase, int touch, double error[2]);

/** Mean squares over where in a step it begins and ends, at h and h/2, with the call and without. */
static void orders(const char *what, impact *meet, int steps)
{
    for (int64_t i = 0; i < vti_multistep_count(); ++i) {
        const vti_multistep *m = vti_multistep_at(i);
        double mean[2][2][2] = {{{0.0}}}, order[2][2];
        for (int touch = 0; touch < 2; ++touch)
            for (int half = 0; half < 2; ++half)
                for (int phase = 0; phase < PHASES; ++phase) {
                    double error[2] = {0.0, 0.0};
                    meet(m, (steps + 7 * phase) << half, (double)phase / PHASES, touch, error);
                    for (int k = 0; k < 2; ++k)
                        mean[touch][half][k] += error[k] * error[k] / PHASES;
                }
        for (int touch = 0; touch < 2; ++touch)
            for (int k = 0; k < 2; ++k)
                order[touch][k] = 0.5 * log2(mean[touch][0][k] / mean[touch][1][k]);
        print_message("%s, %s: %.1e, %.1e, orders %.2f, %.2f; without %.1e, %.1e, %.2f, %.2f\n", what, m->name,
                      sqrt(mean[1][1][0]), sqrt(mean[1][1][1]), order[1][0], order[1][1], sqrt(mean[0][1][0]),
                      sqrt(mean[0][1][1]), order[0][0], order[0][1]);
        assert_close(order[0][0], 2.5, 0.7);
        assert_true(order[1][0] > 4.0 && (meet == of_two || order[1][1] > 4.0));
        assert_true(mean[1][1][0] < 1e-4 * mean[0][1][0]);
    }
}

TEST(wall)
{
    orders("wall", at_wall, 240);
}

TEST(pair)
{
    orders("pair", of_two, 240);
}

/** A step's ends by themselves: the sphere is inside by so much before and after, and moves at the wall so fast. */
static void place(struct scene *s, double before, double after, double speed)
{
    clear(s, 1, DEPTH);
    for (int k = 0; k < 3; ++k) {
        s->before[0][k] = (2.0 - before) * s->plane[0][k];
        s->x[0][k] = (2.0 - after) * s->plane[0][k];
        s->v[0][k] = -speed * s->plane[0][k];
    }
}

static int touch(struct scene *s, double h)
{
    const vti_view before = vti_view_packed(s->before[0]);
    return vti_multistep_touch(h, &before, s->of_pair ? &s->contacts : NULL, s->of_pair ? NULL : &s->walls, &s->b);
}

static const double a[] = {0.1, 0.3, 0.5, 0.8};
static const double zeta3[] = {-0.030681943042529056, -0.008185560485835975, 0.01647482235172846, 0.016336594921834438};

/** In uniform motion the impulse is -k h^{5/2} zeta(-3/2, a): zeta's values from mpmath 1.3. */
TEST(impulse)
{
    static const double zeta5[] = {0.000943625820149835, -0.00949638093151452, -0.007011334254425124,
                                   0.009150255916867068};
    const double h = 0.25, power = h * h * sqrt(h);
    for (int k = 0; k < 4; ++k)
        for (int ends = 0; ends < 2; ++ends) {
            struct scene s;
            const double in = a[k] * h, out = in - h;
            place(&s, ends ? in : out, ends ? out : in, ends ? -1.0 : 1.0);
            const double x = s.x[0][0], v = s.v[0][0], since = ends ? h - in : in;
            assert_int_equal(touch(&s, h), VTI_OK);
            assert_close((s.v[0][0] - v) / s.plane[0][0], -power * zeta3[k], 1e-7 * power);
            assert_close((s.x[0][0] - x) / s.plane[0][0], -power * (since * zeta3[k] + (ends ? h : -h) * zeta5[k]),
                         1e-7 * power * h);
        }
}

/** Body 1 of three comes to body 2 at the speed 1, or to the second of two planes; body 0 is far away. */
struct trio {
    double x[3][3], v[3][3], before[3][3];
    vti_bodies b;
};

static const double masses[] = {1.0, 3.0, 2.0}, diameters[] = {4.0, 2.0, 1.0}, materials[] = {5.0, 7.0, 11.0};

/** It begins to touch at the distance L from x = 0. */
static void come(struct trio *t, double L, double h)
{
    memset(t, 0, sizeof *t);
    t->before[0][1] = t->x[0][1] = 100.0;
    t->before[1][0] = L + (1.0 - a[1]) * h;
    t->x[1][0] = L - a[1] * h;
    t->v[1][0] = -1.0;
    t->b = vti_bodies_none(3);
    t->b.x = vti_view_packed(t->x[0]);
    t->b.v = vti_view_packed(t->v[0]);
    t->b.mass = vti_scalars_array(masses);
}

/** A pair has its own length, and K by the material of both its bodies, whatever number the first body has. */
TEST(own_lengths_and_materials)
{
    static const int64_t pair[] = {1, 3, 3, 2};
    static const double length[] = {0.5, 2.25};
    const double h = 0.25, power = h * h * sqrt(h);
    for (int own = 0; own < 2; ++own)
        for (int material = 0; material < 2; ++material) {
            struct trio t;
            const vti_view before = vti_view_packed(t.before[0]);
            const double L = own ? length[1] : 1.5, of_both = 4.0 / 3.0 / (1.0 / 7.0 + 1.0 / 11.0) / sqrt(1.0 + 2.0),
                         k = material ? of_both : 10.0 / (L * L * sqrt(L));
            const vti_contacts contacts = {.count = 2,
                                           .pair = pair,
                                           .base = 1,
                                           .diameter = vti_scalars_array(diameters),
                                           .length = own ? vti_scalars_array(length) : (vti_scalars){0},
                                           .modulus = material ? vti_scalars_array(materials) : (vti_scalars){0},
                                           .stiffness = material ? 0.0 : 10.0};
            come(&t, L, h);
            assert_int_equal(vti_multistep_touch(h, &before, &contacts, NULL, &t.b), VTI_OK);
            assert_close(t.v[1][0] + 1.0, -k * power * zeta3[1] / masses[1], 1e-7 * k * power);
            assert_close(t.v[2][0], k * power * zeta3[1] / masses[2], 1e-7 * k * power);
            assert_true(t.v[0][0] == 0.0 && t.v[0][1] == 0.0);
        }
}

/** And a wall K of its own, or by its material and that of the body. */
TEST(each_wall)
{
    static const double plane[2][4] = {{0.0, -1.0, 0.0, -200.0}, {1.0, 0.0, 0.0, 0.0}};
    static const double each[] = {3.0, 5.0}, moduli[] = {2.0, 13.0};
    const double h = 0.25, power = h * h * sqrt(h), R = 0.5 * diameters[1];
    for (int material = 0; material < 2; ++material) {
        struct trio t;
        const vti_view before = vti_view_packed(t.before[0]);
        const double k = material ? 4.0 / 3.0 / (1.0 / 7.0 + 1.0 / 13.0) * sqrt(R) : each[1] / (R * R * sqrt(R));
        const vti_walls walls = {.count = 2,
                                 .plane = plane[0],
                                 .diameter = vti_scalars_array(diameters),
                                 .each = material ? NULL : each,
                                 .modulus = material ? vti_scalars_array(materials) : (vti_scalars){0},
                                 .moduli = material ? moduli : NULL};
        come(&t, R, h);
        t.before[0][0] = t.x[0][0] = t.before[2][0] = t.x[2][0] = 100.0;
        assert_int_equal(vti_multistep_touch(h, &before, NULL, &walls, &t.b), VTI_OK);
        assert_close(t.v[1][0] + 1.0, -k * power * zeta3[1] / masses[1], 1e-7 * k * power);
        assert_true(t.v[0][0] == 0.0 && t.v[2][0] == 0.0);
    }
}

/** What has begun or ended by the rounding of a start is taken for the start of its contact; what has not is left. */
TEST(nothing_crosses)
{
    static const double both[][2] = {{0.1, 0.3}, {-0.3, -0.1}, {1e-14, -0.2}};
    for (int k = 0; k < 3; ++k) {
        struct scene s, as_before;
        place(&s, both[k][0], both[k][1], 1.0);
        as_before = s;
        assert_int_equal(touch(&s, 0.25), VTI_OK);
        assert_same_bits(s.x, as_before.x, 3 * BODIES);
        assert_same_bits(s.v, as_before.v, 3 * BODIES);
    }
}

/** A wall that moves along with its sphere pushes as one at rest does. */
TEST(moving_wall)
{
    const double h = 0.25;
    struct scene still, moves;
    vti_wall_motion motion = {.velocity = {3.0, -1.0, 2.0}};
    vti_sum work = {0.0, 0.0};
    place(&still, -0.1, 0.12, 0.9);
    place(&moves, -0.1, 0.12, 0.9);
    moves.walls.motion = &motion;
    moves.walls.work = &work;
    for (int k = 0; k < 3; ++k) {
        motion.moved[k] = h * motion.velocity[k];
        moves.x[0][k] += h * motion.velocity[k];
        moves.v[0][k] += motion.velocity[k];
    }
    assert_int_equal(touch(&still, h), VTI_OK);
    assert_int_equal(touch(&moves, h), VTI_OK);
    for (int k = 0; k < 3; ++k) {
        assert_close(moves.v[0][k] - motion.velocity[k], still.v[0][k], 32.0 * EPS);
        assert_close(moves.x[0][k] - h * motion.velocity[k], still.x[0][k], 32.0 * EPS);
    }
}

/** Of a pair a slice moves its own body; what comes from where there is no direction, or begins to touch without any
 *  speed, moves nothing, and no number is NaN. */
TEST(pairs)
{
    const double length = 4.0 * (1.0 - 1e-12);
    struct scene s, whole, before;
    clear(&whole, 2, DEPTH);
    whole.of_pair = 1;
    whole.before[1][0] = 4.1;
    whole.x[1][0] = 3.95;
    whole.v[0][0] = 0.6;
    s = before = whole;
    assert_int_equal(touch(&whole, 0.25), VTI_OK);
    assert_true(whole.v[0][0] != 0.6 && whole.v[1][0] != 0.0);
    s.b.x = vti_view_packed(s.x[0]); /* copies look at their own memory */
    s.b.v = vti_view_packed(s.v[0]);
    s.b.count = 1;
    assert_int_equal(touch(&s, 0.25), VTI_OK);
    assert_same_bits(s.v[0], whole.v[0], 3);
    assert_same_bits(s.v[1], before.v[1], 3);

    clear(&s, 2, DEPTH); /* the overlap grows as t^2: r = 0 */
    s.of_pair = 1;
    s.before[1][0] = length;
    s.x[1][0] = length - 0.125;
    s.v[0][0] = 0.25;
    assert_int_equal(touch(&s, 1.0), VTI_OK);
    assert_true(s.v[0][0] == 0.25 && s.v[1][0] == 0.0);
    for (int k = 1; k < 100; ++k) { /* the same with numbers that round: r^2 may come out below 0 */
        const double h = 0.01 * (100 + k), in = length - (s.x[1][0] = length - 0.003 * k);
        memset(s.v, 0, sizeof s.v);
        s.x[0][0] = 0.0;
        s.v[0][0] = 2.0 * in / h;
        assert_int_equal(touch(&s, h), VTI_OK);
        assert_true(all_finite(s.v[0], 3 * BODIES) && all_finite(s.x[0], 3 * BODIES));
    }

    clear(&s, 2, DEPTH);
    s.of_pair = 1;
    s.before[1][0] = 5.0;
    assert_int_equal(touch(&s, 0.25), VTI_OK);
    assert_true(all_finite(s.v[0], 3 * BODIES) && all_finite(s.x[0], 3 * BODIES));
}

enum { CROWD = 37, ROW = 4 };

/** Spheres that have come some way, in rows of three or of four numbers. */
struct crowd {
    double x[ROW * CROWD], v[ROW * CROWD], force[ROW * CROWD], before[ROW * CROWD], mass[CROWD], diameter[CROWD];
    int64_t pair[CROWD * (CROWD - 1) / 2][2];
};

enum { PAIRS = CROWD * (CROWD - 1) / 2 };

static vti_bodies meet(struct crowd *c, int64_t row)
{
    rng g = rng_seed(11);
    vti_bodies b = vti_bodies_none(CROWD);
    int64_t pairs = 0;
    memset(c, 0, sizeof *c);
    for (int64_t i = 0; i < CROWD; ++i) {
        random_vector(&g, 1.6, c->before + row * i);
        random_vector(&g, 2.5, c->v + row * i);
        for (int64_t k = row * i; k < row * i + 3; ++k)
            c->x[k] = c->before[k] + 0.1 * c->v[k];
        c->mass[i] = uniform(&g, 0.5, 2.0);
        c->diameter[i] = uniform(&g, 0.8, 1.2);
        for (int64_t j = 0; j < i; ++j, ++pairs) {
            c->pair[pairs][0] = j;
            c->pair[pairs][1] = i;
        }
    }
    b.x = vti_view_member(c->x, row * (int64_t)sizeof(double));
    b.v = vti_view_member(c->v, row * (int64_t)sizeof(double));
    b.force = vti_view_packed(c->force);
    b.mass = vti_scalars_array(c->mass);
    return b;
}

/** One pair, and then one body at the walls, after the other. Returns how many of both have been moved. */
static int64_t one_by_one(struct crowd *c, int64_t row, const vti_view *before, vti_contacts contacts,
                          const vti_walls *walls, vti_bodies b)
{
    int64_t moved = 0;
    double was[3];
    for (int64_t k = 0; k < PAIRS; ++k) {
        const double *const v = c->v + row * c->pair[k][0];
        contacts.pair = c->pair[k];
        contacts.count = 1;
        memcpy(was, v, sizeof was);
        assert_int_equal(vti_multistep_touch(0.1, before, &contacts, NULL, &b), VTI_OK);
        moved += memcmp(was, v, sizeof was) != 0;
    }
    assert_true(moved > 10);
    b.count = 1;
    for (b.first = 0; b.first < CROWD; ++b.first) {
        memcpy(was, c->v + row * b.first, sizeof was);
        assert_int_equal(vti_multistep_touch(0.1, before, NULL, walls, &b), VTI_OK);
        moved += memcmp(was, c->v + row * b.first, sizeof was) != 0;
    }
    return moved;
}

/** Those that begin or end are found among many as they are each by itself. */
TEST(many)
{
    static const double plane[2][4] = {{0.6, 0.0, 0.8, -2.0}, {0.0, 1.0, 0.0, -2.0}},
                        cylinder[7] = {0.0, 0.0, 1.0, 0.1, 0.2, 0.0, 3.0};
    static vti_wall_motion motion[] = {{.velocity = {0.3, 0.0, 0.4}}, {.spin = 2.0}, {.velocity = {0.1, -0.2, 0.0}}};
    for (int trial = 0; trial < 8; ++trial) {
        struct crowd at_once, alone;
        vti_sum work = {0.0, 0.0};
        const int64_t row = trial & 1 ? ROW : 3;
        const vti_bodies b = meet(&at_once, row), c = meet(&alone, row);
        const vti_view before = vti_view_member(at_once.before, row * (int64_t)sizeof(double));
        const vti_scalars diameter =
            trial & 2 ? vti_scalars_one(at_once.diameter) : vti_scalars_array(at_once.diameter);
        const vti_contacts contacts = {
            .count = PAIRS, .pair = at_once.pair[0], .diameter = diameter, .stiffness = 10.0};
        vti_walls walls = {.count = 2,
                           .plane = plane[0],
                           .cylinders = 1,
                           .cylinder = cylinder,
                           .diameter = diameter,
                           .stiffness = 10.0};
        if (trial & 4) {
            walls.motion = motion;
            walls.work = &work;
        }
        assert_int_equal(vti_multistep_touch(0.1, &before, &contacts, &walls, &b), VTI_OK);
        assert_true(one_by_one(&alone, row, &before, contacts, &walls, c) > 14);
        assert_same_bits(at_once.x, alone.x, ROW * CROWD);
        assert_same_bits(at_once.v, alone.v, ROW * CROWD);
    }
}

TEST(refusals)
{
    struct scene s, as_before;
    place(&s, -0.1, 0.1, 0.8);
    as_before = s;
    const vti_view before = vti_view_packed(s.before[0]);
    vti_view part = before;
    part.c[1] = NULL;
    vti_contacts no_list = s.contacts;
    no_list.pair = NULL;
    vti_walls no_planes = s.walls;
    no_planes.plane = NULL;
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &s.walls, NULL), VTI_E_NULL);
    assert_int_equal(vti_multistep_touch(0.1, NULL, NULL, &s.walls, &s.b), VTI_E_NULL);
    assert_int_equal(vti_multistep_touch(0.1, &part, NULL, &s.walls, &s.b), VTI_E_VIEW);
    vti_view few = before, one = before;
    vti_bodies two = s.b;
    two.count = 2;
    few.count = 1;
    one.stride = 0;
    assert_int_equal(vti_multistep_touch(0.1, &few, NULL, &s.walls, &two), VTI_E_COUNT);
    assert_int_equal(vti_multistep_touch(0.1, &one, NULL, &s.walls, &two), VTI_E_STRIDE);
    assert_int_equal(vti_multistep_touch(0.1, &s.b.x, NULL, &s.walls, &s.b), VTI_E_ALIAS);
    const vti_view second = {
        {s.b.x.c[0] + s.b.x.stride, s.b.x.c[1] + s.b.x.stride, s.b.x.c[2] + s.b.x.stride}, s.b.x.stride, 0};
    assert_int_equal(vti_multistep_touch(0.1, &second, NULL, &s.walls, &two), VTI_E_ALIAS);
    assert_int_equal(vti_multistep_touch(0.0, &before, NULL, &s.walls, &s.b), VTI_E_TIME);
    assert_int_equal(vti_multistep_touch(INFINITY, &before, NULL, &s.walls, &s.b), VTI_E_TIME);
    assert_int_equal(vti_multistep_touch(0.1, &before, &no_list, NULL, &s.b), VTI_E_NULL);
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &no_planes, &s.b), VTI_E_NULL);
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, NULL, &s.b), VTI_OK);
    vti_bodies b = s.b;
    b.v = vti_view_none();
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &s.walls, &b), VTI_E_NEEDS);
    b = s.b;
    b.force = vti_view_none(); /* beside which v would go with a mass anyway */
    b.mass.p = NULL;
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &s.walls, &b), VTI_E_NEEDS);
    assert_int_equal(vti_multistep_touch(0.1, &before, &s.contacts, NULL, &b), VTI_E_NEEDS);
    double low[3 * BODIES] = {0}, moments[3] = {1, 1, 1};
    for (int k = 0; k < 5; ++k) {
        b = s.b;
        vti_view *const left[] = {&b.x_low, &b.v_low, &b.alpha_low, &b.omega_low, &b.spin_low};
        *left[k] = vti_view_packed(low);
        assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &s.walls, &b), VTI_E_VIEW);
    }
    b = s.b;
    b.inertia.p = NULL;
    b.moments = (vti_view){{moments, moments + 1, moments + 2}, 0, 0};
    assert_int_equal(vti_multistep_touch(0.1, &before, NULL, &s.walls, &b), VTI_E_MOMENTS);
    const vti_bodies none = vti_bodies_none(0); /* of which no array is there to look at */
    assert_int_equal(vti_multistep_touch(0.1, &before, &s.contacts, &s.walls, &none), VTI_OK);
    assert_same_bits(s.x, as_before.x, 3 * BODIES);
    assert_same_bits(s.v, as_before.v, 3 * BODIES);
}

RUN_TESTS(cmocka_unit_test(wall), cmocka_unit_test(pair), cmocka_unit_test(impulse),
          cmocka_unit_test(own_lengths_and_materials), cmocka_unit_test(each_wall), cmocka_unit_test(nothing_crosses),
          cmocka_unit_test(moving_wall), cmocka_unit_test(pairs), cmocka_unit_test(many), cmocka_unit_test(refusals))
