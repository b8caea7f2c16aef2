/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kick, drift and the clearing of loads against their formulas, to the bit, with every quantity in every layout beside
 * every other: the loops that are compiled for one layout do what the loop for any does, and write nowhere else. */
#include "support.h"

enum { N = 13, ROOM = 8 * N };
enum { X, V, FORCE, ALPHA, OMEGA, MOMENT, QUANTITIES };
enum { PACKED, SEPARATE, SPREAD, Y_APART, Z_APART, LAYOUTS };
enum { ONE, ARRAY, MEMBER, SCALARS };

#define GUARD 1.2345678901234567e-89

static double room[QUANTITIES][ROOM], expected[QUANTITIES][N][3], scalar[2 * N];

static vti_view view_in(int layout, double *p)
{
    const vti_view views[LAYOUTS] = {vti_view_packed(p),
                                     vti_view_separate(p, p + N, p + 2 * N),
                                     {{p + 1, p + 4, p}, 5, 0},
                                     {{p, p + 3 * N, p + 2}, 3, 0}, /* stride 3, and yet not x[n][3] */
                                     {{p, p + 1, p + 3 * N + 1}, 3, 0}};
    return views[layout];
}

/** count bodies of random numbers: X and ALPHA lie as layout[0] says, V and OMEGA as [1], FORCE and MOMENT as [2]. */
static vti_bodies fill(int64_t count, const int layout[3], int scalars)
{
    rng g = rng_seed(31);
    vti_bodies b = vti_bodies_none(count);
    vti_view *const views[QUANTITIES] = {&b.x, &b.v, &b.force, &b.alpha, &b.omega, &b.moment};
    for (int q = 0; q < QUANTITIES; ++q) {
        for (int i = 0; i < ROOM; ++i)
            room[q][i] = GUARD;
        *views[q] = view_in(layout[q % 3], room[q]);
        for (int i = 0; i < N; ++i) {
            random_vector(&g, 1, expected[q][i]);
            for (int k = 0; k < 3; ++k)
                views[q]->c[k][i * views[q]->stride] = expected[q][i][k];
        }
    }
    for (int i = 0; i < 2 * N; ++i)
        scalar[i] = uniform(&g, 0.5, 2);
    b.mass.p = b.inertia.p = scalar;
    b.mass.stride = b.inertia.stride = scalars;
    return b;
}

/** The numbers that the views show are the expected ones, and all others are guards still. */
static void as_expected(const vti_bodies *b)
{
    const vti_view *const views[QUANTITIES] = {&b->x, &b->v, &b->force, &b->alpha, &b->omega, &b->moment};
    for (int q = 0; q < QUANTITIES; ++q) {
        int guards = 0;
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < 3; ++k)
                assert_same_bits(&views[q]->c[k][i * views[q]->stride], &expected[q][i][k], 1);
        for (int i = 0; i < ROOM; ++i)
            guards += room[q][i] == GUARD;
        assert_int_equal(guards, ROOM - 3 * N);
    }
}

/** v += t F/m, x += s v; Omega += t RM/J, alpha <- alpha (+) s Omega; then F = RM = 0. */
static void move_expected(int64_t count, int scalars, double t, double s)
{
    for (int64_t i = 0; i < count; ++i) {
        const double k = t / scalar[i * scalars];
        double u[3];
        for (int c = 0; c < 3; ++c) {
            expected[V][i][c] += k * expected[FORCE][i][c];
            expected[X][i][c] += s * expected[V][i][c];
            expected[OMEGA][i][c] += k * expected[MOMENT][i][c];
            u[c] = s * expected[OMEGA][i][c];
            expected[FORCE][i][c] = expected[MOMENT][i][c] = 0.0;
        }
        vti_rrv_turn(2.0, u, expected[ALPHA][i]);
    }
}

TEST(every_layout_beside_every_other)
{
    const double t = 0.3, s = -0.7;
    for (int trial = 0; trial < 2 * SCALARS * LAYOUTS * LAYOUTS * LAYOUTS; ++trial) {
        const int64_t count = trial & 1 ? N : 3; /* few are done in loops of their own */
        const int scalars = trial / 2 % SCALARS, rest = trial / 2 / SCALARS;
        const int layout[3] = {rest % LAYOUTS, rest / LAYOUTS % LAYOUTS, rest / LAYOUTS / LAYOUTS};
        const vti_bodies b = fill(count, layout, scalars);
        assert_int_equal(vti_kick(t, &b), VTI_OK);
        assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, s, &b, NULL), VTI_OK);
        assert_int_equal(vti_apply(NULL, 0, &b), VTI_OK);
        move_expected(count, scalars, t, s);
        as_expected(&b);
    }
}

RUN_TESTS(cmocka_unit_test(every_layout_beside_every_other))
