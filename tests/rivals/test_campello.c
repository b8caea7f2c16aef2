/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Campello's map as printed, with phi = 0, 1/2 and 1: orders and dissipation, as docs/paper.md has them (E17). */
#include "journey.h"

#include "fit.h"

static const char *page; /* docs/paper.md */

static const char *const names[] = {"campello-0", "campello", "campello-1"};
static const double phi[] = {0.0, 0.5, 1.0};
enum { PHIS = 3, RUNGS = 5 };

/* ---- order ------------------------------------------------------------------------------------------------------- */

/** Orders in attitude and velocity on the paper's pendulum at t = 10. */
static void orders(const vti_stepper *method, double *attitude, double *velocity)
{
    struct scene scene;
    double *state, h[RUNGS], error[2][RUNGS], floor[RUNGS];
    read_scene("pendulum", &scene);
    const vti_bodies exact = reference_of(&scene, 10.0, &state);
    for (int k = 0; k < RUNGS; ++k) {
        struct journey j;
        const int64_t steps = (int64_t)1280 << k;
        h[k] = 10.0 / (double)steps;
        floor[k] = 1e-13;
        begin(&j, &scene, method, h[k]);
        go(&j, steps);
        const vti_bodies b = travel_bodies(&j.travel);
        error[0][k] = attitude_distance(&b, &exact);
        error[1][k] = velocity_distance(&b, &exact);
        end(&j);
    }
    *attitude = fit_order(h, error[0], floor, RUNGS).order;
    *velocity = fit_order(h, error[1], floor, RUNGS).order;
    free(state);
}

/* ---- dissipation ------------------------------------------------------------------------------------------------- */

/** Tilt and its rate of a pendulum that hangs, omega = 1, after so many steps from (tilt, rate). */
static void swing(const vti_stepper *method, double h, int64_t steps, double *tilt, double *rate)
{
    struct scene scene;
    struct journey j;
    read_scene("pendulum", &scene);
    scene.alpha[0] = scene.alpha[2] = scene.omega[0] = scene.omega[2] = 0.0;
    scene.alpha[1] = *tilt;
    scene.omega[1] = *rate;
    begin(&j, &scene, method, h);
    go(&j, steps);
    const vti_bodies b = travel_bodies(&j.travel);
    const rotor q = attitude_of(&b, 0);
    *tilt = (double)(2 * q.y / q.w);
    *rate = b.omega.c[1][0];
    end(&j);
}

/** What a step multiplies areas of (tilt, rate) by: two motions' area after steps, of swings of 1e-4. */
static double area_per_step(const vti_stepper *method, double h)
{
    enum { STEPS = 64 };
    const double small = 1e-4;
    double a[2] = {small, 0.0}, b[2] = {0.0, small};
    swing(method, h, STEPS, &a[0], &a[1]);
    swing(method, h, STEPS, &b[0], &b[1]);
    return pow((a[0] * b[1] - a[1] * b[0]) / (small * small), 1.0 / STEPS);
}

/** Energy of the paper's pendulum at t = 100 with h = 1/64; 0.7471 at t = 0, -1 at the bottom. */
static double energy_late(const vti_stepper *method)
{
    struct scene scene;
    struct journey j;
    read_scene("pendulum", &scene);
    begin(&j, &scene, method, 1.0 / 64);
    go(&j, 6400);
    const vti_bodies b = travel_bodies(&j.travel);
    const double energy = vti_energy(j.model.effects, j.model.effects_count, &b);
    end(&j);
    return energy;
}

/* ---- the tests --------------------------------------------------------------------------------------------------- */

static int is_in_page(const char *row)
{
    char line[4096];
    int found = 0;
    FILE *file = fopen(page, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file) != NULL)
        found = found || strncmp(line, row, strlen(row)) == 0;
    fclose(file);
    return found;
}

/** x+ = x + h v+ and v+ = v - h omega^2 [phi x + (1 - phi) x+] has the determinant 1/(1 + (1 - phi)(h omega)^2);
 *  swings of 1e-4 are linear to 1e-8. */
TEST(order_and_dissipation)
{
    const double h = 1.0 / 16;
    int missing = 0;
    for (int k = 0; k < PHIS; ++k) {
        const vti_stepper *method = method_of(names[k]);
        double attitude, velocity;
        char row[256];
        orders(method, &attitude, &velocity);
        const double area = area_per_step(method, h), energy = energy_late(method);
        snprintf(row, sizeof row, "| %g | %.2f | %.2f | %.5f | %.3f |", phi[k], attitude, velocity, area, energy);
        print_message("%s\n", row);
        assert_close(attitude, 1.0, 0.1);
        assert_close(velocity, 1.0, 0.1);
        assert_close(area, 1.0 / (1.0 + (1.0 - phi[k]) * h * h), 1e-8);
        missing += !is_in_page(row);
    }
    if (missing > 0)
        fail_msg("%s does not have %d of these rows", page, missing);
}

/** phi = 1 is explicit: v+ = v + h F/m, then x+ = x + h v+, as VTI-3. */
TEST(phi_1_is_vti3)
{
    static const char *const where[] = {"pendulum", "chain"};
    for (int k = 0; k < 2; ++k) {
        struct scene scene;
        struct journey j[2];
        read_scene(where[k], &scene);
        for (int m = 0; m < 2; ++m) {
            begin(&j[m], &scene, method_of(m == 0 ? "campello-1" : "vti3"), 1.0 / 256);
            go(&j[m], 256);
        }
        const vti_bodies a = travel_bodies(&j[0].travel), b = travel_bodies(&j[1].travel);
        assert_below(attitude_distance(&a, &b), 256 * 8 * EPS);
        assert_below(velocity_distance(&a, &b), 256 * 64 * EPS);
        end(&j[0]);
        end(&j[1]);
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(order_and_dissipation), cmocka_unit_test(phi_1_is_vti3)};
    assert_int_equal(argc, 3);
    scenes = argv[1];
    page = argv[2];
    return cmocka_run_group_tests(tests, NULL, NULL);
}
