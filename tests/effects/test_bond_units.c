/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The kernels of bonds for AVX2 give the bits of those for any processor: every combination of terms and forms,
 * few bonds and many, alpha and quaternions. Their tables are private to the library, and declared here as in src/vti_binder_table.h. */
#include "crowd.h"

struct bond_kernel {
    void (*apply)(const void *self, const vti_bodies *b);
    void (*energy)(const void *self, const vti_bodies *b, double *energies);
};
extern const struct bond_kernel vti_binder_baseline[4][4], vti_binder_avx2[4][4];

static crowd c, wide;
static web w;

TEST(avx2)
{
    if (!__builtin_cpu_supports("avx2"))
        skip();
    rng g = rng_seed(3071);
    for (int trial = 0; trial < 15 * 12; ++trial) {
        const int n = 2 + trial % 12 * 7;
        int terms, form;
        crowd_clear(&c, n, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        crowd_scatter(&c, &g, 2, 0.2);
        const int64_t count = web_grow(&w, &g, &c, n, 1, 20);
        crowd_scatter(&c, &g, 2, 0.2);
        crowd_tumble(&c, &g);
        web_combination(trial % 15, &terms, &form);
        web_terms(&w, count, terms, form);
        memset(c.force, 0, sizeof c.force);
        memset(c.moment, 0, sizeof c.moment);
        wide = c;
        const vti_bodies b = crowd_bodies(&c), other = crowd_bodies(&wide);
        const int row = terms & SHEAR ? form : 0, column = terms & (MOMENT | AXIAL);
        double energies[3] = {0, 0, 0}, others[3] = {0, 0, 0};
        vti_binder_baseline[row][column].apply(&w.bonds, &b);
        vti_binder_baseline[row][column].energy(&w.bonds, &b, energies);
        vti_binder_avx2[row][column].apply(&w.bonds, &other);
        vti_binder_avx2[row][column].energy(&w.bonds, &other, others);
        assert_same_bits(wide.force[0], c.force[0], 3 * n);
        assert_same_bits(wide.moment[0], c.moment[0], 3 * n);
        assert_same_bits(others, energies, 3);
    }
}

RUN_TESTS(cmocka_unit_test(avx2))
