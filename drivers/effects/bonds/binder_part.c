/* SPDX-License-Identifier: BSD-3-Clause
 * The bonds that a slice of the bodies feels: a range of the list, where it has few others, or a list of its own. */
#include <stdlib.h>
#include <string.h>

#include "binder.h"

enum { REST = 4, TURN = 4, STIFFNESSES = 3 };

static void copy_bonds(const vti_bonds *all, const int64_t *which, vti_bonds *part, int64_t *pair, double *rest)
{
    double *turn = rest + REST * part->count, *next = turn + TURN * part->count;
    const vti_scalars *const from[STIFFNESSES] = {&all->moment, &all->axial, &all->shear};
    vti_scalars *const to[STIFFNESSES] = {&part->moment, &part->axial, &part->shear};
    for (int64_t k = 0; k < part->count; ++k) {
        memcpy(pair + 2 * k, all->pair + 2 * which[k], 2 * sizeof *pair);
        memcpy(rest + REST * k, all->rest + REST * which[k], REST * sizeof *rest);
        if (all->turn != NULL)
            memcpy(turn + TURN * k, all->turn + TURN * which[k], TURN * sizeof *turn);
    }
    for (int c = 0; c < STIFFNESSES; ++c) {
        if (from[c]->p == NULL || from[c]->stride == 0)
            continue;
        for (int64_t k = 0; k < part->count; ++k)
            next[k] = from[c]->p[which[k] * from[c]->stride];
        *to[c] = vti_scalars_array(next);
        next += part->count;
    }
    part->pair = pair;
    part->rest = rest;
    part->turn = all->turn != NULL ? turn : NULL;
}

/** Where the bonds of a slice begin and end in the list, and how many they are. */
struct range {
    int64_t first, last, count;
};

static struct range find_range(const vti_bonds *all, const vti_bodies *slice)
{
    struct range r = {0, 0, 0};
    for (int64_t k = 0; k < all->count; ++k)
        if (vti_pairs_of_slice(1, all->pair + 2 * k, all->base, slice->first, slice->count, NULL) > 0) {
            r.first = r.count == 0 ? k : r.first;
            r.last = k + 1;
            ++r.count;
        }
    return r;
}

/** The range without a copy; what it has of others adds nothing to the bodies of the slice. */
static void lend_bonds(const vti_bonds *all, struct range r, vti_bonds *part)
{
    vti_scalars *const stiffness[STIFFNESSES] = {&part->moment, &part->axial, &part->shear};
    part->count = r.last - r.first;
    part->pair = all->pair + 2 * r.first;
    part->rest = all->rest + REST * r.first;
    part->turn = all->turn != NULL ? all->turn + TURN * r.first : NULL;
    for (int c = 0; c < STIFFNESSES; ++c)
        if (stiffness[c]->p != NULL)
            stiffness[c]->p += r.first * stiffness[c]->stride;
}

static int own_bonds(const vti_bonds *all, int64_t n, const vti_bodies *slice, struct effect_part *part)
{
    int64_t *which = calloc(n > 0 ? (size_t)n : 1, sizeof *which);
    double *memory = effect_part_room(part, (2 + REST + TURN + STIFFNESSES) * n);
    const int fits = which != NULL && memory != NULL;
    if (fits) {
        vti_pairs_of_slice(all->count, all->pair, all->base, slice->first, slice->count, which);
        part->bonds.count = n;
        copy_bonds(all, which, &part->bonds, (int64_t *)(void *)(memory + (REST + TURN + STIFFNESSES) * n), memory);
    }
    free(which);
    return fits ? 0 : -1;
}

int binder_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part)
{
    enum { FEW = 16 }; /* one of so many may be another's */
    const struct binder_self *self = e->self;
    const vti_bonds *all = &self->bonds;
    const int64_t age = 1 + self->breaking.changes;
    if (part->age == age)
        return 0;
    const struct range r = find_range(all, slice);
    part->bonds = *all;
    if (r.last - r.first <= r.count + r.count / FEW)
        lend_bonds(all, r, &part->bonds);
    else if (own_bonds(all, r.count, slice, part) != 0)
        return -1;
    part->made = vti_bonds_effect(&part->bonds);
    part->age = age;
    return 0;
}
