/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of many bonds, no two of which share a body, at once (EQUATIONS 6.3), with u and w of vti_touch_motion.h for
 * shares of 1/2:
 *
 *     axial p = m_n expm1(-c_a t/m_n) (u.n) n             shear p = m_t expm1(-c_s t/m_t) P u
 *     bending l = J_r expm1(-c_b t/J_r) P w               twisting l = J_r expm1(-c_w t/J_r) (w.n) n
 *
 * Included by vti_touch_kernels.h only. */
#ifndef VTI_BOND_KERNELS_H
#define VTI_BOND_KERNELS_H

#include "vti_bond_flow.h"
#include "vti_decay.h"
#include "../contacts/vti_touch_gather.h"

enum { BOND_MOTIONS = VTI_BOND_DASHPOT_BOOKS };

/** Bonds where they are. */
struct bond_place {
    struct vti_touch touch;
    struct vti_touch_motion motion;
    int damped[BOND_MOTIONS];
    lanes mass[BOND_MOTIONS]; /* m_n, m_t, J_r, J_r */
    lanes gone[BOND_MOTIONS]; /* the share of the velocity that goes */
    lanes lost[BOND_MOTIONS]; /* of energy */
};

/** Those that coincide have no direction: n = 0, and nothing goes. */
VTI_INLINE lanes_mask gather_bonds(enum touch_layout layout, const vti_bonds *p, const vti_bodies *b,
                                   const int64_t *which, struct side *i, struct side *j, struct vti_touch *at)
{
    lanes d[3];
    sides_of(p->pair, p->base, which, i, j);
    gather_difference(layout, &b->x, i, j, d);
    at->i = at->j = 0;
    at->moves = 0;
    at->r = lanes_sqrt(lanes_dot(d, d));
    const lanes per_r = 1.0 / at->r;
    const lanes_mask apart = at->r > VTI_COINCIDENT;
    for (int c = 0; c < 3; ++c)
        at->n[c] = lanes_where(apart, d[c] * per_r, lanes_of(0.0));
    at->s_i = at->s_j = lanes_of(0.5);
    return apart;
}

/** An array of the bonds, or the number that all have. */
VTI_INLINE lanes of_bonds(const double *p, int64_t stride, const int64_t *which)
{
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = which[l] * stride;
    return lanes_gather(p, at);
}

/** Of all motions. */
VTI_INLINE void find_bond_decays(const struct vti_bond_sweep *s, const int64_t *which, lanes_mask apart,
                                 struct bond_place *at)
{
    const vti_bond_dashpots *const p = s->p;
    const lanes rest = of_bonds(p->bonds->rest + 3, 4, which), one = lanes_of(1.0), zero = lanes_of(0.0),
                per[BOND_MOTIONS] = {vti_touch_per_normal(&at->touch), vti_touch_per_tangential(&at->touch),
                                     vti_touch_per_rolling(&at->touch), vti_touch_per_rolling(&at->touch)};
    struct vti_decay d[BOND_MOTIONS];
    lanes z[BOND_MOTIONS];
    for (int k = 0; k < BOND_MOTIONS; ++k) {
        const vti_scalars *const stiffness = vti_bond_stiffness(p, k);
        const int has = p->zeta > 0.0 && stiffness->p != NULL;
        at->damped[k] = (has || vti_bond_constant(p, k) > 0.0) && (at->motion.turns || !vti_bond_turns(k));
        at->mass[k] = at->damped[k] ? 1.0 / per[k] : zero;
        const lanes energy = has ? of_bonds(stiffness->p, stiffness->stride, which) : zero;
        z[k] = vti_bond_coefficient(p, k, at->mass[k], energy, vti_bond_turns(k) ? one : rest) * s->t * per[k];
    }
    vti_decays(BOND_MOTIONS, z, d);
    for (int k = 0; k < BOND_MOTIONS; ++k)
        at->gone[k] = lanes_where(apart, d[k].gone, zero);
}

VTI_INLINE void flow_bond(int motion, struct bond_place *at)
{
    lanes a[3], along[3];
    if (!at->damped[motion])
        return;
    if (vti_bond_turns(motion))
        vti_touch_roll(&at->motion, a);
    else
        vti_touch_slip(&at->touch, &at->motion, a);
    vti_touch_split(at->touch.n, a, along);
    if (motion == VTI_AXIAL) {
        const lanes un = lanes_dot(along, at->touch.n), gone = at->gone[VTI_AXIAL], mass = at->mass[VTI_AXIAL];
        at->lost[VTI_AXIAL] = mass * gone * (1.0 - 0.5 * gone) * un * un;
        vti_touch_press(&at->touch, -mass * gone * un, &at->motion);
        return;
    }
    lanes *const damped = motion == VTI_TWIST ? along : a;
    at->lost[motion] = vti_touch_decay(at->mass[motion], at->gone[motion], damped);
    if (vti_bond_turns(motion))
        vti_touch_turn(&at->touch, damped, &at->motion);
    else
        vti_touch_push(&at->touch, damped, &at->motion);
}

VTI_INLINE void flow_bond_lanes(enum touch_layout layout, const struct vti_bond_sweep *s, const int64_t *which,
                                int64_t count, struct books *books)
{
    struct bond_place at;
    struct side i, j;
    const lanes_mask apart = gather_bonds(layout, s->p->bonds, s->b, which, &i, &j, &at.touch);
    gather_velocities(layout, s->b, &i, &j, &at.touch, &at.motion);
    find_bond_decays(s, which, apart, &at);
    for (int k = 0; k < BOND_MOTIONS; ++k)
        at.lost[k] = lanes_of(0.0);
    if (s->drift < 0.0) {
        flow_bond(VTI_TWIST, &at);
        flow_bond(VTI_BENDING, &at);
        flow_bond(VTI_SHEAR, &at);
    }
    flow_bond(VTI_AXIAL, &at);
    if (!(s->drift < 0.0)) {
        flow_bond(VTI_SHEAR, &at);
        flow_bond(VTI_BENDING, &at);
        flow_bond(VTI_TWIST, &at);
    }
    scatter_velocities(layout, s->b, &i, &j, &at.motion);
    book_lanes(books, at.lost, count);
}

static void flow_bonds(const struct vti_bond_sweep *s, int64_t count, const int64_t *which)
{
    const int packed = is_packed(s->b);
    int64_t place[WIDTH];
    struct books books;
    books_open(&books, s->p->lost, BOND_MOTIONS);
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int64_t *const here = whole(which, first, count, place);
        BY_LAYOUT(packed, flow_bond_lanes, s, here, count - first, &books);
    }
    books_close(&books, s->p->lost, BOND_MOTIONS);
}

#endif
