/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What dashpots of a touch depend on, whatever the bodies: their coefficients, as means over the drift beside the flow,
 * and the limits of friction (EQUATIONS 6.3). For lanes of touches, or for one, as in vti_touch_motion.h. */
#ifndef VTI_DAMPING_H
#define VTI_DAMPING_H

#include "vti_decay.h"
#include "../contacts/vti_face.h"
#include "../contacts/vti_history.h"
#include "../contacts/vti_touch_motion.h"

/** The four motions that are damped, in the order of vti_dashpots.lost. */
enum vti_damped { VTI_NORMAL, VTI_TANGENTIAL, VTI_ROLLING, VTI_TWISTING };

/** Of which the coefficients are not all 0, at pairs and at all walls. */
static inline void vti_damping_all(const vti_dashpots *p, int damped[VTI_DASHPOT_BOOKS])
{
    int any = p->zeta > 0.0;
    for (int64_t w = 0; p->wall_zeta != NULL && w < vti_faces(p->walls); ++w)
        any |= p->wall_zeta[w] > 0.0;
    damped[VTI_NORMAL] = any || p->normal > 0.0;
    damped[VTI_TANGENTIAL] = p->tangential > 0.0 || (p->ratio > 0.0 && damped[VTI_NORMAL]);
    damped[VTI_ROLLING] = p->rolling > 0.0;
    damped[VTI_TWISTING] = p->twisting > 0.0;
}

/* ---- coefficients, as their mean over the drift ------------------------------------------------------------------ */

/** The share of the way from delta to other on which they overlap, as they do at one end or at both. */
VTI_INLINE lanes vti_damping_share(lanes delta, lanes other)
{
    const lanes_mask here = delta > 0.0, there = other > 0.0;
    if (lanes_all(here & there)) /* as mostly: no division */
        return lanes_of(1.0);
    const lanes inside = lanes_where(here, delta, other), outside = lanes_where(here, other, delta);
    return lanes_where(here & there, lanes_of(1.0), inside / (inside - outside));
}

/** A touch, between here and the other end of the drift. With o = [delta/L]_+ and k = K/L^2
 *
 *      F_n = k delta o^{1/2} = k_H delta^{3/2},      k_H delta^{1/2} = k o^{1/2},      k_H = K/L^{5/2}               */
struct vti_damping {
    lanes k;
    lanes per_length; /* 1/L */
    lanes root;       /* o^{1/2} here */
    lanes delta;      /* overlap here */
    lanes other;      /* overlap at the other end */
    lanes touched;    /* share of the drift */
    double zeta;
};

/** o^{1/2} */
VTI_INLINE lanes vti_damping_root(const struct vti_damping *at, lanes delta)
{
    return lanes_sqrt(lanes_where(delta > 0.0, delta * at->per_length, lanes_of(0.0)));
}

/** zeta is the caller's. */
VTI_INLINE void vti_damping_at(const struct vti_touch *touch, lanes other, struct vti_damping *at)
{
    at->delta = touch->delta;
    at->other = other;
    at->per_length = 1.0 / touch->length;
    at->k = touch->stiffness * at->per_length * at->per_length;
    at->root = vti_damping_root(at, touch->delta);
    at->touched = vti_damping_share(touch->delta, other);
}

/** factor F_n; 0 apart */
VTI_INLINE lanes vti_damping_force(const struct vti_damping *at, double factor)
{
    return factor * at->k * at->delta * at->root;
}

/** The mean over the drift of (m k_H)^{1/2} delta_+^{1/4}, m being the mass: with its values a and b at both ends
 *
 *     (4/5) (a^5 - b^5)/(a^4 - b^4) = (4/5) (a^4 + a^3 b + a^2 b^2 + a b^3 + b^4)/((a + b) (a^2 + b^2))
 *
 *  for the share of it that they touch; with b = 0 where they touch at one end only. */
VTI_INLINE lanes vti_damping_mean(const struct vti_damping *at, lanes mass)
{
    const lanes a2 = mass * at->k * at->root, b2 = mass * at->k * vti_damping_root(at, at->other);
    const lanes a = lanes_sqrt(a2), b = lanes_sqrt(b2), ab = a * b, both = a2 + b2;
    const lanes mean = 0.8 * (both * (both + ab) - ab * ab) / ((a + b) * both);
    return lanes_where(both > 0.0, mean * at->touched, lanes_of(0.0));
}

/** c_n = normal + sqrt(5) zeta sqrt(m_n k_H) delta^{1/4} */
VTI_INLINE lanes vti_damping_normal(const vti_dashpots *p, const struct vti_damping *at, lanes mass)
{
    lanes c = p->normal * at->touched;
    if (at->zeta > 0.0)
        c += sqrt(5.0) * at->zeta * vti_damping_mean(at, mass);
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
    if (p->friction == NULL || p->friction->history == NULL || p->friction->history->used == 0)
        return &none;
    const vti_held *held =
        vti_history_find(p->friction->history, touch->i + 1, touch->j >= 0 ? touch->j + 1 : -1 - touch->wall);
    return held != NULL ? held : &none;
}

/** The share of F_n that the load of a motion may be: 0 at a wall without friction, negative where it has no limit. */
static inline double vti_damping_share_of_force(const vti_dashpots *p, const struct vti_touch *touch, int motion)
{
    static const vti_friction none;
    const vti_friction *const friction = p->friction != NULL ? p->friction : &none;
    const double own = motion == VTI_TANGENTIAL ? friction->sliding
                       : motion == VTI_ROLLING  ? friction->rolling
                                                : friction->twisting;
    if (!(own > 0.0))
        return -1.0;
    return motion == VTI_TANGENTIAL && touch->j < 0 ? vti_friction_of_wall(friction, touch->wall) : own;
}

/** Spring and dashpot together obey the limit: g = p - t f, f being what the spring holds, goes to the nearest place of
 *  |g| <= R = t max(limit, |f|), and p takes all of the change: p <- p - s g, s = 1 - R/|g|, which is (g.g - R^2)/(|g|
 *  (|g| + R)) (EQUATIONS 6.3). The longest share of p that obeys the limit would jump from nothing to all of p as f, on
 *  the limit, and p pass the right angle, and make velocities of first order (test friction). For p = -m c u, of one m
 *  for all directions, none of these gains energy: p'.p >= p'.p', as the nearest place of a convex set has it. Where
 *  nothing is beyond, as mostly, there are neither roots nor divisions. */
VTI_INLINE void vti_damping_limit(lanes p[3], const lanes f[3], double t, lanes limit)
{
    const lanes load2 = t * t * lanes_dot(f, f), most2 = t * t * limit * limit;
    const lanes r2 = lanes_where(load2 < most2, most2, load2);
    const lanes over = lanes_dot(p, p) - 2.0 * t * lanes_dot(f, p) + (load2 - r2);
    const lanes_mask beyond = over > 0.0;
    if (lanes_bits(beyond) == 0)
        return;
    const lanes g = lanes_sqrt(r2 + over), r = lanes_sqrt(r2), s = over / (g * (g + r));
    for (int k = 0; k < 3; ++k)
        p[k] = lanes_where(beyond, p[k] - s * (p[k] - t * f[k]), p[k]);
}

#endif
