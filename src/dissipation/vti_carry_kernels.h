/* SPDX-License-Identifier: BSD-3-Clause
 * Springs of many pairs, and of many bodies at walls, that follow a drift at once. Included by vti_touch_kernels.h only. */
#ifndef VTI_CARRY_KERNELS_H
#define VTI_CARRY_KERNELS_H

#include "../vti_move.h"
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

/** The way back of gather_loads. */
VTI_INLINE void scatter_loads(const vti_friction *p, vti_held *first, const int64_t at[WIDTH],
                              const struct vti_loads *f)
{
    double *const table = (double *)(void *)first;
    if (p->sliding > 0.0)
        lanes_untriple(table + SLIDING_AT, at, f->sliding);
    if (p->rolling > 0.0)
        lanes_untriple(table + ROLLING_AT, at, f->rolling);
    if (p->twisting > 0.0)
        lanes_scatter(table + TWISTING_AT, at, f->twisting);
}

/** Where pairs were out of reach before the drift, loads are those before it, and nothing is lost. */
VTI_INLINE void leave(lanes_mask out, const struct vti_loads *before, struct vti_loads *f, struct vti_taken *taken)
{
    for (int k = 0; k < 3; ++k) {
        f->sliding[k] = lanes_where(out, before->sliding[k], f->sliding[k]);
        f->rolling[k] = lanes_where(out, before->rolling[k], f->rolling[k]);
        taken->lost[k] = lanes_where(out, lanes_of(0.0), taken->lost[k]);
    }
    f->twisting = lanes_where(out, before->twisting, f->twisting);
}

/** Pairs that were out of reach before the drift are left as they are: lists need not have them. */
VTI_INLINE void carry_lanes(enum touch_layout layout, const vti_friction *p, const vti_bodies *b,
                            const vti_drifted *drifted, struct vti_carried *pairs, int64_t first, struct books *books)
{
    struct vti_carry c;
    struct vti_loads before, loads;
    struct vti_taken taken;
    struct side i, j;
    int64_t place[WIDTH], at[WIDTH];
    gather_touches(layout, p->contacts, b, whole(pairs->pair, first, pairs->count, place), &c.touch, &i, &j);
    gather_motion(layout, &c, &i, &j, b, drifted, pairs, first);
    whole_slots(pairs->held[0], pairs->held, first, pairs->count, at);
    gather_loads(p, pairs->held[0], at, &before);
    loads = before;
    vti_carry_loads(p, &c, lanes_of(p->sliding), &loads, &taken);
    const lanes_mask near = c.delta0 >= -p->reach;
    if (!lanes_all(near))
        leave(near == 0, &before, &loads, &taken);
    lanes_store(pairs->delta + first, lanes_where(near, c.touch.delta, lanes_of(INFINITY)));
    scatter_loads(p, pairs->held[0], at, &loads);
    const lanes lost[BOOKS] = {taken.lost[0], taken.lost[1], taken.lost[2], lanes_of(0.0)};
    book_lanes(books, lost, pairs->count - first);
}

static void carry(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, struct vti_carried *pairs)
{
    const int packed = is_packed(b);
    struct books books;
    books_open(&books, p->lost, VTI_FRICTION_BOOKS);
    for (int64_t first = 0; first < pairs->count; first += WIDTH)
        if (packed)
            carry_lanes(PACKED, p, b, drifted, pairs, first, &books);
        else
            carry_lanes(ANY, p, b, drifted, pairs, first, &books);
    books_close(&books, p->lost, VTI_FRICTION_BOOKS);
}

/* ---- at walls ---------------------------------------------------------------------------------------------------- */

VTI_INLINE void load_vector(const struct vti_carried_at *from, int column, int64_t first, lanes a[3])
{
    for (int k = 0; k < 3; ++k)
        a[k] = lanes_load(from->column[column + k] + first);
}

VTI_INLINE void carry_lanes_at_wall(const vti_friction *p, struct vti_carried_at *from, int64_t first)
{
    struct vti_carry c = {.touch = {.j = -1, .moves = from->moves}};
    struct vti_loads loads;
    struct vti_taken taken;
    lanes d0[3], a_i[3], a_j[3];
    int64_t at[WIDTH];
    load_vector(from, VTI_AT_N, first, c.touch.n);
    c.touch.r = lanes_load(from->column[VTI_AT_R] + first);
    c.touch.delta = lanes_load(from->column[VTI_AT_DELTA] + first);
    c.touch.length = lanes_load(from->column[VTI_AT_LENGTH] + first);
    c.touch.stiffness = lanes_load(from->column[VTI_AT_STIFFNESS] + first);
    c.touch.s_i = lanes_of(1.0);
    c.touch.s_j = lanes_of(0.0);
    load_vector(from, VTI_AT_N0, first, c.n0);
    load_vector(from, VTI_AT_D0, first, d0);
    c.delta0 = lanes_load(from->column[VTI_AT_DELTA0] + first);
    load_vector(from, VTI_AT_SLID, first, c.slid);
    load_vector(from, VTI_AT_DRAGGED, first, c.dragged);
    load_vector(from, VTI_AT_TURN_I, first, a_i);
    load_vector(from, VTI_AT_TURN_J, first, a_j);
    load_vector(from, VTI_AT_TURN_J, first, c.turned);
    vti_carry_stretch(&c, d0, a_i, a_j);
    whole_slots(from->held[0], from->held, first, from->count, at);
    gather_loads(p, from->held[0], at, &loads);
    vti_carry_loads(p, &c, lanes_load(from->column[VTI_AT_SLIDING] + first), &loads, &taken);
    scatter_loads(p, from->held[0], at, &loads);
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) {
        lanes_store(from->column[VTI_AT_LOST + k] + first, taken.lost[k]);
        lanes_store(from->column[VTI_AT_WORKED + k] + first, taken.worked[k]);
    }
}

static void carry_at_walls(const vti_friction *p, struct vti_carried_at *at)
{
    for (int64_t first = 0; first < at->count; first += WIDTH)
        carry_lanes_at_wall(p, at, first);
}

#endif
