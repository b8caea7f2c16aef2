/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The reach of multistep methods from roots: a step for x'' = -x is linear in x, v and the K differences that are
 * remembered, and its matrix, whose columns are steps from each of them alone, has eigenvalues beyond the circle from
 * there on. */
#include <gsl/gsl_eigen.h>

#include "march.h"

enum { MOST = MARCH_DEPTH + 2 };

/** One step from state = x, v, N^0 a ... N^{K-1} a. */
static void step(const vti_multistep *m, double h, double state[MOST])
{
    static const double mass = 1;
    double x[3] = {state[0]}, v[3] = {state[1]}, f[3] = {0}, memory[MARCH_DEPTH][6] = {{0}};
    vti_past past = {memory[0], m->depth, m->depth};
    vti_bodies b = vti_bodies_none(1);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(f);
    b.mass = vti_scalars_one(&mass);
    for (int k = 0; k < m->depth; ++k)
        memory[k][0] = state[2 + k];
    assert_int_equal(vti_multistep_predict(m, h, &past, &b, NULL), VTI_OK);
    f[0] = -x[0];
    assert_int_equal(vti_multistep_correct(m, h, &past, &b), VTI_OK);
    state[0] = x[0];
    state[1] = v[0];
    for (int k = 0; k < m->depth; ++k)
        state[2 + k] = memory[k][0];
}

/** The largest modulus of an eigenvalue of the step by h. */
static double growth(const vti_multistep *m, double h)
{
    const size_t n = (size_t)m->depth + 2;
    gsl_matrix *matrix = gsl_matrix_alloc(n, n);
    gsl_vector_complex *roots = gsl_vector_complex_alloc(n);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(n);
    double largest = 0;
    for (size_t column = 0; column < n; ++column) {
        double state[MOST] = {0};
        state[column] = 1;
        step(m, h, state);
        for (size_t row = 0; row < n; ++row)
            gsl_matrix_set(matrix, row, column, state[row]);
    }
    assert_int_equal(gsl_eigen_nonsymm(matrix, roots, work), 0);
    for (size_t k = 0; k < n; ++k) {
        const gsl_complex root = gsl_vector_complex_get(roots, k);
        largest = fmax(largest, hypot(GSL_REAL(root), GSL_IMAG(root)));
    }
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(roots);
    gsl_matrix_free(matrix);
    return largest;
}

/** The first h, by 2^-12, at which an oscillation grows by more than `rate` times h a step. */
static double reach(const vti_multistep *m, double rate)
{
    double h = 0x1p-12;
    while (growth(m, h) < 1 + rate * h)
        h += 0x1p-12;
    return h;
}

/** By the growth of 1e-3 that the library's reach is meant by. */
TEST(those_of_the_library)
{
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        const double found = reach(m, 1e-3);
        print_message("%-10s %.4f, %.4f is said; by a growth of 1e-2 %.4f\n", m->name, found, m->reach, reach(m, 1e-2));
        assert_close(m->reach, found, 0.005);
        assert_below(m->reach, found + 0x1p-11);
    }
}

/** K, c and reach as the equations list them, to steps of 0.005. */
TEST(those_of_the_equations)
{
    static const struct {
        int depth;
        double c, reach;
    } rows[] = {{2, 0.75, 1.385}, {3, 0.75, 0.525},  {4, 1, 0.565},     {5, 0.75, 0.64},   {6, -0.5, 0.665},
                {6, 0.75, 0.47},  {7, -0.75, 0.825}, {7, 0.75, 0.345},  {8, -0.75, 0.665}, {8, 0.75, 0.25},
                {9, -0.75, 0.5},  {9, 0.75, 0.18},   {10, -0.75, 0.36}, {10, 1, 0.12}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
        const vti_multistep m = {"own", rows[k].depth, rows[k].c, 0, 0, ""};
        const double found = reach(&m, 1e-3);
        print_message("AN(%d, %g) %.4f, %.3f in the list\n", rows[k].depth, rows[k].c, found, rows[k].reach);
        assert_close(found, rows[k].reach, 0.005 + 0x1p-12);
    }
}

/** With u = -3/80 the amplitude falls by h^8/48 a step, and grows by no step below the reach; another u adds its
 *  difference times h^6. */
TEST(amplitude_of_an4)
{
    const vti_multistep *const an4 = vti_multistep_find("an4");
    vti_multistep other = *an4;
    other.u += 0.01;
    for (double h = 0x1p-4; h < an4->reach; h += 0x1p-6)
        assert_below(growth(an4, h), 1);
    for (double h = 0.2; h < 0.31; h += 0.05) {
        const double of_an4 = log(growth(an4, h)), of_other = log(growth(&other, h));
        print_message("h = %.2f: %.4f h^8/48, %.5f h^6 more\n", h, 48 * of_an4 / pow(h, 8),
                      (of_other - of_an4) / pow(h, 6));
        assert_close(48 * of_an4 / pow(h, 8), -1, h * h); /* the next term */
        assert_close((of_other - of_an4) / pow(h, 6), 0.01, 0.01 * h);
    }
}

RUN_TESTS(cmocka_unit_test(those_of_the_library), cmocka_unit_test(those_of_the_equations),
          cmocka_unit_test(amplitude_of_an4))
