/* SPDX-License-Identifier: BSD-3-Clause
 * Bodies of three moments: drifts of each rotor beside a sphere's and beside NO_SQUISH, and whole steps. */
#include <math.h>
#include <stdlib.h>

#include "bench.h"

static const double h = 1e-3;

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

/** Where the numbers of n bodies begin in memory, in those of one body. */
enum {
    X = 0,
    V = 3,
    FORCE = 6,
    SPIN = 9,
    MOMENT = 12,
    ALPHA = 15,
    MOMENTS = 18,
    MIXED = 21,
    QUAT = 24,
    MOMENTUM = 28,
    MASS = 32,
    ALL = 33
};

static void fill(double *p, int64_t count, double middle, double size, uint64_t *seed)
{
    for (int64_t k = 0; k < count; ++k)
        p[k] = middle + size * bench_random(seed);
}

/** p = 2 S(q) (0, L), L in the body: the momentum of a quaternion q, here the identity. */
static void set_squish(struct bench_tops *b)
{
    double *const q = b->memory + QUAT * b->n, *const p = b->memory + MOMENTUM * b->n;
    const double *const L = b->memory + SPIN * b->n;
    for (int64_t i = 0; i < b->n; ++i)
        for (int k = 0; k < 4; ++k) {
            q[4 * i + k] = k == 0;
            p[4 * i + k] = k == 0 ? 0.0 : 2.0 * L[3 * i + k - 1];
        }
}

static void set_views(struct bench_tops *b)
{
    static const double one = 1.0;
    double *const m = b->memory;
    const int64_t n = b->n;
    vti_bodies drift = vti_bodies_none(n);
    drift.alpha = vti_view_packed(m + ALPHA * n);
    b->spheres = b->tops = b->mixed = drift;
    b->spheres.omega = vti_view_packed(m + SPIN * n);
    b->spheres.inertia = vti_scalars_one(&one);
    b->tops.spin = b->mixed.spin = b->spheres.omega;
    b->tops.moments = vti_view_packed(m + MOMENTS * n);
    b->mixed.moments = vti_view_packed(m + MIXED * n);
    b->whole = b->tops;
    b->whole.x = vti_view_packed(m + X * n);
    b->whole.v = vti_view_packed(m + V * n);
    b->whole.force = vti_view_packed(m + FORCE * n);
    b->whole.moment = vti_view_packed(m + MOMENT * n);
    b->whole.mass = vti_scalars_array(m + MASS * n);
}

int bench_tops_make(struct bench_tops *b, int64_t n)
{
    uint64_t seed = 2;
    b->n = n;
    b->memory = bench_numbers(ALL * n);
    if (b->memory == NULL)
        return -1;
    double *const m = b->memory;
    fill(m, 3 * 2 * n, 0.0, 1.0, &seed);
    fill(m + FORCE * n, 3 * n, 0.0, 1e-6, &seed); /* however long it runs, h|Omega| stays small */
    fill(m + SPIN * n, 3 * n, 0.0, 1.0, &seed);
    fill(m + MOMENT * n, 3 * n, 0.0, 1e-6, &seed);
    fill(m + ALPHA * n, 3 * n, 0.0, 0.5, &seed);
    fill(m + MOMENTS * n, 3 * n, 1.25, 0.25, &seed);
    fill(m + MASS * n, n, 1.5, 0.5, &seed);
    for (int64_t k = 0; k < 3 * n; ++k) /* the first half are spheres */
        m[MIXED * n + k] = k < 3 * (n / 2) ? 1.25 : m[MOMENTS * n + k];
    set_squish(b);
    set_views(b);
    vti_bodies *const all[] = {&b->spheres, &b->tops, &b->mixed, &b->whole};
    int status = VTI_OK;
    for (int k = 0; k < 4 && status == VTI_OK; ++k)
        status = vti_bodies_seal(all[k]);
    return status == VTI_OK ? 0 : -1;
}

void bench_tops_free(struct bench_tops *b)
{
    free(b->memory);
}

/* ---- drifts ------------------------------------------------------------------------------------------------------ */

/** The exact law's drift, and no kicks. */
static void drift(int rotor, const vti_bodies *bodies)
{
    static const double none[] = {0.0, 0.0}, whole[] = {1.0, 0.0};
    const vti_stepper alone = {.name = "drift",
                               .law = VTI_LAW_EXACT,
                               .frame = VTI_FRAME_SPACE,
                               .stages = 1,
                               .evals = 1,
                               .kick = none,
                               .drift = whole,
                               .rotor = rotor};
    vti_step_begin(&alone, h, bodies, NULL);
}

static void drift_sphere(void *self)
{
    drift(2, &((struct bench_tops *)self)->spheres);
}

static void drift_strang(void *self)
{
    drift(2, &((struct bench_tops *)self)->tops);
}

static void drift_m4(void *self)
{
    drift(4, &((struct bench_tops *)self)->tops);
}

static void drift_s10(void *self)
{
    drift(6, &((struct bench_tops *)self)->tops);
}

static void drift_mixed(void *self)
{
    drift(2, &((struct bench_tops *)self)->mixed);
}

/** P_k q: q turned by a right angle about the body's axis k, of quaternions (w, x, y, z). */
static void turned(int k, const double q[4], double r[4])
{
    static const int from[3][4] = {{1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    static const double sign[3][4] = {{-1, 1, 1, -1}, {-1, -1, 1, 1}, {-1, 1, -1, 1}};
    for (int n = 0; n < 4; ++n)
        r[n] = sign[k][n] * q[from[k][n]];
}

/** The free turn by t about axis k: q <- cos(z t) q + sin(z t) P_k q, and p likewise, z = p.P_k q/(4 I_k). */
static void squish_turn(int k, double t, double moment, double q[4], double p[4])
{
    double qk[4], pk[4], z = 0.0;
    turned(k, q, qk);
    turned(k, p, pk);
    for (int n = 0; n < 4; ++n)
        z += p[n] * qk[n];
    z *= t / (4.0 * moment);
    const double c = cos(z), s = sin(z);
    for (int n = 0; n < 4; ++n) {
        q[n] = c * q[n] + s * qk[n];
        p[n] = c * p[n] + s * pk[n];
    }
}

/** NO_SQUISH (Miller et al., J. Chem. Phys. 116 (2002) 8649): turns about the body's axes 3, 2, 1, 2, 3 by sine and
 *  cosine. */
static void drift_squish(void *self)
{
    const struct bench_tops *const b = self;
    for (int64_t i = 0; i < b->n; ++i) {
        const double *const moments = b->memory + MOMENTS * b->n + 3 * i;
        double *const q = b->memory + QUAT * b->n + 4 * i, *const p = b->memory + MOMENTUM * b->n + 4 * i;
        squish_turn(2, 0.5 * h, moments[2], q, p);
        squish_turn(1, 0.5 * h, moments[1], q, p);
        squish_turn(0, h, moments[0], q, p);
        squish_turn(1, 0.5 * h, moments[1], q, p);
        squish_turn(2, 0.5 * h, moments[2], q, p);
    }
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static void step_vti2(void *self)
{
    struct bench_tops *const b = self;
    const vti_stepper *const method = vti_stepper_find("vti2");
    vti_step_begin(method, h, &b->whole, NULL);
    vti_step_finish(method, h, &b->whole);
}

static void next_vti2(void *self)
{
    struct bench_tops *const b = self;
    vti_step_next(vti_stepper_find("vti2"), h, &b->whole, NULL);
}

int bench_tops_cases(struct bench_tops *b, struct bench_case *cases, int count)
{
    static const struct {
        const char *what;
        void (*call)(void *self);
    } all[] = {
        {"drift: sphere", drift_sphere},    {"drift: Strang", drift_strang},        {"drift: M4", drift_m4},
        {"drift: S10", drift_s10},          {"drift: mixed", drift_mixed},          {"drift: NO_SQUISH", drift_squish},
        {"three moments: vti2", step_vti2}, {"three moments: vti2 next", next_vti2}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        const struct bench_case one = {
            .what = all[k].what, .layout = "packed", .items = b->n, .call = all[k].call, .self = b};
        cases[count++] = one;
    }
    return count;
}
