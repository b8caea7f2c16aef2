/* SPDX-License-Identifier: BSD-3-Clause */
#include "arrange.h"

#include "plain.h"

/* ---- ring: body k at the angle 2 pi k/n -------------------------------------------------------------------------- */

static void place_ring(const struct scene_ring *ring, double *x)
{
    const double radius = 0.5 * ring->diameter;
    for (int64_t k = 0; k < ring->count; ++k) {
        x[3 * k] = ring->center[0] + plain_cos_turn(radius, k, ring->count);
        x[3 * k + 1] = ring->center[1] + plain_sin_turn(radius, k, ring->count);
        x[3 * k + 2] = ring->center[2];
    }
}

/* ---- chain ------------------------------------------------------------------------------------------------------- */

static void place_chain(const struct scene_chain *chain, double *x)
{
    const double length = vti_norm(chain->direction);
    for (int64_t k = 0; k < chain->count; ++k)
        for (int c = 0; c < 3; ++c)
            x[3 * k + c] = chain->start[c] + (double)k * chain->spacing * (chain->direction[c] / length);
}

/* ---- lattice: x runs fastest ------------------------------------------------------------------------------------- */

/** Steps along x, y and z from the corner to body b. */
static void lattice_site(const struct scene_lattice *lattice, int64_t b, int64_t site[3])
{
    for (int c = 0; c < 3; ++c) {
        site[c] = b % lattice->counts[c];
        b /= lattice->counts[c];
    }
}

static void place_lattice(const struct scene_lattice *lattice, int64_t n, double *x)
{
    for (int64_t b = 0; b < n; ++b) {
        int64_t site[3];
        lattice_site(lattice, b, site);
        for (int c = 0; c < 3; ++c)
            x[3 * b + c] = lattice->corner[c] + (double)site[c] * lattice->spacing;
    }
}

static void bond_lattice(const struct scene_lattice *lattice, int64_t n, int64_t *pair)
{
    const int64_t stride[3] = {1, lattice->counts[0], lattice->counts[0] * lattice->counts[1]};
    for (int64_t b = 0; b < n; ++b) {
        int64_t site[3];
        lattice_site(lattice, b, site);
        for (int c = 0; c < 3; ++c)
            if (site[c] + 1 < lattice->counts[c]) {
                *pair++ = b;
                *pair++ = b + stride[c];
            }
    }
}

/* ---- any --------------------------------------------------------------------------------------------------------- */

void arrange_positions(const struct scene *scene, double *x)
{
    if (scene->arrangement == SCENE_IN_RING)
        place_ring(&scene->ring, x);
    else if (scene->arrangement == SCENE_IN_CHAIN)
        place_chain(&scene->chain, x);
    else if (scene->arrangement == SCENE_IN_LATTICE)
        place_lattice(&scene->lattice, scene_bodies(scene), x);
    else
        for (int c = 0; c < 3; ++c)
            x[c] = scene->x[c];
}

/** Of a ring D_t sin(pi/n). */
double arrange_touching(const struct scene *scene)
{
    return scene->arrangement == SCENE_IN_RING      ? plain_sin_turn(scene->ring.diameter, 1, 2 * scene->ring.count)
           : scene->arrangement == SCENE_IN_CHAIN   ? scene->chain.spacing
           : scene->arrangement == SCENE_IN_LATTICE ? scene->lattice.spacing
                                                    : 0.0;
}

int64_t arrange_bonds(const struct scene *scene)
{
    const int64_t n = scene_bodies(scene), *c = scene->lattice.counts;
    return scene->arrangement == SCENE_IN_RING      ? n
           : scene->arrangement == SCENE_IN_CHAIN   ? n - 1
           : scene->arrangement == SCENE_IN_LATTICE ? 3 * n - c[0] * c[1] - c[1] * c[2] - c[2] * c[0]
                                                    : 0;
}

void arrange_bond_pairs(const struct scene *scene, int64_t *pair)
{
    const int64_t n = scene_bodies(scene), bonds = arrange_bonds(scene);
    if (scene->arrangement == SCENE_IN_LATTICE) {
        bond_lattice(&scene->lattice, n, pair);
        return;
    }
    for (int64_t k = 0; k < bonds; ++k) {
        pair[2 * k] = k;
        pair[2 * k + 1] = (k + 1) % n;
    }
}
