/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The kernels of bonds for wide units give the bits of those for any processor, and strided bodies those of packed
 * ones: every combination of terms and forms, few bonds and many, alpha and quaternions, at half a turn among them.
 * Their tables are private to the library. */
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

TEST(baseline)
{
    agree(&vti_binder_baseline);
}

ON_AVX2(agree(&vti_binder_avx2))
ON_AVX512(agree(&vti_binder_avx512))

RUN_TESTS(cmocka_unit_test(baseline), cmocka_unit_test(avx2), cmocka_unit_test(avx512))
