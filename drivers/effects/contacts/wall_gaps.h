/* SPDX-License-Identifier: BSD-3-Clause
 * How bodies and walls stand to each other: how deep, how fast. */
#ifndef VTI_WALL_GAPS_H
#define VTI_WALL_GAPS_H

#include "vti.h"

/** The largest speed against a wall, along its normal, of what is at x with the velocity v. NaN if any is. */
double wall_approach(const vti_walls *walls, const double x[3], const double v[3]);

/** The fastest that a point of a wall next to a body goes, squared. */
double wall_fastest(const vti_walls *walls, const vti_bodies *bodies);

/** The largest energy of an overlap, of one sphere in one wall. */
double wall_held(const vti_walls *walls, const vti_bodies *spheres);

/** The sphere that is deepest in a wall, by more than the share `least` of its radius, with *share and *wall; -1 and
 *  *share = least if there is none. */
int64_t wall_deepest(const vti_walls *walls, const vti_bodies *spheres, double least, double *share, int64_t *wall);

/** The first sphere that is as wide as the cylinder it is in, with *wall; -1 if there is none. */
int64_t wall_first_filled(const vti_walls *walls, const vti_bodies *spheres, int64_t *wall);

/** The first wall that moves in its own face alone, whose velocity presses no sphere: of a plane what is along its normal
 *  does, of a cylinder what is across its axis; -1: none. */
int64_t wall_first_sliding(const vti_walls *walls);

#endif
