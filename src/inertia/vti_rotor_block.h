/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A block of bodies with three moments, one to a lane: loaded from any layout, kicked, and turned by the drift of
 * vti_rotor.h. Included by vti_rotor_kernels.h only. */
#ifndef VTI_ROTOR_BLOCK_H
#define VTI_ROTOR_BLOCK_H

#include "vti_rotor.h"
#include "../move/vti_turn_kernels.h"

/* ---- vectors of any layout --------------------------------------------------------------------------------------- */

VTI_INLINE void load_any(struct stream s, int64_t i, lanes r[3])
{
    lanes there[3];
    int64_t at[WIDTH];
    if (order_of(s) == PACKED) {
        load(PACKED, s, i, there);
        lanes_split(there, r);
    } else if (order_of(s) >= 0)
        load(MIXED, s, i, r);
    else {
        double *const c[3] = {s.x, s.y, s.z};
        lanes_strided(s.stride, at);
        for (int k = 0; k < 3; ++k)
            r[k] = s.stride == 0 ? lanes_of(*c[k]) : lanes_gather(c[k] + i * s.stride, at);
    }
}

VTI_INLINE void store_any(struct stream s, int64_t i, const lanes r[3])
{
    lanes there[3];
    int64_t at[WIDTH];
    if (order_of(s) == PACKED) {
        lanes_join(r, there);
        store(PACKED, s, i, there);
    } else if (order_of(s) >= 0)
        store(MIXED, s, i, r);
    else {
        double *const c[3] = {s.x, s.y, s.z};
        lanes_strided(s.stride, at);
        for (int k = 0; k < 3; ++k)
            lanes_scatter(c[k] + i * s.stride, at, r[k]);
    }
}

VTI_INLINE void load_quad(const vti_quat_view *q, int64_t i, lanes r[4])
{
    int64_t at[WIDTH];
    lanes_strided(q->stride, at);
    if (quat_is_adjacent(q))
        lanes_quads(q->xyzw[0] + i * q->stride, at, r);
    else
        for (int k = 0; k < 4; ++k)
            r[k] = lanes_gather(q->xyzw[k] + i * q->stride, at);
}

VTI_INLINE void store_quad(const vti_quat_view *q, int64_t i, const lanes r[4])
{
    int64_t at[WIDTH];
    lanes_strided(q->stride, at);
    if (quat_is_adjacent(q))
        lanes_unquad(q->xyzw[0] + i * q->stride, at, r);
    else
        for (int k = 0; k < 4; ++k)
            lanes_scatter(q->xyzw[k] + i * q->stride, at, r[k]);
}

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

/** What is known of the bodies of all lanes: the attitude as a pair, L and, where it alone is shown, Omega. */
struct general {
    struct rotor_body body;
    lanes attitude[4], L[3], omega[3];
};

/** alpha/2 and 1, which is shorter to compute with than alpha and 2. */
VTI_INLINE void half_pair(const lanes alpha[3], lanes q[4])
{
    for (int k = 0; k < 3; ++k)
        q[k] = 0.5 * alpha[k];
    q[3] = lanes_of(1.0);
}

VTI_INLINE lanes half_square(const lanes half[3])
{
    return (half[0] * half[0] + half[1] * half[1]) + (half[2] * half[2] + 1.0);
}

/** From the attitude on. */
VTI_INLINE void turned_body(int by_alpha, const vti_quat_view *principal, int64_t i, struct general *g)
{
    lanes q[4], p[4];
    if (by_alpha)
        half_pair(g->attitude, q);
    g->body.turned = principal->xyzw[0] != NULL;
    if (g->body.turned) {
        load_quad(principal, i, p);
        rotor_principal(by_alpha ? q : g->attitude, p, g->body.q);
    } else
        for (int k = 0; k < 4; ++k)
            g->body.q[k] = by_alpha ? q[k] : g->attitude[k];
    g->body.square = lanes_square(g->body.q);
}

VTI_INLINE void load_attitude(const vti_bodies *b, int64_t i, lanes attitude[4])
{
    if (vti_has(&b->alpha)) {
        load_any(stream_of(&b->alpha), i, attitude);
        attitude[3] = lanes_of(2.0);
    } else
        load_quad(&b->quat, i, attitude);
}

/** a += t by, of both kicks. */
VTI_INLINE void kick_any(const struct vti_move *move, const lanes by[3], lanes a[3])
{
    for (int k = 0; k < 3 && move->before != 0.0; ++k)
        a[k] += move->before * by[k];
    for (int k = 0; k < 3 && move->kick != 0.0; ++k)
        a[k] += move->kick * by[k];
}

VTI_INLINE int kicks_general(const struct vti_move *move, const vti_bodies *b)
{
    return vti_has(&b->moment) && (move->before != 0.0 || move->kick != 0.0);
}

/** L of the bodies from i on after their kicks. */
VTI_INLINE void kicked_spin(const struct vti_move *move, const vti_bodies *b, int64_t i, lanes L[3])
{
    lanes by[3];
    load_any(stream_of(&b->spin), i, L);
    if (kicks_general(move, b)) {
        load_any(stream_of(&b->moment), i, by);
        kick_any(move, by, L);
    }
}

/** The bodies from i on after their kicks. */
VTI_INLINE void load_general(const struct vti_move *move, const vti_bodies *b, int64_t i, struct general *g)
{
    lanes by[3];
    load_attitude(b, i, g->attitude);
    turned_body(vti_has(&b->alpha), &b->principal, i, g);
    load_any(stream_of(&b->moments), i, g->body.m);
    if (vti_has(&b->spin)) {
        kicked_spin(move, b, i, g->L);
        for (int k = 0; k < 3; ++k)
            g->omega[k] = lanes_of(0.0);
        return;
    }
    load_any(stream_of(&b->omega), i, g->omega);
    if (kicks_general(move, b)) {
        load_any(stream_of(&b->moment), i, by);
        rotor_times(&g->body, 1, by, by);
        kick_any(move, by, g->omega);
    }
    rotor_times(&g->body, 0, g->omega, g->L);
}

/* ---- turns ------------------------------------------------------------------------------------------------------- */

/** Which bodies of a block are spheres. */
enum { NO_SPHERES, SOME_SPHERES, ALL_SPHERES };

VTI_INLINE int spheres_of(lanes_mask round)
{
    return lanes_all(~round) ? NO_SPHERES : lanes_all(round) ? ALL_SPHERES : SOME_SPHERES;
}

/** alpha after an increment of which no turn is more than 2; whether the incremental form may be had, which one sum
 *  tells: 2^-6 < c, as |u| < 2^23, |alpha| < 2^29 and 4 |d| < c. square: 1 + |alpha/2|^2. */
VTI_INLINE lanes_mask turn_alpha_by(const struct rotor_increment *d, double side, lanes square, const lanes half[3],
                                    const lanes alpha[3], lanes a[3])
{
    lanes add[3];
    const lanes dot = rotor_incremental(d->c, d->u, side, half, add);
    for (int k = 0; k < 3; ++k)
        a[k] = alpha[k] + add[k];
    return 4.0 * lanes_abs(dot) + (0x1p-6 + 0x1p-31 * square) < d->c;
}

/** A sphere's attitude after its own drift; as for one that shows Omega, but the size of the increment is found out:
 *  |f u| < 2^15 c, |alpha| < 2^29, c < 2^34 and 2 |d| < c. */
VTI_INLINE lanes_mask turn_spheres(int law, double t, int by_alpha, const lanes m[3], const lanes L[3], lanes q[4])
{
    struct rotor_increment d;
    rotor_sphere(law, lanes_of(t), 1.0 / m[0], L, &d);
    const lanes uu = d.f * d.f * lanes_dot(d.u, d.u), cc = d.c * d.c;
    if (by_alpha) {
        lanes add[3];
        const lanes dot = incremental(d.c, d.f, d.u, lanes_of(1.0), q, add),
                    sizes = 0x1p-58 * (lanes_dot(q, q) + 4.0) + 0x1p-68 * cc;
        for (int k = 0; k < 3; ++k)
            q[k] += add[k];
        return (16.0 * (dot * dot) + 0x1p-30 * uu) + cc * sizes < d.c * lanes_abs(d.c);
    }
    for (int k = 0; k < 3; ++k)
        d.u[k] *= d.f;
    turn_quat_by(d.c, d.u, 1.0, q);
    return cc + uu < 0x1p100;
}

/** Where a block has spheres, they are turned by themselves, from before to q. */
VTI_INLINE lanes_mask with_spheres(int law, double t, int spheres, int by_alpha, const lanes m[3], const lanes L[3],
                                   const lanes before[4], lanes_mask sound, lanes q[4])
{
    const int count = by_alpha ? 3 : 4;
    lanes own[4];
    for (int k = 0; k < 4; ++k)
        own[k] = before[k];
    const lanes_mask turned = turn_spheres(law, t, by_alpha, m, L, own);
    const lanes_mask round = rotor_is_round(m);
    for (int k = 0; k < count; ++k)
        q[k] = spheres == ALL_SPHERES ? own[k] : lanes_where(round, own[k], q[k]);
    return spheres == ALL_SPHERES ? turned : (round & turned) | (~round & sound);
}

/** Turns the attitude of all lanes by the drift; 0, where it is not to be used, if some lane needs more care: of a body
 *  near a half turn, or one whose products could leave the range. */
VTI_INLINE int turn_general(int law, int rotor, double t, int by_alpha, const vti_quat_view *principal, int64_t i,
                            struct general *g)
{
    const int spheres = spheres_of(rotor_is_round(g->body.m));
    lanes_mask sound = lanes_of(0.0) < 1.0;
    lanes before[4], half[3];
    for (int k = 0; k < 4; ++k)
        before[k] = g->attitude[k];
    if (spheres != ALL_SPHERES) {
        struct rotor_start start;
        struct rotor_increment d;
        const struct rotor_start *const from = &start;
        turned_body(by_alpha, principal, i, g);
        rotor_start_of(t, &g->body, g->L, &start);
        rotor_drift(law, rotor, &from, &g->body, &d, 1);
        for (int k = 0; k < 3; ++k)
            half[k] = 0.5 * before[k];
        if (by_alpha)
            sound = turn_alpha_by(&d, rotor_side(&g->body), half_square(half), half, before, g->attitude);
        else
            turn_quat_by(d.c, d.u, rotor_side(&g->body), g->attitude);
        sound &= rotor_is_tame(from);
    }
    if (spheres != NO_SPHERES)
        sound = with_spheres(law, t, spheres, by_alpha, g->body.m, g->L, before, sound, g->attitude);
    return lanes_all(sound);
}

#endif
