/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A rigorous bound of the stable step (EQUATIONS 5 and 6.10). The system is split into elements, one for each spring
 * that an effect reports, and every body into shares for the elements at it: K = sum K_e, M = sum M_e. If no element is
 * faster than omega, the whole is not: x.Kx = sum x.K_e x <= omega^2 sum x.M_e x = omega^2 x.Mx. */
#include <limits.h>

#include "vti_ready.h"

/* ---- numbers of any size ----------------------------------------------------------------------------------------- */

/** x 2^(256 e) >= 0 with x in [2^-128, 2^128), or x = 0, infinite or NaN and e = 0: squares and products of what a
 *  double holds, m = 1e-300 and L0 = 1e-100 among them. Where e is 0 all along, the bits are those of doubles. */
struct wide {
    double x;
    int e;
};

static const double up = 0x1p256, down = 0x1p-256, most = 0x1p128, least = 0x1p-128;

static struct wide scaled(double x, int e)
{
    for (; x >= most && isfinite(x); ++e)
        x *= down;
    for (; x < least && x > 0.0; --e)
        x *= up;
    const struct wide w = {x, x > 0.0 && isfinite(x) ? e : 0};
    return w;
}

/** Nearly all numbers are in the range already. */
static inline struct wide wide(double x, int e)
{
    const struct wide w = {x, e};
    return x >= least && x < most ? w : scaled(x, e);
}

static inline struct wide times(struct wide a, struct wide b)
{
    return wide(a.x * b.x, a.e + b.e);
}

static inline struct wide over(struct wide a, struct wide b)
{
    return wide(a.x / b.x, a.e - b.e);
}

/** x of a at another e, near its own or larger; what vanishes there is less than rounding. */
static inline double at_exponent(struct wide a, int e)
{
    return a.e == e ? a.x : a.e > e ? a.x * up : a.e + 1 == e ? a.x * down : 0.0 * a.x;
}

/** The larger e of the two that are not 0. */
static inline int exponent(struct wide a, struct wide b)
{
    return a.x == 0.0 || (b.x != 0.0 && b.e > a.e) ? b.e : a.e;
}

static inline struct wide plus(struct wide a, struct wide b)
{
    if (a.e == b.e || !isfinite(a.x) || !isfinite(b.x))
        return wide(a.x + b.x, a.e);
    const int e = exponent(a, b);
    return wide(at_exponent(a, e) + at_exponent(b, e), e);
}

/** NaN wins, then what is infinite. */
static int is_larger(struct wide a, struct wide b)
{
    if (!isfinite(a.x) || !isfinite(b.x))
        return !isnan(b.x) && (isnan(a.x) || a.x > b.x);
    const int e = exponent(a, b);
    return at_exponent(a, e) > at_exponent(b, e);
}

static struct wide larger(struct wide a, struct wide b)
{
    return is_larger(a, b) ? a : b;
}

/* ---- one element ------------------------------------------------------------------------------------------------- */

static struct wide share_over(const vti_scalars *s, double z, int64_t i)
{
    return s->p != NULL && i >= 0 ? over(wide(z, 0), wide(vti_scalar(s, i), 0)) : wide(0.0, 0);
}

/** Whether a spring does nothing but pull bodies by their centres: contacts and walls, most of all springs. */
static int only_pulls(const vti_spring *s)
{
    return s->shear == 0.0 && s->bend == 0.0 && s->twist == 0.0 && s->lever_i == 0.0 && (s->j < 0 || s->lever_j == 0.0);
}

/** The larger eigenvalue of [[p, g], [g, q]], g^2 = r/4. */
static struct wide eigenvalue(struct wide p, struct wide q, struct wide r)
{
    const int e = exponent(p, q);
    const double x = at_exponent(p, e), y = at_exponent(q, e);
    return wide(0.5 * (x + y + sqrt((x - y) * (x - y) + at_exponent(r, 2 * e))), e);
}

/** The smallest of three moments; NaN if one is. */
static double smallest(const double m[3])
{
    return isnan(m[0] + m[1] + m[2]) ? NAN : fmin(fmin(m[0], m[1]), m[2]);
}

/** z/m and z/J of the place at which a spring holds body i. At r from its centre the inverse mass of u, theta is
 *      diag(1/m, 0) + (1/J) B B^T,  B = [-r x; 1],  B B^T <= 2 diag(|r|^2 - r r^T, 1),
 *  and of u alone at most 1/m + |r|^2/J (EQUATIONS 7.5). */
struct share {
    struct wide m, J;
};

static struct share share_at(const vti_spring *s, const vti_bodies *b, double z, int64_t i, double lever)
{
    struct share share = {share_over(&b->mass, z, i), share_over(&b->inertia, z, i)};
    if (vti_has(&b->moments) && i >= 0) { /* R_p diag(A, B, C) R_p^T >= min(A, B, C) (EQUATIONS 7.4) */
        double moments[3];
        vti_load(&b->moments, i, moments);
        share.J = over(wide(z, 0), wide(smallest(moments), 0));
    }
    if (lever == 0.0)
        return share;
    if (s->shear != 0.0 || s->bend != 0.0 || s->twist != 0.0)
        share.J = times(wide(2.0, 0), share.J);
    share.m = plus(share.m, times(times(wide(lever, 0), wide(lever, 0)), share.J));
    return share;
}

/** omega_max^2 of a spring with 1/zi and 1/zj of its bodies; a = (zi/m_i + zj/m_j)/L^2, b = z/J.
 *
 *  Along n it is K^axial a and K^twist (b_i + b_j). In each of two planes through n the energy is, with q = (u_i, u_j,
 *  theta_i, theta_j), K^shear/2 (g.q)^2 + K^bend/2 (d.q)^2 + K^across/2 [(u_i - u_j)/L]^2, g = (1/L, -1/L, -s_i, -s_j),
 *  s the arms, and d = (0, 0, 1, -1). The omega^2 of the first two terms are the eigenvalues of
 *      [ K^shear gg                    (K^shear K^bend)^{1/2} gd ]    gg = g.M^-1 g = a + s_i^2 b_i + s_j^2 b_j,
 *      [ (K^shear K^bend)^{1/2} gd     K^bend dd                 ]    gd = s_j b_j - s_i b_i,  dd = b_i + b_j,
 *  and the third adds at most K^across a. Of what only pulls nothing else is left, and it is the larger of the two. */
static struct wide omega2(const vti_spring *s, const vti_bodies *b, double zi, double zj)
{
    const struct wide length = wide(s->length, 0), axial = wide(s->axial, 0), across = wide(s->across, 0);
    if (only_pulls(s)) {
        const struct wide mass = plus(share_over(&b->mass, zi, s->i), share_over(&b->mass, zj, s->j));
        return times(larger(axial, across), over(mass, times(length, length)));
    }
    const struct wide shear = wide(s->shear, 0), bend = wide(s->bend, 0), twist = wide(s->twist, 0);
    const struct wide ai = wide(s->arm_i * s->arm_i, 0), aj = wide(s->arm_j * s->arm_j, 0);
    const struct share at_i = share_at(s, b, zi, s->i, s->lever_i), at_j = share_at(s, b, zj, s->j, s->lever_j);
    const struct wide a = over(plus(at_i.m, at_j.m), times(length, length));
    const struct wide bi = at_i.J, bj = at_j.J, dd = plus(bi, bj);
    const int e = exponent(bi, bj);
    const struct wide gd = wide(fabs(s->arm_j * at_exponent(bj, e) - s->arm_i * at_exponent(bi, e)), e);
    const struct wide p = times(shear, plus(a, plus(times(ai, bi), times(aj, bj)))), q = times(bend, dd);
    const struct wide r = times(times(times(times(wide(4.0, 0), shear), bend), gd), gd);
    const struct wide bent = eigenvalue(p, q, r);
    return larger(larger(times(axial, a), times(twist, dd)), across.x == 0.0 ? bent : plus(bent, times(across, a)));
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

struct tally {
    const vti_bodies *b;
    double *shares; /* per body, the sum of its elements' weights */
    int scale;      /* weights are in units of 2^(256 scale) */
    int largest;    /* the scale that the largest weight has */
    int status;
    int64_t effect;
    struct wide most, heaviest;
    int64_t at[2]; /* bodies of the element that is fastest with its shares */
    vti_stable found;
};

/** Whether the bodies of a spring are there; once one is not, nothing is looked at any more. */
static int exists(const vti_spring *s, struct tally *t)
{
    const int64_t first = t->b->first, end = first + t->b->count;
    if (s->i < first || s->i >= end || s->j < -1 || s->j >= end || (s->j >= 0 && s->j < first))
        t->status = VTI_E_BOND;
    return t->status == VTI_OK;
}

/** Whether a spring pulls bodies, and whether it turns them: shear does so by arms, and all that pulls by a lever. */
static int pulls(const vti_spring *s)
{
    return s->axial != 0.0 || s->across != 0.0 || s->shear != 0.0;
}

static int turns(const vti_spring *s)
{
    const double arm_j = s->j >= 0 ? s->arm_j : 0.0, lever_j = s->j >= 0 ? s->lever_j : 0.0;
    return s->bend != 0.0 || s->twist != 0.0 || (s->shear != 0.0 && (s->arm_i != 0.0 || arm_j != 0.0)) ||
           (pulls(s) && (s->lever_i != 0.0 || lever_j != 0.0));
}

/** Whether what a spring moves has a mass and an inertia; what has no v stays where it is, what has no omega does not
 *  turn. */
static int weighs(const vti_spring *s, struct tally *t)
{
    const vti_bodies *b = t->b;
    if (b->mass.p == NULL && vti_has(&b->v) && pulls(s))
        t->status = VTI_E_MASS;
    else if (vti_inertia_check(b) != VTI_OK && turns(s))
        t->status = VTI_E_INERTIA;
    return t->status == VTI_OK;
}

/** An element weighs as much as it is fast with its bodies whole: slow ones need little of a body. Any weights will do
 *  for a bound, so that of elements which are slower by 2^256 and more it is enough to say that they are there. 0 if it
 *  is slack, or if its bodies are not there, or have no mass or inertia. */
static double weight(const vti_spring *s, struct tally *t, struct wide *whole)
{
    if (!exists(s, t) || !weighs(s, t))
        return 0.0;
    *whole = omega2(s, t->b, 1.0, 1.0);
    if (whole->x == 0.0)
        return 0.0;
    return whole->e >= t->scale - 1 ? at_exponent(*whole, t->scale) : least * down;
}

static void add_weight(void *context, const vti_spring *s)
{
    struct tally *t = context;
    struct wide whole = {0.0, 0};
    const double w = weight(s, t, &whole);
    if (w == 0.0)
        return;
    t->largest = whole.e > t->largest ? whole.e : t->largest;
    t->shares[s->i - t->b->first] += w;
    if (s->j >= 0)
        t->shares[s->j - t->b->first] += w;
}

static void name(const vti_spring *s, struct wide whole, struct tally *t)
{
    const vti_stable stable = {NAN, t->effect, s->element, s->i, s->j};
    t->heaviest = whole;
    t->found = stable;
}

static void find_most(void *context, const vti_spring *s)
{
    struct tally *t = context;
    struct wide whole = {0.0, 0};
    const double w = weight(s, t, &whole);
    if (w == 0.0)
        return;
    const double zi = t->shares[s->i - t->b->first] / w, zj = s->j >= 0 ? t->shares[s->j - t->b->first] / w : 0.0;
    const struct wide found = omega2(s, t->b, zi, zj);
    if (!is_larger(found, t->most))
        return;
    t->most = found;
    t->at[0] = s->i;
    t->at[1] = s->j;
    name(s, whole, t);
}

/** By shares that are as the weights all elements at a body come out alike: it is the heaviest there that sets the
 *  step. */
static void name_heaviest(void *context, const vti_spring *s)
{
    struct tally *t = context;
    if (s->i != t->at[0] && s->i != t->at[1] && (s->j < 0 || (s->j != t->at[0] && s->j != t->at[1])))
        return;
    const struct wide whole = omega2(s, t->b, 1.0, 1.0);
    if (is_larger(whole, t->heaviest))
        name(s, whole, t);
}

static int each_spring(const vti_effect *effects, int64_t n, const vti_deformation *at, vti_spring_visit *visit,
                       struct tally *t)
{
    for (t->effect = 0; t->effect < n && t->status == VTI_OK; ++t->effect) {
        const vti_effect *e = effects + t->effect;
        const int status = e->springs != NULL ? e->springs(e->self, t->b, at, visit, t) : VTI_OK;
        if (t->status == VTI_OK)
            t->status = status;
    }
    return t->status;
}

/** Shares of the bodies, in units in which the largest weight is a double. */
static int share_out(const vti_effect *effects, int64_t n, const vti_deformation *at, struct tally *t)
{
    do {
        t->scale = t->largest;
        t->largest = INT_MIN;
        for (int64_t i = 0; i < t->b->count; ++i)
            t->shares[i] = 0.0;
        if (each_spring(effects, n, at, add_weight, t) != VTI_OK)
            return t->status;
    } while (t->largest != INT_MIN && t->largest != t->scale);
    return VTI_OK;
}

/* ---- what is given ----------------------------------------------------------------------------------------------- */

int vti_springs_none(const void *self, const vti_bodies *bodies, const vti_deformation *at, vti_spring_visit *visit,
                     void *context)
{
    (void)self, (void)bodies, (void)at, (void)visit, (void)context;
    return VTI_OK;
}

/** Whether all of them report their springs; else *stable names the first that does not. */
static int springs_check(const vti_effect *effects, int64_t n, vti_stable *stable)
{
    for (int64_t k = 0; k < n; ++k)
        if (effects[k].springs == NULL && effects[k].apply != NULL) {
            const vti_stable unknown = {NAN, k, -1, -1, -1};
            *stable = unknown;
            return VTI_E_SPRINGS;
        }
    return VTI_OK;
}

int vti_stable_step(const vti_effect *effects, int64_t n, const vti_bodies *b, const vti_deformation *at,
                    double *scratch, vti_stable *stable)
{
    int status = vti_effects_fault(effects, n, b, NULL);
    if (status == VTI_OK && (scratch == NULL || stable == NULL))
        status = VTI_E_NULL;
    if (status == VTI_OK)
        status = springs_check(effects, n, stable);
    if (status != VTI_OK)
        return status;
    struct tally t = {b, scratch, 0, 0, VTI_OK, 0, {0.0, 0}, {0.0, 0}, {-1, -1}, {INFINITY, -1, -1, -1, -1}};
    status = share_out(effects, n, at, &t);
    if (status == VTI_OK && t.largest != INT_MIN) /* else all are slack */
        status = each_spring(effects, n, at, find_most, &t);
    if (status == VTI_OK && t.at[0] >= 0)
        status = each_spring(effects, n, at, name_heaviest, &t);
    if (status != VTI_OK)
        return status;
    *stable = t.found;
    if (isfinite(t.most.x))
        stable->h = t.most.x > 0.0 ? ldexp(2.0 / sqrt(t.most.x), -128 * t.most.e) : INFINITY;
    else
        stable->h = 0.0; /* what is infinite, or NaN, is infinitely fast */
    return VTI_OK;
}
