/* SPDX-License-Identifier: BSD-3-Clause
 * Friction by chunks of the bodies: springs are carried along by all threads at once, each chunk with a table of its
 * own. Loads have the bits of one piece; what is booked, and energies, are sums of those of chunks. */
#include <stdlib.h>

#include "friction.h"

/** What a slice feels: of each chunk the pairs that name one of its bodies. */
struct friction_part {
    const struct friction_self *self;
    vti_contacts of[CHUNKS_MOST];
};

/* ---- what they remember ------------------------------------------------------------------------------------------ */

/** Room for so many touches. Returns 0, or -1 if there is no memory. */
static int make_room(vti_history *history, int64_t touches)
{
    vti_history next = {64, 0, 0, NULL};
    while (next.slots < 2 * touches)
        next.slots *= 2;
    if (next.slots <= history->slots)
        return 0;
    next.slot = calloc((size_t)next.slots, sizeof *next.slot);
    if (next.slot == NULL)
        return -1;
    for (int64_t k = 0; k < history->slots; ++k)
        if (history->slot[k].i != 0)
            vti_history_add(&next, &history->slot[k]);
    free(history->slot);
    *history = next;
    return 0;
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
    return make_room(history, history->used + pairs + near_walls(f->self, &own, pairs)) != 0;
}

/** Where bodies have books chunks share some of them: pairs are booked one by one then, and joined afterwards. Returns 0,
 *  or 1 if there is no memory. */
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
    for (int64_t k = 0; k < history->slots; ++k) {
        const vti_held *held = &history->slot[k];
        if (held->i == 0)
            continue;
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

/** By bodies: where touches stand in the table depends on the order in which they came, which is another one for a run
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
        free(self->chunk[k].history.slot);
        self->chunk[k].history = (vti_history){0, 0, 0, NULL};
        if (make_room(&self->chunk[k].history, 0) != 0)
            return -1;
    }
    const double *at = memory + 1;
    for (int64_t k = 0; k < (int64_t)count; ++k, at += HELD) {
        const vti_held held = {(int64_t)at[0], (int64_t)at[1], {at[2], at[3], at[4]}, {at[5], at[6], at[7]}, at[8]};
        vti_history *history = history_of(self, held.i);
        if (history == NULL || make_room(history, history->used + 1) != 0 || vti_history_add(history, &held) != VTI_OK)
            return -1;
    }
    return 1 + HELD * (int64_t)count;
}

const struct effect_memory_of friction_memory = {size, get, put};

/* ---- what they do ------------------------------------------------------------------------------------------------ */

/** The loads of those pairs, whose first bodies are in chunk k, and then of the chunk's bodies at walls: each body has
 *  those of its pairs first, as in one piece. */
static void apply_chunk(const struct friction_self *self, int64_t k, const vti_contacts *pairs, const vti_bodies *b)
{
    const vti_bodies own = chunks_slice(self->chunks, k, b);
    vti_friction friction = self->chunk[k].friction;
    friction.contacts = pairs;
    friction.walls = NULL;
    self->whole.apply(&friction, b);
    friction.contacts = NULL;
    friction.walls = self->friction.walls;
    self->whole.apply(&friction, &own);
}

static void apply(const void *friction, const vti_bodies *b)
{
    const struct friction_self *self = friction; /* of which it is the first member */
    for (int64_t k = 0; k < self->count; ++k)
        apply_chunk(self, k, &self->chunks->of[k], b);
}

static void apply_part(const void *part, const vti_bodies *b)
{
    const struct friction_part *p = part;
    for (int64_t k = 0; k < p->self->count; ++k)
        apply_chunk(p->self, k, &p->of[k], b);
}

static int is_of_slice(const vti_contacts *c, int64_t k, const vti_bodies *slice)
{
    return vti_pairs_of_slice(1, c->pair + 2 * k, c->base, slice->first, slice->count, NULL) > 0;
}

int friction_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part)
{
    enum { HEAD = (sizeof(struct friction_part) + sizeof(int64_t) - 1) / sizeof(int64_t) };
    const struct friction_self *self = e->self;
    const struct chunks *chunks = self->chunks;
    int64_t n = 0;
    if (chunks == NULL)
        part->made = self->made;
    if (chunks == NULL || part->age == chunks->age)
        return 0;
    for (int64_t c = 0; c < self->count; ++c)
        n += vti_pairs_of_slice(chunks->of[c].count, chunks->of[c].pair, 0, slice->first, slice->count, NULL);
    struct friction_part *p = effect_part_room(part, HEAD + 3 * n);
    if (p == NULL)
        return -1;
    int64_t *pair = (int64_t *)(void *)p + HEAD;
    double *length = (double *)(void *)(pair + 2 * n);
    p->self = self;
    for (int64_t c = 0; c < self->count; ++c) {
        const vti_contacts *const from = &chunks->of[c];
        vti_contacts *const to = &p->of[c];
        *to = *from;
        to->count = 0;
        to->pair = pair;
        if (from->length.p != NULL)
            to->length = vti_scalars_array(length);
        for (int64_t k = 0; k < from->count; ++k) {
            if (!is_of_slice(from, k, slice))
                continue;
            *pair++ = from->pair[2 * k];
            *pair++ = from->pair[2 * k + 1];
            *length++ = from->length.p != NULL ? from->length.p[k] : 0.0;
            ++to->count;
        }
    }
    part->made = self->made;
    part->made.apply = apply_part;
    part->made.check = NULL; /* the model's effect is looked at */
    part->made.self = p;
    part->age = chunks->age;
    return 0;
}

static void energy(const void *friction, const vti_bodies *b, double *energies)
{
    const struct friction_self *self = friction;
    vti_sum sum[VTI_FRICTION_BOOKS] = {{0.0, 0.0}};
    for (int64_t k = 0; k < self->count; ++k) {
        const vti_bodies own = chunks_slice(self->chunks, k, b);
        double of_chunk[VTI_FRICTION_BOOKS] = {0.0};
        self->whole.energy(&self->chunk[k].friction, &own, of_chunk);
        for (int n = 0; n < self->whole.terms; ++n)
            vti_sum_add(&sum[n], of_chunk[n]);
    }
    for (int n = 0; n < self->whole.terms; ++n)
        energies[n] = vti_sum_value(&sum[n]);
}

/** What the pairs of a chunk have lost, half to each body. */
static void share_pairs(const vti_friction *friction)
{
    const vti_contacts *const contacts = friction->contacts;
    for (int64_t k = 0; k < 2 * contacts->count; ++k)
        for (int n = 0; n < VTI_FRICTION_BOOKS; ++n) {
            const double lost = friction->by_pair[VTI_FRICTION_BOOKS * (k / 2) + n];
            if (lost != 0.0)
                vti_sum_add(&friction->by_body[VTI_FRICTION_BOOKS * (contacts->pair[k] - contacts->base) + n],
                            0.5 * lost);
        }
}

struct carrying {
    const struct friction_self *self;
    const vti_bodies *bodies;
    const vti_drifted *drifted;
};

static int64_t carry_chunk(void *context, int64_t k)
{
    const struct carrying *c = context;
    const vti_bodies own = chunks_slice(c->self->chunks, k, c->bodies);
    c->self->whole.carry(&c->self->chunk[k].friction, &own, c->drifted);
    return 0;
}

static void carry(const void *friction, const vti_bodies *b, const vti_drifted *drifted)
{
    const struct friction_self *self = friction;
    struct carrying carrying = {self, b, drifted};
    chunks_all(self->chunks, carry_chunk, &carrying);
    for (int64_t k = 0; k < self->count; ++k) {
        struct friction_chunk *chunk = &self->chunk[k];
        for (int n = 0; n < VTI_FRICTION_BOOKS; ++n)
            chunks_book(&self->friction.lost[n], &chunk->lost[n]);
        if (self->friction.walls != NULL && self->friction.walls->work != NULL)
            chunks_book(self->friction.walls->work, &chunk->work);
        if (k > 0) /* the table that check looks at */
            self->friction.history->missed += chunk->history.missed;
        chunk->history.missed = k > 0 ? 0 : chunk->history.missed;
        if (chunk->friction.by_pair != NULL)
            share_pairs(&chunk->friction);
    }
}

/** Of each chunk its own, or a table for all. Returns 0, or -1 if memory is out. */
int friction_make_chunks(struct friction_self *self)
{
    self->count = self->chunks != NULL ? self->chunks->count : 1;
    self->chunk = calloc((size_t)self->count, sizeof *self->chunk);
    if (self->chunk == NULL)
        return -1;
    self->friction.history = &self->chunk->history;
    for (int64_t k = 0; k < self->count; ++k) {
        struct friction_chunk *chunk = &self->chunk[k];
        chunk->friction = self->friction;
        chunk->friction.history = &chunk->history;
        chunk->friction.lost = chunk->lost;
        if (self->chunks != NULL)
            chunk->friction.contacts = &self->chunks->of[k];
        if (self->friction.walls != NULL) {
            chunk->walls = *self->friction.walls;
            chunk->walls.work = &chunk->work;
            chunk->friction.walls = &chunk->walls;
        }
        if (make_room(&chunk->history, 0) != 0)
            return -1;
    }
    return 0;
}

void friction_by_chunks(struct friction_self *self, vti_effect *made)
{
    self->whole = *made;
    if (self->chunks != NULL) {
        made->apply = apply;
        made->energy = energy;
        made->carry = carry;
    }
    self->made = *made;
}
