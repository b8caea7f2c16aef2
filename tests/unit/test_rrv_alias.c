/* SPDX-License-Identifier: BSD-3-Clause
 *
 * "The output may be the same array as an input": each function called in place gives the bits that it gives elsewhere,
 * and leaves its other input alone. */
#include "support.h"

typedef void unary(const double *in, double *out);
typedef void binary(const double *a, const double *b, double *out);

static void unary_in_place(unary *f, int inputs, int outputs)
{
    rng g = rng_seed(7);
    for (int i = 0; i < 10000; ++i) {
        double in[9], keep[9], out[9] = {0}, both[9] = {0};
        for (int k = 0; k < inputs; ++k)
            in[k] = i % 2 ? random_finite(&g) : uniform(&g, -2, 2);
        memcpy(keep, in, sizeof keep);
        memcpy(both, in, sizeof(double) * (size_t)inputs);
        f(in, out);
        f(both, both);
        assert_same_bits(in, keep, inputs);
        assert_same_bits(both, out, outputs);
    }
}

static void binary_in_place(binary *f)
{
    rng g = rng_seed(8);
    for (int i = 0; i < 10000; ++i) {
        double a[3], b[3], out[3], first[3], second[3], twice[3], same[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = first[k] = same[k] = i % 2 ? random_finite(&g) : uniform(&g, -2, 2);
            b[k] = second[k] = i % 2 ? random_finite(&g) : uniform(&g, -2, 2);
        }
        f(a, b, out);
        f(first, b, first);
        f(a, second, second);
        assert_same_bits(first, out, 3);
        assert_same_bits(second, out, 3);
        f(a, a, twice);
        f(same, same, same);
        assert_same_bits(same, twice, 3);
    }
}

TEST(rotation_vectors)
{
    unary_in_place(vti_rrv_from_rotvec, 3, 3);
    unary_in_place(vti_rrv_to_rotvec, 3, 3);
    unary_in_place(vti_rrv_inverse, 3, 3);
}

TEST(quaternions_and_matrices)
{
    unary_in_place(vti_rrv_to_quat_xyzw, 3, 4);
    unary_in_place(vti_rrv_from_quat_xyzw, 4, 3);
    unary_in_place(vti_rrv_to_pair, 3, 4);
    unary_in_place(vti_rrv_from_pair, 4, 3);
    unary_in_place(vti_rrv_to_matrix, 3, 9);
    unary_in_place(vti_rrv_from_matrix, 9, 3);
}

TEST(pairs)
{
    binary_in_place(vti_rrv_compose);
    binary_in_place(vti_rrv_relative);
    binary_in_place(vti_rrv_relative_printed);
    binary_in_place(vti_rrv_rotate);
    binary_in_place(vti_rrv_rotate_back);
}

TEST(turns)
{
    rng g = rng_seed(9);
    for (int i = 0; i < 10000; ++i) {
        double a[3], u[3], r[3];
        for (int k = 0; k < 3; ++k)
            r[k] = a[k] = u[k] = i % 2 ? random_finite(&g) : uniform(&g, -2, 2);
        vti_rrv_turn(2.0, u, r);
        vti_rrv_turn(2.0, a, a);
        assert_same_bits(a, r, 3);
    }
}

RUN_TESTS(cmocka_unit_test(rotation_vectors), cmocka_unit_test(quaternions_and_matrices), cmocka_unit_test(pairs),
          cmocka_unit_test(turns))
