/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kicks and drifts of many bodies with three moments at once, a body to a lane, by the formulas of vti_rotor.h, which
 * are those of one body. Where a body is near a half turn, or turns too far for its squares, the bodies of all lanes
 * are moved one by one. Included by vti_move_kernels.h only. */
#ifndef VTI_ROTOR_KERNELS_H
#define VTI_ROTOR_KERNELS_H

#include "vti_rotor_block.h"

static const double unit_inertia = 1.0; /* of L, which is kicked by t RM */

/* ---- packed bodies ----------------------------------------------------------------------------------------------- */

/** Where the drift of a block of packed bodies begins. */
struct begun {
    struct rotor_start from;
    lanes alpha[3], half[3], square; /* alpha/2, and 1 + its square */
    lanes_mask tame;
    int spheres;
};

/** A drift is a chain of products, and a processor looks only some hundred operations ahead: so many blocks begin
 *  theirs before that of the first goes on, and then some go on side by side. */
enum { BEGUN = 8 };

VTI_INLINE void load_packed(struct stream s, int64_t i, lanes r[3])
{
    lanes there[3];
    load(PACKED, s, i, there);
    lanes_split(there, r);
}

VTI_INLINE void begin_packed(const struct vti_move *move, const vti_bodies *b, struct kicks k, int64_t i,
                             struct begun *to)
{
    const struct stream spin = stream_of(&b->spin);
    struct rotor_body body = {.turned = 0};
    lanes there[3], L[3];
    load(PACKED, spin, i, there);
    if (k.count > 0) {
        kick(PACKED, k, i, there);
        store(PACKED, spin, i, there);
    }
    lanes_split(there, L);
    load_any(stream_of(&b->moments), i, body.m);
    load_packed(stream_of(&b->alpha), i, to->alpha);
    to->spheres = spheres_of(rotor_is_round(body.m));
    if (to->spheres == ALL_SPHERES)
        return;
    half_pair(to->alpha, body.q);
    body.square = to->square = half_square(body.q);
    for (int n = 0; n < 3; ++n)
        to->half[n] = body.q[n];
    rotor_start_of(move->drift, &body, L, &to->from);
    to->tame = rotor_is_tame(&to->from);
}

/** Turns a block by its increment. */
VTI_INLINE void turn_packed(int law, int rotor, const struct vti_move *move, const vti_bodies *b, int64_t i,
                            const struct begun *begun, const struct rotor_increment *d)
{
    const lanes before[4] = {begun->alpha[0], begun->alpha[1], begun->alpha[2], lanes_of(2.0)};
    lanes q[4] = {before[0], before[1], before[2], before[3]}, there[3];
    lanes_mask sound = begun->tame;
    if (begun->spheres != ALL_SPHERES)
        sound &= turn_alpha_by(d, -1.0, begun->square, begun->half, begun->alpha, q);
    if (begun->spheres != NO_SPHERES) {
        lanes m[3], L[3];
        load_any(stream_of(&b->moments), i, m);
        load_packed(stream_of(&b->spin), i, L);
        sound = with_spheres(law, move->drift, begun->spheres, 1, m, L, before, sound, q);
    }
    if (lanes_all(sound)) {
        lanes_join(q, there);
        store(PACKED, stream_of(&b->alpha), i, there);
    } else {
        const struct vti_move drift = {0.0, 0.0, move->drift, 1, law, VTI_FRAME_SPACE, rotor};
        vti_rotor_move(&drift, b, i, i + WIDTH);
    }
}

/** Ends the drifts of one block or of as many as go on side by side, from body i on. */
VTI_INLINE void end_packed(int law, int rotor, const struct vti_move *move, const vti_bodies *b, int64_t i,
                           const struct begun *begun, int count)
{
    const struct rotor_body own_axes = {.turned = 0};
    const struct rotor_start *from[ROTOR_ABREAST];
    struct rotor_increment d[ROTOR_ABREAST];
    for (int n = 0; n < count; ++n)
        from[n] = &begun[n].from;
    if (count > 1 || begun->spheres != ALL_SPHERES)
        rotor_drift(law, rotor, from, &own_axes, d, count);
    for (int n = 0; n < count; ++n)
        turn_packed(law, rotor, move, b, i + n * WIDTH, begun + n, d + n);
}

/** Bodies that show L and alpha, all packed, their axes the body's own. */
VTI_INLINE void move_packed(int law, int rotor, const struct vti_move *move, const vti_bodies *b, int64_t begin,
                            int64_t end)
{
    const vti_scalars one = {&unit_inertia, 0, 0};
    const struct kicks k = kicks_of(move, &b->moment, &one);
    struct begun begun[BEGUN];
    for (int64_t i = begin; i + WIDTH <= end;) {
        int count = 0;
        for (; count < BEGUN && i + (count + 1) * WIDTH <= end; ++count)
            begin_packed(move, b, k, i + count * WIDTH, begun + count);
        for (int n = 0; n < count;) {
            int tops = 0; /* side by side */
            while (tops < ROTOR_ABREAST && n + tops < count && begun[n + tops].spheres != ALL_SPHERES)
                ++tops;
            if (tops == ROTOR_ABREAST)
                end_packed(law, rotor, move, b, i + n * WIDTH, begun + n, ROTOR_ABREAST);
            else
                end_packed(law, rotor, move, b, i + n * WIDTH, begun + n, 1);
            n += tops == ROTOR_ABREAST ? ROTOR_ABREAST : 1;
        }
        i += count * WIDTH;
    }
}

/* ---- bodies of any layout ---------------------------------------------------------------------------------------- */

VTI_INLINE int is_packed(const struct vti_move *move, const vti_bodies *b)
{
    return move->drifts && order_of(stream_of(&b->spin)) == PACKED && order_of(stream_of(&b->alpha)) == PACKED &&
           (order_of(stream_of(&b->moments)) == PACKED || b->moments.stride == 0) && !vti_has(&b->omega) &&
           b->principal.xyzw[0] == NULL && (!kicks_general(move, b) || order_of(stream_of(&b->moment)) == PACKED);
}

/** law 0: kicks only. */
VTI_INLINE void move_general(int law, int rotor, const struct vti_move *move, const vti_bodies *b, int64_t begin,
                             int64_t end)
{
    const int by_alpha = vti_has(&b->alpha), spins = vti_has(&b->spin), shows = vti_has(&b->omega);
    for (int64_t i = begin; i + WIDTH <= end; i += WIDTH) {
        struct general g;
        load_general(move, b, i, &g);
        int sound = 1;
        if (law != 0) {
            sound = turn_general(law, rotor, move->drift, by_alpha, &b->principal, i, &g);
            if (shows)
                turned_body(by_alpha, &b->principal, i, &g);
        } else if (by_alpha)
            sound = lanes_all(lanes_dot(g.attitude, g.attitude) < 0x1p58);
        if (!sound) {
            vti_rotor_move(move, b, i, i + WIDTH);
            continue;
        }
        if (shows && (spins || law != 0))
            rotor_times(&g.body, 1, g.L, g.omega);
        if (spins && kicks_general(move, b))
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
#define MOVE_GENERAL(HOW, LAW, ROTOR)                                                                                  \
    static void HOW##_##LAW##_##ROTOR(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)    \
    {                                                                                                                  \
        move_##HOW(VTI_LAW_##LAW, ROTOR, move, b, begin, end);                                                         \
    }
#define ALL_LAWS(HOW, ROTOR)                                                                                           \
    MOVE_GENERAL(HOW, CLOSED, ROTOR)                                                                                   \
    MOVE_GENERAL(HOW, CAYLEY, ROTOR)                                                                                   \
    MOVE_GENERAL(HOW, EXACT, ROTOR)                                                                                    \
    MOVE_GENERAL(HOW, EXACT9, ROTOR)
ALL_LAWS(general, 2)
ALL_LAWS(general, 4)
ALL_LAWS(general, 6)
ALL_LAWS(packed, 2)
ALL_LAWS(packed, 4)
ALL_LAWS(packed, 6)

static void general_kicks(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    move_general(0, 2, move, b, begin, end);
}

#define GENERAL_BY_LAW(HOW, KICKS, ROTOR)                                                                              \
    {                                                                                                                  \
        KICKS, HOW##_CLOSED_##ROTOR, HOW##_CAYLEY_##ROTOR, HOW##_EXACT_##ROTOR, HOW##_EXACT9_##ROTOR                   \
    }
/** [packed][half of the rotor, less 1][law, or 0 without a drift] */
typedef void turn(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
static turn *const generals[2][3][VTI_LAW_EXACT9 + 1] = {
    {GENERAL_BY_LAW(general, general_kicks, 2), GENERAL_BY_LAW(general, general_kicks, 4),
     GENERAL_BY_LAW(general, general_kicks, 6)},
    {GENERAL_BY_LAW(packed, NULL, 2), GENERAL_BY_LAW(packed, NULL, 4), GENERAL_BY_LAW(packed, NULL, 6)}};

static int64_t rotate_general(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (end - begin < WIDTH || !vti_has_attitude(b))
        return begin;
    const vti_scalars one = {&unit_inertia, 0, 0};
    const struct stream spin = stream_of(&b->spin);
    if (!move->drifts && !vti_has(&b->omega))
        return kick_and_move_any(kicks_of(move, &b->moment, &one), 0.0, spin, 0, spin, begin, end);
    const int rotor = move->rotor == 0 ? 2 : move->rotor;
    const int64_t stop = begin + (end - begin) / WIDTH * WIDTH;
    generals[is_packed(move, b)][rotor / 2 - 1][move->drifts ? move->law : 0](move, b, begin, stop);
    return stop;
}

/** Whether |t| |L| is below the least moment in all lanes, by enough for what is rounded later: then no turn reaches 1,
 *  as none is more than t |L|/min(m). */
VTI_INLINE int is_slow(double t, const lanes m[3], const lanes L[3])
{
    const lanes u[3] = {t * L[0], t * L[1], t * L[2]};
    const lanes low = lanes_where(m[0] < m[1], m[0], m[1]), least = lanes_where(low < m[2], low, m[2]);
    return lanes_all(((1.0 + 0x1p-40) * lanes_dot(u, u) < least * least) & (least > 0x1p-500));
}

/** Whether a turn of the closed form is 1 or more, or NaN. */
static int reaches_general(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end,
                           int64_t *stopped)
{
    const int spins = vti_has(&b->spin);
    lanes_mask below = lanes_of(0.0) < 1.0;
    int64_t i = begin;
    for (; i + WIDTH <= end; i += WIDTH) {
        struct general g;
        struct rotor_start from;
        if (spins) {
            lanes m[3], L[3];
            load_any(stream_of(&b->moments), i, m);
            kicked_spin(move, b, i, L);
            if (is_slow(move->drift, m, L))
                continue;
        }
        load_general(move, b, i, &g);
        rotor_start_of(move->drift, &g.body, g.L, &from);
        if (spheres_of(rotor_is_round(g.body.m)) != NO_SPHERES) {
            struct rotor_increment d;
            rotor_sphere(VTI_LAW_CLOSED, lanes_of(move->drift), 1.0 / g.body.m[0], g.L, &d);
            below &= (lanes_dot(d.u, d.u) < 1.0) | (rotor_is_round(g.body.m) == 0);
        }
        below &= (from.range < ROTOR_RANGE) & (rotor_most(VTI_LAW_CLOSED, move->rotor, &from) < 1.0);
    }
    *stopped = i;
    return !lanes_all(below);
}

#endif
