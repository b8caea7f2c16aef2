/* SPDX-License-Identifier: BSD-3-Clause
 * Any bytes as a scene file: refused with one line, or a scene of which a model can be made and stepped. */
#include "fuzz.h"

#include "loop.h"
#include "model.h"
#include "table.h"

enum { BODIES = 300, STEPS = 3 };

/** A few steps, too: numbers that are read must be fit to compute with. Whether they blow up is another question. */
static void step(const struct scene *scene)
{
    struct model model;
    struct message message = {""};
    if (model_create(scene, &model, &message) != 0) {
        fuzz_one_line(&message);
        return;
    }
    fuzz_must(model.bodies.count == scene_bodies(scene), "a model has the scene's bodies");
    (void)model_energy(&model, &model.bodies);
    if (loop_run(&model, scene->stepper, scene->h, 0, STEPS, NULL, 0, &message) != 0)
        fuzz_one_line(&message);
    model_destroy(&model);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct scene scene;
    struct message message = {""};
    const char *path = fuzz_file("scene.yaml", data, size);
    if (scene_read(path, NULL, 0, &scene, &message) != 0) {
        fuzz_one_line(&message);
        return 0;
    }
    fuzz_must(scene.h > 0.0 && scene.t_end > 0.0 && isfinite(scene.t_end / scene.h), "times are positive");
    fuzz_must(scene.stepper != NULL && scene.name[0] != '\0', "a scene has a stepper and a name");
    int tables = 0;
    for (int k = 0; k < TABLES; ++k)
        tables += tables_path(&scene, k)[0] != '\0';
    if (tables == 0 && scene_bodies(&scene) <= BODIES)
        step(&scene);
    return 0;
}
