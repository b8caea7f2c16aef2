/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One touch (vti_touch_motion.h) of bodies as they are: where it is, and the velocities there. */
#ifndef VTI_TOUCH_H
#define VTI_TOUCH_H

#include "vti_face.h"
#include "vti_hertz.h"
#include "vti_touch_motion.h"

/** What the bodies of a pair have: 1/m and, where bodies turn, 1/J. */
static inline void vti_touch_masses(struct vti_touch *at, const vti_bodies *b)
{
    const int turns = vti_has(&b->omega);
    at->per_m_i = 1.0 / vti_scalar(&b->mass, at->i);
    at->per_m_j = 1.0 / vti_scalar(&b->mass, at->j);
    at->per_j_i = turns ? 1.0 / vti_scalar(&b->inertia, at->i) : 0.0;
    at->per_j_j = turns ? 1.0 / vti_scalar(&b->inertia, at->j) : 0.0;
}

/** The bodies of pair k of a list that counts from base, and d = x_i - x_j. */
VTI_INLINE void vti_touch_apart(struct vti_touch *at, const int64_t *pair, int64_t base, const vti_bodies *b, int64_t k,
                                double d[3])
{
    double xj[3];
    at->moves = 0;
    at->i = pair[2 * k] - base;
    at->j = pair[2 * k + 1] - base;
    vti_load(&b->x, at->i, d);
    vti_load(&b->x, at->j, xj);
    for (int c = 0; c < 3; ++c)
        d[c] -= xj[c];
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

/** The velocities of a pair. */
static inline void vti_touch_load(const struct vti_touch *at, const vti_bodies *b, struct vti_touch_motion *m)
{
    static const struct vti_touch_motion still;
    *m = still;
    m->turns = vti_has(&b->omega);
    vti_load(&b->v, at->i, m->v_i);
    vti_load(&b->v, at->j, m->v_j);
    if (!m->turns)
        return;
    vti_load(&b->omega, at->i, m->w_i);
    vti_load(&b->omega, at->j, m->w_j);
}

static inline void vti_touch_store(const struct vti_touch *at, const vti_bodies *b, const struct vti_touch_motion *m)
{
    vti_store(&b->v, at->i, m->v_i);
    vti_store(&b->v, at->j, m->v_j);
    if (!m->turns)
        return;
    vti_store(&b->omega, at->i, m->w_i);
    vti_store(&b->omega, at->j, m->w_j);
}

#endif
