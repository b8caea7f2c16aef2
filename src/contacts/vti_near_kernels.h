/* SPDX-License-Identifier: BSD-3-Clause
 * Which pairs of a list are near each other, and which bodies near a wall, many at once. Included by
 * vti_touch_kernels.h only. */
#ifndef VTI_NEAR_KERNELS_H
#define VTI_NEAR_KERNELS_H

#include "vti_touch_gather.h"

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** Of so many pairs from the first on, WIDTH at most. */
VTI_INLINE int64_t near_lanes(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b, double reach,
                              int64_t first, int64_t count, int64_t *which)
{
    int64_t all[WIDTH], found = 0;
    struct side i, j;
    lanes d[3];
    for (int l = 0; l < WIDTH; ++l)
        all[l] = first + (l < count ? l : count - 1);
    sides_of(p->pair, p->base, all, &i, &j);
    gather_difference(layout, &b->x, &i, &j, d);
    const lanes length = gather_length(p, all, scalars(&p->diameter, &i), scalars(&p->diameter, &j)),
                far = length + reach, r2 = lanes_dot(d, d);
    int64_t is_near[WIDTH], touches[WIDTH];
    lanes_told((r2 <= far * far) & (r2 > VTI_COINCIDENT * VTI_COINCIDENT), is_near);
    lanes_told(r2 < length * length, touches);
    for (int l = 0; l < WIDTH && l < count; ++l) { /* what is not near is written over */
        if (which != NULL)
            which[found] = (-1 - (first + l)) ^ touches[l]; /* of -1 - k all bits are those of k turned over */
        found -= is_near[l];
    }
    return found;
}

VTI_INLINE int64_t near_list(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b, double reach,
                             int64_t first, int64_t count, int64_t *which)
{
    const int64_t even = layout == PACKED ? count - count % WIDTH : 0;
    int64_t found = 0;
    for (int64_t n = 0; n < even; n += WIDTH)
        found += near_lanes(layout, p, b, reach, first + n, WIDTH, which != NULL ? which + found : NULL);
    for (int64_t n = even; n < count; n += WIDTH)
        found += near_lanes(ANY, p, b, reach, first + n, count - n, which != NULL ? which + found : NULL);
    return found;
}

static int64_t near_pairs(const vti_contacts *p, const vti_bodies *b, double reach, int64_t first, int64_t count,
                          int64_t *which)
{
    if (!vti_is_packed(&b->x))
        return near_list(ANY, p, b, reach, first, count, which);
    if (!are_alike(p))
        return near_list(PACKED, p, b, reach, first, count, which);
    const vti_contacts alike = alike_of(p);
    return near_list(PACKED, &alike, b, reach, first, count, which);
}

/* ---- bodies at a wall -------------------------------------------------------------------------------------------- */

/** So many bodies in a row, packed ones WIDTH, and their vectors of a view: where they are. */
VTI_INLINE void gather_row(enum touch_layout layout, const vti_view *view, int64_t first, int64_t count, struct side *i,
                           lanes x[3])
{
    int64_t body[WIDTH];
    lanes row[3];
    for (int l = 0; l < WIDTH; ++l)
        body[l] = first + (l < count ? l : count - 1);
    side_of(body, i);
    if (layout == PACKED) {
        for (int k = 0; k < 3; ++k)
            row[k] = lanes_load(view->c[0] + 3 * first + k * WIDTH);
        lanes_split(row, x);
    } else
        gather(layout, view, i, x);
}

/** Of so many in a row. The way of the drift, and of the wall over it, is twice as long here, and a little more, as
 *  places before it are not known to the last digit. */
VTI_INLINE unsigned near_row(enum touch_layout layout, const vti_walls *p, const vti_bodies *b, double reach, double h,
                             int64_t w, int64_t first, int64_t count)
{
    struct vti_touch at;
    struct side i;
    lanes x[3], v[3], way[3];
    gather_row(layout, &b->x, first, count, &i, x);
    vti_face_touch(&at, p, w, x, 0.5 * scalars(&p->diameter, &i));
    if (!(h > 0.0))
        return lanes_bits(at.delta >= -reach);
    gather(layout, &b->v, &i, v);
    for (int k = 0; k < 3; ++k)
        way[k] = h * (lanes_abs(v[k]) + (p->motion != NULL ? fabs(p->motion[w].velocity[k]) : 0.0));
    const lanes far = lanes_sqrt(lanes_dot(way, way));
    return lanes_bits(at.delta + 2.0 * far + 1e-6 * at.length >= -reach);
}

VTI_INLINE uint64_t near_rows(enum touch_layout layout, const vti_walls *p, const vti_bodies *b, double reach, double h,
                              int64_t w, int64_t first, int64_t count)
{
    const int64_t even = layout == PACKED ? count - count % WIDTH : 0;
    uint64_t bits = 0;
    for (int64_t k = 0; k < even; k += WIDTH)
        bits |= (uint64_t)near_row(layout, p, b, reach, h, w, first + k, WIDTH) << k;
    for (int64_t k = even; k < count; k += WIDTH)
        bits |= (uint64_t)near_row(ANY, p, b, reach, h, w, first + k, count - k) << k;
    return bits & ~UINT64_C(0) >> (64 - count);
}

static uint64_t near_wall(const vti_walls *list, const vti_bodies *b, double reach, double h, int64_t w, int64_t first,
                          int64_t count)
{
    if (!vti_is_packed(&b->x) || (h > 0.0 && !vti_is_packed(&b->v)))
        return near_rows(ANY, list, b, reach, h, w, first, count);
    if (h > 0.0 || list->diameter.stride != 0)
        return near_rows(PACKED, list, b, reach, h, w, first, count);
    vti_walls alike = *list;
    alike.diameter = vti_scalars_one(list->diameter.p);
    return near_rows(PACKED, &alike, b, reach, 0.0, w, first, count);
}

#endif
