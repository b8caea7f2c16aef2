/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Displacement and turn of a body at a wall over one drift: input of vti_spring.h. For lanes of bodies at one wall, or
 * for one, as in vti_touch_motion.h. */
#ifndef VTI_CARRY_H
#define VTI_CARRY_H

#include "../contacts/vti_face.h"
#include "vti_spring.h"

/** d0, n0 and delta0 of a body that is at x, and has come there past the wall by slid. */
VTI_INLINE void vti_carry_from(struct vti_carry *c, const vti_walls *p, const lanes x[3], lanes d0[3])
{
    const struct vti_touch *const at = &c->touch;
    lanes before[3], gap = at->r - lanes_dot(c->slid, at->n);
    for (int k = 0; k < 3; ++k)
        c->n0[k] = at->n[k];
    if (at->wall >= p->count) {
        vti_face_from_axis(p, at->wall, x, before);
        for (int k = 0; k < 3; ++k)
            before[k] -= c->slid[k];
        gap = vti_face_inside(vti_face_axis(p, at->wall), before, c->n0);
    }
    for (int k = 0; k < 3; ++k)
        d0[k] = gap * c->n0[k];
    c->delta0 = at->length - gap;
}

/** Takes the way of a turning wall's surface off the motion: A x (foot0 + foot1)/2, A the wall's increment. */
VTI_INLINE void vti_carry_drag(struct vti_carry *c, const vti_walls *p, double h, const lanes x[3], const lanes d0[3],
                               const lanes a_j[3])
{
    const struct vti_touch *const at = &c->touch;
    lanes now[3], foot[3], way[3];
    vti_face_from_axis(p, at->wall, x, now);
    for (int k = 0; k < 3; ++k)
        foot[k] = 0.5 * (now[k] - c->slid[k] - d0[k] + now[k] - at->r * at->n[k]);
    lanes_cross(a_j, foot, way);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] -= way[k];
        c->dragged[k] = h * p->motion[at->wall].velocity[k] + way[k];
    }
}

/** d0, n0, delta0 and the way past the surface, of a body at x that has moved with v for the time h: what
 *  vti_carry_stretch goes on with. a_j is the wall's increment. */
VTI_INLINE void vti_carry_at_wall(struct vti_carry *c, const vti_walls *p, double h, const lanes x[3], const lanes v[3],
                                  const lanes a_j[3], lanes d0[3])
{
    const vti_wall_motion *const m = vti_face_motion(p, c->touch.wall);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] = h * (m != NULL ? v[k] - m->velocity[k] : v[k]);
        c->turned[k] = a_j[k];
        c->dragged[k] = lanes_of(0.0);
    }
    vti_carry_from(c, p, x, d0);
    if (m != NULL)
        vti_carry_drag(c, p, h, x, d0, a_j);
}

#endif
