/* SPDX-License-Identifier: BSD-3-Clause
 * Dashpots of many pairs, no two of which share a body, at once. Included by vti_touch_kernels.h only. */
#ifndef VTI_DASHPOT_KERNELS_H
#define VTI_DASHPOT_KERNELS_H

#include "vti_dashpot_flow.h"
#include "vti_touch_gather.h"

/** 1/m, or 1/J */
VTI_INLINE lanes per(const vti_scalars *s, const struct side *side)
{
    return 1.0 / scalars(s, side);
}

/** Velocities, and what resists their change. */
VTI_INLINE void gather_velocities(enum touch_layout layout, const vti_bodies *b, const struct side *i,
                                  const struct side *j, struct place *at)
{
    struct vti_touch *const touch = &at->touch;
    struct vti_touch_motion *const m = &at->motion;
    const lanes zero = lanes_of(0.0);
    m->turns = vti_has(&b->omega);
    gather(layout, &b->v, i, m->v_i);
    gather(layout, &b->v, j, m->v_j);
    touch->per_m_i = per(&b->mass, i);
    touch->per_m_j = per(&b->mass, j);
    touch->per_j_i = touch->per_j_j = zero;
    for (int k = 0; k < 3; ++k)
        m->w_i[k] = m->w_j[k] = zero;
    if (!m->turns)
        return;
    gather(layout, &b->omega, i, m->w_i);
    gather(layout, &b->omega, j, m->w_j);
    touch->per_j_i = per(&b->inertia, i);
    touch->per_j_j = per(&b->inertia, j);
}

VTI_INLINE void scatter_velocities(enum touch_layout layout, const vti_bodies *b, const struct side *i,
                                   const struct side *j, const struct vti_touch_motion *m)
{
    scatter(layout, &b->v, i, m->v_i);
    scatter(layout, &b->v, j, m->v_j);
    if (!m->turns)
        return;
    scatter(layout, &b->omega, i, m->w_i);
    scatter(layout, &b->omega, j, m->w_j);
}

/** Of the first count pairs, in their order. */
VTI_INLINE void book(const struct vti_sweep *s, const struct place *at, int64_t count)
{
    for (int k = 0; k < MOTIONS; ++k)
        for (int l = 0; s->damped[k] && l < WIDTH && l < count; ++l)
            vti_sum_add(&s->p->lost[k], lanes_get(at->lost[k], l));
}

VTI_INLINE void flow_lanes(enum touch_layout layout, const struct vti_sweep *s, const struct vti_seat *seat,
                           int64_t count)
{
    static const vti_friction none;
    const vti_held *held[WIDTH];
    struct place at;
    struct side i, j;
    gather_touches(layout, s->p->contacts, s->b, seat, &at.touch, &i, &j);
    gather_velocities(layout, s->b, &i, &j, &at);
    at.damping.zeta = s->p->zeta;
    for (int l = 0; l < WIDTH && s->p->friction != NULL; ++l)
        held[l] = vti_damping_held_by(s->p, seat[l].i + 1, seat[l].j + 1);
    gather_loads(s->p->friction != NULL ? s->p->friction : &none, held, &at.held);
    if (!flow_touch(s, &at))
        return;
    scatter_velocities(layout, s->b, &i, &j, &at.motion);
    book(s, &at, count);
}

/** Beyond count, up to a whole number of lanes, pairs are repeated. */
static void flow_pairs(const struct vti_sweep *s, int64_t count, const struct vti_seat *seat)
{
    const int packed = is_packed(s->b);
    for (int64_t first = 0; first < count; first += WIDTH)
        if (packed)
            flow_lanes(PACKED, s, seat + first, count - first);
        else
            flow_lanes(ANY, s, seat + first, count - first);
}

#endif
