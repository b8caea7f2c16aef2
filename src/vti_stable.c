/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A rigorous bound of the stable step (EQUATIONS 5, with a tighter element and better shares). The system is split into
 * elements, one for each thing that pulls, and every body into shares for the elements at it: K = sum K_e, M = sum M_e.
 * If no element is faster than omega, x.Kx = sum x.K_e x <= omega^2 sum x.M_e x = omega^2 x.Mx, nor is the whole. */
#include "vti_internal.h"

/** An element: a bond at rest, or what has the stiffness of one. Without j (-1) the other end does not move. */
struct spring {
    int64_t i, j;
    double length, axial, moment, shear;
    int64_t shear_form;
};

/* ---- one element ------------------------------------------------------------------------------------------------- */

static inline double share_over(const vti_scalars *s, double z, int64_t i)
{
    return s->p != NULL && i >= 0 ? z / vti_scalar(s, i) : 0.0;
}

/** What is no number wins. */
static inline double larger(double x, double y)
{
    return x > y || isnan(x) ? x : y;
}

/** omega_max^2 of a spring with 1/zi and 1/zj of its bodies; a = (zi/m_i + zj/m_j)/L0^2, b = z/J.
 *
 *  Displace a bond at rest by u and turn it by theta: to first order, across n (P), n moves by P(u_i - u_j)/L0 and mh
 *  by (theta_i + theta_j)/2 x n. The energies are K^s/2 |n - mh|^2, K^m/2 |theta_i - theta_j|^2 and, with the part of
 *  (u_i - u_j)/L0 along n, K^a/2 of its square. Along n that is K^a a and K^m (b_i + b_j). In each of two planes
 *  through n it is K^s/2 (g.q)^2 + K^m/2 (d.q)^2 with q = (u_i, u_j, theta_i, theta_j), g = (1/L0, -1/L0, -1/2, -1/2)
 *  and d = (0, 0, 1, -1), of which omega^2 are the eigenvalues of
 *      [ K^s gg              (K^s K^m)^{1/2} gd ]    gg = g.M^-1 g = a + (b_i + b_j)/4,
 *      [ (K^s K^m)^{1/2} gd  K^m dd             ]    gd = g.M^-1 d = (b_j - b_i)/2,  dd = d.M^-1 d = b_i + b_j.
 *
 *  Shear with an exponent of 4 has no stiffness at rest. Bent by 60 degrees it has K^s, at most it has 9/8 K^s: it
 *  counts as K^s. As printed it is n against R_j^T R_i n0 that bends, and g = (1/L0, -1/L0, -1, 1). */
static double omega2(const struct spring *s, const vti_bodies *b, double zi, double zj)
{
    const double a = (share_over(&b->mass, zi, s->i) + share_over(&b->mass, zj, s->j)) / (s->length * s->length);
    const double bi = share_over(&b->inertia, zi, s->i), bj = share_over(&b->inertia, zj, s->j), dd = bi + bj;
    const int printed = s->shear_form == VTI_SHEAR_PRINTED;
    const double gg = a + (printed ? dd : 0.25 * dd), gd = printed ? dd : 0.5 * (bj - bi);
    const double p = s->shear * gg, q = s->moment * dd, r = 4.0 * s->shear * s->moment * gd * gd;
    return larger(s->axial * a, 0.5 * (p + q + sqrt((p - q) * (p - q) + r)));
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

struct tally {
    const vti_bodies *b;
    double *shares; /* per body, the sum of its elements' weights */
    double most;
};

typedef void visit(const struct spring *s, struct tally *t);

static double stiffness_of(const vti_scalars *s, int64_t k)
{
    return s->p != NULL ? vti_scalar(s, k) : 0.0;
}

static void each_bond(const vti_bonds *p, struct tally *t, visit *see)
{
    for (int64_t k = 0; p != NULL && k < p->count; ++k) {
        const struct spring s = {
            p->pair[2 * k] - p->base,    p->pair[2 * k + 1] - p->base, p->rest[4 * k + 3], stiffness_of(&p->axial, k),
            stiffness_of(&p->moment, k), stiffness_of(&p->shear, k),   p->shear_form};
        see(&s, t);
    }
}

/** Hertz: d^2U/do^2 = (3/2) K sqrt(o) */
static void each_contact(const vti_contacts *p, double overlap, struct tally *t, visit *see)
{
    for (int64_t k = 0; p != NULL && k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        const double length = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
        const struct spring s = {i, j, length, 1.5 * p->stiffness * sqrt(overlap), 0.0, 0.0, 0};
        see(&s, t);
    }
}

/** The walls at a body are one element, as stiff as all of them. */
static void each_at_walls(const vti_walls *p, double overlap, struct tally *t, visit *see)
{
    for (int64_t i = t->b->first; p != NULL && p->count > 0 && i < t->b->first + t->b->count; ++i) {
        const double stiffness = (double)p->count * 1.5 * p->stiffness * sqrt(overlap);
        const struct spring s = {i, -1, 0.5 * vti_scalar(&p->diameter, i), stiffness, 0.0, 0.0, 0};
        see(&s, t);
    }
}

/** An arm in the field has the stiffness m g |rho0| against turning, at most. */
static void each_arm(const vti_pendulum *p, struct tally *t, visit *see)
{
    for (int64_t i = t->b->first; p != NULL && i < t->b->first + t->b->count; ++i) {
        const struct spring s = {i, -1, 1.0, 0.0, fabs(p->weight) * vti_norm(p->rho0), 0.0, 0};
        see(&s, t);
    }
}

static void each_spring(const vti_springs *s, struct tally *t, visit *see)
{
    each_bond(s->bonds, t, see);
    each_contact(s->contacts, s->overlap, t, see);
    each_at_walls(s->walls, s->overlap, t, see);
    each_arm(s->pendulum, t, see);
}

/* ---- shares ------------------------------------------------------------------------------------------------------ */

/** An element weighs as much as it is fast with its bodies whole: slow ones need little of a body. */
static void add_weight(const struct spring *s, struct tally *t)
{
    const double weight = omega2(s, t->b, 1.0, 1.0);
    t->shares[s->i - t->b->first] += weight;
    if (s->j >= 0)
        t->shares[s->j - t->b->first] += weight;
}

static void find_most(const struct spring *s, struct tally *t)
{
    const double weight = omega2(s, t->b, 1.0, 1.0);
    if (weight == 0.0)
        return;
    const double zi = t->shares[s->i - t->b->first] / weight;
    const double zj = s->j >= 0 ? t->shares[s->j - t->b->first] / weight : 0.0;
    const double found = omega2(s, t->b, zi, zj);
    t->most = isnan(found) ? INFINITY : fmax(t->most, found); /* what overflows is infinitely fast */
}

/* ---- what is given ----------------------------------------------------------------------------------------------- */

static int pairs_check(int64_t count, const int64_t *pair, int64_t base, const vti_bodies *b)
{
    if (count < 0)
        return VTI_E_COUNT;
    if (count > 0 && pair == NULL)
        return VTI_E_NULL;
    for (int64_t k = 0; k < 2 * count; ++k)
        if (pair[k] - base < b->first || pair[k] - base >= b->first + b->count)
            return VTI_E_BOND;
    return VTI_OK;
}

static int springs_check(const vti_springs *s, const vti_bodies *b)
{
    int status = VTI_OK;
    if (s->bonds != NULL) {
        status = pairs_check(s->bonds->count, s->bonds->pair, s->bonds->base, b);
        if (status == VTI_OK && s->bonds->count > 0 && s->bonds->rest == NULL)
            status = VTI_E_NULL;
    }
    if (status == VTI_OK && s->contacts != NULL) {
        status = pairs_check(s->contacts->count, s->contacts->pair, s->contacts->base, b);
        if (status == VTI_OK && s->contacts->count > 0 && s->contacts->diameter.p == NULL)
            status = VTI_E_NULL;
    }
    if (status == VTI_OK && s->walls != NULL && s->walls->count > 0 && s->walls->diameter.p == NULL)
        status = VTI_E_NULL;
    return status;
}

int vti_stable_step(const vti_springs *springs, const vti_bodies *b, double *scratch, double *h)
{
    int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (springs == NULL || scratch == NULL || h == NULL)
        return VTI_E_NULL;
    status = springs_check(springs, b);
    if (status != VTI_OK)
        return status;
    struct tally tally = {b, scratch, 0.0};
    for (int64_t i = 0; i < b->count; ++i)
        scratch[i] = 0.0;
    each_spring(springs, &tally, add_weight);
    each_spring(springs, &tally, find_most);
    *h = tally.most > 0.0 ? 2.0 / sqrt(tally.most) : INFINITY;
    return VTI_OK;
}
