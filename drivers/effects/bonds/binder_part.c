/* SPDX-License-Identifier: BSD-3-Clause
 * The bonds that a slice of the bodies feels, as a list of its own. */
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

int binder_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part)
{
    const struct binder_self *self = e->self;
    const vti_bonds *all = &self->bonds;
    const int64_t age = 1 + self->breaking.changes;
    if (part->age == age)
        return 0;
    const int64_t n = vti_pairs_of_slice(all->count, all->pair, all->base, slice->first, slice->count, NULL);
    int64_t *which = calloc(n > 0 ? (size_t)n : 1, sizeof *which);
    double *memory = effect_part_room(part, (2 + REST + TURN + STIFFNESSES) * n);
    if (which != NULL && memory != NULL) {
        vti_pairs_of_slice(all->count, all->pair, all->base, slice->first, slice->count, which);
        part->bonds = *all;
        part->bonds.count = n;
        copy_bonds(all, which, &part->bonds, (int64_t *)(void *)(memory + (REST + TURN + STIFFNESSES) * n), memory);
        part->made = vti_bonds_effect(&part->bonds);
        part->age = age;
    }
    free(which);
    return part->age == age ? 0 : -1;
}
