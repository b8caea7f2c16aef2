/* SPDX-License-Identifier: BSD-3-Clause
 * Which contacts begin or end within a step, found for many at once: few do. Included by vti_touch_kernels.h only. */
#ifndef VTI_ONSET_KERNELS_H
#define VTI_ONSET_KERNELS_H

#include "vti_near_kernels.h"

/** Where one of two overlaps, before and after the step, is a touch, and the other is not. */
VTI_INLINE lanes_mask differ(lanes before, lanes after)
{
    return (before > 0.0) != (after > 0.0);
}

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** Of so many pairs from the first on, WIDTH at most, those that begin or end to touch, as bits. */
VTI_INLINE unsigned cross_lanes(enum touch_layout layout, const vti_contacts *p, const vti_view *before,
                                const vti_bodies *b, int64_t first, int64_t count)
{
    struct side i, j;
    lanes was[3], is[3];
    int64_t which[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        which[l] = first + (l < count ? l : count - 1);
    sides_of(p->pair, p->base, which, &i, &j);
    gather_difference(layout, before, &i, &j, was);
    gather_difference(layout, &b->x, &i, &j, is);
    const lanes length = gather_length(p, which, scalars(&p->diameter, &i), scalars(&p->diameter, &j)),
                square = length * length, from = lanes_dot(was, was), to = lanes_dot(is, is);
    if (lanes_all((from >= square) & (to >= square)))
        return 0;
    const lanes touching = length * VTI_JUST_TOUCHING;
    return lanes_bits(differ(touching - lanes_sqrt(from), touching - lanes_sqrt(to)));
}

VTI_INLINE int64_t crossing_list(enum touch_layout layout, const vti_contacts *p, const vti_view *before,
                                 const vti_bodies *b, int64_t first)
{
    for (int64_t k = first; k < p->count; k += WIDTH) {
        const unsigned bits = k + WIDTH <= p->count ? cross_lanes(layout, p, before, b, k, WIDTH)
                                                    : cross_lanes(ANY, p, before, b, k, p->count - k);
        if (bits != 0)
            return k + vti_first_bit(bits);
    }
    return p->count;
}

static int64_t crossing_pair(const vti_contacts *p, const vti_view *before, const vti_bodies *b, int64_t first)
{
    if (!vti_is_packed(&b->x) || !vti_is_packed(before))
        return crossing_list(ANY, p, before, b, first);
    if (!are_alike(p))
        return crossing_list(PACKED, p, before, b, first);
    const vti_contacts alike = alike_of(p);
    return crossing_list(PACKED, &alike, before, b, first);
}

/* ---- bodies at walls --------------------------------------------------------------------------------------------- */

/** Twice the square of the way. */
VTI_INLINE lanes come(const lanes from[3], const lanes to[3])
{
    lanes way[3];
    for (int k = 0; k < 3; ++k)
        way[k] = to[k] - from[k];
    return 2.0 * lanes_dot(way, way);
}

/** Of so many bodies in a row, packed ones WIDTH, those that begin or end to touch a wall, as bits. Where a wall moves
 *  they were where its velocity says. Most are farther from having just touched than they have come, which takes the
 *  gap at their place alone. */
VTI_INLINE unsigned cross_row(enum touch_layout layout, const vti_walls *p, double h, const vti_view *before,
                              const vti_bodies *b, int64_t first, int64_t count)
{
    const int64_t faces = vti_faces(p);
    struct side i;
    lanes was[3], x[3], from[3], n[3];
    unsigned bits = 0;
    gather_row(layout, before, first, count, &i, was);
    gather_row(layout, &b->x, first, count, &i, x);
    memcpy(from, was, sizeof from);
    const lanes touching = 0.5 * scalars(&p->diameter, &i) * VTI_JUST_TOUCHING;
    lanes square = come(was, x);
    for (int64_t w = 0; w < faces; ++w) {
        if (p->motion != NULL) {
            for (int k = 0; k < 3; ++k)
                from[k] = was[k] + h * p->motion[w].velocity[k];
            square = come(from, x);
        }
        const lanes overlap = touching - vti_face_gap(p, w, x, n);
        const lanes_mask far = overlap * overlap > square;
        if (!lanes_all(far))
            bits |= lanes_bits(differ(touching - vti_face_gap(p, w, from, n), overlap) & (far == 0));
    }
    return bits;
}

VTI_INLINE int64_t crossing_rows(enum touch_layout layout, const vti_walls *p, double h, const vti_view *before,
                                 const vti_bodies *b, int64_t first)
{
    const int64_t end = b->first + b->count;
    for (int64_t i = first; i < end; i += WIDTH) {
        const unsigned bits = i + WIDTH <= end ? cross_row(layout, p, h, before, b, i, WIDTH)
                                               : cross_row(ANY, p, h, before, b, i, end - i);
        if (bits != 0)
            return i + vti_first_bit(bits);
    }
    return end;
}

static int64_t crossing_body(const vti_walls *p, double h, const vti_view *before, const vti_bodies *b, int64_t first)
{
    if (!vti_is_packed(&b->x) || !vti_is_packed(before))
        return crossing_rows(ANY, p, h, before, b, first);
    if (p->diameter.stride != 0)
        return crossing_rows(PACKED, p, h, before, b, first);
    vti_walls alike = *p;
    alike.diameter = vti_scalars_one(p->diameter.p);
    return crossing_rows(PACKED, &alike, h, before, b, first);
}

#endif
