/* SPDX-License-Identifier: BSD-3-Clause
 * Any bytes as a scene file: refused with one line, or a scene of which a model can be made and stepped. */
#include "fuzz.h"

#include <math.h>

#include "../../settings.h"
#include "loop.h"
#include "tables.h"

enum { BODIES = 300, STEPS = 3 };

static int positive(double x)
{
    return isfinite(x) && x > 0.0;
}

static int all_finite(const double *p, int n)
{
    int finite = 1;
    for (int k = 0; k < n; ++k)
        finite = finite && isfinite(p[k]);
    return finite;
}

static void check_effects(const struct scene *s)
{
    const int known = s->arrangement != SCENE_IN_TABLE;
    const struct scene_planes *planes = setting(s, "wall.planes");
    if (calls_for(s, "binder"))
        fuzz_must(*(char *)setting(s, "binder.table") != '\0' || *number_setting(s, "binder.moment") > 0.0 ||
                      *number_setting(s, "binder.axial") > 0.0 || *number_setting(s, "binder.shear.stiffness") > 0.0,
                  "a binder has a stiffness");
    fuzz_must(!known || s->translates || scene_first_with(s, EFFECT_TRANSLATING) == NULL,
              "what acts on positions has some");
    fuzz_must(!calls_for(s, "contact") || positive(*number_setting(s, "contact.stiffness")) ||
                  positive(*number_setting(s, "contact.young")),
              "contact is stiff");
    for (int64_t k = 0; calls_for(s, "wall") && k < planes->count; ++k)
        fuzz_must(fabs(vti_norm(planes->plane[k]) - 1.0) < 1e-15 && isfinite(planes->plane[k][3]), "planes are unit");
    fuzz_must(!calls_for(s, "pendulum") || (s->turns && !s->translates), "a pendulum turns");
    fuzz_must(all_finite(number_setting(s, "pendulum.rho0"), 3) && all_finite(number_setting(s, "gravity"), 3),
              "finite");
}

/** Principal moments that a body can have, to rounding. */
static int can_be(const double moments[3])
{
    int good = 1;
    for (int k = 0; k < 3; ++k)
        good &= positive(moments[k]) &&
                moments[k] - moments[(k + 1) % 3] <= moments[(k + 2) % 3] * (1.0 + 1e-12) + 1e-12 * moments[k];
    return good;
}

static void check(const struct scene *s)
{
    const int known = s->arrangement != SCENE_IN_TABLE, formula = known && s->arrangement != SCENE_SINGLE;
    const int sphere = positive(s->mass) && (positive(s->diameter) || formula);
    fuzz_must(!known || s->translates || s->turns, "something moves");
    fuzz_must(!known || !s->translates || positive(s->mass) || positive(s->clumps.density),
              "what translates has a mass");
    const int has_moments = s->moments[0] != 0.0;
    fuzz_must(!has_moments || (can_be(s->moments) && all_finite(s->principal, 3)), "a body can have such moments");
    fuzz_must(!known || !s->turns || positive(s->inertia) || sphere || has_moments || s->clumps.given,
              "what turns has an inertia");
    double spheres = s->clumps.counts.count > 0 ? 0.0 : (double)s->clumps.spheres.count;
    for (int64_t k = 0; k < s->clumps.counts.count; ++k)
        spheres += s->clumps.counts.number[k];
    fuzz_must(!s->clumps.given || (spheres >= 1.0 && spheres == (double)s->clumps.spheres.count),
              "clumps have spheres");
    fuzz_must(all_finite(s->x, 3) && all_finite(s->v, 3) && all_finite(s->alpha, 3) && all_finite(s->omega, 3),
              "finite");
    fuzz_must(known ? scene_bodies(s) >= 1 && scene_bodies(s) <= SCENE_BODIES_MAX : s->table[0] != '\0', "bodies");
    fuzz_must(positive(s->h) && positive(s->t_end) && s->t_end / s->h <= 0x1p53, "times are positive");
    fuzz_must(s->stepper != NULL && s->name[0] != '\0', "a scene has a stepper and a name");
    fuzz_must(s->rotor == 0 || ((s->rotor == 2 || s->rotor == 4 || s->rotor == 6) &&
                                (!known || has_moments || s->clumps.given) && s->stepper->kick != NULL),
              "a rotor is that of bodies with moments");
    check_effects(s);
}

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
    check(&scene);
    int tables = 0;
    for (int k = 0; k < TABLES; ++k)
        tables += tables_path(&scene, k)[0] != '\0';
    if (tables == 0 && scene_bodies(&scene) <= BODIES)
        step(&scene);
    return 0;
}
