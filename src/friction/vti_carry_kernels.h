/* SPDX-License-Identifier: BSD-3-Clause
 * Springs of many pairs, and of many bodies at walls, that follow a drift at once. Included by vti_touch_kernels.h
 * only. */
#ifndef VTI_CARRY_KERNELS_H
#define VTI_CARRY_KERNELS_H

#include "../vti_move.h"
#include "vti_carry.h"
#include "../contacts/vti_touch_gather.h"

VTI_MOVE_LAW(drift_law, lanes, lanes_of, lanes_sqrt)

/** dalpha of those that turn by half a turn, cf[0] = 0, is cut off, as attitudes are. u: the time times Omega. */
VTI_INLINE void cut_off(const lanes cf[2], const lanes u[3], lanes dalpha[3])
{
    double all[3][WIDTH];
    for (int k = 0; k < 3; ++k)
        lanes_store(all[k], dalpha[k]);
    for (int l = 0; l < WIDTH; ++l) {
        const double c = lanes_get(cf[1], l);
        const double q[4] = {c * lanes_get(u[0], l), c * lanes_get(u[1], l), c * lanes_get(u[2], l),
                             lanes_get(cf[0], l)};
        double turn[3];
        if (q[3] != 0.0)
            continue;
        vti_rrv_from_pair(q, turn);
        for (int k = 0; k < 3; ++k)
            all[k][l] = turn[k];
    }
    for (int k = 0; k < 3; ++k)
        dalpha[k] = lanes_load(all[k]);
}

/** dalpha of the turn by Omega for the time of the drift, as vti_drift_increment has it. */
VTI_INLINE void increments(const vti_drifted *drifted, const lanes omega[3], lanes dalpha[3])
{
    const int law = (int)drifted->law;
    lanes cf[2], u[3];
    for (int k = 0; k < 3; ++k)
        dalpha[k] = u[k] = drifted->t * omega[k];
    if (law == VTI_LAW_CAYLEY)
        return;
    lanes s2 = lanes_dot(u, u);
    if (law == VTI_LAW_CLOSED) /* of a body that no step turns */
        s2 = lanes_where(s2 > 1.0, lanes_of(1.0), s2);
    drift_law(law, s2, cf);
    if (law != VTI_LAW_CLOSED) { /* beyond, the fraction of a turn is lost, and half a turn as good as any */
        const lanes_mask within = s2 < 0x1p60;
        cf[0] = lanes_where(within, cf[0], lanes_of(0.0));
        cf[1] = lanes_where(within, cf[1], lanes_of(1.0));
    }
    for (int k = 0; k < 3; ++k)
        dalpha[k] = 2.0 * cf[1] * u[k] / cf[0];
    if (!lanes_all(cf[0] != 0.0))
        cut_off(cf, u, dalpha);
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
    lanes a_i[3], a_j[3], d0[3];
    gather_difference(layout, &b->v, i, j, c->slid);
    for (int k = 0; k < 3; ++k)
        c->slid[k] *= drifted->t;
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
    gather_touches(layout, p->contacts, b, whole(pairs->which, first, pairs->count, place), &c.touch, &i, &j);
    gather_motion(layout, &c, &i, &j, b, drifted, pairs, first);
    whole_places(pairs->held[0], pairs->held, first, pairs->count, at);
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
        BY_LAYOUT(packed, carry_lanes, p, b, drifted, pairs, first, &books);
    books_close(&books, p->lost, VTI_FRICTION_BOOKS);
}

/* ---- at walls ---------------------------------------------------------------------------------------------------- */

/** Increments of attitude of bodies, and of the wall where they touch it; at a plane h Omega, so that rolling on it is
 *  exact. */
VTI_INLINE void gather_turns_at(enum touch_layout layout, const vti_walls *p, const vti_bodies *b,
                                const vti_drifted *drifted, const struct vti_touch *touch, const struct side *i,
                                const struct vti_carried *bodies, int64_t first, lanes a_i[3], lanes a_j[3])
{
    lanes w_i[3];
    if (!bodies->turned)
        gather(layout, &b->omega, i, w_i);
    for (int k = 0; k < 3; ++k) {
        a_i[k] = bodies->turned ? lanes_load(bodies->turn[k] + first) : drifted->t * w_i[k];
        a_j[k] = drifted->t * touch->w_j[k];
    }
    if (touch->wall < p->count)
        return;
    if (!bodies->turned)
        increments(drifted, w_i, a_i);
    increments(drifted, touch->w_j, a_j);
}

VTI_INLINE void carry_lanes_at_wall(enum touch_layout layout, const vti_friction *p, const vti_bodies *b,
                                    const vti_drifted *drifted, int64_t w, struct vti_carried *bodies, int64_t first,
                                    struct books *books)
{
    const int64_t count = bodies->count - first;
    struct vti_carry c;
    struct vti_loads before, loads;
    struct vti_taken taken;
    struct side i;
    lanes x[3], v[3], d0[3], a_i[3], a_j[3];
    int64_t place[WIDTH], at[WIDTH];
    side_of(whole(bodies->which, first, bodies->count, place), &i);
    gather_at_wall(layout, p->walls, b, w, &i, &c.touch, x);
    gather(layout, &b->v, &i, v);
    gather_turns_at(layout, p->walls, b, drifted, &c.touch, &i, bodies, first, a_i, a_j);
    vti_carry_at_wall(&c, p->walls, drifted->t, x, v, a_j, d0);
    vti_carry_stretch(&c, d0, a_i, a_j);
    whole_places(bodies->held[0], bodies->held, first, bodies->count, at);
    gather_loads(p, bodies->held[0], at, &before);
    loads = before;
    vti_carry_loads(p, &c, lanes_of(vti_friction_of_wall(p, w)), &loads, &taken);
    const lanes_mask there = vti_face_near(&c.touch, INFINITY); /* but on the axis of a cylinder */
    if (!lanes_all(there))
        leave(there == 0, &before, &loads, &taken);
    lanes_store(bodies->delta + first, lanes_where(there, c.touch.delta, lanes_of(INFINITY)));
    scatter_loads(p, bodies->held[0], at, &loads);
    const lanes lost[BOOKS] = {taken.lost[0], taken.lost[1], taken.lost[2], lanes_of(0.0)};
    book_lanes(books, lost, count);
    if (c.touch.moves)
        sum_lanes(p->walls->work, taken.worked[0] + taken.worked[1] + taken.worked[2], count);
}

static void carry_at_wall(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, int64_t w,
                          struct vti_carried *bodies)
{
    const int packed = is_packed(b);
    struct books books;
    books_open(&books, p->lost, VTI_FRICTION_BOOKS);
    for (int64_t first = 0; first < bodies->count; first += WIDTH)
        BY_LAYOUT(packed, carry_lanes_at_wall, p, b, drifted, w, bodies, first, &books);
    books_close(&books, p->lost, VTI_FRICTION_BOOKS);
}

#endif
