/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The coefficients of the steppers against theory: sums, symmetry, the equations that compositions and splittings
 * solve, and the harmonic oscillator, whose flow every list must agree with to its order. In long double. */
#include "support.h"

enum { STAGES = 24, DEGREE = 2 * STAGES };

/** Kicks and drifts each add up to a step. */
TEST(sums)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        long double kicks = 0, drifts = 0;
        for (int64_t i = 0; i <= s->stages; ++i) {
            kicks += s->kick[i];
            drifts += s->drift[i];
        }
        /* each of up to 18 numbers below 1 is rounded by eps/2, and what is left to the sum by as much again */
        assert_close(kicks, 1, 16 * EPS);
        assert_close(drifts, 1, 16 * EPS);
    }
}

/** Kicks and drifts in the order of a step, without those at the ends that are 0; the lag is taken from the first kick
 *  and given to the last, as the stepper is read. Returns how many there are. */
static int sequence(const vti_stepper *s, double *list)
{
    int n = 0;
    for (int64_t i = 0; i <= s->stages; ++i) {
        list[n++] = s->kick[i] - (i == 0 ? s->lag : 0) + (i == s->stages ? s->lag : 0);
        list[n++] = s->drift[i];
    }
    return n;
}

/** A reversible stepper reads the same from both ends, to the bit. */
TEST(symmetric)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        double list[2 * STAGES] = {0};
        int last = sequence(s, list) - 1, first = 0, same = 1;
        while (list[last] == 0)
            --last;
        while (list[first] == 0)
            ++first;
        for (int i = first; i <= last; ++i)
            same &= list[i] == list[last - (i - first)];
        same &= (last - first) % 2 == 0; /* kicks answer kicks */
        assert_int_equal(same, s->reversible);
    }
    const vti_stepper *chin = vti_stepper_find("chin4");
    assert_close(chin->probe[0], chin->probe[2], 0);
}

/** Suzuki's p solves 4 p^3 + (1 - 4p)^3 = 0. */
TEST(suzuki)
{
    const vti_stepper *s = vti_stepper_find("suzuki4");
    const long double p = 1 / (4 - cbrtl(4));
    for (int i = 0; i < 5; ++i)
        assert_close(s->drift[i], i == 2 ? 1 - 4 * p : p, 2 * EPS);
}

/** A composition of a symmetric step: kicks are the means of the drifts on either side, and sums of odd powers vanish.
 *  They are necessary for order 6 (powers 3 and 5) and 8 (also 7); their sizes are those of 17 numbers of order 1/2. */
TEST(kahan_li)
{
    const char *const names[] = {"suzuki4", "kl6", "kl8"};
    for (int m = 0; m < 3; ++m) {
        const vti_stepper *s = vti_stepper_find(names[m]);
        for (int64_t i = 0; i <= s->stages; ++i)
            assert_close(s->kick[i], 0.5 * ((i > 0 ? s->drift[i - 1] : 0) + s->drift[i]), EPS);
        for (int power = 3; power < s->order; power += 2) {
            long double sum = 0;
            for (int64_t i = 0; i < s->stages; ++i)
                sum += powl(s->drift[i], power);
            assert_close(sum, 0, 8 * EPS);
        }
    }
}

typedef long double poly[DEGREE + 4];

/** a += c z b */
static void add_shifted(poly a, long double c, const poly b)
{
    for (int k = DEGREE + 3; k > 0; --k)
        a[k] += c * b[k - 1];
}

/** The matrix of a step on x'' = -x as polynomials in z = h: rows x and v, columns of the start. A kick with a probe
 *  takes the force -(1 - c z^2) x. */
static void oscillator(const vti_stepper *s, poly matrix[2][2])
{
    memset(matrix, 0, 4 * sizeof(poly));
    matrix[0][0][0] = matrix[1][1][0] = 1;
    for (int64_t i = 0; i <= s->stages; ++i)
        for (int j = 0; j < 2; ++j) {
            const long double c = s->probe != NULL ? s->probe[i] : 0;
            poly kicked = {0}, once = {0}, twice = {0};
            add_shifted(kicked, -(s->kick[i] - (i == 0 ? s->lag : 0) + (i == s->stages ? s->lag : 0)), matrix[0][j]);
            add_shifted(once, 1, kicked);
            add_shifted(twice, 1, once);
            for (int k = 0; k < DEGREE + 4; ++k)
                matrix[1][j][k] += kicked[k] - c * twice[k];
            add_shifted(matrix[0][j], s->drift[i], matrix[1][j]);
        }
}

/** cos z in the diagonal, sin z and -sin z beside it: equal up to z^order, and not beyond. */
TEST(harmonic_oscillator)
{
    for (int64_t m = 0; m < vti_stepper_count(); ++m) {
        const vti_stepper *s = vti_stepper_at(m);
        poly matrix[2][2];
        oscillator(s, matrix);
        long double factorial = 1, beyond = 0;
        for (int k = 0; k <= s->order + 1; ++k) {
            factorial *= k > 0 ? k : 1;
            const long double term = (k / 2 % 2 ? -1 : 1) / factorial;
            const long double flow[2][2] = {{k % 2 ? 0 : term, k % 2 ? term : 0},
                                            {k % 2 ? -term : 0, k % 2 ? 0 : term}};
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    const long double off = matrix[i][j][k] - flow[i][j];
                    /* lists printed to 15 digits, and products of several of them */
                    if (k <= s->order)
                        assert_close(off, 0, 16 * EPS);
                    else
                        beyond = fmaxl(beyond, fabsl(off));
                }
        }
        assert_true(beyond > 1e-9);
    }
}

RUN_TESTS(cmocka_unit_test(sums), cmocka_unit_test(symmetric), cmocka_unit_test(suzuki), cmocka_unit_test(kahan_li),
          cmocka_unit_test(harmonic_oscillator))
