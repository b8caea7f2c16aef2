/* SPDX-License-Identifier: BSD-3-Clause
 * What chain.c, the host, and report.c share. */
#ifndef HOST_H
#define HOST_H

#define LAMMPS_LIB_MPI
#include <lammps/library.h>

#include "scene.h"

/** What this rank owns or sees, by LAMMPS' local numbers, and the bonds that pull at what it owns. */
struct local {
    int64_t room, bonds, ours; /* bonds: all, and those whose energy is this rank's */
    int64_t *place;            /* of each tag, or -1 */
    int64_t *pair;
    double *rest, *force, *moment, *quat;
};

struct host {
    void *lammps;
    int rank;
    struct scene scene;
    double *quat; /* attitudes of all spheres, by tag */
    struct local here;
};

/** Memory for so many values more or less; ends all ranks if there is none. */
void *reserve(void *old, int64_t values, size_t size);
/** printf on rank 0. */
void say(const struct host *host, const char *format, ...);

/** The end of a run: how LAMMPS' forces compare with those of all bonds at once, who had what, and where the spheres
 *  are. */
void report(struct host *host);

#endif
