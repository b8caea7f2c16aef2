/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Slices and layouts do not change a bit: a block of bonded spheres, 1000 steps by every stepper of one stage, whole,
 * in slices of all sizes, which threads (OpenMP) step where there are any, and in every layout. The chain of the same
 * kind is in test_hosts.py. */
#include "support.h"

enum { NX = 7, NY = 6, NZ = 5, N = NX * NY * NZ, MOST = 3 * N, STEPS = 1000, MOVING = 12 };

enum layout { SEPARATE, PACKED, STRUCTS, BACKWARDS, LAYOUTS };

struct block {
    double q[MOVING * N];    /* x, v, alpha, omega */
    double f[N][3], m[N][3]; /* another layout */
    double mass[N], inertia[N];
};

static int64_t pair[MOST][2], bonded;
static double rest[MOST][4];

static int64_t number(int i, int j, int k)
{
    return ((int64_t)k * NY + j) * NX + i;
}

static void bond(int64_t i, int64_t j, int exists)
{
    if (exists) {
        pair[bonded][0] = i;
        pair[bonded++][1] = j;
    }
}

static void connect(void)
{
    bonded = 0;
    for (int k = 0; k < NZ; ++k)
        for (int j = 0; j < NY; ++j)
            for (int i = 0; i < NX; ++i) {
                bond(number(i, j, k), number(i + 1, j, k), i + 1 < NX);
                bond(number(i, j, k), number(i, j + 1, k), j + 1 < NY);
                bond(number(i, j, k), number(i, j, k + 1), k + 1 < NZ);
            }
}

/** Quantity k of x, v, alpha, omega. */
static vti_view view(struct block *s, enum layout layout, int k)
{
    double *const p = s->q + 3 * N * k, *const first = s->q + 3 * k, *const last = first + (N - 1) * MOVING;
    const vti_view backwards = {{last, last + 1, last + 2}, -MOVING, 0};
    return layout == SEPARATE  ? vti_view_separate(p, p + N, p + 2 * N)
           : layout == PACKED  ? vti_view_packed(p)
           : layout == STRUCTS ? vti_view_member(first, MOVING * (int64_t)sizeof *first)
                               : backwards;
}

static vti_bodies start(struct block *s, enum layout layout)
{
    vti_bodies b = vti_bodies_none(N);
    memset(s, 0, sizeof *s);
    b.x = view(s, layout, 0);
    b.v = view(s, layout, 1);
    b.alpha = view(s, layout, 2);
    b.omega = view(s, layout, 3);
    for (int64_t i = 0; i < N; ++i) {
        b.x.c[0][i * b.x.stride] = (double)(i % NX);
        b.x.c[1][i * b.x.stride] = (double)(i / NX % NY);
        b.x.c[2][i * b.x.stride] = (double)(i / (NX * NY));
        s->mass[i] = 1.0 + 0.01 * (double)(i % 11);
        s->inertia[i] = 0.1 + 0.002 * (double)(i % 7);
        for (int c = 0; c < 3; ++c) {
            b.v.c[c][i * b.v.stride] = 0.03 * sin((double)(3 * i + c));
            b.omega.c[c][i * b.omega.stride] = 0.2 * cos((double)(5 * i + c));
        }
    }
    b.force = vti_view_packed(s->f[0]);
    b.moment = vti_view_packed(s->m[0]);
    b.mass = vti_scalars_array(s->mass);
    b.inertia = vti_scalars_array(s->inertia);
    return b;
}

/** Half a step of each slice of so many bodies; the last may be shorter. */
static int each_slice(const vti_stepper *method, double h, const vti_bodies *b, int64_t size, int begins)
{
    int failed = 0;
#ifdef _OPENMP
#pragma omp parallel for reduction(| : failed)
#endif
    for (int64_t first = 0; first < N; first += size) {
        const vti_bodies part = vti_bodies_slice(*b, first, N - first < size ? N - first : size);
        failed |= begins ? vti_step_begin(method, h, &part, NULL) : vti_step_finish(method, h, &part);
    }
    return failed;
}

static void run(const char *name, int64_t size, enum layout layout, struct block *s)
{
    const vti_stepper *method = vti_stepper_find(name);
    const double moment = 2.0, axial = 20.0, shear = 20.0, h = 1.0 / 256.0;
    vti_bonds bonds = {bonded,
                       pair[0],
                       0,
                       rest[0],
                       vti_scalars_one(&moment),
                       vti_scalars_one(&axial),
                       vti_scalars_one(&shear),
                       VTI_SHEAR_OBJECTIVE};
    const vti_bodies b = start(s, layout);
    assert_int_equal(vti_bonds_rest(bonded, pair[0], 0, &b.x, rest[0], NULL), VTI_OK);
    const vti_effect binder = vti_bonds_effect(&bonds);
    assert_int_equal(vti_apply(&binder, 1, &b), VTI_OK);
    for (int k = 0; k < STEPS; ++k) {
        assert_int_equal(each_slice(method, h, &b, size, 1), VTI_OK);
        assert_int_equal(vti_apply(&binder, 1, &b), VTI_OK);
        assert_int_equal(each_slice(method, h, &b, size, 0), VTI_OK);
    }
}

static void same_motion(struct block *s, struct block *t, enum layout layout)
{
    for (int k = 0; k < 4; ++k) {
        const vti_view a = view(s, SEPARATE, k), b = view(t, layout, k);
        for (int64_t i = 0; i < N; ++i)
            for (int c = 0; c < 3; ++c)
                assert_same_bits(&a.c[c][i * a.stride], &b.c[c][i * b.stride], 1);
    }
}

TEST(slices_and_layouts_do_not_change_a_bit)
{
    static struct block whole, other, untouched;
    static const char *const names[] = {"vti1", "vti2", "vti3", "exact"};
    static const int64_t sizes[] = {1, 3, 4, 5, 64, 100, N - 1};
    connect();
    start(&untouched, SEPARATE);
    for (size_t s = 0; s < sizeof names / sizeof names[0]; ++s) {
        run(names[s], N, SEPARATE, &whole);
        assert_true(isfinite(whole.q[0]));
        assert_memory_not_equal(whole.q, untouched.q, sizeof whole.q);
        for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
            run(names[s], sizes[k], SEPARATE, &other);
            same_motion(&whole, &other, SEPARATE);
        }
        for (int layout = PACKED; layout < LAYOUTS; ++layout) {
            run(names[s], 64, (enum layout)layout, &other);
            same_motion(&whole, &other, (enum layout)layout);
        }
    }
}

RUN_TESTS(cmocka_unit_test(slices_and_layouts_do_not_change_a_bit))
