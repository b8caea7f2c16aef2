/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Pairs of bodies as lanes, a pair to a lane: where they are and what they have, from any layout, and the way back.
 * Included by vti_touch_kernels.h only. */
#ifndef VTI_TOUCH_GATHER_H
#define VTI_TOUCH_GATHER_H

#include "vti_lanes.h"

#include "vti_hertz.h"
#include "vti_touch_motion.h"
#include "vti_touch_table.h"

/** Bodies of one side of the pairs. */
struct side {
    int64_t body[WIDTH];
};

VTI_INLINE void sides_of(const struct vti_seat *seat, struct side *i, struct side *j)
{
    for (int l = 0; l < WIDTH; ++l) {
        i->body[l] = seat[l].i;
        j->body[l] = seat[l].j;
    }
}

VTI_INLINE void times(const struct side *side, int64_t stride, int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = side->body[l] * stride;
}

/** Components side by side, at any stride. */
VTI_INLINE int is_adjacent(const vti_view *view)
{
    return view->c[1] == view->c[0] + 1 && view->c[2] == view->c[0] + 2;
}

VTI_INLINE void gather(const vti_view *view, const struct side *side, lanes r[3])
{
    int64_t at[WIDTH];
    times(side, view->stride, at);
    if (is_adjacent(view))
        lanes_triples(view->c[0], at, r);
    else
        for (int k = 0; k < 3; ++k)
            r[k] = lanes_gather(view->c[k], at);
}

VTI_INLINE void scatter(const vti_view *view, const struct side *side, const lanes r[3])
{
    int64_t at[WIDTH];
    times(side, view->stride, at);
    if (is_adjacent(view))
        lanes_untriple(view->c[0], at, r);
    else
        for (int k = 0; k < 3; ++k)
            lanes_scatter(view->c[k], at, r[k]);
}

VTI_INLINE lanes scalars(const vti_scalars *s, const struct side *side)
{
    int64_t at[WIDTH];
    if (s->stride == 0)
        return lanes_of(*s->p);
    times(side, s->stride, at);
    return lanes_gather(s->p, at);
}

/** K and the length from which on they touch, where they are not all the same. */
VTI_INLINE void gather_laws(const vti_contacts *p, const struct vti_seat *seat, struct vti_touch *at)
{
    double length[WIDTH], stiffness[WIDTH];
    for (int l = 0; l < WIDTH; ++l) {
        length[l] = vti_contact_length(p, seat[l].k, seat[l].i, seat[l].j);
        stiffness[l] = vti_contact_stiffness(p, seat[l].i, seat[l].j, length[l]);
    }
    at->length = lanes_load(length);
    at->stiffness = lanes_load(stiffness);
}

/** Where pairs touch; sides become theirs. */
VTI_INLINE void gather_touches(const vti_contacts *p, const vti_bodies *b, const struct vti_seat *seat,
                               struct vti_touch *at, struct side *i, struct side *j)
{
    lanes d[3], x[3];
    sides_of(seat, i, j);
    at->i = at->j = 0;
    at->moves = 0;
    gather(&b->x, i, d);
    gather(&b->x, j, x);
    for (int c = 0; c < 3; ++c)
        d[c] -= x[c];
    gather_laws(p, seat, at);
    vti_touch_between(at, d, scalars(&p->diameter, i), scalars(&p->diameter, j));
}

#endif
