/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Cells: which spheres are near each other, each pair once. Only cells with bodies in them exist, wide ones for long
 * bodies and, where these are few, narrow ones for short bodies; threads share them. */
#ifndef VTI_CELLS_H
#define VTI_CELLS_H

#include <stdint.h>

#include "pairs.h"

/** Of cells by their widths: the least is 2^-31 of the widest. */
enum { CELLS_LEVELS = 32 };

/** Pairs of a body on the mean beyond which a search gives up, where these are more than so many in all: spheres that
 *  touch have some ten, and those of the wrong unit all others, for which memory would last until the system ends the
 *  program. */
enum { CELLS_CROWD = 1000, CELLS_FEW_PAIRS = 10000000 };

struct cells {
    int64_t n;      /* bodies */
    double *radius; /* [n] > 0, for the caller to fill in */
    double *x;      /* [n][3] finite, likewise */
    int64_t levels; /* that there are: one, where few bodies share a cell of it */
    double width[CELLS_LEVELS];
    int64_t on_level[CELLS_LEVELS]; /* cells that there are of it */
    int64_t *home;                  /* [n] cell of a body */
    struct cell *cell;
    int64_t count;         /* of cells, at most n */
    struct member *member; /* [n] by cell */
    int64_t *slot;         /* [slots], a power of 2: hash table, number of a cell + 1, 0 for none */
    int64_t slots;
    struct pairs *part; /* [parts] what threads have found, each in some of the cells */
    int64_t parts;
};

/** Room for n >= 0 bodies; returns 0, or -1 if memory is out, with *cells as after cells_destroy. */
int cells_create(struct cells *cells, int64_t n);

/** Sets *found to the pairs i < j whose gap, the distance less both radii, is below the skin, in no order that the
 *  caller may rely on. longest is the largest radius. Returns 0, or -1 if memory is out or there is a crowd. */
int cells_search(struct cells *cells, double longest, double skin, struct pairs *found);

/** Whether that search has given up at more than CELLS_CROWD pairs a body. */
int cells_are_crowded(const struct cells *cells, const struct pairs *found);

void cells_destroy(struct cells *cells);

#endif
