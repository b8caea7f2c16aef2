/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Which springs of friction follow a drift, and when they come and go; how they follow is in vti_spring.h (EQUATIONS
 * 6.5). As many at once as a kernel takes, in the order of the lists. */
#include "vti_carry.h"
#include "vti_friction_touches.h"
#include "../contacts/vti_touch.h"
#include "../vti_shares.h"
#include "../vti_moments.h"

/* ---- touches that wait for a kernel ------------------------------------------------------------------------------ */

/** What a drift is carried over, and the pairs, or the bodies at a wall, that wait for it. */
struct carrying {
    const vti_friction *p;
    const vti_bodies *b;
    const vti_drifted *drifted;
    int64_t wall; /* -1: pairs */
    struct vti_carried waiting;
};

/** Body i (side 0) or j (1) of touch k of those that wait; -1: a wall. */
static int64_t body_of(const struct carrying *c, int64_t k, int side)
{
    if (c->wall < 0)
        return vti_contact_body(c->p->contacts, c->waiting.which[k], side);
    return side == 0 ? c->waiting.which[k] : -1;
}

/** What touch k of those that wait holds. */
static vti_held *held_by(const struct carrying *c, int64_t k)
{
    return vti_history_find(c->p->history, 1 + body_of(c, k, 0), c->wall < 0 ? 1 + body_of(c, k, 1) : -1 - c->wall);
}

/** Increments of attitude of bodies that turn by L; beyond count, up to a whole number of lanes, the last ones
 *  again. */
static void find_turns(struct carrying *c, const vti_bodies *turning)
{
    struct vti_carried *const all = &c->waiting;
    const int at_plane = c->wall >= 0 && c->wall < c->p->walls->count;
    all->turned = 1;
    for (int64_t k = 0; k < all->count; ++k)
        for (int j = 0; j < (c->wall < 0 ? 2 : 1); ++j) {
            double a[3];
            vti_rotor_turned(turning, vti_drifted_body(c->drifted, body_of(c, k, j)), c->drifted, at_plane, a);
            for (int n = 0; n < 3; ++n)
                all->turn[3 * j + n][k] = a[n];
        }
    for (int64_t k = all->count; k % VTI_LANES_MOST != 0; ++k)
        for (int n = 0; n < 6; ++n)
            all->turn[n][k] = all->turn[n][all->count - 1];
}

static void carry(const struct carrying *c, const vti_friction *p, struct vti_carried *touches)
{
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(touches->count);
    if (c->wall < 0)
        kernels->carry(p, c->b, c->drifted, touches);
    else
        kernels->carry_at(p, c->b, c->drifted, c->wall, touches);
}

/** Touch n of those that wait alone, so that what it loses is known, and what a wall that moves takes by it. */
static void carry_one(struct carrying *c, int64_t n)
{
    const vti_friction *const p = c->p;
    struct vti_carried *const all = &c->waiting;
    struct vti_carried one = {.count = 1, .turned = all->turned};
    vti_sum lost[VTI_FRICTION_BOOKS] = {{0.0, 0.0}}, work = {0.0, 0.0};
    const vti_walls none = {.count = 0};
    vti_walls walls = p->walls != NULL ? *p->walls : none;
    vti_friction own = *p;
    const int by_pair = c->wall < 0 && p->by_pair != NULL;
    own.lost = lost;
    own.walls = &walls;
    walls.work = &work;
    one.which[0] = all->which[n];
    one.held[0] = all->held[n];
    for (int turn = 0; turn < 6 && all->turned; ++turn)
        for (int lane = 0; lane < VTI_LANES_MOST; ++lane)
            one.turn[turn][lane] = all->turn[turn][n];
    carry(c, &own, &one);
    all->delta[n] = one.delta[0];
    vti_share_out(lost, VTI_FRICTION_BOOKS, p->lost, by_pair ? NULL : p->by_body, body_of(c, n, 0), body_of(c, n, 1));
    for (int m = 0; m < VTI_FRICTION_BOOKS && by_pair; ++m)
        p->by_pair[VTI_FRICTION_BOOKS * all->which[n] + m] = lost[m].high;
    if (c->wall >= 0 && p->walls != NULL && p->walls->motion != NULL)
        vti_share_out(&work, 1, p->walls->work, p->walls->by_body, body_of(c, n, 0), -1);
}

/** Whether somebody asks what each touch loses, or takes from walls. */
static int tells(const struct carrying *c)
{
    return c->p->by_body != NULL || (c->wall < 0 ? c->p->by_pair != NULL : c->p->walls->by_body != NULL);
}

/** Carries the springs of those that wait; those that have parted leave the history. */
static void carry_waiting(struct carrying *c)
{
    const int64_t count = c->waiting.count;
    const vti_bodies *const turning = vti_drifted_bodies(c->drifted, c->b);
    if (count > 0 && vti_spins_generally(turning))
        find_turns(c, turning);
    for (int64_t n = 0; tells(c) && n < count; ++n)
        carry_one(c, n);
    if (!tells(c) && count > 0)
        carry(c, c->p, &c->waiting);
    for (int64_t k = 0; k < count; ++k) {
        vti_held *const parted = c->waiting.delta[k] <= 0.0 ? held_by(c, k) : NULL; /* others have moved */
        if (parted != NULL)                                                         /* a list may name a pair twice */
            vti_history_remove(c->p->history, parted);
    }
    c->waiting.count = 0;
}

/** A pair, or a body at the wall, that holds something or, where held is NULL, begins to. */
static void enlist(struct carrying *c, int64_t which, int64_t i, int64_t j, vti_held *held)
{
    vti_history *const history = c->p->history;
    if (held == NULL)
        held = vti_history_begin(history, i, j);
    if (held == NULL) { /* those that part make room */
        carry_waiting(c);
        held = vti_history_begin(history, i, j);
    }
    if (held == NULL) {
        ++history->missed;
        return;
    }
    c->waiting.which[c->waiting.count] = which;
    c->waiting.held[c->waiting.count] = held;
    if (++c->waiting.count == VTI_TOUCHES)
        carry_waiting(c);
}

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** Whether a pair that holds nothing and touches was within reach before the drift: lists need not have it else. */
static int was_near(const struct carrying *c, int64_t k)
{
    struct vti_carry motion = {.delta0 = 0.0};
    double v_i[3], v_j[3], d0[3];
    (void)vti_touch_pair(&motion.touch, c->p->contacts, c->b, k, INFINITY); /* there is a direction */
    vti_load(&c->b->v, motion.touch.i, v_i);
    vti_load(&c->b->v, motion.touch.j, v_j);
    for (int n = 0; n < 3; ++n)
        v_i[n] = c->drifted->t * (v_i[n] - v_j[n]);
    vti_carry_apart(&motion, v_i, d0);
    return motion.delta0 >= -c->p->reach;
}

/** A pair, if it touches or holds something: its springs begin where it does. Returns 1 if what it holds does not stand
 *  at next. */
static int carry_pair(struct carrying *c, int64_t k, int touches, int64_t *next)
{
    const int64_t there = *next;
    vti_held *const held = vti_friction_held(c->p, k, next);
    if (held != NULL || (touches && was_near(c, k)))
        enlist(c, k, 1 + vti_contact_body(c->p->contacts, k, 0), 1 + vti_contact_body(c->p->contacts, k, 1), held);
    return held != NULL && *next != there + 1;
}

/** What pairs hold comes into the order of the list, before all else. */
static void order(const vti_friction *p)
{
    vti_history *const t = p->history;
    int64_t k = 0, next = 0;
    for (int64_t n = 0; n < p->contacts->count; ++n) {
        vti_held *const held = vti_friction_held(p, n, &next);
        if (held == NULL || held - t->held < k) /* named before */
            continue;
        if (held - t->held > k)
            vti_history_swap(t, k, held);
        next = ++k;
    }
}

static void carry_pairs(struct carrying *c)
{
    const vti_contacts *const list = c->p->contacts;
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(list->count);
    int64_t pair[VTI_TOUCHES], next = 0, astray = 0;
    for (int64_t first = 0; first < list->count; first += VTI_TOUCHES) {
        const int64_t left = list->count - first, most = left < VTI_TOUCHES ? left : VTI_TOUCHES,
                      found = kernels->near(list, c->b, c->p->reach, first, most, pair);
        for (int64_t n = 0; n < found; ++n)
            astray += carry_pair(c, vti_touch_number(pair[n]), pair[n] >= 0, &next);
    }
    carry_waiting(c);
    if (astray > c->p->history->used / 8)
        order(c->p);
}

/* ---- at walls ---------------------------------------------------------------------------------------------------- */

/** A body at the wall, likewise. */
static void carry_body(struct carrying *c, int64_t i)
{
    vti_held *const held = vti_history_find(c->p->history, 1 + i, -1 - c->wall);
    struct vti_touch touch;
    if (held != NULL || (vti_touch_wall(&touch, c->p->walls, c->b, c->wall, i, 0.0) && touch.delta > 0.0))
        enlist(c, i, 1 + i, -1 - c->wall, held);
}

/** Of a wall the bodies in their order. */
static void carry_wall(struct carrying *c, int64_t w)
{
    const int64_t end = c->b->first + c->b->count;
    c->wall = w;
    for (int64_t first = c->b->first; first < end; first += VTI_TOUCHES) {
        const int64_t count = end - first < VTI_TOUCHES ? end - first : VTI_TOUCHES;
        uint64_t bodies =
            vti_touch_kernels_for(count)->near_wall(c->p->walls, c->b, c->p->reach, c->drifted->t, w, first, count);
        for (; bodies != 0; bodies &= bodies - 1)
            carry_body(c, first + vti_first_bit(bodies));
    }
    carry_waiting(c);
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

void vti_friction_carry(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    const vti_friction *p = self;
    struct carrying c = {.p = p, .b = b, .drifted = drifted, .wall = -1};
    for (int64_t k = 0; p->by_pair != NULL && p->contacts != NULL && k < VTI_FRICTION_BOOKS * p->contacts->count; ++k)
        p->by_pair[k] = 0.0;
    if (p->contacts != NULL)
        carry_pairs(&c);
    for (int64_t w = 0; w < vti_faces(p->walls); ++w)
        carry_wall(&c, w);
}
