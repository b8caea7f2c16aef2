/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The torus of the paper (EQUATIONS 3) as the library computes it: a ring of 80 bonded bodies that flies at a wall.
 * Contact is between all pairs that are not bonded. */
#ifndef VTI_TESTS_TORUS_H
#define VTI_TESTS_TORUS_H

#include "crowd.h"
#include "torus_quad.h"

enum { RING = 80, RING_PAIRS = RING * (RING - 1) / 2 - RING };

typedef struct torus {
    crowd c;
    web w;
    int64_t pair[RING_PAIRS][2];
    double diameter, plane[4];
    vti_contacts contacts;
    vti_walls walls;
    vti_effect effects[3];
} torus;

/** At t = 0. The torus points into itself and is not to be copied. */
static inline void torus_start(torus *t, int form)
{
    crowd_clear(&t->c, RING, CROWD_ALPHA);
    t->diameter = 3 * sin(PI / 80);
    int64_t count = 0;
    for (int k = 0; k < RING; ++k) {
        const double angle = 2 * PI * k / 80;
        t->c.x[k][0] = 1.5 + 0.5 * t->diameter + 1.5 * cos(angle);
        t->c.x[k][1] = 1.5 * sin(angle);
        t->c.v[k][0] = -1;
        t->w.pair[k][0] = k;
        t->w.pair[k][1] = (k + 1) % RING;
        t->w.moment[k] = 10;
        t->w.axial[k] = t->w.shear[k] = 200;
        for (int j = k + 2; j < RING; ++j)
            if (!(k == 0 && j == RING - 1)) {
                t->pair[count][0] = k;
                t->pair[count++][1] = j;
            }
    }
    assert_int_equal(count, RING_PAIRS);
    const vti_view x = vti_view_packed(t->c.x[0]);
    assert_int_equal(vti_bonds_rest(RING, t->w.pair[0], 0, &x, t->w.rest[0], NULL), VTI_OK);
    web_terms(&t->w, RING, MOMENT | AXIAL | SHEAR, form);
    const vti_contacts contacts = {
        .count = RING_PAIRS, .pair = t->pair[0], .diameter = vti_scalars_one(&t->diameter), .stiffness = 2100};
    const vti_walls walls = {
        .count = 1, .plane = t->plane, .diameter = vti_scalars_one(&t->diameter), .stiffness = 2100};
    t->plane[0] = 1;
    t->plane[1] = t->plane[2] = t->plane[3] = 0;
    t->contacts = contacts;
    t->walls = walls;
    t->effects[0] = vti_bonds_effect(&t->w.bonds);
    t->effects[1] = vti_contacts_effect(&t->contacts);
    t->effects[2] = vti_walls_effect(&t->walls);
}

/** Energies in the order of torus_quad.h. */
static inline void torus_energies(torus *t, double e[TORUS_ENERGIES])
{
    const vti_bodies b = crowd_bodies(&t->c);
    e[0] = vti_kinetic_translation(&b);
    e[1] = vti_kinetic_rotation(&b);
    t->effects[0].energy(t->effects[0].self, &b, e + 2);
    t->effects[1].energy(t->effects[1].self, &b, e + 5);
    t->effects[2].energy(t->effects[2].self, &b, e + 6);
    e[7] = vti_energy(t->effects, 3, &b);
}

#endif
