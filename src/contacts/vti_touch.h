/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Builds the geometry of one touching pair, or of a body at a wall, from the positions (struct vti_touch of
 * vti_touch_motion.h). */
#ifndef VTI_TOUCH_H
#define VTI_TOUCH_H

#include "vti_face.h"
#include "vti_hertz.h"
#include "vti_touch_motion.h"

/** The bodies of pair k of a list that counts from base, and d = x_i - x_j. */
VTI_INLINE void vti_touch_apart(struct vti_touch *at, const int64_t *pair, int64_t base, const vti_bodies *b, int64_t k,
                                double d[3])
{
    at->moves = 0;
    at->i = pair[2 * k] - base;
    at->j = pair[2 * k + 1] - base;
    (void)vti_difference(&b->x, at->i, at->j, d);
}

/** Of pair k of the list. Returns 1, or 0 where centres coincide, so that there is no direction, or the gap is above
 *  reach. */
static inline int vti_touch_pair(struct vti_touch *at, const vti_contacts *p, const vti_bodies *b, int64_t k,
                                 double reach)
{
    double d[3];
    vti_touch_apart(at, p->pair, p->base, b, k, d);
    const double di = vti_scalar(&p->diameter, at->i), dj = vti_scalar(&p->diameter, at->j);
    at->length = vti_contact_length(p, k, at->i, at->j);
    const double far = at->length + reach, r2 = vti_dot(d, d);
    if (!(r2 <= far * far))
        return 0;
    vti_touch_between(at, d, di / (di + dj));
    at->stiffness = vti_contact_stiffness(p, at->i, at->j, at->length);
    return at->r > VTI_COINCIDENT;
}

/** Of body i and wall w, where they are now. Returns 1, or 0 where the gap is above reach, or there is no direction. */
static inline int vti_touch_wall(struct vti_touch *at, const vti_walls *p, const vti_bodies *b, int64_t w, int64_t i,
                                 double reach)
{
    double x[3];
    vti_load(&b->x, i, x);
    vti_face_touch(at, p, w, x, 0.5 * vti_scalar(&p->diameter, i));
    if (!vti_face_near(at, reach))
        return 0;
    at->i = i;
    at->stiffness = vti_face_stiffness(p, w, i, at->length);
    vti_face_move(at, p, x);
    return 1;
}

#endif
