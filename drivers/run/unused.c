/* SPDX-License-Identifier: BSD-3-Clause
 * What scene and tables give of bodies and nothing in the model goes by. */
#include "unused.h"

#include "quote.h"

/** Whether an effect is as stiff as the bodies' materials make it. */
static int has_materials(const struct model *model)
{
    int any = 0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        any |= e->kind->by_material != NULL && e->kind->by_material(e);
    }
    return any;
}

/** Inertia follows from mass and diameter. */
static int needs_mass(const struct model *model, const struct table *t)
{
    const struct scene *s = model->scene;
    const int given =
        s->inertia != 0.0 || s->moments[0] != 0.0 || table_has(t, BODY_INERTIA) || table_has(t, BODY_MOMENTS);
    return model->translates || (model->turns && !given);
}

static void say_key(const char *key, const char *why, FILE *file)
{
    fprintf(file, "note: %s is not used: %s; leave it out\n", key, why);
}

/** Tables may be those of several scenes, and have what others need. */
static void say_columns(const struct table *table, const char *columns, const char *why, FILE *file)
{
    char shown[240];
    fprintf(file, "note: %s: %s not used: %s\n", quote_tail(shown, sizeof shown, table->path), columns, why);
}

void unused_say(const struct model *model, const struct tables *tables, FILE *file)
{
    static const char *const turned = "nothing turns bodies",
                             *const moved = "bodies do not translate, and their inertia is given",
                             *const made = "no stiffness of this scene follows from the bodies' materials";
    const struct scene *s = model->scene;
    const struct table *t = &tables->bodies;
    const int massless = !needs_mass(model, t);
    if (!model->turns && s->inertia != 0.0)
        say_key("bodies.inertia", turned, file);
    if (!model->turns && s->moments[0] != 0.0)
        say_key("bodies.moments", turned, file);
    if (!model->turns && table_has(t, BODY_INERTIA))
        say_columns(t, "column inertia is", turned, file);
    if (!model->turns && table_has(t, BODY_MOMENTS))
        say_columns(t, "columns moment_a, moment_b, moment_c are", turned, file);
    if (massless && (s->mass != 0.0 || s->density != 0.0))
        say_key(s->mass != 0.0 ? "bodies.mass" : "bodies.density", moved, file);
    if (massless && table_has(t, BODY_MASS))
        say_columns(t, "column mass is", moved, file);
    if (table_has(t, BODY_YOUNG) && !has_materials(model))
        say_columns(t, "columns young and poisson are", made, file);
}
