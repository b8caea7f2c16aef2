/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Which springs of friction follow a drift, and when they come and go; how they follow is in vti_spring.h (EQUATIONS
 * 6.5). As many at once as a kernel takes, in the order of the lists. */
#include "vti_carry.h"
#include "vti_friction_touches.h"
#include "../vti_shares.h"

/** The slot of a touch that holds something or begins to; NULL if there is no room. */
static vti_held *hold(vti_history *history, int64_t i, int64_t j)
{
    vti_held *held = vti_history_at(history, i, j);
    const vti_held none = {i, j, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0};
    if (held->i != 0)
        return held;
    if (history->used + 1 >= history->slots)
        return NULL;
    *held = none;
    ++history->used;
    return held;
}

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** What a drift is carried over, and the pairs that wait for it, as many at once as a kernel takes. */
struct carrying {
    const vti_friction *p;
    const vti_bodies *b;
    const vti_drifted *drifted;
    struct vti_carried pairs;
};

/** Increments of attitude of bodies that turn by L; beyond count, up to a whole number of lanes, the last ones again. */
static void find_turns(struct carrying *c, const vti_bodies *turning)
{
    struct vti_carried *pairs = &c->pairs;
    pairs->turned = 1;
    for (int64_t k = 0; k < pairs->count; ++k)
        for (int j = 0; j < 2; ++j) {
            double a[3];
            const int64_t i = vti_contact_body(c->p->contacts, pairs->pair[k], j);
            vti_rotor_turned(turning, vti_drifted_body(c->drifted, i), c->drifted, 0, a);
            for (int n = 0; n < 3; ++n)
                pairs->turn[3 * j + n][k] = a[n];
        }
    for (int64_t k = pairs->count; k % VTI_LANES_MOST != 0; ++k)
        for (int n = 0; n < 6; ++n)
            pairs->turn[n][k] = pairs->turn[n][pairs->count - 1];
}

/** The springs of the pairs that wait one by one, so that what each loses is known. */
static void carry_singly(struct carrying *c)
{
    const vti_friction *p = c->p;
    struct vti_carried *const all = &c->pairs;
    struct vti_carried one = {.count = 1, .turned = all->turned};
    vti_friction own = *p;
    for (int64_t n = 0; n < all->count; ++n) {
        const int64_t k = all->pair[n];
        vti_sum lost[VTI_FRICTION_BOOKS] = {{0.0, 0.0}};
        own.lost = lost;
        one.pair[0] = k;
        one.held[0] = all->held[n];
        for (int turn = 0; turn < 6 && all->turned; ++turn)
            for (int lane = 0; lane < VTI_LANES_MOST; ++lane)
                one.turn[turn][lane] = all->turn[turn][n];
        vti_touch_kernels_for(1)->carry(&own, c->b, c->drifted, &one);
        all->delta[n] = one.delta[0];
        vti_share_out(lost, VTI_FRICTION_BOOKS, p->lost, p->by_pair == NULL ? p->by_body : NULL,
                      vti_contact_body(p->contacts, k, 0), vti_contact_body(p->contacts, k, 1));
        for (int m = 0; m < VTI_FRICTION_BOOKS && p->by_pair != NULL; ++m)
            p->by_pair[VTI_FRICTION_BOOKS * k + m] = lost[m].high;
    }
}

/** Carries the springs of the pairs that wait; those that have parted leave the table. */
static void carry_waiting(struct carrying *c)
{
    struct vti_carried *pairs = &c->pairs;
    const int64_t count = pairs->count;
    const vti_bodies *const turning = vti_drifted_bodies(c->drifted, c->b);
    if (count > 0 && vti_turns_by_spin(turning))
        find_turns(c, turning);
    if (count > 0 && (c->p->by_body != NULL || c->p->by_pair != NULL))
        carry_singly(c);
    else if (count > 0)
        vti_touch_kernels_for(count)->carry(c->p, c->b, c->drifted, pairs);
    for (int64_t k = 0; k < count; ++k)
        if (pairs->delta[k] <= 0.0)
            vti_history_remove(c->p->history, vti_friction_slot(c->p, pairs->pair[k]));
    pairs->count = 0;
}

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

/** A pair, if it touches or holds something: its springs begin where it does. */
static void carry_pair(struct carrying *c, int64_t k, int touches)
{
    vti_history *const history = c->p->history;
    vti_held *held = vti_friction_slot(c->p, k);
    if (held->i == 0 && !(touches && was_near(c, k)))
        return;
    if (held->i == 0) {
        const int64_t i = 1 + vti_contact_body(c->p->contacts, k, 0), j = 1 + vti_contact_body(c->p->contacts, k, 1);
        held = hold(history, i, j);
        if (held == NULL) { /* pairs that part make room */
            carry_waiting(c);
            held = hold(history, i, j);
        }
    }
    if (held == NULL) {
        ++history->missed;
        return;
    }
    c->pairs.pair[c->pairs.count] = k;
    c->pairs.held[c->pairs.count] = held;
    if (++c->pairs.count == VTI_TOUCHES)
        carry_waiting(c);
}

static void carry_pairs(struct carrying *c)
{
    const vti_contacts *const list = c->p->contacts;
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(list->count);
    int64_t pair[VTI_TOUCHES];
    for (int64_t first = 0; first < list->count; first += VTI_TOUCHES) {
        const int64_t left = list->count - first, most = left < VTI_TOUCHES ? left : VTI_TOUCHES,
                      found = kernels->near(list, c->b, c->p->reach, first, most, pair);
        for (int64_t n = 0; n < found; ++n)
            carry_pair(c, vti_touch_number(pair[n]), pair[n] >= 0);
    }
    carry_waiting(c);
}

/* ---- at walls ---------------------------------------------------------------------------------------------------- */

/** What a drift is carried over at walls, and the bodies there that wait for it. */
struct carrying_at {
    const struct carrying *c;
    struct vti_carried_at at;
};

static void put(struct vti_carried_at *at, int column, double a)
{
    at->column[column][at->count] = a;
}

static void put_vector(struct vti_carried_at *at, int column, const double a[3])
{
    for (int k = 0; k < 3; ++k)
        put(at, column + k, a[k]);
}

/** Entry m of what the springs of body i take, and of what a wall that moves puts in. */
static void book_at(const vti_friction *p, const struct vti_carried_at *at, int64_t i, int m, int64_t k)
{
    const double lost = at->column[VTI_AT_LOST + m][k], worked = at->column[VTI_AT_WORKED + m][k];
    vti_sum_add(&p->lost[m], lost);
    if (p->by_body != NULL)
        vti_share(p->by_body, VTI_FRICTION_BOOKS, m, i, -1, lost);
    if (!at->moves)
        return;
    vti_sum_add(p->walls->work, worked);
    if (p->walls->by_body != NULL)
        vti_share(p->walls->by_body, 1, 0, i, -1, worked);
}

/** Carries the springs of those that wait; of those that have parted they leave the table. */
static void carry_waiting_at(struct carrying_at *w)
{
    struct vti_carried_at *const at = &w->at;
    vti_history *const history = w->c->p->history;
    const double coefficient[VTI_FRICTION_BOOKS] = {w->c->p->sliding, w->c->p->rolling, w->c->p->twisting};
    const int64_t count = at->count;
    int64_t of[VTI_TOUCHES][2];
    if (count == 0)
        return;
    for (int64_t k = count; k % VTI_LANES_MOST != 0; ++k)
        for (int column = 0; column < VTI_AT_LOST; ++column)
            at->column[column][k] = at->column[column][count - 1];
    vti_touch_kernels_for(count)->carry_at(w->c->p, at);
    for (int64_t k = 0; k < count; ++k) {
        of[k][0] = at->held[k]->i;
        of[k][1] = at->held[k]->j;
        for (int m = 0; m < VTI_FRICTION_BOOKS; ++m)
            if (coefficient[m] > 0.0)
                book_at(w->c->p, at, of[k][0] - 1, m, k);
    }
    for (int64_t k = 0; k < count; ++k) /* which moves others */
        if (at->column[VTI_AT_DELTA][k] <= 0.0)
            vti_history_remove(history, vti_history_at(history, of[k][0], of[k][1]));
    at->count = 0;
}

/** A body at a wall, where it touches or holds something. */
static void wait_at_wall(struct carrying_at *w, const struct vti_touch *touch, vti_held *held)
{
    const struct carrying *const c = w->c;
    struct vti_carried_at *const at = &w->at;
    struct vti_carry motion = {.touch = *touch};
    double d0[3], a_i[3], a_j[3];
    vti_carry_motion(&motion, c->p->walls, c->b, c->drifted, d0, a_i, a_j);
    at->held[at->count] = held;
    at->moves = touch->moves;
    put_vector(at, VTI_AT_N, touch->n);
    put(at, VTI_AT_R, touch->r);
    put(at, VTI_AT_DELTA, touch->delta);
    put(at, VTI_AT_LENGTH, touch->length);
    put(at, VTI_AT_STIFFNESS, touch->stiffness);
    put(at, VTI_AT_SLIDING, vti_friction_of_wall(c->p, touch->wall));
    put_vector(at, VTI_AT_N0, motion.n0);
    put_vector(at, VTI_AT_D0, d0);
    put(at, VTI_AT_DELTA0, motion.delta0);
    put_vector(at, VTI_AT_SLID, motion.slid);
    put_vector(at, VTI_AT_DRAGGED, motion.dragged);
    put_vector(at, VTI_AT_TURN_I, a_i);
    put_vector(at, VTI_AT_TURN_J, a_j);
    if (++at->count == VTI_TOUCHES)
        carry_waiting_at(w);
}

/** Body i, with the walls in their order. */
static void carry_at_walls(struct carrying_at *at, int64_t i)
{
    const vti_friction *const p = at->c->p;
    struct vti_touch touch;
    for (int64_t w = 0; w < vti_faces(p->walls); ++w) {
        if (!vti_touch_wall(&touch, p->walls, at->c->b, w, i, INFINITY))
            continue;
        if (touch.delta <= 0.0 && vti_history_find(p->history, i + 1, -1 - w) == NULL)
            continue;
        vti_held *held = hold(p->history, i + 1, -1 - w);
        if (held == NULL) { /* those that part make room */
            carry_waiting_at(at);
            held = hold(p->history, i + 1, -1 - w);
        }
        if (held == NULL)
            ++p->history->missed;
        else
            wait_at_wall(at, &touch, held);
    }
}

/** Bodies one after the other. */
static void carry_walls(const struct carrying *c)
{
    const int64_t end = vti_faces(c->p->walls) > 0 ? c->b->first + c->b->count : c->b->first;
    struct carrying_at at;
    at.c = c;
    at.at.count = 0;
    for (int64_t first = c->b->first; first < end; first += VTI_TOUCHES) {
        uint64_t bodies = vti_friction_near_walls(c->p, c->b, c->p->reach, c->drifted->t, first);
        for (int64_t i = first; bodies != 0; ++i, bodies >>= 1)
            if (bodies & 1)
                carry_at_walls(&at, i);
    }
    carry_waiting_at(&at);
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

void vti_friction_carry(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    const vti_friction *p = self;
    struct carrying c = {.p = p, .b = b, .drifted = drifted};
    for (int64_t k = 0; p->by_pair != NULL && p->contacts != NULL && k < VTI_FRICTION_BOOKS * p->contacts->count; ++k)
        p->by_pair[k] = 0.0;
    if (p->contacts != NULL)
        carry_pairs(&c);
    carry_walls(&c);
}
