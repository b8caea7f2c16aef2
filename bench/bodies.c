/* SPDX-License-Identifier: BSD-3-Clause
 * Bodies in the layouts that hosts have, their steps, and loops that move the same bytes and hardly compute. */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>

#include "bench.h"
#include "wide.h"

static const double h = 1e-3;

/* ---- memory ------------------------------------------------------------------------------------------------------ */

double *bench_numbers(int64_t count)
{
    enum { LINE = 64 };
    void *memory = NULL;
    return posix_memalign(&memory, LINE, sizeof(double) * (size_t)count) == 0 ? memory : NULL;
}

/** Where the quantities of a body begin among its numbers, in structs; v and the other vectors follow in this order. */
enum { X, V, FORCE, OMEGA, MOMENT, ALPHA, QUAT = 18, MASS = 22, INERTIA, STRUCT };

/** Vector number q of all bodies, x being 0. */
static vti_view vectors(const struct bench_bodies *b, int q)
{
    double *const p = b->memory + 3 * q * b->n;
    switch (b->layout) {
    case BENCH_SEPARATE:
        return vti_view_separate(p, p + b->n, p + 2 * b->n);
    case BENCH_STRUCTS:
        return vti_view_member(b->memory + 3 * q, STRUCT * (int64_t)sizeof(double));
    default:
        return vti_view_packed(p);
    }
}

static vti_scalars scalars(const struct bench_bodies *b, int q)
{
    return b->layout == BENCH_STRUCTS ? vti_scalars_member(b->memory + q, STRUCT * (int64_t)sizeof(double))
                                      : vti_scalars_array(b->memory + q * b->n);
}

static void set_views(struct bench_bodies *b)
{
    vti_bodies *bodies = &b->bodies;
    *bodies = vti_bodies_none(b->n);
    bodies->x = vectors(b, X);
    bodies->v = vectors(b, V);
    bodies->force = vectors(b, FORCE);
    bodies->omega = vectors(b, OMEGA);
    bodies->moment = vectors(b, MOMENT);
    bodies->mass = scalars(b, MASS);
    bodies->inertia = scalars(b, INERTIA);
    if (b->layout != BENCH_QUATERNIONS) {
        bodies->alpha = vectors(b, ALPHA);
        return;
    }
    for (int k = 0; k < 4; ++k)
        bodies->quat.xyzw[k] = b->memory + QUAT * b->n + k;
    bodies->quat.stride = 4;
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** Uniform in [-1, 1), by Knuth's linear congruence modulo 2^64. */
double bench_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1.0;
}

static void fill(const vti_view *view, int64_t n, double size, uint64_t *seed)
{
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            view->c[k][i * view->stride] = size * bench_random(seed);
}

static void set_values(struct bench_bodies *b)
{
    uint64_t seed = 1;
    const vti_bodies *bodies = &b->bodies;
    const vti_view *const state[] = {&bodies->x, &bodies->v, &bodies->omega};
    for (int k = 0; k < 3; ++k)
        fill(state[k], b->n, 1.0, &seed);
    fill(&bodies->force, b->n, 1e-6, &seed); /* however long it runs, h|Omega| stays small */
    fill(&bodies->moment, b->n, 1e-6, &seed);
    for (int64_t i = 0; i < b->n; ++i) {
        ((double *)bodies->mass.p)[i * bodies->mass.stride] = 1.5 + 0.5 * bench_random(&seed);
        ((double *)bodies->inertia.p)[i * bodies->inertia.stride] = 0.15 + 0.05 * bench_random(&seed);
        for (int k = 0; k < 4 && b->layout == BENCH_QUATERNIONS; ++k)
            bodies->quat.xyzw[k][4 * i] = k == 3;
    }
    if (b->layout != BENCH_QUATERNIONS)
        fill(&bodies->alpha, b->n, 0.5, &seed);
}

int bench_bodies_make(struct bench_bodies *b, enum bench_layout layout, int64_t n)
{
    b->layout = layout;
    b->n = n;
    b->memory = bench_numbers(STRUCT * n);
    if (b->memory == NULL)
        return -1;
    set_views(b);
    set_values(b);
    return vti_bodies_seal(&b->bodies) == VTI_OK ? 0 : -1;
}

void bench_bodies_free(struct bench_bodies *b)
{
    free(b->memory);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static void step(const char *name, struct bench_bodies *b)
{
    const vti_stepper *method = vti_stepper_find(name);
    vti_step_begin(method, h, &b->bodies, NULL);
    vti_step_finish(method, h, &b->bodies);
}

static void step_vti1(void *self)
{
    step("vti1", self);
}

static void step_vti2(void *self)
{
    step("vti2", self);
}

static void step_exact(void *self)
{
    step("exact", self);
}

static void next_vti2(void *self)
{
    struct bench_bodies *b = self;
    vti_step_next(vti_stepper_find("vti2"), h, &b->bodies, NULL);
}

/* ---- the same bytes ---------------------------------------------------------------------------------------------- */

/** y += t x of count numbers */
VTI_INLINE void add(double *restrict y, double t, const double *restrict x, int64_t count)
{
    for (int64_t k = 0; k < count; ++k)
        y[k] += t * x[k];
}

enum { TILE = 64 };
double bench_sums[TILE];

/** Reads the masses and inertias of a tile. What is summed anybody may look at, so that no compiler leaves it out. */
VTI_INLINE void read_constants(const double *mass, const double *inertia, int64_t count)
{
    for (int64_t i = 0; i < count; ++i)
        bench_sums[i] = mass[i] + inertia[i];
}

/** What a kick reads and writes, and a drift after it, where arrays lie whole; by tiles, so that each number comes from
 *  memory once. By the widest vectors that the machine has, whatever the steps beside it have. */
VTI_INLINE void pass_loops(double *memory, int64_t n, int drifts)
{
    for (int64_t first = 0; first < n; first += TILE) {
        const int64_t count = n - first < TILE ? n - first : TILE;
        double *at[ALPHA + 1];
        for (int q = X; q <= ALPHA; ++q)
            at[q] = memory + 3 * (q * n + first);
        add(at[V], 1e-9, at[FORCE], 3 * count);
        add(at[OMEGA], 1e-9, at[MOMENT], 3 * count);
        read_constants(memory + MASS * n + first, memory + INERTIA * n + first, count);
        if (drifts) {
            add(at[X], 1e-9, at[V], 3 * count);
            add(at[ALPHA], 1e-9, at[OMEGA], 3 * count);
        }
    }
}

static void pass(double *memory, int64_t n, int drifts);
WIDE(pass, (double *memory, int64_t n, int drifts), (memory, n, drifts))

static void bytes_step(void *self)
{
    const struct bench_bodies *b = self;
    pass(b->memory, b->n, 1);
    pass(b->memory, b->n, 0);
}

static void bytes_next(void *self)
{
    const struct bench_bodies *b = self;
    pass(b->memory, b->n, 1);
}

/* ---- cases ------------------------------------------------------------------------------------------------------- */

int bench_bodies_cases(struct bench_bodies *b, struct bench_case *cases, int count)
{
    static const char *const layouts[BENCH_LAYOUTS] = {"packed", "separate", "quaternions", "structs"};
    static const struct {
        const char *what;
        void (*call)(void *self);
        int reads, writes; /* numbers of a body */
    } all[] = {{"vti2", step_vti2, 20 + 14, 12 + 6},   {"vti1", step_vti1, 20 + 14, 12 + 6},
               {"exact", step_exact, 20 + 14, 12 + 6}, {"vti2 next", next_vti2, 20, 12},
               {"bytes", bytes_step, 20 + 14, 12 + 6}, {"bytes next", bytes_next, 20, 12}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        const int loop = k >= 4;
        if (loop && b->layout != BENCH_PACKED)
            continue;
        const int more = b->layout == BENCH_QUATERNIONS; /* a number more of each attitude */
        const struct bench_case one = {.what = all[k].what,
                                       .layout = layouts[b->layout],
                                       .items = b->n,
                                       .bytes = 8.0 * (all[k].reads + all[k].writes + 2 * more),
                                       .call = all[k].call,
                                       .self = b};
        cases[count++] = one;
    }
    return count;
}
