/* SPDX-License-Identifier: BSD-3-Clause */
#include "touch_forces.h"

#include <stdlib.h>
#include <string.h>

#include "contact.h"
#include "model.h"
#include "touches.h"
#include "wall.h"

struct finding {
    struct effect_surfaces surfaces;
    vti_bodies spheres; /* whose forces are force */
    double *force;      /* [spheres][3], zeros between two touches */
    vti_held *held;     /* what springs hold, ascending by i, then by j */
    int64_t held_count;
    struct touch_list *list;
    int failed;
};

/* ---- what springs hold ------------------------------------------------------------------------------------------- */

static int by_numbers(int64_t i, int64_t j, int64_t other_i, int64_t other_j)
{
    return i != other_i ? (i < other_i ? -1 : 1) : (j > other_j) - (j < other_j);
}

static int compare_held(const void *a, const void *b)
{
    const vti_held *p = a, *q = b;
    return by_numbers(p->i, p->j, q->i, q->j);
}

/** Of all chunks. Returns 0, or -1 if there is no memory. */
static int sort_held(struct finding *f, const struct effect *springs)
{
    const int64_t chunks = springs == NULL ? 0 : f->surfaces.chunks != NULL ? f->surfaces.chunks->count : 1;
    for (int64_t c = 0; c < chunks; ++c)
        f->held_count += springs->kind->friction(springs, c)->history->used;
    vti_held *next = f->held = malloc((size_t)(f->held_count + 1) * sizeof *f->held);
    if (next == NULL)
        return -1;
    for (int64_t c = 0; c < chunks; ++c) {
        const vti_history *history = springs->kind->friction(springs, c)->history;
        for (int64_t k = 0; k < history->used; ++k)
            *next++ = history->held[k];
    }
    qsort(f->held, (size_t)f->held_count, sizeof *f->held, compare_held);
    return 0;
}

/** A spring pulls its body back by what it holds (vti_held). */
static void take_spring(const struct finding *f, struct touch *touch)
{
    const vti_held key = {.i = 1 + touch->i, .j = touch->j < 0 ? touch->j : 1 + touch->j};
    const vti_held *found = bsearch(&key, f->held, (size_t)f->held_count, sizeof *f->held, compare_held);
    for (int c = 0; c < 3 && found != NULL; ++c)
        touch->tangential[c] = -found->sliding[c];
}

/* ---- touches ----------------------------------------------------------------------------------------------------- */

static void load_place(const vti_bodies *b, int64_t i, double x[3])
{
    for (int c = 0; c < 3; ++c)
        x[c] = b->x.c[c][i * b->x.stride];
}

/** A new one at the end of the list; NULL if there is no memory. */
static struct touch *add(struct finding *f, int64_t i, int64_t j, double overlap)
{
    struct touch_list *list = f->list;
    if (list->count == list->room) {
        const int64_t room = list->room > 0 ? 2 * list->room : 64;
        struct touch *more = realloc(list->touch, (size_t)room * sizeof *more);
        f->failed |= more == NULL;
        if (more == NULL)
            return NULL;
        list->touch = more;
        list->room = room;
    }
    struct touch *touch = &list->touch[list->count++];
    *touch = (struct touch){.i = i, .j = j, .overlap = overlap};
    load_place(&f->spheres, i, touch->from);
    take_spring(f, touch);
    return touch;
}

/** The force that one touch has put on body i. */
static void take_force(const struct finding *f, int64_t i, double force[3])
{
    memcpy(force, f->force + 3 * i, 3 * sizeof *force);
    memset(f->force + 3 * i, 0, 3 * sizeof *force);
}

static void find_pair(struct finding *f, int64_t k)
{
    const vti_contacts *p = f->surfaces.contacts;
    const int64_t i = p->pair[2 * k], j = p->pair[2 * k + 1];
    const double overlap = contact_length(p, k) - partings_distance(&f->spheres.x, i, j);
    struct touch *touch = overlap > 0.0 ? add(f, i, j, overlap) : NULL;
    double back[3];
    if (touch == NULL)
        return;
    load_place(&f->spheres, j, touch->to);
    touches_add_pair(p, k, &f->spheres);
    take_force(f, i, touch->normal);
    take_force(f, j, back);
}

static void find_at_wall(struct finding *f, int64_t w, int64_t i)
{
    const vti_walls *p = f->surfaces.walls;
    double x[3], n[3] = {0.0};
    load_place(&f->spheres, i, x);
    const double gap = vti_walls_gap(p, w, x, n), overlap = 0.5 * p->diameter.p[i * p->diameter.stride] - gap;
    struct touch *touch = overlap > 0.0 ? add(f, i, -1 - w, overlap) : NULL;
    if (touch == NULL)
        return;
    for (int c = 0; c < 3; ++c)
        touch->to[c] = x[c] - gap * n[c];
    touches_add_wall(p, w, i, &f->spheres);
    take_force(f, i, touch->normal);
}

static void find_all(struct finding *f)
{
    const vti_contacts *pairs = f->surfaces.contacts;
    const vti_walls *walls = f->surfaces.walls;
    for (int64_t k = 0; pairs != NULL && k < pairs->count && !f->failed; ++k)
        find_pair(f, k);
    for (int64_t w = 0; walls != NULL && w < wall_count(walls); ++w)
        for (int64_t i = 0; i < f->spheres.count && !f->failed; ++i)
            find_at_wall(f, w, i);
}

/* ---- as people number them --------------------------------------------------------------------------------------- */

/** The other way round. */
static void turn(struct touch *touch)
{
    const struct touch was = *touch;
    touch->i = was.j;
    touch->j = was.i;
    for (int c = 0; c < 3; ++c) {
        touch->from[c] = was.to[c];
        touch->to[c] = was.from[c];
        touch->normal[c] = -was.normal[c];
        touch->tangential[c] = -was.tangential[c];
    }
}

static int compare_touches(const void *a, const void *b)
{
    const struct touch *p = a, *q = b;
    return by_numbers(p->i, p->j, q->i, q->j);
}

static void put_in_order(const struct model *model, struct touch_list *list)
{
    for (int64_t k = 0; k < list->count && model->number != NULL; ++k) {
        struct touch *touch = &list->touch[k];
        touch->i = model_number(model, touch->i);
        touch->j = model_number(model, touch->j); /* walls keep theirs */
        if (touch->j > -1 && touch->j < touch->i)
            turn(touch);
    }
    qsort(list->touch, (size_t)list->count, sizeof *list->touch, compare_touches);
}

/* ---- together ---------------------------------------------------------------------------------------------------- */

int touch_forces_may(const struct model *model)
{
    const struct effect_surfaces surfaces = model_surfaces(model);
    return surfaces.contacts != NULL || surfaces.walls != NULL;
}

int touch_forces_find(const struct model *model, const vti_bodies *bodies, struct touch_list *list)
{
    struct finding f = {.surfaces = model_surfaces(model),
                        .spheres = model_has_clumps(model) ? *model_spheres(model) : *bodies,
                        .list = list};
    list->count = 0;
    f.force = calloc((size_t)(3 * f.spheres.count), sizeof *f.force);
    f.failed = f.force == NULL || sort_held(&f, effect_with_friction(model)) != 0;
    f.spheres.force = vti_view_packed(f.force);
    f.spheres.moment = vti_view_none();
    if (!f.failed)
        find_all(&f);
    if (!f.failed && list->count > 0)
        put_in_order(model, list);
    free(f.force);
    free(f.held);
    return f.failed ? -1 : 0;
}

void touch_forces_free(struct touch_list *list)
{
    free(list->touch);
    memset(list, 0, sizeof *list);
}
