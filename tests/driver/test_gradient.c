/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Forces of scenes are minus the derivatives of their energies by the positions: a case for each effect that has both
 * and takes no energy out of the motion. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#define CHAIN "bodies: {mass: 2, diameter: 1.25, chain: {count: 4, spacing: 1, start: [0.25, 0.5, 0.375]}"

/* What each is called for by, and a distance that all bodies have from where the energy, or a derivative of it, has a
 * jump. */
static const struct {
    const char *effect, *scene;
    double distance;
} cases[] = {
    {"binder", CHAIN "}\nbinder: {axial: 3, moment: 2, shear: {stiffness: 5}}\n", 0.5},
    {"contact", CHAIN "}\ncontact: {stiffness: 7}\n", 0.125},
    {"wall", CHAIN "}\nwall: {stiffness: 7, planes: [[0, 0, 1, 0]]}\n", 0.125},
    {"gravity", CHAIN "}\ngravity: [1, 2, -3]\n", 1.0},
};

/** The energy with a coordinate moved by t; *moved is by how much. */
static double moved_energy(struct model *model, double *x, double t, double *moved)
{
    const double kept = *x;
    *x += t;
    *moved = *x - kept;
    const double energy = model_energy(model, &model->bodies);
    *x = kept;
    return energy;
}

/** (4 D(t/2) - D(t))/3 of the central differences D. */
static double slope(struct model *model, double *x, double t)
{
    double d[2];
    for (int half = 0; half < 2; ++half, t /= 2) {
        double up, down;
        const double high = moved_energy(model, x, t, &up), low = moved_energy(model, x, -t, &down);
        d[half] = (high - low) / (up - down);
    }
    return (4 * d[1] - d[0]) / 3;
}

/* As in tests/effects/test_bond_gradient.c: by steps of tau times the distance s it errs by tau^4/4 U/s from where it
 * is cut off, and by 48 eps U/(tau s) from rounding. */
TEST(forces_are_minus_the_gradient)
{
    const double tau = pow(200 * EPS, 0.2);
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        char text[512];
        struct scene scene;
        struct model model;
        snprintf(text, sizeof text, "%s" TIME, cases[k].scene);
        make_model(text, &scene, &model);
        const vti_bodies *b = &model.bodies;
        for (int64_t i = 0; i < b->count; ++i) /* out of the line, and off the symmetric places */
            for (int c = 0; c < 3; ++c)
                b->x.c[c][i * b->x.stride] += (double)((7 * i + 5 * c) % 11 - 5) / 128;
        assert_int_equal(model_forces(&model, b), VTI_OK);
        const double s = cases[k].distance, size = 2 * fabs(model_energy(&model, b)) + 1;
        double largest = 0;
        for (int64_t i = 0; i < b->count; ++i)
            for (int c = 0; c < 3; ++c) {
                const double force = b->force.c[c][i * b->force.stride];
                assert_close(force, -slope(&model, &b->x.c[c][i * b->x.stride], tau * s),
                             size / s * (pow(tau, 4) / 4 + 48 * EPS / tau));
                largest = fmax(largest, fabs(force));
            }
        assert_true(largest > 0.01); /* there is something to compare */
        model_destroy(&model);
    }
}

/** Whoever adds an effect adds a case. */
TEST(no_effect_is_left_out)
{
    static union effect_settings settings;
    kinds_defaults(&settings);
    for (int k = 0; kinds_at(k) != NULL; ++k) {
        const vti_effect draft = kinds_draft(kinds_at(k), &settings, NULL);
        int found = draft.dissipates || draft.apply == NULL || draft.gives == EFFECT_MOMENT;
        for (size_t c = 0; c < sizeof cases / sizeof cases[0]; ++c)
            found = found || strcmp(cases[c].effect, kinds_at(k)->key) == 0;
        if (!found)
            fail_msg("there is no case of %s", kinds_at(k)->key);
    }
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(forces_are_minus_the_gradient), cmocka_unit_test(no_effect_is_left_out))
