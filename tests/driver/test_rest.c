/* SPDX-License-Identifier: BSD-3-Clause
 * The heap and the tetrapods of the scenes (their folder is the argument) come to rest and stay: their kinetic energy
 * falls below a share of what it began with, and of what it had at most, and is never above that again. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

static const char *folder;

struct watch {
    double start, most, late, ledger; /* kinetic at the start, at most, at most since rest; largest change of the sum */
    struct model *model;
    double total, rest_from;
};

static int see(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct watch *w = self;
    const double kinetic = vti_kinetic_translation(b) + vti_kinetic_rotation(b);
    const double total = model_energy(w->model, b) + vti_booked(w->model->effects, w->model->effects_count);
    (void)step;
    w->most = fmax(w->most, kinetic);
    w->ledger = fmax(w->ledger, fabs(total - w->total));
    if (t >= w->rest_from)
        w->late = fmax(w->late, kinetic);
    return 0;
}

/** From rest_from to the end, both in units of the scene's t_end; ledger is a share of the energy. */
static void assert_rests(const char *name, double rest_from, double end, double share, double ledger)
{
    char path[1024];
    struct scene scene;
    struct model model;
    struct message message;
    snprintf(path, sizeof path, "%s/%s.yaml", folder, name);
    if (scene_read(path, NULL, 0, &scene, &message) != 0 || model_create(&scene, &model, &message) != 0)
        fail_msg("%s", message.text);
    struct watch w = {.model = &model, .rest_from = rest_from * scene.t_end};
    w.start = vti_kinetic_translation(&model.bodies) + vti_kinetic_rotation(&model.bodies);
    w.total = model_energy(&model, &model.bodies);
    const struct observer observer = {see, &w, 16, 0, NULL, NULL};
    const int64_t steps = (int64_t)(end * scene.t_end / scene.h + 0.5);
    assert_int_equal(loop_run(&model, scene.stepper, scene.h, 0, steps, &observer, 1, &message), 0);
    print_message(
        "kinetic energy %.3g at the start, %.3g at most, %.3g from t = %g on; the sum changes by %.2g of %.4g\n",
        w.start, w.most, w.late, w.rest_from, w.ledger, w.total);
    assert_below(w.late, share * fmin(w.start, w.most));
    assert_below(w.ledger, ledger * w.total);
    model_destroy(&model);
}

TEST(the_heap_rests)
{
    assert_rests("heap", 7.0 / 6.0, 1.5, 1e-12, 2e-3); /* from t = 14 to 18 */
}

TEST(tetrapods_rest)
{
    assert_rests("clump-pile", 0.875, 1.0, 1e-7, 2.4e-4); /* twice what the ledger changes by */
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_heap_rests), cmocka_unit_test(tetrapods_rest)};
    folder = argc > 1 ? argv[1] : ".";
    return cmocka_run_group_tests(tests, NULL, NULL);
}
