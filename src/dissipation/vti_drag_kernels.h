/* SPDX-License-Identifier: BSD-3-Clause
 * Drag on many bodies at once, a body to a lane. Included by vti_touch_kernels.h only. */
#ifndef VTI_DRAG_KERNELS_H
#define VTI_DRAG_KERNELS_H

#include "vti_drag_flow.h"
#include "../contacts/vti_touch_gather.h"

VTI_INLINE lanes value_of(const vti_scalars *s, const struct side *i)
{
    return s->p != NULL ? scalars(s, i) : lanes_of(0.0);
}

/** |u|. Returns where it is not that of vti_norm to the last bit: its square rounds to infinity, or some of it to 0. */
VTI_INLINE lanes_mask speed_of(const lanes u[3], lanes *speed)
{
    const lanes uu = lanes_dot(u, u);
    *speed = lanes_sqrt(uu);
    return ((uu < 0x1p-900) | (uu > 0x1p1000)) & ((u[0] != 0.0) | (u[1] != 0.0) | (u[2] != 0.0));
}

/** Translation of bodies of these lanes. Returns 0, and nothing has changed, where some speed is out of range. */
VTI_INLINE int slow_lanes(enum touch_layout layout, const vti_drag *p, const vti_bodies *b, double t,
                          const struct side *i, lanes *lost)
{
    const lanes m = scalars(&b->mass, i), c = value_of(&p->linear, i);
    struct vti_decay e;
    lanes v[3];
    gather(layout, &b->v, i, v);
    if (p->quadratic.p == NULL)
        e = vti_drag_decay_linear(c, m, t);
    else {
        const lanes u[3] = {v[0] - p->medium[0], v[1] - p->medium[1], v[2] - p->medium[2]};
        lanes speed;
        if (lanes_bits(speed_of(u, &speed)) != 0)
            return 0;
        e = vti_drag_decay(c, value_of(&p->quadratic, i), speed, m, t);
    }
    *lost = vti_drag_slow(&e, p->medium, m, v);
    scatter(layout, &b->v, i, v);
    return 1;
}

VTI_INLINE int slow_turning_lanes(enum touch_layout layout, const vti_drag *p, const vti_bodies *b, double t,
                                  const struct side *i, lanes *lost)
{
    static const double still[3] = {0.0, 0.0, 0.0};
    const lanes j = scalars(&b->inertia, i);
    const struct vti_decay e = vti_drag_decay_linear(scalars(&p->angular, i), j, t);
    lanes w[3];
    gather(layout, &b->omega, i, w);
    *lost = vti_drag_slow(&e, still, j, w);
    scatter(layout, &b->omega, i, w);
    return 1;
}

static int64_t drag(const vti_drag *p, const vti_bodies *b, double t, int book, int64_t begin, int64_t end)
{
    const int packed = is_packed(b);
    const lanes none = lanes_of(0.0);
    struct books books;
    int64_t i = begin, done = 1;
    books_open(&books, p->lost, VTI_DRAG_BOOKS);
    for (; done && i < end; i += done ? WIDTH : 0) {
        lanes lost[BOOKS] = {none, none, none, none};
        int64_t body[WIDTH];
        struct side side;
        for (int l = 0; l < WIDTH; ++l)
            body[l] = i + l < end ? i + l : end - 1;
        side_of(body, &side);
        done = book == 0 ? BY_LAYOUT(packed, slow_lanes, p, b, t, &side, lost)
                         : BY_LAYOUT(packed, slow_turning_lanes, p, b, t, &side, lost + 1);
        if (done)
            book_lanes(&books, lost, end - i);
    }
    books_close(&books, p->lost, VTI_DRAG_BOOKS);
    return i < end ? i : end;
}

#endif
