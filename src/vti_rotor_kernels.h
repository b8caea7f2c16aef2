/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kicks and drifts of many bodies with three moments at once, a body to a lane, by the formulas of vti_rotor.h, which
 * are those of one body. Where a body is near a half turn, or turns too far for its squares, the bodies of all lanes
 * are moved one by one. Included by vti_move_kernels.h only. */
#ifndef VTI_ROTOR_KERNELS_H
#define VTI_ROTOR_KERNELS_H

#include "vti_rotor.h"
#include "vti_turn_kernels.h"

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
        lanes_strided(s.stride, at);
        for (int k = 0; k < 3; ++k)
            r[k] = s.stride == 0 ? lanes_of(*s.c[k]) : lanes_gather(s.c[k] + i * s.stride, at);
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
        lanes_strided(s.stride, at);
        for (int k = 0; k < 3; ++k)
            lanes_scatter(s.c[k] + i * s.stride, at, r[k]);
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

/** From the attitude on. */
VTI_INLINE void turned_body(const vti_bodies *b, int64_t i, struct general *g)
{
    if (b->principal.xyzw[0] != NULL) {
        lanes p[4];
        load_quad(&b->principal, i, p);
        rotor_principal(g->attitude, p, g->body.q);
    } else
        for (int k = 0; k < 4; ++k)
            g->body.q[k] = g->attitude[k];
    g->body.scale = 2.0 / lanes_square(g->body.q);
}

/** The bodies from i on after their kicks. */
VTI_INLINE void load_general(const struct vti_move *move, const vti_bodies *b, int64_t i, struct general *g)
{
    const int spins = vti_has(&b->spin);
    lanes by[3];
    if (vti_has(&b->alpha)) {
        load_any(stream_of(&b->alpha), i, g->attitude);
        g->attitude[3] = lanes_of(2.0);
    } else
        load_quad(&b->quat, i, g->attitude);
    turned_body(b, i, g);
    load_any(stream_of(&b->moments), i, g->body.m);
    for (int k = 0; k < 3; ++k)
        g->body.k[k] = 1.0 / g->body.m[k];
    lanes *const kicked = spins ? g->L : g->omega;
    load_any(stream_of(spins ? &b->spin : &b->omega), i, kicked);
    if (vti_has(&b->moment) && (move->before != 0.0 || move->kick != 0.0)) {
        load_any(stream_of(&b->moment), i, by);
        if (!spins)
            rotor_times(&g->body, g->body.k, by, by);
        for (int k = 0; k < 3 && move->before != 0.0; ++k)
            kicked[k] += move->before * by[k];
        for (int k = 0; k < 3 && move->kick != 0.0; ++k)
            kicked[k] += move->kick * by[k];
    }
    if (!spins)
        rotor_times(&g->body, g->body.m, g->omega, g->L);
}

/** The attitude turned by the increment; 0, where it is not to be used, if some lane needs more care. */
VTI_INLINE int turn_general(int by_alpha, const struct rotor_increment *d, lanes q[4])
{
    const lanes uu = d->f * d->f * lanes_dot(d->u, d->u), cc = d->c * d->c, size = cc + uu;
    lanes_mask near = (size < 0x1p100) & (size > 0x1p-100);
    if (by_alpha) {
        lanes add[3];
        const lanes dot = incremental(d->c, d->f, d->u, 1.0, q, add);
        near &= (d->c > 0x1p-30) & (4.0 * (dot * dot) + 0x1p-56 * uu < cc) & (lanes_dot(q, q) < 0x1p58);
        for (int k = 0; k < 3; ++k)
            q[k] += add[k];
        return lanes_all(near);
    }
    lanes u[3], r[4], x[3];
    for (int k = 0; k < 3; ++k)
        u[k] = d->f * d->u[k];
    lanes_cross(u, q, x);
    for (int k = 0; k < 3; ++k)
        r[k] = d->c * q[k] + q[3] * u[k] + x[k];
    r[3] = d->c * q[3] - lanes_dot(u, q);
    const lanes scale = 1.0 / lanes_sqrt(lanes_dot(r, r) + r[3] * r[3]);
    for (int k = 0; k < 4; ++k)
        q[k] = r[k] * scale;
    return lanes_all(near);
}

/** law 0: kicks only. */
VTI_INLINE void move_general(int law, int rotor, const struct vti_move *move, const vti_bodies *b, int64_t begin,
                             int64_t end)
{
    const int by_alpha = vti_has(&b->alpha), spins = vti_has(&b->spin), shows = vti_has(&b->omega);
    const int kicks = vti_has(&b->moment) && (move->before != 0.0 || move->kick != 0.0);
    for (int64_t i = begin; i + WIDTH <= end; i += WIDTH) {
        struct general g;
        struct rotor_increment d;
        load_general(move, b, i, &g);
        int sound = 1;
        if (law != 0) {
            rotor_drift(law, rotor, lanes_of(move->drift), &g.body, g.L, &d);
            sound = turn_general(by_alpha, &d, g.attitude);
            if (shows)
                turned_body(b, i, &g);
        } else if (by_alpha)
            sound = lanes_all(lanes_dot(g.attitude, g.attitude) < 0x1p58);
        if (!sound) {
            vti_rotor_move(move, b, i, i + WIDTH);
            continue;
        }
        if (shows && (spins || law != 0))
            rotor_times(&g.body, g.body.k, g.L, g.omega);
        if (spins && kicks)
            store_any(stream_of(&b->spin), i, g.L);
        if (shows)
            store_any(stream_of(&b->omega), i, g.omega);
        if (law != 0 && by_alpha)
            store_any(stream_of(&b->alpha), i, g.attitude);
        else if (law != 0)
            store_quad(&b->quat, i, g.attitude);
    }
}

/* Literal arguments, so that each law and each rotor is a loop of its own. */
#define MOVE_GENERAL(LAW, ROTOR)                                                                                       \
    static void general_##LAW##_##ROTOR(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)  \
    {                                                                                                                  \
        move_general(VTI_LAW_##LAW, ROTOR, move, b, begin, end);                                                       \
    }
#define ALL_LAWS(ROTOR)                                                                                                \
    MOVE_GENERAL(CLOSED, ROTOR)                                                                                        \
    MOVE_GENERAL(CAYLEY, ROTOR)                                                                                        \
    MOVE_GENERAL(EXACT, ROTOR)                                                                                         \
    MOVE_GENERAL(EXACT9, ROTOR)
ALL_LAWS(2)
ALL_LAWS(4)
ALL_LAWS(6)

static void general_kicks(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    move_general(0, 2, move, b, begin, end);
}

#define GENERAL_BY_LAW(ROTOR)                                                                                          \
    {                                                                                                                  \
        general_kicks, general_CLOSED_##ROTOR, general_CAYLEY_##ROTOR, general_EXACT_##ROTOR, general_EXACT9_##ROTOR   \
    }
/** [half of the rotor, less 1][law, or 0 without a drift] */
static turn *const generals[3][VTI_LAW_EXACT9 + 1] = {GENERAL_BY_LAW(2), GENERAL_BY_LAW(4), GENERAL_BY_LAW(6)};

static int64_t rotate_general(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (end - begin < WIDTH || !vti_has_attitude(b))
        return begin;
    const int rotor = move->rotor == 0 ? 2 : move->rotor;
    const int64_t stop = begin + (end - begin) / WIDTH * WIDTH;
    generals[rotor / 2 - 1][move->drifts ? move->law : 0](move, b, begin, stop);
    return stop;
}

/** Whether a turn of the closed form is 1 or more, or NaN. */
static int reaches_general(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end,
                           int64_t *stopped)
{
    lanes_mask below = lanes_of(0.0) < 1.0;
    int64_t i = begin;
    for (; i + WIDTH <= end; i += WIDTH) {
        struct general g;
        load_general(move, b, i, &g);
        below &= rotor_most(VTI_LAW_CLOSED, move->rotor, lanes_of(move->drift), &g.body, g.L) < 1.0;
    }
    *stopped = i;
    return !lanes_all(below);
}

#endif
