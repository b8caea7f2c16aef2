/* SPDX-License-Identifier: BSD-3-Clause
 * A smooth function of time with many components, kept as Chebyshev interpolants on panels of equal length. */
#ifndef VTI_PANELS_H
#define VTI_PANELS_H

#include <stdint.h>

enum { PANELS_NODES = 16, PANELS_BLOCK = 64 };

/** Blocks begin where the widest vectors do, in memory of PANELS_SPARE doubles more: loads that cross cache lines take
 *  twice as long. */
enum { PANELS_SPARE = 8 };
static inline double *panels_aligned(double *memory)
{
    const uintptr_t line = PANELS_SPARE * sizeof *memory, over = (uintptr_t)memory % line;
    return over == 0 ? memory : memory + (line - over) / sizeof *memory;
}

struct panels {
    int64_t width;       /* components */
    int64_t count;       /* panels */
    int64_t first, held; /* of those the ones that are in memory */
    double t_end;
    double node[PANELS_NODES];    /* of [-1, 1], ascending */
    double weight[PANELS_NODES];  /* barycentric */
    double last[2][PANELS_NODES]; /* the two highest Chebyshev polynomials at the nodes, up to sign */
    double *values;               /* [held][PANELS_NODES][width] */
};

/** count panels on [0, t_end], the first held of them in memory: whoever sets panels->first fills them anew. Frees what
 *  *panels held before. Returns 0, or -1 if there is no memory. */
int panels_create(struct panels *panels, int64_t width, int64_t count, int64_t held, double t_end);
void panels_destroy(struct panels *panels);

/** Time of tau in [-1, 1] of panel p, and the values at node k to be filled in. From here on p is in memory. */
double panels_time(const struct panels *panels, int64_t p, double tau);
double *panels_row(const struct panels *panels, int64_t p, int k);

/** Largest of the last two Chebyshev coefficients of any component of panel p, in its unit (NULL: 1): what the
 *  interpolant leaves out is smaller. */
double panels_tail(const struct panels *panels, int64_t p, const double *unit);
/** The largest of its values, likewise. */
double panels_most(const struct panels *panels, int64_t p, const double *unit);

/** The panel that holds t, in memory or not, and t's place tau in it. */
int64_t panels_find(const struct panels *panels, double t, double *tau);
/** The same of t = step h, and the places in that panel of the *count steps from there on that lie in it, at most
 *  PANELS_BLOCK; those behind are finite. */
int64_t panels_find_block(const struct panels *panels, double h, int64_t step, double tau[PANELS_BLOCK],
                          int64_t *count);
/** All components at tau of panel p. */
void panels_read(const struct panels *panels, int64_t p, double tau, double *out);
/** All components at the first n of the tau of panel p, out[width][PANELS_BLOCK], with the bits of panels_read; what is
 *  written behind the n is without meaning. The tau behind them are finite. */
void panels_read_block(const struct panels *panels, int64_t p, const double tau[PANELS_BLOCK], int64_t n, double *out);
/** One component at tau of panel p. */
double panels_read_one(const struct panels *panels, int64_t p, double tau, int64_t component);

#endif
