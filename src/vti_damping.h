/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What dashpots of a touch depend on, whatever the bodies: their coefficients, as means over the drift beside the flow,
 * and the limits of friction (EQUATIONS 6.3). */
#ifndef VTI_DAMPING_H
#define VTI_DAMPING_H

#include "vti_decay.h"
#include "vti_history.h"
#include "vti_touch.h"

/** The four motions that are damped, in the order of vti_dashpots.lost. */
enum vti_damped { VTI_NORMAL, VTI_TANGENTIAL, VTI_ROLLING, VTI_TWISTING };

/** Of which the coefficients are not all 0. */
static inline void vti_damping_all(const vti_dashpots *p, int damped[VTI_DASHPOT_BOOKS])
{
    damped[VTI_NORMAL] = p->zeta > 0.0 || p->normal > 0.0;
    damped[VTI_TANGENTIAL] = p->tangential > 0.0 || (p->ratio > 0.0 && damped[VTI_NORMAL]);
    damped[VTI_ROLLING] = p->rolling > 0.0;
    damped[VTI_TWISTING] = p->twisting > 0.0;
}

/* ---- coefficients, as their mean over the drift ------------------------------------------------------------------ */

/** x^{5/4} of x > 0, else 0 */
static inline double vti_damping_power_5_4(double x)
{
    return x > 0.0 ? x * sqrt(sqrt(x)) : 0.0;
}

/** The share of the way from delta to other on which they overlap, as they do at one end or at both. */
static inline double vti_damping_share(double delta, double other)
{
    if (delta > 0.0 && other > 0.0)
        return 1.0;
    const double inside = delta > 0.0 ? delta : other, outside = delta > 0.0 ? other : delta;
    return inside / (inside - outside);
}

/** Mean of delta_+^{1/4} on the same way: (4/5) (delta_+^{5/4} - other_+^{5/4})/(delta - other) */
static inline double vti_damping_mean_power(double delta, double other)
{
    if (fabs(delta - other) < 1e-6 * fabs(delta))
        return sqrt(sqrt(delta));
    return 0.8 * (vti_damping_power_5_4(delta) - vti_damping_power_5_4(other)) / (delta - other);
}

/** A touch, between here and the other end of the drift. */
struct vti_damping {
    double k_h;     /* F = k_h delta^{3/2}, K/length^{5/2} */
    double root;    /* of delta, 0 apart */
    double delta;   /* overlap here, */
    double other;   /* and at the other end */
    double touched; /* share of the drift */
    double zeta;
};

/** zeta is the caller's. */
static inline void vti_damping_at(const struct vti_touch *touch, double other, struct vti_damping *at)
{
    at->delta = touch->delta;
    at->other = other;
    at->k_h = touch->stiffness / (touch->length * touch->length * sqrt(touch->length));
    at->root = touch->delta > 0.0 ? sqrt(touch->delta) : 0.0;
    at->touched = vti_damping_share(touch->delta, other);
}

/** factor F_n; 0 apart */
static inline double vti_damping_force(const struct vti_damping *at, double factor)
{
    return factor * at->k_h * at->delta * at->root;
}

/** c_n = normal + sqrt(5) zeta sqrt(m_n k_h) delta^{1/4}, m_n being the mass. */
static inline double vti_damping_normal(const vti_dashpots *p, const struct vti_damping *at, double mass)
{
    double c = p->normal * at->touched;
    if (at->zeta > 0.0)
        c += sqrt(5.0) * at->zeta * sqrt(mass * at->k_h) * vti_damping_mean_power(at->delta, at->other);
    return c;
}

/** Those of all motions. */
static inline void vti_damping_coefficients(const vti_dashpots *p, const struct vti_damping *at, double mass,
                                            double c[VTI_DASHPOT_BOOKS])
{
    c[VTI_NORMAL] = vti_damping_normal(p, at, mass);
    c[VTI_TANGENTIAL] = p->tangential * at->touched + p->ratio * c[VTI_NORMAL];
    c[VTI_ROLLING] = p->rolling * at->touched;
    c[VTI_TWISTING] = p->twisting * at->touched;
}

/* ---- limits ------------------------------------------------------------------------------------------------------ */

/** What the springs of friction hold at a touch; nothing where there is no friction. */
static inline const vti_held *vti_damping_held(const vti_dashpots *p, const struct vti_touch *touch)
{
    static const vti_held none;
    if (p->friction == NULL || p->friction->history == NULL || p->friction->history->slot == NULL)
        return &none;
    const vti_held *held =
        vti_history_find(p->friction->history, touch->i + 1, touch->j >= 0 ? touch->j + 1 : -1 - touch->wall);
    return held != NULL ? held : &none;
}

/** How much of F_n the load of a motion may be; 0: there is no limit. */
static inline double vti_damping_share_of_force(const vti_dashpots *p, const struct vti_touch *touch, int motion)
{
    const vti_friction *const friction = p->friction;
    if (friction == NULL)
        return 0.0;
    if (motion == VTI_TANGENTIAL)
        return touch->j < 0 ? vti_friction_of_wall(friction, touch->wall) : friction->sliding;
    return motion == VTI_ROLLING ? friction->rolling : friction->twisting;
}

/** Spring and dashpot together obey the limit: the largest s in [0, 1] with |-t f + s p| <= t limit, f being what the
 *  spring holds. A = p.p, B = -t f.p, C = min(0, t^2 (f.f - limit^2)), q = sqrt(B^2 - A C). */
static inline double vti_damping_limited(const double p[3], const double f[3], double t, double limit)
{
    const double a = vti_dot(p, p), b = -t * vti_dot(f, p), over = t * t * (vti_dot(f, f) - limit * limit),
                 c = over < 0.0 ? over : 0.0;
    if (a + 2.0 * b + c <= 0.0 || !(a > 0.0)) /* within it as a whole */
        return 1.0;
    const double q = sqrt(b * b - a * c);
    const double s = b > 0.0 ? -c / (b + q) : (q - b) / a;
    return s < 1.0 ? s : 1.0;
}

#endif
