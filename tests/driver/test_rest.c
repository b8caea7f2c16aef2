/* SPDX-License-Identifier: BSD-3-Clause
 * The heap of the scenes (their folder is the argument) comes to rest and stays: its kinetic energy falls below 1e-12
 * of what it began with, and of what it had at most, and is never above that again. */
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

TEST(the_heap_rests)
{
    char path[1024];
    struct scene scene;
    struct model model;
    struct message message;
    snprintf(path, sizeof path, "%s/heap.yaml", folder);
    if (scene_read(path, NULL, 0, &scene, &message) != 0 || model_create(&scene, &model, &message) != 0)
        fail_msg("%s", message.text);
    struct watch w = {.model = &model, .rest_from = scene.t_end};
    w.start = vti_kinetic_translation(&model.bodies) + vti_kinetic_rotation(&model.bodies);
    w.total = model_energy(&model, &model.bodies);
    const struct observer observer = {see, &w, 16, 0};
    const int64_t steps = (int64_t)(1.5 * scene.t_end / scene.h + 0.5);
    assert_int_equal(loop_run(&model, scene.stepper, scene.h, 0, steps, &observer, 1, &message), 0);
    print_message(
        "kinetic energy %.3g at the start, %.3g at most, %.3g from t = %g on; the sum changes by %.2g of %.4g\n",
        w.start, w.most, w.late, w.rest_from, w.ledger, w.total);
    assert_below(w.late, 1e-12 * fmin(w.start, w.most));
    assert_below(w.ledger, 2e-3 * w.total);
    model_destroy(&model);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_heap_rests)};
    folder = argc > 1 ? argv[1] : ".";
    return cmocka_run_group_tests(tests, NULL, NULL);
}
