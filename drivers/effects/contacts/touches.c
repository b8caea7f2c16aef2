/* SPDX-License-Identifier: BSD-3-Clause */
#include "touches.h"

#include <string.h>

#include "contact.h"
#include "wall.h"

/** What begins just touching, up to rounding, does not touch yet. */
static const double nearly = 1.0 - 1e-12;

static int pair_touches(const vti_contacts *p, int64_t k, const vti_view *x, double nearer)
{
    return partings_distance(x, p->pair[2 * k], p->pair[2 * k + 1]) < contact_length(p, k) * nearer;
}

static int wall_touches(const vti_walls *p, int64_t w, int64_t i, const vti_view *x, double nearer)
{
    return wall_gap(p, w, x, i) < 0.5 * p->diameter.p[i * p->diameter.stride] * nearer;
}

void touches_add_pair(const vti_contacts *p, int64_t k, const vti_bodies *b)
{
    vti_contacts one = *p;
    one.count = 1;
    one.pair = p->pair + 2 * k;
    if (p->length.p != NULL)
        one.length = vti_scalars_one(p->length.p + k * p->length.stride);
    const vti_effect effect = vti_contacts_effect(&one);
    effect.apply(effect.self, b);
}

void touches_add_wall(const vti_walls *p, int64_t w, int64_t i, const vti_bodies *b)
{
    vti_walls one = *p;
    one.count = w < p->count;
    one.cylinders = 1 - one.count;
    if (one.count > 0)
        one.plane = p->plane + 4 * w;
    else
        one.cylinder = p->cylinder + 7 * (w - p->count);
    one.each = p->each != NULL ? p->each + w : NULL;
    one.moduli = p->moduli != NULL ? p->moduli + w : NULL;
    one.motion = p->motion != NULL ? p->motion + w : NULL;
    const vti_bodies slice = vti_bodies_slice(*b, i, 1);
    const vti_effect effect = vti_walls_effect(&one);
    effect.apply(effect.self, &slice);
}

void touches_take_new(const struct effect_surfaces *surfaces, const double *start, const vti_bodies *bodies,
                      double *scratch)
{
    const vti_contacts *const pairs = surfaces->contacts;
    const vti_walls *const walls = surfaces->walls;
    const vti_view was = vti_view_packed((double *)start);
    const size_t n = (size_t)bodies->count;
    vti_bodies b = *bodies;
    memset(scratch, 0, 3 * n * sizeof *scratch);
    b.force = vti_view_packed(scratch);
    b.moment = vti_view_none();
    for (int64_t k = 0; pairs != NULL && k < pairs->count; ++k)
        if (pair_touches(pairs, k, &b.x, 1.0) && !pair_touches(pairs, k, &was, nearly))
            touches_add_pair(pairs, k, &b);
    for (int64_t w = 0; walls != NULL && w < wall_count(walls); ++w)
        for (int64_t i = 0; i < b.count; ++i)
            if (wall_touches(walls, w, i, &b.x, 1.0) && !wall_touches(walls, w, i, &was, nearly))
                touches_add_wall(walls, w, i, &b);
    for (size_t k = 0; k < 3 * n; ++k)
        bodies->force.c[0][k] -= scratch[k];
}
