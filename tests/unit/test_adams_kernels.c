/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The two halves of a step of a multistep method by the kernels of every vector width, in every layout, against
 * the equations (EQUATIONS 8.1) written out here number by number, to the bit; and that nothing beside a slice is
 * touched. */
#include <float.h>

#include "../../src/lanes/vti_lanes.h"
#include "../../src/multistep/vti_adams.h"
#include "../../src/vti_move.h"
#include "units.h"

enum { N = 11, FIRST = 2, END = 9, DEPTH = 10, ROOM = 21 * N };
enum { PACKED, SEPARATE, STRUCTS, LAYOUTS };
enum { X, V, F, W, M, VIEWS };

struct system {
    double of[VIEWS][ROOM], mass[N], inertia[N], past[N][DEPTH][6];
};

static vti_view view_in(int layout, double *p)
{
    const vti_view in_struct = {{p + 5, p + 8, p + 7}, 21, 0};
    return layout == STRUCTS  ? in_struct
           : layout == PACKED ? vti_view_packed(p)
                              : vti_view_separate(p, p + N, p + 2 * N);
}

static vti_bodies bodies_in(int layout, struct system *s)
{
    vti_bodies b = vti_bodies_none(N);
    vti_view *const views[VIEWS] = {&b.x, &b.v, &b.force, &b.omega, &b.moment};
    for (int k = 0; k < VIEWS; ++k)
        *views[k] = view_in(layout, s->of[k]);
    b.mass = layout == PACKED ? vti_scalars_one(s->mass) : vti_scalars_array(s->mass);
    b.inertia = vti_scalars_array(s->inertia);
    return b;
}

static void fill(rng *g, struct system *s)
{
    double *const all = (double *)s;
    for (size_t k = 0; k < sizeof *s / sizeof *all; ++k)
        all[k] = uniform(g, -1.0, 1.0);
    for (int i = 0; i < N; ++i) {
        s->mass[i] = uniform(g, 0.5, 2.0);
        s->inertia[i] = uniform(g, 0.5, 2.0);
    }
}

static double *at(const vti_view *view, int i, int c)
{
    return view->c[c] + i * view->stride;
}

/** sum of coefficient[j] N^j, of component c of 6. */
static double sum(int64_t depth, const double *coefficient, double past[DEPTH][6], int c)
{
    double s = 0.0;
    for (int64_t j = 0; j < depth; ++j)
        s += coefficient[j] * past[j][c];
    return s;
}

/** Numbers that are left of a body that is corrected, and of one that is predicted (vti_adams_magnus.h). */
enum { CORRECTED = 4, PREDICTED = 16 };

/** r = sum of t_k a_k, which is nothing where a_k is NULL. */
static void mix(double r[3], double t0, const double *a0, double t1, const double *a1, double t2, const double *a2)
{
    for (int c = 0; c < 3; ++c)
        r[c] = t0 * a0[c] + t1 * a1[c] + (a2 != NULL ? t2 * a2[c] : 0.0);
}

static void magnus(double a[4][3], double theta[3])
{
    double early[3], late[3], s1[3], r1[3], s2[3], r2[3], s3[3], p[3], q[3];
    mix(early, 1.0, a[0], 1.0 / 28.0, a[2], 0.0, NULL);
    mix(late, 1.0, a[1], 3.0 / 28.0, a[3], 0.0, NULL);
    vti_cross(early, late, s1);
    for (int c = 0; c < 3; ++c)
        s1[c] *= -1.0 / 28.0;
    mix(p, 1.0, s1, -1.0 / 14.0, a[2], 0.0, NULL);
    vti_cross(a[0], p, r1);
    for (int c = 0; c < 3; ++c) {
        r1[c] *= 1.0 / 3.0;
        early[c] += s1[c];
        late[c] += r1[c];
    }
    vti_cross(early, late, s2);
    vti_cross(a[1], s1, p);
    mix(q, 2.0, a[2], 1.0, s2, 0.5, p);
    mix(p, 1.0, a[0], 1.25, s1, 0.0, NULL);
    vti_cross(p, q, r2);
    for (int c = 0; c < 3; ++c) {
        theta[c] = a[0][c] + 1.0 / 12.0 * a[2][c];
        p[c] = theta[c] - 7.0 / 3.0 * s1[c] - 1.0 / 6.0 * s2[c];
        q[c] = 63.0 * r1[c] + r2[c] - 9.0 * a[1][c] - 2.25 * a[3][c];
    }
    vti_cross(p, q, s3);
    for (int c = 0; c < 3; ++c)
        theta[c] += 1.0 / 360.0 * s3[c] - 7.0 / 120.0 * s2[c];
}

static void predict(const vti_multistep *m, double h, struct system *s, const vti_bodies *b, int i, double *turn)
{
    for (int c = 0; c < 3; ++c) {
        const double v = *at(&b->v, i, c), w = *at(&b->omega, i, c);
        *at(&b->x, i, c) += h * (v + h * sum(m->depth, adams_d, s->past[i], c));
        *at(&b->v, i, c) = v + h * sum(m->depth, adams_g, s->past[i], c);
        turn[1 + c] = h * (w + h * sum(m->depth, adams_middle[0], s->past[i], 3 + c));
        for (int k = 1; k < 4; ++k)
            turn[4 * k + 1 + c] = h * h * sum(m->depth, adams_middle[k], s->past[i], 3 + c);
        *at(&b->omega, i, c) = w + h * sum(m->depth, adams_g, s->past[i], 3 + c);
    }
}

static void correct(const vti_multistep *m, double h, struct system *s, const vti_bodies *b, int i, double *turn)
{
    static const double ones[DEPTH] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    const double g = h * (adams_g[m->depth] + m->u), d = m->c * h * h * adams_d[m->depth];
    for (int c = 0; c < 6; ++c) {
        double f =
            c < 3 ? *at(&b->force, i, c) / b->mass.p[i * b->mass.stride] : *at(&b->moment, i, c - 3) / s->inertia[i];
        const double off = f - sum(m->depth, ones, s->past[i], c);
        *at(c < 3 ? &b->v : &b->omega, i, c % 3) += g * off;
        if (c < 3)
            *at(&b->x, i, c) += d * off;
        else
            turn[1 + c - 3] = d * off;
        for (int j = 0; j < DEPTH; ++j) { /* the new value of each difference, and the next difference */
            const double was = s->past[i][j][c];
            s->past[i][j][c] = f;
            f -= was;
        }
    }
}

/** Bodies that one of them leaves over are for the next; the last one, where all of them take two at once as this
 *  build's -march lets them, is for nobody. */
static void do_all(const struct vti_move_kernels *kernels, int corrects, const vti_multistep *m, struct system *s,
                   const vti_bodies *b, double *turn)
{
    const vti_past past = {s->past[0][0], DEPTH, DEPTH};
    vti_half_step *const half[2] = {kernels->predict, kernels->correct}, *const rest[2] = {vti_move_baseline.predict,
                                                                                           vti_move_baseline.correct};
    const int64_t each = corrects ? CORRECTED : PREDICTED, stop = half[corrects](m, 0.3, &past, b, FIRST, END, turn);
    assert_in_range(END - stop, 0, 1);
    const int64_t last = rest[corrects](m, 0.3, &past, b, stop, END, turn + each * (stop - FIRST));
    assert_in_range(END - last, 0, WIDTH == 8);
    for (int64_t i = last; i < END; ++i)
        (corrects ? correct : predict)(m, 0.3, s, b, (int)i, turn + each * (i - FIRST));
    for (int64_t k = 0; k < each * (END - FIRST); k += 4)
        turn[k] = 0.0; /* says nothing */
}

static void agree(const struct vti_move_kernels *kernels)
{
    static struct system one, many;
    rng g = rng_seed(11);
    for (int trial = 0; trial < LAYOUTS * 2 * (int)vti_multistep_count(); ++trial) {
        double expected[PREDICTED * (END - FIRST)] = {0.0}, turn[PREDICTED * (END - FIRST)] = {0.0};
        const vti_multistep *m = vti_multistep_at(trial / (LAYOUTS * 2));
        const int corrects = trial / LAYOUTS % 2;
        fill(&g, &one);
        many = one;
        const vti_bodies by_one = bodies_in(trial % LAYOUTS, &one), b = bodies_in(trial % LAYOUTS, &many);
        for (int i = FIRST; i < END; ++i)
            (corrects ? correct : predict)(m, 0.3, &one, &by_one, i,
                                           expected + (corrects ? CORRECTED : PREDICTED) * (i - FIRST));
        do_all(kernels, corrects, m, &many, &b, turn);
        if (!corrects || m->c != 0.0) /* else no body turns, and none is told to */
            assert_same_bits(turn, expected, sizeof expected / sizeof(double));
        assert_same_bits(&many, &one, sizeof one / sizeof(double));
    }
}

/* ---- turns ------------------------------------------------------------------------------------------------------- */

enum { TURNED = 19, QUAT_ROOM = 5 * TURNED };
enum { ALPHA_PACKED, ALPHA_SEPARATE, ALPHA_APART, QUAT_PACKED, QUAT_SEPARATE, QUAT_APART, KEPT };

static vti_bodies attitudes_in(int kept, double *p)
{
    vti_bodies b = vti_bodies_none(TURNED);
    const vti_view apart = {{p + 2, p, p + 4}, 5, 0};
    if (kept == ALPHA_PACKED)
        b.alpha = vti_view_packed(p);
    else if (kept == ALPHA_SEPARATE)
        b.alpha = vti_view_separate(p, p + TURNED, p + 2 * TURNED);
    else if (kept == ALPHA_APART)
        b.alpha = apart;
    for (int k = 0; kept >= QUAT_PACKED && k < 4; ++k) {
        b.quat.xyzw[k] = p + k * (kept == QUAT_SEPARATE ? TURNED : 1);
        b.quat.stride = kept == QUAT_PACKED ? 4 : kept == QUAT_SEPARATE ? 1 : 5;
    }
    return b;
}

/** Turns body i by what is left of it: of a prediction to order 9, of a correction by Cayley's law. */
static void turn_one(const double *by, int64_t each, const vti_bodies *b, int64_t i)
{
    double a[4][3], theta[3];
    for (int k = 0; k < each / 4; ++k)
        memcpy(a[k], by + 4 * k + 1, sizeof a[k]);
    if (each == PREDICTED)
        magnus(a, theta);
    vti_move_turn_by(each == PREDICTED ? VTI_LAW_EXACT9 : VTI_LAW_CAYLEY, each == PREDICTED ? theta : a[0], b, i);
}

/** Turns of any size, of all numbers of bodies, among them such that only single bodies can make. */
static void turn_alike(const struct vti_move_kernels *kernels, int64_t each)
{
    double one[QUAT_ROOM], many[QUAT_ROOM], by[PREDICTED * TURNED];
    static const double large[3] = {4.0, 1e12, 1e200}; /* the square of the last is infinite */
    const int sizes = each == PREDICTED ? 2 : 3;       /* Magnus' vector of the last is NaN */
    rng g = rng_seed(12);
    for (int trial = 0; trial < 40 * KEPT; ++trial) {
        const int64_t first = trial % 3, end = first + trial % (TURNED - 2);
        const double most = trial % 5 == 0 ? large[trial / 30 % sizes] : 0.3;
        for (int k = 0; k < QUAT_ROOM; ++k)
            one[k] = many[k] = uniform(&g, -1.0, 1.0);
        for (int k = 0; k < PREDICTED * TURNED; ++k)
            by[k] = uniform(&g, -most, most);
        const vti_bodies by_one = attitudes_in(trial % KEPT, one), b = attitudes_in(trial % KEPT, many);
        const int64_t stop = kernels->turn(by, each, &b, first, end);
        assert_in_range(end - stop, 0, 4);
        for (int64_t i = first; i < stop; ++i)
            turn_one(by + each * (i - first), each, &by_one, i);
        assert_same_bits(many, one, QUAT_ROOM);
    }
}

/** A turn about z by s = 0.2, x = s/2: the fraction for tan(x) errs by x^9/(3^2 5^2 7^2 9), 1e-14; by Cayley's law it
 *  is one by 2 atan(0.1). */
TEST(one_turn)
{
    const double u[3] = {0.0, 0.0, 0.2}, tolerance = 1e-14 + 8.0 * DBL_EPSILON;
    for (int cayley = 0; cayley < 2; ++cayley) {
        const int law = cayley ? VTI_LAW_CAYLEY : VTI_LAW_EXACT9;
        const double half = cayley ? atan(0.1) : 0.1;
        double alpha[3] = {0.0, 0.0, 0.0}, quat[4] = {0.0, 0.0, 0.0, 1.0};
        vti_bodies b = vti_bodies_none(1), q = vti_bodies_none(1);
        b.alpha = vti_view_packed(alpha);
        for (int k = 0; k < 4; ++k)
            q.quat.xyzw[k] = quat + k;
        vti_move_turn_by(law, u, &b, 0);
        vti_move_turn_by(law, u, &q, 0);
        assert_close(0.5 * alpha[2], tan(half), tolerance);
        assert_close(quat[2], sin(half), tolerance);
        assert_close(quat[3], cos(half), tolerance);
    }
}

/* ---- whole steps ------------------------------------------------------------------------------------------------- */

enum { MOST = 77 };

struct many {
    double x[3 * MOST], v[3 * MOST], force[3 * MOST], alpha[3 * MOST], omega[3 * MOST], moment[3 * MOST],
        past[MOST][DEPTH][6];
};

/** A step of the bodies from first on, so many. */
static void step(struct many *s, int64_t first, int64_t count)
{
    static const double one = 1.5;
    const vti_multistep *const m = vti_multistep_find("an9");
    vti_bodies b = vti_bodies_none(count);
    vti_past past = {s->past[0][0], DEPTH, DEPTH};
    b.first = first;
    b.x = vti_view_packed(s->x);
    b.v = vti_view_packed(s->v);
    b.force = vti_view_packed(s->force);
    b.alpha = vti_view_packed(s->alpha);
    b.omega = vti_view_packed(s->omega);
    b.moment = vti_view_packed(s->moment);
    b.mass = b.inertia = vti_scalars_one(&one);
    assert_int_equal(vti_multistep_predict(m, 0.1, &past, &b, NULL), VTI_OK);
    assert_int_equal(vti_multistep_correct(m, 0.1, &past, &b), VTI_OK);
}

/** All bodies as one alone, by whatever kernels there are, and of any number. */
TEST(numbers_of_bodies)
{
    static struct many all, each;
    rng g = rng_seed(13);
    for (int64_t n = 1; n <= MOST; ++n) {
        double *const numbers = (double *)&all;
        for (size_t k = 0; k < sizeof all / sizeof *numbers; ++k)
            numbers[k] = uniform(&g, -1.0, 1.0);
        each = all;
        step(&all, 0, n);
        for (int64_t i = 0; i < n; ++i)
            step(&each, i, 1);
        assert_same_bits(&all, &each, sizeof all / sizeof *numbers);
    }
}

static void all_kernels(const struct vti_move_kernels *kernels)
{
    agree(kernels);
    turn_alike(kernels, CORRECTED);
    turn_alike(kernels, PREDICTED);
}

TEST(baseline)
{
    all_kernels(&vti_move_baseline);
}

ON_AVX2(all_kernels(&vti_move_avx2))
ON_AVX512(all_kernels(&vti_move_avx512))

RUN_TESTS(cmocka_unit_test(one_turn), cmocka_unit_test(numbers_of_bodies), cmocka_unit_test(baseline),
          cmocka_unit_test(avx2), cmocka_unit_test(avx512))
