/* SPDX-License-Identifier: BSD-3-Clause
 * Springs of many pairs that follow a drift at once. Included by vti_touch_kernels.h only. */
#ifndef VTI_CARRY_KERNELS_H
#define VTI_CARRY_KERNELS_H

#include "vti_move.h"
#include "vti_spring.h"
#include "vti_touch_gather.h"

VTI_MOVE_LAW(drift_law, lanes, lanes_of, lanes_sqrt)

/** dalpha of the turn by Omega for the time of the drift, as vti_drift_increment has it. */
VTI_INLINE void increments(const vti_drifted *drifted, const lanes omega[3], lanes dalpha[3])
{
    const int law = (int)drifted->law;
    lanes cf[2];
    for (int k = 0; k < 3; ++k)
        dalpha[k] = drifted->t * omega[k];
    if (law == VTI_LAW_CAYLEY)
        return;
    const lanes s2 = lanes_dot(dalpha, dalpha);
    drift_law(law, s2, cf);
    if (law != VTI_LAW_CLOSED) { /* beyond, the fraction of a turn is lost, and half a turn as good as any */
        const lanes_mask within = s2 < 0x1p60;
        cf[0] = lanes_where(within, cf[0], lanes_of(0.0));
        cf[1] = lanes_where(within, cf[1], lanes_of(1.0));
    }
    for (int k = 0; k < 3; ++k)
        dalpha[k] = 2.0 * cf[1] * dalpha[k] / cf[0];
}

/** Increments of attitude by Omega. */
VTI_INLINE void gather_turns(enum touch_layout layout, const struct side *i, const struct side *j, const vti_bodies *b,
                             const vti_drifted *drifted, lanes a_i[3], lanes a_j[3])
{
    lanes w_i[3], w_j[3];
    gather(layout, &b->omega, i, w_i);
    gather(layout, &b->omega, j, w_j);
    increments(drifted, w_i, a_i);
    increments(drifted, w_j, a_j);
}

/** n0, n_m, delta0 and the motion X over the drift. */
VTI_INLINE void gather_motion(enum touch_layout layout, struct vti_carry *c, const struct side *i, const struct side *j,
                              const vti_bodies *b, const vti_drifted *drifted, const struct vti_carried *pairs,
                              int64_t first)
{
    lanes v[3], a_i[3], a_j[3], d0[3];
    gather(layout, &b->v, i, c->slid);
    gather(layout, &b->v, j, v);
    for (int k = 0; k < 3; ++k)
        c->slid[k] = drifted->t * (c->slid[k] - v[k]);
    for (int k = 0; k < 3 && pairs->turned; ++k) {
        a_i[k] = lanes_load(pairs->turn[k] + first);
        a_j[k] = lanes_load(pairs->turn[3 + k] + first);
    }
    if (!pairs->turned)
        gather_turns(layout, i, j, b, drifted, a_i, a_j);
    vti_carry_apart(c, c->slid, d0);
    vti_carry_stretch(c, d0, a_i, a_j);
}

VTI_INLINE void scatter_load(const vti_friction *p, vti_held *held, const struct vti_loads *f, int l)
{
    for (int k = 0; k < 3 && p->sliding > 0.0; ++k)
        held->sliding[k] = lanes_get(f->sliding[k], l);
    for (int k = 0; k < 3 && p->rolling > 0.0; ++k)
        held->rolling[k] = lanes_get(f->rolling[k], l);
    if (p->twisting > 0.0)
        held->twisting = lanes_get(f->twisting, l);
}

/** Pairs that were out of reach before the drift are left as they are: lists need not have them. */
VTI_INLINE void carry_lanes(enum touch_layout layout, const vti_friction *p, const vti_bodies *b,
                            const vti_drifted *drifted, struct vti_carried *pairs, int64_t first)
{
    const double coefficient[VTI_FRICTION_BOOKS] = {p->sliding, p->rolling, p->twisting};
    struct vti_carry c;
    struct vti_loads loads;
    struct vti_taken taken;
    struct side i, j;
    int64_t place[WIDTH];
    const vti_held *held[WIDTH];
    double delta0[WIDTH];
    gather_touches(layout, p->contacts, b, whole(pairs->pair, first, pairs->count, place), &c.touch, &i, &j);
    gather_motion(layout, &c, &i, &j, b, drifted, pairs, first);
    whole_held(pairs->held, first, pairs->count, held);
    gather_loads(p, held, &loads);
    vti_carry_loads(p, &c, p->sliding, &loads, &taken);
    lanes_store(pairs->delta + first, c.touch.delta);
    lanes_store(delta0, c.delta0);
    for (int l = 0; l < WIDTH && first + l < pairs->count; ++l) {
        if (!(delta0[l] >= -p->reach)) {
            pairs->delta[first + l] = INFINITY;
            continue;
        }
        scatter_load(p, pairs->held[first + l], &loads, l);
        for (int k = 0; k < VTI_FRICTION_BOOKS; ++k)
            if (coefficient[k] > 0.0)
                vti_sum_add(&p->lost[k], lanes_get(taken.lost[k], l));
    }
}

static void carry(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, struct vti_carried *pairs)
{
    const int packed = is_packed(b);
    for (int64_t first = 0; first < pairs->count; first += WIDTH)
        if (packed)
            carry_lanes(PACKED, p, b, drifted, pairs, first);
        else
            carry_lanes(ANY, p, b, drifted, pairs, first);
}

#endif
