/* SPDX-License-Identifier: BSD-3-Clause
 * Bonds whose bodies have turned past half a turn against each other: there the moment of a bond changes its side,
 * which a binder does not. Attitudes alone do not show it; one has to follow them. */
#include "binder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "far.h"
#include "inertia.h"
#include "threads.h"

static double stiffness(const vti_bonds *bonds, int64_t k)
{
    const vti_scalars *moment = &bonds->moment;
    return moment->p != NULL ? moment->p[k * moment->stride] : 0.0;
}

static struct bond_turns *turns_of(const struct effect *e)
{
    return &((struct binder_self *)e->self)->turns;
}

/** Those that hold: one that has broken has no moment. */
static const vti_bonds *bonds_of(const struct bond_turns *b)
{
    return &b->binder->bonds;
}

/** What is known of the bond at place k of the list. */
static double *pair_of(const struct bond_turns *b, int64_t k)
{
    return b->pair + 4 * binder_number(b->binder, k);
}

static int start(struct effect *e)
{
    const double half_pi_squared = 4.9348022005446793;
    const vti_bonds *bonds = &((struct binder_self *)e->self)->bonds;
    struct bond_turns *b = turns_of(e);
    const struct bond_turns made = {e->self, INFINITY, 0.0, 1.0, 0.0, 0.0, 0, NULL};
    free(b->pair);
    *b = made;
    for (int64_t k = 0; k < bonds->count; ++k)
        if (stiffness(bonds, k) > 0.0)
            b->least = fmin(b->least, half_pi_squared * stiffness(bonds, k));
    if (binder_touches(e->self) && bonds->moment.p != NULL) /* one for all, of bonds that are still to come, too */
        b->least = half_pi_squared * *bonds->moment.p;
    if (!isfinite(b->least))
        return 0;
    const int64_t room = binder_touches(e->self) ? b->binder->touch.room : b->binder->all;
    b->pair = calloc((size_t)(4 * room), sizeof *b->pair);
    return b->pair != NULL ? 0 : -1;
}

static void end(struct effect *e)
{
    struct bond_turns *b = turns_of(e);
    free(b->pair);
    b->pair = NULL;
}

/** r = (v, w) of p q^-1, q of any length. */
static void quotient(const double p[4], const double q[4], double r[4])
{
    double cross[3];
    vti_cross(p, q, cross);
    for (int c = 0; c < 3; ++c)
        r[c] = p[c] * q[3] - p[3] * q[c] - cross[c];
    r[3] = vti_dot(p, q) + p[3] * q[3];
}

/** (v, w) of R_i Q0 R_j^T; its sign means nothing. */
static void relative(const struct bond_turns *b, const vti_bodies *bodies, int64_t k, double r[4])
{
    const double *turn = bonds_of(b)->turn;
    double q[2][4], turned[4];
    for (int c = 0; c < 2; ++c) {
        const vti_view *a = &bodies->alpha;
        const int64_t joined = bonds_of(b)->pair[2 * k + c] - bonds_of(b)->base;
        const int64_t at = (b->binder->body != NULL ? b->binder->body[joined] : joined) * a->stride;
        const double alpha[3] = {a->c[0][at], a->c[1][at], a->c[2][at]};
        vti_rrv_to_pair(alpha, q[c]);
    }
    if (turn != NULL)
        quotient(q[1], turn + 4 * k, turned);
    quotient(q[0], turn != NULL ? turned : q[1], r);
}

static int is_marked(const double *pair)
{
    return pair[0] == 0.0 && pair[1] == 0.0 && pair[2] == 0.0 && pair[3] == 0.0;
}

static double least_inertia(const vti_bodies *b)
{
    double least = INFINITY;
    for (int64_t i = b->first; i < b->first + b->count; ++i)
        least = fmin(least, inertia_least(b, i));
    return least;
}

/** Steps in which no two bodies turn by more than 120 degrees against each other, with twice the energy E of now
 *
 *      h (|Omega_i| + |Omega_j|) <= h (2 |Omega_i|^2 + 2 |Omega_j|^2)^{1/2} <= h (8 E/J)^{1/2}
 *
 *  but few, as rows may be far apart and walls may stir bodies in between. */
static double steps_between(const vti_bodies *bodies, double energy, double h)
{
    const double third_turn = 2.0943951023931953, most = 16.0;
    const double steps = third_turn / (h * sqrt(8.0 * energy / least_inertia(bodies)));
    return steps >= 1.0 ? fmin(floor(steps), most) : 1.0;
}

/** Looks whether bonds can get there at all: they cannot while twice the energy of the motion and of the springs is
 *  below what it takes. */
static void row(struct effect *e, const vti_bodies *bodies, double energy, double h)
{
    struct bond_turns *b = turns_of(e);
    const int was = b->watching != 0.0, fresh = b->turned == 0.0;
    if (b->pair == NULL)
        return;
    b->watching = !(2.0 * energy < b->least);
    b->every = b->watching != 0.0 ? steps_between(bodies, energy, h) : 1.0;
    b->left = fmin(b->left, b->every - 1.0);
    b->are_near = b->are_near && was;
    for (int64_t k = 0; b->watching != 0.0 && !was && k < bonds_of(b)->count; ++k) {
        double *pair = pair_of(b, k);
        if (stiffness(bonds_of(b), k) == 0.0 || (!fresh && is_marked(pair)))
            continue;
        relative(b, bodies, k, pair);
        for (int c = 0; c < 4 && pair[3] < 0.0; ++c)
            pair[c] = c < 3 ? -pair[c] : pair[c];
        pair[3] = fabs(pair[3]);
    }
}

/** Follows bond k; returns 1 if it has turned past half a turn just now. */
static int follow(const struct bond_turns *b, const vti_bodies *bodies, int64_t k)
{
    double now[4], *pair = pair_of(b, k);
    if (is_marked(pair))
        return 0;
    relative(b, bodies, k, now);
    const double side = vti_dot(now, pair) + now[3] * pair[3] < 0.0 ? -1.0 : 1.0;
    for (int c = 0; c < 4; ++c)
        pair[c] = side * now[c];
    if (!(pair[3] < 0.0))
        return 0;
    memset(pair, 0, 4 * sizeof *pair);
    return 1;
}

/** Whether the bodies of bond k are turned by less than 30 degrees against each other, w^2 > cos^2(15) |q_i|^2 |q_j|^2
 *  with w = 4 + alpha_i.alpha_j of pairs (alpha, 2). Not of numbers so large that squares overflow: inf > inf is
 *  false. */
static inline int is_near(const vti_bonds *bonds, const vti_view *alpha, int64_t k)
{
    const int64_t i = (bonds->pair[2 * k] - bonds->base) * alpha->stride,
                  j = (bonds->pair[2 * k + 1] - bonds->base) * alpha->stride;
    const double a[3] = {alpha->c[0][i], alpha->c[1][i], alpha->c[2][i]},
                 b[3] = {alpha->c[0][j], alpha->c[1][j], alpha->c[2][j]};
    const double w = 4.0 + vti_dot(a, b);
    return w * w > 0.9331 * ((4.0 + vti_dot(a, a)) * (4.0 + vti_dot(b, b)));
}

struct following {
    const struct bond_turns *turns;
    const vti_bodies *bodies;
    int64_t parts;
};

/** A bond that is near where it began is known to be on that side without its last place, at a fifth of the price: from
 *  there to past half a turn, or the way around, it is 150 degrees, which no step takes that follows the motion, nor do
 *  the steps between two looks. Returns how many have turned. */
static int64_t follow_part(void *self, int64_t part)
{
    static const double unturned[4] = {0.0, 0.0, 0.0, 1.0};
    const struct following *f = self;
    const vti_bonds bonds = *bonds_of(f->turns);
    const vti_view alpha = f->bodies->alpha;
    const int64_t last = threads_begin(bonds.count, part + 1, f->parts);
    int64_t turned = 0;
    for (int64_t k = threads_begin(bonds.count, part, f->parts); k < last; ++k) {
        double *pair = pair_of(f->turns, k);
        if (bonds.turn != NULL || !is_near(&bonds, &alpha, k))
            turned += follow(f->turns, f->bodies, k);
        else if (pair[3] != 0.0 || !is_marked(pair))
            memcpy(pair, unturned, sizeof unturned);
    }
    return turned;
}

/** 1 if some body of a part is turned by 15 degrees, |alpha| > 2 tan(7.5): two others are not by 30 against each
 *  other. */
static int64_t part_is_turned(void *self, int64_t part)
{
    static const double limit = 0.0693, none[3];
    const struct following *f = self;
    const vti_bodies *const b = f->bodies;
    return far_any(&b->alpha, b->first + threads_begin(b->count, part, f->parts),
                   b->first + threads_begin(b->count, part + 1, f->parts), NULL, none, limit);
}

static void step(struct effect *e, const vti_bodies *bodies)
{
    struct bond_turns *b = turns_of(e);
    struct following following = {b, bodies, threads_used()};
    if (b->pair == NULL || b->watching == 0.0 || b->left-- > 0.0)
        return;
    const int were_near = b->are_near;
    b->are_near = bonds_of(b)->turn == NULL && threads_sum(following.parts, part_is_turned, &following) == 0;
    if (!(were_near && b->are_near))
        b->turned += (double)threads_sum(following.parts, follow_part, &following);
    b->left = b->every - 1.0;
}

static int64_t turned(const struct effect *e)
{
    return (int64_t)turns_of(e)->turned;
}

/** How many numbers of bonds are kept here: of bonds that are made as the run goes on, none; they keep them. */
static int64_t kept(const struct bond_turns *b)
{
    return binder_touches(b->binder) ? 0 : 4 * b->binder->all;
}

static int64_t size(const struct effect *e)
{
    const struct bond_turns *b = turns_of(e);
    return b->pair != NULL ? 4 + kept(b) : 0;
}

static void give(const struct effect *e, struct sink *sink)
{
    const struct bond_turns *b = turns_of(e);
    const double numbers[] = {b->watching, b->every, b->left, b->turned};
    if (b->pair == NULL)
        return;
    sink->add(sink, numbers, sizeof numbers / sizeof *numbers);
    sink->add(sink, b->pair, kept(b));
}

static void put(struct effect *e, const double *state)
{
    struct bond_turns *b = turns_of(e);
    if (b->pair == NULL)
        return;
    b->watching = state[0];
    b->every = state[1];
    b->left = state[2];
    b->turned = state[3];
    b->are_near = 0;
    memcpy(b->pair, state + 4, sizeof *b->pair * (size_t)kept(b));
}

const struct effect_watch binder_watch = {start, end, row, step, turned, size, give, put};
