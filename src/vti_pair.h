/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The formulas of a bonded pair (EQUATIONS 3), each once: what a kernel of vti_binder.c evaluates for one bond. `terms`
 * and `form` are literals at every call, so that a kernel holds the instructions of its own terms only; no branch
 * depends on the data, so that the compiler can do many bonds at once.
 *
 * Attitudes are pairs q ~ (v, w) of any length. P u = u - (u.n) n. */
#ifndef VTI_PAIR_H
#define VTI_PAIR_H

#include "vti_internal.h"

enum { TERM_MOMENT = 1, TERM_AXIAL = 2, TERM_SHEAR = 4, TERMS = 3 };

/** One bond: what is known of it, */
struct bond_state {
    double d[3]; /* x_i - x_j */
    double qi[4], qj[4];
    double n0[3], length;        /* rest direction and L0 */
    double moment, axial, shear; /* stiffnesses */
};

/** and what follows. */
struct bond_loads {
    double force[3]; /* F_i = -F_j */
    double moment_i[3], moment_j[3];
    double energy[TERMS];
};

/** atan(sqrt y)/sqrt y on [0, 1]: Chebyshev's fit of degree 20 (5e-18), below one ulp in double precision. */
VTI_INLINE double atan_ratio(double y)
{
    double p = 1.2631178430477426e-05;
    p = p * y - 0.00014617088163625013;
    p = p * y + 0.0008033604181626027;
    p = p * y - 0.0028047655531701315;
    p = p * y + 0.007038646202989813;
    p = p * y - 0.013674139288399478;
    p = p * y + 0.021740213830758134;
    p = p * y - 0.02970071773623423;
    p = p * y + 0.03651081352721035;
    p = p * y - 0.042125723963855326;
    p = p * y + 0.04719723992321112;
    p = p * y - 0.052527255573225747;
    p = p * y + 0.05880342002401543;
    p = p * y - 0.06666371187721098;
    p = p * y + 0.0769227555520563;
    p = p * y - 0.09090906605656898;
    p = p * y + 0.11111110982087126;
    p = p * y - 0.14285714281592693;
    p = p * y + 0.19999999999929946;
    p = p * y - 0.3333333333333286;
    return p * y + 1.0;
}

/** theta_ij = log(R_i R_j^T), |theta| <= pi, of the quaternion (v, w) = q_i q_j^-1, without libm:
 *      theta = sgn(w) (4/k) A(v.v/k^2) v,  k = |w| + sqrt(w^2 + v.v),  A(y) = atan(sqrt y)/sqrt y.
 *  sgn(w) matters: bodies turn past pi, and w then turns negative. */
VTI_INLINE void relative_rotation(const double qi[4], const double qj[4], double theta[3])
{
    double x[3], v[3];
    vti_cross(qi, qj, x);
    for (int k = 0; k < 3; ++k)
        v[k] = (qj[3] * qi[k] - qi[3] * qj[k]) - x[k];
    const double w = qi[3] * qj[3] + vti_dot(qi, qj), vv = vti_dot(v, v);
    const double inv = 1.0 / (fabs(w) + sqrt(w * w + vv));
    const double scale = copysign(4.0 * inv, w) * atan_ratio(vv * inv * inv);
    for (int k = 0; k < 3; ++k)
        theta[k] = scale * v[k];
}

/** Moment: U = K/2 |theta_ij|^2, T_i = -K theta_ij = -T_j. */
VTI_INLINE void moment_term(const struct bond_state *b, struct bond_loads *out)
{
    double theta[3];
    relative_rotation(b->qi, b->qj, theta);
    for (int k = 0; k < 3; ++k) {
        out->moment_i[k] -= b->moment * theta[k];
        out->moment_j[k] += b->moment * theta[k];
    }
    out->energy[0] = 0.5 * b->moment * vti_dot(theta, theta);
}

/** Axial: U = K/2 (r/L0 - 1)^2, F_i = -(K/L0)(r/L0 - 1) n = -F_j. */
VTI_INLINE void axial_term(const struct bond_state *b, double r, const double n[3], struct bond_loads *out)
{
    const double stretch = (r - b->length) / b->length, f = -b->axial / b->length * stretch;
    for (int k = 0; k < 3; ++k)
        out->force[k] += f * n[k];
    out->energy[1] = 0.5 * b->axial * stretch * stretch;
}

/** Objective shear: m = b_i + b_j, mh = m/|m|, c = mh.n; with e = n - mh is 1 - c = |e|^2/2 without cancellation.
 *      U = K (1 - c),  F_i = (K/r) P mh = -F_j,  T_a = b_a x (K/|m|)(n - c mh);
 *  the printed exponent, U = K/2 (1 - c)^2, has K (1 - c) in place of K. */
VTI_INLINE void objective_shear(int form, const struct bond_state *b, double inv_r, const double n[3],
                                struct bond_loads *out)
{
    double bi[3], bj[3], m[3], e[3], pull[3], ti[3], tj[3];
    vti_pair_rotate(b->qi, 1.0, b->n0, bi);
    vti_pair_rotate(b->qj, 1.0, b->n0, bj);
    for (int k = 0; k < 3; ++k)
        m[k] = bi[k] + bj[k];
    const double mm = vti_dot(m, m);
    const double inv_m = mm > 0.0 ? 1.0 / sqrt(mm) : 0.0;
    const double none = mm * inv_r == 0.0 ? 0.5 : 0.0; /* no middle (b_i = -b_j) or no n: c = 0, no loads */
    for (int k = 0; k < 3; ++k) {
        m[k] *= inv_m;
        e[k] = n[k] - m[k];
    }
    const double one_minus_c = 0.5 * vti_dot(e, e) + none;
    const double stiffness = form == VTI_SHEAR_QUARTIC ? b->shear * one_minus_c : b->shear;
    for (int k = 0; k < 3; ++k) {
        out->force[k] += stiffness * inv_r * (one_minus_c * n[k] - e[k]); /* P mh   = (1 - c) n - e  */
        pull[k] = stiffness * inv_m * (e[k] + one_minus_c * m[k]);        /* n - c mh = e + (1 - c) mh */
    }
    vti_cross(bi, pull, ti);
    vti_cross(bj, pull, tj);
    for (int k = 0; k < 3; ++k) {
        out->moment_i[k] += ti[k];
        out->moment_j[k] += tj[k];
    }
    out->energy[2] = form == VTI_SHEAR_QUARTIC ? 0.5 * stiffness * one_minus_c : stiffness * one_minus_c;
}

/** Shear as printed: c = (R_i n0).(R_j n), g = R_j^T R_i n0,
 *      U = K/2 (1 - c)^2,  F_i = (K (1 - c)/r) P g = -F_j,  T_i = K (1 - c)(R_i n0) x (R_j n) = -T_j.
 *  Not symmetric in i and j, and not frame-indifferent (E11). */
VTI_INLINE void printed_shear(const struct bond_state *b, double inv_r, const double n[3], struct bond_loads *out)
{
    double bi[3], nj[3], g[3], e[3], t[3];
    vti_pair_rotate(b->qi, 1.0, b->n0, bi);
    vti_pair_rotate(b->qj, 1.0, n, nj);
    vti_pair_rotate(b->qj, -1.0, bi, g);
    for (int k = 0; k < 3; ++k)
        e[k] = n[k] - g[k];
    const double one_minus_c = 0.5 * vti_dot(e, e) + (inv_r > 0.0 ? 0.0 : 0.5); /* no n: c = 0 */
    const double stiffness = b->shear * one_minus_c;
    vti_cross(bi, nj, t);
    for (int k = 0; k < 3; ++k) {
        out->force[k] += stiffness * inv_r * (one_minus_c * n[k] - e[k]);
        out->moment_i[k] += stiffness * t[k];
        out->moment_j[k] -= stiffness * t[k];
    }
    out->energy[2] = 0.5 * stiffness * one_minus_c;
}

/** All terms of the mask. What the caller does not read of *out is not computed. */
VTI_INLINE void bond_evaluate(int terms, int form, const struct bond_state *b, struct bond_loads *out)
{
    for (int k = 0; k < 3; ++k)
        out->force[k] = out->moment_i[k] = out->moment_j[k] = out->energy[k] = 0.0;
    if (terms & TERM_MOMENT)
        moment_term(b, out);
    if (!(terms & (TERM_AXIAL | TERM_SHEAR)))
        return;
    const double r = sqrt(vti_dot(b->d, b->d));
    const double inv_r = r > VTI_COINCIDENT ? 1.0 / r : 0.0;
    const double n[3] = {b->d[0] * inv_r, b->d[1] * inv_r, b->d[2] * inv_r};
    if (terms & TERM_AXIAL)
        axial_term(b, r, n, out);
    if (terms & TERM_SHEAR && form == VTI_SHEAR_PRINTED)
        printed_shear(b, inv_r, n, out);
    else if (terms & TERM_SHEAR)
        objective_shear(form, b, inv_r, n, out);
}

#endif
