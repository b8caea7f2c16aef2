/* SPDX-License-Identifier: BSD-3-Clause
 * Where the bodies of a ring, chain or lattice are, and which of them are neighbours. Nothing here is for tables. */
#ifndef VTI_ARRANGE_H
#define VTI_ARRANGE_H

#include "scene.h"

/** Centres of the scene_bodies(scene) bodies to x, packed. */
void arrange_positions(const struct scene *scene, double *x);

/** The diameter at which neighbours just touch; 0 for a single body. */
double arrange_touching(const struct scene *scene);

/** Neighbours, each pair once: ring (k, k+1) and last (n-1, 0); chain (k, k+1); lattice body by body, along x, y and
 *  z. */
int64_t arrange_bonds(const struct scene *scene);
/** pair[arrange_bonds][2], bodies from 0. */
void arrange_bond_pairs(const struct scene *scene, int64_t *pair);

#endif
