/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds that are made where bodies touch: which, when, and at rest as they are then; the books, and what a run goes on
 * with. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "binder.h"
#include "shape.h"

#define BONDED "contact: {stiffness: 2000, bonded: yes}\n"
#define STIFF "moment: 20, axial: 600, shear: {stiffness: 300}"
/* three spheres in a row: 0 comes from the left and meets 1, which meets 2 */
#define ROW                                                                                                            \
    "x,y,z,vx,vy,vz,omega_x,omega_y,omega_z,mass,diameter\n"                                                           \
    "0,0,0,2,0.3,0,0.5,1,-2,1,1\n1.2,0.1,0,0,0,0,0,-0.7,0.4,2,1\n2.5,0,0.1,0,0,0.2,0,0,0,1,1.2\n"

static const struct binder_self *binder_of(const struct model *model)
{
    return model->instances[0].self;
}

/** Steps first + 1 to last of vti2. */
static void go(struct model *model, int64_t first, int64_t last)
{
    struct message message;
    if (loop_run(model, model->scene->stepper, model->scene->h, first, last, NULL, 0, &message) != 0)
        fail_msg("%s", message.text);
}

/** The step at whose end the first bond is made. */
static int64_t first_bond(struct model *model)
{
    int64_t step = 0;
    while (binder_of(model)->all == 0 && step < 1000) {
        go(model, step, step + 1);
        ++step;
    }
    assert_int_equal(binder_of(model)->bonds.count, 1);
    return step;
}

/** Made at the end of the first step in which its bodies overlap; it holds nothing then, and both stay together. */
TEST(made_at_rest)
{
    struct scene scene;
    struct model model;
    double measures[VTI_BOND_MEASURES];
    write_text("b.csv", ROW);
    make_model("bodies: {table: b.csv}\nbinder: {when: touching, " STIFF "}\n" BONDED "h: 2^-9\nt_end: 1\n", &scene,
               &model);
    assert_int_equal(shape_lines(&model), 0);
    const int64_t step = first_bond(&model);
    const vti_bonds *bonds = &binder_of(&model)->bonds;
    const double *x = model.bodies.x.c[0], r = hypot(hypot(x[0] - x[3], x[1] - x[4]), x[2] - x[5]);
    assert_true(bonds->pair[0] == 0 && bonds->pair[1] == 1);
    assert_true(r < 1 && r > 1 - 2.1 * scene.h); /* it was apart a step ago */
    assert_close(bonds->rest[3], r, 4 * EPS);
    assert_int_equal(vti_bonds_measure(bonds, &model.bodies, 0, 1, measures), VTI_OK);
    assert_below(measures[VTI_BOND_ENERGY], 600 * pow(16 * EPS, 2));
    assert_below(measures[VTI_BOND_BENDING] + measures[VTI_BOND_TORSION], 20 * 32 * EPS);
    assert_int_equal(vti_bonds_check(bonds, 3, NULL), VTI_OK);
    go(&model, step, 512);
    assert_int_equal(binder_of(&model)->all, 2); /* each pair once */
    assert_true(bonds->pair[2] == 1 && bonds->pair[3] == 2);
    for (int64_t k = 0; k < 2; ++k) {
        assert_int_equal(vti_bonds_measure(bonds, &model.bodies, k, k + 1, measures), VTI_OK);
        assert_below(fabs(measures[VTI_BOND_STRETCH]), 0.25);
    }
    model_destroy(&model);
}

/** The energy of the motion, springs and contacts at t = 1/2, with bonds and rupture booked. */
static double energy_at_end(const char *h, const char *breaks, int64_t *holding)
{
    struct scene scene;
    struct model model;
    char text[512];
    write_text("b.csv", ROW);
    snprintf(text, sizeof text,
             "bodies: {table: b.csv}\nbinder: {when: touching, " STIFF "%s}\n" BONDED "h: %s\nt_end: 0.5\n", breaks, h);
    make_model(text, &scene, &model);
    go(&model, 0, loop_steps(scene.t_end, scene.h));
    const double energy = model_energy(&model, &model.bodies) + vti_booked(model.effects, model.effects_count);
    *holding = binder_of(&model)->bonds.count;
    model_destroy(&model);
    return energy;
}

/** The books close with the square of the step, bonds that are made and that break included: a fourth at half of it. */
TEST(books_close)
{
    const double start = 0.5 * (4 + 0.09) + 0.5 * 0.04 + 0.05 * (0.25 + 1 + 4) + 0.1 * (0.49 + 0.16);
    const char *const breaks[] = {"", ", break: {stretch: 0.03, bending: 0.5}"};
    for (int k = 0; k < 2; ++k) {
        int64_t holding;
        const double coarse = energy_at_end("2^-9", breaks[k], &holding) - start;
        const double fine = energy_at_end("2^-11", breaks[k], &holding) - start;
        print_message("%g %g %ld\n", coarse, fine, (long)holding);
        assert_true(holding == 2 || k == 1);
        assert_below(fabs(fine), 2e-4);
        assert_below(fabs(fine), fabs(coarse) / 6); /* 1/16 of a smooth swing */
    }
}

/** No body has more bonds than it may. */
TEST(most_of_a_body)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", ROW);
    make_model("bodies: {table: b.csv}\nbinder: {when: touching, most: 1, " STIFF "}\n" BONDED "h: 2^-9\nt_end: 1\n",
               &scene, &model);
    go(&model, 0, 512);
    assert_int_equal(binder_of(&model)->all, 1);
    model_destroy(&model);
}

/** Bonds of the row after 400 steps by h = 0.002 and the step of the first, 401 where there is none. */
static int64_t bonds_within(const char *window, int64_t *first)
{
    struct scene scene;
    struct model model;
    char text[512];
    write_text("b.csv", ROW);
    snprintf(text, sizeof text,
             "bodies: {table: b.csv}\nbinder: {when: touching%s, " STIFF "}\n" BONDED "h: 0.002\nt_end: 0.8\n", window);
    make_model(text, &scene, &model);
    for (int64_t step = 0; step < 400; ++step)
        go(&model, step, step + 1);
    const int64_t all = binder_of(&model)->all;
    *first = all > 0 ? (int64_t)binder_of(&model)->breaking.made[0] : 401;
    model_destroy(&model);
    return all;
}

/** At the ends of the steps from one time to another, both of them included, and not before or after. */
TEST(window_of_time)
{
    int64_t first, then;
    char window[64];
    const int64_t all = bonds_within("", &first);
    assert_true(all == 2 && first > 10 && first < 300);
    for (int64_t later = 0; later < 4; ++later) { /* while they are in touch */
        snprintf(window, sizeof window, ", from: %.3f", 0.002 * (double)(first + later));
        assert_int_equal(bonds_within(window, &then), 2);
        assert_int_equal(then, first + later);
    }
    snprintf(window, sizeof window, ", until: %.3f", 0.002 * (double)first);
    assert_int_equal(bonds_within(window, &then), 1);
    snprintf(window, sizeof window, ", until: %.4f", 0.002 * (double)first - 0.001);
    assert_int_equal(bonds_within(window, &then), 0);
}

#define CROWD                                                                                                          \
    "bodies: {lattice: {counts: [3, 3, 4], spacing: 1.1}, mass: 1, diameter: 1, random: {seed: 3, v: 2, omega: 1}}\n"  \
    "binder: {when: touching, " STIFF ", break: {stretch: 0.04, bending: 3}}\n" BONDED                                 \
    "bond_dashpot: {zeta: 0.1}\nh: 2^-8\nt_end: 1\n"

/** What a run keeps brings another model to the same bits, and it goes on so; pieces of it are refused. */
TEST(goes_on_with_the_same_bits)
{
    struct scene scene;
    struct model model, other;
    make_model(CROWD, &scene, &model);
    make_model(CROWD, &scene, &other);
    go(&model, 0, 160);
    const struct binder_self *self = binder_of(&model);
    print_message("%ld bonds, %ld hold\n", (long)self->all, (long)self->bonds.count);
    assert_true(self->bonds.count > 5 && self->all > self->bonds.count + 5);
    for (int64_t k = 1; k < self->bonds.count; ++k)
        assert_true(self->breaking.id[k] > self->breaking.id[k - 1]);
    const int64_t size = model_memory_size(&model), n = 3 * model.bodies.count;
    double *memory = malloc((size_t)size * sizeof *memory);
    assert_non_null(memory);
    const struct effect *const kept = &model.instances[0];
    const int64_t own = kept->kind->memory->size(kept); /* without those of other effects behind them */
    kept->kind->memory->get(kept, memory);
    assert_int_equal(kept->kind->memory->put(&other.instances[0], memory, own - 1), -1);
    assert_int_equal(kept->kind->memory->put(&other.instances[0], memory, own), own);
    model_memory_get(&model, memory);
    const vti_view *const from[] = {&model.bodies.x, &model.bodies.v, &model.bodies.alpha, &model.bodies.omega};
    const vti_view *const to[] = {&other.bodies.x, &other.bodies.v, &other.bodies.alpha, &other.bodies.omega};
    for (int k = 0; k < 4; ++k)
        memcpy(to[k]->c[0], from[k]->c[0], (size_t)n * sizeof *memory);
    assert_int_equal(model_memory_put(&other, memory, size - 1), -1);
    assert_int_equal(model_memory_put(&other, memory, size), 0);
    free(memory);
    assert_int_equal(binder_of(&other)->bonds.count, self->bonds.count);
    go(&model, 160, 256);
    go(&other, 160, 256);
    assert_int_equal(binder_of(&other)->all, self->all);
    for (int k = 0; k < 4; ++k)
        assert_same_bits(to[k]->c[0], from[k]->c[0], n);
    model_destroy(&other);
    model_destroy(&model);
}

/** What files say of a step long ago is what was so then: bonds that hold, their energies, and fragments. */
TEST(lines_as_they_were)
{
    enum { BODIES = 36, ROOM = 200 };
    static double value[3][ROOM], fragment[BODIES], then[BODIES];
    double *const rows[3] = {value[0], value[1], value[2]};
    struct scene scene;
    struct model model;
    double counts[2];
    make_model(CROWD, &scene, &model);
    struct effect *e = &model.instances[0];
    go(&model, 0, 100);
    e->kind->breaks->count(e, counts);
    e->kind->breaks->fragments(e, 100, then);
    go(&model, 100, 256);
    const int64_t all = e->kind->lines->count(e);
    assert_true(all > (int64_t)counts[0] && all <= ROOM);
    assert_int_equal(e->kind->lines->told(e), 3);
    assert_int_equal(e->kind->lines->values(e, &model.bodies, 100, rows), VTI_OK);
    double holding = 0;
    for (int64_t m = 0; m < all; ++m) {
        int64_t pair[2];
        e->kind->lines->ends(e, m, pair);
        assert_true(pair[0] >= 0 && pair[0] < pair[1] && pair[1] < BODIES);
        assert_true(value[2][m] != 0 || (value[0][m] == 0 && value[1][m] == 0));
        holding += value[2][m];
    }
    assert_true(holding == counts[0] && holding > 0);
    e->kind->breaks->fragments(e, 100, fragment);
    double first = 0;
    for (int i = 0; i < BODIES; ++i) {
        assert_true(fragment[i] == then[i]);
        first += fragment[i] == i;
    }
    assert_true(first == counts[1]);
    model_destroy(&model);
}

/** A pair whose bond has broken gets no other one, though its bodies still touch. */
TEST(once_for_each_pair)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", ROW);
    make_model("bodies: {table: b.csv}\nbinder: {when: touching, axial: 600, break: {energy: 1e-3}}\n" BONDED
               "h: 2^-9\nt_end: 1\n",
               &scene, &model);
    go(&model, 0, 512);
    assert_int_equal(binder_of(&model)->all, 2);
    assert_int_equal(binder_of(&model)->bonds.count, 0);
    model_destroy(&model);
}

RUN_TESTS(cmocka_unit_test(made_at_rest), cmocka_unit_test(books_close), cmocka_unit_test(most_of_a_body),
          cmocka_unit_test(window_of_time), cmocka_unit_test(goes_on_with_the_same_bits),
          cmocka_unit_test(lines_as_they_were), cmocka_unit_test(once_for_each_pair))
