/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A pair with a gap of at least the skin cannot touch before one of its bodies has moved by half the skin against any
 * motion that both share, such as that of a body of bonded spheres as a whole. */
#include "neighbours.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cells.h"
#include "excluded.h"
#include "far.h"
#include "number.h"
#include "threads.h"

/** The default skin, as a share of the mean diameter: a wide one means more pairs to look at in each step, a narrow one
 *  more builds. For 1e4 equal spheres that fill 0.6 of the space and move freely by 1e-4, 1e-3 or 1e-2 of their
 *  diameter in a step (root mean square per direction), search and forces take 1.4, 1.0 and 1.2 times what they take
 *  with the best skin, which is 0.05, 0.15 and 0.5. */
static const double default_skin = 0.2;

/** A skin that is left to the list follows the cost, up to this share. */
static const double widest_skin = 1.0;

/** What a build costs, per body and per pair that it finds, in looks at a pair of the list, which take some 20
 *  instructions. Rough: with twice as much the scene pile takes 1 % more instructions, and the torus as many. */
static const double build_body = 25.0, build_pair = 5.0;

/** How often a step looks at a pair where effects look near it, too: force, two flows, carry, and the springs' load. */
static const double near_looks = 5.0;

/** After a wider skin that did not pay. */
static const int64_t builds_to_wait = 16;

struct neighbours_search {
    struct cells cells; /* with the positions of the last build */
    struct pairs found;
    double longest;   /* radius */
    double mean;      /* diameter */
    int adapts;       /* the skin was left to the list */
    int64_t age;      /* updates since it was built */
    double tried;     /* cost of a step before the skin was made wider for this list; 0: it was not */
    int64_t wait;     /* builds until a wider one may be tried */
    double shared[3]; /* how far bodies have moved together since then, as of the last look at it */
    int is_built;
    int64_t pair_room; /* of the list */
    int64_t *start;    /* [n + 1] for sorting */
    struct excluded excluded;
};

/* ---- update ------------------------------------------------------------------------------------------------------ */

/** Who looks whether bodies have moved. */
struct look {
    const struct neighbours *list;
    const vti_view *x;
    double limit; /* how far one may be from where all have moved, squared */
    int64_t parts;
};

/** So many bodies, and all where there are fewer, say how far bodies have moved together: any vector will do. */
enum { SAMPLE = 32 };

/** The mean displacement since the list was built. */
static void find_shared(struct neighbours_search *s, const vti_view *x)
{
    const struct cells *cells = &s->cells;
    const int64_t step = cells->n / SAMPLE + 1, count = (cells->n + step - 1) / step;
    for (int k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (int64_t i = 0; i < cells->n; i += step)
            sum += x->c[k][i * x->stride] - cells->x[3 * i + k];
        s->shared[k] = count > 0 ? sum / (double)count : 0.0;
    }
}

/** 1 if a body of a part has moved, but for what is shared, by more than half of what the skin is above the reach, or
 *  to where there are no numbers. */
static int64_t part_has_moved(void *self, int64_t part)
{
    const struct look *l = self;
    const struct neighbours_search *s = l->list->search;
    const int64_t n = s->cells.n;
    return far_any(l->x, threads_begin(n, part, l->parts), threads_begin(n, part + 1, l->parts), s->cells.x, s->shared,
                   l->limit);
}

static int has_left_shared(const struct neighbours *list, const vti_view *x)
{
    struct look look = {.list = list, .x = x, .parts = threads_used()};
    const double *const shared = list->search->shared;
    /* displacements that are far longer than what is left of them round */
    const double far = fabs(shared[0]) + fabs(shared[1]) + fabs(shared[2]);
    const double way = 0.5 * (list->skin - list->reach) - 4.0 * DBL_EPSILON * far;
    look.limit = way > 0.0 ? way * way : -1.0;
    return threads_sum(look.parts, part_has_moved, &look) > 0;
}

/** What is shared is found anew only when it no longer serves. */
static int has_moved(struct neighbours *list, const vti_view *x)
{
    if (!has_left_shared(list, x))
        return 0;
    find_shared(list->search, x);
    return has_left_shared(list, x);
}

static int store_positions(struct neighbours *list, const vti_view *x, struct message *message)
{
    struct cells *const cells = &list->search->cells;
    for (int64_t i = 0; i < cells->n; ++i) {
        double *const at = cells->x + 3 * i;
        for (int k = 0; k < 3; ++k)
            at[k] = x->c[k][i * x->stride];
        if (!isfinite(at[0]) || !isfinite(at[1]) || !isfinite(at[2]))
            return message_set(message, "contacts: body %lld is at (%.6g, %.6g, %.6g); use a smaller h",
                               (long long)(list->number != NULL ? list->number[i] : i), number_plain(at[0]),
                               number_plain(at[1]), number_plain(at[2]));
    }
    return 0;
}

/** Room in the list for all that were found; what was in it is lost. */
static int make_room(struct neighbours *list)
{
    struct neighbours_search *const s = list->search;
    if (s->pair_room == s->found.room)
        return 0;
    free(list->pair);
    list->pair = malloc((size_t)s->found.room * 2 * sizeof *list->pair);
    s->pair_room = list->pair == NULL ? 0 : s->found.room;
    return list->pair == NULL ? -1 : 0;
}

static int build(struct neighbours *list)
{
    struct neighbours_search *const s = list->search;
    if (cells_search(&s->cells, s->longest, list->skin, &s->found) != 0 || make_room(list) != 0)
        return -1;
    pairs_sort(s->cells.n, s->start, s->found.count, s->found.pair, list->pair);
    list->count = excluded_leave_out(&s->excluded, s->found.count, s->found.pair, list->owner, list->pair);
    return 0;
}

/** A skin s times the diameter costs the build every so many steps, ever fewer, and in each a look at pairs that are as
 *  many as (1 + s)^3 among equal spheres that fill the space: least where the build costs 3 s/(1 + s) of the pairs.
 *  Among others, a ring's or a lattice's, a little more skin may find many more pairs: one that has cost
 *  clearly more than the one before is taken back, and for a while none is tried. */
static void adapt(struct neighbours *list)
{
    struct neighbours_search *const s = list->search;
    const double build_cost = build_body * (double)s->cells.n + build_pair * (double)s->found.count;
    const double looks = (list->reach > 0.0 ? near_looks : 1.0) * (double)list->count;
    const double share = list->skin / s->mean, best = 3.0 * share / (1.0 + share) * looks;
    const double each = build_cost / (double)s->age, before = s->tried;
    s->tried = 0.0;
    s->wait -= s->wait > 0;
    if (before > 0.0 && each + looks > 1.5 * before) {
        list->skin *= 0.8;
        s->wait = builds_to_wait;
    } else if (each > best && s->wait == 0) {
        s->tried = each + looks;
        list->skin = fmin(1.25 * list->skin, widest_skin * s->mean);
    } else if (each < 0.5 * best)
        list->skin = fmax(0.8 * list->skin, default_skin * s->mean);
}

int neighbours_update(struct neighbours *list, const vti_view *x, struct message *message)
{
    struct neighbours_search *const s = list->search;
    ++s->age;
    if (s->is_built && !has_moved(list, x))
        return 0;
    if (s->is_built && s->adapts)
        adapt(list);
    list->count = 0;
    s->is_built = 0;
    if (store_positions(list, x, message) != 0)
        return -1;
    const int failed = build(list) != 0;
    if (failed && cells_are_crowded(&s->cells, &s->found))
        return message_set(
            message,
            "contacts: each of %lld spheres has more than %d others at most a diameter or so away, on the "
            "mean; have positions and diameters the same unit?",
            (long long)s->cells.n, CELLS_CROWD);
    if (failed)
        return message_set(message, "contacts: out of memory for the pairs of %lld bodies; are too many in one place?",
                           (long long)s->cells.n);
    s->is_built = 1;
    s->age = 0;
    s->shared[0] = s->shared[1] = s->shared[2] = 0.0;
    ++list->builds;
    return 1;
}

int neighbours_hold(struct neighbours *list, const vti_view *x)
{
    return list->search->is_built && !has_moved(list, x);
}

int neighbours_exclude(const struct neighbours *list, int64_t i, int64_t j)
{
    const int64_t pair[2] = {i, j};
    return (list->owner != NULL && list->owner[i] == list->owner[j]) || excluded_has(&list->search->excluded, pair);
}

void neighbours_release(struct neighbours *list, int64_t i, int64_t j)
{
    const int64_t pair[2] = {i < j ? i : j, i < j ? j : i};
    if (excluded_release(&list->search->excluded, pair))
        list->search->is_built = 0;
}

/* ---- create and destroy ------------------------------------------------------------------------------------------ */

static int store_diameters(struct neighbours *list, const vti_scalars *diameter, double skin, struct message *message)
{
    struct neighbours_search *const s = list->search;
    for (int64_t i = 0; i < s->cells.n; ++i) {
        const double value = diameter->p[i * diameter->stride];
        if (!(value > 0.0 && isfinite(value)))
            return message_set(message, "contacts: body %lld has the diameter %.6g; it must be positive", (long long)i,
                               value);
        s->cells.radius[i] = 0.5 * value;
        s->longest = fmax(s->longest, 0.5 * value);
        s->mean += value / (double)s->cells.n;
    }
    s->adapts = !(skin > 0.0);
    list->skin = s->adapts ? default_skin * s->mean : skin;
    return 0;
}

static int allocate(struct neighbours *list, int64_t n)
{
    struct neighbours_search *const s = calloc(1, sizeof *s);
    list->search = s;
    if (s == NULL || cells_create(&s->cells, n) != 0)
        return -1;
    s->start = malloc((size_t)(n + 1) * sizeof *s->start);
    return s->start == NULL ? -1 : 0;
}

static int fill(struct neighbours *list, int64_t n, const vti_scalars *diameter, double skin, int64_t excluded_count,
                const int64_t *excluded, struct message *message)
{
    if (!(skin >= 0.0 && isfinite(skin)))
        return message_set(message, "contacts: the skin is %.6g; give a length, or 0 for the default", skin);
    if (allocate(list, n) != 0)
        return message_set(message, "contacts: out of memory; use fewer bodies than %lld", (long long)n);
    if (store_diameters(list, diameter, skin, message) != 0)
        return -1;
    struct neighbours_search *const s = list->search;
    return excluded_create(&s->excluded, n, s->start, excluded_count, excluded, message);
}

int neighbours_create(struct neighbours *list, int64_t n, const vti_scalars *diameter, double skin,
                      int64_t excluded_count, const int64_t *excluded, struct message *message)
{
    memset(list, 0, sizeof *list);
    if (fill(list, n, diameter, skin, excluded_count, excluded, message) == 0)
        return 0;
    neighbours_destroy(list);
    return -1;
}

void neighbours_destroy(struct neighbours *list)
{
    if (list->search != NULL) {
        cells_destroy(&list->search->cells);
        free(list->search->found.pair);
        free(list->search->start);
        excluded_destroy(&list->search->excluded);
    }
    free(list->search);
    free(list->pair);
    memset(list, 0, sizeof *list);
}
