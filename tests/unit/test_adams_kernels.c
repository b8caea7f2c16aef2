/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The two halves of a step of a multistep method by the kernels of every vector width, in every layout, against
 * the equations (EQUATIONS 8.1) written out here number by number, to the bit; and that nothing beside a slice is
 * touched. */
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

static void predict(const vti_multistep *m, double h, struct system *s, const vti_bodies *b, int i, double theta[3])
{
    double o[3][3], a1[3], a2[3], a3[3], c1[3], c2[3], p[3], q[3], w[3];
    for (int c = 0; c < 3; ++c) {
        const double v = *at(&b->v, i, c);
        *at(&b->x, i, c) += h * (v + h * sum(m->depth, adams_d, s->past[i], c));
        *at(&b->v, i, c) = v + h * sum(m->depth, adams_g, s->past[i], c);
        w[c] = *at(&b->omega, i, c);
        for (int k = 0; k < 3; ++k)
            o[k][c] = w[c] + h * sum(m->depth, adams_node[k], s->past[i], 3 + c);
        *at(&b->omega, i, c) = w[c] + h * sum(m->depth, adams_g, s->past[i], 3 + c);
        a1[c] = h * o[1][c];
        a2[c] = 1.2909944487358056 * h * (o[2][c] - o[0][c]);
        a3[c] = 10.0 / 3.0 * h * (o[2][c] - 2.0 * o[1][c] + o[0][c]);
    }
    vti_cross(a1, a2, c1);
    for (int c = 0; c < 3; ++c)
        p[c] = 2.0 * a3[c] + c1[c];
    vti_cross(a1, p, c2);
    for (int c = 0; c < 3; ++c) {
        p[c] = c1[c] - 20.0 * a1[c] - a3[c];
        q[c] = a2[c] - c2[c] / 60.0;
    }
    vti_cross(p, q, theta);
    for (int c = 0; c < 3; ++c)
        theta[c] = a1[c] + a3[c] / 12.0 + theta[c] / 240.0;
}

static void correct(const vti_multistep *m, double h, struct system *s, const vti_bodies *b, int i, double turn[3])
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
            turn[c - 3] = d * off;
        for (int j = 0; j < DEPTH; ++j) { /* the new value of each difference, and the next difference */
            const double was = s->past[i][j][c];
            s->past[i][j][c] = f;
            f -= was;
        }
    }
}

static void agree(const struct vti_move_kernels *kernels)
{
    static struct system one, many;
    double expected[END - FIRST][3], turn[END - FIRST][3];
    rng g = rng_seed(11);
    for (int trial = 0; trial < LAYOUTS * 2 * (int)vti_multistep_count(); ++trial) {
        const vti_multistep *m = vti_multistep_at(trial / (LAYOUTS * 2));
        const int corrects = trial / LAYOUTS % 2;
        fill(&g, &one);
        many = one;
        const vti_bodies by_one = bodies_in(trial % LAYOUTS, &one), b = bodies_in(trial % LAYOUTS, &many);
        const vti_past past = {many.past[0][0], DEPTH, DEPTH};
        for (int i = FIRST; i < END; ++i)
            (corrects ? correct : predict)(m, 0.3, &one, &by_one, i, expected[i - FIRST]);
        (corrects ? kernels->correct : kernels->predict)(m, 0.3, &past, &b, FIRST, END, turn[0]);
        assert_same_bits(turn, expected, sizeof turn / sizeof(double));
        assert_same_bits(&many, &one, sizeof one / sizeof(double));
    }
}

TEST(baseline)
{
    agree(&vti_move_baseline);
}

ON_AVX2(agree(&vti_move_avx2))
ON_AVX512(agree(&vti_move_avx512))

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
