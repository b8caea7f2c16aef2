/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Turns of many bodies at once, a body to a lane: the incremental form of vti_rrv.h without its branch; where it is not
 * allowed in some lane, the bodies of all lanes are turned one by one. Only the attitude and t Omega are sorted by
 * component. Included by vti_move_kernels.h only. */
#ifndef VTI_TURN_KERNELS_H
#define VTI_TURN_KERNELS_H

#include "vti_strip_kernels.h"

VTI_RRV_INCREMENTAL(incremental, lanes)
VTI_MOVE_LAW(law_of, lanes, lanes_of, lanes_sqrt)
VTI_MOVE_QUAT(turn_quat_by, lanes, lanes_dot, lanes_cross, lanes_sqrt)

static int quat_is_adjacent(const vti_quat_view *q)
{
    return q->xyzw[1] == q->xyzw[0] + 1 && q->xyzw[2] == q->xyzw[0] + 2 && q->xyzw[3] == q->xyzw[0] + 3;
}

/* ---- turn -------------------------------------------------------------------------------------------------------- */

/** u = t Omega after its kicks, which k is for, by component. Returns u.u. */
VTI_INLINE lanes kicked_turn(enum order order, struct kicks k, double t, struct stream omega, int writes, int64_t i,
                             lanes u[3])
{
    lanes w[3];
    load(order, omega, i, w);
    if (k.count > 0) {
        kick(order, k, i, w);
        if (writes)
            store(order, omega, i, w);
    }
    for (int c = 0; c < 3; ++c)
        w[c] *= t;
    if (order == PACKED)
        lanes_split(w, u);
    else
        for (int c = 0; c < 3; ++c)
            u[c] = w[c];
    return u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
}

VTI_APART void turn_one_by_one(const struct vti_move *move, const vti_bodies *b, int64_t i)
{
    for (int l = 0; l < WIDTH; ++l)
        vti_move_turn(move, b, i + l);
}

/** a <- a (+) dalpha(u). Returns whether the incremental form is allowed, of all lanes: 2 |f u.a| < c, |a| < 2^29 and
 *  |f u| < 2^29 c. Its sum tells, of 0 < c <= 2: where the first holds, it is no smaller than its parts along a, at
 *  least 2/3 |a|, and along u, at least 8/(5 c) |f u|, but for less than 1. So one sum that is less than c^2, as
 *  rounding keeps order, tells all. */
VTI_INLINE int turn_alphas(int law, double side, lanes s2, const lanes u[3], lanes a[3])
{
    lanes add[3], cf[2];
    law_of(law, s2, cf);
    const lanes d = incremental(cf[0], cf[1], u, lanes_of(side), a, add);
    for (int n = 0; n < 3; ++n)
        a[n] += add[n];
    const lanes aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const int near = lanes_all_less(d * d + 0x1p-58 * aa, 0.0625 * (cf[0] * cf[0]));
    /* c of the exact laws, which are polynomials, leaves [-2, 2] beyond s^2 = 29 and 180 */
    return law == VTI_LAW_EXACT || law == VTI_LAW_EXACT9 ? near && lanes_all_less(s2, lanes_of(8.0)) : near;
}

/** r = normalise((u, c) q), or q (u, c) in the body's frame, where s^2 = u.u < 8. */
VTI_INLINE void turn_quats(int law, double side, lanes s2, const lanes u[3], const lanes q[4], lanes r[4])
{
    lanes f[3], cf[2];
    law_of(law, s2, cf);
    for (int n = 0; n < 3; ++n)
        f[n] = cf[1] * u[n];
    for (int n = 0; n < 4; ++n)
        r[n] = q[n];
    turn_quat_by(cf[0], f, side, r);
}

/** alpha <- alpha (+) dalpha(t Omega), of bodies that are translated too where x says so. */
VTI_INLINE void turn_alpha(enum order order, int law, double side, const struct vti_move *move, const vti_bodies *b,
                           struct kicks k, struct translation x, int64_t begin, int64_t end)
{
    const struct stream omega = stream_of(&b->omega), alpha = stream_of(&b->alpha);
    const double t = move->drift;
    for (int64_t i = begin; i < end;) { /* a whole number of lanes */
        const int64_t to = strip_end(order, x, i, end), until = prefetched_until(order, x, to, end);
        for (int64_t next = i + x.strips.ahead; next < until; next += LINE) {
            prefetch_line(order, x, k, omega, next);
            prefetch_vectors(x.strips, order, alpha, next);
        }
        struct kicks next = kicks_at(k, i);
        translate_strip(order, x, i, to);
        for (; i < to; i += WIDTH) {
            lanes u[3], there[3], a[3];
            const lanes s2 = kicked_turn(order, kicks_ahead(&next, i, to), t, omega, 1, i, u);
            load(order, alpha, i, there);
            if (order == PACKED)
                lanes_split(there, a);
            else
                for (int n = 0; n < 3; ++n)
                    a[n] = there[n];
            if (!turn_alphas(law, side, s2, u, a)) {
                turn_one_by_one(move, b, i);
                continue;
            }
            if (order == PACKED) {
                lanes_join(a, there);
                store(order, alpha, i, there);
            } else
                store(order, alpha, i, a);
        }
    }
}

/** q <- normalise((u, c) q), or q (u, c) in the body's frame, where u is small enough for its square. */
VTI_INLINE void turn_quat(enum order order, int law, double side, const struct vti_move *move, const vti_bodies *b,
                          struct kicks k, struct translation x, int64_t begin, int64_t end)
{
    const struct stream omega = stream_of(&b->omega);
    const vti_quat_view quat = b->quat;
    const double t = move->drift;
    const int adjacent = quat_is_adjacent(&quat);
    int64_t at[WIDTH];
    lanes_strided(quat.stride, at);
    for (int64_t i = begin; i < end;) { /* a whole number of lanes */
        const int64_t to = strip_end(order, x, i, end), until = prefetched_until(order, x, to, end);
        for (int64_t next = i + x.strips.ahead; next < until; next += LINE) {
            prefetch_line(order, x, k, omega, next);
            for (int n = 0; n < 4; ++n)
                prefetch(x.strips, adjacent ? quat.xyzw[0] + next * quat.stride + n * LINE : quat.xyzw[n] + next, 1);
        }
        struct kicks next = kicks_at(k, i);
        translate_strip(order, x, i, to);
        for (; i < to; i += WIDTH) {
            lanes u[3], q[4], r[4];
            const lanes s2 = kicked_turn(order, kicks_ahead(&next, i, to), t, omega, 1, i, u);
            if (adjacent)
                lanes_quads(quat.xyzw[0] + i * quat.stride, at, q);
            else
                for (int n = 0; n < 4; ++n)
                    q[n] = lanes_load(quat.xyzw[n] + i);
            if (!lanes_all_less(s2, lanes_of(8.0))) {
                turn_one_by_one(move, b, i);
                continue;
            }
            turn_quats(law, side, s2, u, q, r);
            if (adjacent)
                lanes_unquad(quat.xyzw[0] + i * quat.stride, at, r);
            else
                for (int n = 0; n < 4; ++n)
                    lanes_store(quat.xyzw[n] + i, r[n]);
        }
    }
}

/* Literal arguments, so that each order, law and frame is a loop of its own, and another for plain kicks. */
typedef void turn_with(const struct vti_move *move, const vti_bodies *b, const struct translation *with, int64_t begin,
                       int64_t end);
#define TURN(KEPT, ORDER, LAW, FRAME, SIDE)                                                                            \
    static void KEPT##_##ORDER##_##LAW##_##FRAME(const struct vti_move *move, const vti_bodies *b,                     \
                                                 const struct translation *with, int64_t begin, int64_t end)           \
    {                                                                                                                  \
        const struct kicks k = kicks_of(move, &b->moment, &b->inertia);                                                \
        const struct translation x = translation_with(ORDER, with);                                                    \
        if (ORDER != MIXED && are_plain(k) && (with == NULL || are_plain(x.k)))                                        \
            turn_##KEPT(ORDER, VTI_LAW_##LAW, SIDE, move, b, plain(k), with_plain_kicks(x), begin, end);               \
        else                                                                                                           \
            turn_##KEPT(ORDER, VTI_LAW_##LAW, SIDE, move, b, k, x, begin, end);                                        \
    }
#define LAWS(KEPT, ORDER, FRAME, SIDE)                                                                                 \
    TURN(KEPT, ORDER, CLOSED, FRAME, SIDE)                                                                             \
    TURN(KEPT, ORDER, CAYLEY, FRAME, SIDE)                                                                             \
    TURN(KEPT, ORDER, EXACT, FRAME, SIDE)                                                                              \
    TURN(KEPT, ORDER, EXACT9, FRAME, SIDE)
LAWS(alpha, PACKED, space, 1.0)
LAWS(alpha, PACKED, body, -1.0)
LAWS(alpha, SEPARATE, space, 1.0)
LAWS(alpha, SEPARATE, body, -1.0)
LAWS(alpha, MIXED, space, 1.0)
LAWS(alpha, MIXED, body, -1.0)
LAWS(quat, PACKED, space, 1.0)
LAWS(quat, PACKED, body, -1.0)
LAWS(quat, SEPARATE, space, 1.0)
LAWS(quat, SEPARATE, body, -1.0)
LAWS(quat, MIXED, space, 1.0)
LAWS(quat, MIXED, body, -1.0)

#define BY_LAW(KEPT, ORDER, FRAME)                                                                                     \
    {                                                                                                                  \
        NULL, KEPT##_##ORDER##_CLOSED_##FRAME, KEPT##_##ORDER##_CAYLEY_##FRAME, KEPT##_##ORDER##_EXACT_##FRAME,        \
            KEPT##_##ORDER##_EXACT9_##FRAME                                                                            \
    }
#define BY_FRAME(KEPT, ORDER)                                                                                          \
    {                                                                                                                  \
        BY_LAW(KEPT, ORDER, space), BY_LAW(KEPT, ORDER, body)                                                          \
    }
/** [attitude is a quaternion][order of omega, moment and alpha][frame is the body's][law] */
static turn_with *const turns[2][3][2][VTI_LAW_EXACT9 + 1] = {
    {BY_FRAME(alpha, PACKED), BY_FRAME(alpha, SEPARATE), BY_FRAME(alpha, MIXED)},
    {BY_FRAME(quat, PACKED), BY_FRAME(quat, SEPARATE), BY_FRAME(quat, MIXED)}};

/** Eight lanes are sorted more slowly than twice four. */
static int worth_it(int order)
{
    return order == MIXED && WIDTH > 4 ? -1 : order;
}

/** The order in which the lanes of a turn are filled; -1 if they cannot be. */
static int turn_order(const struct kicks *k, const vti_bodies *b)
{
    const struct stream w = stream_of(&b->omega);
    int order = order_with(order_of(w), k->count > 0 ? k->by : w);
    if (vti_has(&b->alpha))
        order = order_with(order, stream_of(&b->alpha));
    else if (b->quat.stride != 1 && !quat_is_adjacent(&b->quat))
        order = -1;
    return worth_it(order);
}

static turn_with *turn_of(const struct vti_move *move, const vti_bodies *b, int order)
{
    return turns[!vti_has(&b->alpha)][order][move->frame == VTI_FRAME_BODY][move->law];
}

static int64_t rotate(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (end - begin < WIDTH)
        return begin;
    const struct stream w = stream_of(&b->omega);
    const struct kicks k = kicks_of(move, &b->moment, &b->inertia);
    if (!move->drifts || !vti_has_attitude(b))
        return kick_and_move_any(k, 0.0, w, 0, w, begin, end);
    const int order = turn_order(&k, b);
    if (order < 0)
        return begin;
    const int64_t stop = begin + (end - begin) / WIDTH * WIDTH;
    struct vti_move rest = *move;
    if (order == MIXED && k.count > 0 && kick_and_move_any(k, 0.0, w, 0, w, begin, stop) == stop)
        rest.before = rest.kick = 0.0;
    turn_of(move, b, order)(&rest, b, NULL, begin, stop);
    return stop;
}

/* ---- translation and turn in one loop ---------------------------------------------------------------------------- */

/** Both kicks where nothing turns, from the last body to the first. */
VTI_INLINE void kick_strips(enum order order, struct translation x, struct kicks k, struct stream w, int64_t begin,
                            int64_t end)
{
    for (int64_t i = end; i > begin;) {
        const int64_t from = i - begin < x.strips.bodies ? begin : i - x.strips.bodies, ahead = x.strips.ahead;
        if (ahead > 0 && from - ahead >= begin)
            for (int64_t next = i - ahead; next > from - ahead; next -= LINE)
                prefetch_line(order, x, k, w, next - LINE);
        for (; i > from; i -= WIDTH) {
            kick_and_move_some(order, kicks_at(k, i - WIDTH), 0.0, w, 0, w, i - WIDTH);
            kick_and_move_some(order, kicks_at(x.k, i - WIDTH), x.t, x.v, 0, x.x, i - WIDTH);
        }
    }
}

VTI_INLINE void kick_both(enum order order, struct translation x, struct kicks k, struct stream w, int64_t begin,
                          int64_t end)
{
    if (are_plain(k) && are_plain(x.k))
        kick_strips(order, with_plain_kicks(x), plain(k), w, begin, end);
    else
        kick_strips(order, x, k, w, begin, end);
}

static int64_t move_both(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    struct translation x = translation_of(move, b);
    const struct kicks k = kicks_of(move, &b->moment, &b->inertia);
    const struct stream w = stream_of(&b->omega), by = k.count > 0 ? k.by : w;
    x.strips = strips_of(end - begin);
    const int turns_too = move->drifts && vti_has_attitude(b);
    const int order = order_with(order_with(order_of(x.v), x.x), x.k.count > 0 ? x.k.by : x.v);
    if (order != (turns_too ? turn_order(&k, b) : order_with(order_of(w), by)) || order < 0 || order == MIXED)
        return begin;
    const int64_t stop = begin + (end - begin) / WIDTH * WIDTH;
    if (turns_too)
        turn_of(move, b, order)(move, b, &x, begin, stop);
    else if (order == PACKED)
        kick_both(PACKED, x, k, w, begin, stop);
    else
        kick_both(SEPARATE, x, k, w, begin, stop);
    return stop;
}

/* ---- the bound of the closed form -------------------------------------------------------------------------------- */

static int reaches(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end, int64_t *stopped)
{
    const struct kicks k = kicks_of(move, &b->moment, &b->inertia);
    const struct stream omega = stream_of(&b->omega), by = k.count > 0 ? k.by : omega;
    lanes_mask below = lanes_of(0.0) < 1.0;
    int64_t i = begin;
    lanes u[3];
    const int order = worth_it(order_with(order_of(omega), by));
    if (order == PACKED)
        for (; i + WIDTH <= end; i += WIDTH)
            below &= kicked_turn(PACKED, kicks_at(k, i), move->drift, omega, 0, i, u) < 1.0;
    else if (order >= 0)
        for (; i + WIDTH <= end; i += WIDTH)
            below &= kicked_turn(MIXED, kicks_at(k, i), move->drift, omega, 0, i, u) < 1.0;
    *stopped = i;
    return !lanes_all(below);
}

#endif
