/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The 24 rotations of the cube, where Rodrigues vectors are at their worst: every other product is a half turn, alpha
 * at infinity. Compositions are followed in exact integer matrices. */
#include "support.h"

enum { TRIALS = 1000000 };

typedef struct whole {
    int m[9];
} whole;

static whole times(whole a, whole b)
{
    whole c = {{0}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                c.m[3 * i + j] += a.m[3 * i + k] * b.m[3 * k + j];
    return c;
}

/** The turns by the integer quaternions (u, c): quarter and half turns about the axes, half turns about the face
 *  diagonals, third turns about the space diagonals. */
typedef struct generator {
    double u[3], c;
    whole R;
} generator;

static generator generators[64];
static int count;

static int make_generators(void **state)
{
    (void)state;
    count = 0;
    for (int code = 0; code < 81; ++code) {
        const int x = code % 3 - 1, y = code / 3 % 3 - 1, z = code / 9 % 3 - 1, w = code / 27 - 1;
        const int n = x * x + y * y + z * z + w * w;
        if (n == 0 || n == 3) /* the remaining 1, 2 and 4 divide 2 (products) */
            continue;
        generator *g = &generators[count++];
        const generator made = {
            {x, y, z},
            w,
            {{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n,
              2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n,
              2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
        *g = made;
    }
    assert_int_equal(count, 48); /* each of the 24 as q and as -q */
    return 0;
}

static void compare(const double alpha[3], const whole *exact, double tolerance)
{
    double R[9];
    assert_true(all_finite(alpha, 3));
    vti_rrv_to_matrix(alpha, R);
    for (int k = 0; k < 9; ++k)
        assert_close(R[k], exact->m[k], tolerance);
}

/** An attitude of each of the 24, as alpha. */
static void attitude(const generator *g, double alpha[3])
{
    const double q[4] = {g->u[0], g->u[1], g->u[2], g->c};
    vti_rrv_from_quat_xyzw(q, alpha);
}

/** One composition, from exact attitudes: right to rounding. */
TEST(all_products)
{
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            double a[3], b[3], r[3], R[9];
            attitude(&generators[i], a);
            attitude(&generators[j], b);
            compare(a, &generators[i].R, 4 * EPS);
            const whole after = times(generators[j].R, generators[i].R),
                        before = times(generators[i].R, generators[j].R);
            vti_rrv_compose(a, b, r);
            compare(r, &after, 4 * EPS);
            memcpy(r, a, sizeof r);
            vti_rrv_turn(generators[j].c, generators[j].u, r);
            compare(r, &after, 4 * EPS);
            memcpy(r, a, sizeof r);
            vti_rrv_turn_side(generators[j].c, generators[j].u, -1, r);
            compare(r, &before, 4 * EPS);
            vti_rrv_to_rotvec(r, r);
            assert_true(all_finite(r, 3));
            vti_rrv_from_rotvec(r, r);
            compare(r, &before, 8 * EPS);
            for (int k = 0; k < 9; ++k)
                R[k] = before.m[k];
            vti_rrv_from_matrix(R, r);
            compare(r, &before, 4 * EPS);
        }
}

/** A million of them in a row, by alpha and by pair in turns. Each step rounds by 4 eps at most, half turns lose their
 *  3.5e-18; errors of independent sign would make 4 eps sqrt(N), and an exact angle every few steps makes them less. */
TEST(a_long_product)
{
    rng g = rng_seed(251);
    double a[3] = {0, 0, 0};
    whole exact = {{1, 0, 0, 0, 1, 0, 0, 0, 1}};
    for (int i = 0; i < TRIALS; ++i) {
        const generator *next = &generators[rng_below(&g, count)];
        double b[3];
        const int way = rng_below(&g, 3);
        if (way == 0) {
            attitude(next, b);
            vti_rrv_compose(a, b, a);
        } else {
            vti_rrv_turn_side(next->c, next->u, way == 1 ? 1 : -1, a);
        }
        exact = way < 2 ? times(next->R, exact) : times(exact, next->R);
        if (i % 1000 == 0 || !all_finite(a, 3))
            compare(a, &exact, 4 * EPS * sqrt(TRIALS));
    }
    compare(a, &exact, 4 * EPS * sqrt(TRIALS));
}

/** Near each half turn, closer and closer: the product of two turns by pi/2 + d about any axis is off by d alone. */
TEST(close_to_half_turns)
{
    rng g = rng_seed(252);
    for (int i = 0; i < 200000; ++i) {
        double n[3], theta[3], a[3], r[3];
        random_unit(&g, 3, n);
        const double angle = PI / 2 + (rng_below(&g, 2) ? 1 : -1) * pow(10, uniform(&g, -20, 0));
        for (int k = 0; k < 3; ++k)
            theta[k] = angle * n[k];
        vti_rrv_from_rotvec(theta, a);
        vti_rrv_compose(a, a, r);
        assert_true(all_finite(r, 3));
        const rotor q = quat_of_alpha(a);
        assert_close(quat_distance(quat_of_alpha(r), quat_times(q, q)), 0, 8 * EPS);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_products),
        cmocka_unit_test(a_long_product),
        cmocka_unit_test(close_to_half_turns),
    };
    return cmocka_run_group_tests(tests, make_generators, NULL);
}
