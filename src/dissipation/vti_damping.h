/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What dashpots of a touch depend on, whatever the bodies: their coefficients, as means over the drift beside the flow,
 * and the limits of friction (EQUATIONS 6.3). For lanes of touches, or for one, as in vti_touch_motion.h. */
#ifndef VTI_DAMPING_H
#define VTI_DAMPING_H

#include "vti_decay.h"
#include "../contacts/vti_history.h"
#include "../contacts/vti_touch_motion.h"

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

/** The share of the way from delta to other on which they overlap, as they do at one end or at both. */
VTI_INLINE lanes vti_damping_share(lanes delta, lanes other)
{
    const lanes_mask here = delta > 0.0, there = other > 0.0;
    const lanes inside = lanes_where(here, delta, other), outside = lanes_where(here, other, delta);
    return lanes_where(here & there, lanes_of(1.0), inside / (inside - outside));
}

/** Mean of delta_+^{1/4} on the same way: (4/5) (delta_+^{5/4} - other_+^{5/4})/(delta - other) */
VTI_INLINE lanes vti_damping_mean_power(lanes delta, lanes other)
{
    const lanes zero = lanes_of(0.0), from = lanes_where(delta > 0.0, delta, zero),
                to = lanes_where(other > 0.0, other, zero), power = lanes_sqrt(lanes_sqrt(from));
    const lanes powers = 0.8 * (from * power - to * lanes_sqrt(lanes_sqrt(to))) / (delta - other);
    return lanes_where(lanes_abs(delta - other) < 1e-6 * lanes_abs(delta), power, powers);
}

/** A touch, between here and the other end of the drift. */
struct vti_damping {
    lanes k_h;     /* F = k_h delta^{3/2}, K/length^{5/2} */
    lanes root;    /* of delta, 0 apart */
    lanes delta;   /* overlap here, */
    lanes other;   /* and at the other end */
    lanes touched; /* share of the drift */
    double zeta;
};

/** zeta is the caller's. */
VTI_INLINE void vti_damping_at(const struct vti_touch *touch, lanes other, struct vti_damping *at)
{
    at->delta = touch->delta;
    at->other = other;
    at->k_h = touch->stiffness / (touch->length * touch->length * lanes_sqrt(touch->length));
    at->root = lanes_sqrt(lanes_where(touch->delta > 0.0, touch->delta, lanes_of(0.0)));
    at->touched = vti_damping_share(touch->delta, other);
}

/** factor F_n; 0 apart */
VTI_INLINE lanes vti_damping_force(const struct vti_damping *at, double factor)
{
    return factor * at->k_h * at->delta * at->root;
}

/** c_n = normal + sqrt(5) zeta sqrt(m_n k_h) delta^{1/4}, m_n being the mass. */
VTI_INLINE lanes vti_damping_normal(const vti_dashpots *p, const struct vti_damping *at, lanes mass)
{
    lanes c = p->normal * at->touched;
    if (at->zeta > 0.0)
        c += sqrt(5.0) * at->zeta * lanes_sqrt(mass * at->k_h) * vti_damping_mean_power(at->delta, at->other);
    return c;
}

/** Those of all motions. */
VTI_INLINE void vti_damping_coefficients(const vti_dashpots *p, const struct vti_damping *at, lanes mass,
                                         lanes c[VTI_DASHPOT_BOOKS])
{
    c[VTI_NORMAL] = vti_damping_normal(p, at, mass);
    c[VTI_TANGENTIAL] = p->tangential * at->touched + p->ratio * c[VTI_NORMAL];
    c[VTI_ROLLING] = p->rolling * at->touched;
    c[VTI_TWISTING] = p->twisting * at->touched;
}

/* ---- limits ------------------------------------------------------------------------------------------------------ */

/** What the springs of friction hold at one touch; nothing where there is no friction. */
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

/** Spring and dashpot together obey the limit: g = p - t f, f being what the spring holds, goes to the nearest place of
 *  |g| <= R = t max(limit, |f|), and p takes all of the change: p <- p - s g, s = 1 - R/|g|, which is
 *  (g.g - R^2)/(|g| (|g| + R)). Here EQUATIONS 6.3 has the longest share of p that obeys the limit, which jumps from
 *  nothing to all of p as f, on the limit, and p pass the right angle, and takes velocities to first order (test
 *  friction). For p = -m c u, of one m for all directions, none of these gains energy: p'.p >= p'.p', as the nearest
 *  place of a convex set has it. */
VTI_INLINE void vti_damping_limit(lanes p[3], const lanes f[3], double t, lanes limit)
{
    const lanes load2 = t * t * lanes_dot(f, f), most2 = t * t * limit * limit;
    const lanes r2 = lanes_where(load2 < most2, most2, load2);
    const lanes over = lanes_dot(p, p) - 2.0 * t * lanes_dot(f, p) + (load2 - r2);
    const lanes_mask beyond = over > 0.0;
    const lanes g = lanes_sqrt(r2 + over), r = lanes_sqrt(r2);
    const lanes s = lanes_where(beyond, over, lanes_of(0.0)) / lanes_where(beyond, g * (g + r), lanes_of(1.0));
    for (int k = 0; k < 3; ++k)
        p[k] -= s * (p[k] - t * f[k]);
}

#endif
