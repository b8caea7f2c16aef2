/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies of three moments: their reference, which goes by Euler's equations, against elliptic functions and against the
 * library's own steppers, which go by angular momenta; and the rivals that know such bodies. */
#include "fit.h"
#include "free_body.h"
#include "journey.h"
#include "state.h"

static void set_vector(double to[3], double x, double y, double z)
{
    to[0] = x;
    to[1] = y;
    to[2] = z;
}

/* ---- references -------------------------------------------------------------------------------------------------- */

/** A free body along axes that its principal ones are turned from. Its attitude starts as none, that of
 *  free_attitude does not. */
static double off_elliptic_functions(const double I[3], const double principal[3], double t_end)
{
    const struct free_body f = free_body_of(I, 0.4, 0.9);
    const rotor p = quat_of_alpha(principal);
    struct scene scene;
    double *solution, w[3] = {0.4, 0.0, 0.9};
    read_scene("dzhanibekov", &scene);
    quat_rotate(p, w, w);
    for (int k = 0; k < 3; ++k) {
        scene.moments[k] = I[k];
        scene.principal[k] = principal[k];
        scene.omega[k] = w[k];
    }
    const vti_bodies b = reference_of(&scene, t_end, &solution);
    /* R P = P A(0)^-1 A(t) with R = 1 at t = 0 */
    const rotor start = quat_times(p, quat_conj(free_attitude(&f, 0.0))),
                axes = quat_times(start, free_attitude(&f, t_end)), R = quat_times(axes, quat_conj(p));
    const double off = quat_distance(quat_unit(attitude_of(&b, 0)), R);
    free(solution);
    return off;
}

TEST(free_reference)
{
    static const double moments[2][3] = {{1, 1.7, 2.3}, {0.2, 1.0, 1.1}}, none[3] = {0, 0, 0}, turned[3] = {1, -0.5, 2};
    for (int k = 0; k < 2; ++k) {
        const double off = off_elliptic_functions(moments[k], k == 0 ? none : turned, 20.0);
        print_message("reference of a free body, t = 20: off elliptic functions by %.3g\n", off);
        assert_below(off, 20.0 * 1e-13);
    }
}

/** A top without symmetry, its principal axes turned against the body's; and two of them, bonded. */
static void asymmetric(const char *where, struct scene *scene)
{
    read_scene(where, scene);
    scene->inertia = 0.0;
    set_vector(scene->moments, 0.6, 1.0, 1.5);
    set_vector(scene->principal, 0.5, 0.2, -0.7);
}

TEST(reference_under_moments)
{
    static const char *const where[2] = {"heavy-top", "pair"};
    for (int k = 0; k < 2; ++k) {
        const double t_end = 2.0;
        struct scene scene;
        struct journey j;
        double *solution;
        asymmetric(where[k], &scene);
        const vti_bodies exact = reference_of(&scene, t_end, &solution);
        begin(&j, &scene, method_of("kl8"), t_end / 1024);
        go(&j, 1024);
        const vti_bodies b = travel_bodies(&j.travel);
        const double turned = attitude_distance(&b, &exact), moved = velocity_distance(&b, &exact);
        print_message("reference of %s: off kl8 by %.3g, Omega and v by %.3g\n", where[k], turned, moved);
        assert_below(turned, 1e-11);
        assert_below(moved, 1e-10);
        end(&j);
        free(solution);
    }
}

/* ---- what rivals are known for ----------------------------------------------------------------------------------- */

/** The motion with that method, the attitude's distance from the reference at the end. */
static double attitude_error(const struct scene *scene, const vti_bodies *exact, const char *name, double h,
                             int64_t steps, struct journey *j)
{
    begin(j, scene, method_of(name), h);
    go(j, steps);
    const vti_bodies b = travel_bodies(&j->travel);
    return attitude_distance(&b, exact);
}

/** EQUATIONS 7.6, two figures each: errors of two free bodies that spin by (0.3, 1.1, -0.4), at h = 0.1 to t = 20. */
TEST(errors_of_free_bodies)
{
    static const double moments[2][3] = {{1, 1.7, 2.3}, {1.7231, 0.0658, 1.7243}};
    static const struct {
        const char *name;
        double error[2];
    } row[] = {
        {"exact", {1.5e-8, 1.7e-9}},
        {"no-squish", {1.3e-2, 6.7e-2}},
        {"lammps-asphere", {2.7e-2, 0.63}},
        {"fincham", {1.4e-2, 0.53}},
        {"yade-aspherical", {2.7, 2.0}},
        {"buss", {1.9e-2, 3.4e-2}},
        {"moser-veselov", {6.8e-2, 5.9e-2}},
        {"moser-veselov-newton", {6.8e-2, 5.9e-2}},
        {"implicit-midpoint", {3.6e-2, 3.8e-2}},
        {"spiral-aspherical", {1.4e-3, 5.4e-3}},
    };
    for (int which = 0; which < 2; ++which) {
        struct scene scene;
        double *solution;
        read_scene("dzhanibekov", &scene);
        set_vector(scene.moments, moments[which][0], moments[which][1], moments[which][2]);
        set_vector(scene.omega, 0.3, 1.1, -0.4);
        const vti_bodies exact = reference_of(&scene, 20.0, &solution);
        for (size_t k = 0; k < sizeof row / sizeof row[0]; ++k) {
            struct journey j;
            const double error = attitude_error(&scene, &exact, row[k].name, 0.1, 200, &j);
            print_message("free body %d: %s errs by %.3g\n", which, row[k].name, error);
            assert_below(fabs(error / row[k].error[which] - 1.0), 0.05);
            end(&j);
        }
        free(solution);
    }
}

/** By halving the step twice, on the tops and the pair without symmetry. */
TEST(orders)
{
    static const char *const where[2] = {"heavy-top", "pair"};
    for (int k = 0; k < 2; ++k) {
        const double t_end = k == 0 ? 4.0 : 1.0;
        struct scene scene;
        double *solution;
        asymmetric(where[k], &scene);
        if (k == 0)
            set_vector(scene.omega, 0.3, -0.5, 0.8);
        const vti_bodies exact = reference_of(&scene, t_end, &solution);
        for (int64_t i = 0; rival_general(i) != NULL; ++i) {
            const vti_stepper *method = &rival_general(i)->stepper;
            double h[4], error[4], floor[4] = {1e-12, 1e-12, 1e-12, 1e-12};
            for (int r = 0; r < 4; ++r) {
                struct journey j;
                const int64_t steps = 512 << r;
                h[r] = t_end / (double)steps;
                error[r] = attitude_error(&scene, &exact, method->name, h[r], steps, &j);
                end(&j);
            }
            const struct order fit = fit_order(h, error, floor, 4);
            print_message("%s: %s order %.3f +- %.3f\n", where[k], method->name, fit.order, fit.interval);
            assert_below(fabs(fit.order - (double)method->order), 0.1);
        }
        free(solution);
    }
}

/** Methods for any differential equation, of a top without symmetry: of order 4, and next to the reference. */
TEST(runge_kutta)
{
    static const char *const fine[] = {"pd8", "dop853", "vern9", "rk8pd", "rk8pd-adaptive", "dop853-adaptive"};
    struct scene scene;
    struct journey j;
    double *solution, h[4], error[4], floor[4] = {1e-12, 1e-12, 1e-12, 1e-12};
    asymmetric("heavy-top", &scene);
    set_vector(scene.omega, 0.3, -0.5, 0.8);
    const vti_bodies exact = reference_of(&scene, 4.0, &solution);
    for (int r = 0; r < 4; ++r) {
        h[r] = 4.0 / (64 << r);
        error[r] = attitude_error(&scene, &exact, "rk4", h[r], 64 << r, &j);
        end(&j);
    }
    const struct order fit = fit_order(h, error, floor, 4);
    print_message("heavy-top: rk4 order %.3f +- %.3f\n", fit.order, fit.interval);
    assert_below(fabs(fit.order - 4.0), 0.1);
    for (size_t k = 0; k < sizeof fine / sizeof fine[0]; ++k) {
        const double off = attitude_error(&scene, &exact, fine[k], 4.0 / 128, 128, &j);
        const vti_bodies b = travel_bodies(&j.travel);
        print_message("heavy-top: %s errs by %.3g\n", fine[k], off);
        assert_below(off, 1e-10);
        double w[3], p[3]; /* L is that of Omega */
        const double omega[3] = {b.omega.c[0][0], b.omega.c[1][0], b.omega.c[2][0]};
        const rotor q = quat_times(quat_unit(attitude_of(&b, 0)), quat_of_alpha(scene.principal));
        quat_rotate(quat_conj(q), omega, w);
        for (int i = 0; i < 3; ++i)
            p[i] = scene.moments[i] * w[i];
        quat_rotate(q, p, p);
        for (int i = 0; i < 3; ++i)
            assert_close(b.spin.c[i][0], p[i], 1e-13);
        end(&j);
    }
    free(solution);
}

/** A sphere's three moments are one, and each of these is a scheme for spheres that is known. */
TEST(of_spheres)
{
    static const char *const same[][2] = {{"no-squish", "yade-exp-verlet"},
                                          {"lammps-asphere", "lammps-richardson"},
                                          {"buss", "yade-exp-verlet"},
                                          {"moser-veselov", "vti1"},
                                          {"moser-veselov-newton", "vti1"},
                                          {"implicit-midpoint", "vti2"},
                                          {"spiral-aspherical", "yade-exp-verlet"}};
    for (size_t k = 0; k < sizeof same / sizeof same[0]; ++k) {
        struct scene scene, sphere;
        struct journey general, other;
        read_scene("pendulum", &sphere);
        scene = sphere;
        set_vector(scene.moments, sphere.inertia, sphere.inertia, sphere.inertia);
        scene.inertia = 0.0;
        begin(&general, &scene, method_of(same[k][0]), 1.0 / 32);
        begin(&other, &sphere, method_of(same[k][1]), 1.0 / 32);
        go(&general, 100);
        go(&other, 100);
        const vti_bodies a = travel_bodies(&general.travel), b = travel_bodies(&other.travel);
        print_message("%s: off %s by %.3g\n", same[k][0], same[k][1], attitude_distance(&a, &b));
        /* five turns about axes are no turn about one: of order 2, and no more */
        assert_below(attitude_distance(&a, &b), k == 0 ? 1e-2 : 1e-12);
        assert_below(velocity_distance(&a, &b), k == 0 ? 1e-2 : 1e-12);
        end(&general);
        end(&other);
    }
}

/** The closed form is Newton's solution; where a body is flat, it is taken from there. */
TEST(closed_form)
{
    static const double moments[3][3] = {{1, 1.7, 2.3}, {0.6, 1, 1.59}, {1, 1.5, 2.5}};
    for (int k = 0; k < 3; ++k) {
        struct scene scene;
        struct journey closed, newton;
        asymmetric("heavy-top", &scene);
        set_vector(scene.moments, moments[k][0], moments[k][1], moments[k][2]);
        set_vector(scene.omega, 0.5, 3.0, -2.0);
        begin(&closed, &scene, method_of("moser-veselov"), 0.1);
        begin(&newton, &scene, method_of("moser-veselov-newton"), 0.1);
        go(&closed, 40);
        go(&newton, 40);
        const vti_bodies a = travel_bodies(&closed.travel), b = travel_bodies(&newton.travel);
        print_message("closed form: off Newton's solution by %.3g\n", attitude_distance(&a, &b));
        assert_below(attitude_distance(&a, &b), k == 2 ? 0.0 : 1e-11);
        end(&closed);
        end(&newton);
    }
}

/** Free bodies: whoever goes by L keeps it to the bit, and those by an equation of a keep the energy to rounding. */
TEST(what_they_keep)
{
    for (int64_t i = 0; rival_general(i) != NULL; ++i) {
        const char *name = rival_general(i)->stepper.name;
        struct scene scene;
        struct journey j;
        read_scene("dzhanibekov", &scene);
        begin(&j, &scene, method_of(name), 0.1);
        const double energy = model_energy(&j.model, &j.model.bodies);
        double L[3], changed = 0.0;
        for (int k = 0; k < 3; ++k)
            L[k] = j.model.bodies.spin.c[k][0];
        go(&j, 500);
        const vti_bodies b = travel_bodies(&j.travel);
        for (int k = 0; k < 3; ++k)
            changed = fmax(changed, fabs(b.spin.c[k][0] - L[k]));
        const double drift = fabs(model_energy(&j.model, &b) / energy - 1.0);
        print_message("%s: L off by %.3g, energy by %.3g\n", name, changed, drift);
        if (strcmp(name, "spiral-aspherical") == 0)
            assert_below(1e-9, changed);
        else
            assert_below(changed, 0.0);
        if (strncmp(name, "moser", 5) == 0 || strcmp(name, "implicit-midpoint") == 0)
            assert_below(drift, 1e-12);
        end(&j);
    }
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

TEST(refused)
{
    struct scene scene;
    struct journey j;
    struct message *said = &j.message;
    read_scene("pendulum", &j.scene);
    make_model(&j.scene, &j.model);
    assert_int_equal(travel_create(&j.travel, method_of("no-squish"), &j.model, 0.1, said), -1);
    assert_non_null(strstr(said->text, "no-squish moves bodies of three moments"));
    model_destroy(&j.model);
    read_scene("heavy-top", &j.scene);
    make_model(&j.scene, &j.model);
    assert_int_equal(travel_create(&j.travel, method_of("mercury"), &j.model, 0.1, said), -1);
    assert_non_null(strstr(said->text, "mercury knows bodies of one moment"));
    model_destroy(&j.model);
    static const char *const implicit[] = {"moser-veselov", "moser-veselov-newton"};
    for (int k = 0; k < 2; ++k) { /* turns by more than these can */
        read_scene("dzhanibekov", &scene);
        set_vector(scene.moments, 1, 1.7, 2.3);
        begin(&j, &scene, method_of(implicit[k]), 3.0);
        assert_int_equal(travel_go(&j.travel, 10, said), -1);
        assert_non_null(strstr(said->text, "body 0 has h|Omega| = "));
        end(&j);
    }
}

/* ---- looks and checkpoints --------------------------------------------------------------------------------------- */

struct keeper {
    int64_t step;
    double *state;
};

static int keep(void *self, int64_t step, double t, const vti_bodies *b)
{
    const struct keeper *keeper = self;
    (void)t;
    if (step == keeper->step)
        state_get(b, keeper->state);
    return 0;
}

/** Whoever looks changes no bit, and what he keeps is what a run goes on from. */
TEST(goes_on)
{
    for (int64_t i = 0; method_general_at(i) != NULL; ++i) {
        const vti_stepper *method = method_general_at(i);
        if (method_rival(method) == NULL)
            continue;
        struct scene scene;
        struct journey whole, looked, second;
        double kept[4][64];
        int64_t count, again;
        asymmetric("pair", &scene);
        begin(&whole, &scene, method, 1.0 / 512);
        begin(&looked, &scene, method, 1.0 / 512);
        begin(&second, &scene, method, 1.0 / 512);
        assert_true(state_size(&whole.model.bodies) <= 64);
        memset(kept, 0, sizeof kept);
        struct keeper keeper = {20, kept[0]};
        const struct observer observer = {keep, &keeper, 1, 1, NULL, NULL};
        assert_int_equal(travel_show(&looked.travel, 20, &observer, 1, &looked.message), 0);
        const double *memory = travel_state(&looked.travel, &count);
        memcpy(travel_state(&second.travel, &again), memory, (size_t)count * sizeof *memory);
        assert_int_equal(count, again);
        state_put(kept[0], &second.model.bodies);
        travel_resume(&second.travel, 20);
        struct journey *const all[] = {&whole, &looked, &second};
        for (int k = 0; k < 3; ++k) {
            struct keeper last = {50, kept[k + 1]};
            const struct observer at_end = {keep, &last, 50, 1, NULL, NULL};
            assert_int_equal(travel_show(&all[k]->travel, k == 0 ? 50 : 30, &at_end, 1, &all[k]->message), 0);
            end(all[k]);
        }
        assert_memory_equal(kept[2], kept[1], sizeof kept[1]);
        assert_memory_equal(kept[3], kept[1], sizeof kept[1]);
    }
}

/** All are listed for those who ask what there is for such bodies, and none for the others. */
TEST(lists)
{
    int64_t n = 0, ours = 0, rivals = 0;
    for (; method_general_at(n) != NULL; ++n) {
        const vti_stepper *method = method_general_at(n);
        ours += vti_stepper_find(method->name) == method;
        rivals += method_rival(method) != NULL && method_rival(method)->general != RIVAL_OF_SPHERES;
        assert_ptr_equal(method_find(method->name), method);
    }
    assert_int_equal(ours + rivals, n);
    assert_int_equal(rivals, 9 + 7); /* and Runge-Kutta */
    assert_null(rival_general(9));
    assert_null(rival_general(-1));
    for (int64_t i = 0; method_at(i) != NULL; ++i)
        assert_true(method_rival(method_at(i)) == NULL || method_rival(method_at(i))->general != RIVAL_OF_MOMENTS);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(free_reference), cmocka_unit_test(reference_under_moments),
                    cmocka_unit_test(errors_of_free_bodies), cmocka_unit_test(orders), cmocka_unit_test(runge_kutta),
                    cmocka_unit_test(of_spheres), cmocka_unit_test(closed_form), cmocka_unit_test(what_they_keep),
                    cmocka_unit_test(refused), cmocka_unit_test(goes_on), cmocka_unit_test(lists))
