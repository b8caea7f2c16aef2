/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rotation matrices in long double by their textbook formulas: the reference for energies of bonds. Nothing of the
 * library is used here. */
#ifndef VTI_TESTS_MATRIX_H
#define VTI_TESTS_MATRIX_H

#include "crowd.h"

typedef struct vec {
    long double c[3];
} vec;

typedef struct mat {
    long double m[3][3];
} mat;

static inline vec vec_of(const double a[3])
{
    const vec r = {{a[0], a[1], a[2]}};
    return r;
}

static inline vec vec_add(vec a, long double s, vec b)
{
    const vec r = {{a.c[0] + s * b.c[0], a.c[1] + s * b.c[1], a.c[2] + s * b.c[2]}};
    return r;
}

static inline vec vec_cross(vec a, vec b)
{
    const vec r = {
        {a.c[1] * b.c[2] - a.c[2] * b.c[1], a.c[2] * b.c[0] - a.c[0] * b.c[2], a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
    return r;
}

static inline long double vec_dot(vec a, vec b)
{
    return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}

static inline long double vec_norm(vec a)
{
    return sqrtl(vec_dot(a, a));
}

/** The angle between two vectors. */
static inline long double vec_angle(vec a, vec b)
{
    return atan2l(vec_norm(vec_cross(a, b)), vec_dot(a, b));
}

static inline vec mat_apply(mat a, vec v)
{
    vec r;
    for (int i = 0; i < 3; ++i)
        r.c[i] = a.m[i][0] * v.c[0] + a.m[i][1] * v.c[1] + a.m[i][2] * v.c[2];
    return r;
}

/** A B^T */
static inline mat mat_times_transpose(mat a, mat b)
{
    mat r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r.m[i][j] = a.m[i][0] * b.m[j][0] + a.m[i][1] * b.m[j][1] + a.m[i][2] * b.m[j][2];
    return r;
}

/** The angle of a rotation from its skew part, 2 sin, and its trace, 1 + 2 cos. */
static inline long double mat_angle(mat a)
{
    const vec s = {{a.m[2][1] - a.m[1][2], a.m[0][2] - a.m[2][0], a.m[1][0] - a.m[0][1]}};
    return atan2l(vec_norm(s), a.m[0][0] + a.m[1][1] + a.m[2][2] - 1);
}

/** I + f [w S(v) + S(v)^2] */
static inline mat mat_rodrigues(vec v, long double w, long double f)
{
    const long double vv = vec_dot(v, v), s[3][3] = {
                                              {0, -v.c[2], v.c[1]},
                                              {v.c[2], 0, -v.c[0]},
                                              {-v.c[1], v.c[0], 0},
                                          };
    mat r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r.m[i][j] = (i == j) + f * (w * s[i][j] + (v.c[i] * v.c[j] - (i == j) * vv));
    return r;
}

/** R of body i from the numbers that the caller stores: I + 4/(4 + |alpha|^2) [S + S^2/2], or the matrix of a
 *  quaternion of any length. */
static inline mat mat_of(const crowd *c, int i)
{
    if (c->storage == CROWD_ALPHA) {
        const vec a = vec_of(c->alpha[i]);
        return mat_rodrigues(a, 2, 2 / (4 + vec_dot(a, a)));
    }
    const vec v = vec_of(c->quat[i]);
    const long double w = c->quat[i][3];
    return mat_rodrigues(v, w, 2 / (w * w + vec_dot(v, v)));
}

#endif
