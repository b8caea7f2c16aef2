/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What rounding does to what a step conserves exactly. Brouwer's law: it walks at random, as sqrt(N), and to neither
 * side. And reversed runs return. */
#include "rig.h"

#include "hard.h"

enum { ENSEMBLE = 64, FIRST = 8, LAST = 14 }; /* steps 2^8 to 2^14 */

/* ---- Brouwer's law ----------------------------------------------------------------------------------------------- */

typedef struct walk {
    double sum[LAST + 1], squares[LAST + 1];
} walk;

static void note(walk *w, int n, double off)
{
    w->sum[n] += off;
    w->squares[n] += off * off;
}

/** log(rms) over log(N) by a line. 64 members know an rms to 9 %, and neighbours share most of their walk: the slope
 *  over six octaves errs by some 0.03, so that 0.1 is three times that. The mean of the last is 0 within 3.5 of its
 *  standard errors. */
static void check(const walk *w, const char *what, const char *who)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    const int n = LAST - FIRST + 1;
    for (int k = FIRST; k <= LAST; ++k) {
        const double v = 0.5 * log2(w->squares[k] / ENSEMBLE);
        x += k;
        y += v;
        xx += (double)k * k;
        xy += k * v;
    }
    const double exponent = (n * xy - x * y) / (n * xx - x * x), rms = sqrt(w->squares[LAST] / ENSEMBLE);
    const double bias = w->sum[LAST] / ENSEMBLE / (rms / sqrt(ENSEMBLE));
    print_message("%-14s %-24s exponent %.3f, bias %.1f standard errors, %.2f eps sqrt(N)\n", who, what, exponent, bias,
                  rms / EPS / sqrt(ldexp(1, LAST)));
    assert_close(exponent, 0.5, 0.1);
    assert_below(fabs(bias), 3.5);
    char row[96];
    snprintf(row, sizeof row, "rounding of the %s, N steps", what);
    robust(row, who, "Brouwer's law: as N^0.5, no bias");
}

/** Of a pendulum: what each stepper conserves exactly, arm.Omega, and the energy of those whose own error is below
 *  rounding. In the body's frame R^T makes neither exact. */
static void pendulum_member(const vti_stepper *method, rng *g, double h, walk *spin, walk *energy)
{
    rig p = rig_random(g, RIG_ALPHA);
    double arm[3];
    const vti_bodies b = rig_bodies(&p);
    vti_pendulum_arm(&p.pendulum, &b, 0, arm);
    const double spin0 = vti_dot(arm, p.omega), energy0 = rig_energy(&p);
    long done = 0;
    rig_moment(&p);
    vti_step_start(method, h, &b);
    for (int n = FIRST; n <= LAST; ++n) {
        rig_steps(&p, method, h, (1L << n) - done);
        done = 1L << n;
        rig read = p;
        const vti_bodies copy = rig_bodies(&read);
        vti_step_sync(method, h, &copy);
        vti_pendulum_arm(&p.pendulum, &b, 0, arm);
        note(spin, n, vti_dot(arm, read.omega) - spin0);
        note(energy, n, rig_energy(&read) - energy0);
    }
}

TEST(pendulum)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        walk spin = {{0}, {0}}, energy = {{0}, {0}};
        rng g = rng_seed(61);
        if (method->frame == VTI_FRAME_BODY)
            continue;
        for (int i = 0; i < ENSEMBLE; ++i)
            pendulum_member(method, &g, 1.0 / 128, &spin, &energy);
        check(&spin, "momentum arm.Omega", method->name);
        if (method->order >= 6 && method->stages > 9) /* (h omega)^order is far below eps */
            check(&energy, "energy of a pendulum", method->name);
    }
}

/** Of a bond that stretches along itself, a harmonic oscillator: the steppers kick, drift, kick conserve the sum of
 *  |v|^2 + omega^2 (1 - h^2 omega^2/4) x^2 exactly. */
static void oscillator_member(const vti_stepper *method, rng *g, double h, walk *energy)
{
    static troupe t;
    static web w;
    crowd_clear(&t.c, 2, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = 1;
    w.axial[0] = 1;
    t.c.x[0][0] = 1 + uniform(g, 0.1, 0.4);
    t.c.v[0][0] = uniform(g, -0.4, 0.4);
    t.c.v[1][0] = -t.c.v[0][0];
    web_terms(&w, 1, AXIAL, 0);
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    troupe_ready(&t, method, &effect, 1);
    vti_step_start(method, h, &t.b);
    double start = NAN;
    long done = 0;
    for (int n = FIRST - 1; n <= LAST; ++n) {
        for (; n >= FIRST && done < 1L << n; ++done)
            troupe_step(&t, h, NULL);
        const crowd kept = t.c;
        vti_step_sync(method, h, &t.b);
        const double x = t.c.x[0][0] - t.c.x[1][0] - 1, v = t.c.v[0][0] - t.c.v[1][0];
        t.c = kept;
        const double now = 0.25 * (v * v + 2 * (1 - h * h / 2) * x * x); /* omega^2 = 2 K/m */
        if (n < FIRST)
            start = now;
        else
            note(energy, n, now - start);
    }
}

TEST(oscillator)
{
    static const char *const names[] = {"vti1", "vti2", "vti3-leapfrog", "vti1-body", "exact"};
    for (int k = 0; k < 5; ++k) {
        walk energy = {{0}, {0}};
        rng g = rng_seed(62);
        for (int i = 0; i < ENSEMBLE; ++i)
            oscillator_member(vti_stepper_find(names[k]), &g, 0.05, &energy);
        check(&energy, "energy of an oscillator", names[k]);
    }
}

/* ---- reversal ---------------------------------------------------------------------------------------------------- */

/** N steps forth and N back. Each kick leaves a rounding of Omega, of rms eps/2 of its size, which is below 2; from
 *  there the attitude goes astray linearly, as the motion is regular: after n = 2N steps the sum of independent eps (n
 *  - k) h over k is eps h n^{3/2}/sqrt 3. It is all of the same size for the kicks of a step of h together. */
TEST(forth_and_back)
{
    enum { STEPS = 100000 };
    const double h = 1.0 / 256, n = 2.0 * STEPS;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        const double bound = 2 * EPS * h * n * sqrt(n * (double)method->evals / 3);
        rig p = rig_of_the_paper(RIG_ALPHA);
        p.frame = (int)method->frame;
        const rig start = p;
        rig_run(&p, method, h, STEPS);
        for (int turn = 0; turn < 2; ++turn) {
            for (int c = 0; c < 3; ++c)
                p.omega[c] = -p.omega[c];
            if (turn == 0)
                rig_run(&p, method, h, STEPS);
        }
        const double off = rig_difference(&p, &start);
        print_message("%-14s returns to %.1e, bound %.1e\n", method->name, off, bound);
        if (method->reversible) {
            assert_below(bound, 1.4e-9);
            assert_below(off, fmin(bound, 1e-9));
        } else
            assert_true(off > 1e-6); /* h times the moment, at least now and then */
        robust("1e5 steps forth and 1e5 back, h = 1/256", method->name,
               method->reversible ? "returns to 1e-9" : "does not return: not reversible, as it says");
    }
}

RUN_TESTS(cmocka_unit_test(pendulum), cmocka_unit_test(oscillator), cmocka_unit_test(forth_and_back))
