/* SPDX-License-Identifier: BSD-3-Clause
 * What vti-bench times: cases that are called in turn, so that whatever else the machine does meets all alike. */
#ifndef VTI_BENCH_H
#define VTI_BENCH_H

#include "vti.h"

/** One thing that is timed. */
struct bench_case {
    const char *what;         /* as bench.csv has it */
    const char *layout;       /* of the bodies */
    int64_t items;            /* of one call: bodies, bonds, pairs */
    double bytes;             /* that one call reads and writes per item where no cache helps; 0: not counted */
    void (*call)(void *self); /* the whole of it, with nothing left to do but for the clock */
    void *self;
};

enum { BENCH_CASES = 24 };

enum bench_layout { BENCH_PACKED, BENCH_SEPARATE, BENCH_QUATERNIONS, BENCH_STRUCTS, BENCH_LAYOUTS };

/** n bodies that turn and fly at random speeds under small constant loads, in memory of their own. */
struct bench_bodies {
    enum bench_layout layout;
    int64_t n;
    double *memory;
    vti_bodies bodies; /* sealed */
};

/** Returns 0, or -1 where there is no memory. */
int bench_bodies_make(struct bench_bodies *b, enum bench_layout layout, int64_t n);
void bench_bodies_free(struct bench_bodies *b);

/** Sums that nobody reads, or the compiler would leave loops out. */
extern double bench_sums[];

/** Uniform in [-1, 1). */
double bench_random(uint64_t *seed);

/** Memory for so many numbers that begins with a line of the cache, as LAMMPS takes its own; NULL where there is
 *  none. */
double *bench_numbers(int64_t count);

/** Adds steps of these bodies and loops that move the same bytes. Returns how many cases there are then. */
int bench_bodies_cases(struct bench_bodies *b, struct bench_case *cases, int count);

/** Adds the most operations of a core, by the widest vectors that it has: an item is one. Returns how many cases there
 *  are then. */
int bench_peak_cases(struct bench_case *cases, int count);

/** n bodies of three moments, packed, in memory of their own: as spheres that only drift, as tops that do, as spheres
 *  and then tops, and as tops with all that a step needs. */
struct bench_tops {
    int64_t n;
    double *memory;
    vti_bodies spheres, tops, mixed, whole; /* sealed */
};

/** Returns 0, or -1 where there is no memory. */
int bench_tops_make(struct bench_tops *b, int64_t n);
void bench_tops_free(struct bench_tops *b);

/** Adds their drifts and steps, and the drift of NO_SQUISH. Returns how many cases there are then. */
int bench_tops_cases(struct bench_tops *b, struct bench_case *cases, int count);

/** side^3 packed bodies on a lattice, displaced and turned at random, each with its neighbours in a list. */
struct bench_lattice {
    struct bench_bodies of;
    int64_t pairs, *pair;
    double *rest, diameter[2], stiffness[3], plane[6][4];
    vti_bonds bonds;
    vti_contacts touching, apart;
    vti_walls walls;
    vti_history history;
    vti_friction friction;
    vti_dashpots dashpots;
    vti_sum lost[VTI_FRICTION_BOOKS + VTI_DASHPOT_BOOKS];
    vti_effect effect[4];  /* bonds, contacts that touch, contacts that do not, walls */
    vti_effect rubbing[3]; /* contacts that touch, friction, dashpots */
};

/** Returns 0, or -1 where there is no memory. */
int bench_lattice_make(struct bench_lattice *l, int64_t side);
void bench_lattice_free(struct bench_lattice *l);

/** Adds each effect, and the whole step of the bonded lattice. Returns how many cases there are then. */
int bench_lattice_cases(struct bench_lattice *l, struct bench_case *cases, int count);

#endif
