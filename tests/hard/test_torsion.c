/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Each stepper beside the stable step, on two bodies with a bond that resists torsion. theta'' = -K (1/J_i + 1/J_j)
 * theta: vti_stable_step is then exact, and h = share * reach/2 * vti_stable_step. */
#include "hard.h"

enum { STEPS = 20000 };

static troupe t;
static web w;
static vti_effect effect;

/** The twist about e3; the bodies turn about it only. */
static double twist(void)
{
    return 2 * (atan2(t.c.alpha[0][2], 2) - atan2(t.c.alpha[1][2], 2));
}

static void pose(const vti_stepper *method, double amplitude)
{
    crowd_clear(&t.c, 2, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    t.c.x[0][0] = w.rest[0][0] = w.rest[0][3] = 1;
    t.c.inertia[0] = 0.5;
    t.c.inertia[1] = 2;
    w.pair[0][1] = 1;
    w.moment[0] = 3;
    web_terms(&w, 1, MOMENT, 0);
    effect = vti_bonds_effect(&w.bonds);
    /* shared so that their sum of J theta, which stays, is 0 */
    t.c.alpha[0][2] = 2 * tan(0.5 * amplitude * 0.8);
    t.c.alpha[1][2] = -2 * tan(0.5 * amplitude * 0.2);
    troupe_ready(&t, method, &effect, 1);
}

static double stable_step(void)
{
    const double h = crowd_stable(&t.c, &effect, 1, 0);
    assert_close(h, 2 / sqrt(3 * (1 / 0.5 + 1 / 2.0)), 4 * EPS);
    return h;
}

enum outcome { BOUNDED, UNBOUNDED, REFUSED };

/** Unbounded: the energy, of what a step conserves nearly, rises to 1e4 times its start. */
static enum outcome run(const vti_stepper *method, double amplitude, double share)
{
    pose(method, amplitude);
    const double h = share * method->reach / 2 * stable_step(), start = troupe_energy(&t);
    vti_fault fault;
    vti_step_start(method, h, &t.b);
    for (int i = 0; i < STEPS; ++i) {
        const int status = troupe_step(&t, h, &fault);
        assert_true(troupe_is_finite(&t) && fabs(twist()) <= 2 * PI * (1 + EPS));
        if (status != VTI_OK) {
            assert_int_equal(status, VTI_E_TOO_LARGE);
            assert_true(method->law == VTI_LAW_CLOSED && fault.value >= 1);
            return REFUSED;
        }
        if (troupe_energy(&t) > 1e4 * start)
            return UNBOUNDED;
    }
    return BOUNDED;
}

TEST(beside_the_stable_step)
{
    const double shares[] = {0.90, 0.99, 1.01, 1.10}, amplitudes[] = {1e-6, 0.1, 0.5, 1, 1.5};
    for (int a = 0; a < 5; ++a)
        for (int s = 0; s < 4; ++s)
            for (int64_t k = 0; k < vti_stepper_count(); ++k) {
                const vti_stepper *method = vti_stepper_at(k);
                const enum outcome got = run(method, amplitudes[a], shares[s]);
                char what[96];
                /* reach is where stability is first lost; the long lists regain it not far above, for a while */
                if (a == 0 && (s < 2 || method->stages == 1))
                    assert_int_equal(got == BOUNDED, s < 2);
                snprintf(what, sizeof what, "torsion by %g rad at %.2f of the stepper's own stable step", amplitudes[a],
                         shares[s]);
                if (got == REFUSED)
                    robust(what, method->name, "reported: %s", vti_status_text(VTI_E_TOO_LARGE));
                else
                    robust(what, method->name, got == BOUNDED ? "bounded" : "unbounded, finite");
            }
}

RUN_TESTS(cmocka_unit_test(beside_the_stable_step))
