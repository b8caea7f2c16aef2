/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Free bodies of three moments over many steps: L keeps its bits, and energy stays in the band of the first tenth of
 * the run, without drift; a slender body goes on where explicit Euler ends.      test_free_tops [STEPS] */
#include <stdio.h>
#include <stdlib.h>

#include "top.h"

static int64_t steps = 50000;

enum { TENTHS = 10 };

static top top_of(double a, double b, double c, double x, double y, double z)
{
    top p = {.alpha = {0, 0, 0}, .moments = {a, b, c}, .storage = TOP_ALPHA, .shows = TOP_L};
    p.spin[0] = a * x;
    p.spin[1] = b * y;
    p.spin[2] = c * z;
    return p;
}

/** Largest |T/T0 - 1| in every tenth of the steps; L is looked at in each. */
static void bands(const char *name, double h, int64_t count, top *p, double band[TENTHS])
{
    const vti_stepper *const method = vti_stepper_find(name);
    vti_bodies b = top_bodies(p);
    const double start[3] = {p->spin[0], p->spin[1], p->spin[2]}, energy = vti_kinetic_rotation(&b);
    assert_int_equal(vti_bodies_seal(&b), VTI_OK);
    for (int k = 0; k < TENTHS; ++k) {
        band[k] = 0;
        for (int64_t n = 0; n < count / TENTHS; ++n) {
            assert_int_equal(vti_step_next(method, h, &b, NULL), VTI_OK);
            band[k] = fmax(band[k], fabs(vti_kinetic_rotation(&b) / energy - 1));
        }
        assert_same_bits(p->spin, start, 3);
    }
    printf("%s, h = %g, %lld steps: energy within %.3g at first, %.3g at last\n", name, h, (long long)count, band[0],
           band[TENTHS - 1]);
}

/** Turning over about the middle axis, h|Omega| = 0.1: within 8.7e-5 by Strang's list and 1.3e-8 by M4, as 113 bits
 *  have it (EQUATIONS 7.2). */
TEST(energy_has_the_same_band_in_every_tenth)
{
    static const struct {
        const char *name;
        double most;
    } cases[] = {{"vti2", 1e-4}, {"exact", 2e-8}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; ++c) {
        double band[TENTHS];
        top p = top_of(1, 2, 3, 1e-3, 1, 1e-3);
        bands(cases[c].name, 0.1, steps, &p, band);
        for (int k = 0; k < TENTHS; ++k) {
            assert_true(band[k] < cases[c].most);
            assert_close(band[k], band[0], 0.01 * band[0] + 1e-13);
        }
    }
}

/** I w' = (I w) x w by explicit Euler. Steps until the energy has doubled. */
static int64_t euler_lasts(const double m[3], const double omega[3], double h, int64_t most)
{
    double w[3] = {omega[0], omega[1], omega[2]};
    const double start = m[0] * w[0] * w[0] + m[1] * w[1] * w[1] + m[2] * w[2] * w[2];
    for (int64_t n = 0; n < most; ++n) {
        const double L[3] = {m[0] * w[0], m[1] * w[1], m[2] * w[2]};
        double rate[3];
        vti_cross(L, w, rate);
        for (int k = 0; k < 3; ++k)
            w[k] += h * rate[k] / m[k];
        if (!(m[0] * w[0] * w[0] + m[1] * w[1] * w[1] + m[2] * w[2] * w[2] < 2 * start))
            return n;
    }
    return most;
}

/** 26 times lighter about its axis than across, h|Omega| = 0.1: for a tenth as many steps. */
TEST(slender_bodies_go_on)
{
    const double m[3] = {1.7231e-4, 0.0658e-4, 1.7243e-4}, omega[3] = {20, 100, 10}, h = 1e-3;
    const int64_t lasts = euler_lasts(m, omega, h, steps / 10);
    rotor ends[2];
    printf("explicit Euler doubles its energy in %lld steps\n", (long long)lasts);
    assert_true(lasts < 2000);
    static const char *const names[] = {"exact", "srkn11"}; /* whose lists are of order 4 and 6 */
    for (int c = 0; c < 2; ++c) {
        double band[TENTHS];
        top p = top_of(m[0], m[1], m[2], omega[0], omega[1], omega[2]);
        if (c == 0) {
            bands(names[c], h, steps / 10, &p, band);
            for (int k = 1; k < TENTHS; ++k)
                assert_close(band[k], band[0], 0.05 * band[0] + 1e-12);
        } else {
            const vti_bodies b = top_bodies(&p);
            const vti_stepper *const method = vti_stepper_find("srkn11");
            for (int64_t n = 0; n < steps / 10 * method->stages; ++n)
                assert_int_equal(vti_step_stage(method, n % method->stages, h, &b, NULL), VTI_OK);
        }
        ends[c] = top_attitude(&p);
    }
    const double off = quat_distance(ends[0], ends[1]);
    printf("the lists of order 4 and 6 end %.2g rad apart after %lld steps\n", off, (long long)(steps / 10));
    assert_true(off < 1e-8 * (double)steps / 10); /* 4e-8 in 1e4 steps (EQUATIONS 7.6), growing with time */
}

int main(int argc, char **argv)
{
    if (argc > 1)
        steps = strtoll(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {cmocka_unit_test(energy_has_the_same_band_in_every_tenth),
                                       cmocka_unit_test(slender_bodies_go_on)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
