/* SPDX-License-Identifier: BSD-3-Clause
 * The stable step of the shipped scenes, whose folder is the argument, against the true limit 2/omega_max and against
 * what the scenes do: bounded at 0.95 of the bound, and at 1.05 of the true limit not. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "../effects/hessian.h"

static const char *folder;
static struct scene scene;
static struct model model;
static struct message message;
static const vti_deformation rest = {0, 0, 0};

static double bound(const vti_deformation *at)
{
    vti_stable stable;
    assert_int_equal(model_stable_step(&model, &model.bodies, at, &stable, &message), 0);
    return stable.h;
}

/** As vti-run says it before a run. */
static double bound_within(void)
{
    const vti_deformation at = model_deformation(&model, &model.bodies);
    return bound(&at);
}

/* ---- runs -------------------------------------------------------------------------------------------------------- */

struct watch {
    double zero;   /* energy at rest */
    double start;  /* energy at the start, over zero */
    double most;   /* largest energy over zero, in units of start */
    int64_t every; /* steps between limits; 0: none */
    double limit;  /* the least */
};

enum { FAR = 1000000 }; /* energy of a run that has no bound */

static int see(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct watch *w = self;
    const double ratio = (model_energy(&model, bodies) - w->zero) / w->start;
    (void)t;
    w->most = isnan(ratio) ? INFINITY : fmax(w->most, ratio);
    if (w->every > 0 && step % w->every == 0)
        w->limit = fmin(w->limit, hessian_limit(bodies, model.effects, model.effects_count));
    return !(w->most < FAR);
}

/** The model steps by h, until it is far or a step is refused, and is destroyed. */
static struct watch run(double zero, double h, int64_t steps, int64_t every)
{
    struct watch w = {zero, model_energy(&model, &model.bodies) - zero, 0.0, every, INFINITY};
    const struct observer observer = {see, &w, 1, 0, NULL, NULL};
    assert_int_equal(model_forces(&model, &model.bodies), VTI_OK);
    if (loop_run(&model, scene.stepper, h, 0, steps, &observer, 1, &message) < 0)
        w.most = INFINITY;
    model_destroy(&model);
    return w;
}

/* ---- near rest --------------------------------------------------------------------------------------------------- */

static void set_zero(const vti_view *view)
{
    for (int64_t i = 0; i < model.bodies.count && view->c[0] != NULL; ++i)
        for (int k = 0; k < 3; ++k)
            view->c[k][i * view->stride] = 0.0;
}

/** The scene at rest, alpha = 0, with its first effect alone, binder or pendulum: what is linear in it. (Contact is
 *  not, however small the overlap.) */
static void open_at_rest(const char *name)
{
    open_scene(folder, name, &scene, &model);
    model.effects_count = 1;
    set_zero(&model.bodies.v);
    set_zero(&model.bodies.omega);
    set_zero(&model.bodies.alpha);
}

/** Displaced by 1e-6, the largest energy over that at the start. What couples the modes is then of the size of 1e-6 a
 *  step. (With strains of 1e-4 three modes whose phases add up to 2 pi can feed each other until the scene flies apart,
 *  within some thousands of steps at 0.95 of a bound that is close to the limit.) */
static double growth(const char *name, double h, int64_t steps)
{
    rng g = rng_seed(3078);
    open_at_rest(name);
    const double zero = model_energy(&model, &model.bodies);
    for (int64_t i = 0; i < model.bodies.count; ++i)
        for (int k = 0; k < 6; ++k)
            if (hessian_loads(&model.bodies, k) != NULL)
                hessian_move(&model.bodies, i, k, uniform(&g, -1e-6, 1e-6));
    return run(zero, h, steps, 0).most;
}

/** Of each mode the step conserves v^2/2 + (1 - (h omega/2)^2) omega^2 q^2/2, so that from rest its energy only falls.
 *  Above the limit that of the fastest grows by e^1.3 a step, and 400 steps are enough to reach any. share: of the
 *  limit that the bound reaches, a little less than measured. The energy of the pendulum is 1e-12 in 1, to 1e-16. */
TEST(near_rest)
{
    static const struct {
        const char *name;
        double share;
    } scenes[] = {{"chain", 0.84}, {"block", 0.69}, {"torus", 0.99}, {"torus-printed", 0.99}, {"pendulum", 0.999}};
    for (size_t k = 0; k < sizeof scenes / sizeof scenes[0]; ++k) {
        const char *name = scenes[k].name;
        open_at_rest(name);
        const double limit = hessian_limit(&model.bodies, model.effects, 1), h = bound(&rest);
        model_destroy(&model);
        const double below = growth(name, 0.95 * h, 4000), above = growth(name, 1.05 * limit, 400);
        print_message("%s at rest: bound %.6g, 2/omega_max %.6g, ratio %.4f; energy x %.5f at 0.95, %.2g at 1.05\n",
                      name, h, limit, h / limit, below, above);
        assert_below(h, limit * (1 + HESSIAN_ERROR));
        assert_true(h >= scenes[k].share * limit);
        assert_below(below, 1 + 4000 * 1e-6);
        assert_true(above >= FAR);
    }
}

/* ---- in contact -------------------------------------------------------------------------------------------------- */

/** The bound of the start against the limit in flight, where contacts are deep and bonds are bent. */
TEST(in_flight)
{
    static const struct {
        const char *name;
        int64_t steps, every;
    } scenes[] = {{"block", 1200, 120}, {"torus", 600, 20}, {"torus-printed", 600, 20}, {"pile", 6000, 1500}};
    for (size_t k = 0; k < sizeof scenes / sizeof scenes[0]; ++k) {
        open_scene(folder, scenes[k].name, &scene, &model);
        const double h = bound_within();
        const struct watch w = run(0.0, 0.25 * h, scenes[k].steps, scenes[k].every);
        print_message("%s in flight: bound %.5g, least 2/omega_max %.5g, ratio %.3f\n", scenes[k].name, h, w.limit,
                      h / w.limit);
        assert_true(isfinite(w.limit));
        assert_below(h, w.limit);
    }
}

/** A bead at rest that touches a slope: the weight takes it in by up to o, m g D o = 2/5 K o^(5/2), and what holds it
 *  there bounds the step, though nothing has energy at first. Each of 16 turns leaves 2/5 of what log(o) is off by, 10
 *  at first. */
TEST(at_rest_on_a_slope)
{
    open_scene(folder, "incline", &scene, &model);
    const vti_deformation at = model_deformation(&model, &model.bodies);
    const double weight = 1.309e-3 * 9.81 * 0.01, stiffness = 2.0;
    assert_close(at.overlap, pow(2.5 * weight / stiffness, 2.0 / 3.0), 10 * pow(0.4, 16) * at.overlap);
    assert_true(isinf(bound(&rest)));
    const double h = bound(&at);
    const struct watch w = run(0.0, 0.25 * h, 4000, 20);
    print_message("incline: bound %.5g, least 2/omega_max %.5g\n", h, w.limit);
    assert_true(isfinite(w.limit));
    assert_below(h, w.limit);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(near_rest), cmocka_unit_test(in_flight),
                                       cmocka_unit_test(at_rest_on_a_slope)};
    folder = argc > 1 ? argv[1] : ".";
    return cmocka_run_group_tests(tests, NULL, NULL);
}
