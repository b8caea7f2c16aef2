/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The true limit of the step, 2/omega_max, by the eigenvalues of the whole: GSL. */
#ifndef VTI_TESTS_HESSIAN_H
#define VTI_TESTS_HESSIAN_H

#include <gsl/gsl_eigen.h>

#include "crowd.h"

/** R_i <- exp S(angle e_k) R_i, in the numbers that the bodies are kept in. */
static inline void hessian_turn(const vti_bodies *b, int64_t i, int k, double angle)
{
    const double axis[3] = {k == 0, k == 1, k == 2};
    double q[4], alpha[3];
    for (int l = 0; l < 4; ++l)
        q[l] = b->quat.xyzw[0] != NULL ? b->quat.xyzw[l][i * b->quat.stride] : 2.0; /* alpha = 2 v/w: (alpha, 2) */
    for (int l = 0; l < 3 && b->alpha.c[0] != NULL; ++l)
        q[l] = b->alpha.c[l][i * b->alpha.stride];
    const rotor r = quat_times(quat_turn(axis, angle), quat_of_xyzw(q));
    const long double v[4] = {r.x, r.y, r.z, r.w};
    for (int l = 0; l < 3; ++l)
        alpha[l] = (double)(2 * v[l] / v[3]);
    for (int l = 0; l < 4 && b->quat.xyzw[0] != NULL; ++l)
        b->quat.xyzw[l][i * b->quat.stride] = (double)v[l];
    for (int l = 0; l < 3 && b->alpha.c[0] != NULL; ++l)
        b->alpha.c[l][i * b->alpha.stride] = alpha[l];
}

/** Coordinate k of body i, 0-2 position and 3-5 rotation. */
static inline void hessian_move(const vti_bodies *b, int64_t i, int k, double by)
{
    if (k < 3)
        b->x.c[k][i * b->x.stride] += by;
    else
        hessian_turn(b, i, k - 3, by);
}

/** What can move: a body without positions or without attitudes has no such coordinates. */
static inline const vti_view *hessian_loads(const vti_bodies *b, int k)
{
    const int there = k < 3 ? b->x.c[0] != NULL : b->alpha.c[0] != NULL || b->quat.xyzw[0] != NULL;
    return !there ? NULL : k < 3 ? &b->force : &b->moment;
}

/** Column (i, k): -d(loads)/d(coordinate) by central differences, each over the root of the mass or inertia of both.
 *  Moving there and back leaves the bodies where they were to rounding. */
static inline void hessian_column(const vti_bodies *b, const vti_effect *effects, int64_t n, int64_t i, int k, double t,
                                  gsl_matrix *m)
{
    const size_t column = (size_t)(6 * i + k);
    for (int side = -1; side <= 1 && hessian_loads(b, k) != NULL; side += 2) {
        hessian_move(b, i, k, side * t);
        vti_apply(effects, n, b);
        hessian_move(b, i, k, -side * t);
        for (int64_t j = 0; j < b->count; ++j)
            for (int l = 0; l < 6; ++l) {
                const vti_view *loads = hessian_loads(b, l);
                const vti_scalars *own = k < 3 ? &b->mass : &b->inertia, *other = l < 3 ? &b->mass : &b->inertia;
                double *entry = gsl_matrix_ptr(m, (size_t)(6 * j + l), column);
                if (loads != NULL)
                    *entry -= side * loads->c[l % 3][j * loads->stride] / (2 * t) /
                              sqrt(own->p[i * own->stride] * other->p[j * other->stride]);
            }
    }
}

/** 2/omega_max. With t = 1e-5 the differences err by t^2/6 of a derivative that is of the size of the Hessian over the
 *  square of a length, which is 0.1 or more here, and by 16 eps/t: 2e-9 and 4e-10, of omega^2. */
#define HESSIAN_ERROR 4e-9

/** The largest eigenvalue of m, which it overwrites. Where most of m is 0, as with few contacts, GSL's iteration does
 *  not end: with a diagonal it does. */
static inline double hessian_largest(gsl_matrix *m)
{
    double least, most;
    gsl_matrix_minmax(m, &least, &most);
    const double shift = fmax(most, -least);
    gsl_vector *values = gsl_vector_alloc(m->size1);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(m->size1);
    gsl_vector_view diagonal = gsl_matrix_diagonal(m);
    gsl_vector_add_constant(&diagonal.vector, shift);
    gsl_eigen_symm(m, values, work); /* reads the lower half */
    const double largest = gsl_vector_max(values) - shift;
    gsl_eigen_symm_free(work);
    gsl_vector_free(values);
    return fmax(largest, 0.0);
}

static inline double hessian_limit(const vti_bodies *b, const vti_effect *effects, int64_t n)
{
    const size_t size = 6 * (size_t)b->count;
    gsl_matrix *m = gsl_matrix_calloc(size, size);
    for (int64_t i = 0; i < b->count; ++i)
        for (int k = 0; k < 6; ++k)
            hessian_column(b, effects, n, i, k, 1e-5, m);
    for (size_t i = 0; i < size; ++i) /* of moments that do not vanish the skew part is the frame's, not the energy's */
        for (size_t j = 0; j < i; ++j)
            gsl_matrix_set(m, i, j, 0.5 * (gsl_matrix_get(m, i, j) + gsl_matrix_get(m, j, i)));
    const double omega2 = hessian_largest(m);
    gsl_matrix_free(m);
    vti_apply(effects, n, b);
    return omega2 > 0 ? 2 / sqrt(omega2) : INFINITY;
}

static inline double crowd_limit(crowd *c, const vti_effect *effects, int64_t n)
{
    const vti_bodies b = crowd_bodies(c);
    return hessian_limit(&b, effects, n);
}

#endif
