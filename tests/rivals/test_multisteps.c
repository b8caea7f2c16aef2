/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The library's multistep methods on their way through scenes: their orders on the pendulum and the free chain against
 * the study's reference, and the drift of the energy, which goes on with time as that of the lists of kicks and drifts
 * does not. */
#include "journey.h"

#include "fit.h"

enum { RUNGS = 6, METHODS = 5 };

struct ladder {
    const char *scene;
    double t_end;
    int64_t steps[METHODS]; /* of the coarsest rung; others are a factor of 2^(1/4) apart */
};

static void assert_order(const char *where, const char *of, const vti_stepper *method, const double *h,
                         const double *error)
{
    double floor[RUNGS];
    for (int k = 0; k < RUNGS; ++k)
        floor[k] = 1e-13; /* rounding after some hundred steps */
    const struct order fit = fit_order(h, error, floor, RUNGS);
    print_message("%s: %s: %s order %.3f +- %.3f, errors %.2e ... %.2e\n", where, method->name, of, fit.order,
                  fit.interval, error[0], error[RUNGS - 1]);
    if (method->reach < 0.2 && error[0] < 1e-11) /* steps that are stable leave rounding alone */
        return;
    assert_true(fit.points >= 4);
    /* from order 9 there is little room between the longest steps, whose errors fall faster, and rounding, and starts
     * are of less, which shows in runs so short: tests/property/test_multistep.c starts better and measures closer */
    assert_close(fit.order, (double)method->order, method->order < 9 ? 0.5 : 3.0);
}

static void orders(const struct ladder *ladder)
{
    struct scene scene;
    double *state;
    read_scene(ladder->scene, &scene);
    const vti_bodies exact = reference_of(&scene, ladder->t_end, &state);
    assert_int_equal(vti_multistep_count(), METHODS);
    for (int64_t i = 0; i < METHODS; ++i) {
        const vti_stepper *method = &multistep_at(i)->stepper;
        double h[RUNGS], attitude[RUNGS], velocity[RUNGS];
        for (int k = 0; k < RUNGS; ++k) {
            const int64_t steps = llrint((double)ladder->steps[i] * pow(2.0, 0.25 * k));
            h[k] = ladder->t_end / (double)steps;
            journey_errors(&scene, method, h[k], steps, &exact, &attitude[k], &velocity[k]);
        }
        assert_order(ladder->scene, "attitude", method, h, attitude);
        assert_order(ladder->scene, "velocity", method, h, velocity);
    }
    free(state);
}

TEST(pendulum)
{
    const struct ladder ladder = {"pendulum", 10.0, {320, 50, 90, 60, 60}};
    orders(&ladder);
}

TEST(chain)
{
    const struct ladder ladder = {"chain", 1.0, {300, 180, 170, 200, 450}};
    orders(&ladder);
}

/** The ring's particle 40 touches its wall at the start, and others as they follow: each of these is a kink of the
 *  force, which leaves order 2.5 of any method whose steps know nothing of it. */
TEST(touches)
{
    enum { FIRST = 512 };
    struct scene scene;
    double *memory;
    read_scene("torus", &scene);
    const double t_end = 0.25;
    const vti_bodies exact = reference_of(&scene, t_end, &memory);
    for (int64_t i = 0; i < METHODS; ++i) {
        const vti_stepper *method = &multistep_at(i)->stepper;
        double velocity[2] = {0.0, 0.0};
        for (int half = 0; half < 2; ++half)
            for (int k = 0; k < 4; ++k) { /* mean squares, over where in a step they touch */
                const int64_t steps = ((FIRST + 13 * k) << half) * (method->reach < 0.2 ? 2 : 1);
                double of_attitude, of_velocity;
                journey_errors(&scene, method, t_end / (double)steps, steps, &exact, &of_attitude, &of_velocity);
                velocity[half] += of_velocity * of_velocity;
            }
        const double order = 0.5 * log2(velocity[0] / velocity[1]);
        print_message("torus: %s: errors %.2e, %.2e, order %.2f\n", method->name, sqrt(0.25 * velocity[0]),
                      sqrt(0.25 * velocity[1]), order);
        assert_true(order > 3.5);
    }
    free(memory);
}

/** What the energy has changed by after each of the parts of a run. */
static void drift(const char *name, double h, int64_t steps, int parts, double *change)
{
    struct scene scene;
    struct journey j;
    read_scene("pendulum", &scene);
    begin(&j, &scene, method_of(name), h);
    const double before = model_energy(&j.model, &j.model.bodies);
    for (int k = 0; k < parts; ++k) {
        go(&j, steps);
        const vti_bodies b = travel_bodies(&j.travel);
        change[k] = model_energy(&j.model, &b) - before;
    }
    end(&j);
}

/** Eight steps a unit of time, to t = 4000. */
TEST(energy_drifts_evenly)
{
    enum { PARTS = 4 };
    double of_an7[PARTS], of_srkn11[PARTS];
    drift("an7", 0.125, 8000, PARTS, of_an7);
    drift("srkn11", 0.125, 8000, PARTS, of_srkn11);
    for (int k = 0; k < PARTS; ++k) {
        print_message("t = %d: an7 %.3e, %.2e a unit of time; srkn11 %.2e\n", 1000 * (k + 1), of_an7[k],
                      of_an7[k] / (1000.0 * (k + 1)), of_srkn11[k]);
        assert_close(of_an7[k] / of_an7[0], k + 1, 0.2 * (k + 1));
        assert_below(fabs(of_srkn11[k]), 1e-9);
    }
    assert_true(fabs(of_an7[0]) > 1e-6);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(pendulum), cmocka_unit_test(chain), cmocka_unit_test(touches),
                    cmocka_unit_test(energy_drifts_evenly))
