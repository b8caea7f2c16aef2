/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Clumps for the tests: a crowd of bodies and the crowd of their spheres. */
#ifndef VTI_TESTS_TROOP_H
#define VTI_TESTS_TROOP_H

#include "crowd.h"

typedef struct troop {
    crowd c, s; /* bodies, and their spheres */
    int64_t body[CROWD_MAX], pair[CROWD_MAX * CROWD_MAX][2];
    double offset[CROWD_MAX][3], diameter[CROWD_MAX];
    vti_clumps clumps; /* these point into the troop, which therefore is not to be copied */
    vti_contacts contacts;
} troop;

/** Views on all that there is. */
static inline void troop_link(troop *t)
{
    t->clumps = (vti_clumps){t->s.n, t->body, 0, t->offset[0], crowd_bodies(&t->s)};
}

/** Contacts of all pairs of spheres that are not of one body. */
static inline void troop_touch(troop *t, double stiffness)
{
    int64_t count = 0;
    for (int64_t s = 0; s < t->s.n; ++s)
        for (int64_t other = 0; other < s; ++other)
            if (t->body[s] != t->body[other]) {
                t->pair[count][0] = other;
                t->pair[count++][1] = s;
            }
    t->contacts = (vti_contacts){
        .count = count, .pair = t->pair[0], .diameter = vti_scalars_array(t->diameter), .stiffness = stiffness};
}

/** n bodies in a box, turned anyhow, of 0 to most spheres each at offsets up to size. */
static inline void troop_draw(troop *t, rng *g, int n, int most, double size, enum crowd_storage storage,
                              enum crowd_storage of_spheres)
{
    crowd_clear(&t->c, n, storage);
    crowd_scatter(&t->c, g, 1, 0.2);
    crowd_tumble(&t->c, g);
    int count = 0;
    for (int i = 0; i < n; ++i) {
        t->c.mass[i] = uniform(g, 0.5, 2);
        t->c.inertia[i] = uniform(g, 0.5, 2);
        random_vector(g, 0.5, t->c.v[i]);
        random_vector(g, 0.5, t->c.omega[i]);
        for (int k = rng_below(g, most + 1); k > 0; --k, ++count) {
            t->body[count] = i;
            random_vector(g, size, t->offset[count]);
            t->diameter[count] = uniform(g, 0.5, 1);
        }
    }
    crowd_clear(&t->s, count, of_spheres);
    troop_link(t);
    troop_touch(t, 10);
}

#endif
