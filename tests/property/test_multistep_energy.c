/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The energy of a multistep method drifts in proportion to time. Its rate on the paper's pendulum, as a share of the
 * energy per unit of time, is that of EQUATIONS 8.1, found by another code, and that of the methods of the library the
 * table of docs/linking.md. */
#include "march.h"
#include "rig.h"

enum { PARTS = 4, TIME = 500 };

/** The drift by the end of each part, from where the start has left the energy. */
static void find_rates(const vti_multistep *m, int64_t steps, double rate[PARTS])
{
    rig p = rig_of_the_paper(RIG_QUAT);
    double memory[MARCH_DEPTH][6];
    vti_past past = {memory[0], m->depth, 0};
    const vti_bodies b = rig_bodies(&p);
    const double h = 1 / (double)steps;
    rig_moment(&p);
    march_start(m, h, &past, &b, rig_load, &p);
    const double before = rig_energy(&p);
    for (int k = 0; k < PARTS; ++k) {
        march_on(m, h, TIME * steps, &past, &b, rig_load, &p);
        rate[k] = (rig_energy(&p) - before) / (before * (k + 1) * TIME);
    }
}

/** The rate is told to half a unit of its last digit; about it the energy swings by a few hundredths of the drift. */
static void assert_drifts(const vti_multistep *m, int64_t steps, double expected, double unit)
{
    double rate[PARTS];
    find_rates(m, steps, rate);
    print_message("%s K = %d, c = %g, %d steps a unit of time: %.2e by t = %d, %.2e by t = %d\n", m->name,
                  (int)m->depth, m->c, (int)steps, rate[0], TIME, rate[PARTS - 1], PARTS * TIME);
    for (int k = 0; k < PARTS; ++k)
        assert_close(rate[k], expected, 0.06 * fabs(expected) + 0.5 * unit);
}

TEST(of_the_equations)
{
    static const struct {
        double c, rate, unit;
        int depth, steps;
    } rows[] = {{0.75, -1.6e-7, 1e-8, 5, 8}, {0.75, 1.6e-8, 1e-9, 8, 8}, {0.75, 5e-11, 1e-11, 9, 12}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
        const vti_multistep m = {"own", rows[k].depth, rows[k].c, 0, 0, ""};
        assert_drifts(&m, rows[k].steps, rows[k].rate, rows[k].unit);
    }
}

TEST(of_the_library)
{
    static const struct {
        const char *name;
        double rate, unit; /* at 8 steps a unit of time */
    } rows[] = {{"an4", -2.8e-7, 1e-8},
                {"an7", -2.4e-7, 1e-8},
                {"an9", 8.1e-9, 1e-10},
                {"an10-mid", 8.2e-9, 1e-10},
                {"an10-fine", -9.7e-10, 1e-11}};
    assert_int_equal(sizeof rows / sizeof rows[0], vti_multistep_count());
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k)
        assert_drifts(vti_multistep_find(rows[k].name), 8, rows[k].rate, rows[k].unit);
}

RUN_TESTS(cmocka_unit_test(of_the_equations), cmocka_unit_test(of_the_library))
