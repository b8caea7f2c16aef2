/* SPDX-License-Identifier: BSD-3-Clause
 * Hertzian contact of many pairs, and of many bodies at a wall, at once (EQUATIONS 3, E4). Included by
 * vti_touch_kernels.h only. */
#ifndef VTI_PRESS_KERNELS_H
#define VTI_PRESS_KERNELS_H

#include "vti_hertz.h"
#include "vti_near_kernels.h"

VTI_HERTZ_FORCE(hertz_force, lanes, lanes_sqrt)

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** F_i = (K/L) o^{3/2} n with o = [1 - r/L]_+ of so many pairs from the first on, WIDTH at most, into force[3 WIDTH].
 *  Returns those that touch, as bits; one with a number that is NaN is among them, so that it shows. */
VTI_INLINE unsigned press_lanes(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b, int64_t first,
                                int64_t count, double *force)
{
    struct side i, j;
    lanes d[3];
    int64_t which[WIDTH], to[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        which[l] = first + (l < count ? l : count - 1);
    sides_of(p->pair, p->base, which, &i, &j);
    gather_difference(layout, &b->x, &i, &j, d);
    const lanes length = gather_length(p, which, scalars(&p->diameter, &i), scalars(&p->diameter, &j)),
                r2 = lanes_dot(d, d);
    const unsigned apart = lanes_bits(r2 >= length * length), all = (1u << WIDTH) - 1;
    if (apart == all)
        return 0;
    const lanes r = lanes_sqrt(r2), per_r = lanes_where(r > VTI_COINCIDENT, 1.0 / r, lanes_of(0.0)),
                f = hertz_force(gather_stiffness(p, &i, &j, length), length, 1.0 - r / length) * per_r;
    for (int k = 0; k < 3; ++k)
        d[k] *= f;
    lanes_strided(3, to);
    lanes_untriple(force, to, d);
    return all & ~apart;
}

/** F_j = -F_i; to bodies of the slice. */
VTI_INLINE void add_both(enum touch_layout layout, const vti_bodies *b, int64_t i, int64_t j, const double force[3])
{
    const double back[3] = {-force[0], -force[1], -force[2]};
    if (vti_owns(b, i))
        add_row(layout, &b->force, i, force);
    if (vti_owns(b, j))
        add_row(layout, &b->force, j, back);
}

/** Of so many pairs, VTI_TOUCHES at most, all forces before the first is added: roots and divisions of different lanes
 *  do not wait for each other. */
VTI_INLINE void press_some(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b, int64_t first,
                           int64_t count)
{
    double force[3 * VTI_TOUCHES];
    const int64_t even = count - count % WIDTH;
    uint64_t touches = 0;
    for (int64_t n = 0; n < even; n += WIDTH)
        touches |= (uint64_t)press_lanes(layout, p, b, first + n, WIDTH, force + 3 * n) << n;
    if (even < count)
        touches |= (uint64_t)press_lanes(layout, p, b, first + even, count - even, force + 3 * even) << even;
    touches &= ~UINT64_C(0) >> (VTI_TOUCHES - count);
    for (; touches != 0; touches &= touches - 1) {
        const int64_t n = vti_first_bit(touches), k = first + n;
        add_both(layout, b, vti_contact_body(p, k, 0), vti_contact_body(p, k, 1), force + 3 * n);
    }
}

VTI_INLINE void press_list(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b)
{
    for (int64_t first = 0; first < p->count; first += VTI_TOUCHES) {
        const int64_t left = p->count - first;
        press_some(layout, p, b, first, left < VTI_TOUCHES ? left : VTI_TOUCHES);
    }
}

static void press_pairs(const vti_contacts *p, const vti_bodies *b)
{
    if (!vti_is_packed(&b->x) || !vti_is_packed(&b->force)) {
        press_list(ANY, p, b);
        return;
    }
    if (!are_alike(p)) {
        press_list(PACKED, p, b);
        return;
    }
    const vti_contacts alike = alike_of(p);
    press_list(PACKED, &alike, b);
}

/* ---- bodies at a wall -------------------------------------------------------------------------------------------- */

/** F = (K/(D/2)) o^{3/2} N of wall w, o = [1 - g/(D/2)]_+, on so many bodies in a row, packed ones WIDTH. */
VTI_INLINE void press_row(enum touch_layout layout, const vti_walls *p, const vti_bodies *b, int64_t w, int64_t first,
                          int64_t count)
{
    struct side i;
    lanes x[3], n[3];
    int64_t to[WIDTH];
    double force[3 * WIDTH];
    gather_row(layout, &b->x, first, count, &i, x);
    const lanes radius = 0.5 * scalars(&p->diameter, &i), gap = vti_face_gap(p, w, x, n);
    const unsigned apart = lanes_bits(gap >= radius), all = (1u << WIDTH) - 1; /* exactly where no overlap is > 0 */
    if (apart == all)
        return;
    const lanes f = hertz_force(gather_stiffness_at(p, w, &i, radius), radius, 1.0 - gap / radius);
    for (int k = 0; k < 3; ++k)
        n[k] *= f;
    lanes_strided(3, to);
    lanes_untriple(force, to, n);
    for (int l = 0; l < WIDTH && l < count; ++l)
        if (!(apart >> l & 1))
            add_row(layout, &b->force, first + l, force + 3 * l);
}

VTI_INLINE void press_rows(enum touch_layout layout, const vti_walls *p, const vti_bodies *b, int64_t w, int64_t first,
                           int64_t count)
{
    const int64_t even = layout == PACKED ? count - count % WIDTH : 0;
    for (int64_t k = 0; k < even; k += WIDTH)
        press_row(layout, p, b, w, first + k, WIDTH);
    for (int64_t k = even; k < count; k += WIDTH)
        press_row(ANY, p, b, w, first + k, count - k);
}

static void press_at_wall(const vti_walls *p, const vti_bodies *b, int64_t w, int64_t first, int64_t count)
{
    if (!vti_is_packed(&b->x) || !vti_is_packed(&b->force)) {
        press_rows(ANY, p, b, w, first, count);
        return;
    }
    if (p->diameter.stride != 0 || p->modulus.p != NULL) {
        press_rows(PACKED, p, b, w, first, count);
        return;
    }
    vti_walls alike = *p;
    alike.diameter = vti_scalars_one(p->diameter.p);
    alike.modulus.p = NULL;
    press_rows(PACKED, &alike, b, w, first, count);
}

#endif
