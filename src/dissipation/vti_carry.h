/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What one touch, of bodies or at a wall, has been through in a drift; what its springs hold then is in
 * vti_spring.h. */
#ifndef VTI_CARRY_H
#define VTI_CARRY_H

#include "../contacts/vti_history.h"
#include "vti_spring.h"
#include "../contacts/vti_touch.h"

/** Increments of attitude over the drift: the law's own, or those of a body that turns by L; at a plane h Omega, so
 *  that rolling on it is exact. */
static inline void vti_carry_turns(const struct vti_touch *at, const vti_walls *walls, const vti_bodies *b,
                                   const vti_drifted *drifted, double ai[3], double aj[3])
{
    const double still[3] = {0.0, 0.0, 0.0};
    const int at_plane = at->j < 0 && at->wall < walls->count;
    double wi[3], wj[3];
    vti_load(&b->omega, at->i, wi);
    if (at->j >= 0)
        vti_load(&b->omega, at->j, wj);
    for (int k = 0; k < 3; ++k) {
        if (at->j < 0)
            wj[k] = at->moves ? at->w_j[k] : still[k];
        ai[k] = drifted->t * wi[k];
        aj[k] = drifted->t * wj[k];
    }
    if (!at_plane) {
        vti_drift_increment((int)drifted->law, drifted->t, wi, ai);
        vti_drift_increment((int)drifted->law, drifted->t, wj, aj);
    }
    const vti_bodies *const turning = vti_drifted_bodies(drifted, b);
    if (vti_turns_by_spin(turning))
        vti_rotor_turned(turning, vti_drifted_body(drifted, at->i), drifted, at_plane, ai);
}

/** The place that body i had before the drift, from a point of the axis of the wall there, and its place now. */
static inline void vti_carry_from_axis(const struct vti_carry *c, const vti_walls *walls, const vti_bodies *b,
                                       double before[3], double now[3])
{
    double x[3];
    vti_load(&b->x, c->touch.i, x);
    vti_face_from_axis(walls, c->touch.wall, x, now);
    for (int k = 0; k < 3; ++k)
        before[k] = now[k] - c->slid[k];
}

/** Takes the way of a turning wall's surface off the motion: A x (foot0 + foot1)/2, A the wall's increment. */
static inline void vti_carry_drag(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b, double h,
                                  const double aj[3], const double d0[3])
{
    const struct vti_touch *const at = &c->touch;
    double before[3], now[3], foot[3], way[3];
    vti_carry_from_axis(c, walls, b, before, now);
    for (int k = 0; k < 3; ++k)
        foot[k] = 0.5 * (before[k] - d0[k] + now[k] - at->r * at->n[k]);
    vti_cross(aj, foot, way);
    for (int k = 0; k < 3; ++k) {
        c->slid[k] -= way[k];
        c->dragged[k] = h * walls->motion[at->wall].velocity[k] + way[k];
    }
}

/** d at the start of the drift, and with it n0 and delta0. */
static inline void vti_carry_start(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b, double d0[3])
{
    const struct vti_touch *const at = &c->touch;
    if (at->j < 0 && at->wall >= walls->count) {
        double before[3], now[3];
        vti_carry_from_axis(c, walls, b, before, now);
        const double gap = vti_face_inside(vti_face_axis(walls, at->wall), before, c->n0);
        for (int k = 0; k < 3; ++k)
            d0[k] = gap * c->n0[k];
        c->delta0 = at->length - gap;
        return;
    }
    double along = 0.0; /* of the way, normal to a plane */
    if (at->j >= 0) {
        vti_carry_apart(c, c->slid, d0);
        return;
    }
    for (int k = 0; k < 3; ++k)
        along += c->slid[k] * at->n[k];
    for (int k = 0; k < 3; ++k) {
        d0[k] = (at->r - along) * at->n[k];
        c->n0[k] = at->n[k];
    }
    c->delta0 = at->length - (at->r - along);
}

/** d0, n0, delta0, the way of the centre past the surface, and the turns: what vti_carry_stretch goes on with. */
static inline void vti_carry_motion(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b,
                                    const vti_drifted *drifted, double d0[3], double ai[3], double aj[3])
{
    const struct vti_touch *const at = &c->touch;
    const double h = drifted->t;
    double vi[3], vj[3] = {0.0, 0.0, 0.0};
    vti_load(&b->v, at->i, vi);
    if (at->j >= 0)
        vti_load(&b->v, at->j, vj);
    for (int k = 0; k < 3; ++k) {
        if (at->moves)
            vj[k] = walls->motion[at->wall].velocity[k];
        c->slid[k] = h * (vi[k] - vj[k]);
    }
    vti_carry_turns(at, walls, b, drifted, ai, aj);
    vti_carry_start(c, walls, b, d0);
    if (at->moves)
        vti_carry_drag(c, walls, b, h, aj, d0);
}

#endif
