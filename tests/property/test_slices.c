/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Slices and layouts do not change a bit: a block of bonded spheres, 100 steps by every stepper of one stage, whole,
 * in slices of all sizes, which threads (OpenMP) step and load where there are any, and in every layout. The chain of
 * the same kind is in test_hosts.py. */
#include "support.h"

enum { NX = 7, NY = 6, NZ = 5, N = NX * NY * NZ, MOST = 3 * N, STEPS = 100, MOVING = 12 };

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

enum half { BEGIN, FORCES, FINISH };

/** Half a step of each slice of so many bodies, or the forces between; the last may be shorter. */
static int each_slice(const vti_stepper *method, double h, const vti_effect *binder, const vti_bodies *b, int64_t size,
                      enum half half)
{
    int failed = 0;
#ifdef _OPENMP
#pragma omp parallel for reduction(| : failed)
#endif
    for (int64_t first = 0; first < N; first += size) {
        const vti_bodies part = vti_bodies_slice(*b, first, N - first < size ? N - first : size);
        failed |= half == BEGIN    ? vti_step_begin(method, h, &part, NULL)
                  : half == FORCES ? vti_apply(binder, 1, &part)
                                   : vti_step_finish(method, h, &part);
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
                       VTI_SHEAR_OBJECTIVE,
                       NULL};
    const vti_bodies b = start(s, layout);
    assert_int_equal(vti_bonds_rest(bonded, pair[0], 0, &b.x, rest[0], NULL), VTI_OK);
    const vti_effect binder = vti_bonds_effect(&bonds);
    assert_int_equal(vti_apply(&binder, 1, &b), VTI_OK);
    for (int k = 0; k < STEPS; ++k)
        for (int half = BEGIN; half <= FINISH; ++half) {
            /* of many slices each would look at all bonds */
            const int64_t now = half == FORCES && size < 64 ? N : size;
            assert_int_equal(each_slice(method, h, &binder, &b, now, (enum half)half), VTI_OK);
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

/** The loads of a list of what acts on a slice, of bonds and contacts, counted from 1: bits of the whole list, and
 *  nothing outside the slice. */
TEST(a_slice_needs_the_pairs_that_name_it)
{
    static struct block whole, part;
    static int64_t named[2 * MOST], which[MOST];
    static double picked[4 * MOST];
    static const double none[N][3];
    const double stiffness = 20.0, diameter = 1.3;
    connect();
    const vti_bodies b = start(&whole, PACKED), c = start(&part, PACKED);
    assert_int_equal(vti_bonds_rest(bonded, pair[0], 0, &b.x, rest[0], NULL), VTI_OK);
    for (int64_t i = 0; i < N; ++i)
        for (int k = 0; k < 3; ++k)
            b.alpha.c[k][i * b.alpha.stride] = c.alpha.c[k][i * c.alpha.stride] = 0.1 * sin((double)(7 * i + k));
    vti_bonds bonds = {.count = bonded,
                       .pair = pair[0],
                       .rest = rest[0],
                       .moment = vti_scalars_one(&stiffness),
                       .shear = vti_scalars_one(&stiffness),
                       .shear_form = VTI_SHEAR_OBJECTIVE};
    vti_contacts contacts = {
        .count = bonded, .pair = pair[0], .diameter = vti_scalars_one(&diameter), .stiffness = stiffness};
    const vti_effect all[] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts)};
    assert_int_equal(vti_apply(all, 2, &b), VTI_OK);
    for (int64_t first = 0; first < N; first += 37) {
        const int64_t count = N - first < 37 ? N - first : 37;
        const int64_t n = vti_pairs_of_slice(bonded, pair[0], 0, first, count, which);
        assert_int_equal(vti_pairs_of_slice(bonded, pair[0], 0, first, count, NULL), n);
        assert_true(n > 0 && n < bonded);
        for (int64_t k = 0; k < n; ++k) {
            named[2 * k] = pair[which[k]][0] + 1;
            named[2 * k + 1] = pair[which[k]][1] + 1;
            memcpy(picked + 4 * k, rest[which[k]], 4 * sizeof *picked);
        }
        assert_int_equal(vti_pairs_of_slice(n, named, 1, first, count, NULL), n);
        vti_bonds own = bonds;
        vti_contacts near = contacts;
        own.count = near.count = n;
        own.pair = near.pair = named;
        own.base = near.base = 1;
        own.rest = picked;
        const vti_effect some[] = {vti_bonds_effect(&own), vti_contacts_effect(&near)};
        const vti_bodies slice = vti_bodies_slice(c, first, count);
        memset(part.f, 0, sizeof part.f);
        memset(part.m, 0, sizeof part.m);
        assert_int_equal(vti_apply(some, 2, &slice), VTI_OK);
        assert_same_bits(part.f[first], whole.f[first], 3 * count);
        assert_same_bits(part.m[first], whole.m[first], 3 * count);
        assert_same_bits(part.f[0], none[0], 3 * first);
        assert_same_bits(part.m[0], none[0], 3 * first);
        assert_same_bits(part.f[first + count - 1] + 3, none[0], 3 * (N - first - count));
    }
    assert_int_equal(vti_pairs_of_slice(5, NULL, 0, 0, N, NULL), 0);
}

RUN_TESTS(cmocka_unit_test(slices_and_layouts_do_not_change_a_bit),
          cmocka_unit_test(a_slice_needs_the_pairs_that_name_it))
