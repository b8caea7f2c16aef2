/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A free chain of bonded spheres (moment, axial and objective shear) that moves, bends and tumbles. */
#ifndef VTI_TESTS_CHAIN_H
#define VTI_TESTS_CHAIN_H

#include "bodies.h"
#include "play.h"

enum { LINKS = 10 };
enum chain_storage { CHAIN_ALPHA, CHAIN_QUAT };

typedef struct chain {
    int n;
    enum chain_storage storage;
    double x[LINKS][3], v[LINKS][3], force[LINKS][3];
    double alpha[LINKS][3], quat[LINKS][4], omega[LINKS][3], moment[LINKS][3];
    double mass[LINKS], inertia[LINKS], stiffness[3], rest[LINKS][4];
    int64_t pair[LINKS][2];
} chain;

static inline vti_bodies chain_bodies(chain *c)
{
    return bodies_of(c, c->n, c->storage == CHAIN_QUAT);
}

static inline rotor chain_attitude(const chain *c, int i)
{
    return c->storage == CHAIN_QUAT ? quat_of_xyzw(c->quat[i]) : quat_of_alpha(c->alpha[i]);
}

static inline vti_bonds chain_bonds(const chain *c)
{
    const vti_bonds bonds = {c->n - 1,
                             c->pair[0],
                             0,
                             c->rest[0],
                             vti_scalars_one(&c->stiffness[0]),
                             vti_scalars_one(&c->stiffness[1]),
                             vti_scalars_one(&c->stiffness[2]),
                             VTI_SHEAR_OBJECTIVE,
                             NULL};
    return bonds;
}

static inline void chain_load(void *self, const vti_bodies *b)
{
    const vti_bonds bonds = chain_bonds(self);
    const vti_effect effect = vti_bonds_effect(&bonds);
    assert_int_equal(vti_apply(&effect, 1, b), VTI_OK);
}

/** n spheres in a crooked line, bonded, displaced and turned out of rest and set moving at random, so that no force,
 *  moment or velocity is 0 at t = 0. */
static inline void chain_make(chain *c, int n, uint64_t seed, enum chain_storage storage)
{
    rng g = rng_seed(seed);
    memset(c, 0, sizeof *c);
    c->n = n;
    c->storage = storage;
    c->stiffness[0] = 0.8;
    c->stiffness[1] = 3.0;
    c->stiffness[2] = 1.2;
    for (int i = 0; i < n; ++i) {
        random_vector(&g, 0.1, c->x[i]);
        random_vector(&g, 0.5, c->v[i]);
        random_vector(&g, 0.8, c->omega[i]);
        c->x[i][0] += i;
        c->mass[i] = uniform(&g, 0.8, 1.6);
        c->inertia[i] = uniform(&g, 0.5, 1.2);
        c->pair[i][0] = i;
        c->pair[i][1] = i + 1;
    }
    const vti_view x = vti_view_packed(c->x[0]);
    assert_int_equal(vti_bonds_rest(n - 1, c->pair[0], 0, &x, c->rest[0], NULL), VTI_OK);
    for (int i = 0; i < n; ++i) {
        double q[4] = {0, 0, 0, 1}, shift[3];
        random_vector(&g, 0.15, q);
        random_vector(&g, 0.05, shift);
        const double size = sqrt(vti_dot(q, q) + 1);
        for (int k = 0; k < 4; ++k)
            c->quat[i][k] = q[k] / size;
        for (int k = 0; k < 3; ++k) {
            c->x[i][k] += shift[k];
            c->alpha[i][k] = 2 * q[k];
        }
    }
}

static inline void chain_run(chain *c, const vti_stepper *method, double h, int64_t steps)
{
    static chain elsewhere;
    elsewhere = *c;
    const vti_bodies b = chain_bodies(c);
    vti_bodies probed = chain_bodies(&elsewhere);
    probed.force = b.force;
    probed.moment = b.moment;
    chain_load(c, &b);
    vti_step_start(method, h, &b);
    for (int64_t k = 0; k < steps; ++k)
        play_step(method, h, &b, &probed, chain_load, c);
    vti_step_sync(method, h, &b);
}

/** Differences of attitudes, Omega, positions and velocities: the largest over bodies. */
static inline void chain_difference(const chain *c, const chain *d, double e[4])
{
    memset(e, 0, 4 * sizeof *e);
    for (int i = 0; i < c->n; ++i) {
        double w[3], x[3], v[3];
        for (int k = 0; k < 3; ++k) {
            w[k] = c->omega[i][k] - d->omega[i][k];
            x[k] = c->x[i][k] - d->x[i][k];
            v[k] = c->v[i][k] - d->v[i][k];
        }
        e[0] = fmax(e[0], quat_distance(chain_attitude(c, i), chain_attitude(d, i)));
        e[1] = fmax(e[1], vti_norm(w));
        e[2] = fmax(e[2], vti_norm(x));
        e[3] = fmax(e[3], vti_norm(v));
    }
}

#endif
