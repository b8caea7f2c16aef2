/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The Rodrigues algebra over the whole range of doubles: for random bit patterns, zeros and subnormals included, every
 * result is finite and right. The reference has the exponents of long double, where no square overflows. */
#include "support.h"

enum { TRIALS = 1000000 };

#define TINY 5e-324
#define CUT 6e-18

static void random_bits(rng *g, int n, double v[])
{
    for (int k = 0; k < n; ++k)
        v[k] = rng_below(g, 16) == 0 ? 0.0 : random_finite(g);
    /* in every other trial the components are of like size, as those of real vectors are */
    for (int k = 1, like = rng_below(g, 2); like && k < n; ++k) {
        const double next = v[0] * uniform(g, -1, 1);
        v[k] = isfinite(next) ? next : 0.0;
    }
}

static long double norm_of(const double v[3])
{
    const long double x = v[0], y = v[1], z = v[2];
    return sqrtl(x * x + y * y + z * z);
}

static rotor pair_quat(double c, const double u[3])
{
    const rotor q = {u[0], u[1], u[2], c};
    return quat_unit(q);
}

/** The representation of long double must hold squares of doubles; where it does not, there is no reference. */
static int needs_long_double(void **state)
{
    (void)state;
    return LDBL_MAX_EXP > 2 * DBL_MAX_EXP + 8 ? 0 : -1;
}

static void fail_with(const char *what, const double *a, int n, double error)
{
    print_error("%s is off by %.3g or not finite, for", what, error);
    for (int k = 0; k < n; ++k)
        print_error(" %.17g", a[k]);
    print_error("\n");
    fail();
}

TEST(compose)
{
    rng g = rng_seed(101);
    for (int i = 0; i < TRIALS; ++i) {
        double in[6], r[3];
        random_bits(&g, 3, in);
        random_bits(&g, 3, in + 3);
        const rotor expected = quat_times(quat_of_alpha(in + 3), quat_of_alpha(in));
        vti_rrv_compose(in, in + 3, r);
        const double off = all_finite(r, 3) ? quat_distance(quat_of_alpha(r), expected) : INFINITY;
        if (!(off <= 8 * EPS + CUT) || !(vti_max3(r) <= VTI_RRV_LARGE * (1 + 4 * EPS)))
            fail_with("composition", in, 6, off);
    }
}

/** An increment (c, u) of any length, in space and in the body's frame. */
TEST(turn)
{
    rng g = rng_seed(107);
    for (int i = 0; i < TRIALS; ++i) {
        double in[7], a[3];
        random_bits(&g, 3, in);
        random_bits(&g, 4, in + 3);
        const double *u = in + 3, c = in[6], side = rng_below(&g, 2) ? 1 : -1;
        if (c == 0 && u[0] == 0 && u[1] == 0 && u[2] == 0)
            continue;
        const rotor q = quat_of_alpha(in), d = pair_quat(c, u);
        memcpy(a, in, sizeof a);
        vti_rrv_turn_side(c, u, side, a);
        const rotor expected = side > 0 ? quat_times(d, q) : quat_times(q, d);
        const double off = all_finite(a, 3) ? quat_distance(quat_of_alpha(a), expected) : INFINITY;
        if (!(off <= 8 * EPS + CUT) || !(vti_max3(a) <= VTI_RRV_LARGE * (1 + 4 * EPS)))
            fail_with("turn", in, 7, off);
    }
}

/** R p may overflow only if it does so itself; |r_k| <= |p|. */
TEST(rotate)
{
    rng g = rng_seed(102);
    for (int i = 0; i < TRIALS; ++i) {
        double in[6], r[3], expected[3];
        random_bits(&g, 6, in);
        const double *a = in, *p = in + 3;
        const long double size = norm_of(p);
        if (size > DBL_MAX * (1 - 8 * EPS))
            continue;
        const rotor q = quat_of_alpha(a);
        for (int back = 0; back < 2; ++back) {
            (back ? vti_rrv_rotate_back : vti_rrv_rotate)(a, p, r);
            quat_rotate(back ? quat_conj(q) : q, p, expected);
            for (int k = 0; k < 3; ++k)
                if (!(fabs(r[k] - expected[k]) <= 8 * EPS * (double)size + 16 * TINY))
                    fail_with("R p", in, 6, r[k] - expected[k]);
        }
    }
}

TEST(convert_alpha)
{
    rng g = rng_seed(103);
    for (int i = 0; i < TRIALS; ++i) {
        double a[3], theta[3], q[4], R[9], b[3];
        random_bits(&g, 3, a);
        const long double size = norm_of(a), angle = 2 * atan2l(size, 2);
        const rotor exact = quat_of_alpha(a);

        vti_rrv_to_rotvec(a, theta);
        for (int k = 0; k < 3; ++k) {
            const double expected = size > 0 ? (double)(angle * (a[k] / size)) : 0.0;
            if (!(fabs(theta[k] - expected) <= 6 * EPS * fabs(expected) + 2 * TINY))
                fail_with("log", a, 3, theta[k] - expected);
        }
        vti_rrv_to_quat_xyzw(a, q);
        const rotor ours = {q[0], q[1], q[2], q[3]};
        const double length = (double)(ours.x * ours.x + ours.y * ours.y + ours.z * ours.z + ours.w * ours.w);
        if (!(quat_distance(quat_unit(ours), exact) <= 4 * EPS) || !(fabs(length - 1) <= 4 * EPS))
            fail_with("quaternion", a, 3, length - 1);
        vti_rrv_to_matrix(a, R);
        vti_rrv_from_matrix(R, b);
        const double off = all_finite(R, 9) && all_finite(b, 3) ? quat_distance(quat_of_alpha(b), exact) : INFINITY;
        if (!(off <= 12 * EPS + CUT)) /* 8 eps of the matrix, as in test_rrv_table.c, and back */
            fail_with("alpha -> R -> alpha", a, 3, off);
    }
}

TEST(arc)
{
    rng g = rng_seed(107);
    for (int i = 0; i < TRIALS; ++i) {
        double in[2];
        random_bits(&g, 2, in);
        in[i % 2] = i % 4 < 2 ? in[i % 2] : in[1 - i % 2] * uniform(&g, 0, 1); /* all slopes alike */
        const double y = fabs(in[0]), x = fabs(in[1]), found = vti_arc(y, x);
        const long double expected = atan2l(y, x);
        if (!(fabsl(found - expected) <= 1.5L * EPS * expected + TINY))
            fail_with("arc", in, 2, (double)(found - expected));
    }
    assert_true(vti_arc(0, 0) == 0 && vti_arc(0, 1) == 0 && vti_arc(1, 0) == 0.5 * PI && vti_arc(1, 1) == 0.25 * PI);
    assert_true(isnan(vti_arc(NAN, 1)) && isnan(vti_arc(1, NAN)));
}

/** Everywhere, beside right angles, and where libm takes over. */
TEST(sine_and_cosine)
{
    rng g = rng_seed(108);
    for (int i = 0; i < TRIALS; ++i) {
        const double most = i % 3 == 0 ? 0x1p20 : 8, right = floor(uniform(&g, -667544, 667544)) * (0.5 * PI);
        const double t = i % 3 == 1 ? right : i == 0 ? 1.5e6 : uniform(&g, -most, most);
        double s, c;
        vti_sin_cos(t, &s, &c);
        if (!(fabsl(s - sinl(t)) <= EPS) || !(fabsl(c - cosl(t)) <= EPS))
            fail_with("sine or cosine", &t, 1, (double)(s - sinl(t)));
    }
    for (int i = 0; i < 3; ++i) {
        double s, c;
        vti_sin_cos(i == 0 ? NAN : i == 1 ? INFINITY : -INFINITY, &s, &c);
        assert_true(isnan(s) && isnan(c));
    }
}

TEST(norm_and_angle)
{
    rng g = rng_seed(104);
    for (int i = 0; i < TRIALS; ++i) {
        double a[3];
        random_bits(&g, 3, a);
        const long double size = norm_of(a);
        const double angle = (double)(2 * atan2l(size, 2));
        if (!(fabs(vti_rrv_angle(a) - angle) <= 4 * EPS * angle + 2 * TINY))
            fail_with("angle", a, 3, vti_rrv_angle(a) - angle);
        if (size <= DBL_MAX * (1 - 4 * EPS) && !(fabsl(vti_norm(a) - size) <= 2 * EPS * size + 2 * TINY))
            fail_with("norm", a, 3, (double)(vti_norm(a) - size));
    }
}

TEST(convert_to_alpha)
{
    rng g = rng_seed(105);
    for (int i = 0; i < TRIALS; ++i) {
        double q[4], a[3], off;
        random_bits(&g, 4, q);
        if (q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0) {
            vti_rrv_from_quat_xyzw(q, a);
            off = all_finite(a, 3) ? quat_distance(quat_of_alpha(a), pair_quat(q[3], q)) : INFINITY;
            if (!(off <= 4 * EPS + CUT))
                fail_with("alpha of a quaternion", q, 4, off);
        }
        vti_rrv_from_rotvec(q, a);
        const long double angle = norm_of(q);
        off = all_finite(a, 3) ? quat_distance(quat_of_alpha(a), quat_turn(q, angle)) : INFINITY;
        /* sinl is trusted to 2^60; beyond 1/eps radians |theta| is known to no better than a turn anyway */
        if (!(off <= (angle < 1e12L ? 4 * EPS * (1 + (double)angle) + CUT : 2 * PI)))
            fail_with("alpha of a rotation vector", q, 3, off);
    }
}

/** cos(6381956970095103 2^797) = -4.7e-19: no double comes nearer to an odd number of right angles. Twice that is a
 *  half turn, whose tangent lies beyond the largest alpha: cut off as compositions are, on every axis, either way
 *  round. */
TEST(nearest_half_turn)
{
    for (int k = 0; k < 6; ++k) {
        double theta[3] = {0, 0, 0}, a[3];
        theta[k % 3] = (k < 3 ? 2.0 : -2.0) * 6381956970095103.0 * 0x1p797;
        vti_rrv_from_rotvec(theta, a);
        assert_close(fabs(a[k % 3]), VTI_RRV_LARGE, 4 * EPS * VTI_RRV_LARGE);
        assert_true(a[(k + 1) % 3] == 0 && a[(k + 2) % 3] == 0);
        assert_true((a[k % 3] < 0) == (k < 3)); /* sin is 1 there, cos negative: w turns negative */
    }
}

/** Distance of attitudes, and that it is finite, symmetric and at most pi. */
TEST(distance)
{
    rng g = rng_seed(106);
    for (int i = 0; i < TRIALS; ++i) {
        double in[6];
        random_bits(&g, 6, in);
        const double d = vti_rrv_distance(in, in + 3);
        const double off = d - quat_distance(quat_of_alpha(in), quat_of_alpha(in + 3));
        if (!(fabs(off) <= 8 * EPS) || !(d <= PI) || d != vti_rrv_distance(in + 3, in))
            fail_with("distance", in, 6, off);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(compose),
        cmocka_unit_test(turn),
        cmocka_unit_test(rotate),
        cmocka_unit_test(convert_alpha),
        cmocka_unit_test(norm_and_angle),
        cmocka_unit_test(convert_to_alpha),
        cmocka_unit_test(distance),
        cmocka_unit_test(nearest_half_turn),
        cmocka_unit_test(arc),
        cmocka_unit_test(sine_and_cosine),
    };
    return cmocka_run_group_tests(tests, needs_long_double, NULL);
}
