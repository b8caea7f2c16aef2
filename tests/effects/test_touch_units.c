/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Touches done many at once, by the kernels of every vector width, have the bits of one after the other: all layouts and
 * laws, materials, pairs that part, that meet, that pass through each other and that no list need have. The kernels'
 * tables are private to the library. */
#include "support.h"

#include "../../src/vti_carry.h"
#include "../../src/vti_touch_table.h"

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
        vti_carry_motion(&c, NULL, b, drifted);
        delta[k] = c.touch.delta;
        if (!(c.delta0 >= -p->reach))
            delta[k] = INFINITY;
        else
            vti_carry_held(p, &c, &held[k]);
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
        const vti_drifted drifted = {trial % 4 ? 0.1 : 0.5, 1 + trial / LAYOUTS % 4, VTI_FRAME_SPACE};
        if (drifted.law == VTI_LAW_CLOSED) /* all turn by less than 1 */
            for (int64_t i = 0; i < N; ++i)
                put(&b.omega, i, uniform(&g, -1, 1), uniform(&g, -1, 1), uniform(&g, -1, 1));
        else if (trial % 8 == 5)
            put(&b.omega, 7, 1e30, 1.0, 2.0);
        start = bodies;
        struct vti_carried pairs = {.count = PAIRS};
        for (int64_t k = 0; k < VTI_TOUCHES; ++k) {
            const int64_t at = k < PAIRS ? k : PAIRS - 1;
            const struct vti_seat seat = {bodies.pair[at][0] - 1, bodies.pair[at][1] - 1, at};
            pairs.seat[k] = seat;
            pairs.held[k] = &bodies.held[at];
        }
        kernels->carry(&many, &b, &drifted, &pairs);
        expect(&one, &b, &drifted, start.held, delta);
        assert_memory_equal(bodies.held, start.held, sizeof bodies.held);
        assert_same_bits(pairs.delta, delta, PAIRS);
        assert_same_bits(lost_too, lost, 2 * VTI_FRICTION_BOOKS);
    }
}

TEST(baseline)
{
    carries(&vti_touch_baseline);
}

TEST(avx2)
{
#ifdef VTI_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) {
        carries(&vti_touch_avx2);
        return;
    }
#endif
    skip();
}

TEST(avx512)
{
#ifdef VTI_HAS_AVX512
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
        carries(&vti_touch_avx512);
        return;
    }
#endif
    skip();
}

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
