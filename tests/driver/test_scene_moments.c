/* SPDX-License-Identifier: BSD-3-Clause
 * Scenes of bodies with three moments, against what one has by hand: angular momenta, Jacobi's elliptic functions of a
 * free body, the turning points of Lagrange's top. The argument is the folder of the shipped scenes. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include "state.h"

static const char *folder;

/** From step first to step last; observers see every step. */
static void go(struct model *model, const char *stepper, double h, int64_t first, int64_t last,
               const struct observer *observer)
{
    struct message message;
    if (loop_run(model, vti_stepper_find(stepper), h, first, last, observer, observer != NULL, &message) != 0)
        fail_msg("%s", message.text);
}

/* ---- what they start from ---------------------------------------------------------------------------------------- */

/** principal [2, 2, 2], a third of a turn about the diagonal, takes x to y, y to z and z to x: the moments about the
 *  body's axes are C, A, B. alpha [0, 0, 2] is a quarter of a turn about z, and makes that A, C, B in space. */
TEST(the_angular_momentum)
{
    static const char *const starts[] = {"", "principal: [2, 2, 2], ", "principal: [2, 2, 2], "};
    static const double alpha[] = {0.0, 0.0, 2.0}, moments[3][3] = {{2, 3, 4}, {4, 2, 3}, {2, 4, 3}};
    for (int k = 0; k < 3; ++k) {
        struct scene scene;
        struct model model;
        char text[256];
        snprintf(text, sizeof text,
                 "bodies: {moments: [2, 3, 4], %schain: {count: 2, spacing: 1}, mass: 1, alpha: [0, 0, %g], omega: [5, "
                 "7, 11], "
                 "random: {seed: 1, omega: 1}}\n" TIME,
                 starts[k], alpha[k]);
        make_model(text, &scene, &model);
        const vti_bodies *b = &model.bodies;
        assert_true(b->inertia.p == NULL);
        double energy = 0.0;
        for (int i = 0; i < 2; ++i)
            for (int c = 0; c < 3; ++c) {
                const double w = b->omega.c[c][i * b->omega.stride];
                assert_true(fabs(w - (c == 0 ? 5 : c == 1 ? 7 : 11)) <= 1.0);
                assert_close(b->spin.c[c][i * b->spin.stride], moments[k][c] * w, 200 * EPS);
                energy += 0.5 * moments[k][c] * w * w;
            }
        assert_close(model_energy(&model, b), energy, 2000 * EPS);
        model_destroy(&model);
    }
}

#define BODY                                                                                                           \
    "bodies: {moments: [1, 2, 3], mass: 1, diameter: 1, x: [0, 0, 2], v: [0, 0, 0], alpha: [0, 0, 0], omega: [0, 0, "  \
    "1]}\n"

/** All that dissipates takes bodies of three moments. */
TEST(what_dissipates_is_taken)
{
    struct scene scene;
    struct model model;
    make_model(BODY "contact: {stiffness: 10}\nwall: {stiffness: 10, planes: [[0, 0, 1, 0]]}\ndashpot: {restitution: "
                    "0.5}\nfriction: {sliding: 0.5, stiffness: 1}\ndrag: {linear: 1, angular: 1}\n" TIME,
               &scene, &model);
    model_destroy(&model);
}

/** A bonded pair that bends, shears, twists and stretches: what its dashpots take is booked. */
TEST(bonds_are_damped)
{
    struct scene scene;
    struct model model;
    struct message message;
    make_model("bodies: {moments: [0.1, 0.2, 0.25], mass: 1, chain: {count: 2, spacing: 1}, random: {seed: 3, v: 0.1, "
               "omega: 0.5}}\nbinder: {axial: 5, moment: 2, shear: {stiffness: 3}}\nbond_dashpot: {zeta: 0.2}\n" TIME,
               &scene, &model);
    const double before = model_energy(&model, &model.bodies);
    assert_int_equal(loop_run(&model, vti_stepper_find("vti2"), 1.0 / 256.0, 0, 2560, NULL, 0, &message), 0);
    const double lost = vti_booked(model.effects, model.effects_count);
    assert_true(lost > 0.1 * before);
    assert_close(model_energy(&model, &model.bodies) + lost, before, 1e-4 * before); /* (h omega)^2 / 24 */
    model_destroy(&model);
}

TEST(tables_have_no_other_inertia)
{
    struct scene scene;
    struct model model;
    struct message message;
    write_text("b.csv", "omega_x,omega_y,omega_z,inertia\n0,0,1,1\n");
    assert_int_equal(try_model("bodies: {table: b.csv, moments: [1, 2, 3]}\n" TIME, &scene, &model, &message), -1);
    assert_string_equal(message.text, "b.csv: gives what the scene gives as bodies.moments too; keep one of them");
    write_text("b.csv", "omega_x,omega_y,omega_z\n4,5,6\n");
    make_model("bodies: {table: b.csv, moments: [1, 2, 3]}\n" TIME, &scene, &model);
    assert_close(model_energy(&model, &model.bodies), 0.5 * (16 + 2 * 25 + 3 * 36), 100 * EPS);
    model_destroy(&model);
}

/** Each body has its own moments and axes; what the table leaves out is the scene's. */
TEST(tables_of_moments)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", "omega_x,omega_y,omega_z,moment_a,moment_b,moment_c,principal_x,principal_y,principal_z\n"
                        "4,5,6,1,2,3,0,0,0\n4,5,6,3,4,5,2,2,2\n");
    make_model("bodies: {table: b.csv}\n" TIME, &scene, &model);
    const double first = 16 + 2 * 25 + 3 * 36, second = 5 * 16 + 3 * 25 + 4 * 36; /* the axes are y, z, x */
    assert_close(model_energy(&model, &model.bodies), 0.5 * (first + second), 200 * EPS);
    assert_close(model.bodies.spin.c[0][3], 20.0, 100 * EPS);
    model_destroy(&model);
    write_text("b.csv", "omega_x,omega_y,omega_z,principal_x,principal_y,principal_z\n4,5,6,2,2,2\n");
    make_model("bodies: {table: b.csv, moments: [3, 4, 5]}\n" TIME, &scene, &model);
    assert_close(model_energy(&model, &model.bodies), 0.5 * second, 200 * EPS);
    model_destroy(&model);
}

TEST(tables_of_moments_refused)
{
    static const struct {
        const char *bodies, *rows, *line;
    } refused[] = {
        {"", "moment_a,moment_b,moment_c\n1,2,3.1\n",
         "b.csv:2: moment_a: one of 1, 2, 3.1 is more than the sum of the others; no body has such moments, give "
         "smaller ones"},
        {"", "moment_a,moment_b,moment_c\n1,2,0\n", "b.csv:2:5: moment_c: '0' is not positive; it must be > 0"},
        {"", "moment_a,moment_b\n1,2\n",
         "b.csv:1: no column moment_c; give moment_a, moment_b and moment_c or none of them"},
        {"", "principal_x,principal_y,principal_z\n1,2,3\n",
         "b.csv: no columns moment_a, moment_b, moment_c, whose axes principal_x, principal_y, principal_z are; give "
         "them, or bodies.moments"},
        {"", "moment_a,moment_b,moment_c,inertia\n1,2,3,1\n",
         "b.csv:1: inertia and moment_a, moment_b, moment_c; bodies have one or three"},
        {", inertia: 1", "moment_a,moment_b,moment_c\n1,2,3\n",
         "b.csv: gives what the scene gives as bodies.inertia too; keep one of them"},
        {", moments: [1, 2, 3]", "moment_a,moment_b,moment_c\n1,2,3\n",
         "b.csv: gives what the scene gives as bodies.moments too; keep one of them"},
        {", moments: [1, 2, 3], principal: [1, 0, 0]", "principal_x,principal_y,principal_z\n1,2,3\n",
         "b.csv: gives what the scene gives as bodies.principal too; keep one of them"}};
    for (size_t k = 0; k < sizeof refused / sizeof refused[0]; ++k) {
        struct scene scene;
        struct model model;
        struct message message;
        char text[128];
        snprintf(text, sizeof text, "bodies: {table: b.csv, omega: [0, 0, 1]%s}\n" TIME, refused[k].bodies);
        write_text("b.csv", refused[k].rows);
        assert_refused(refused[k].rows, try_model(text, &scene, &model, &message), &message, refused[k].line);
    }
}

/* ---- closed forms ------------------------------------------------------------------------------------------------ */

struct flip {
    double rate, k2, at0; /* of the elliptic functions */
    double worst, lowest;
};

/** Omega_y of the body is sn(rate t + K): of the three, dn, sn and cn, it starts at its crest. */
static int see_flip(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct flip *f = self;
    double sn, cn, dn, w[3];
    const double omega[3] = {b->omega.c[0][0], b->omega.c[1][0], b->omega.c[2][0]},
                 alpha[3] = {b->alpha.c[0][0], b->alpha.c[1][0], b->alpha.c[2][0]};
    (void)step;
    assert_int_equal(gsl_sf_elljac_e(f->rate * t + f->at0, f->k2, &sn, &cn, &dn), 0);
    vti_rrv_rotate_back(alpha, omega, w);
    f->worst = fmax(f->worst, fabs(w[1] - sn));
    f->lowest = fmin(f->lowest, w[1]);
    return 0;
}

/** Landau and Lifshitz, Mechanics, section 37, for L^2 < 2 E B, where A and C change places. L keeps its bits. */
static struct flip flips(double h)
{
    struct scene scene;
    struct model model;
    open_scene(folder, "dzhanibekov", &scene, &model);
    const double *m = scene.moments, *w = scene.omega;
    double energy2 = 0.0, square = 0.0;
    for (int k = 0; k < 3; ++k) {
        energy2 += m[k] * w[k] * w[k];
        square += m[k] * w[k] * m[k] * w[k];
    }
    struct flip f = {.worst = 0.0};
    f.rate = sqrt((m[1] - m[0]) * (energy2 * m[2] - square) / (m[0] * m[1] * m[2]));
    f.k2 = (m[2] - m[1]) * (square - energy2 * m[0]) / ((m[1] - m[0]) * (energy2 * m[2] - square));
    f.at0 = gsl_sf_ellint_Kcomp(sqrt(f.k2), GSL_PREC_DOUBLE);
    const struct observer observer = {see_flip, &f, 1, 0, NULL, NULL};
    go(&model, "vti2", h, 0, (int64_t)(21.0 / h), &observer);
    for (int k = 0; k < 3; ++k)
        assert_true(model.bodies.spin.c[k][0] == m[k] * w[k]);
    model_destroy(&model);
    return f;
}

TEST(dzhanibekov)
{
    const struct flip at_h = flips(1.0 / 64), at_half = flips(1.0 / 128);
    print_message("off sn by %.3g, %.3g; lowest %.10g\n", at_h.worst, at_half.worst, at_half.lowest);
    assert_below(at_half.lowest, -0.9999);
    assert_below(at_h.worst, 5e-3);
    assert_below(fabs(at_h.worst / at_half.worst - 4.0), 0.2);
}

struct top {
    double spin, highest, lowest, off;
};

static int see_top(void *self, int64_t step, double t, const vti_bodies *b)
{
    static const double axis0[3] = {0.0, 0.0, -1.0};
    struct top *top = self;
    double axis[3];
    const double alpha[3] = {b->alpha.c[0][0], b->alpha.c[1][0], b->alpha.c[2][0]},
                 L[3] = {b->spin.c[0][0], b->spin.c[1][0], b->spin.c[2][0]};
    (void)step;
    (void)t;
    vti_rrv_rotate(alpha, axis0, axis);
    top->highest = fmax(top->highest, -axis[2]);
    top->lowest = fmin(top->lowest, -axis[2]);
    top->off = fmax(top->off, fabs(vti_dot(L, axis) - top->spin));
    return 0;
}

/** Let go at rest but for its spin S, the top sinks from u0 = cos(60 degrees) to u with S^2/(2 A W) (u0 - u) = 1 - u^2,
 *  and back; S = L.axis stays. Least and greatest of steps are off by what u does within half of one, besides h^2. */
TEST(heavy_top)
{
    struct scene scene;
    struct model model;
    struct top top = {3.0, -1.0, 1.0, 0.0};
    const struct observer observer = {see_top, &top, 1, 0, NULL, NULL};
    open_scene(folder, "heavy-top", &scene, &model);
    go(&model, "vti2", scene.h, 0, (int64_t)(scene.t_end / scene.h), &observer);
    const double a = 9.0 / 2.0, lowest = 0.5 * (a - sqrt(a * a - 4.0 * (0.5 * a - 1.0)));
    print_message("top between %.8g and %.8g, spin off by %.3g\n", top.lowest, top.highest, top.off);
    assert_below(fabs(top.lowest - lowest), 1e-4);
    assert_below(fabs(top.highest - 0.5), 1e-4);
    assert_below(top.off, 1e-12);
    model_destroy(&model);
}

struct band {
    struct model *model;
    double start, worst[10];
    int64_t steps;
};

static int see_band(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct band *band = self;
    const int64_t tenth = step < band->steps ? 10 * step / band->steps : 9;
    (void)t;
    band->worst[tenth] = fmax(band->worst[tenth], fabs(model_energy(band->model, b) / band->start - 1.0));
    return 0;
}

/** Energy after as many steps of explicit Euler, in the body's frame, L' = L x Omega. */
static double energy_of_euler(const struct scene *s, int64_t steps)
{
    double w[3] = {s->omega[0], s->omega[1], s->omega[2]}, energy = 0.0;
    for (int64_t n = 0; n < steps; ++n) {
        const double L[3] = {s->moments[0] * w[0], s->moments[1] * w[1], s->moments[2] * w[2]};
        double rate[3];
        vti_cross(L, w, rate);
        for (int k = 0; k < 3; ++k)
            w[k] += s->h * rate[k] / s->moments[k];
    }
    for (int k = 0; k < 3; ++k)
        energy += 0.5 * s->moments[k] * w[k] * w[k];
    return energy;
}

TEST(slender)
{
    enum { STEPS = 100000 };
    struct scene scene;
    struct model model;
    open_scene(folder, "slender", &scene, &model);
    struct band band = {&model, model_energy(&model, &model.bodies), {0.0}, STEPS};
    const struct observer observer = {see_band, &band, 1, 0, NULL, NULL};
    go(&model, "vti2", scene.h, 0, STEPS, &observer);
    const double euler = energy_of_euler(&scene, 125);
    print_message("slender: energy off by %.3g in the first tenth, %.3g in the last; Euler's %.3g of it\n",
                  band.worst[0], band.worst[9], euler / band.start);
    for (int k = 0; k < 10; ++k) {
        assert_below(band.worst[k], 1e-6);
        assert_below(fabs(band.worst[k] / band.worst[0] - 1.0), 0.02);
    }
    assert_below(2.0 * band.start, euler);
    model_destroy(&model);
}

/* ---- states ------------------------------------------------------------------------------------------------------ */

enum { NUMBERS = 9 };

/** A state is all that a run goes on from; a stepper whose velocities lag is read without a change of its bits. */
TEST(what_a_run_goes_on_from)
{
    for (int k = 0; k < 2; ++k) {
        const char *stepper = k == 0 ? "vti3-leapfrog" : "chin4";
        struct scene scene;
        struct model whole, half;
        double numbers[3][NUMBERS];
        struct band band = {&whole, 18.5, {0.0}, 200};
        const struct observer observer = {see_band, &band, 1, 0, NULL, NULL};
        open_scene(folder, "heavy-top", &scene, &whole);
        assert_int_equal(state_size(&whole.bodies), NUMBERS);
        go(&whole, stepper, scene.h, 0, 100, &observer);
        state_get(&whole.bodies, numbers[0]);
        go(&whole, stepper, scene.h, 100, 200, NULL);
        state_get(&whole.bodies, numbers[1]);
        model_destroy(&whole);
        assert_int_equal(model_create(&scene, &half, &(struct message){""}), 0);
        state_put(numbers[0], &half.bodies);
        band.model = &half;
        go(&half, stepper, scene.h, 100, 200, &observer);
        state_get(&half.bodies, numbers[2]);
        model_destroy(&half);
        assert_memory_equal(numbers[2], numbers[1], sizeof numbers[1]);
        for (int n = 0; n < 10; ++n)
            assert_below(band.worst[n], 1e-7);
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_angular_momentum),
                                       cmocka_unit_test(what_dissipates_is_taken),
                                       cmocka_unit_test(bonds_are_damped),
                                       cmocka_unit_test(tables_have_no_other_inertia),
                                       cmocka_unit_test(tables_of_moments),
                                       cmocka_unit_test(tables_of_moments_refused),
                                       cmocka_unit_test(dzhanibekov),
                                       cmocka_unit_test(heavy_top),
                                       cmocka_unit_test(slender),
                                       cmocka_unit_test(what_a_run_goes_on_from)};
    folder = argc > 1 ? argv[1] : ".";
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
