/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The same hard cases for what people use instead: test_rivals SCENES. Nothing is asserted of rivals but that what they
 * do is what the page says they do; ours stand beside them. */
#include "rivals/journey.h"

#include "hard.h"

enum { SAMPLES = 10000 };

static struct journey j;

/** Steps of its own choice, about which h says little, and rivals of high order: rk8pd stands for these. */
static int is_left_out(const vti_stepper *method)
{
    const int is_adaptive = strcmp(method->name, "rk8pd-adaptive") == 0, is_rk8pd = strcmp(method->name, "rk8pd") == 0;
    return is_adaptive || (method_rival(method) != NULL && method->order > 4 && !is_rk8pd);
}

/** The next method. */
static const vti_stepper *method_of_steps(int64_t *k)
{
    const vti_stepper *method = method_at((*k)++);
    while (method != NULL && is_left_out(method))
        method = method_at((*k)++);
    return method;
}

/** What a method says, without its name and time. */
static const char *reason(void)
{
    const char *const begins[] = {": body ", ": its "};
    const char *text = NULL;
    for (int k = 0; k < 2 && text == NULL; ++k)
        text = strstr(j.message.text, begins[k]);
    return text != NULL ? text + 2 : j.message.text;
}

/** The angle of one step of a free spin from R = I, in (-pi, pi], or NaN with the reason in j.message. */
static double angle_of(const struct scene *scene, const vti_stepper *method, double h, int64_t steps)
{
    double angle = NAN;
    j.scene = *scene;
    make_model(&j.scene, &j.model);
    set_out(&j, method, h);
    if (travel_go(&j.travel, steps, &j.message) == 0) {
        const vti_bodies b = travel_bodies(&j.travel);
        const rotor q = attitude_of(&b, 0);
        const double axis[3] = {0.6, 0, 0.8};
        const long double along = q.x * axis[0] + q.z * axis[2];
        angle = (double)remainderl(2 * atan2l(along, q.w), 2 * PI_L);
    }
    travel_destroy(&j.travel);
    model_destroy(&j.model);
    return angle;
}

TEST(free_spin)
{
    const vti_stepper *method;
    struct scene scene;
    read_scene("spin", &scene);
    const double turns[] = {0.99, 1, 1.01, 10};
    for (int i = 0; i < 4; ++i)
        for (int64_t k = 0; (method = method_of_steps(&k)) != NULL;) {
            const double angle = angle_of(&scene, method, turns[i], 1);
            char what[64];
            snprintf(what, sizeof what, "free spin, h|Omega| = %g: angle of a step", turns[i]);
            if (isnan(angle))
                robust(what, method->name, "reported: %s", reason());
            else
                robust(what, method->name, "%.3f", angle);
        }
}

/** 400 steps of 0.01: past pi. */
TEST(through_pi)
{
    const vti_stepper *method;
    struct scene scene;
    read_scene("spin", &scene);
    for (int64_t k = 0; (method = method_of_steps(&k)) != NULL;) {
        const double off = fabs(remainder(angle_of(&scene, method, 0.01, 400) - 4, 2 * PI));
        const char *const size = off < 1e-12 ? "to 1e-12" : off < 1e-6 ? "to 1e-6" : off < 1e-3 ? "to 1e-3" : NULL;
        robust("400 steps of 0.01 rad, through pi", method->name,
               size != NULL ? "goes on, %s" : "is off by more than 1e-3", size);
    }
}

/** Averages of E over the first and the last 1e4 of 1e5 steps, which the band of VTI-3 leaves uncertain
 *  by 1e-5. */
TEST(pendulum)
{
    const vti_stepper *method;
    struct scene scene;
    read_scene("pendulum", &scene);
    for (int64_t k = 0; (method = method_of_steps(&k)) != NULL;) {
        double e[2] = {0, 0};
        int over = 0;
        begin(&j, &scene, method, 1.0 / 16);
        for (int part = 0; part < 3 && !over; ++part)
            for (int i = 0; i < (part == 1 ? 1 : SAMPLES) && !over; ++i) {
                over = travel_go(&j.travel, part == 1 ? 100000 - 2 * SAMPLES : 1, &j.message) != 0;
                const vti_bodies b = travel_bodies(&j.travel);
                if (part != 1 && !over)
                    e[part / 2] += vti_energy(j.model.effects, j.model.effects_count, &b) / SAMPLES;
            }
        end(&j);
        const double change = e[1] - e[0], size = fabs(change);
        const char *const sign = change < 0 ? "loses" : "gains";
        if (over)
            robust("pendulum, 1e5 steps of h = 1/16: mean energy", method->name, "reported: %s", reason());
        else if (size < 5e-5)
            robust("pendulum, 1e5 steps of h = 1/16: mean energy", method->name, "stays within 5e-5");
        else
            robust("pendulum, 1e5 steps of h = 1/16: mean energy", method->name, "%s %.1g", sign, size);
        if (method_rival(method) == NULL && method->reversible)
            assert_below(size, 5e-5);
    }
}

/** A chain of two with a moment only: 2000 steps at a share of 2/omega, whatever the method's own reach. */
TEST(torsion)
{
    const vti_stepper *method;
    struct scene scene;
    read_scene("chain", &scene);
    scene.chain.count = 2;
    scene.random.v = scene.random.omega = 0;
    scene.has_v = 0;
    scene.has_alpha = 0;
    *number_setting(&scene, "binder.axial") = *number_setting(&scene, "binder.shear.stiffness") = 0;
    for (int s = 0; s < 2; ++s)
        for (int64_t k = 0; (method = method_of_steps(&k)) != NULL;) {
            struct message message;
            const vti_deformation rest = {0, 0, 0};
            vti_stable limit;
            j.scene = scene;
            make_model(&j.scene, &j.model);
            assert_int_equal(model_stable_step(&j.model, &j.model.bodies, &rest, &limit, &message), 0);
            double *const w = j.model.bodies.omega.c[0];
            memset(w, 0, 6 * sizeof *w);
            w[2] = 1e-6;
            w[5] = -1e-6;
            set_out(&j, method, (s ? 1.1 : 0.9) * limit.h);
            int over = 0;
            double size = 0;
            for (int i = 0; i < 2000 && !over; ++i) {
                over = travel_go(&j.travel, 1, &j.message) != 0;
                const vti_bodies b = travel_bodies(&j.travel);
                size = over ? size : fmax(size, vti_max_turn(1, &b));
            }
            end(&j);
            char what[64];
            snprintf(what, sizeof what, "torsion by 1e-6 rad, h = %.1f of 2/omega", s ? 1.1 : 0.9);
            /* how far it is beyond the bound when that is seen depends on the last digits: what is said after that */
            const char *const remedy = strstr(reason(), "; "), *const said = reason()[0] == 'b' ? remedy + 2 : reason();
            robust(what, method->name,
                   over          ? "unbounded, then reported: %s"
                   : size < 1e-3 ? "bounded"
                                 : "unbounded",
                   said);
            if (method_rival(method) == NULL && s == 0 && method->reach > 0.9 * 2)
                assert_below(size, 1e-3);
        }
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(free_spin), cmocka_unit_test(through_pi), cmocka_unit_test(pendulum),
                    cmocka_unit_test(torsion))
