/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The formulas of a bonded pair (EQUATIONS 3), each once: what a kernel of vti_binder_kernels.h evaluates for WIDTH
 * bonds, one to a lane. `terms` and `form` are literals at every call, so that a kernel holds the instructions of its
 * own terms only; no branch depends on the data.
 *
 * Attitudes are pairs q ~ (v, w) of any length. P u = u - (u.n) n. Of a bond with a rotation Q0 at rest R_j stands for
 * R_j Q0^T (EQUATIONS 6.6): its formulas are those of one without. */
#ifndef VTI_PAIR_H
#define VTI_PAIR_H

#include "vti_binder_table.h"
#include "../lanes/vti_lanes.h"

/** WIDTH bonds: what their formulas take. */
struct bond_state {
    lanes d[3]; /* x_i - x_j */
    lanes qi[4], qj[4];
    lanes n0[3], length;        /* rest direction and L0 */
    lanes moment, axial, shear; /* stiffnesses */
};

/** Their loads and energies. */
struct bond_loads {
    lanes force[3]; /* F_i = -F_j */
    lanes moment_i[3], moment_j[3];
    lanes energy[TERMS];
};

/** What a bond holds, in the order of vti_bond_measure. */
struct bond_measures {
    lanes of[VTI_BOND_MEASURES];
};

/** c[0] + c[1] y + c[2] y^2 + c[3] y^3 */
VTI_INLINE lanes cubic(const double c[4], lanes y, lanes y2)
{
    return (c[0] + c[1] * y) + (c[2] + c[3] * y) * y2;
}

/** A(y) = atan(sqrt y)/sqrt y on [0, 1]: Chebyshev's fit of degree 20, within 0.7 eps in double precision, as
 *      A = 1 + y P,  P = p_0 + p_1 y^4 + p_2 y^8 + p_3 y^12 + p_4 y^16 of cubics p_n,
 *  whose parts need not wait for each other (Estrin's scheme). */
VTI_INLINE lanes atan_ratio(lanes y)
{
    static const double p[5][4] = {
        {-0.3333333333333286, 0.19999999999929946, -0.14285714281592693, 0.11111110982087126},
        {-0.09090906605656898, 0.0769227555520563, -0.06666371187721098, 0.05880342002401543},
        {-0.052527255573225747, 0.04719723992321112, -0.042125723963855326, 0.03651081352721035},
        {-0.02970071773623423, 0.021740213830758134, -0.013674139288399478, 0.007038646202989813},
        {-0.0028047655531701315, 0.0008033604181626027, -0.00014617088163625013, 1.2631178430477426e-05}};
    const lanes y2 = y * y, y4 = y2 * y2, y8 = y4 * y4;
    const lanes low = cubic(p[0], y, y2) + cubic(p[1], y, y2) * y4;
    const lanes high = cubic(p[2], y, y2) + cubic(p[3], y, y2) * y4;
    return 1.0 + y * ((low + high * y8) + cubic(p[4], y, y2) * (y8 * y8));
}

/** The quaternion (v, w) = q_i conj(q_j) of R_i R_j^T; returns w. */
VTI_INLINE lanes quotient(const lanes qi[4], const lanes qj[4], lanes v[3])
{
    lanes x[3];
    lanes_cross(qi, qj, x);
    for (int k = 0; k < 3; ++k)
        v[k] = (qj[3] * qi[k] - qi[3] * qj[k]) - x[k];
    return qi[3] * qj[3] + lanes_dot(qi, qj);
}

/** theta_ij = log(R_i R_j^T) = s v, |theta| <= pi, of the quaternion (v, w) = q_i q_j^-1, without libm:
 *      s = sgn(w) (4/k) A(v.v/k^2),  k = |w| + sqrt(w^2 + v.v),  A(y) = atan(sqrt y)/sqrt y.
 *  sgn(w) matters: bodies turn past pi, and w then turns negative. Returns s. */
VTI_INLINE lanes relative_rotation(const lanes qi[4], const lanes qj[4], lanes v[3])
{
    const lanes w = quotient(qi, qj, v), vv = lanes_dot(v, v);
    const lanes inv = 1.0 / (lanes_abs(w) + lanes_sqrt(w * w + vv));
    return lanes_copysign(4.0 * inv, w) * atan_ratio(vv * inv * inv);
}

/** Moment: U = K/2 |theta_ij|^2, T_i = -K theta_ij = -T_j. */
VTI_INLINE void moment_term(const struct bond_state *b, struct bond_loads *out)
{
    lanes v[3];
    const lanes s = relative_rotation(b->qi, b->qj, v), ks = b->moment * s;
    for (int k = 0; k < 3; ++k) {
        out->moment_i[k] -= ks * v[k];
        out->moment_j[k] += ks * v[k];
    }
    out->energy[0] = 0.5 * ks * s * lanes_dot(v, v);
}

/** Axial: U = K/2 (r/L0 - 1)^2, F_i = -(K/L0)(r/L0 - 1) n = -F_j; the force along n is added. */
VTI_INLINE void axial_term(const struct bond_state *b, lanes r, lanes *along, struct bond_loads *out)
{
    const lanes inv = 1.0 / b->length, stretch = (r - b->length) * inv;
    *along -= b->axial * inv * stretch;
    out->energy[1] = 0.5 * b->axial * stretch * stretch;
}

/** The part of a shear force that both forms share, with e = n - m' of a unit vector m' and c = m'.n:
 *      F_i = (K/r) P m' = (K/r) ((1 - c) n - e),
 *  of which the part along n is added to *along. */
VTI_INLINE void shear_force(lanes stiffness, lanes inv_r, lanes one_minus_c, const lanes e[3], lanes *along,
                            struct bond_loads *out)
{
    const lanes f = stiffness * inv_r;
    *along += f * one_minus_c;
    for (int k = 0; k < 3; ++k)
        out->force[k] -= f * e[k];
}

/** Objective shear: m = b_i + b_j, mh = m/|m|, c = mh.n; with e = n - mh is 1 - c = |e|^2/2 without cancellation.
 *      U = K (1 - c),  F_i = (K/r) P mh = -F_j,  T_a = b_a x (K/|m|)(n - c mh);
 *  the printed exponent, U = K/2 (1 - c)^2, has K (1 - c) in place of K. */
VTI_INLINE void objective_shear(int form, const struct bond_state *b, lanes inv_r, const lanes n[3], lanes *along,
                                struct bond_loads *out)
{
    const lanes zero = lanes_of(0.0), qqi = lanes_square(b->qi), qqj = lanes_square(b->qj), inv = 2.0 / (qqi * qqj);
    lanes bi[3], bj[3], m[3], e[3], pull[3], ti[3], tj[3];
    lanes_rotate(b->qi, qqj * inv, 1.0, b->n0, bi);
    lanes_rotate(b->qj, qqi * inv, 1.0, b->n0, bj);
    for (int k = 0; k < 3; ++k)
        m[k] = bi[k] + bj[k];
    const lanes mm = lanes_dot(m, m);
    const lanes inv_m = lanes_where(mm > 0.0, 1.0 / lanes_sqrt(mm), zero);
    for (int k = 0; k < 3; ++k) {
        m[k] *= inv_m;
        e[k] = n[k] - m[k];
    }
    /* no middle (b_i = -b_j) or no n: c = 0, no loads */
    const lanes none = lanes_where(mm * inv_r == 0.0, lanes_of(0.5), zero);
    const lanes one_minus_c = 0.5 * lanes_dot(e, e) + none;
    const lanes stiffness = form == VTI_SHEAR_QUARTIC ? b->shear * one_minus_c : b->shear;
    const lanes arm = stiffness * inv_m;
    shear_force(stiffness, inv_r, one_minus_c, e, along, out);
    for (int k = 0; k < 3; ++k)
        pull[k] = arm * (e[k] + one_minus_c * m[k]); /* n - c mh = e + (1 - c) mh */
    lanes_cross(bi, pull, ti);
    lanes_cross(bj, pull, tj);
    for (int k = 0; k < 3; ++k) {
        out->moment_i[k] += ti[k];
        out->moment_j[k] += tj[k];
    }
    out->energy[2] = form == VTI_SHEAR_QUARTIC ? 0.5 * stiffness * one_minus_c : stiffness * one_minus_c;
}

/** Shear as printed: c = (R_i n0).(R_j n), g = R_j^T R_i n0,
 *      U = K/2 (1 - c)^2,  F_i = (K (1 - c)/r) P g = -F_j,  T_i = K (1 - c)(R_i n0) x (R_j n) = -T_j.
 *  Not symmetric in i and j, and not frame-indifferent (E11). */
VTI_INLINE void printed_shear(const struct bond_state *b, lanes inv_r, const lanes n[3], lanes *along,
                              struct bond_loads *out)
{
    const lanes qqi = lanes_square(b->qi), qqj = lanes_square(b->qj), inv = 2.0 / (qqi * qqj);
    const lanes ki = qqj * inv, kj = qqi * inv;
    lanes bi[3], nj[3], g[3], e[3], t[3];
    lanes_rotate(b->qi, ki, 1.0, b->n0, bi);
    lanes_rotate(b->qj, kj, 1.0, n, nj);
    lanes_rotate(b->qj, kj, -1.0, bi, g);
    for (int k = 0; k < 3; ++k)
        e[k] = n[k] - g[k];
    const lanes none = lanes_where(inv_r > 0.0, lanes_of(0.0), lanes_of(0.5)); /* no n: c = 0 */
    const lanes one_minus_c = 0.5 * lanes_dot(e, e) + none, stiffness = b->shear * one_minus_c;
    shear_force(stiffness, inv_r, one_minus_c, e, along, out);
    lanes_cross(bi, nj, t);
    for (int k = 0; k < 3; ++k) {
        out->moment_i[k] += stiffness * t[k];
        out->moment_j[k] -= stiffness * t[k];
    }
    out->energy[2] = 0.5 * stiffness * one_minus_c;
}

/** All terms of the mask. What the caller does not read of *out is not computed. */
VTI_INLINE void bond_evaluate(int terms, int form, const struct bond_state *b, struct bond_loads *out)
{
    lanes along = lanes_of(-0.0); /* a sum leaves what is added to -0 as it is */
    for (int k = 0; k < 3; ++k)
        out->force[k] = out->moment_i[k] = out->moment_j[k] = out->energy[k] = lanes_of(-0.0);
    /* the moment's long chain comes last where a block fills all that a processor looks ahead; its sums commute */
    const int pulls = terms & (TERM_AXIAL | TERM_SHEAR), last = pulls && WIDTH > 4;
    if (terms & TERM_MOMENT && !last)
        moment_term(b, out);
    if (!pulls)
        return;
    const lanes r = lanes_sqrt(lanes_dot(b->d, b->d));
    const lanes inv_r = lanes_where(r > VTI_COINCIDENT, 1.0 / r, lanes_of(0.0));
    const lanes n[3] = {b->d[0] * inv_r, b->d[1] * inv_r, b->d[2] * inv_r};
    if (terms & TERM_AXIAL)
        axial_term(b, r, &along, out);
    if (terms & TERM_SHEAR && form == VTI_SHEAR_PRINTED)
        printed_shear(b, inv_r, n, &along, out);
    else if (terms & TERM_SHEAR)
        objective_shear(form, b, inv_r, n, &along, out);
    for (int k = 0; k < 3; ++k)
        out->force[k] += along * n[k];
    if (terms & TERM_MOMENT && last)
        moment_term(b, out);
}

/** What the bond holds (EQUATIONS 6.7), each by the loads of its term alone:
 *      N = (K^a/L0)(r/L0 - 1),  V = (K^s/r)|P mh|,  M_b = K|P theta|,  M_t = K|theta.n|,  U,  r/L0 - 1.
 *  Positions are there, whatever the terms. */
VTI_INLINE void bond_measure(int terms, int form, const struct bond_state *b, struct bond_measures *out)
{
    const lanes zero = lanes_of(0.0), r = lanes_sqrt(lanes_dot(b->d, b->d));
    const lanes inv_r = lanes_where(r > VTI_COINCIDENT, 1.0 / r, zero);
    const lanes n[3] = {b->d[0] * inv_r, b->d[1] * inv_r, b->d[2] * inv_r};
    struct bond_loads loads;
    lanes pull = zero, along = zero, across[3];
    for (int k = 0; k < 3; ++k)
        loads.force[k] = loads.moment_i[k] = loads.moment_j[k] = loads.energy[k] = zero;
    if (terms & TERM_MOMENT)
        moment_term(b, &loads);
    const lanes twist = lanes_dot(loads.moment_i, n);
    for (int k = 0; k < 3; ++k)
        across[k] = loads.moment_i[k] - twist * n[k];
    out->of[VTI_BOND_BENDING] = lanes_sqrt(lanes_dot(across, across));
    out->of[VTI_BOND_TORSION] = lanes_abs(twist);
    if (terms & TERM_AXIAL)
        axial_term(b, r, &pull, &loads);
    if (terms & TERM_SHEAR && form == VTI_SHEAR_PRINTED)
        printed_shear(b, inv_r, n, &along, &loads);
    else if (terms & TERM_SHEAR)
        objective_shear(form, b, inv_r, n, &along, &loads);
    for (int k = 0; k < 3; ++k)
        across[k] = loads.force[k] + along * n[k];
    out->of[VTI_BOND_NORMAL] = zero - pull;
    out->of[VTI_BOND_ACROSS] = lanes_sqrt(lanes_dot(across, across));
    out->of[VTI_BOND_ENERGY] = (loads.energy[0] + loads.energy[1]) + loads.energy[2];
    out->of[VTI_BOND_STRETCH] = (r - b->length) / b->length;
}

#endif
