/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps that follow how fast bodies turn, as programs run them (EQUATIONS 8.4): against that equation written out for
 * the pendulum; energies without drift, beside the naive choice; where they lead does not depend on who looks, nor on a
 * stop; what cannot be served is refused. */
#include <string.h>

#include "journey.h"

static struct scene scene_with(const char *where, int64_t control, double turning)
{
    struct scene scene;
    read_scene(where, &scene);
    scene.control = control;
    scene.turning = turning;
    return scene;
}

static struct travel_tally tally_of(const struct journey *j)
{
    struct travel_tally tally;
    assert_int_equal(travel_tally(&j->travel, &tally), 1);
    return tally;
}

/* ---- the pendulum, s = (1/2 + |Omega|^2)^(-1/2), G = Omega.(RM/J)/(1/2 + |Omega|^2) ------------------------------ */

static double vector_at(const vti_view *view, int k)
{
    return view->c[k][0];
}

static double square_of(const vti_bodies *b)
{
    double sum = 0.5;
    for (int k = 0; k < 3; ++k)
        sum += vector_at(&b->omega, k) * vector_at(&b->omega, k);
    return sum;
}

static double rate_of(const vti_bodies *b, double inertia)
{
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
        sum += vector_at(&b->omega, k) * vector_at(&b->moment, k) / inertia;
    return sum / square_of(b);
}

static void step_by(const vti_stepper *by, double h, struct model *model)
{
    for (int64_t k = 0; k < by->stages; ++k) {
        assert_int_equal(vti_step_stage(by, k, h, &model->bodies, NULL), VTI_OK);
        assert_int_equal(model_forces(model, &model->bodies), VTI_OK);
    }
    assert_int_equal(vti_step_finish(by, h, &model->bodies), VTI_OK);
}

/** From t = 0 to t = end, where the last step is cut; returns how many whole ones there were. */
static int64_t written_out(const vti_stepper *by, double epsilon, int naive, double end, struct model *model)
{
    const double inertia = model->bodies.inertia.p[0];
    double rho = sqrt(square_of(&model->bodies)) + epsilon / 2 * rate_of(&model->bodies, inertia), t = 0.0;
    for (int64_t k = 0;; ++k) {
        const double h = naive ? epsilon / sqrt(square_of(&model->bodies)) : epsilon / rho;
        step_by(by, fmin(h, end - t), model);
        if (t + h >= end)
            return k;
        t += h;
        rho += epsilon * rate_of(&model->bodies, inertia);
    }
}

TEST(equation)
{
    static const char *const names[] = {"exact", "srkn6", "srkn14", "kl8"};
    for (int naive = 0; naive < 2; ++naive)
        for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
            struct scene scene = scene_with("pendulum", naive ? SCENE_NAIVE : SCENE_INTEGRATING, sqrt(0.5));
            struct journey j;
            struct model model;
            const double h = 0.125;
            scene.inertia = 2.0;
            begin(&j, &scene, method_of(names[i]), h);
            make_model(&scene, &model);
            go(&j, 64);
            /* s is of at most sqrt(2) there, of at most 1 here */
            const int64_t steps = written_out(method_of(names[i]), h * sqrt(0.5), naive, 8.0, &model);
            const vti_bodies b = travel_bodies(&j.travel);
            assert_int_equal(tally_of(&j).accepted, steps);
            assert_true(steps > 80);
            assert_below(attitude_distance(&b, &model.bodies), 1e-12); /* rounding of a hundred steps */
            assert_below(velocity_distance(&b, &model.bodies), 1e-12);
            model_destroy(&model);
            end(&j);
        }
}

/** Of many bodies: the density stays with the wish that it follows, 1/s, so there are as many steps as the wish alone
 *  asks for; with another rate it would leave that. */
TEST(many_bodies)
{
    int64_t steps[2];
    for (int naive = 0; naive < 2; ++naive) {
        struct scene scene = scene_with("chain", naive ? SCENE_NAIVE : SCENE_INTEGRATING, 0.05);
        struct journey j;
        scene.inertia = 2.0;
        begin(&j, &scene, method_of("srkn6"), 1.0 / 32);
        go(&j, 320);
        steps[naive] = tally_of(&j).accepted;
        assert_true(tally_of(&j).longest < 1.0 / 32);
        end(&j);
    }
    print_message("chain: %d and %d steps\n", (int)steps[0], (int)steps[1]);
    assert_true(steps[0] > 400);
    assert_true(llabs(steps[0] - steps[1]) <= steps[1] / 50); /* they differ by h^2 of the wish's change in a step */
}

/* ---- long times -------------------------------------------------------------------------------------------------- */

struct energies {
    double start, worst, half[2];
    int64_t looks, last;
};

static int see_energy(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct energies *e = self;
    (void)t;
    double kinetic = 0.0, arm = 0.0;
    for (int k = 0; k < 3; ++k)
        kinetic += 0.5 * vector_at(&b->omega, k) * vector_at(&b->omega, k);
    const rotor q = quat_unit(attitude_of(b, 0));
    arm = (double)(1.0L - 2.0L * (q.x * q.x + q.y * q.y)); /* of R e3 along e3, the direction of the weight */
    const double energy = kinetic - arm;
    e->start = step == 0 ? energy : e->start;
    e->worst = fmax(e->worst, fabs(energy - e->start));
    e->half[2 * step > e->last] += energy - e->start;
    ++e->looks;
    return 0;
}

static struct energies long_way(const char *name, int64_t control, int64_t steps)
{
    const struct scene scene = scene_with("pendulum", control, sqrt(0.5));
    struct journey j;
    struct energies e = {.last = steps};
    const struct observer observer = {see_energy, &e, 7, 0, NULL, NULL};
    begin(&j, &scene, method_of(name), sqrt(0.5));
    assert_int_equal(travel_show(&j.travel, steps, &observer, 1, &j.message), 0);
    print_message("%s, %d steps: |E - E_0| at most %.2e, means of its halves %.3e and %.3e\n", j.travel.stepper->name,
                  (int)tally_of(&j).accepted, e.worst, 2 * e.half[0] / (double)e.looks,
                  2 * e.half[1] / (double)e.looks);
    end(&j);
    return e;
}

TEST(no_drift)
{
    const char *asked = getenv("VTI_TEST_STEPS");
    const int64_t steps = (asked != NULL ? atoll(asked) : 20000) / 7 * 4; /* of h: there are 1.8 steps in each */
    static const char *const names[] = {"srkn6", "srkn11"};
    for (int i = 0; i < 2; ++i) {
        const struct energies good = long_way(names[i], SCENE_INTEGRATING, steps),
                              naive = long_way(names[i], SCENE_NAIVE, steps);
        const double looks = (double)good.looks / 2;
        assert_true(fabs(good.half[1] - good.half[0]) < 0.02 * looks * good.worst);
        assert_true(fabs(naive.half[1] - naive.half[0]) > 0.3 * looks * naive.worst);
        assert_true(naive.worst > 10 * good.worst);
    }
}

/* ---- who looks --------------------------------------------------------------------------------------------------- */

TEST(looking_and_stopping)
{
    for (int naive = 0; naive < 2; ++naive) {
        const struct scene scene = scene_with("chain", naive ? SCENE_NAIVE : SCENE_INTEGRATING, 0.1);
        struct journey one, many, late;
        begin(&one, &scene, method_of("srkn11"), 1.0 / 16);
        begin(&many, &scene, method_of("srkn11"), 1.0 / 16);
        begin(&late, &scene, method_of("srkn11"), 1.0 / 16);
        go(&one, 64);
        for (int k = 0; k < 23; ++k)
            go(&many, 1);
        /* from what a checkpoint keeps */
        int64_t doubles, others;
        double *const from = travel_state(&many.travel, &doubles), *const to = travel_state(&late.travel, &others);
        const int64_t n = many.model.bodies.count;
        assert_int_equal(doubles, others);
        memcpy(to, from, (size_t)doubles * sizeof *to);
        memcpy(late.model.bodies.x.c[0], many.model.bodies.x.c[0], (size_t)(3 * n) * sizeof *to);
        memcpy(late.model.bodies.v.c[0], many.model.bodies.v.c[0], (size_t)(3 * n) * sizeof *to);
        memcpy(late.model.bodies.omega.c[0], many.model.bodies.omega.c[0], (size_t)(3 * n) * sizeof *to);
        travel_resume(&late.travel, 23);
        for (int k = 23; k < 64; ++k)
            go(&many, 1);
        go(&late, 41);
        const vti_bodies a = travel_bodies(&one.travel), b = travel_bodies(&many.travel),
                         c = travel_bodies(&late.travel);
        assert_same_bits(a.x.c[0], b.x.c[0], (size_t)(3 * n));
        assert_same_bits(a.omega.c[0], b.omega.c[0], (size_t)(3 * n));
        assert_same_bits(a.x.c[0], c.x.c[0], (size_t)(3 * n));
        assert_same_bits(a.omega.c[0], c.omega.c[0], (size_t)(3 * n));
        assert_int_equal(tally_of(&one).accepted, tally_of(&many).accepted);
        assert_int_equal(tally_of(&many).cut, 64);
        assert_int_equal(tally_of(&one).evals, 1 + 11 * (tally_of(&one).accepted + 1));
        assert_int_equal(travel_force_evals(&one.travel), tally_of(&one).evals);
        assert_int_equal(travel_force_evals(&many.travel), tally_of(&one).evals);
        end(&one);
        end(&many);
        end(&late);
    }
}

TEST(wanted_sooner)
{
    for (int naive = 0; naive < 2; ++naive) {
        const struct scene scene = scene_with("chain", naive ? SCENE_NAIVE : SCENE_INTEGRATING, 0.1);
        assert_impatience_changes_nothing(&scene, method_of("srkn11"));
    }
}

/** Where numbers are h apart, t does not move by steps that are shorter. */
TEST(too_late)
{
    enum { TIME = 0 }; /* of what a checkpoint has */
    const int64_t late = (int64_t)1 << 52;
    for (int naive = 0; naive < 2; ++naive) {
        const struct scene scene = scene_with("pendulum", naive ? SCENE_NAIVE : SCENE_INTEGRATING, 0.1);
        struct journey j;
        int64_t doubles;
        begin(&j, &scene, method_of("srkn11"), 1.0 / 16);
        travel_state(&j.travel, &doubles)[TIME] = (double)late / 16.0;
        travel_resume(&j.travel, late);
        assert_int_equal(travel_go(&j.travel, 2, &j.message), -1);
        assert_non_null(strstr(j.message.text, "end the run sooner"));
        end(&j);
    }
}

/* ---- what there is not ------------------------------------------------------------------------------------------- */

static void assert_refused(const char *where, const char *name, const char *words)
{
    const struct scene scene = scene_with(where, SCENE_INTEGRATING, 0.0);
    assert_no_journey(&scene, name, words);
}

TEST(refused)
{
    assert_refused("chain", "an7", "control: the stepper an7 is no reversible list");
    assert_refused("chain", "vti3", "take srkn6");
    assert_refused("chain", "vti3-leapfrog", "take srkn6");
    assert_refused("chain", "chin4", "at its own positions alone");
    assert_refused("chain", "rk4", "leave control out");
    assert_refused("chain", "srkn11-tol", "leave control out");
    assert_refused("torus", "srkn6", "control: integrating: the forces of contact have kinks");
    assert_refused("pile", "srkn6", "have kinks");
    assert_refused("drum", "exact", "would have dissipated already; leave control out");
    assert_refused("slender", "srkn6", "bodies.moments");
}

/** Bodies that turn freely: no moment changes the density of steps. */
TEST(no_moments)
{
    for (int naive = 0; naive < 2; ++naive) {
        const struct scene scene = scene_with("spin", naive ? SCENE_NAIVE : SCENE_INTEGRATING, 0.1);
        struct journey j;
        begin(&j, &scene, method_of("exact"), 1.0 / 16);
        go(&j, 16);
        end(&j);
    }
}

/** Steps of which a step of h has more than anybody waits for. */
TEST(too_fine)
{
    const struct scene scene = scene_with("pendulum", SCENE_INTEGRATING, 1e-12);
    struct journey j;
    begin(&j, &scene, method_of("exact"), 1.0 / 16);
    assert_int_equal(travel_go(&j.travel, 1, &j.message), -1);
    assert_non_null(strstr(j.message.text, "t = 0: steps become shorter than 2^-26 h"));
    end(&j);
}

/** Where a step is as long as the wish changes over, the density comes to nothing. */
TEST(too_long)
{
    const struct scene scene = scene_with("pendulum", SCENE_INTEGRATING, 0.1);
    struct journey j;
    begin(&j, &scene, method_of("exact"), 50.0);
    assert_int_equal(travel_go(&j.travel, 100, &j.message), -1);
    assert_non_null(strstr(j.message.text, "exact-integrating at h = 50"));
    assert_non_null(
        strstr(j.message.text, "turn so much more slowly that no next one can be chosen; take a smaller h"));
    end(&j);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(equation), cmocka_unit_test(many_bodies), cmocka_unit_test(no_drift),
                    cmocka_unit_test(looking_and_stopping), cmocka_unit_test(wanted_sooner), cmocka_unit_test(too_late),
                    cmocka_unit_test(refused), cmocka_unit_test(too_long), cmocka_unit_test(no_moments),
                    cmocka_unit_test(too_fine))
