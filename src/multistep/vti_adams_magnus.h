/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The vectors by which bodies turn in half a step of a multistep method, a body to a lane, from what
 * vti_adams_kernels.h leaves of each: of the correction the vector itself, as the last three of four numbers; of the
 * prediction A1, A2, A3 and A4, four numbers each, of the turn under
 *
 *     h w(s) = A1 + A2 z + A3 z^2 + A4 z^3,  z = s - 1/2,  0 <= s <= 1 of h. */
#ifndef VTI_ADAMS_MAGNUS_H
#define VTI_ADAMS_MAGNUS_H

#include "../lanes/vti_lanes.h"

/** Numbers of a body. */
enum { ADAMS_CORRECTION = 4, ADAMS_PREDICTION = 16 };

/** By which law they turn. A correction is of order K + 2 in h: its cube, which Cayley's law errs by, is of order
 *  3 K + 6. */
VTI_INLINE int adams_law(int64_t each)
{
    return each == ADAMS_CORRECTION ? VTI_LAW_CAYLEY : VTI_LAW_EXACT9;
}

/** Where the numbers of the bodies of the lanes begin, of n bodies; lanes that are left over have the last one. */
VTI_INLINE void adams_places(int64_t n, int64_t stride, int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = (l < n ? l : n - 1) * stride;
}

/** a + t b */
VTI_INLINE void adams_with(const lanes a[3], double t, const lanes b[3], lanes r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = a[k] + t * b[k];
}

/** Magnus' rotation vector, to order 8 (Blanes, Casas and Ros 2000):
 *      S1 = -(1/28) (A1 + A3/28) x (A2 + 3 A4/28),          R1 = (1/3) A1 x (S1 - A3/14)
 *      S2 = (A1 + A3/28 + S1) x (A2 + 3 A4/28 + R1),        R2 = (A1 + 5 S1/4) x (2 A3 + S2 + (1/2) A2 x S1)
 *      S3 = (A1 + A3/12 - 7 S1/3 - S2/6) x (63 R1 + R2 - 9 A2 - 9 A4/4)
 *      theta = A1 + A3/12 - 7 S2/120 + S3/360 */
VTI_INLINE void adams_magnus(const lanes a1[3], const lanes a2[3], const lanes a3[3], const lanes a4[3], lanes theta[3])
{
    lanes s1[3], s2[3], s3[3], r1[3], r2[3], early[3], late[3], p[3], q[3];
    adams_with(a1, 1.0 / 28.0, a3, early);
    adams_with(a2, 3.0 / 28.0, a4, late);
    lanes_cross(early, late, p);
    for (int k = 0; k < 3; ++k)
        s1[k] = -1.0 / 28.0 * p[k];
    adams_with(s1, -1.0 / 14.0, a3, p);
    lanes_cross(a1, p, q);
    for (int k = 0; k < 3; ++k) {
        r1[k] = 1.0 / 3.0 * q[k];
        early[k] += s1[k];
        late[k] += r1[k];
    }
    lanes_cross(early, late, s2);
    lanes_cross(a2, s1, p);
    for (int k = 0; k < 3; ++k)
        q[k] = 2.0 * a3[k] + s2[k] + 0.5 * p[k];
    adams_with(a1, 1.25, s1, p);
    lanes_cross(p, q, r2);
    for (int k = 0; k < 3; ++k) {
        theta[k] = a1[k] + 1.0 / 12.0 * a3[k];
        p[k] = theta[k] - 7.0 / 3.0 * s1[k] - 1.0 / 6.0 * s2[k];
        q[k] = 63.0 * r1[k] + r2[k] - 9.0 * a2[k] - 2.25 * a4[k];
    }
    lanes_cross(p, q, s3);
    for (int k = 0; k < 3; ++k)
        theta[k] += 1.0 / 360.0 * s3[k] - 7.0 / 120.0 * s2[k];
}

/** The vectors of n bodies, WIDTH at most. */
VTI_INLINE void adams_theta(const double *by, int64_t each, int64_t n, lanes theta[3])
{
    lanes a[4][4];
    int64_t at[WIDTH];
    adams_places(n, each, at);
    lanes_quads(by, at, a[0]);
    if (each == ADAMS_CORRECTION) {
        for (int k = 0; k < 3; ++k)
            theta[k] = a[0][k + 1];
        return;
    }
    for (int m = 1; m < 4; ++m)
        lanes_quads(by + 4 * m, at, a[m]);
    adams_magnus(a[0] + 1, a[1] + 1, a[2] + 1, a[3] + 1, theta);
}

#endif
