/* SPDX-License-Identifier: BSD-3-Clause
 * Euler's equations of a body of principal moments I = (A, B, C), in space, for methods and references that take
 * Omega as their unknown. Nothing here knows of angular momenta, by which the library's own steppers go. */
#ifndef VTI_EULER_H
#define VTI_EULER_H

#include "vti_bodies.h"

/** w_b' = I^-1 (M_b - w_b x I w_b), all along the principal axes. */
VTI_INLINE void euler_body_rate(const double I[3], const double w[3], const double moment[3], double rate[3])
{
    const double p[3] = {I[0] * w[0], I[1] * w[1], I[2] * w[2]};
    vti_cross(p, w, rate);
    for (int k = 0; k < 3; ++k)
        rate[k] = (moment[k] + rate[k]) / I[k];
}

/** q = attitude principal: takes the principal axes into space. */
VTI_INLINE void euler_axes(const double attitude[4], const double principal[4], double q[4])
{
    double x[3];
    vti_cross(attitude, principal, x);
    for (int k = 0; k < 3; ++k)
        q[k] = attitude[3] * principal[k] + principal[3] * attitude[k] + x[k];
    q[3] = attitude[3] * principal[3] - vti_dot(attitude, principal);
}

/** Of body i, whose bodies show moments, a quaternion (of any norm but 0) and omega: q from the principal axes into
 *  space, I, and w_b. */
VTI_INLINE void euler_body(const vti_bodies *b, int64_t i, double I[3], double w[3], double q[4])
{
    const vti_quat_view *principal = &b->principal;
    for (int k = 0; k < 3; ++k) {
        I[k] = b->moments.c[k][i * b->moments.stride];
        w[k] = b->omega.c[k][i * b->omega.stride];
    }
    for (int k = 0; k < 4; ++k)
        q[k] = b->quat.xyzw[k][i * b->quat.stride];
    if (principal->xyzw[0] != 0) {
        const double attitude[4] = {q[0], q[1], q[2], q[3]},
                     p[4] = {principal->xyzw[0][i * principal->stride], principal->xyzw[1][i * principal->stride],
                             principal->xyzw[2][i * principal->stride], principal->xyzw[3][i * principal->stride]};
        euler_axes(attitude, p, q);
    }
    vti_pair_rotate(q, -1.0, w, w);
}

/** L = R_p I w_b of such a body. */
VTI_INLINE void euler_momentum(const vti_bodies *b, int64_t i, double L[3])
{
    double I[3], w[3], q[4];
    euler_body(b, i, I, w, q);
    for (int k = 0; k < 3; ++k)
        w[k] *= I[k];
    vti_pair_rotate(q, 1.0, w, L);
}

/** Omega' = R_p w_b' of such a body. */
VTI_INLINE void euler_rate(const vti_bodies *b, int64_t i, const double moment[3], double rate[3])
{
    double I[3], w[3], m[3], q[4];
    euler_body(b, i, I, w, q);
    vti_pair_rotate(q, -1.0, moment, m);
    euler_body_rate(I, w, m, rate);
    vti_pair_rotate(q, 1.0, rate, rate);
}

#endif
