/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where walls are, and how their surfaces move: with g the distance from the wall and N the normal towards the body
 *
 *     plane       g = n.x - (offset + n.moved),  N = n
 *     cylinder    g = R - |rho|,  N = -rho/|rho|,  rho being what of x - (point + moved) is across the axis
 *
 * and the velocity V + W x (x - centre) of the surface at x, W along the axis, which leaves the wall in its place. */
#ifndef VTI_FACE_H
#define VTI_FACE_H

#include "vti_hertz.h"

static inline int64_t vti_faces(const vti_walls *p)
{
    return p != NULL && p->count >= 0 && p->cylinders >= 0 ? p->count + p->cylinders : 0;
}

/** K of body i, of that radius, at wall w. */
static inline double vti_face_stiffness(const vti_walls *p, int64_t w, int64_t i, double radius)
{
    if (p->modulus.p == NULL)
        return p->each != NULL ? p->each[w] : p->stiffness;
    const double modulus = vti_scalar(&p->modulus, i);
    return vti_hertz_material(p->moduli != NULL ? vti_hertz_reduced(modulus, p->moduli[w]) : modulus, radius, radius);
}

/** How wall w moves, NULL if none does. */
static inline const vti_wall_motion *vti_face_motion(const vti_walls *p, int64_t w)
{
    return p->motion != NULL ? &p->motion[w] : NULL;
}

/** a, but what is along the unit vector n. */
static inline void vti_face_across(const double a[3], const double n[3], double across[3])
{
    const double along = vti_dot(a, n);
    for (int k = 0; k < 3; ++k)
        across[k] = a[k] - along * n[k];
}

/** From the axis of cylinder c towards the inside of its wall: of a place that is d away from a point of the axis. On
 *  the axis N = 0. */
static inline double vti_face_inside(const double cylinder[7], const double d[3], double n[3])
{
    double rho[3];
    vti_face_across(d, cylinder, rho);
    const double r = vti_norm(rho);
    for (int k = 0; k < 3; ++k)
        n[k] = r > VTI_COINCIDENT ? -rho[k] / r : 0.0 * rho[k];
    return cylinder[6] - r;
}

/** x less a point of the axis of wall w. */
static inline void vti_face_from_axis(const vti_walls *p, int64_t w, const double x[3], double d[3])
{
    const vti_wall_motion *const m = vti_face_motion(p, w);
    for (int k = 0; k < 3; ++k) {
        const double at = w >= p->count ? p->cylinder[7 * (w - p->count) + 3 + k] : m != NULL ? m->centre[k] : 0.0;
        d[k] = x[k] - (m != NULL ? at + m->moved[k] : at);
    }
}

/** Where plane w stands: N, and n.x on it. */
static inline double vti_face_plane(const vti_walls *p, int64_t w, double n[3])
{
    const double *const plane = p->plane + 4 * w;
    const vti_wall_motion *const m = vti_face_motion(p, w);
    for (int k = 0; k < 3; ++k)
        n[k] = plane[k];
    return m != NULL ? plane[3] + vti_dot(plane, m->moved) : plane[3];
}

/** g of a plane that stands at offset. */
static inline double vti_face_above(const double n[3], double offset, const double x[3])
{
    return vti_dot(n, x) - offset;
}

/** g and N; g is NaN where a number is. */
static inline double vti_face_gap(const vti_walls *p, int64_t w, const double x[3], double n[3])
{
    if (w >= p->count) {
        double d[3];
        vti_face_from_axis(p, w, x, d);
        return vti_face_inside(p->cylinder + 7 * (w - p->count), d, n);
    }
    const double offset = vti_face_plane(p, w, n);
    return vti_face_above(n, offset, x);
}

/** The axis about which wall w turns. */
static inline const double *vti_face_axis(const vti_walls *p, int64_t w)
{
    return w >= p->count ? p->cylinder + 7 * (w - p->count) : p->plane + 4 * w;
}

/** Where walls move: the velocity of the surface of wall w at x, and its angular velocity. */
static inline void vti_face_velocity(const vti_walls *p, int64_t w, const double x[3], double velocity[3],
                                     double turning[3])
{
    const vti_wall_motion *const m = &p->motion[w];
    const double *const axis = vti_face_axis(p, w);
    double d[3];
    vti_face_from_axis(p, w, x, d);
    for (int k = 0; k < 3; ++k)
        turning[k] = m->spin * axis[k];
    vti_cross(turning, d, velocity);
    for (int k = 0; k < 3; ++k)
        velocity[k] += m->velocity[k];
}

#endif
