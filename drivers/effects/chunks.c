/* SPDX-License-Identifier: BSD-3-Clause */
#include "chunks.h"

#include <stdlib.h>
#include <string.h>

#include "threads.h"

enum {
    LEAST = 1024,    /* bodies of more than one chunk; each so many are CHUNKS more */
    CHUNKS = 4,      /* two threads, or four, share them evenly */
    PAIRS_WORTH = 64 /* of a round: for fewer nobody is woken */
};

static int64_t begin(const struct chunks *c, int64_t k)
{
    return threads_begin(c->bodies, k, c->count);
}

int64_t chunks_of(const struct chunks *c, int64_t body)
{
    int64_t k = body * c->count / c->bodies; /* but for rounding */
    while (body < begin(c, k))
        --k;
    while (body >= begin(c, k + 1))
        ++k;
    return k;
}

vti_bodies chunks_slice(const struct chunks *c, int64_t k, const vti_bodies *bodies)
{
    const int64_t end = bodies->first + bodies->count, low = begin(c, k), high = begin(c, k + 1);
    const int64_t first = low > bodies->first ? low : bodies->first, last = high < end ? high : end;
    return vti_bodies_slice(*bodies, first, last > first ? last - first : 0);
}

/* ---- rounds ------------------------------------------------------------------------------------------------------ */

/** Chunks k and k + d: of those with a common d, each chunk is the lower one of one group and the higher one of
 *  another, so that two rounds do, which k/d, even or odd, tells apart. */
static int64_t round_of(int64_t low, int64_t high)
{
    const int64_t d = high - low;
    return d == 0 ? 0 : 2 * d - 1 + low / d % 2;
}

static void rank_groups(struct chunks *c)
{
    int64_t next = 0;
    for (int64_t round = 0; round < c->rounds; ++round) {
        const int64_t d = (round + 1) / 2;
        for (int64_t low = 0; low + d < c->count; ++low) {
            if (round_of(low, low + d) != round)
                continue;
            c->group[next].low = low;
            c->group[next].high = low + d;
            c->rank[low * c->count + low + d] = next++;
        }
        c->ends[round] = next;
    }
}

/* ---- the list ---------------------------------------------------------------------------------------------------- */

static int make_room(struct chunks *c, const vti_contacts *all)
{
    if (all->count < c->room)
        return 0;
    free(c->pair);
    free(c->length);
    c->room = all->count + all->count / 4 + 1;
    c->pair = malloc((size_t)c->room * 2 * sizeof *c->pair);
    c->length = malloc((size_t)c->room * sizeof *c->length);
    if (c->pair == NULL || c->length == NULL)
        c->room = 0;
    return c->room == 0 ? -1 : 0;
}

static struct chunk_group *group_of(const struct chunks *c, int64_t low, const int64_t *pair)
{
    return &c->group[c->rank[low * c->count + chunks_of(c, pair[1])]];
}

/** Part of the list *all, count pairs from first on. */
static vti_contacts part_of(const vti_contacts *all, int64_t first, int64_t count)
{
    vti_contacts part = *all;
    part.count = count;
    part.pair = all->pair != NULL ? all->pair + 2 * first : NULL;
    if (all->length.p != NULL)
        part.length = vti_scalars_array(all->length.p + first);
    return part;
}

/** Which pairs begin in each chunk; and how many there are of each group, in its count. */
static void count_pairs(struct chunks *c, const vti_contacts *all)
{
    int64_t k = 0;
    for (int64_t g = 0; g < c->groups; ++g)
        c->group[g].contacts.count = 0;
    for (int64_t low = 0; low < c->count; ++low) {
        const int64_t first = k, end = begin(c, low + 1);
        for (; k < all->count && all->pair[2 * k] < end; ++k)
            ++group_of(c, low, all->pair + 2 * k)->contacts.count;
        c->of[low] = part_of(all, first, k - first);
    }
}

/** Where each group begins in the list by groups; none has any of its pairs yet. */
static void place_groups(struct chunks *c, const vti_contacts *all)
{
    int64_t first = 0;
    for (int64_t g = 0; g < c->groups; ++g) {
        vti_contacts *const to = &c->group[g].contacts;
        const int64_t count = to->count;
        *to = part_of(all, 0, 0);
        to->pair = c->pair + 2 * first;
        if (all->length.p != NULL)
            to->length = vti_scalars_array(c->length + first);
        first += count;
    }
}

vti_contacts chunks_pairs_of(const vti_contacts *all, const vti_bodies *slice, int64_t *pair, double *length)
{
    vti_contacts part = *all;
    part.count = 0;
    part.pair = pair;
    if (all->length.p != NULL)
        part.length = vti_scalars_array(length);
    for (int64_t k = 0; k < all->count; ++k) {
        if (vti_pairs_of_slice(1, all->pair + 2 * k, all->base, slice->first, slice->count, NULL) == 0)
            continue;
        memcpy(pair + 2 * part.count, all->pair + 2 * k, 2 * sizeof *pair);
        length[part.count++] = all->length.p != NULL ? all->length.p[k] : 0.0;
    }
    return part;
}

int chunks_take(struct chunks *c, const vti_contacts *all)
{
    if (make_room(c, all) != 0)
        return -1;
    ++c->age;
    count_pairs(c, all);
    place_groups(c, all);
    for (int64_t low = 0; low < c->count; ++low)
        for (int64_t k = 0; k < c->of[low].count; ++k) {
            const int64_t *const pair = c->of[low].pair + 2 * k;
            vti_contacts *const to = &group_of(c, low, pair)->contacts;
            const int64_t at = (to->pair - c->pair) / 2 + to->count++;
            c->pair[2 * at] = pair[0];
            c->pair[2 * at + 1] = pair[1];
            if (all->length.p != NULL)
                c->length[at] = c->of[low].length.p[k];
        }
    return 0;
}

/* ---- at once ----------------------------------------------------------------------------------------------------- */

/** Some groups of one round. */
struct round {
    void (*work)(void *self, int64_t group);
    void *self;
    int64_t count, pairs;
    int64_t group[CHUNKS_MOST];
};

static int64_t one_group(void *self, int64_t k)
{
    const struct round *r = self;
    r->work(r->self, r->group[k]);
    return 0;
}

void chunks_by_rounds(const struct chunks *c, int backwards, void (*work)(void *self, int64_t group), void *self)
{
    struct round r = {.work = work, .self = self};
    for (int64_t n = 0; n < c->rounds; ++n) {
        const int64_t round = backwards ? c->rounds - 1 - n : n;
        r.count = r.pairs = 0;
        for (int64_t g = round > 0 ? c->ends[round - 1] : 0; g < c->ends[round]; ++g) {
            if (round > 0 && c->group[g].contacts.count == 0)
                continue;
            r.group[r.count++] = g;
            r.pairs += c->group[g].contacts.count;
        }
        if (round == 0 || r.pairs >= PAIRS_WORTH)
            threads_sum(r.count, one_group, &r);
        else
            for (int64_t k = 0; k < r.count; ++k)
                one_group(&r, k);
    }
}

int64_t chunks_all(const struct chunks *c, int64_t (*work)(void *self, int64_t chunk), void *self)
{
    return threads_sum(c->count, work, self);
}

void chunks_book(vti_sum *all, vti_sum *own)
{
    vti_sum_add(all, own->high);
    vti_sum_add(all, own->low);
    own->high = own->low = 0.0;
}

/* ---- create and destroy ------------------------------------------------------------------------------------------ */

int chunks_create(struct chunks *c, int64_t bodies)
{
    memset(c, 0, sizeof *c);
    c->bodies = bodies;
    c->count = bodies / LEAST * CHUNKS;
    c->count = c->count < 1 ? 1 : c->count < CHUNKS_MOST ? c->count : CHUNKS_MOST;
    c->groups = c->count * (c->count + 1) / 2;
    c->rounds = 2 * c->count - 1;
    c->of = calloc((size_t)c->count, sizeof *c->of);
    c->group = calloc((size_t)c->groups, sizeof *c->group);
    c->rank = calloc((size_t)(c->count * c->count), sizeof *c->rank);
    c->ends = calloc((size_t)c->rounds, sizeof *c->ends);
    if (c->of == NULL || c->group == NULL || c->rank == NULL || c->ends == NULL)
        return -1;
    rank_groups(c);
    return 0;
}

void chunks_destroy(struct chunks *c)
{
    free(c->of);
    free(c->group);
    free(c->rank);
    free(c->ends);
    free(c->pair);
    free(c->length);
    memset(c, 0, sizeof *c);
}
