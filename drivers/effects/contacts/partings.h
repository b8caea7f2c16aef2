/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies whose bond has broken: where they overlap at that moment, contact between them begins at the distance that
 * they have then, until they have been apart (EQUATIONS 6.7). Otherwise rupture would put energy into the motion. */
#ifndef VTI_PARTINGS_H
#define VTI_PARTINGS_H

#include "vti.h"

struct parting {
    int64_t i, j;  /* i < j */
    double length; /* at which they begin to touch; 0: as all others do */
};

struct partings {
    int64_t count, room, own; /* own: how many have a length */
    struct parting *list;     /* ascending by i, then by j */
};

/** (D_i + D_j)/2 */
double partings_touching(const vti_scalars *diameter, int64_t i, int64_t j);
/** Adds a pair, either way round, that is at such a distance now. Returns 0, or -1 if there is no memory. */
int partings_add(struct partings *p, int64_t i, int64_t j, double distance, const vti_scalars *diameter);
/** Pairs that are apart at x have no length of their own any more. Returns how many these are. */
int64_t partings_end(struct partings *p, const vti_view *x, const vti_scalars *diameter);
/** Distances at which the count pairs of a list begin to touch, which ascends as partings do. */
void partings_lengths(const struct partings *p, const vti_scalars *diameter, int64_t count, const int64_t *pair,
                      double *length);
void partings_destroy(struct partings *p);

/** |x_i - x_j| */
double partings_distance(const vti_view *x, int64_t i, int64_t j);

/* What a run goes on with: how many doubles, and the doubles. */
int64_t partings_size(const struct partings *p);
void partings_get(const struct partings *p, double *memory);
/** Returns how many doubles it took of at most left, or -1: they are none of these, or there is no memory. */
int64_t partings_put(struct partings *p, const double *memory, int64_t left);

#endif
