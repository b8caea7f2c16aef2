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
        p->of[c] = chunks_pairs_of(&chunks->of[c], slice, pair, length);
        pair += 2 * p->of[c].count;
        length += p->of[c].count;
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
        if (friction_make_room(&chunk->history, 0) != 0)
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
