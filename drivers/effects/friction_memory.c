/* SPDX-License-Identifier: BSD-3-Clause
 * What the springs of friction remember: tables of touches, one for each chunk of the bodies, with room for those
 * that the next drift may bring, and what of them a run keeps to go on. */
#include <stdlib.h>

#include "friction.h"

/* ---- room for what may touch ------------------------------------------------------------------------------------- */

int friction_make_room(vti_history *history, int64_t touches)
{
    vti_history next = {64, 0, history->missed, NULL, NULL};
    while (next.slots < 2 * touches)
        next.slots *= 2;
    if (next.slots <= history->slots)
        return 0;
    next.held = malloc((size_t)next.slots * sizeof *next.held); /* of which pages that nothing is put into take none */
    next.slot = calloc((size_t)next.slots, sizeof *next.slot);
    const int failed = next.held == NULL || next.slot == NULL;
    for (int64_t k = 0; k < history->used && !failed; ++k)
        vti_history_add(&next, &history->held[k]);
    friction_free(failed ? &next : history);
    if (!failed)
        *history = next;
    return failed ? -1 : 0;
}

void friction_free(vti_history *history)
{
    free(history->held);
    free(history->slot);
}

/** Bodies that may touch walls after the next drift, once for each: nearer than their diameter; all of them where these
 *  are no more than the pairs, so that nobody needs to look. */
static int64_t near_walls(const struct friction_self *self, const vti_bodies *b, int64_t pairs)
{
    const vti_walls *walls = self->friction.walls;
    int64_t count = walls != NULL ? b->count * (walls->count + walls->cylinders) : 0;
    if (count <= pairs)
        return count;
    count = 0;
    for (int64_t w = 0; walls != NULL && w < walls->count + walls->cylinders; ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            const int64_t at = i * b->x.stride;
            const double x[3] = {b->x.c[0][at], b->x.c[1][at], b->x.c[2][at]};
            double n[3];
            count += vti_walls_gap(walls, w, x, n) < 1.5 * self->diameter.p[i * self->diameter.stride];
        }
    return count;
}

struct finding {
    struct friction_self *self;
    const vti_bodies *bodies;
};

/** Returns 1 if there is no memory. */
static int64_t find_in_chunk(void *context, int64_t k)
{
    const struct finding *f = context;
    const struct chunks *chunks = f->self->chunks;
    vti_history *history = &f->self->chunk[k].history;
    const vti_contacts *contacts = chunks != NULL ? &chunks->of[k] : f->self->friction.contacts;
    const vti_bodies own = chunks != NULL ? chunks_slice(chunks, k, f->bodies) : *f->bodies;
    const int64_t pairs = contacts != NULL ? contacts->count : 0;
    return friction_make_room(history, history->used + pairs + near_walls(f->self, &own, pairs)) != 0;
}

/** Where bodies have books chunks share some of them: pairs are booked one by one then, and joined afterwards. Returns
 *  0, or 1 if there is no memory. */
static int make_books_of_pairs(struct friction_self *self)
{
    if (self->chunks == NULL || self->friction.by_body == NULL || self->friction.contacts == NULL)
        return 0;
    const size_t pairs = (size_t)self->friction.contacts->count + 1;
    double *by_pair = realloc(self->by_pair, VTI_FRICTION_BOOKS * pairs * sizeof *by_pair);
    if (by_pair == NULL)
        return 1;
    self->by_pair = by_pair;
    for (int64_t k = 0; k < self->count; ++k) {
        self->chunk[k].friction.by_pair = by_pair;
        by_pair += VTI_FRICTION_BOOKS * self->chunks->of[k].count;
    }
    return 0;
}

int friction_find_pairs(struct effect *e, const vti_bodies *bodies, struct message *message)
{
    struct friction_self *self = e->self;
    struct finding finding = {self, bodies};
    const int64_t failed =
        self->chunks != NULL ? chunks_all(self->chunks, find_in_chunk, &finding) : find_in_chunk(&finding, 0);
    if (failed == 0 && make_books_of_pairs(self) == 0)
        return 0;
    return message_set(message, "friction: out of memory for %lld touches; use fewer bodies",
                       (long long)(self->friction.contacts != NULL ? self->friction.contacts->count : bodies->count));
}

/* ---- what a run goes on with ------------------------------------------------------------------------------------- */

enum { HELD = 9 }; /* doubles of a touch */

static int64_t used(const struct friction_self *self)
{
    int64_t sum = 0;
    for (int64_t k = 0; k < self->count; ++k)
        sum += self->chunk[k].history.used;
    return sum;
}

static int64_t size(const struct effect *e)
{
    return 1 + HELD * used(e->self);
}

static int compare(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return p[0] != q[0] ? (p[0] < q[0] ? -1 : 1) : (p[1] > q[1]) - (p[1] < q[1]);
}

static double *get_chunk(const vti_history *history, double *memory)
{
    for (int64_t k = 0; k < history->used; ++k) {
        const vti_held *held = &history->held[k];
        *memory++ = (double)held->i;
        *memory++ = (double)held->j;
        for (int c = 0; c < 3; ++c)
            *memory++ = held->sliding[c];
        for (int c = 0; c < 3; ++c)
            *memory++ = held->rolling[c];
        *memory++ = held->twisting;
    }
    return memory;
}

/** By bodies: where touches stand in memory depends on the order in which they came, which is another one for a run
 *  that goes on. */
static void get(const struct effect *e, double *memory)
{
    const struct friction_self *self = e->self;
    double *next = memory + 1;
    *memory = (double)used(self);
    for (int64_t k = 0; k < self->count; ++k)
        next = get_chunk(&self->chunk[k].history, next);
    qsort(memory + 1, (size_t)used(self), HELD * sizeof *memory, compare);
}

/** The table of what body i, from 1, holds first; NULL if there is no such body. */
static vti_history *history_of(const struct friction_self *self, int64_t i)
{
    if (self->chunks == NULL)
        return &self->chunk->history;
    return i >= 1 && i <= self->chunks->bodies ? &self->chunk[chunks_of(self->chunks, i - 1)].history : NULL;
}

static int64_t put(struct effect *e, const double *memory, int64_t left)
{
    struct friction_self *self = e->self;
    const double count = left > 0 ? memory[0] : -1.0;
    if (!(count >= 0.0 && HELD * count <= (double)(left - 1)))
        return -1;
    for (int64_t k = 0; k < self->count; ++k) {
        friction_free(&self->chunk[k].history);
        self->chunk[k].history = (vti_history){0, 0, 0, NULL, NULL};
        if (friction_make_room(&self->chunk[k].history, 0) != 0)
            return -1;
    }
    const double *at = memory + 1;
    for (int64_t k = 0; k < (int64_t)count; ++k, at += HELD) {
        const vti_held held = {(int64_t)at[0], (int64_t)at[1], {at[2], at[3], at[4]}, {at[5], at[6], at[7]}, at[8]};
        vti_history *history = history_of(self, held.i);
        if (history == NULL || friction_make_room(history, history->used + 1) != 0 ||
            vti_history_add(history, &held) != VTI_OK)
            return -1;
    }
    return 1 + HELD * (int64_t)count;
}

const struct effect_memory_of friction_memory = {size, get, put};
