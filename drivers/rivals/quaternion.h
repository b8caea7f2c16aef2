/* SPDX-License-Identifier: BSD-3-Clause
 * Quaternions in the order x, y, z, w, as codes that hold attitudes in them multiply and normalise them; and three
 * linear equations, for those whose turns are implicit. */
#ifndef VTI_QUATERNION_H
#define VTI_QUATERNION_H

#include "vti_rrv.h"

/** r = (u, c) q: the attitude q turned in space by the quaternion with vector part u and scalar part c. r is not q. */
VTI_INLINE void quat_turned(double c, const double u[3], const double q[4], double r[4])
{
    r[0] = c * q[0] + q[3] * u[0] + (u[1] * q[2] - u[2] * q[1]);
    r[1] = c * q[1] + q[3] * u[1] + (u[2] * q[0] - u[0] * q[2]);
    r[2] = c * q[2] + q[3] * u[2] + (u[0] * q[1] - u[1] * q[0]);
    r[3] = c * q[3] - (u[0] * q[0] + u[1] * q[1] + u[2] * q[2]);
}

/** q = r/|r|. q may be r. */
VTI_INLINE void quat_unit_of(const double r[4], double q[4])
{
    const double k = 1.0 / sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    q[0] = k * r[0];
    q[1] = k * r[1];
    q[2] = k * r[2];
    q[3] = k * r[3];
}

/** q <- normalise(q + (1/2) u q), u = h Omega: a step along q' = (1/2) Omega q and back to the sphere. Turns by
 *  2 atan(|u|/2). */
VTI_INLINE void quat_turn_normalised(const double u[3], double q[4])
{
    const double half[3] = {0.5 * u[0], 0.5 * u[1], 0.5 * u[2]};
    double r[4];
    quat_turned(1.0, half, q, r);
    quat_unit_of(r, q);
}

/** r = exp(u/2) q, u = h Omega; 0, and r left alone, if that is no turn. */
VTI_INLINE int quat_turned_exactly(const double u[3], const double q[4], double r[4])
{
    const double s = sqrt(vti_dot(u, u));
    if (s == 0.0)
        return 0;
    double sine, c;
    vti_sin_cos(0.5 * s, &sine, &c);
    const double k = sine / s, v[3] = {k * u[0], k * u[1], k * u[2]};
    quat_turned(c, v, q, r);
    return 1;
}

/** q <- normalise(exp(u/2) q), u = h Omega: turns by |u|. */
VTI_INLINE void quat_turn_exactly(const double u[3], double q[4])
{
    double r[4];
    if (quat_turned_exactly(u, q, r))
        quat_unit_of(r, q);
}

/* ---- three equations ------------------------------------------------------------------------------------------- */

/** x = A^-1 b by Cramer's rule, A given by its columns. */
VTI_INLINE void vector_solve(const double a0[3], const double a1[3], const double a2[3], const double b[3], double x[3])
{
    double c12[3], c20[3], c01[3];
    vti_cross(a1, a2, c12);
    vti_cross(a2, a0, c20);
    vti_cross(a0, a1, c01);
    const double k = 1.0 / vti_dot(a0, c12);
    x[0] = k * vti_dot(b, c12);
    x[1] = k * vti_dot(b, c20);
    x[2] = k * vti_dot(b, c01);
}

#endif
