/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model_parts.h"

/* ---- from the scene --------------------------------------------------------------------------------------------------- */

static int make(struct model *model, const struct tables *tables, struct message *message)
{
    if (model_check_tables(model, tables, message) != 0 || model_place_bodies(model, tables, message) != 0 ||
        model_add_effects(model, tables, message) != 0)
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
        result = model_read_tables(scene, &own, message);
    if (result == 0)
        result = make(model, scene->tables != NULL ? scene->tables : &own, message);
    table_destroy(&own.bodies);
    table_destroy(&own.bonds);
    if (result != 0)
        model_destroy(model);
    return result;
}

void model_destroy(struct model *model)
{
    neighbours_destroy(&model->neighbours);
    free(model->memory);
    free(model->bond_memory);
    free(model->bond_pairs);
    memset(model, 0, sizeof *model);
}

/* ---- forces and energy ------------------------------------------------------------------------------------------------ */

int model_find_pairs(struct model *model, const vti_bodies *bodies)
{
    if (!model->scene->has_contact)
        return VTI_OK;
    const int result = neighbours_update(&model->neighbours, &bodies->x, &model->trouble);
    model->contacts.count = model->neighbours.count;
    model->contacts.pair = model->neighbours.pair;
    return result < 0 ? MODEL_E_PAIRS : VTI_OK;
}

int model_forces(struct model *model, const vti_bodies *bodies)
{
    const int status = model_find_pairs(model, bodies);
    return status == VTI_OK ? vti_apply(model->effects, model->effects_count, bodies) : status;
}

double model_energy(struct model *model, const vti_bodies *bodies)
{
    if (model_find_pairs(model, bodies) != VTI_OK)
        return NAN;
    return vti_energy(model->effects, model->effects_count, bodies);
}

const char *model_text(const struct model *model, int status)
{
    return status == MODEL_E_PAIRS ? model->trouble.text : vti_status_text(status);
}
