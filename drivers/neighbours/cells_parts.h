/* SPDX-License-Identifier: BSD-3-Clause
 * What filling cells (cells.c) and searching them (cells_search.c) share. */
#ifndef VTI_CELLS_PARTS_H
#define VTI_CELLS_PARTS_H

#include <math.h>
#include <string.h>

#include "cells.h"

/** Cells are counted to 2^40 either way, where x/width is rounded to 2^-13 of a cell: as they are 2^-10 wider than any
 *  reach, bodies in reach are never more than one cell apart. What is farther out shares the last cells. */
#define CELLS_LAST 0x1p40
#define CELLS_MARGIN (1.0 + 0x1p-10)

/** Levels of cells stand so far apart in z that none of the one is beside any of the other. */
#define CELLS_APART ((int64_t)1 << 44)

/** A body as its cell stores it, so that cells are read in one go. */
struct member {
    double x[3], radius;
    int64_t body;
};

struct cell {
    int64_t q[3], begin, end; /* its members */
};

/** The cell at x. */
static inline void cells_at(const struct cells *s, const double x[3], int64_t level, int64_t q[3])
{
    const double width = s->width[level];
    for (int k = 0; k < 3; ++k)
        q[k] = (int64_t)floor(fmax(-CELLS_LAST, fmin(x[k] / width, CELLS_LAST)));
    q[2] += level * CELLS_APART;
}

static inline int64_t cells_level(const struct cell *cell)
{
    return (cell->q[2] + CELLS_APART / 2) / CELLS_APART;
}

/** Hashes of cells take in x, y and z one after the other, so that cells in a line share the most of it. */
static inline uint64_t cells_hash(uint64_t h, int64_t q)
{
    h = (h ^ (uint64_t)q) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 32;
}

/** The slot of the cell q, which has the hash h, or the empty one where it belongs. */
static inline int64_t *cells_slot(const struct cells *s, uint64_t h, const int64_t q[3])
{
    const uint64_t mask = (uint64_t)s->slots - 1;
    for (h &= mask;; h = (h + 1) & mask) {
        const int64_t c = s->slot[h] - 1;
        if (c < 0 || memcmp(s->cell[c].q, q, sizeof s->cell[c].q) == 0)
            return &s->slot[h];
    }
}

/** Every body into its cell, of level 0 or, where these would be crowded, of its own level. */
void cells_fill(struct cells *cells, double longest, double skin);

#endif
