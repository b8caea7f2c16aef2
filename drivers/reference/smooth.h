/* SPDX-License-Identifier: BSD-3-Clause
 * The reference of a model whose motion is smooth and whose bodies are few: Chebyshev panels, readable at any time.
 *
 * As many panels as memory allows are a window. All of a reference that fits into one stay there. Of a longer one
 * the state at the start of each window is kept, and a window is integrated again from there when somebody reads in
 * it: whoever goes through time in order does that once per window, and finds the same bits as anybody else. */
#ifndef VTI_SMOOTH_H
#define VTI_SMOOTH_H

#include "equations.h"
#include "panels.h"
#include "watch.h"

struct smooth {
    struct model *model;
    struct panels panels;       /* of the bodies' part of a state: those of one window */
    double *state;              /* where integration is, and where smooth_at writes */
    double *block;              /* [a state's width][PANELS_BLOCK] from panels_aligned on: what smooth_block has read */
    double t;                   /* of the integration */
    struct equations equations; /* that integrate */
    int64_t windows, window;    /* how many, and which one is in memory, -1 for none */
    double *starts; /* [windows][SMOOTH_START + a state's width]: t, ||q||^2 as two parts of a sum, and the state */
    vti_sum *sums;  /* [panels.held]: ||q||^2 up to the start of the panels of sums_window */
    int64_t sums_window, sums_known; /* and the last of them that is known */
    double energy_error;             /* largest |E - E_0| at the ends of the panels */
    double tail;                     /* largest panels_tail in units of the state */
    double interpolation_error;      /* the same in the unit of the norm */
    double spread;                   /* smooth_spread */
    double *samples;      /* [SMOOTH_SAMPLES][a state's width]: at SMOOTH_SAMPLES times, evenly up to t_end */
    double rounding;      /* of velocities and spins in all steps, where that is above the tolerance; else 0 */
    double rounding_most; /* the most of a step, likewise, or an ulp or two of what is farthest from 0 */
};

/** A reference that is known to less, relative: its trajectories have parted from the true ones. */
#define REFERENCE_PARTED 1e-3

enum { SMOOTH_START = 3, SMOOTH_SAMPLES = 128 };

/** Room for a reference of *model; the panels are made by smooth_integrate, or by smooth_resize and a copy. */
int smooth_create(struct smooth *smooth, struct model *model, struct message *message);
void smooth_destroy(struct smooth *smooth);
/** Integrates to t_end, with panels of up to bytes in memory. Returns 0, or -1 with one line in *message, or
 *  WATCH_ASKED. */
int smooth_integrate(struct smooth *smooth, double t_end, double bytes, const struct watch *watch,
                     struct message *message);
/** The samples of a solution by a looser tolerance, into other, [SMOOTH_SAMPLES][a state's width]. Likewise. */
int smooth_looser(struct model *model, double t_end, double *other, const struct watch *watch, struct message *message);
/** How well the solution is known, relative, from how far it is from that one. */
double smooth_spread(struct smooth *smooth, const double *other);
/** Room for count panels on [0, t_end], held of them at once. No window is in memory then. Returns 0, or -1 if there
 *  is no memory. */
int smooth_resize(struct smooth *smooth, int64_t count, int64_t held, double t_end);

/** Brings the window of t into memory. Returns as smooth_integrate does. */
int smooth_seek(struct smooth *smooth, double t, const struct watch *watch, struct message *message);
/** At a t whose window is in memory. */
vti_bodies smooth_at(struct smooth *smooth, double t);
/** At t = step h, likewise, with the bits of smooth_at, and at the steps that follow in the same panel, *count in all:
 *  for those who go through time in order. States side by side (states.h), which hold until the next call. */
const double *smooth_block(struct smooth *smooth, double h, int64_t step, int64_t *count);
/** Exact ||q||^2_{H1(0,t)}, likewise: Gauss-Legendre on the panels, split where a body passes a half turn, since the
 *  integrand (theta in [0, pi]) has a kink there. */
double smooth_norm_squared(struct smooth *smooth, double t);

/* Between the two files of it. */

/** ||q||^2 up to the start of a window. */
vti_sum smooth_sum_before(const struct smooth *smooth, int64_t window);
/** The part of ||q||^2 from the start of panel p, which is in memory, to tau = end. Overwrites smooth->state. */
double smooth_panel_integral(struct smooth *smooth, int64_t p, double end);

#endif
