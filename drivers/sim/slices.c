/* SPDX-License-Identifier: BSD-3-Clause */
#include "slices.h"

#include <stdlib.h>

#include "threads.h"

struct slice {
    vti_bodies bodies, spheres; /* sealed; spheres of clumps */
    struct effect_part part[MODEL_EFFECTS];
    vti_effect effects[MODEL_EFFECTS];
    int status;
};

struct slices {
    int64_t count;
    struct slice slice[];
};

/** What is done with each slice: all that a thread is told. */
struct task {
    int (*work)(struct slice *slice, const struct task *task);
    const struct model *model;
    const vti_stepper *stepper;
    int64_t k;
    double h;
};

static int64_t one_slice(void *self, int64_t k)
{
    const struct task *task = self;
    struct slice *slice = &task->model->slices->slice[k];
    slice->status = task->work(slice, task);
    return slice->status != VTI_OK;
}

/** Returns the status of the first slice, by its number, that is not VTI_OK. */
static int do_all(const struct task *task)
{
    const struct slices *s = task->model->slices;
    struct task own = *task;
    int64_t k = 0;
    if (threads_sum(s->count, one_slice, &own) == 0)
        return VTI_OK;
    while (s->slice[k].status == VTI_OK)
        ++k;
    return s->slice[k].status;
}

/* ---- what they do ------------------------------------------------------------------------------------------------ */

static int stage(struct slice *slice, const struct task *task)
{
    return vti_step_stage(task->stepper, task->k, task->h, &slice->bodies, NULL);
}

static int finish(struct slice *slice, const struct task *task)
{
    return vti_step_finish(task->stepper, task->h, &slice->bodies);
}

static int next(struct slice *slice, const struct task *task)
{
    return vti_step_next(task->stepper, task->h, &slice->bodies, NULL);
}

static int spread(struct slice *slice, const struct task *task)
{
    return vti_clumps_spread(&task->model->clumps.list, &slice->bodies);
}

static int apply(struct slice *slice, const struct task *task)
{
    const struct model *model = task->model;
    for (int64_t k = 0; k < model->effects_count; ++k) {
        const struct effect *e = &model->instances[k];
        const int takes = e->kind->take_part != NULL;
        const vti_bodies *on = model->on_spheres[k] ? &slice->spheres : &slice->bodies;
        if (takes && e->kind->take_part(e, on, &slice->part[k]) != 0)
            return MODEL_E_PAIRS;
        slice->effects[k] = takes ? slice->part[k].made : model->acting[k];
    }
    return model_apply(model, slice->effects, &slice->bodies, &slice->spheres);
}

int slices_stage(const struct model *model, const vti_stepper *stepper, int64_t k, double h, vti_fault *fault)
{
    const struct task task = {stage, model, stepper, k, h};
    if (stepper->law == VTI_LAW_CLOSED) /* all bodies or none */
        return vti_step_stage(stepper, k, h, &model->bodies, fault);
    return do_all(&task);
}

int slices_finish(const struct model *model, const vti_stepper *stepper, double h)
{
    const struct task task = {finish, model, stepper, 0, h};
    return do_all(&task);
}

int slices_next(const struct model *model, const vti_stepper *stepper, double h)
{
    const struct task task = {next, model, stepper, 0, h};
    return do_all(&task);
}

int slices_spread(const struct model *model)
{
    const struct task task = {spread, model, NULL, 0, 0.0};
    return do_all(&task);
}

int slices_apply(struct model *model)
{
    const struct task task = {apply, model, NULL, 0, 0.0};
    const int status = do_all(&task);
    if (status == MODEL_E_PAIRS)
        message_set(&model->trouble, "out of memory for the pairs of %lld threads; use fewer",
                    (long long)model->slices->count);
    return status;
}

/* ---- create and destroy ------------------------------------------------------------------------------------------ */

int slices_create(struct model *model, struct message *message)
{
    const int64_t n = model->bodies.count, count = threads_used() < n ? threads_used() : n;
    slices_destroy(model);
    if (count <= 1)
        return 0;
    struct slices *s = calloc(1, sizeof *s + (size_t)count * sizeof *s->slice);
    if (s == NULL)
        return message_set(message, "%s: out of memory for %lld threads; use fewer", model->scene->name,
                           (long long)count);
    s->count = count;
    model->slices = s;
    for (int64_t k = 0; k < count; ++k) {
        const int64_t first = threads_begin(n, k, count);
        s->slice[k].bodies = vti_bodies_slice(model->bodies, first, threads_begin(n, k + 1, count) - first);
        s->slice[k].spheres =
            model_has_clumps(model) ? vti_clumps_spheres(&model->clumps.list, &s->slice[k].bodies) : vti_bodies_none(0);
        if (vti_bodies_seal(&s->slice[k].bodies) != VTI_OK || vti_bodies_seal(&s->slice[k].spheres) != VTI_OK)
            return message_set(message, "%s: its bodies cannot be cut into slices", model->scene->name);
    }
    return 0;
}

void slices_destroy(struct model *model)
{
    struct slices *s = model->slices;
    for (int64_t k = 0; s != NULL && k < s->count; ++k)
        for (int e = 0; e < MODEL_EFFECTS; ++e)
            free(s->slice[k].part[e].memory);
    free(s);
    model->slices = NULL;
}
