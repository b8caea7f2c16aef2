/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One bond between two bodies. */
#ifndef VTI_TESTS_PAIR_H
#define VTI_TESTS_PAIR_H

#include "matrix.h"

typedef struct pair {
    crowd c;
    web w;
} pair;

/** Bond (0, 1) with stiffnesses in [0.5, 20]. */
static inline void pair_stiffen(pair *p, rng *g)
{
    p->w.pair[0][0] = 0;
    p->w.pair[0][1] = 1;
    p->w.moment[0] = uniform(g, 0.5, 20);
    p->w.axial[0] = uniform(g, 0.5, 20);
    p->w.shear[0] = uniform(g, 0.5, 20);
}

/** Of all terms that are present. */
static inline double pair_energy(pair *p)
{
    const vti_effect effect = vti_bonds_effect(&p->w.bonds);
    const vti_bodies b = crowd_bodies(&p->c);
    double energies[3] = {0, 0, 0};
    effect.energy(effect.self, &b, energies);
    return energies[0] + energies[1] + energies[2];
}

/** A random bond; *s is its distance to the nearest singularity and *size the largest energy within. */
static inline void pair_draw(pair *p, rng *g, enum crowd_storage storage, double *s, double *size)
{
    double r, m, w, bi[3], bj[3];
    do { /* not within 0.3 of a singularity, nor within 0.01 of the kink of the moment at half a turn */
        crowd_clear(&p->c, 2, storage);
        crowd_scatter(&p->c, g, 1, 0.3);
        crowd_tumble(&p->c, g);
        random_unit(g, 3, p->w.rest[0]);
        const double d[3] = {p->c.x[0][0] - p->c.x[1][0], p->c.x[0][1] - p->c.x[1][1], p->c.x[0][2] - p->c.x[1][2]};
        const rotor qi = crowd_attitude(&p->c, 0), qj = crowd_attitude(&p->c, 1);
        quat_rotate(qi, p->w.rest[0], bi);
        quat_rotate(qj, p->w.rest[0], bj);
        for (int k = 0; k < 3; ++k)
            bi[k] += bj[k];
        r = vti_norm(d);
        m = vti_norm(bi);
        w = quat_distance(qi, qj);
    } while (m < 0.3 || w > PI - 0.01);
    p->w.rest[0][3] = uniform(g, 0.5, 2);
    pair_stiffen(p, g);
    *s = fmin(fmin(r, m), 1);
    const double stretch = r / p->w.rest[0][3] + 1;
    *size = p->w.moment[0] * PI * PI / 2 + p->w.axial[0] * stretch * stretch / 2 + 2 * p->w.shear[0];
}

#endif
