/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The Rodrigues algebra against the 50-digit table of rrv_reference.py. Attitudes are compared by the angle between
 * them; below 2 rad, where alpha is a good coordinate, alpha itself must be right to a few units in its last place. */
#include "support.h"

#include "rrv_reference.h"

/* A half turn is cut off at |alpha_i| = 2^60, an error of 4/(2^60) rad = 3.5e-18; 6e-18 with rounding. */
#define CUT 6e-18
/* A unit in the last place of a subnormal number. */
#define TINY 5e-324

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/** alpha stands for the attitude q: within `ulps` eps of angle, and of relative size where the angle is below 2 rad.
 *  ulps is beyond 12 only for rotation vectors of more than 2 rad, whose small remainder is not known so well. */
static void check_alpha(const double alpha[3], const double q[4], double ulps)
{
    assert_true(all_finite(alpha, 3));
    const rotor r = quat_of_xyzw(q);
    assert_close(quat_distance(quat_of_alpha(alpha), r), 0, ulps * EPS + CUT);
    if (ulps <= 12 && 2 * acosl(fabsl(r.w)) < 2) {
        const double expected[3] = {(double)(2 * r.x / r.w), (double)(2 * r.y / r.w), (double)(2 * r.z / r.w)};
        assert_close3(alpha, expected, ulps * EPS * vti_max3(expected) + 2 * TINY);
    }
}

/** The half turn has two rotation vectors, theta and -theta. */
static void check_theta(const double theta[3], const double expected[3])
{
    const double size = vti_max3(expected), tolerance = 4 * EPS * size + TINY;
    const double sign = size > 1 && vti_dot(theta, expected) < 0 ? -1 : 1;
    if (sign < 0)
        assert_close(vti_norm(expected), PI, 8 * EPS);
    for (int k = 0; k < 3; ++k)
        assert_close(sign * theta[k], expected[k], tolerance);
}

TEST(rotation_vector_to_alpha)
{
    for (size_t i = 0; i < COUNT(rotvec_cases); ++i) {
        double a[3];
        vti_rrv_from_rotvec(rotvec_cases[i].input, a);
        /* |theta| is known to 1.5 eps of itself, its tangent to 1 eps more */
        check_alpha(a, rotvec_cases[i].quat, 4 * (1 + vti_norm(rotvec_cases[i].input)));
        for (int k = 0; k < 3; ++k)
            assert_below(fabs(a[k]), VTI_RRV_LARGE * (1 + 4 * EPS));
    }
}

TEST(alpha_to_rotation_vector)
{
    for (size_t i = 0; i < COUNT(alpha_cases); ++i) {
        double theta[3];
        vti_rrv_to_rotvec(alpha_cases[i].input, theta);
        check_theta(theta, alpha_cases[i].theta);
    }
}

TEST(angle_of_alpha)
{
    for (size_t i = 0; i < COUNT(alpha_cases); ++i) {
        const double expected = alpha_cases[i].angle;
        assert_close(vti_rrv_angle(alpha_cases[i].input), expected, 4 * EPS * expected + TINY);
    }
}

TEST(quaternions)
{
    for (size_t i = 0; i < COUNT(alpha_cases); ++i) {
        const struct alpha_case *c = &alpha_cases[i];
        double q[4], a[3], scaled[4];
        vti_rrv_to_quat_xyzw(c->input, q);
        for (int k = 0; k < 4; ++k)
            assert_close(q[k], c->quat[k], 3 * EPS * fabs(c->quat[k]) + TINY);
        assert_true(q[3] >= 0);
        vti_rrv_from_quat_xyzw(c->quat, a);
        check_alpha(a, c->quat, 4);
        /* neither the length nor the sign of a quaternion matters; powers of two change no bit */
        for (int k = 0; k < 4; ++k)
            scaled[k] = -0x1p300 * c->quat[k];
        vti_rrv_from_quat_xyzw(scaled, scaled);
        if (vti_max3(c->quat) > 1e-200)
            assert_same_bits(scaled, a, 3);
    }
}

TEST(matrices)
{
    for (size_t i = 0; i < COUNT(alpha_cases); ++i) {
        double R[9], a[3];
        vti_rrv_to_matrix(alpha_cases[i].input, R);
        /* an entry is a sum of products of two numbers <= 1, each with an error of 3 eps */
        assert_close_all("R", R, alpha_cases[i].matrix, 9, 8 * EPS, __FILE__, __LINE__);
        /* the entries of the reference are rounded themselves; a difference of two of them doubles that */
        vti_rrv_from_matrix(alpha_cases[i].matrix, a);
        check_alpha(a, alpha_cases[i].quat, 6);
    }
    for (size_t i = 0; i < COUNT(rotvec_cases); ++i) {
        double a[3];
        vti_rrv_from_matrix(rotvec_cases[i].matrix, a);
        check_alpha(a, rotvec_cases[i].quat, 6);
    }
}

TEST(rotated_vectors)
{
    const double tolerance = 8 * EPS * vti_norm(reference_vector);
    for (size_t i = 0; i < COUNT(alpha_cases); ++i) {
        double r[3];
        vti_rrv_rotate(alpha_cases[i].input, reference_vector, r);
        assert_close3(r, alpha_cases[i].rotated, tolerance);
        vti_rrv_rotate_back(alpha_cases[i].input, reference_vector, r);
        assert_close3(r, alpha_cases[i].rotated_back, tolerance);
    }
}

TEST(compositions)
{
    for (size_t i = 0; i < COUNT(pair_cases); ++i) {
        const struct pair_case *c = &pair_cases[i];
        double r[3], minus[3];
        vti_rrv_compose(c->a, c->b, r);
        check_alpha(r, c->composed, 8);
        vti_rrv_relative(c->a, c->b, r);
        check_alpha(r, c->relative, 8);
        vti_rrv_relative_printed(c->a, c->b, r);
        check_alpha(r, c->relative_printed, 8);
        vti_rrv_inverse(c->b, minus);
        vti_rrv_compose(minus, c->a, r);
        check_alpha(r, c->relative, 8);
        /* an angle between products with errors of 4 eps each */
        assert_close(vti_rrv_distance(c->a, c->b), c->distance, 8 * EPS);
    }
}

/** The increment as a pair: spatial on the left, in the body's frame on the right; its length and sign do not
 *  matter. */
TEST(turns)
{
    for (size_t i = 0; i < COUNT(pair_cases); ++i) {
        const struct pair_case *c = &pair_cases[i];
        const rotor p = quat_of_alpha(c->a), q = quat_of_alpha(c->b), left = quat_times(q, p), right = quat_times(p, q);
        for (int k = 0; k < 4; ++k) {
            const double s = (k & 1 ? -1 : 1) * (k & 2 ? 0x1p-40 : 1), u[3] = {s * c->b[0], s * c->b[1], s * c->b[2]};
            double a[3];
            memcpy(a, c->a, sizeof a);
            vti_rrv_turn(2 * s, u, a);
            assert_close(quat_distance(quat_of_alpha(a), left), 0, 8 * EPS + CUT);
            memcpy(a, c->a, sizeof a);
            vti_rrv_turn_side(2 * s, u, -1, a);
            assert_close(quat_distance(quat_of_alpha(a), right), 0, 8 * EPS + CUT);
        }
    }
}

TEST(zero_is_the_identity)
{
    const double zero[3] = {0, 0, 0}, eye[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, one[4] = {0, 0, 0, 1};
    double r[9];
    vti_rrv_from_rotvec(zero, r);
    assert_close3(r, zero, 0);
    vti_rrv_to_rotvec(zero, r);
    assert_close3(r, zero, 0);
    vti_rrv_to_quat_xyzw(zero, r);
    assert_same_bits(r, one, 4);
    vti_rrv_to_matrix(zero, r);
    assert_close_all("R", r, eye, 9, 0, __FILE__, __LINE__);
    vti_rrv_from_matrix(eye, r);
    assert_close3(r, zero, 0);
    vti_rrv_compose(zero, zero, r);
    assert_close3(r, zero, 0);
    vti_rrv_rotate(zero, reference_vector, r);
    assert_same_bits(r, reference_vector, 3);
    assert_true(vti_rrv_angle(zero) == 0 && vti_rrv_distance(zero, zero) == 0);
}

/** A quaternion of four zeros is no attitude: NaN shows it, wherever it goes in. */
TEST(no_attitude)
{
    const double none[4] = {0, 0, 0, 0}, p[3] = {1, 2, 3};
    double a[3] = {0, 0, 0}, r[3] = {0, 0, 0};
    vti_rrv_from_quat_xyzw(none, a);
    vti_pair_rotate(none, 1, p, r);
    for (int k = 0; k < 3; ++k)
        assert_true(isnan(a[k]) && isnan(r[k]));
}

RUN_TESTS(cmocka_unit_test(rotation_vector_to_alpha), cmocka_unit_test(alpha_to_rotation_vector),
          cmocka_unit_test(angle_of_alpha), cmocka_unit_test(quaternions), cmocka_unit_test(matrices),
          cmocka_unit_test(rotated_vectors), cmocka_unit_test(compositions), cmocka_unit_test(turns),
          cmocka_unit_test(zero_is_the_identity), cmocka_unit_test(no_attitude))
