/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The two-form of T*(R^3 x SO(3))^n on a free chain of three bonded spheres: sums over the bodies of
 *
 *     dp1 . dx2 - dp2 . dx1  +  dmu1 . eta2 - dmu2 . eta1 + mu . (eta1 x eta2)      (see test_symplectic.c)
 *
 * All exactly symplectic steppers conserve it to what differences show. chin4 is off by h^5 or less, and is off. */
#include "chain.h"

enum { BODIES = 3, PER_BODY = 12, NUMBERS = PER_BODY * BODIES };

typedef double tangent[NUMBERS]; /* of each body: dx, eta, dp, dmu */

static double two_form(const chain *c, const tangent a, const tangent b)
{
    double sum = 0;
    for (int i = 0; i < BODIES; ++i, a += PER_BODY, b += PER_BODY) {
        double bracket[3];
        vti_cross(a + 3, b + 3, bracket);
        sum += vti_dot(a + 6, b) - vti_dot(b + 6, a) + vti_dot(a + 9, b + 3) - vti_dot(b + 9, a + 3);
        sum += c->inertia[i] * vti_dot(c->omega[i], bracket);
    }
    return sum;
}

/** c moved by e in the k-th of its coordinate directions. */
static chain moved(const chain *c, int k, double e)
{
    chain d = *c;
    const int i = k / PER_BODY, what = k % PER_BODY / 3, axis = k % 3;
    if (what == 0)
        d.x[i][axis] += e;
    if (what == 1) {
        const double about[3] = {axis == 0, axis == 1, axis == 2};
        const rotor q = quat_times(quat_turn(about, e), chain_attitude(c, i));
        const double turned[4] = {(double)q.x, (double)q.y, (double)q.z, (double)q.w};
        for (int m = 0; m < 4; ++m)
            d.quat[i][m] = turned[m];
        for (int m = 0; m < 3; ++m)
            d.alpha[i][m] = 2 * turned[m] / turned[3];
    }
    if (what == 2)
        d.v[i][axis] += e / c->mass[i];
    if (what == 3)
        d.omega[i][axis] += e / c->inertia[i];
    return d;
}

/** (plus - minus)/(2 e), attitudes by the logarithm of what they differ by. */
static void quotient(const chain *plus, const chain *minus, double e, tangent t)
{
    for (int i = 0; i < BODIES; ++i, t += PER_BODY) {
        const rotor d = quat_times(chain_attitude(plus, i), quat_conj(chain_attitude(minus, i)));
        const long double v[3] = {d.x, d.y, d.z};
        for (int k = 0; k < 3; ++k) {
            t[k] = (plus->x[i][k] - minus->x[i][k]) / (2 * e);
            t[3 + k] = (double)(2 * v[k] / d.w) / (2 * e);
            t[6 + k] = plus->mass[i] * (plus->v[i][k] - minus->v[i][k]) / (2 * e);
            t[9 + k] = plus->inertia[i] * (plus->omega[i][k] - minus->omega[i][k]) / (2 * e);
        }
    }
}

/** The largest change of the two-form on pairs of coordinate directions by one step. */
static double defect(const vti_stepper *method, const chain *start, double h)
{
    static tangent image[NUMBERS];
    const double e = cbrt(EPS);
    chain end = *start;
    double most = 0;
    chain_run(&end, method, h, 1);
    for (int k = 0; k < NUMBERS; ++k) {
        chain plus = moved(start, k, e), minus = moved(start, k, -e);
        chain_run(&plus, method, h, 1);
        chain_run(&minus, method, h, 1);
        quotient(&plus, &minus, e, image[k]);
    }
    for (int i = 0; i < NUMBERS; ++i)
        for (int j = 0; j < i; ++j) {
            tangent ei = {0}, ej = {0};
            ei[i] = ej[j] = 1;
            most = fmax(most, fabs(two_form(&end, image[i], image[j]) - two_form(start, ei, ej)));
        }
    return most;
}

/* As in test_symplectic.c: differences err by e^2 of third derivatives and some eps/e, both 4e-11, in sums of
 * dozens. */
#define TOLERANCE (100 * (cbrt(EPS) * cbrt(EPS)))

TEST(symplectic_steppers_conserve_it)
{
    const double steps[] = {1.0 / 64, 0.125, 0.4};
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 6; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            chain c;
            if (method->frame == VTI_FRAME_BODY || !method->symplectic)
                continue;
            chain_make(&c, BODIES, (uint64_t)(331 + trial), (enum chain_storage)(trial & 1));
            const double off = defect(method, &c, steps[trial % 3]);
            print_message("%-14s h = %.3f: %.1e\n", method->name, steps[trial % 3], off);
            assert_below(off, TOLERANCE);
        }
}

/** The probe's force is a gradient but for terms of h^4, and acts for h. Two terms of the largest defect may cancel at
 *  one of the steps, hence the mean of several chains. */
TEST(chin4_is_off_by_h5)
{
    enum { CHAINS = 8 };
    double mean = 0;
    for (int trial = 0; trial < CHAINS; ++trial) {
        chain c;
        chain_make(&c, BODIES, (uint64_t)(331 + trial), (enum chain_storage)(trial & 1));
        const double coarse = defect(vti_stepper_find("chin4"), &c, 0.28);
        const double fine = defect(vti_stepper_find("chin4"), &c, 0.07);
        const double order = log2(coarse / fine) / 2;
        print_message("chin4: off by %.2e at h = 0.28, %.2e at 0.07: order %.2f\n", coarse, fine, order);
        assert_true(fine > 0.5 * TOLERANCE && order > 4.2);
        mean += order / CHAINS;
    }
    assert_true(mean > 4.9);
}

RUN_TESTS(cmocka_unit_test(symplectic_steppers_conserve_it), cmocka_unit_test(chin4_is_off_by_h5))
