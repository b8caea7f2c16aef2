/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model_parts.h"
#include "slices.h"
#include "step_errors.h"

/* ---- from the scene ---------------------------------------------------------------------------------------------- */

/** Effect k of the model acts on the spheres of clumps. */
static void put_on_spheres(struct model *model, int64_t k)
{
    model->on_spheres[k] = 1;
    model->clumped[k] = (vti_clumped){&model->clumps.list, &model->acting[k]};
    model->effects[k] = vti_clumped_effect(&model->clumped[k]);
}

int64_t model_acted_on(const struct model *model, const struct effect *e)
{
    return model_has_clumps(model) && kinds_has(e->kind, &model->scene->settings, EFFECT_ON_SPHERES)
               ? model->clumps.list.count
               : model->bodies.count;
}

/** Books of each body, if somebody asks and there is something to book. */
static int make_books(const struct model *model, struct effect *e, const vti_effect *draft, struct message *message)
{
    if (!model->scene->by_body || draft->books == 0)
        return 0;
    e->by_body = calloc((size_t)(model_acted_on(model, e) * draft->of_body) + 1, sizeof *e->by_body);
    return e->by_body != NULL ? 0 : scene_no_memory(model->scene, message);
}

/** An effect of the scene, with memory of its own. */
static int add_effect(struct model *model, const struct effect_kind *kind, const struct tables *tables,
                      struct message *message)
{
    struct effect *e = &model->instances[model->instances_count];
    vti_effect *made = &model->effects[model->effects_count];
    e->settings = kinds_settings_of(kind, &model->scene->settings);
    e->kind = kind;
    ++model->instances_count;
    model->seeks |= kind->find_pairs != NULL;
    const struct table *table = &tables->effect[kind->number];
    const vti_effect draft = kinds_draft(kind, &model->scene->settings, table);
    *made = draft;
    if (make_books(model, e, &draft, message) != 0)
        return -1;
    if (kind->make != NULL && kind->make(e, model, table, made, message) != 0)
        return -1;
    if (kinds_check_made(kind, &draft, made, message) != 0)
        return -1;
    model->acting[model->effects_count] = *made;
    if (model_has_clumps(model) && kinds_has(kind, &model->scene->settings, EFFECT_ON_SPHERES))
        put_on_spheres(model, model->effects_count);
    ++model->effects_count;
    return 0;
}

/** Whether the effects can act on these bodies at all; what else may be wrong, the first evaluation says. */
static int check_effects(const struct model *model, struct message *message)
{
    for (int64_t k = 0; k < model->effects_count; ++k)
        if (model_has_clumps(model) && model->effects[k].rupture != NULL)
            return message_set(message,
                               "%s: bonds of bodies.clumps neither break nor are made on the way; leave out %s.break, "
                               "columns break_... of its table, and %s.when",
                               model->scene->name, model->effects[k].name, model->effects[k].name);
    return 0;
}

static int make(struct model *model, const struct tables *tables, struct message *message)
{
    model->number = tables->number;
    if (model_check_tables(model, tables, message) != 0 || model_place_bodies(model, tables, message) != 0)
        return -1;
    model->seeks = model_has_clumps(model);
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (model->scene->has[k] && add_effect(model, kinds_at(k), tables, message) != 0)
            return -1;
    if (check_effects(model, message) != 0)
        return -1;
    /* once and for all: what checks the views again at every step would cost a lone body more than its step */
    int status = vti_bodies_seal(&model->bodies);
    if (status == VTI_OK)
        status = model_forces(model, &model->bodies);
    return status == VTI_OK ? 0 : message_set(message, "%s: %s", model->scene->name, model_text(model, status));
}

int model_create(const struct scene *scene, struct model *model, struct message *message)
{
    struct tables own;
    memset(&own, 0, sizeof own);
    memset(model, 0, sizeof *model);
    model->scene = scene;
    int result = 0;
    if (scene->tables == NULL)
        result = tables_read_by(model_read_table, scene, &own, message);
    if (result == 0)
        result = make(model, scene->tables != NULL ? scene->tables : &own, message);
    tables_destroy(&own);
    if (result != 0)
        model_destroy(model);
    return result;
}

void model_destroy(struct model *model)
{
    slices_destroy(model);
    step_errors_destroy(model->errors);
    for (int64_t k = 0; k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        if (e->kind->destroy != NULL && e->self != NULL)
            e->kind->destroy(e);
        free(e->self);
        free(e->by_body);
    }
    clumps_destroy(&model->clumps);
    free(model->memory);
    memset(model, 0, sizeof *model);
}

/* ---- forces and energy ------------------------------------------------------------------------------------------- */

const vti_bodies *model_spheres(const struct model *model)
{
    return model_has_clumps(model) ? &model->clumps.list.spheres : &model->bodies;
}

struct effect_surfaces model_surfaces(const struct model *model)
{
    struct effect_surfaces surfaces = {NULL, NULL, INFINITY, NULL};
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (model->instances[k].kind->surfaces != NULL)
            model->instances[k].kind->surfaces(&model->instances[k], &surfaces);
    return surfaces;
}

/** The spheres of clumps to where the bodies are. */
static int spread(struct model *model, const vti_bodies *bodies)
{
    if (!model_has_clumps(model))
        return VTI_OK;
    if (model->slices != NULL && bodies == &model->bodies)
        return slices_spread(model);
    return vti_clumps_spread(&model->clumps.list, bodies);
}

int model_find_pairs(struct model *model, const vti_bodies *bodies)
{
    if (!model->seeks)
        return VTI_OK;
    const int status = spread(model, bodies);
    for (int64_t k = 0; status == VTI_OK && k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        const vti_bodies *on = model->on_spheres[k] ? &model->clumps.list.spheres : bodies;
        if (e->kind->find_pairs != NULL && e->kind->find_pairs(e, on, &model->trouble) != 0)
            return MODEL_E_PAIRS;
    }
    return status;
}

int model_apply(const struct model *model, const vti_effect *acting, const vti_bodies *bodies,
                const vti_bodies *spheres)
{
    vti_effect on[2][MODEL_EFFECTS];
    int64_t n[2] = {0, 0};
    if (!model_has_clumps(model))
        return vti_apply(acting, model->effects_count, bodies);
    for (int64_t k = 0; k < model->effects_count; ++k)
        on[model->on_spheres[k]][n[model->on_spheres[k]]++] = acting[k];
    int status = vti_apply(on[1], n[1], spheres);
    if (status == VTI_OK)
        status = vti_apply(on[0], n[0], bodies);
    return status == VTI_OK ? vti_clumps_gather(&model->clumps.list, bodies) : status;
}

int model_forces(struct model *model, const vti_bodies *bodies)
{
    const int status = model_find_pairs(model, bodies);
    if (status != VTI_OK)
        return status;
    if (model->slices != NULL && bodies == &model->bodies)
        return slices_apply(model);
    return model_apply(model, model_has_clumps(model) ? model->acting : model->effects, bodies, model_spheres(model));
}

double model_energy(struct model *model, const vti_bodies *bodies)
{
    if (model_find_pairs(model, bodies) != VTI_OK)
        return NAN;
    return vti_energy(model->effects, model->effects_count, bodies);
}

double model_energy0(struct model *model)
{
    static const double rounding = 1e-13;
    const vti_bodies *b = &model->bodies;
    const double energy = model_energy(model, b), kinetic = vti_energy(NULL, 0, b);
    double size = kinetic;
    for (int64_t k = 0; k < model->effects_count; ++k)
        size += fabs(vti_energy(&model->effects[k], 1, b) - kinetic);
    return fabs(energy) > rounding * size ? energy : 0.0;
}

/* ---- what takes energy ------------------------------------------------------------------------------------------- */

const vti_effect *model_dissipates(const struct model *model)
{
    for (int64_t k = 0; k < model->effects_count; ++k) {
        const vti_effect *e = &model->effects[k];
        if (e->flow != NULL || e->carry != NULL || e->rupture != NULL || e->dissipates != 0)
            return e;
    }
    return NULL;
}

int model_twists(const struct model *model)
{
    int any = model->turns && (model->bodies.moments.c[0] != NULL || model_has_clumps(model));
    for (int64_t k = 0; k < model->effects_count && model->turns; ++k) {
        const vti_effect *e = &model->effects[k];
        any |= (e->gives & EFFECT_MOMENT) != 0 || (e->flow != NULL && (e->needs & 1 << VTI_QUANTITY_OMEGA) != 0);
    }
    return any;
}

int model_only_slows(const struct model *model)
{
    int slows = 0, pushes = 0;
    for (int64_t k = 0; k < model->effects_count; ++k) {
        const vti_effect *e = &model->effects[k];
        pushes |= e->apply != NULL;
        slows |= e->flow != NULL && (e->needs & 1 << VTI_QUANTITY_V) != 0;
    }
    return slows && !pushes;
}

int model_breaks(const struct model *model)
{
    int any = 0;
    for (int64_t k = 0; k < model->effects_count; ++k)
        any |= model->effects[k].rupture != NULL;
    return any;
}

int model_of_spheres(const struct model *model, const char *what, const char *remedy, struct message *message)
{
    if (model_has_clumps(model))
        return message_set(message, "%s: bodies.clumps: %s knows bodies that are spheres; %s", model->scene->name, what,
                           remedy);
    if (model->bodies.moments.c[0] == NULL)
        return 0;
    return message_set(
        message, "%s: bodies.moments: %s knows bodies of one moment of inertia, spheres; give bodies.inertia, or %s",
        model->scene->name, what, remedy);
}

int model_rupture(struct model *model, int64_t step, double t)
{
    const int64_t *pair = NULL;
    int64_t broken, count = 0;
    const int status = vti_effects_rupture(model->effects, model->effects_count, &model->bodies, &broken);
    if (status != VTI_OK)
        return status;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        if (e->kind->breaks != NULL && e->kind->breaks->may(e))
            count = e->kind->breaks->broken(e, step, &pair);
    }
    for (int64_t k = 0; k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        if (e->kind->release != NULL && e->kind->release(e, &model->bodies, count, pair, &model->trouble) != 0)
            return MODEL_E_PAIRS;
    }
    for (int64_t k = 0; k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        const int64_t made = e->kind->join != NULL ? e->kind->join(e, model, step, t, &model->trouble) : 0;
        if (made < 0)
            return MODEL_E_PAIRS;
        broken += made;
    }
    return broken > 0 ? model_forces(model, &model->bodies) : VTI_OK;
}

/* ---- texts ------------------------------------------------------------------------------------------------------- */

const char *model_text(const struct model *model, int status)
{
    if (status == VTI_E_HISTORY) /* the table has room for all that touch soon: these came from farther in one step */
        return "more bodies came to touch in one step than could be foreseen; use a smaller h";
    return status == MODEL_E_PAIRS ? model->trouble.text : vti_status_text(status);
}
