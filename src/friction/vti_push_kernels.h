/* SPDX-License-Identifier: BSD-3-Clause
 * Vector kernels that add the springs' forces and moments to the bodies. Included by vti_touch_kernels.h only. */
#ifndef VTI_PUSH_KERNELS_H
#define VTI_PUSH_KERNELS_H

#include "../contacts/vti_touch_gather.h"

/** To body i, if it is of the slice. */
VTI_INLINE void add_loads(enum touch_layout layout, const vti_bodies *b, int64_t i, const double force[3],
                          const double moment[3])
{
    if (!vti_owns(b, i))
        return;
    if (vti_has(&b->force))
        add_row(layout, &b->force, i, force);
    if (vti_has(&b->moment))
        add_row(layout, &b->moment, i, moment);
}

/** F_i -= f, F_j += f, T_i += s_i d x f, T_j += s_j d x f of sliding, T_i -= f, T_j += f of rolling, and of twisting
 *  with f n; nothing where they do not touch. */
VTI_INLINE void push_lanes(enum touch_layout layout, const vti_friction *p, const vti_bodies *b, const int64_t *which,
                           const vti_held *from, const int64_t place[WIDTH], int64_t count)
{
    enum { F_I, F_J, T_I, T_J, ROWS };
    struct vti_touch at;
    struct vti_loads f;
    struct side i, j;
    lanes across[3], act[ROWS][3];
    double row[ROWS][3 * WIDTH];
    int64_t to[WIDTH];
    gather_touches(layout, p->contacts, b, which, &at, &i, &j);
    gather_loads(p, from, place, &f);
    lanes_cross(at.n, f.sliding, across);
    for (int k = 0; k < 3; ++k) {
        const lanes moment = f.rolling[k] + f.twisting * at.n[k];
        act[F_I][k] = -f.sliding[k];
        act[F_J][k] = f.sliding[k];
        act[T_I][k] = at.s_i * at.r * across[k] - moment;
        act[T_J][k] = at.s_j * at.r * across[k] + moment;
    }
    const lanes_mask touches = (at.delta >= 0.0) & (at.r > VTI_COINCIDENT);
    for (int k = 0; k < ROWS && !lanes_all(touches); ++k)
        for (int c = 0; c < 3; ++c)
            act[k][c] = lanes_where(touches, act[k][c], lanes_of(0.0));
    lanes_strided(3, to);
    for (int k = 0; k < ROWS; ++k)
        lanes_untriple(row[k], to, act[k]);
    for (int l = 0; l < WIDTH && l < count; ++l) {
        add_loads(layout, b, i.body[l], row[F_I] + 3 * l, row[T_I] + 3 * l);
        add_loads(layout, b, j.body[l], row[F_J] + 3 * l, row[T_J] + 3 * l);
    }
}

static int is_loaded_packed(const vti_bodies *b)
{
    return is_packed(b) && (!vti_has(&b->force) || vti_is_packed(&b->force)) &&
           (!vti_has(&b->moment) || vti_is_packed(&b->moment));
}

static void push_springs(const vti_friction *p, const vti_bodies *b, int64_t count, const int64_t *which,
                         vti_held *const *held)
{
    const int packed = is_loaded_packed(b);
    int64_t place[WIDTH], at[WIDTH];
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const pairs = whole(which, first, count, place);
        whole_places(held[0], held, first, count, at);
        BY_LAYOUT(packed, push_lanes, p, b, pairs, held[0], at, count - first);
    }
}

/** The same on bodies at wall w. */
VTI_INLINE void push_lanes_at_wall(enum touch_layout layout, const vti_friction *p, const vti_bodies *b, int64_t w,
                                   const int64_t *body, const vti_held *from, const int64_t place[WIDTH], int64_t count)
{
    struct vti_touch at;
    struct vti_loads f;
    struct side i;
    lanes x[3], across[3], force[3], moment[3];
    double row[2][3 * WIDTH];
    int64_t to[WIDTH];
    side_of(body, &i);
    gather(layout, &b->x, &i, x);
    vti_face_touch(&at, p->walls, w, x, 0.5 * scalars(&p->walls->diameter, &i));
    gather_loads(p, from, place, &f);
    lanes_cross(at.n, f.sliding, across);
    const lanes_mask touches = vti_face_near(&at, 0.0);
    for (int k = 0; k < 3; ++k) {
        const lanes turning = at.r * across[k] - (f.rolling[k] + f.twisting * at.n[k]);
        force[k] = lanes_where(touches, -f.sliding[k], lanes_of(0.0));
        moment[k] = lanes_where(touches, turning, lanes_of(0.0));
    }
    lanes_strided(3, to);
    lanes_untriple(row[0], to, force);
    lanes_untriple(row[1], to, moment);
    for (int l = 0; l < WIDTH && l < count; ++l)
        add_loads(layout, b, i.body[l], row[0] + 3 * l, row[1] + 3 * l);
}

static void push_springs_at_wall(const vti_friction *p, const vti_bodies *b, int64_t w, int64_t count,
                                 const int64_t *body, vti_held *const *held)
{
    const int packed = is_loaded_packed(b);
    int64_t place[WIDTH], at[WIDTH];
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const bodies = whole(body, first, count, place);
        whole_places(held[0], held, first, count, at);
        BY_LAYOUT(packed, push_lanes_at_wall, p, b, w, bodies, held[0], at, count - first);
    }
}

#endif
