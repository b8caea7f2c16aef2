/* SPDX-License-Identifier: BSD-3-Clause
 * Dashpots of many pairs, no two of which share a body, at once. Included by vti_touch_kernels.h only. */
#ifndef VTI_DASHPOT_KERNELS_H
#define VTI_DASHPOT_KERNELS_H

#include "vti_dashpot_flow.h"
#include "../contacts/vti_touch_gather.h"

/* ---- which touch ------------------------------------------------------------------------------------------------- */

/** Where pairs will not touch at the other end of the drift; NaN shall show. */
VTI_INLINE lanes_mask stay_apart(enum touch_layout layout, const struct vti_sweep *s, const int64_t *which)
{
    const vti_contacts *const p = s->p->contacts;
    struct side i, j;
    lanes d[3], u[3];
    sides_of(p->pair, p->base, which, &i, &j);
    gather_difference(layout, &s->b->x, &i, &j, d);
    gather_difference(layout, &s->b->v, &i, &j, u);
    const lanes length = gather_length(p, which, scalars(&p->diameter, &i), scalars(&p->diameter, &j)),
                r = lanes_sqrt(lanes_dot(d, d));
    return length - r - s->drift * (lanes_dot(u, d) / r) <= 0.0;
}

static int64_t soon(const struct vti_sweep *s, int64_t count, const int64_t *apart, int64_t *pairs)
{
    const int packed = is_packed(s->b);
    int64_t place[WIDTH], stay[WIDTH], closing = 0;
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const here = whole(apart, first, count, place);
        lanes_told(BY_LAYOUT(packed, stay_apart, s, here), stay);
        for (int l = 0; l < WIDTH && first + l < count; ++l) { /* what stays apart is written over */
            pairs[closing] = here[l];
            closing += 1 + stay[l];
        }
    }
    return closing;
}

/* ---- flows ------------------------------------------------------------------------------------------------------- */

/** What springs hold between bodies i and j of pairs which, or where j is NULL at a wall: 0 where there are none. */
VTI_INLINE void find_loads(const struct vti_sweep *s, const int64_t *which, const struct side *i, const struct side *j,
                           int64_t wall, struct vti_loads *f)
{
    static const vti_friction none;
    const vti_dashpots *const p = s->p;
    const vti_history *const table = p->friction != NULL ? p->friction->history : NULL;
    const int64_t *const guess = j != NULL ? s->guess : NULL;
    int64_t at[WIDTH] = {0}, holds[WIDTH];
    if (table == NULL || table->used == 0) {
        gather_loads(&none, NULL, at, f);
        return;
    }
    for (int l = 0; l < WIDTH; ++l) {
        const int64_t one = i->body[l] + 1, other = j != NULL ? j->body[l] + 1 : -1 - wall;
        const vti_held *held = guess != NULL ? &table->held[guess[which[l] % VTI_GUESSES]] : NULL;
        if (guess == NULL || !vti_history_is(held, one, other))
            held = vti_history_find(table, one, other);
        holds[l] = held != NULL;
        at[l] = held != NULL ? place_of(table->held, held) : 0;
    }
    const lanes_mask empty = lanes_zero(holds);
    gather_loads(p->friction, table->held, at, f);
    if (lanes_bits(empty) == 0)
        return;
    for (int k = 0; k < 3; ++k) {
        f->sliding[k] = lanes_where(empty, lanes_of(0.0), f->sliding[k]);
        f->rolling[k] = lanes_where(empty, lanes_of(0.0), f->rolling[k]);
    }
    f->twisting = lanes_where(empty, lanes_of(0.0), f->twisting);
}

VTI_INLINE void flow_lanes(enum touch_layout layout, const struct vti_sweep *s, const int64_t *which, int64_t count,
                           struct books *books)
{
    struct place at;
    struct side i, j;
    gather_touches(layout, s->p->contacts, s->b, which, &at.touch, &i, &j);
    gather_velocities(layout, s->b, &i, &j, &at.touch, &at.motion);
    at.out = lanes_of(0.0) > 0.0;
    at.damping.zeta = s->p->zeta;
    find_loads(s, which, &i, &j, 0, &at.held);
    if (!flow_touch(s, &at))
        return;
    scatter_velocities(layout, s->b, &i, &j, &at.motion);
    book_lanes(books, at.lost, count);
}

static void flow_pairs(const struct vti_sweep *s, int64_t count, const int64_t *which)
{
    const int packed = is_packed(s->b);
    int64_t place[WIDTH];
    struct books books;
    books_open(&books, s->p->lost, MOTIONS);
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const here = whole(which, first, count, place);
        BY_LAYOUT(packed, flow_lanes, s, here, count - first, &books);
    }
    books_close(&books, s->p->lost, MOTIONS);
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Velocities of bodies at a wall and its own, and what resists. */
VTI_INLINE void gather_velocities_at(enum touch_layout layout, const vti_bodies *b, const struct side *i,
                                     struct vti_touch *touch, struct vti_touch_motion *m)
{
    const lanes zero = lanes_of(0.0);
    touch->per_m_j = touch->per_j_j = touch->per_j_i = zero;
    touch->per_m_i = per(&b->mass, i);
    m->turns = vti_has(&b->omega);
    gather(layout, &b->v, i, m->v_i);
    for (int k = 0; k < 3; ++k) {
        m->v_j[k] = touch->v_j[k];
        m->w_j[k] = touch->w_j[k];
        m->w_i[k] = zero;
    }
    if (!m->turns)
        return;
    gather(layout, &b->omega, i, m->w_i);
    touch->per_j_i = per(&b->inertia, i);
}

VTI_INLINE void flow_lanes_at_wall(enum touch_layout layout, const struct vti_sweep *s, int64_t w, const int64_t *body,
                                   int64_t count, struct books *books)
{
    const vti_dashpots *const p = s->p;
    struct place at;
    struct side i;
    lanes x[3];
    side_of(body, &i);
    gather_at_wall(layout, p->walls, s->b, w, &i, &at.touch, x);
    at.out = vti_face_near(&at.touch, p->reach) == 0;
    gather_velocities_at(layout, s->b, &i, &at.touch, &at.motion);
    at.damping.zeta = p->wall_zeta != NULL ? p->wall_zeta[w] : p->zeta;
    find_loads(s, body, &i, NULL, w, &at.held);
    if (!flow_touch(s, &at))
        return;
    scatter(layout, &s->b->v, &i, at.motion.v_i);
    if (at.motion.turns)
        scatter(layout, &s->b->omega, &i, at.motion.w_i);
    if (at.touch.moves)
        sum_lanes(p->walls->work, at.worked, count);
    book_lanes(books, at.lost, count);
}

static void flow_at_wall(const struct vti_sweep *s, int64_t w, int64_t count, const int64_t *body)
{
    const int packed = is_packed(s->b);
    int64_t place[WIDTH];
    struct books books;
    books_open(&books, s->p->lost, MOTIONS);
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const here = whole(body, first, count, place);
        BY_LAYOUT(packed, flow_lanes_at_wall, s, w, here, count - first, &books);
    }
    books_close(&books, s->p->lost, MOTIONS);
}

#endif
