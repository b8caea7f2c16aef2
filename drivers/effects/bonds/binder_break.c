/* SPDX-License-Identifier: BSD-3-Clause
 * Bonds that break (EQUATIONS 6.7): their limits, when each of them broke, and the fragments that are left. */
#include <math.h>
#include <stdlib.h>

#include "binder.h"

/* ---- limits ------------------------------------------------------------------------------------------------------ */

int binder_has_limit(const struct binder_settings *binder, const struct table *table, int limit)
{
    return binder->limit[limit] != 0.0 || (table != NULL && table_has(table, BOND_LIMITS + limit));
}

int binder_may_break(const struct binder_settings *binder, const struct table *table)
{
    int may = 0;
    for (int k = 0; k < LIMITS; ++k)
        may |= binder_has_limit(binder, table, k);
    return may;
}

/** The effect's self is that of its bonds, with which struct binder_self begins. */
static int64_t rupture(const void *self, const vti_bodies *bodies)
{
    const struct binder_self *binder = self;
    if (!binder->breaking.limits)
        return 0;
    const vti_effect effect = vti_rupture_effect(&binder->breaking.rupture);
    return effect.rupture(effect.self, bodies);
}

void binder_add_rupture(vti_effect *effect, int breaks)
{
    static const char *const book[VTI_RUPTURE_BOOKS] = {"lost_rupture"};
    effect->rupture = rupture;
    effect->needs |= 1 << VTI_QUANTITY_X;
    effect->smooth = 0; /* forces end where bonds break */
    if (!breaks)
        return;
    effect->dissipates = 1;
    effect->books = VTI_RUPTURE_BOOKS;
    effect->book = book;
    effect->of_body = VTI_RUPTURE_BOOKS;
}

/* ---- making ------------------------------------------------------------------------------------------------------ */

static int allocate(struct bond_break *b, int64_t all, int64_t bodies)
{
    const size_t n = all > 0 ? (size_t)all : 1;
    b->memory = calloc((LIMITS + 1) * n, sizeof *b->memory);
    b->id = calloc(n, sizeof *b->id);
    b->ends = calloc(2 * n, sizeof *b->ends);
    b->root = calloc((size_t)bodies + 1, sizeof *b->root);
    return b->memory != NULL && b->id != NULL && b->ends != NULL && b->root != NULL ? 0 : -1;
}

void binder_free_breaking(struct bond_break *b)
{
    free(b->memory);
    free(b->id);
    free(b->ends);
    free(b->made);
    free(b->root);
}

/** One limit for all from the scene, or one for each from the table, copied to p; or none. */
static vti_scalars limit_of(const struct binder_settings *binder, const struct table *table, int limit, double *p)
{
    const vti_scalars none = {NULL, 0, 0};
    if (table == NULL || !table_has(table, BOND_LIMITS + limit))
        return binder->limit[limit] != 0.0 ? vti_scalars_one(&binder->limit[limit]) : none;
    for (int64_t k = 0; k < table->rows; ++k)
        p[k] = table->column[BOND_LIMITS + limit][k];
    return vti_scalars_array(p);
}

void binder_take_limits(struct effect *e, const struct table *table)
{
    const struct binder_settings *settings = e->settings;
    struct binder_self *self = e->self;
    struct bond_break *b = &self->breaking;
    vti_scalars *const to[LIMITS] = {&b->rupture.stretch, &b->rupture.normal,  &b->rupture.shear,
                                     &b->rupture.bending, &b->rupture.torsion, &b->rupture.energy};
    for (int k = 0; k < LIMITS; ++k)
        *to[k] = limit_of(settings, table, k, b->memory + k * self->all);
    b->limits = binder_may_break(settings, table);
    b->rupture.bonds = &self->bonds;
    b->rupture.id = b->id;
    b->rupture.lost = e->booked;
    b->rupture.by_body = e->by_body;
}

int binder_make_breaking(struct effect *e, const struct model *model, const struct table *table,
                         struct message *message)
{
    const struct binder_settings *settings = e->settings;
    struct binder_self *self = e->self;
    struct bond_break *b = &self->breaking;
    if (!binder_may_break(settings, table))
        return 0;
    if (allocate(b, self->all, model->bodies.count) != 0)
        return message_set(message, "%s: out of memory for its bonds; use fewer", model->scene->name);
    binder_take_limits(e, table);
    b->broke = b->memory + LIMITS * self->all;
    b->bodies = model->bodies.count;
    b->holding = self->all;
    for (int64_t k = 0; k < self->all; ++k) {
        b->id[k] = k;
        b->ends[2 * k] = self->pair[2 * k];
        b->ends[2 * k + 1] = self->pair[2 * k + 1];
        b->broke[k] = INFINITY;
    }
    return 0;
}

/* ---- what has broken --------------------------------------------------------------------------------------------- */

static struct bond_break *breaking_of(const struct effect *e)
{
    return &((struct binder_self *)e->self)->breaking;
}

static int may(const struct effect *e)
{
    return breaking_of(e)->id != NULL;
}

static int64_t broken(struct effect *e, int64_t step, const int64_t **pair)
{
    struct binder_self *self = e->self;
    struct bond_break *b = &self->breaking;
    const int64_t first = self->bonds.count, count = b->holding - first;
    for (int64_t k = first; k < b->holding; ++k)
        b->broke[b->id[k]] = (double)step;
    *pair = self->pair + 2 * first;
    b->holding = first;
    b->changes += count > 0;
    return count;
}

/* ---- fragments --------------------------------------------------------------------------------------------------- */

/** The first body of the fragment, which the way there is made shorter to. */
static int64_t first_of(int64_t *root, int64_t i)
{
    while (root[i] != i)
        i = root[i] = root[root[i]];
    return i;
}

/** Whether the bond had been made by the end of the step. */
static int was_made(const struct bond_break *b, int64_t m, double step)
{
    return b->made == NULL || b->made[m] <= step;
}

/** Fragments that bonds hold together which have not broken by the end of the step. Returns how many. */
static int64_t find_fragments(const struct effect *e, double step)
{
    const struct binder_self *self = e->self;
    const struct bond_break *b = &self->breaking;
    int64_t *root = b->root, count = 0;
    for (int64_t i = 0; i < b->bodies; ++i)
        root[i] = -1;
    for (int64_t m = 0; m < 2 * self->all; ++m)
        if (was_made(b, m / 2, step))
            root[b->ends[m]] = b->ends[m];
    for (int64_t m = 0; m < self->all; ++m) {
        if (b->broke[m] <= step || !was_made(b, m, step))
            continue;
        const int64_t i = first_of(root, b->ends[2 * m]), j = first_of(root, b->ends[2 * m + 1]);
        root[i > j ? i : j] = i > j ? j : i;
    }
    for (int64_t i = 0; i < b->bodies; ++i)
        count += root[i] == i;
    return count;
}

static void count(const struct effect *e, double value[2])
{
    const double now = 0x1p62; /* behind every step, before what is infinite */
    value[0] = (double)((const struct binder_self *)e->self)->bonds.count;
    value[1] = (double)find_fragments(e, now);
}

static void fragments(const struct effect *e, int64_t step, double *fragment)
{
    const struct bond_break *b = breaking_of(e);
    find_fragments(e, (double)step);
    for (int64_t i = 0; i < b->bodies; ++i)
        fragment[i] = b->root[i] < 0 ? -1.0 : (double)first_of(b->root, i);
}

const struct effect_breaks binder_breaks = {may, broken, {"bonds", "fragments"}, count, fragments};

/* ---- what a run goes on with: when each bond broke --------------------------------------------------------------- */

static int64_t size(const struct effect *e)
{
    const struct binder_self *self = e->self;
    return binder_touches(self) ? binder_touch_size(e) : may(e) ? self->all : 0;
}

static void get(const struct effect *e, double *memory)
{
    if (binder_touches(e->self))
        binder_touch_get(e, memory);
    else
        for (int64_t m = 0; m < size(e); ++m)
            memory[m] = breaking_of(e)->broke[m];
}

int binder_take_out(struct binder_self *self)
{
    struct bond_break *b = &self->breaking;
    int64_t *out = calloc(self->all > 0 ? (size_t)self->all : 1, sizeof *out), n = 0;
    for (int64_t m = 0; out != NULL && m < self->all; ++m)
        if (b->broke[m] < INFINITY)
            out[n++] = m;
    const int taken = out != NULL && vti_rupture_take_out(&b->rupture, n, out) == VTI_OK;
    free(out);
    b->holding = self->bonds.count;
    b->changes += n > 0;
    return taken ? 0 : -1;
}

/** Into a model at t = 0, whose bonds all hold. */
static int64_t put(struct effect *e, const double *memory, int64_t left)
{
    struct binder_self *self = e->self;
    if (binder_touches(self))
        return binder_touch_put(e, memory, left);
    const int64_t all = size(e);
    if (left < all)
        return -1;
    for (int64_t m = 0; m < all; ++m)
        self->breaking.broke[m] = memory[m];
    return all == 0 || binder_take_out(self) == 0 ? all : -1;
}

const struct effect_memory_of binder_memory = {size, get, put};
