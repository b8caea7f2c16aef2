/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the springs of one touch do in a drift, by the formulas for one lane: what kernels of many have to agree
 * with. */
#ifndef VTI_TESTS_TOUCH_ALONE_H
#define VTI_TESTS_TOUCH_ALONE_H

#include "support.h"

#include "../../src/contacts/vti_touch.h"
#include "../../src/friction/vti_carry.h"

/** What the bodies of a pair have: 1/m and, where bodies turn, 1/J. */
static inline void touch_masses(struct vti_touch *at, const vti_bodies *b)
{
    const int turns = vti_has(&b->omega);
    at->per_m_i = 1.0 / vti_scalar(&b->mass, at->i);
    at->per_m_j = 1.0 / vti_scalar(&b->mass, at->j);
    at->per_j_i = turns ? 1.0 / vti_scalar(&b->inertia, at->i) : 0.0;
    at->per_j_j = turns ? 1.0 / vti_scalar(&b->inertia, at->j) : 0.0;
}

/** The velocities of a pair. */
static inline void touch_load(const struct vti_touch *at, const vti_bodies *b, struct vti_touch_motion *m)
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

static inline void touch_store(const struct vti_touch *at, const vti_bodies *b, const struct vti_touch_motion *m)
{
    vti_store(&b->v, at->i, m->v_i);
    vti_store(&b->v, at->j, m->v_j);
    if (!m->turns)
        return;
    vti_store(&b->omega, at->i, m->w_i);
    vti_store(&b->omega, at->j, m->w_j);
}

/** All springs of one touch, and what they take. */
static inline void hold_on(const vti_friction *p, const struct vti_carry *c, double mu, vti_held *held)
{
    const double coefficient[VTI_FRICTION_BOOKS] = {p->sliding, p->rolling, p->twisting};
    struct vti_loads loads = {.twisting = held->twisting};
    struct vti_taken taken;
    memcpy(loads.sliding, held->sliding, sizeof loads.sliding);
    memcpy(loads.rolling, held->rolling, sizeof loads.rolling);
    vti_carry_loads(p, c, mu, &loads, &taken);
    memcpy(held->sliding, loads.sliding, sizeof loads.sliding);
    memcpy(held->rolling, loads.rolling, sizeof loads.rolling);
    held->twisting = loads.twisting;
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) {
        if (coefficient[k] > 0.0)
            vti_sum_add(&p->lost[k], taken.lost[k]);
    }
    if (c->touch.j < 0 && c->touch.moves)
        vti_sum_add(p->walls->work, taken.worked[0] + taken.worked[1] + taken.worked[2]);
}

/** The increments of attitude of a body and of what it touches, by the law. */
static inline void turn_both(const vti_drifted *drifted, const double w_i[3], const double w_j[3], double a_i[3],
                             double a_j[3])
{
    vti_drift_increment((int)drifted->law, drifted->t, w_i, a_i);
    vti_drift_increment((int)drifted->law, drifted->t, w_j, a_j);
}

/** What one pair has been through. */
static inline void go_along(struct vti_carry *c, const vti_bodies *b, const vti_drifted *drifted)
{
    struct vti_touch_motion m;
    double d0[3], a_i[3], a_j[3];
    touch_load(&c->touch, b, &m);
    for (int k = 0; k < 3; ++k)
        c->slid[k] = drifted->t * (m.v_i[k] - m.v_j[k]);
    turn_both(drifted, m.w_i, m.w_j, a_i, a_j);
    vti_carry_apart(c, c->slid, d0);
    vti_carry_stretch(c, d0, a_i, a_j);
}

/** What one body at a wall has. */
static inline void go_along_wall(struct vti_carry *c, const vti_walls *walls, const vti_bodies *b,
                                 const vti_drifted *drifted)
{
    double x[3], v[3], w[3], d0[3], a_i[3], a_j[3];
    vti_load(&b->x, c->touch.i, x);
    vti_load(&b->v, c->touch.i, v);
    vti_load(&b->omega, c->touch.i, w);
    turn_both(drifted, w, c->touch.w_j, a_i, a_j);
    for (int k = 0; k < 3 && c->touch.wall < walls->count; ++k) {
        a_i[k] = drifted->t * w[k];
        a_j[k] = drifted->t * c->touch.w_j[k];
    }
    vti_carry_at_wall(c, walls, drifted->t, x, v, a_j, d0);
    vti_carry_stretch(c, d0, a_i, a_j);
}

#endif
