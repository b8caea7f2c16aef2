/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The true limit of the step, 2/omega_max, by the eigenvalues of the whole: GSL. */
#ifndef VTI_TESTS_HESSIAN_H
#define VTI_TESTS_HESSIAN_H

#include <gsl/gsl_eigen.h>

#include "crowd.h"

/** Column (i, k), k = 0-2 position and 3-5 rotation: -d(loads)/d(coordinate) by central differences, each over the
 *  root of the mass or inertia of both. */
static inline void hessian_column(crowd *c, const vti_effect *effects, int64_t n, int i, int k, double t, gsl_matrix *m)
{
    const double axis[3] = {k == 3, k == 4, k == 5};
    const vti_bodies b = crowd_bodies(c);
    static crowd kept, up;
    kept = *c;
    for (int side = 1; side >= -1; side -= 2) {
        if (k < 3)
            c->x[i][k] += side * t;
        else
            crowd_turn(c, i, axis, side * t);
        vti_apply(effects, n, &b);
        if (side == 1) {
            up = *c;
            *c = kept;
        }
    }
    const double root = sqrt(k < 3 ? c->mass[i] : c->inertia[i]);
    for (int j = 0; j < c->n; ++j)
        for (int l = 0; l < 3; ++l) {
            const double force = (c->force[j][l] - up.force[j][l]) / (2 * t);
            const double moment = (c->moment[j][l] - up.moment[j][l]) / (2 * t);
            gsl_matrix_set(m, (size_t)(6 * j + l), (size_t)(6 * i + k), force / (root * sqrt(c->mass[j])));
            gsl_matrix_set(m, (size_t)(6 * j + l + 3), (size_t)(6 * i + k), moment / (root * sqrt(c->inertia[j])));
        }
    *c = kept;
}

/** 2/omega_max. With t = 1e-5 the differences err by t^2/6 of a derivative that is of the size of the Hessian over the
 *  square of a length, which is 0.1 or more here, and by 16 eps/t: 2e-9 and 4e-10, of omega^2. */
#define HESSIAN_ERROR 4e-9

static inline double hessian_limit(crowd *c, const vti_effect *effects, int64_t n)
{
    const size_t size = 6 * (size_t)c->n;
    gsl_matrix *m = gsl_matrix_alloc(size, size);
    gsl_vector *values = gsl_vector_alloc(size);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(size);
    for (int i = 0; i < c->n; ++i)
        for (int k = 0; k < 6; ++k)
            hessian_column(c, effects, n, i, k, 1e-5, m);
    for (size_t i = 0; i < size; ++i) /* of moments that do not vanish the skew part is the frame's, not the energy's */
        for (size_t j = 0; j < i; ++j)
            gsl_matrix_set(m, i, j, 0.5 * (gsl_matrix_get(m, i, j) + gsl_matrix_get(m, j, i)));
    gsl_eigen_symm(m, values, work); /* reads the lower half */
    double most = 0;
    for (size_t i = 0; i < size; ++i)
        most = fmax(most, gsl_vector_get(values, i));
    gsl_eigen_symm_free(work);
    gsl_vector_free(values);
    gsl_matrix_free(m);
    return 2 / sqrt(most);
}

#endif
