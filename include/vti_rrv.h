/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 *  vti_rrv.h -- the algebra of the rescaled Rodrigues rotation vector, inline and allocation-free.
 *
 *  A rotation by the vector theta (right-handed, radians) is written
 *
 *     alpha = (tan(|theta|/2) / (|theta|/2)) theta,      |alpha| = 2 tan(|theta|/2),
 *
 *  which is the unit quaternion (w, v) in projective coordinates: alpha = 2 v/w. R(alpha) takes body to space.
 *
 *  Contracts that hold for every function here:
 *  1. Vectors are double[3], matrices double[9], row by row, quaternions double[4] in the order x, y, z, w.
 *  2. Inputs must be finite; then so are the results, at half turns and for |alpha| up to DBL_MAX too. The exception is
 *     a quaternion of four zeros, as cleared memory holds: its results are NaN.
 *  3. Computed attitudes have |alpha_i| <= VTI_RRV_LARGE (to rounding): a half turn is cut off there, which costs at
 *     most 3.5e-18 rad.
 *  4. Bits do not depend on libm, but for vti_sin_cos and vti_rrv_from_rotvec of more than 1e5 turns.
 *  5. The output may be the same array as an input, never a part of one.
 *
 *  The header stands alone (C99 and C++; libm and nothing else). */
#ifndef VTI_RRV_H
#define VTI_RRV_H

#include <math.h>

/** 2^60: the largest |component| of an attitude that a composition returns. Exact in binary. */
#define VTI_RRV_LARGE 1152921504606846976.0
/** 2^-60. */
#define VTI_RRV_SMALL (1.0 / VTI_RRV_LARGE)
/** 2^29: up to here both factors of a composition are small enough for its incremental form to stay below 2^60. */
#define VTI_RRV_NEAR 536870912.0
/** 2^570: an exact scaling after which squares of tiny numbers do not vanish. */
#define VTI_RRV_UP 3.8645375230172583e+171
/** 2^-520: the same for huge numbers, whose squares do not overflow then. */
#define VTI_RRV_DOWN (1.0 / 3.432398830065305e+156)

/* Inlined whole, so that a loop over bonds can be vectorised; kept apart, so that what is rare costs the rest nothing.
 * A compiler that is told not to optimise shall not either: it takes a minute for a kernel that is one function. */
#if defined(__GNUC__) && defined(__OPTIMIZE__)
/** Inlined whole. */
#define VTI_INLINE static inline __attribute__((always_inline))
/** Kept apart. */
#define VTI_APART static __attribute__((noinline, cold, unused))
#else
#define VTI_INLINE static inline
#define VTI_APART static inline
#endif

/* ---- three-vectors ------------------------------------------------------------------------------------------- */

/** DOT: a.b, CROSS: r = a x b = S(a) b, for numbers and for vectors of numbers, V. r must not overlap a or b. */
#define VTI_RRV_PRODUCTS(DOT, CROSS, V)                                                                                \
    VTI_INLINE V DOT(const V a[3], const V b[3])                                                                       \
    {                                                                                                                  \
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];                                                                \
    }                                                                                                                  \
    VTI_INLINE void CROSS(const V a[3], const V b[3], V r[3])                                                          \
    {                                                                                                                  \
        r[0] = a[1] * b[2] - a[2] * b[1];                                                                              \
        r[1] = a[2] * b[0] - a[0] * b[2];                                                                              \
        r[2] = a[0] * b[1] - a[1] * b[0];                                                                              \
    }
VTI_RRV_PRODUCTS(vti_dot, vti_cross, double)

/** The largest |component|. */
VTI_INLINE double vti_max3(const double a[3])
{
    const double x = fabs(a[0]), y = fabs(a[1]), z = fabs(a[2]);
    const double m = x > y ? x : y;
    return m > z ? m : z;
}

/** A power of two that brings numbers of size m to where squares are safe. */
VTI_INLINE double vti_scale(double m)
{
    return m > VTI_RRV_LARGE ? VTI_RRV_DOWN : m < VTI_RRV_SMALL ? VTI_RRV_UP : 1.0;
}

/** |a|, without overflow or underflow of the squares (infinite only if |a| > DBL_MAX). */
static inline double vti_norm(const double a[3])
{
    const double s = vti_scale(vti_max3(a));
    const double b[3] = {s * a[0], s * a[1], s * a[2]};
    return sqrt(vti_dot(b, b)) / s;
}

/* ---- angles in plain arithmetic ----------------------------------------------------------------------------- */

/* A libm picks its functions by the processor's vector units and their last bits differ: the same attitudes would have
 * other angles elsewhere. Additions, products, quotients and square roots are rounded alike everywhere. */

/** atan2(y, x) of x, y >= 0, in [0, pi/2], within 1.5 ulp. With t the smaller over the larger of x and y,
 *
 *      atan t = atan c + atan r,   r = (t - c)/(1 + t c),   atan r = r - r^3/3 + r^5/5 - ...,
 *
 *  where c is 0, 1/2 or 1, so that |r| <= 1/4. Selections instead of branches: compilers make vectors of loops over
 *  it. */
static inline double vti_arc(double y, double x)
{
    const double a = y > x ? x : y, b = y > x ? y : x;
    const double c = a <= 0.25 * b ? 0.0 : a < 0.75 * b ? 0.5 : 1.0;
    const double s = vti_scale(b), sa = s * a, sb = s * b;
    const double above = c > 0.0 ? sa - c * sb : a, below = c > 0.0 ? sb + c * sa : b;
    const double r = below > 0.0 ? above / below : below, z = r * r;
    double sum = 1.0 / 21 - z * (1.0 / 23 - z * (1.0 / 25 - z * (1.0 / 27)));
    sum = 1.0 / 13 - z * (1.0 / 15 - z * (1.0 / 17 - z * (1.0 / 19 - z * sum)));
    sum = z * (1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9 - z * (1.0 / 11 - z * sum)))));
    const double rest = r - r * sum;
    /* atan c or pi/2 - atan c, in two parts */
    const double none = y > x ? 1.5707963267948966 : 0.0, none_low = y > x ? 6.123233995736766e-17 : 0.0;
    const double half = y > x ? 1.1071487177940904 : 0.4636476090008061;
    const double half_low = y > x ? 9.40447137356638e-17 : 2.2698777452961687e-17;
    const double angle = c < 0.5 ? none : c < 1.0 ? half : 0.7853981633974483;
    const double low = c < 0.5 ? none_low : c < 1.0 ? half_low : 3.061616997868383e-17;
    return angle + (low + (y > x ? -rest : rest));
}

/** sin t and cos t, within 1 ulp of 1, NaN of what is not finite; beyond |t| = 2^20 they are libm's. t = n pi/2 + r
 *  with pi/2 in three parts, of which n times the first two is exact. */
static inline void vti_sin_cos(double t, double *sine, double *cosine)
{
    if (!(fabs(t) <= 1048576.0)) {
        *sine = sin(t);
        *cosine = cos(t);
        return;
    }
    const double n = floor(t * 0.6366197723675814 + 0.5), a = t - n * 1.5707963267341256, b = n * 6.077100506303966e-11;
    const double d = a - b, e = ((a - d) - b) - n * 2.0222662487959506e-21, r = d + e, low = (d - r) + e, z = r * r;
    double p = 1.0 / 39916800 - z * (1.0 / 6227020800.0 - z * (1.0 / 1307674368000.0 - z * (1.0 / 355687428096000.0)));
    p = 1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880 - z * p)));
    double q =
        1.0 / 479001600 - z * (1.0 / 87178291200.0 - z * (1.0 / 20922789888000.0 - z * (1.0 / 6402373705728000.0)));
    q = z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800 - z * q))));
    const double s = r + (low - r * z * p), c = 1.0 - (z * (0.5 - q) + r * low); /* the angle is r + low */
    const double quarter = n - 4.0 * floor(0.25 * n);                            /* 0, 1, 2 or 3 */

    *sine = quarter < 1.0 ? s : quarter < 2.0 ? c : quarter < 3.0 ? -s : -c;
    *cosine = quarter < 1.0 ? c : quarter < 2.0 ? -s : quarter < 3.0 ? -c : s;
}

/* ---- alpha as a quaternion that is not normalised ------------------------------------------------------------ */

/** q ~ (alpha, 2): the quaternion (x, y, z, w) of alpha up to a positive factor, with |q_k| <= VTI_RRV_LARGE and q.q
 *  far from 0. R depends on the direction of q only, so no square root is needed. */
VTI_INLINE void vti_rrv_to_pair(const double a[3], double q[4])
{
    q[0] = a[0];
    q[1] = a[1];
    q[2] = a[2];
    q[3] = 2.0;
    const double m = vti_max3(a);
    if (m > VTI_RRV_LARGE)
        for (int k = 0; k < 4; ++k)
            q[k] /= m;
}

/** alpha = 2 v/w of any quaternion but zero, normalised or not. */
static inline void vti_rrv_from_pair(const double q[4], double a[3])
{
    const double m = vti_max3(q), w = fabs(q[3]), s = vti_scale(m > w ? m : w);
    const double v[3] = {2.0 * s * q[0], 2.0 * s * q[1], 2.0 * s * q[2]};
    const double least = VTI_RRV_SMALL * vti_max3(v), sw = s * w;
    const double d = copysign(sw > least ? sw : least, q[3]);
    a[0] = v[0] / d;
    a[1] = v[1] / d;
    a[2] = v[2] / d;
}

/** R p for the quaternion q ~ (v, w) up to a factor:
 *      R p = k [ (w^2 - v.v)/2 p + (v.p) v + w v x p ],  k = 2/q.q,
 *  which is R(alpha) p = p + 4/(4+|alpha|^2) [S(alpha) + S(alpha)^2/2] p with (v, w) = (alpha, 2).
 *  side = +1 gives R p, side = -1 its inverse R^T p. SQUARE: q.q, ROTATE: r = R p, which may be p; for numbers and for
 *  vectors of numbers, V, with their products DOT and CROSS. */
#define VTI_RRV_ROTATION(SQUARE, ROTATE, DOT, CROSS, V)                                                                \
    VTI_INLINE V SQUARE(const V q[4])                                                                                  \
    {                                                                                                                  \
        return (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);                                              \
    }                                                                                                                  \
    VTI_INLINE void ROTATE(const V q[4], V k, double side, const V p[3], V r[3])                                       \
    {                                                                                                                  \
        const V vv = (q[0] * q[0] + q[1] * q[1]) + q[2] * q[2], cv = DOT(q, p), cx = side * q[3];                      \
        const V cp = 0.5 * (q[3] * q[3]) - 0.5 * vv;                                                                   \
        V x[3];                                                                                                        \
        CROSS(q, p, x);                                                                                                \
        for (int n = 0; n < 3; ++n)                                                                                    \
            r[n] = k * (cp * p[n] + (cv * q[n] + cx * x[n]));                                                          \
    }
VTI_RRV_ROTATION(vti_pair_square, vti_pair_rotate_by, vti_dot, vti_cross, double)

/** r = R p of the quaternion q up to a factor for side = 1, its inverse R^T p for side = -1. q.q must be finite and not
 *  0. r may be p. */
VTI_INLINE void vti_pair_rotate(const double q[4], double side, const double p[3], double r[3])
{
    vti_pair_rotate_by(q, 2.0 / vti_pair_square(q), side, p, r);
}

/** theta in [0, pi] by which the quaternion q ~ (v, w) turns. */
static inline double vti_pair_angle(const double q[4])
{
    return 2.0 * vti_arc(vti_norm(q), fabs(q[3]));
}

/** |log(R_p R_q^T)| in [0, pi]: the angle of p q^-1. */
static inline double vti_pair_distance(const double p[4], const double q[4])
{
    double x[3], d[4];
    vti_cross(p, q, x);
    for (int k = 0; k < 3; ++k)
        d[k] = (q[3] * p[k] - p[3] * q[k]) - x[k];
    d[3] = p[3] * q[3] + vti_dot(p, q);
    return vti_pair_angle(d);
}

/* ---- composition --------------------------------------------------------------------------------------------- */

/** The direct form of vti_rrv_increment, for what comes near a half turn or is of extreme size. */
VTI_APART void vti_rrv_direct(double c, const double u[3], double side, const double a[3], double sum[3])
{
    const double ma = vti_max3(a), mu = vti_max3(u);
    const double sa = ma > VTI_RRV_LARGE ? VTI_RRV_DOWN : 1.0, su = vti_scale(mu > fabs(c) ? mu : fabs(c));
    const double A[3] = {sa * a[0], sa * a[1], sa * a[2]}, W = 2.0 * sa;
    const double U[3] = {su * u[0], su * u[1], su * u[2]}, C = su * c;
    double x[3];
    vti_cross(U, A, x);
    for (int k = 0; k < 3; ++k)
        sum[k] = 2.0 * (W * U[k] + side * x[k]) + 2.0 * C * A[k];
    const double w = C * W - vti_dot(U, A), least = VTI_RRV_SMALL * vti_max3(sum);
    const double inv = 1.0 / copysign(fabs(w) > least ? fabs(w) : least, w);
    for (int k = 0; k < 3; ++k)
        sum[k] *= inv;
}

/** The incremental form of vti_rrv_increment, its fraction reduced by 2, for numbers and for vectors of numbers, V;
 *  returns f u.alpha/2. */
#define VTI_RRV_INCREMENTAL(NAME, V)                                                                                   \
    VTI_INLINE V NAME(V c, V f, const V u[3], V side, const V a[3], V add[3])                                          \
    {                                                                                                                  \
        const V d = 0.5 * f * (u[0] * a[0] + u[1] * a[1] + u[2] * a[2]), inv = 1.0 / (c - d);                          \
        const V x[3] = {u[1] * a[2] - u[2] * a[1], u[2] * a[0] - u[0] * a[2], u[0] * a[1] - u[1] * a[0]};              \
        for (int k = 0; k < 3; ++k)                                                                                    \
            add[k] = (f * (2.0 * u[k] + side * x[k]) + d * a[k]) * inv;                                                \
        return d;                                                                                                      \
    }
VTI_RRV_INCREMENTAL(vti_rrv_incremental, double)

/** alpha <- alpha (+) dalpha with dalpha = 2 f u/c given as c, f and u: the quaternion (w, v) = (c, f u) of the
 *  increment up to a factor. side = +1: R(alpha) <- R(dalpha) R(alpha), a spatial increment. side = -1: R(alpha) <-
 *  R(alpha) R(dalpha), an increment in the body's frame. With f = 1:
 *
 *      alpha + [4 u + 2 u x alpha + (u.alpha) alpha] / (2 c - u.alpha)       where |alpha . dalpha| < 1   (incremental)
 *      [2 c alpha + 4 u + 2 u x alpha] / (2 c - u.alpha)                     elsewhere                    (direct)
 *
 *  Both are a (+) b = 4/(4 - a.b) [a + b - (a x b)/2]; the first does not repeat the same rounding error each step
 *  (attitude error ~ sqrt(N) instead of N), the second is cut off at VTI_RRV_LARGE when its denominator vanishes.
 *  Total. c and f u must be finite and not both 0. vti_rrv_increment returns the sum's second part in add and whether
 *  alpha is to be added to it (incremental form). f stands apart from u since it comes late: meanwhile the products
 *  with u are made. small: the caller knows already that 2^-60 < c < 2^60 and |f u_i| < 2^29 c, which need not be found
 *  out then. */
VTI_INLINE int vti_rrv_increment(double c, double f, const double u[3], int small, double side, const double a[3],
                                 double add[3])
{
    const double d = vti_rrv_incremental(c, f, u, side, a, add);
    if (!small)
        small = c > VTI_RRV_SMALL && c < VTI_RRV_LARGE && fabs(f) * vti_max3(u) < VTI_RRV_NEAR * c;
    if (small && vti_max3(a) < VTI_RRV_NEAR && 4.0 * fabs(d) < c) /* so that no product has left the range */
        return 1;
    const double scaled[3] = {f * u[0], f * u[1], f * u[2]};
    vti_rrv_direct(c, scaled, side, a, add);
    return 0;
}

/** alpha <- alpha (+) dalpha with dalpha = 2 f u/c, as vti_rrv_increment has it. */
VTI_INLINE void vti_rrv_turn_by(double c, double f, const double u[3], int small, double side, double a[3])
{
    double add[3];
    const int near = vti_rrv_increment(c, f, u, small, side, a, add);
    for (int k = 0; k < 3; ++k)
        a[k] = (near ? a[k] : 0.0) + add[k];
}

/** The same with f = 1, of a u that may be large. */
VTI_INLINE void vti_rrv_turn_side(double c, const double u[3], double side, double a[3])
{
    vti_rrv_turn_by(c, 1.0, u, 0, side, a);
}

/** The same in space: R(alpha) <- R(2 u/c) R(alpha). */
VTI_INLINE void vti_rrv_turn(double c, const double u[3], double a[3])
{
    vti_rrv_turn_by(c, 1.0, u, 0, 1.0, a);
}

/** r = a (+) b, R(r) = R(b) R(a): first a, then b. r may be a or b. */
static inline void vti_rrv_compose(const double a[3], const double b[3], double r[3])
{
    const double u[3] = {b[0], b[1], b[2]};
    double t[3] = {a[0], a[1], a[2]};
    vti_rrv_turn(2.0, u, t);
    r[0] = t[0];
    r[1] = t[1];
    r[2] = t[2];
}

/** r = -a, R(r) = R(a)^T. */
static inline void vti_rrv_inverse(const double a[3], double r[3])
{
    r[0] = -a[0];
    r[1] = -a[1];
    r[2] = -a[2];
}

/** r = (-b) (+) a, R(r) = R(a) R(b)^T: the paper's R_(ij) with a = alpha_i, b = alpha_j. */
static inline void vti_rrv_relative(const double a[3], const double b[3], double r[3])
{
    const double inv[3] = {-b[0], -b[1], -b[2]};
    vti_rrv_compose(inv, a, r);
}

/** r = (-a) (+) b, R(r) = R(b) R(a)^T: what the paper prints as alpha_(ij). It represents the transpose of R_(ij)
 *  (erratum E5), r = -vti_rrv_relative(a, b). */
static inline void vti_rrv_relative_printed(const double a[3], const double b[3], double r[3])
{
    vti_rrv_relative(b, a, r);
}

/* ---- rotating a vector --------------------------------------------------------------------------------------- */

/** r = R(a) p for side = 1, R(a)^T p for side = -1. r may be p. */
static inline void vti_rrv_rotate_side(const double a[3], double side, const double p[3], double r[3])
{
    const double s = vti_scale(vti_max3(p)), back = 1.0 / s;
    const double sp[3] = {s * p[0], s * p[1], s * p[2]};
    double q[4];
    vti_rrv_to_pair(a, q);
    vti_pair_rotate(q, side, sp, r);
    r[0] *= back;
    r[1] *= back;
    r[2] *= back;
}

/** r = R(a) p, body to space. r may be p. (|p| near DBL_MAX can overflow if R p itself does.) */
static inline void vti_rrv_rotate(const double a[3], const double p[3], double r[3])
{
    vti_rrv_rotate_side(a, 1.0, p, r);
}

/** r = R(a)^T p, space to body. r may be p. */
static inline void vti_rrv_rotate_back(const double a[3], const double p[3], double r[3])
{
    vti_rrv_rotate_side(a, -1.0, p, r);
}

/* ---- angles and other representations ------------------------------------------------------------------------ */

/** theta = 2 atan(|a|/2) = |log R(a)|_F / sqrt 2, in [0, pi]. */
static inline double vti_rrv_angle(const double a[3])
{
    return 2.0 * vti_arc(vti_norm(a), 2.0);
}

/** Distance of two attitudes, |log(R(a) R(b)^T)| in [0, pi]. */
static inline double vti_rrv_distance(const double a[3], const double b[3])
{
    double p[4], q[4];
    vti_rrv_to_pair(a, p);
    vti_rrv_to_pair(b, q);
    return vti_pair_distance(p, q);
}

/** alpha of the rotation vector theta (radians, of any length; taken modulo full turns). The same bits everywhere up to
 *  |theta| = 2^21, beyond which libm's sine and cosine serve. */
static inline void vti_rrv_from_rotvec(const double theta[3], double a[3])
{
    const double half[3] = {0.5 * theta[0], 0.5 * theta[1], 0.5 * theta[2]};
    const double t = vti_norm(half);
    double s, c;
    vti_sin_cos(t, &s, &c);
    const double raw = t > VTI_RRV_SMALL ? s / c / t : 1.0; /* tan t/t = 1 + t^2/3 + ... rounds to 1 below */
    const double most = VTI_RRV_LARGE / (1.0 + vti_max3(theta));
    const double k = fabs(raw) < most ? raw : copysign(most, raw);
    a[0] = k * theta[0];
    a[1] = k * theta[1];
    a[2] = k * theta[2];
}

/** theta = log R(a), |theta| in [0, pi]. */
static inline void vti_rrv_to_rotvec(const double a[3], double theta[3])
{
    double q[4];
    vti_rrv_to_pair(a, q);
    const double n = vti_norm(q);
    /* 2 atan(n/2)/n = 1 - n^2/12 + ... rounds to 1 long before n/n would be 0/0 */
    const double k = n > VTI_RRV_SMALL ? 2.0 * vti_arc(n, q[3]) / n : 1.0;
    theta[0] = k * q[0];
    theta[1] = k * q[1];
    theta[2] = k * q[2];
}

/** Unit quaternion in the order x, y, z, w, with w >= 0. */
static inline void vti_rrv_to_quat_xyzw(const double a[3], double q[4])
{
    vti_rrv_to_pair(a, q);
    const double k = 1.0 / sqrt(vti_dot(q, q) + q[3] * q[3]);
    q[0] *= k;
    q[1] *= k;
    q[2] *= k;
    q[3] *= k;
}

/** alpha of a quaternion x, y, z, w, which need not be normalised; -q gives what q does. NaN of four zeros. */
static inline void vti_rrv_from_quat_xyzw(const double q[4], double a[3])
{
    vti_rrv_from_pair(q, a);
}

/** R(alpha) as nine numbers, row by row. */
static inline void vti_rrv_to_matrix(const double a[3], double R[9])
{
    double q[4];
    vti_rrv_to_quat_xyzw(a, q);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    R[0] = 1.0 - 2.0 * (y * y + z * z);
    R[1] = 2.0 * (x * y - w * z);
    R[2] = 2.0 * (x * z + w * y);
    R[3] = 2.0 * (x * y + w * z);
    R[4] = 1.0 - 2.0 * (x * x + z * z);
    R[5] = 2.0 * (y * z - w * x);
    R[6] = 2.0 * (x * z - w * y);
    R[7] = 2.0 * (y * z + w * x);
    R[8] = 1.0 - 2.0 * (x * x + y * y);
}

/** The pair of a rotation matrix (row by row), up to a factor: of the four columns of 4 q q^T the one with the largest
 *  diagonal entry, so that no digits cancel at any angle. */
static inline void vti_rrv_pair_from_matrix(const double R[9], double q[4])
{
    const double d[4] = {1.0 + R[0] - R[4] - R[8], 1.0 - R[0] + R[4] - R[8], 1.0 - R[0] - R[4] + R[8],
                         1.0 + R[0] + R[4] + R[8]};
    const double xy = R[1] + R[3], xz = R[2] + R[6], yz = R[5] + R[7];
    const double wx = R[7] - R[5], wy = R[2] - R[6], wz = R[3] - R[1];
    const double column[4][4] = {{d[0], xy, xz, wx}, {xy, d[1], yz, wy}, {xz, yz, d[2], wz}, {wx, wy, wz, d[3]}};
    int k = 3;
    for (int i = 0; i < 3; ++i)
        k = d[i] > d[k] ? i : k;
    for (int i = 0; i < 4; ++i)
        q[i] = column[k][i];
}

/** alpha of a rotation matrix (row by row). */
static inline void vti_rrv_from_matrix(const double R[9], double a[3])
{
    double q[4];
    vti_rrv_pair_from_matrix(R, q);
    vti_rrv_from_pair(q, a);
}

#endif
