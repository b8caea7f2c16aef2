/* SPDX-License-Identifier: BSD-3-Clause
 * Any lines as what follows --set: refused with one line, or taken up by the scene. */
#include "fuzz.h"

#include "scene.h"

enum { SETS = 16, TEXT = 1024 };

static const char *const base[] = {"bodies: {alpha: [0, 0, 0], omega: [1, 2, 3], inertia: 1}\n"
                                   "pendulum: {weight: 1, rho0: [0, 0, -1]}\nh: 1/64\nt_end: 10\n",
                                   "bodies:\n  lattice: {counts: [2, 2, 2], spacing: 1}\n  mass: 1\n  inertia: 1\n"
                                   "binder: {moment: 10, axial: 200, shear: {stiffness: 200, form: objective}}\n"
                                   "contact: {stiffness: 100}\nwall: {stiffness: 1e3, planes: [[0, 0, 1, -2]]}\n"
                                   "gravity: [0, 0, -1]\nh: 1e-3\nt_end: 1\n"};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct scene scene;
    char text[TEXT];
    const char *sets[SETS];
    int n = 0;
    struct message message = {""};
    if (size < 1 || size > TEXT)
        return 0;
    const char *scene_text = base[data[0] & 1];
    memcpy(text, data + 1, size - 1);
    text[size - 1] = '\0';
    for (char *line = text; line != NULL && n < SETS; ++n) {
        char *end = strchr(line, '\n');
        if (end != NULL)
            *end++ = '\0';
        sets[n] = line;
        line = end;
    }
    if (scene_read(fuzz_file("scene.yaml", scene_text, strlen(scene_text)), sets, n, &scene, &message) != 0)
        fuzz_one_line(&message);
    else
        fuzz_must(scene.h > 0.0 && scene.t_end > 0.0 && scene.stepper != NULL, "a scene can be run");
    return 0;
}
