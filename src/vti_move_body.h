/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What moves one body: sums whose rounding errors may be carried along, and increments onto an attitude, however it is
 * kept. */
#ifndef VTI_MOVE_BODY_H
#define VTI_MOVE_BODY_H

#include "vti_move.h"
#include "vti_views.h"

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/** a += b with the rounding error of the sum carried in *low (two-sum, exact whatever the magnitudes). */
static inline double add_compensated(double a, double b, double *low)
{
    const double y = b + *low, s = a + y, z = s - a;
    *low = (a - (s - z)) + (y - z);
    return s;
}

/** a += t by of one body, with its residual where there is one. */
VTI_INLINE void add_by(double t, const double by[3], const vti_view *low, int64_t i, double a[3])
{
    for (int c = 0; c < 3; ++c)
        a[c] = vti_has(low) ? add_compensated(a[c], t * by[c], low->c[c] + i * low->stride) : a[c] + t * by[c];
}

/* ---- turn -------------------------------------------------------------------------------------------------------- */

VTI_MOVE_LAW(law_of, double, (double), sqrt)
VTI_MOVE_QUAT(quat_by, double, vti_dot, vti_cross, sqrt)

/** The increment dalpha = 2 f u/c. small: as in vti_rrv_increment. */
struct increment {
    double cf[2];
    int small;
};

/** As VTI_MOVE_LAW has it. Where s^2 would overflow, s has long lost its fraction of a turn: a half turn, c = 0, is as
 *  good as any. Below s^2 = 8, c > 0.36 in both of the exact. */
VTI_INLINE struct increment increment(int law, const double u[3])
{
    struct increment d = {{2.0, 1.0}, 0};
    if (law == VTI_LAW_CAYLEY)
        return d;
    const double s2 = vti_dot(u, u);
    d.small = law != VTI_LAW_CLOSED && s2 < 8.0;
    if (law != VTI_LAW_CLOSED && !d.small && !(s2 < 0x1p60))
        d.cf[0] = 0.0;
    else
        law_of(law, s2, d.cf);
    return d;
}

/** alpha <- alpha (+) dalpha for side = 1, in space; for side = -1 in the body's frame. */
VTI_INLINE void turn_alpha(struct increment d, double side, const double u[3], const vti_view *alpha, int64_t i)
{
    double a[3];
    vti_load(alpha, i, a);
    vti_rrv_turn_by(d.cf[0], d.cf[1], u, d.small, side, a);
    vti_store(alpha, i, a);
}

/** The same with the rounding error of alpha carried along. */
VTI_INLINE void turn_compensated(struct increment d, double side, const double u[3], const vti_view *alpha,
                                 const vti_view *low, int64_t i)
{
    double base[3], add[3], r[3];
    vti_load(alpha, i, base);
    vti_load(low, i, r);
    const int incremental = vti_rrv_increment(d.cf[0], d.cf[1], u, d.small, side, base, add);
    for (int k = 0; k < 3; ++k) {
        r[k] = incremental ? r[k] : 0.0;
        base[k] = add_compensated(incremental ? base[k] : 0.0, add[k], &r[k]);
    }
    vti_store(alpha, i, base);
    vti_store(low, i, r);
}

/** q <- normalise((u, c) q), or q (u, c) in the body's frame: the same increment on a host's quaternion. */
VTI_INLINE void turn_quat(struct increment d, double side, const double turn[3], const vti_quat_view *quat, int64_t i)
{
    double u[3], q[4];
    for (int k = 0; k < 4; ++k)
        q[k] = quat->xyzw[k][i * quat->stride];
    /* scaled, lest the square of a huge u overflow */
    const double s = vti_max3(turn) > VTI_RRV_LARGE ? VTI_RRV_DOWN : 1.0, c = s * d.cf[0];
    for (int k = 0; k < 3; ++k)
        u[k] = s * d.cf[1] * turn[k];
    quat_by(c, u, side, q);
    for (int k = 0; k < 4; ++k)
        quat->xyzw[k][i * quat->stride] = q[k];
}

#endif
