/* SPDX-License-Identifier: BSD-3-Clause
 * Hertzian contact of many pairs at once (EQUATIONS 3, E4). Included by vti_touch_kernels.h only. */
#ifndef VTI_PRESS_KERNELS_H
#define VTI_PRESS_KERNELS_H

#include "vti_hertz.h"
#include "vti_touch_gather.h"

VTI_HERTZ_FORCE(hertz_force, lanes, lanes_sqrt)

/** F_i = (K/L) o^{3/2} n with o = [1 - r/L]_+ of these pairs, into force[3 WIDTH]. Returns those that touch, as bits; one
 *  with a number that is NaN is among them, so that it shows. */
VTI_INLINE unsigned press_lanes(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b,
                                const int64_t *which, double *force)
{
    struct side i, j;
    lanes d[3];
    int64_t to[WIDTH];
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
    int64_t which[WIDTH];
    uint64_t touches = 0;
    for (int64_t n = 0; n < count; n += WIDTH) {
        for (int l = 0; l < WIDTH; ++l)
            which[l] = first + (n + l < count ? n + l : count - 1);
        touches |= (uint64_t)press_lanes(layout, p, b, which, force + 3 * n) << n;
    }
    touches &= ~UINT64_C(0) >> (VTI_TOUCHES - count);
    for (int64_t k = first; touches != 0; ++k, touches >>= 1)
        if (touches & 1)
            add_both(layout, b, vti_contact_body(p, k, 0), vti_contact_body(p, k, 1), force + 3 * (k - first));
}

static void press_pairs(const vti_contacts *p, const vti_bodies *b)
{
    const int packed = vti_is_packed(&b->x) && vti_is_packed(&b->force);
    for (int64_t first = 0; first < p->count; first += VTI_TOUCHES) {
        const int64_t left = p->count - first;
        BY_LAYOUT(packed, press_some, p, b, first, left < VTI_TOUCHES ? left : VTI_TOUCHES);
    }
}

#endif
