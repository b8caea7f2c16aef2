/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the digest is made of: a hash over the bits of numbers, a seeded generator, and a scene with every effect in it.
 * No libm but sqrt and fabs, no test library: it has to build wherever the core does. */
#ifndef VTI_TESTS_DIGEST_H
#define VTI_TESTS_DIGEST_H

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../bodies.h" /* builds without meson have no other path to it */

/* ---- hash and numbers -------------------------------------------------------------------------------------------- */

/** FNV-1a over 64 bits, byte by byte from the lowest, so that the order of bytes in memory does not matter. */
static inline void hash_add(uint64_t *hash, const double *a, int64_t n)
{
    for (int64_t i = 0; i < n; ++i) {
        uint64_t bits;
        if (isnan(a[i])) { /* its sign and payload are nobody's promise, and none should be here */
            fprintf(stderr, "digest: not a number\n");
            exit(1);
        }
        memcpy(&bits, &a[i], sizeof bits);
        for (int k = 0; k < 64; k += 8)
            *hash = (*hash ^ (bits >> k & 0xff)) * UINT64_C(0x100000001b3);
    }
}

#define HASH_START UINT64_C(0xcbf29ce484222325)

/** splitmix64 */
static inline uint64_t draw(uint64_t *seed)
{
    uint64_t z = (*seed += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static inline double between(uint64_t *seed, double low, double high)
{
    return low + (high - low) * ((double)(int64_t)(draw(seed) >> 11) * 0x1p-53);
}

static inline void draw_vector(uint64_t *seed, double size, double *v, int n)
{
    for (int k = 0; k < n; ++k)
        v[k] = between(seed, -size, size);
}

/* ---- a scene ----------------------------------------------------------------------------------------------------- */

/* More than one block of bonds, and no multiple of any vector's width. */
enum { BODIES = 71, PAIRS = 2 * BODIES - 3 };
enum storage { BY_ALPHA, BY_RESIDUALS, BY_QUATERNION, STORAGES };

typedef struct scene {
    double x[BODIES][3], v[BODIES][3], force[BODIES][3], alpha[BODIES][3], quat[BODIES][4], omega[BODIES][3];
    double moment[BODIES][3], low[4][BODIES][3];
    double mass[BODIES], inertia[BODIES], diameter[BODIES], rest[BODIES - 1][4], stiffness[3], plane[2][4];
    int64_t pair[PAIRS][2]; /* neighbours of the chain, then those two apart */
    vti_bonds bonds;
    vti_contacts contacts;
    vti_walls walls;
    vti_gravity gravity;
    vti_pendulum pendulum;
} scene;

static inline vti_bodies scene_bodies(scene *s, enum storage storage)
{
    vti_bodies b = bodies_of(s, BODIES, storage == BY_QUATERNION);
    if (storage == BY_RESIDUALS) {
        b.x_low = vti_view_packed(s->low[0][0]);
        b.v_low = vti_view_packed(s->low[1][0]);
        b.alpha_low = vti_view_packed(s->low[2][0]);
        b.omega_low = vti_view_packed(s->low[3][0]);
    }
    return b;
}

static inline void scene_lists(scene *s)
{
    for (int i = 0; i < BODIES - 1; ++i) {
        s->pair[i][0] = i;
        s->pair[i][1] = i + 1;
    }
    for (int i = 0; i < BODIES - 2; ++i) {
        s->pair[BODIES - 1 + i][0] = i + 2;
        s->pair[BODIES - 1 + i][1] = i;
    }
}

/** A crooked chain, displaced, turned and set moving, above a floor and beside a slanting wall. */
static inline void scene_make(scene *s, uint64_t seed)
{
    const vti_view x = vti_view_packed(s->x[0]);
    memset(s, 0, sizeof *s);
    scene_lists(s);
    for (int i = 0; i < BODIES; ++i) {
        draw_vector(&seed, 0.1, s->x[i], 3);
        s->x[i][0] += i;
    }
    vti_bonds_rest(BODIES - 1, s->pair[0], 0, &x, s->rest[0], NULL);
    for (int i = 0; i < BODIES; ++i) {
        double shift[3];
        draw_vector(&seed, 0.05, shift, 3);
        draw_vector(&seed, 0.5, s->v[i], 3);
        draw_vector(&seed, 0.15, s->quat[i], 3);
        s->quat[i][3] = 1.0;
        draw_vector(&seed, 0.5, s->omega[i], 3);
        for (int k = 0; k < 3; ++k) {
            s->x[i][k] += shift[k];
            s->omega[i][k] += 1.5; /* together, so that the chain turns through half turns and does not break up */
        }
        vti_rrv_from_quat_xyzw(s->quat[i], s->alpha[i]);
        s->mass[i] = between(&seed, 0.8, 1.6);
        s->inertia[i] = between(&seed, 0.5, 1.2);
        s->diameter[i] = between(&seed, 0.9, 1.1);
    }
}

/** Every effect there is, in the array effects[5]. */
static inline void scene_effects(scene *s, vti_effect *effects)
{
    const double stiffness[3] = {0.8, 3.0, 1.2}, plane[2][4] = {{0.0, 0.0, 1.0, -0.8}, {0.6, 0.8, 0.0, -0.3}};
    const vti_bonds bonds = {BODIES - 1,
                             s->pair[0],
                             0,
                             s->rest[0],
                             vti_scalars_one(&s->stiffness[0]),
                             vti_scalars_one(&s->stiffness[1]),
                             vti_scalars_one(&s->stiffness[2]),
                             VTI_SHEAR_OBJECTIVE,
                             NULL};
    const vti_contacts contacts = {
        .count = PAIRS, .pair = s->pair[0], .diameter = vti_scalars_array(s->diameter), .stiffness = 20.0};
    const vti_walls walls = {
        .count = 2, .plane = s->plane[0], .diameter = vti_scalars_array(s->diameter), .stiffness = 10.0};
    const vti_gravity gravity = {{0.02, -0.1, -0.2}};
    const vti_pendulum pendulum = {0.3, {0.1, 0.2, 0.7}};
    memcpy(s->stiffness, stiffness, sizeof stiffness);
    memcpy(s->plane, plane, sizeof plane);
    s->bonds = bonds;
    s->contacts = contacts;
    s->walls = walls;
    s->gravity = gravity;
    s->pendulum = pendulum;
    effects[0] = vti_bonds_effect(&s->bonds);
    effects[1] = vti_contacts_effect(&s->contacts);
    effects[2] = vti_walls_effect(&s->walls);
    effects[3] = vti_gravity_effect(&s->gravity);
    effects[4] = vti_pendulum_effect(&s->pendulum);
}

enum { EFFECTS = 5 };

#endif
