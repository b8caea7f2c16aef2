/* SPDX-License-Identifier: BSD-3-Clause
 * The chain of examples/chain: its tables, and its binder. Knows nothing of LAMMPS. */
#ifndef SCENE_H
#define SCENE_H

#include "vti.h"

struct scene {
    int64_t bodies, bonds;
    double *x, *v, *alpha, *omega, *mass, *inertia;
    int64_t *pair; /* [bonds][2] */
    double *rest;  /* [bonds][4] */
};

/** Ends all ranks. */
void give_up(const char *what, int64_t number);

void scene_read(struct scene *scene, const char *bodies, const char *bonds);

/** Forces and moments of bonds, numbered as bodies are; returns the energy of the first `ours` of them. */
double scene_apply(int64_t bonds, const int64_t *pair, const double *rest, const vti_bodies *bodies, int64_t ours);

static inline vti_quat_view quat_view(double *xyzw)
{
    vti_quat_view view = {{xyzw, xyzw + 1, xyzw + 2, xyzw + 3}, 4, 0};
    return view;
}

#endif
