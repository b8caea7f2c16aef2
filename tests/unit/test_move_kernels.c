/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Moves of many bodies by the kernels of every vector width against the same bodies moved one by one, to the bit: all
 * layouts, laws and frames, no kick, one and two, attitudes past half a turn and of any size, spins of any size. And
 * vti_step_next against the finish and the begin that it stands for. The kernels' tables are private to the library. */
#include "../../src/lanes/vti_lanes.h" /* WIDTH, of this build */
#include "../../src/vti_move.h"
#include "units.h"

enum { N = 59, FAST = 40, ROOM = 24 * N };
enum { PACKED, SEPARATE, STRUCTS, BESIDE, LAYOUTS }; /* BESIDE: omega and v packed, all else separate */

struct body_memory {
    double all[8][ROOM], mass[N], inertia[N];
};
static struct body_memory one, many, before;

static vti_view view_in(int layout, double *p, int is_velocity)
{
    const vti_view in_struct = {{p + 5, p + 6, p + 7}, 21, 0};
    if (layout == STRUCTS)
        return in_struct;
    return layout == PACKED || (layout == BESIDE && is_velocity) ? vti_view_packed(p)
                                                                 : vti_view_separate(p, p + N, p + 2 * N);
}

enum { ONE_MASS = 1, ONE_INERTIA = 2 }; /* of all bodies */

static vti_bodies bodies_in(int layout, int by_quat, int ones, struct body_memory *m)
{
    vti_bodies b = vti_bodies_none(N);
    b.x = view_in(layout, m->all[0], 0);
    b.v = view_in(layout, m->all[1], 1);
    b.force = view_in(layout, m->all[2], 0);
    b.omega = view_in(layout, m->all[3], 1);
    b.moment = view_in(layout, m->all[4], 0);
    double *const q = m->all[5];
    const vti_quat_view side_by_side = {{q, q + 1, q + 2, q + 3}, 4 + 3 * (layout == STRUCTS), 0},
                        separate = {{q, q + N, q + 2 * N, q + 3 * N}, 1, 0};
    if (!by_quat)
        b.alpha = view_in(layout, q, 0);
    else
        b.quat = layout == SEPARATE ? separate : side_by_side;
    b.mass = ones & ONE_MASS ? vti_scalars_one(m->mass) : vti_scalars_array(m->mass);
    b.inertia = ones & ONE_INERTIA ? vti_scalars_one(m->inertia) : vti_scalars_array(m->inertia);
    return b;
}

/** Random bodies; some are near or past half a turn, those from FAST on turn by several radians, where c of the
 *  exact laws is negative, and two are of huge numbers. closed: all turn by less than 1. */
static void fill(rng *g, int closed, const vti_bodies *b)
{
    for (int64_t i = 0; i < N; ++i) {
        const double size = i >= FAST ? 0.1 : i % 11 == 3 ? 1e3 : i % 11 == 5 ? 1e12 : i == 29 ? 1e200 : 1.0;
        const double speed = closed ? 0.3 : i % 13 == 7 ? 9.0 : i >= FAST ? 40.0 : i == 31 ? 1e180 : 1.0;
        double u[3];
        for (int k = 0; k < 3; ++k) {
            b->x.c[k][i * b->x.stride] = uniform(g, -1, 1);
            b->v.c[k][i * b->v.stride] = uniform(g, -1, 1);
            b->force.c[k][i * b->force.stride] = uniform(g, -1, 1);
            b->moment.c[k][i * b->moment.stride] = uniform(g, -1, 1);
            b->omega.c[k][i * b->omega.stride] = speed * uniform(g, -1, 1);
            u[k] = size * uniform(g, -1, 1);
            if (b->alpha.c[0] != NULL)
                b->alpha.c[k][i * b->alpha.stride] = u[k];
        }
        for (int k = 0; k < 4 && b->quat.xyzw[0] != NULL; ++k)
            b->quat.xyzw[k][i * b->quat.stride] = uniform(g, -1, 1);
    }
    if (b->alpha.c[0] != NULL) { /* one is huge, and turns about an axis across it: only its size tells */
        double *const *alpha = b->alpha.c, *const *omega = b->omega.c, *const *moment = b->moment.c;
        const int64_t i = 16, w = i * b->omega.stride, m = i * b->moment.stride, a = i * b->alpha.stride;
        for (int k = 0; k < 3; ++k)
            moment[k][m] = 0.5 * omega[k][w];
        alpha[0][a] = -1e12 * omega[1][w];
        alpha[1][a] = 1e12 * omega[0][w];
        alpha[2][a] = 0.0;
    }
}

/** Moves what kernels have left: translates bodies from one on, turns them from another on. */
static void move_rest(const struct vti_move *move, const vti_bodies *b, int64_t translated, int64_t turned)
{
    vti_bodies left = vti_bodies_slice(*b, translated, N - translated);
    left.alpha = left.omega = left.moment = vti_view_none();
    left.quat = vti_bodies_none(0).quat;
    vti_move_all(move, &left);
    left = vti_bodies_slice(*b, turned, N - turned);
    left.x = left.v = left.force = vti_view_none();
    vti_move_all(move, &left);
}

/** The move body by body, by the public primitives: fewer bodies than any kernel takes. */
static void expect(const struct vti_move *move, const vti_bodies *b)
{
    for (int64_t i = 0; i < N; ++i) {
        const vti_bodies slice = vti_bodies_slice(*b, i, 1);
        assert_int_equal(vti_kick(move->before, &slice), VTI_OK);
        assert_int_equal(vti_kick(move->kick, &slice), VTI_OK);
        if (move->drifts)
            assert_int_equal(vti_drift(move->law, move->frame, move->drift, &slice, NULL), VTI_OK);
    }
}

static void agree(const struct vti_move_kernels *kernels, int64_t width)
{
    static const double kicks[4][2] = {{0.0, 0.0}, {0.0, 0.3}, {0.3, 0.3}, {0.2, -0.3}};
    enum { CASES = LAYOUTS * 2 * 4 * 4 * 2 * 4 * 2 };
    rng g = rng_seed(3);
    for (int k = 0; k < CASES; ++k) {
        const int layout = k % LAYOUTS, by_quat = k / LAYOUTS % 2, ones = k / (2 * LAYOUTS) % 4;
        const double *const kick = kicks[k / (8 * LAYOUTS) % 4];
        const int drifts = k / (32 * LAYOUTS) % 2, law = 1 + k / (64 * LAYOUTS) % 4;
        const int frame = k / (256 * LAYOUTS) % 2 ? VTI_FRAME_BODY : VTI_FRAME_SPACE;
        const struct vti_move move = {kick[0], kick[1], 0.2, drifts, law, frame, 0};
        for (int i = 0; i < N; ++i) {
            before.mass[i] = uniform(&g, 0.5, 2);
            before.inertia[i] = uniform(&g, 0.5, 2);
        }
        const vti_bodies start = bodies_in(layout, by_quat, ones, &before);
        fill(&g, law == VTI_LAW_CLOSED, &start);
        one = many = before;
        const vti_bodies expected = bodies_in(layout, by_quat, ones, &one), b = bodies_in(layout, by_quat, ones, &many);
        expect(&move, &expected);
        const int mixed = layout == STRUCTS || (layout == BESIDE && (kick[0] != 0.0 || kick[1] != 0.0));
        const int sorts = !mixed || width < 8; /* twice four are sorted faster than eight */
        int64_t stopped;
        /* some spin where the law is another */
        assert_int_equal(kernels->reaches(&move, &b, 0, N, &stopped), sorts && law != VTI_LAW_CLOSED);
        assert_true(stopped == (sorts ? N / width * width : 0));
        const int64_t moved = kernels->translate(&move, &b, 0, N), turned = kernels->rotate(&move, &b, 0, N);
        move_rest(&move, &b, moved, turned);
        if (layout == PACKED || layout == SEPARATE) /* not all is left over */
            assert_true(moved == N / width * width && turned == moved);
        assert_same_bits(&many, &one, sizeof one / sizeof(double));
        many = before;
        const int64_t both = kernels->both(&move, &b, 0, N);
        move_rest(&move, &b, both, both);
        if (layout != BESIDE) /* which lies one way where nothing but velocities moves */
            assert_true(both == (layout == STRUCTS ? 0 : moved));
        assert_same_bits(&many, &one, sizeof one / sizeof(double));
    }
}

TEST(baseline)
{
    agree(&vti_move_baseline, WIDTH);
}

ON_AVX2(agree(&vti_move_avx2, WIDTH > 4 ? WIDTH : 4))
ON_AVX512(agree(&vti_move_avx512, 8))

/** The bound sees a body that reaches 1, or is NaN, wherever it stands; nothing is written then. */
TEST(the_bound_sees_every_body)
{
    rng g = rng_seed(5);
    const vti_stepper *vti1 = vti_stepper_find("vti1");
    for (int trial = 0; trial < 2 * LAYOUTS * N; ++trial) {
        const int layout = trial % LAYOUTS, bad = trial / LAYOUTS % N, nan = trial / LAYOUTS / N;
        for (int i = 0; i < N; ++i)
            before.mass[i] = before.inertia[i] = 1.0;
        const vti_bodies b = bodies_in(layout, 0, 0, &before);
        fill(&g, 1, &b);
        b.omega.c[1][bad * b.omega.stride] = nan ? NAN : 3.0;
        many = before;
        vti_fault fault;
        assert_int_equal(vti_step_begin(vti1, 0.5, &b, &fault), VTI_E_TOO_LARGE);
        assert_int_equal(fault.body, bad);
        assert_same_bits(&many, &before, sizeof many / sizeof(double));
        assert_int_equal(vti_step_next(vti1, 0.5, &b, &fault), VTI_E_TOO_LARGE);
        assert_int_equal(fault.body, bad);
        assert_same_bits(&many, &before, sizeof many / sizeof(double));
    }
}

/** So many bodies in 20 n numbers, of quaternions in 21 n. */
static vti_bodies crowd_in(double *p, int64_t n, int separate, int by_quat)
{
    vti_bodies b = vti_bodies_none(n);
    vti_view *const views[] = {&b.x, &b.v, &b.force, &b.omega, &b.moment, &b.alpha};
    for (int q = 0; q < (by_quat ? 5 : 6); ++q) {
        double *const x = p + 3 * q * n;
        *views[q] = separate ? vti_view_separate(x, x + n, x + 2 * n) : vti_view_packed(x);
    }
    for (int k = 0; k < 4 && by_quat; ++k)
        b.quat.xyzw[k] = separate ? p + (17 + k) * n : p + 17 * n + k;
    b.quat.stride = by_quat && !separate ? 4 : 1;
    double *const m = p + (by_quat ? 15 : 18) * n;
    b.mass = vti_scalars_array(m);
    b.inertia = vti_scalars_array(m + n);
    return b;
}

/** Bodies of more than a block and a strip that begin at any place in a line of the cache: `vti_move_all` leaves none
 *  out, and moves none twice. */
TEST(a_crowd_moves_body_by_body)
{
    enum { CROWD = 4096 + 1024 + 45, SHIFTS = 8, NUMBERS = 20 * CROWD };
    static double whole[NUMBERS + SHIFTS], each[NUMBERS + SHIFTS];
    const struct vti_move move = {0.1, 0.2, 0.3, 1, VTI_LAW_EXACT, VTI_FRAME_SPACE, 0};
    for (int shift = 0; shift < SHIFTS; ++shift)
        for (int separate = 0; separate < 2; ++separate) {
            rng g = rng_seed((uint64_t)shift + 11);
            for (int k = 0; k < NUMBERS; ++k)
                whole[shift + k] = each[shift + k] = uniform(&g, 0.5, 1.5);
            const vti_bodies all = crowd_in(whole + shift, CROWD, separate, 0),
                             alone = crowd_in(each + shift, CROWD, separate, 0);
            vti_move_all(&move, &all);
            for (int64_t i = 0; i < CROWD; ++i) {
                const vti_bodies slice = vti_bodies_slice(alone, i, 1);
                vti_move_all(&move, &slice);
            }
            assert_same_bits(whole + shift, each + shift, NUMBERS);
        }
}

/** So many that they are prefetched have the bits of fewer. */
TEST(bodies_are_prefetched_with_the_same_bits)
{
    enum { CROWD = (1 << 19) + 45, PART = 1 << 17, NUMBERS = 21 * CROWD };
    double *const whole = malloc(2 * NUMBERS * sizeof *whole), *const parts = whole + NUMBERS;
    assert_non_null(whole);
    for (int k = 0; k < 8; ++k) {
        const int drifts = k % 2, separate = k / 2 % 2, by_quat = k / 4;
        const struct vti_move move = {0.0, 0.2, 0.3, drifts, VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0};
        rng g = rng_seed((uint64_t)k + 13);
        for (int64_t n = 0; n < NUMBERS; ++n)
            whole[n] = parts[n] = uniform(&g, 0.5, 1.5);
        const vti_bodies all = crowd_in(whole, CROWD, separate, by_quat),
                         fewer = crowd_in(parts, CROWD, separate, by_quat);
        vti_move_all(&move, &all);
        for (int64_t i = 0; i < CROWD; i += PART) {
            const vti_bodies slice = vti_bodies_slice(fewer, i, CROWD - i < PART ? CROWD - i : PART);
            vti_move_all(&move, &slice);
        }
        assert_same_bits(whole, parts, NUMBERS);
    }
    free(whole);
}

TEST(next_is_finish_and_begin)
{
    rng g = rng_seed(7);
    for (int64_t s = 0; s < vti_stepper_count(); ++s)
        for (int layout = 0; layout < LAYOUTS; ++layout) {
            const vti_stepper *const method = vti_stepper_at(s);
            for (int i = 0; i < N; ++i)
                before.mass[i] = before.inertia[i] = uniform(&g, 0.5, 2);
            const vti_bodies start = bodies_in(layout, 0, 0, &before);
            fill(&g, 1, &start);
            one = many = before;
            const vti_bodies expected = bodies_in(layout, 0, 0, &one), b = bodies_in(layout, 0, 0, &many);
            vti_fault fault;
            if (method->drift[method->stages] != 0.0) {
                assert_int_equal(vti_step_next(method, 0.1, &b, &fault), VTI_E_STAGE);
                assert_same_bits(&many, &before, sizeof many / sizeof(double));
                continue;
            }
            assert_int_equal(vti_step_finish(method, 0.1, &expected), VTI_OK);
            assert_int_equal(vti_step_begin(method, 0.1, &expected, NULL), VTI_OK);
            assert_int_equal(vti_step_next(method, 0.1, &b, &fault), VTI_OK);
            assert_same_bits(&many, &one, sizeof many / sizeof(double));
        }
}

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512),
          cmocka_unit_test(the_bound_sees_every_body), cmocka_unit_test(a_crowd_moves_body_by_body),
          cmocka_unit_test(bodies_are_prefetched_with_the_same_bits), cmocka_unit_test(next_is_finish_and_begin))
