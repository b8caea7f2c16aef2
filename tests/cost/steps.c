/* SPDX-License-Identifier: BSD-3-Clause
 * So many steps of a method over a scene and nothing else, for callgrind.      steps SCENE METHOD H STEPS; without
 * arguments: the names of all methods */
#include <stdio.h>
#include <stdlib.h>

#include "travel.h"

static int go(const char *path, const char *name, double h, int64_t steps, struct message *message)
{
    static struct scene scene;
    static struct model model;
    struct travel travel;
    const vti_stepper *method = method_find(name);
    if (method == NULL)
        return message_set(message, "%s: is not a method", name);
    if (scene_read(path, NULL, 0, &scene, message) != 0 || model_create(&scene, &model, message) != 0)
        return -1;
    int failed = travel_create(&travel, method, &model, h, message);
    if (failed == 0) {
        failed = travel_go(&travel, steps, message);
        travel_destroy(&travel);
    }
    model_destroy(&model);
    return failed;
}

int main(int argc, char **argv)
{
    struct message message = {""};
    for (int64_t i = 0; argc == 1 && i < method_count(); ++i)
        puts(method_at(i)->name);
    if (argc != 1 && argc != 5)
        return EXIT_FAILURE;
    if (argc == 5 && go(argv[1], argv[2], strtod(argv[3], NULL), strtoll(argv[4], NULL, 10), &message) != 0) {
        fprintf(stderr, "steps: %s\n", message.text);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
