/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The kernels of bonds for wide units give the bits of those for any processor, and strided bodies those of packed
 * ones: every combination of terms and forms, few bonds and many, alpha and quaternions, at half a turn among them. So
 * do those of bonds that join bodies in a row, which do without rows of loads. Their tables are private to the
 * library. */
#include "crowd.h"
#include "units.h"

#include "../../src/bonds/vti_binder_table.h"

static crowd c, wide;
static web w;
static double held[WEB_MAX][VTI_BOND_MEASURES], held_too[WEB_MAX][VTI_BOND_MEASURES];

/** The quantities of a crowd one body further apart. */
struct sparse {
    double x[CROWD_MAX][5], attitude[CROWD_MAX][7], force[CROWD_MAX][4], moment[CROWD_MAX][9];
};
static struct sparse sparse;

static vti_view sparse_view(double *p, int64_t stride)
{
    const vti_view view = {{p, p + 2, p + 1}, stride, 0};
    return view;
}

/** The bodies of a crowd in other memory, with y and z exchanged there. */
static vti_bodies sparse_bodies(crowd *from)
{
    vti_bodies b = crowd_bodies(from);
    memset(&sparse, 0, sizeof sparse);
    const double *q = from->storage == CROWD_QUAT ? from->quat[0] : from->alpha[0];
    const int numbers = from->storage == CROWD_QUAT ? 4 : 3;
    for (int i = 0; i < from->n; ++i)
        for (int k = 0; k < 4; ++k) {
            const int other = k == 1 ? 2 : k == 2 ? 1 : k;
            if (k < 3)
                sparse.x[i][other] = from->x[i][k];
            if (k < numbers)
                sparse.attitude[i][other] = q[numbers * i + k];
        }
    b.x = sparse_view(sparse.x[0], 5);
    b.force = sparse_view(sparse.force[0], 4);
    b.moment = sparse_view(sparse.moment[0], 9);
    if (numbers == 3)
        b.alpha = sparse_view(sparse.attitude[0], 7);
    else
        for (int k = 0; k < 4; ++k) {
            b.quat.xyzw[k] = sparse.attitude[0] + (k == 1 ? 2 : k == 2 ? 1 : k);
            b.quat.stride = 7;
        }
    return b;
}

/** Bodies and bonds of a trial; some attitudes are where alpha is cut off, and beyond. */
static void draw(rng *g, int trial, int *terms, int *row, int *column)
{
    const int n = 2 + trial % 12 * 7;
    int form;
    crowd_clear(&c, n, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
    crowd_scatter(&c, g, 2, 0.2);
    const int64_t count = web_grow(&w, g, &c, n, 1, 20);
    crowd_scatter(&c, g, 2, 0.2);
    crowd_tumble(&c, g);
    for (int i = 0; i < n; i += 5)
        for (int k = 0; k < 3 && trial % 3 == 0; ++k)
            c.alpha[i][k] *= i % 2 ? 0x1p60 : 0x1p400;
    web_combination(trial % 15, terms, &form);
    web_terms(&w, count, *terms, form);
    memset(c.force, 0, sizeof c.force);
    memset(c.moment, 0, sizeof c.moment);
    wide = c;
    *row = *terms & SHEAR ? form : 0;
    *column = *terms & (MOMENT | AXIAL);
}

/** Loads of all bonds, and their sums. layout: 0 for alpha and 1 for quaternions that lie packed, 2 for any. */
static void apply(const struct bond_kernels *kernels, int terms, const struct bond_kernel *kernel, int layout,
                  const vti_bodies *b)
{
    static double rows[WEB_MAX * VTI_BOND_LOADS];
    kernel->loads[layout](&w.bonds, b, 0, w.bonds.count, rows);
    kernels->sum[layout == 2](terms, &w.bonds, b, 0, w.bonds.count, rows);
}

static void agree(const struct bond_kernels *kernels)
{
    rng g = rng_seed(3071);
    for (int trial = 0; trial < 15 * 12; ++trial) {
        int terms, row, column;
        double energies[3] = {0, 0, 0}, others[3] = {0, 0, 0};
        draw(&g, trial, &terms, &row, &column);
        const vti_bodies b = crowd_bodies(&c), other = crowd_bodies(&wide), apart = sparse_bodies(&c);
        const struct bond_kernel *const kernel = &kernels->of[row][column];
        apply(&vti_binder_baseline, terms, &vti_binder_baseline.of[row][column], trial & 1, &b);
        vti_binder_baseline.of[row][column].energy(&w.bonds, &b, energies);
        apply(kernels, terms, kernel, trial & 1, &other);
        kernel->energy(&w.bonds, &other, others);
        apply(kernels, terms, kernel, 2, &apart);
        assert_same_bits(wide.force[0], c.force[0], 3 * c.n);
        assert_same_bits(wide.moment[0], c.moment[0], 3 * c.n);
        assert_same_bits(others, energies, 3);
        vti_binder_baseline.measure(terms, row, &w.bonds, &b, 0, w.bonds.count, held[0]);
        kernels->measure(terms, row, &w.bonds, &apart, 0, w.bonds.count, held_too[0]);
        assert_same_bits(held_too[0], held[0], (int)w.bonds.count * VTI_BOND_MEASURES);
        for (int i = 0; i < c.n; ++i)
            for (int k = 0; k < 3; ++k) {
                assert_same_bits(&apart.force.c[k][i * apart.force.stride], &c.force[i][k], 1);
                assert_same_bits(&apart.moment.c[k][i * apart.moment.stride], &c.moment[i][k], 1);
            }
    }
}

/* ---- bonds in a row ---------------------------------------------------------------------------------------------- */

/** Bonds of bodies i and i + 1, i + 1 and i + 2, ... in runs of any length, which may wrap around as rings do, and
 *  after some of them a bond of their last body, or of any, and any other. Some are slack, whose loads are 0 or -0. */
static int64_t runs(rng *g, int n)
{
    int64_t count = 0;
    while (count < WEB_MAX - n) {
        const int around = 4 + rng_below(g, n - 3), i = rng_below(g, around);
        const int length = 1 + rng_below(g, 2 * n), other = rng_below(g, n - 1);
        for (int k = i; k < i + length && count < WEB_MAX; ++k, ++count) {
            w.pair[count][0] = k % around;
            w.pair[count][1] = (k + 1) % around;
        }
        if (rng_below(g, 2) && count < WEB_MAX) {
            w.pair[count][0] = rng_below(g, 2) ? i : w.pair[count - 1][1];
            w.pair[count][1] = (w.pair[count][0] + 1 + other) % n;
            ++count;
        }
    }
    for (int64_t k = 0; k < count; ++k)
        w.moment[k] = w.axial[k] = w.shear[k] = rng_below(g, 3) ? uniform(g, 1, 20) : 0.0;
    assert_int_equal(
        vti_bonds_rest(count, w.pair[0], 0, &(vti_view){{c.x[0], c.x[0] + 1, c.x[0] + 2}, 3, 0}, w.rest[0], NULL),
        VTI_OK);
    return count;
}

/** How many bonds from the first on, of bodies of the slice, begin where the one before ends; of those that are in a
 *  row also with the body behind it. */
static int64_t length_of_run(const vti_bodies *b, int64_t first, int in_row)
{
    int64_t k = first;
    for (; k < w.bonds.count; ++k) {
        const int64_t i = w.pair[k][0], j = w.pair[k][1], end = b->first + b->count;
        if ((k > first && i != w.pair[k - 1][1]) || (in_row && j != i + 1))
            break;
        if (i < b->first || i >= end || j < b->first || j >= end)
            break;
    }
    return k - first;
}

static void same_loads(void)
{
    assert_same_bits(wide.force[0], c.force[0], 3 * c.n);
    assert_same_bits(wide.moment[0], c.moment[0], 3 * c.n);
}

/** From every bond on: what the chain takes has the bits of rows, its loads are added to what is there, and less than a
 *  block of the run is left. Where an alpha is too large for its square, more may be left. Then all bonds by the
 *  effect, which changes between both ways. */
static void follow_rows(const struct bond_kernels *kernels)
{
    static double rows[WEB_MAX * VTI_BOND_LOADS];
    rng g = rng_seed(51);
    for (int trial = 0; trial < 15 * 8; ++trial) {
        const int n = 12 + rng_below(&g, CROWD_MAX - 12), large = trial % 4 == 3;
        int terms, form;
        crowd_clear(&c, n, CROWD_ALPHA);
        crowd_scatter(&c, &g, 2, 0.2);
        const int64_t count = runs(&g, n);
        crowd_scatter(&c, &g, 2, 0.2);
        crowd_tumble(&c, &g);
        for (int k = 0; k < 3 && large; ++k)
            c.alpha[n / 2][k] *= 0x1p400;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k) {
                c.force[i][k] = i % 3 ? -0.0 : uniform(&g, -1, 1);
                c.moment[i][k] = i % 5 ? uniform(&g, -1, 1) : -0.0;
            }
        web_combination(trial % 15, &terms, &form);
        web_terms(&w, count, terms, form);
        wide = c;
        const struct bond_kernel *const rowed =
            &vti_binder_baseline.of[terms & SHEAR ? form : 0][terms & (MOMENT | AXIAL)];
        const struct bond_kernel *const kernel = &kernels->of[terms & SHEAR ? form : 0][terms & (MOMENT | AXIAL)];
        const int cut = rng_below(&g, n / 3);
        const vti_bodies b = vti_bodies_slice(crowd_bodies(&c), cut, n - 2 * cut);
        const vti_bodies other = vti_bodies_slice(crowd_bodies(&wide), cut, n - 2 * cut);
        for (int64_t first = 0; first < count; first += 1 + rng_below(&g, 9)) {
            const int64_t last = kernel->chain(&w.bonds, &other, first, count);
            assert_in_range(last - first, 0, length_of_run(&b, first, 0));
            assert_true(large || length_of_run(&b, first, 1) - (last - first) < 8);
            rowed->loads[0](&w.bonds, &b, first, last, rows);
            vti_binder_baseline.sum[0](terms, &w.bonds, &b, first, last, rows);
            same_loads();
        }
        const vti_effect effect = vti_bonds_effect(&w.bonds);
        effect.apply(effect.self, &other);
        rowed->loads[0](&w.bonds, &b, 0, count, rows);
        vti_binder_baseline.sum[0](terms, &w.bonds, &b, 0, count, rows);
        same_loads();
    }
}

/** A ring of whole blocks is taken to its end, where it closes, unless a body is missing in the slice. */
static void close_ring(const struct bond_kernels *kernels)
{
    enum { RING = 8 };
    rng g = rng_seed(52);
    crowd_clear(&c, RING, CROWD_ALPHA);
    crowd_scatter(&c, &g, 2, 0.2);
    runs(&g, RING);
    for (int k = 0; k < RING; ++k) {
        w.pair[k][0] = k;
        w.pair[k][1] = (k + 1) % RING;
    }
    web_terms(&w, RING, MOMENT | AXIAL, 0);
    const vti_bodies b = crowd_bodies(&c), most = vti_bodies_slice(b, 0, RING - 1);
    assert_int_equal(kernels->of[0][MOMENT | AXIAL].chain(&w.bonds, &b, 0, RING), RING);
    assert_in_range(kernels->of[0][MOMENT | AXIAL].chain(&w.bonds, &most, 0, RING), 0, RING - 1);
}

TEST(baseline)
{
    agree(&vti_binder_baseline);
    follow_rows(&vti_binder_baseline);
    close_ring(&vti_binder_baseline);
}

ON_AVX2(agree(&vti_binder_avx2); follow_rows(&vti_binder_avx2); close_ring(&vti_binder_avx2))
ON_AVX512(agree(&vti_binder_avx512); follow_rows(&vti_binder_avx512); close_ring(&vti_binder_avx512))

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
