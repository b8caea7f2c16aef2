/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where walls are, and how their surfaces move: with g the distance from the wall and N the normal towards the body
 *
 *     plane       g = n.x - (offset + n.moved),  N = n
 *     cylinder    g = R - |rho|,  N = -rho/|rho|,  rho being what of x - (point + moved) is across the axis
 *
 * and the velocity V + W x (x - centre) of the surface at x, W along the axis, which leaves the wall in its place. For
 * lanes of bodies at one wall, or for one body, as in vti_touch_motion.h. */
#ifndef VTI_FACE_H
#define VTI_FACE_H

#include "vti_hertz.h"
#include "vti_touch_motion.h"

static inline int64_t vti_faces(const vti_walls *p)
{
    return p != NULL && p->count >= 0 && p->cylinders >= 0 ? p->count + p->cylinders : 0;
}

/** Whether the limits of friction, between bodies and at these walls, are finite numbers >= 0. */
static inline int vti_friction_has_limits(const vti_friction *p, const vti_walls *walls)
{
    const double all[] = {p->sliding, p->rolling, p->twisting};
    int good = 1;
    for (int k = 0; k < 3; ++k)
        good &= isfinite(all[k]) && all[k] >= 0.0;
    for (int64_t w = 0; p->wall_sliding != NULL && w < vti_faces(walls); ++w)
        good &= isfinite(p->wall_sliding[w]) && p->wall_sliding[w] >= 0.0;
    return good;
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
VTI_INLINE void vti_face_across(const lanes a[3], const double n[3], lanes across[3])
{
    const lanes along = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
    for (int k = 0; k < 3; ++k)
        across[k] = a[k] - along * n[k];
}

/** From the axis of cylinder c towards the inside of its wall: of a place that is d away from a point of the axis. On
 *  the axis N = 0. */
VTI_INLINE lanes vti_face_inside(const double cylinder[7], const lanes d[3], lanes n[3])
{
    lanes rho[3];
    vti_face_across(d, cylinder, rho);
    const lanes r = lanes_sqrt(lanes_dot(rho, rho));
    const lanes_mask aside = r > VTI_COINCIDENT;
    const lanes length = lanes_where(aside, r, lanes_of(1.0)); /* none divides by zero */
    for (int k = 0; k < 3; ++k)
        n[k] = lanes_where(aside, -rho[k] / length, 0.0 * rho[k]);
    return cylinder[6] - r;
}

/** x less a point of the axis of wall w. */
VTI_INLINE void vti_face_from_axis(const vti_walls *p, int64_t w, const lanes x[3], lanes d[3])
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
VTI_INLINE lanes vti_face_above(const double n[3], double offset, const lanes x[3])
{
    return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - offset;
}

/** g and N; g is NaN where a number is. */
VTI_INLINE lanes vti_face_gap(const vti_walls *p, int64_t w, const lanes x[3], lanes n[3])
{
    if (w >= p->count) {
        lanes d[3];
        vti_face_from_axis(p, w, x, d);
        return vti_face_inside(p->cylinder + 7 * (w - p->count), d, n);
    }
    double plane[3];
    const double offset = vti_face_plane(p, w, plane);
    for (int k = 0; k < 3; ++k)
        n[k] = lanes_of(plane[k]);
    return vti_face_above(plane, offset, x);
}

/** The axis about which wall w turns. */
static inline const double *vti_face_axis(const vti_walls *p, int64_t w)
{
    return w >= p->count ? p->cylinder + 7 * (w - p->count) : p->plane + 4 * w;
}

/** Where walls move: the velocity of the surface of wall w at x, and its angular velocity. */
VTI_INLINE void vti_face_velocity(const vti_walls *p, int64_t w, const lanes x[3], lanes velocity[3], lanes turning[3])
{
    const vti_wall_motion *const m = &p->motion[w];
    const double *const axis = vti_face_axis(p, w);
    lanes d[3];
    vti_face_from_axis(p, w, x, d);
    for (int k = 0; k < 3; ++k)
        turning[k] = lanes_of(m->spin * axis[k]);
    lanes_cross(turning, d, velocity);
    for (int k = 0; k < 3; ++k)
        velocity[k] += m->velocity[k];
}

/** A body at x, of that radius, and wall w, where they are now; K is the caller's. */
VTI_INLINE void vti_face_touch(struct vti_touch *at, const vti_walls *p, int64_t w, const lanes x[3], lanes radius)
{
    at->i = 0;
    at->j = -1;
    at->wall = w;
    at->length = radius;
    at->r = vti_face_gap(p, w, x, at->n);
    at->delta = radius - at->r;
    at->s_i = lanes_of(1.0);
    at->s_j = lanes_of(0.0);
    at->moves = p->motion != NULL;
}

/** Where it is no farther than reach, and there is a direction. */
VTI_INLINE lanes_mask vti_face_near(const struct vti_touch *at, double reach)
{
    return (at->delta >= -reach) & (lanes_dot(at->n, at->n) > 0.0);
}

/** How the surface moves where a body at x touches it. */
VTI_INLINE void vti_face_move(struct vti_touch *at, const vti_walls *p, const lanes x[3])
{
    lanes foot[3];
    for (int c = 0; c < 3; ++c) {
        foot[c] = x[c] - at->r * at->n[c];
        at->v_j[c] = at->w_j[c] = lanes_of(0.0);
    }
    if (at->moves)
        vti_face_velocity(p, at->wall, foot, at->v_j, at->w_j);
}

#endif
