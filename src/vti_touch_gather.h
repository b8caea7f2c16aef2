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

/** PACKED: all vectors lie as x[n][3]. ANY: whatever the views say. */
enum touch_layout { ANY, PACKED };

static inline int is_packed(const vti_bodies *b)
{
    return vti_is_packed(&b->x) && vti_is_packed(&b->v) && (!vti_has(&b->omega) || vti_is_packed(&b->omega));
}

/** Bodies of one side of the pairs. */
struct side {
    int64_t body[WIDTH], packed[WIDTH]; /* their numbers; where their vectors begin, if they lie packed */
};

VTI_INLINE void sides_of(const struct vti_seat *seat, struct side *i, struct side *j)
{
    for (int l = 0; l < WIDTH; ++l) {
        i->body[l] = seat[l].i;
        j->body[l] = seat[l].j;
        i->packed[l] = 3 * seat[l].i;
        j->packed[l] = 3 * seat[l].j;
    }
}

VTI_INLINE void times(const struct side *side, int64_t stride, int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = side->body[l] * stride;
}

VTI_INLINE void gather(enum touch_layout layout, const vti_view *view, const struct side *side, lanes r[3])
{
    int64_t at[WIDTH];
    if (layout == PACKED) {
        lanes_triples(view->c[0], side->packed, r);
        return;
    }
    times(side, view->stride, at);
    for (int k = 0; k < 3; ++k)
        r[k] = lanes_gather(view->c[k], at);
}

VTI_INLINE void scatter(enum touch_layout layout, const vti_view *view, const struct side *side, const lanes r[3])
{
    int64_t at[WIDTH];
    if (layout == PACKED) {
        lanes_untriple(view->c[0], side->packed, r);
        return;
    }
    times(side, view->stride, at);
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

/** The length from which on they touch, and K, as vti_contact_length and vti_contact_stiffness have them. */
VTI_INLINE void gather_laws(const vti_contacts *p, const struct vti_seat *seat, lanes diameter_i, lanes diameter_j,
                            struct vti_touch *at)
{
    double each[WIDTH];
    at->length = 0.5 * diameter_i + 0.5 * diameter_j;
    at->stiffness = lanes_of(p->stiffness);
    if (p->length.p != NULL) {
        for (int l = 0; l < WIDTH; ++l)
            each[l] = vti_scalar(&p->length, seat[l].k);
        at->length = lanes_load(each);
    }
    if (p->modulus.p != NULL) {
        for (int l = 0; l < WIDTH; ++l)
            each[l] = vti_contact_stiffness(p, seat[l].i, seat[l].j, lanes_get(at->length, l));
        at->stiffness = lanes_load(each);
    }
}

/** Where pairs touch; sides become theirs. */
VTI_INLINE void gather_touches(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b,
                               const struct vti_seat *seat, struct vti_touch *at, struct side *i, struct side *j)
{
    lanes d[3], x[3];
    sides_of(seat, i, j);
    at->i = at->j = 0;
    at->moves = 0;
    gather(layout, &b->x, i, d);
    gather(layout, &b->x, j, x);
    for (int c = 0; c < 3; ++c)
        d[c] -= x[c];
    const lanes diameter_i = scalars(&p->diameter, i), diameter_j = scalars(&p->diameter, j);
    gather_laws(p, seat, diameter_i, diameter_j, at);
    vti_touch_between(at, d, diameter_i, diameter_j);
}

/** Three numbers that begin so far from the start of each. */
VTI_INLINE void gather_held(const vti_held *const held[WIDTH], size_t from, lanes r[3])
{
    double row[3][WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        for (int k = 0; k < 3; ++k)
            row[k][l] = ((const double *)(const void *)((const char *)held[l] + from))[k];
    for (int k = 0; k < 3; ++k)
        r[k] = lanes_load(row[k]);
}

/** What the springs that there are hold, 0 of others. */
VTI_INLINE void gather_loads(const vti_friction *p, const vti_held *const held[WIDTH], struct vti_loads *f)
{
    double twisting[WIDTH];
    for (int k = 0; k < 3; ++k)
        f->sliding[k] = f->rolling[k] = lanes_of(0.0);
    f->twisting = lanes_of(0.0);
    if (p->sliding > 0.0)
        gather_held(held, offsetof(vti_held, sliding), f->sliding);
    if (p->rolling > 0.0)
        gather_held(held, offsetof(vti_held, rolling), f->rolling);
    if (!(p->twisting > 0.0))
        return;
    for (int l = 0; l < WIDTH; ++l)
        twisting[l] = held[l]->twisting;
    f->twisting = lanes_load(twisting);
}

#endif
