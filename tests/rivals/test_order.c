/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Every rival converges with the order that it states, in attitude and in velocity, on the pendulum at t = 10 and on
 * the free chain at t = 1; what it converges to is the study's reference, which shares the forces with the rivals
 * and nothing else. */
#include "journey.h"

#include "fit.h"

enum { RUNGS = 7 };

/** t_end/h of the coarsest rung for methods of order 1, 2, 4 and 8, unless they have their own. Rungs are a factor of
 *  sqrt 2 apart. */
struct ladder {
    const char *scene;
    double t_end;
    int64_t steps[4];
};

/** Coarsest rungs of their own, on pendulum and chain, and how many rungs there are to a factor of two: of the highest
 *  orders, little lies between the step at which they are stable and that at which they are exact. 0: abm12 has nothing
 *  between these on the chain, and errors of verlet-x12 change their sign on the pendulum. */
static const struct {
    const char *name;
    int64_t pendulum, chain;
    double octave;
} own[] = {{"gear", 640, 1024, 2}, {"abm6", 160, 360, 2},    {"abm8", 160, 360, 4},
           {"abm10", 110, 360, 6}, {"abm12", 140, 0, 16},    {"vern9", 8, 24, 3},
           {"gbs12", 17, 20, 7},   {"verlet-x8", 10, 22, 2}, {"verlet-x12", 0, 14, 7}};

static int64_t rung(const struct ladder *ladder, const vti_stepper *method, int k)
{
    const int which = method->order == 1 ? 0 : method->order == 2 ? 1 : method->order == 4 ? 2 : 3;
    double coarsest = (double)ladder->steps[which], octave = 2.0;
    for (size_t i = 0; i < sizeof own / sizeof own[0]; ++i)
        if (strcmp(own[i].name, method->name) == 0) {
            coarsest = (double)(strcmp(ladder->scene, "chain") == 0 ? own[i].chain : own[i].pendulum);
            octave = own[i].octave;
        }
    return llrint(coarsest * pow(2.0, k / octave));
}

/** Where orders of that number may lie. Where the motion is mostly oscillation the leading terms of Runge-Kutta
 *  methods are small, and the next ones count until rounding ends the ladder: on the pendulum the fourth order is
 *  approached from below, and higher ones show as up to one more. */
static void range(double order, double *least, double *most)
{
    *least = order - (order < 4 ? 0.1 : order < 6 ? 0.25 : order < 10 ? 0.6 : 0.8);
    *most = order + (order < 4 ? 0.1 : order < 6 ? 0.25 : 1.5);
}

static void assert_order(const char *where, const char *of, const vti_stepper *method, double expected, const double *h,
                         const double *error)
{
    double floor[RUNGS], least, most;
    for (int k = 0; k < RUNGS; ++k)
        floor[k] = 1e-13; /* rounding after some thousand steps */
    const struct order fit = fit_order(h, error, floor, RUNGS);
    print_message("%s: %s: %s order %.3f +- %.3f, errors %.2e ... %.2e\n", where, method->name, of, fit.order,
                  fit.interval, error[0], error[RUNGS - 1]);
    range(expected, &least, &most);
    assert_true(fit.points >= 4);
    assert_below(fit.interval, expected < 6 ? 0.3 : expected < 10 ? 1.0 : 2.0);
    assert_below(least, fit.order);
    assert_below(fit.order, most);
}

/** A step that begins with a whole kick, as VTI-3's, has the positions and attitudes of Verlet where no force acts
 *  at t = 0 (EQUATIONS 2); its velocities lag all the same. */
static double attitude_order(const struct ladder *ladder, const vti_stepper *method)
{
    const int from_rest = strcmp(ladder->scene, "chain") == 0 && strcmp(method->name, "quat-euler") == 0;
    return from_rest ? 2.0 : (double)method->order;
}

static void orders(const struct ladder *ladder)
{
    struct scene scene;
    double *state;
    int64_t rivals = 0;
    read_scene(ladder->scene, &scene);
    const vti_bodies exact = reference_of(&scene, ladder->t_end, &state);
    for (int64_t i = 0; i < method_count(); ++i) {
        const vti_stepper *method = method_at(i);
        double h[RUNGS], attitude[RUNGS], velocity[RUNGS];
        if (method_rival(method) == NULL)
            continue;
        ++rivals;
        if (rung(ladder, method, 0) == 0)
            continue;
        for (int k = 0; k < RUNGS; ++k) {
            const int64_t steps = rung(ladder, method, k);
            h[k] = ladder->t_end / (double)steps;
            journey_errors(&scene, method, h[k], steps, &exact, &attitude[k], &velocity[k]);
        }
        assert_order(ladder->scene, "attitude", method, attitude_order(ladder, method), h, attitude);
        assert_order(ladder->scene, "velocity", method, (double)method->order, h, velocity);
    }
    assert_int_equal(rivals, rival_count());
    free(state);
}

TEST(pendulum)
{
    const struct ladder ladder = {"pendulum", 10.0, {1280, 320, 320, 8}};
    orders(&ladder);
}

TEST(chain)
{
    const struct ladder ladder = {"chain", 1.0, {4096, 256, 128, 22}};
    orders(&ladder);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(pendulum), cmocka_unit_test(chain))
