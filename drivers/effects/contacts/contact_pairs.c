/* SPDX-License-Identifier: BSD-3-Clause
 * The pairs of contact: their list, that of a slice, and what a run that goes on has to know of them. */
#include <stdlib.h>

#include "contact.h"

/* ---- the list ---------------------------------------------------------------------------------------------------- */

/** Distances at which the pairs of the list begin to touch, where some of them have one of their own. Returns 0, or -1
 *  with one line in *message. */
static int find_lengths(struct contact_self *self, struct message *message)
{
    const vti_scalars none = {NULL, 0, 0};
    const int64_t count = self->contacts.count;
    self->contacts.length = none;
    ++self->age;
    if (self->partings.own == 0)
        return 0;
    if (count > self->room) {
        free(self->length);
        self->length = malloc((size_t)count * sizeof *self->length);
        self->room = self->length != NULL ? count : 0;
    }
    if (count > self->room)
        return message_set(message, "contacts: out of memory for %lld pairs; use fewer bodies", (long long)count);
    partings_lengths(&self->partings, &self->contacts.diameter, count, self->contacts.pair, self->length);
    if (count > 0)
        self->contacts.length = vti_scalars_array(self->length);
    return 0;
}

/** The list is another one, or lengths are. */
static int take_list(struct contact_self *self, struct message *message)
{
    if (find_lengths(self, message) != 0)
        return -1;
    if (self->chunks.count > 1 && chunks_take(&self->chunks, &self->contacts) != 0)
        return message_set(message, "contacts: out of memory for %lld pairs; use fewer bodies",
                           (long long)self->contacts.count);
    return 0;
}

double contact_length(const vti_contacts *list, int64_t k)
{
    if (list->length.p != NULL)
        return list->length.p[k];
    return partings_touching(&list->diameter, list->pair[2 * k], list->pair[2 * k + 1]);
}

void contact_name_pair(const struct neighbours *list, int64_t k, int64_t body[2])
{
    for (int n = 0; n < 2; ++n) {
        const int64_t i = list->pair[2 * k + n], of = list->owner != NULL ? list->owner[i] : i;
        body[n] = list->number != NULL ? list->number[of] : of;
    }
}

/** At the start: of centres that are one there is no direction in which they could part. The core takes those for one
 *  that are nearer than 3.1e-151. */
static int check_directions(const struct contact_self *self, const vti_view *x, struct message *message)
{
    static const double one = 3.2e-151; /* that, rounded up */
    const struct neighbours *list = &self->neighbours;
    for (int64_t k = 0; k < list->count; ++k) {
        if (partings_distance(x, list->pair[2 * k], list->pair[2 * k + 1]) > one)
            continue;
        int64_t body[2];
        contact_name_pair(list, k, body);
        return message_set(
            message, "the centres of %s %lld and %lld give no direction to their contact; move one of them",
            list->owner != NULL ? "spheres of bodies" : "bodies", (long long)body[0], (long long)body[1]);
    }
    return 0;
}

int contact_find_pairs(struct effect *e, const vti_bodies *bodies, struct message *message)
{
    struct contact_self *self = e->self;
    const int result = neighbours_update(&self->neighbours, &bodies->x, message);
    self->contacts.count = self->neighbours.count;
    self->contacts.pair = self->neighbours.pair;
    if (result == 1 && !self->begun && check_directions(self, &bodies->x, message) != 0)
        return -1;
    self->begun = 1;
    return result == 1 ? take_list(self, message) : result;
}

int contact_release(struct effect *e, const vti_bodies *bodies, int64_t count, const int64_t *pair,
                    struct message *message)
{
    struct contact_self *self = e->self;
    const vti_scalars *diameter = &self->contacts.diameter;
    if (!self->parts)
        return 0;
    const int64_t ended = partings_end(&self->partings, &bodies->x, diameter);
    for (int64_t k = 0; k < count; ++k) {
        const int64_t i = pair[2 * k], j = pair[2 * k + 1];
        if (partings_add(&self->partings, i, j, partings_distance(&bodies->x, i, j), diameter) != 0)
            return message_set(message, "contacts: out of memory for bonds that have broken; use fewer bodies");
        neighbours_release(&self->neighbours, i, j);
    }
    return ended > 0 ? take_list(self, message) : 0;
}

/* ---- of a slice -------------------------------------------------------------------------------------------------- */

int contact_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part)
{
    const struct contact_self *self = e->self;
    const vti_contacts *all = &self->contacts;
    if (part->age == self->age)
        return 0;
    const int64_t n = vti_pairs_of_slice(all->count, all->pair, all->base, slice->first, slice->count, NULL);
    int64_t *pair = effect_part_room(part, 3 * n);
    if (pair == NULL)
        return -1;
    part->age = self->age;
    part->contacts = chunks_pairs_of(all, slice, pair, (double *)(void *)(pair + 2 * n));
    part->made = vti_contacts_effect(&part->contacts);
    return 0;
}

/* ---- what a run goes on with ------------------------------------------------------------------------------------- */

static int64_t size(const struct effect *e)
{
    const struct contact_self *self = e->self;
    return self->parts ? partings_size(&self->partings) : 0;
}

static void get(const struct effect *e, double *memory)
{
    const struct contact_self *self = e->self;
    if (self->parts)
        partings_get(&self->partings, memory);
}

static int64_t put(struct effect *e, const double *memory, int64_t left)
{
    struct contact_self *self = e->self;
    const int64_t taken = self->parts ? partings_put(&self->partings, memory, left) : 0;
    for (int64_t k = 0; taken > 0 && k < self->partings.count; ++k)
        neighbours_release(&self->neighbours, self->partings.list[k].i, self->partings.list[k].j);
    return taken;
}

const struct effect_memory_of contact_memory = {size, get, put};
