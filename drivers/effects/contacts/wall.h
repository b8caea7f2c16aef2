/* SPDX-License-Identifier: BSD-3-Clause
 * What the files of walls share. */
#ifndef VTI_WALL_ROOM_H
#define VTI_WALL_ROOM_H

#include "kind.h"
#include "scene.h"
#include "vti.h"

/* ---- what a scene says (wall_keys.c) ----------------------------------------------------------------------------- */

struct wall_settings {
    double stiffness;      /* 0: each its own, or that of materials */
    double young, poisson; /* of the walls, if they have a material */
    struct scene_planes planes;
    struct scene_cylinders cylinders;
    struct scene_numbers each, spins;
    struct scene_vectors velocities;
};

static inline int64_t wall_settings_count(const struct wall_settings *wall)
{
    return wall->planes.count + wall->cylinders.count;
}

enum { WALL_FIELDS = 9 };
extern const struct scene_field wall_fields[WALL_FIELDS];
/** As in kind.h. */
int wall_check(const struct scene_reader *reader, const struct scene *scene, const void *settings);

/* ---- how bodies and walls stand to each other: how deep, how fast (wall_gaps.c) ---------------------------------- */

/** Planes and cylinders. */
static inline int64_t wall_count(const vti_walls *walls)
{
    return walls->count + walls->cylinders;
}

/** The distance of wall w from the centre, at x, of sphere i. */
double wall_gap(const vti_walls *walls, int64_t w, const vti_view *x, int64_t i);

/** The largest speed against a wall, along its normal, of what is at x with the velocity v. NaN if any is. */
double wall_approach(const vti_walls *walls, const double x[3], const double v[3]);

/** The fastest that a point of a wall next to a body goes, squared. */
double wall_fastest(const vti_walls *walls, const vti_bodies *bodies);

/** The largest energy of an overlap, of one sphere in one wall. */
double wall_held(const vti_walls *walls, const vti_bodies *spheres);

/** The sphere that is deepest in a wall, by more than the share `least` of its radius, with *share and *wall; -1 and
 *  *share = least if there is none. */
int64_t wall_deepest(const vti_walls *walls, const vti_bodies *spheres, double least, double *share, int64_t *wall);

/** The largest change of a body's velocity by a touch that the step has missed; as in kind.h (wall_missed.c). */
double wall_missed(const vti_walls *walls, const struct effect_way *way);

/** The first sphere that is as wide as the cylinder it is in, with *wall; -1 if there is none. */
int64_t wall_first_filled(const vti_walls *walls, const vti_bodies *spheres, int64_t *wall);

/** The first wall that moves in its own face alone, whose velocity presses no sphere: of a plane what is along its
 *  normal does, of a cylinder what is across its axis; -1: none. */
int64_t wall_first_sliding(const vti_walls *walls);

#endif
