/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kicks and translations of many bodies at once, a body to a lane. Vectors that lie packed are kicked and moved as they
 * lie; all others are sorted by component as they are read. Included by vti_move_kernels.h only. */
#ifndef VTI_KICK_KERNELS_H
#define VTI_KICK_KERNELS_H

#include "../lanes/vti_lanes.h"
#include "../vti_move.h"

/* ---- what lies how ----------------------------------------------------------------------------------------------- */

/** PACKED: as vectors lie in memory, x y z x y z ..., three vectors of lanes. SEPARATE: an array for each component.
 *  MIXED: of components that lie side by side at any stride, and of separate ones. */
enum order { PACKED, SEPARATE, MIXED };

/** A view, in variables of its own: what nobody else can change stays in registers, but for what is indexed or pointed
 *  to; gcc would copy an array of three pointers to the stack and back at every body. */
struct stream {
    double *x, *y, *z;
    int64_t stride;
    int adjacent; /* its components lie side by side */
};

VTI_INLINE struct stream stream_of(const vti_view *v)
{
    const int adjacent = vti_has(v) && v->c[1] == v->c[0] + 1 && v->c[2] == v->c[0] + 2;
    return (struct stream){v->c[0], v->c[1], v->c[2], v->stride, adjacent};
}

/** The order in which lanes are filled from it alone; -1 if they cannot be. */
VTI_INLINE int order_of(struct stream s)
{
    return s.adjacent ? (s.stride == 3 ? PACKED : MIXED) : s.stride == 1 ? SEPARATE : -1;
}

/** The same of two together. */
VTI_INLINE int order_with(int order, struct stream s)
{
    const int other = order_of(s);
    return order == other ? order : order < 0 || other < 0 ? -1 : MIXED;
}

VTI_INLINE void load(enum order order, struct stream s, int64_t i, lanes r[3])
{
    if (order == MIXED && s.adjacent) {
        int64_t at[WIDTH];
        lanes_strided(s.stride, at);
        lanes_triples(s.x + i * s.stride, at, r);
        return;
    }
    r[0] = lanes_load(order == PACKED ? s.x + 3 * i : s.x + i);
    r[1] = lanes_load(order == PACKED ? s.x + 3 * i + WIDTH : s.y + i);
    r[2] = lanes_load(order == PACKED ? s.x + 3 * i + 2 * WIDTH : s.z + i);
}

VTI_INLINE void store(enum order order, struct stream s, int64_t i, const lanes r[3])
{
    if (order == MIXED && s.adjacent) {
        int64_t at[WIDTH];
        lanes_strided(s.stride, at);
        lanes_untriple(s.x + i * s.stride, at, r);
        return;
    }
    lanes_store(order == PACKED ? s.x + 3 * i : s.x + i, r[0]);
    lanes_store(order == PACKED ? s.x + 3 * i + WIDTH : s.y + i, r[1]);
    lanes_store(order == PACKED ? s.x + 3 * i + 2 * WIDTH : s.z + i, r[2]);
}

/* ---- kick -------------------------------------------------------------------------------------------------------- */

/** The kicks of a move of one quantity: a += t/m by, once or twice. */
struct kicks {
    int count;
    int same;             /* both last equally long */
    double first, second; /* their times */
    struct stream by;
    const double *m;
    int64_t stride;
    lanes by_first, by_second; /* times over m: of some bodies (kicks_at), or of all where one m serves; if they are
                                  equally long, only the first */
};

VTI_INLINE struct kicks kicks_of(const struct vti_move *move, const vti_view *by, const vti_scalars *over)
{
    const int before = vti_has(by) && move->before != 0.0, now = vti_has(by) && move->kick != 0.0;
    const double first = before ? move->before : move->kick, second = move->kick;
    const int one = before + now > 0 && over->stride == 0;
    return (struct kicks){before + now,
                          first == second,
                          first,
                          second,
                          stream_of(by),
                          over->p,
                          over->stride,
                          lanes_of(one ? first / *over->p : 0.0),
                          lanes_of(one ? second / *over->p : 0.0)};
}

/** Kicks as nearly all are: each body has its own m, and they lie side by side. */
VTI_INLINE int are_plain(struct kicks k)
{
    return k.count > 0 && k.same && k.stride == 1;
}

/** The same kicks, of which the compiler knows that they are: loops of these have no branches for all others. */
VTI_INLINE struct kicks plain(struct kicks k)
{
    k.count = k.count > 1 ? 2 : 1;
    k.same = 1;
    k.stride = 1;
    return k;
}

/** The kicks of the WIDTH bodies from i on. */
VTI_INLINE struct kicks kicks_at(struct kicks k, int64_t i)
{
    if (k.count == 0 || k.stride == 0)
        return k;
    const lanes m = lanes_of_scalars(k.m + i * k.stride, k.stride);
    k.by_first = k.first / m;
    if (k.count > 1 && !k.same)
        k.by_second = k.second / m;
    return k;
}

/** The kicks of the WIDTH bodies from i on, for which *next was made; it is made for those that follow, up to `to`. A
 *  division takes longest, and a processor looks only some hundred operations ahead: so each is begun long before what
 *  waits for it. */
VTI_INLINE struct kicks kicks_ahead(struct kicks *next, int64_t i, int64_t to)
{
    const struct kicks now = *next;
    *next = kicks_at(now, i + WIDTH < to ? i + WIDTH : i);
    return now;
}

VTI_INLINE void add_by(enum order order, lanes quotient, const lanes by[3], lanes a[3])
{
    lanes each[3] = {quotient, quotient, quotient};
    if (order == PACKED)
        lanes_spread(quotient, each);
    for (int c = 0; c < 3; ++c)
        a[c] += each[c] * by[c];
}

/** Kicks a of the WIDTH bodies from i on, which k is for. */
VTI_INLINE void kick(enum order order, struct kicks k, int64_t i, lanes a[3])
{
    lanes by[3];
    load(order, k.by, i, by);
    add_by(order, k.by_first, by, a);
    if (k.count > 1)
        add_by(order, k.same ? k.by_first : k.by_second, by, a);
}

/** Of the WIDTH bodies from i on, which k is for, a is kicked, and x += t a where x moves. */
VTI_INLINE void kick_and_move_some(enum order order, struct kicks k, double t, struct stream a, int moves,
                                   struct stream x, int64_t i)
{
    lanes v[3], place[3];
    load(order, a, i, v);
    if (k.count > 0) {
        kick(order, k, i, v);
        store(order, a, i, v);
    }
    if (!moves)
        return;
    load(order, x, i, place);
    for (int c = 0; c < 3; ++c)
        place[c] += t * v[c];
    store(order, x, i, place);
}

/** The same of all bodies. Kicks alone, which end a step, go from the last body to the first: the cache still holds the
 *  forces of the last ones, and then what the next step begins with. */
VTI_INLINE void kick_and_move_all(enum order order, struct kicks k, double t, struct stream a, int moves,
                                  struct stream x, int64_t begin, int64_t end)
{
    const int64_t stop = begin + (end - begin) / WIDTH * WIDTH;
    struct kicks next = begin < stop ? kicks_at(k, begin) : k;
    for (int64_t i = begin; moves && i < stop; i += WIDTH)
        kick_and_move_some(order, kicks_ahead(&next, i, stop), t, a, 1, x, i);
    for (int64_t i = stop; !moves && i > begin; i -= WIDTH)
        kick_and_move_some(order, kicks_at(k, i - WIDTH), t, a, 0, x, i - WIDTH);
}

VTI_INLINE void kick_and_move(enum order order, struct kicks k, double t, struct stream a, int moves, struct stream x,
                              int64_t begin, int64_t end)
{
    if (are_plain(k))
        kick_and_move_all(order, plain(k), t, a, moves, x, begin, end);
    else
        kick_and_move_all(order, k, t, a, moves, x, begin, end);
}

/** The same, body by body: of vectors whose components lie side by side, at any strides. */
VTI_INLINE void kick_and_move_each(struct kicks k, double t, struct stream a, int moves, struct stream x, int64_t begin,
                                   int64_t end)
{
    double first = lanes_get(k.by_first, 0), second = lanes_get(k.by_second, 0);
    for (int64_t i = begin; i < end; ++i) {
        double *const v = a.x + i * a.stride, *const place = x.x + i * x.stride;
        pair xy = pair_load(v);
        double z = v[2];
        if (k.stride != 0 && k.count > 0) {
            const double m = k.m[i * k.stride];
            first = k.first / m;
            second = k.same ? first : k.second / m;
        }
        for (int n = 0; n < k.count; ++n) {
            const double *const by = k.by.x + i * k.by.stride, q = n == 0 ? first : second;
            xy += q * pair_load(by);
            z += q * by[2];
        }
        if (k.count > 0) {
            pair_store(v, xy);
            v[2] = z;
        }
        if (moves) {
            pair_store(place, pair_load(place) + t * xy);
            place[2] += t * z;
        }
    }
}

/** Whichever of the two suits. */
VTI_INLINE int64_t kick_and_move_any(struct kicks k, double t, struct stream a, int moves, struct stream x,
                                     int64_t begin, int64_t end)
{
    const struct stream by = k.count > 0 ? k.by : a;
    const int order = order_with(order_with(order_of(a), x), by);
    if (order == MIXED && a.adjacent && x.adjacent && by.adjacent) {
        kick_and_move_each(k, t, a, moves, x, begin, end);
        return end;
    }
    if (order == PACKED)
        kick_and_move(PACKED, k, t, a, moves, x, begin, end);
    else if (order == SEPARATE)
        kick_and_move(SEPARATE, k, t, a, moves, x, begin, end);
    else
        return begin;
    return begin + (end - begin) / WIDTH * WIDTH;
}

/** How one loop goes through bodies that it translates and turns: so many at a time, while those so far ahead of them
 *  are prefetched, 0 for none, into the first-level cache where near, else the second. */
struct strips {
    int64_t bodies, ahead;
    int near;
};

/** The translation of a move. */
struct translation {
    struct kicks k;
    double t;
    struct stream v, x; /* x is v where it does not move */
    int moves;
    struct strips strips;
};

VTI_INLINE struct translation translation_of(const struct vti_move *move, const vti_bodies *b)
{
    const int moves = move->drifts && vti_has(&b->x);
    return (struct translation){kicks_of(move, &b->force, &b->mass), move->drift, stream_of(&b->v),
                                stream_of(moves ? &b->x : &b->v),    moves,       {0, 0, 0}};
}

VTI_INLINE struct translation with_plain_kicks(struct translation x)
{
    x.k = plain(x.k);
    return x;
}

static int64_t translate(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (end - begin < WIDTH)
        return begin;
    const struct translation s = translation_of(move, b);
    return kick_and_move_any(s.k, s.t, s.v, s.moves, s.x, begin, end);
}

#endif
