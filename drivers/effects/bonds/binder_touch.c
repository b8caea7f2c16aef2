/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds that are made where bodies touch: at the end of the step, after what breaks, each pair of spheres in contact
 * that has had no bond gets one that is at rest as they are then (EQUATIONS 6.6), as long as the scene has bonds
 * made. It holds no energy, and the contact inside it stays, so that neither loads nor energy jump. Pairs come in
 * ascending order: numbers of bonds depend on the motion alone. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "binder.h"
#include "partings.h"

/** Numbers of a bond that a run goes on with: i, j, rest, turn, when it was made and broke, and how it has turned. */
enum { REST = 4, TURN = 4, KEPT_MADE = 2 + REST + TURN, KEPT_BROKE, KEPT_PAIR, KEPT = KEPT_PAIR + 4 };

/* ---- room for them ----------------------------------------------------------------------------------------------- */

/** *p with room for so many of size bytes, which keeps what it has. Returns 0 if there is none. */
static int resize(void *p, int64_t n, size_t size)
{
    void *old, *moved;
    memcpy(&old, p, sizeof old);
    moved = realloc(old, (size_t)n * size);
    if (moved != NULL)
        memcpy(p, &moved, sizeof moved);
    return moved != NULL; /* cppcheck-suppress memleak ; *p has it */
}

/** Room for so many bonds in all of their arrays. Returns 0, or -1: room is as it was, and what there is is kept. */
static int grow(struct binder_self *self, int64_t room)
{
    struct bond_break *b = &self->breaking;
    if (room <= self->touch.room)
        return 0;
    const int grown = resize(&self->pair, 2 * room, sizeof *self->pair) &&
                      resize(&self->memory, REST * room, sizeof(double)) &&
                      resize(&self->touch.turn, TURN * room, sizeof(double)) && resize(&b->id, room, sizeof *b->id) &&
                      resize(&b->ends, 2 * room, sizeof *b->ends) && resize(&b->memory, room, sizeof(double)) &&
                      resize(&b->made, room, sizeof(double)) && resize(&self->touch.known, 2 * room, sizeof(int64_t)) &&
                      (self->turns.pair == NULL || resize(&self->turns.pair, 4 * room, sizeof(double)));
    self->bonds.pair = self->pair; /* some have moved, even if one has not */
    self->bonds.rest = self->memory;
    self->bonds.turn = self->touch.turn;
    b->broke = b->memory;
    b->rupture.id = b->id;
    if (!grown)
        return -1;
    self->touch.room = room;
    return 0;
}

int binder_make_none(struct effect *e, const struct model *model, struct message *message)
{
    enum { FIRST = 16 };
    const struct binder_settings *settings = e->settings;
    struct binder_self *self = e->self;
    struct bond_break *b = &self->breaking;
    vti_scalars *const to[] = {&self->bonds.moment, &self->bonds.axial, &self->bonds.shear};
    const int64_t bodies = model->bodies.count;
    b->root = calloc((size_t)bodies + 1, sizeof *b->root);
    self->touch.meet = calloc((size_t)bodies + 1, sizeof *self->touch.meet);
    if (b->root == NULL || self->touch.meet == NULL || grow(self, FIRST) != 0)
        return message_set(message, "%s: out of memory for its bonds; use fewer bodies", model->scene->name);
    b->bodies = bodies;
    for (int k = 0; k < 3; ++k)
        if (settings->stiffness[k] != 0.0)
            *to[k] = vti_scalars_one(&settings->stiffness[k]);
    self->bonds.shear_form = binder_shear(settings);
    binder_take_limits(e, NULL);
    return 0;
}

void binder_free_touch(struct bond_touch *touch)
{
    free(touch->turn);
    free(touch->known);
    free(touch->meet);
}

/* ---- which pairs have had one ------------------------------------------------------------------------------------ */

static int compare(const void *a, const void *b)
{
    const int64_t *p = a, *q = b;
    const int k = p[0] == q[0];
    return (p[k] > q[k]) - (p[k] < q[k]);
}

static void sort_known(struct binder_self *self)
{
    qsort(self->touch.known, (size_t)self->all, 2 * sizeof *self->touch.known, compare);
}

/** Whether a pair is among the count that are known, which *at has gone through up to it: pairs ascend. */
static int is_known(const struct bond_touch *touch, int64_t count, const int64_t pair[2], int64_t *at)
{
    while (*at < count && compare(touch->known + 2 * *at, pair) < 0)
        ++*at;
    return *at < count && compare(touch->known + 2 * *at, pair) == 0;
}

/* ---- making ------------------------------------------------------------------------------------------------------ */

/** What has left the list stands behind it: what is there first moves to the end, and leaves its place. */
static void move_to_end(struct binder_self *self)
{
    const int64_t from = self->bonds.count, to = self->all;
    if (from == to)
        return;
    memcpy(self->pair + 2 * to, self->pair + 2 * from, 2 * sizeof *self->pair);
    memcpy(self->memory + REST * to, self->memory + REST * from, REST * sizeof(double));
    memcpy(self->touch.turn + TURN * to, self->touch.turn + TURN * from, TURN * sizeof(double));
    self->breaking.id[to] = self->breaking.id[from];
}

/** A bond behind those that hold, with the number that comes next. Returns 0, or -1 with one line in *message. */
static int make_bond(struct binder_self *self, const vti_bodies *bodies, const int64_t pair[2], int64_t step,
                     struct message *message)
{
    struct bond_break *b = &self->breaking;
    const int64_t place = self->bonds.count, number = self->all;
    vti_fault fault;
    if (number == self->touch.room && grow(self, 2 * number) != 0)
        return message_set(message, "binder: out of memory for more than %lld bonds; use fewer bodies",
                           (long long)number);
    move_to_end(self);
    memcpy(self->pair + 2 * place, pair, 2 * sizeof *pair);
    const int status =
        vti_bonds_rest_now(1, pair, 0, bodies, self->memory + REST * place, self->touch.turn + TURN * place, &fault);
    if (status != VTI_OK)
        return message_set(message, "binder: bodies %lld and %lld: %s", (long long)pair[0], (long long)pair[1],
                           vti_status_text(status));
    memcpy(b->ends + 2 * number, pair, 2 * sizeof *pair);
    memcpy(self->touch.known + 2 * number, pair, 2 * sizeof *pair);
    b->id[place] = number;
    b->made[number] = (double)step;
    b->broke[number] = INFINITY;
    for (int c = 0; self->turns.pair != NULL && c < 4; ++c)
        self->turns.pair[4 * number + c] = c == 3;
    b->holding = ++self->bonds.count;
    self->all = number + 1;
    return 0;
}

/** Where bodies touch: the contact of the model, whose list is that of the bodies as they are. */
static int find_contacts(struct model *model, const vti_contacts **contacts)
{
    const int status = model_find_pairs(model, &model->bodies);
    *contacts = model_surfaces(model).contacts;
    return status;
}

/** How many bonds hold each body. */
static void count_meeting(struct binder_self *self)
{
    memset(self->touch.meet, 0, (size_t)self->breaking.bodies * sizeof *self->touch.meet);
    for (int64_t k = 0; k < 2 * self->bonds.count; ++k)
        ++self->touch.meet[self->pair[k]];
}

/** Whether bonds are made at the end of a step at t, a product that may be off by its rounding. */
static int in_window(const struct binder_settings *settings, double t)
{
    const double rounding = 4.0 * DBL_EPSILON * t;
    return t >= settings->from - rounding && t <= settings->until + rounding;
}

int64_t binder_join(struct effect *e, struct model *model, int64_t step, double t, struct message *message)
{
    struct binder_self *self = e->self;
    const struct binder_settings *settings = e->settings;
    const int64_t most = settings->most, before = self->all;
    const vti_contacts *contacts = NULL;
    int64_t at = 0;
    if (!binder_touches(self) || !in_window(settings, t))
        return 0;
    if (find_contacts(model, &contacts) != VTI_OK || contacts == NULL)
        return -1;
    if (most > 0)
        count_meeting(self);
    for (int64_t k = 0; k < contacts->count; ++k) {
        const int64_t *pair = contacts->pair + 2 * k, i = pair[0], j = pair[1];
        int64_t *meet = self->touch.meet;
        if (!(partings_distance(&model->bodies.x, i, j) < partings_touching(&contacts->diameter, i, j)) ||
            is_known(&self->touch, before, pair, &at) || (most > 0 && (meet[i] >= most || meet[j] >= most)))
            continue;
        if (make_bond(self, &model->bodies, pair, step, message) != 0)
            return -1;
        ++meet[i];
        ++meet[j];
    }
    if (self->all > before) {
        sort_known(self);
        ++self->breaking.changes;
    }
    return self->all - before;
}

/* ---- what a run goes on with ------------------------------------------------------------------------------------- */

int64_t binder_touch_size(const struct effect *e)
{
    return 1 + KEPT * ((const struct binder_self *)e->self)->all;
}

void binder_touch_get(const struct effect *e, double *memory)
{
    const struct binder_self *self = e->self;
    const struct bond_break *b = &self->breaking;
    *memory++ = (double)self->all;
    for (int64_t k = 0; k < self->all; ++k) {
        const int64_t m = b->id[k];
        double *to = memory + KEPT * m;
        to[0] = (double)self->pair[2 * k];
        to[1] = (double)self->pair[2 * k + 1];
        memcpy(to + 2, self->memory + REST * k, REST * sizeof *to);
        memcpy(to + 2 + REST, self->touch.turn + TURN * k, TURN * sizeof *to);
        to[KEPT_MADE] = b->made[m];
        to[KEPT_BROKE] = b->broke[m];
        for (int c = 0; c < 4; ++c)
            to[KEPT_PAIR + c] = self->turns.pair != NULL ? self->turns.pair[4 * m + c] : 0.0;
    }
}

/** Bond number m, which holds. */
static void put_bond(struct binder_self *self, int64_t m, const double *from)
{
    struct bond_break *b = &self->breaking;
    for (int c = 0; c < 2; ++c)
        self->pair[2 * m + c] = b->ends[2 * m + c] = self->touch.known[2 * m + c] = (int64_t)from[c];
    memcpy(self->memory + REST * m, from + 2, REST * sizeof *from);
    memcpy(self->touch.turn + TURN * m, from + 2 + REST, TURN * sizeof *from);
    b->id[m] = m;
    b->made[m] = from[KEPT_MADE];
    b->broke[m] = from[KEPT_BROKE];
    if (self->turns.pair != NULL)
        memcpy(self->turns.pair + 4 * m, from + KEPT_PAIR, 4 * sizeof *from);
}

int64_t binder_touch_put(struct effect *e, const double *memory, int64_t left)
{
    struct binder_self *self = e->self;
    const double count = left > 0 ? memory[0] : -1.0;
    if (!(count >= 0.0 && KEPT * count <= (double)(left - 1)) || grow(self, (int64_t)count) != 0)
        return -1;
    self->all = self->bonds.count = (int64_t)count;
    for (int64_t m = 0; m < self->all; ++m)
        put_bond(self, m, memory + 1 + KEPT * m);
    sort_known(self);
    ++self->breaking.changes;
    return binder_take_out(self) == 0 ? binder_touch_size(e) : -1;
}
