/* SPDX-License-Identifier: BSD-3-Clause */
#include "loop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "number.h"

int64_t loop_steps(double t_end, double h)
{
    const double ratio = t_end / h;
    /* t_end and h are rounded, so their ratio may fall short of a whole number by a few ulps */
    return (int64_t)floor(ratio * (1.0 + 4.0 * 2.220446049250313e-16));
}

/* ---- reading a lagging method ------------------------------------------------------------------------------------ */

/** Copies of v and omega on which a lagging method is brought to the time of the positions, so that looking at a run does not
 *  change its bits. Other methods are read as they are, from the model itself, whose bodies are sealed. */
struct reader {
    vti_bodies bodies;
    double *memory;
};

static void copy(const vti_view *from, const vti_view *to, int64_t n)
{
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            to->c[k][i * to->stride] = from->c[k][i * from->stride];
}

static int reader_create(struct reader *reader, const struct model *model, const vti_stepper *stepper)
{
    const vti_bodies *b = &model->bodies;
    reader->bodies = *b;
    reader->memory = NULL;
    if (stepper->lag == 0.0)
        return 0;
    reader->memory = calloc((size_t)(6 * b->count), sizeof *reader->memory);
    if (reader->memory == NULL)
        return -1;
    /* the copies hold no residuals; what those add to one reading is below its rounding */
    reader->bodies.v_low = reader->bodies.omega_low = vti_view_none();
    if (b->v.c[0] != NULL)
        reader->bodies.v = vti_view_packed(reader->memory);
    if (b->omega.c[0] != NULL)
        reader->bodies.omega = vti_view_packed(reader->memory + 3 * b->count);
    return vti_bodies_seal(&reader->bodies) == VTI_OK ? 0 : -1;
}

static const vti_bodies *reader_read(struct reader *reader, const struct model *model, const vti_stepper *stepper,
                                     double h)
{
    if (reader->memory == NULL)
        return &model->bodies;
    if (model->bodies.v.c[0] != NULL)
        copy(&model->bodies.v, &reader->bodies.v, model->bodies.count);
    if (model->bodies.omega.c[0] != NULL)
        copy(&model->bodies.omega, &reader->bodies.omega, model->bodies.count);
    vti_step_sync(stepper, h, &reader->bodies);
    return &reader->bodies;
}

/* ---- force gradients ---------------------------------------------------------------------------------------------- */

/** Bodies whose positions and attitudes are memory of their own, and all else the model's: where a stepper with a probe takes
 *  forces besides. */
struct probe {
    vti_bodies bodies;
    double *memory;
};

static int probe_create(struct probe *probe, const struct model *model, const vti_stepper *stepper)
{
    const vti_bodies *b = &model->bodies;
    probe->bodies = *b;
    probe->memory = NULL;
    if (stepper->probe == NULL)
        return 0;
    probe->memory = calloc((size_t)(6 * b->count), sizeof *probe->memory);
    if (probe->memory == NULL)
        return -1;
    probe->bodies.x_low = probe->bodies.alpha_low = vti_view_none();
    if (b->x.c[0] != NULL)
        probe->bodies.x = vti_view_packed(probe->memory);
    if (b->alpha.c[0] != NULL)
        probe->bodies.alpha = vti_view_packed(probe->memory + 3 * b->count);
    return vti_bodies_seal(&probe->bodies) == VTI_OK ? 0 : -1;
}

/** The forces of kick k are there already, but for a probe. */
static int probe_forces(struct probe *probe, struct model *model, const vti_stepper *stepper, int64_t k, double h)
{
    if (stepper->probe == NULL || stepper->probe[k] == 0.0)
        return VTI_OK;
    const int status = vti_step_probe(stepper, k, h, &model->bodies, &probe->bodies);
    return status == VTI_OK ? model_forces(model, &probe->bodies) : status;
}

/* ---- the loop ---------------------------------------------------------------------------------------------------- */

/** One step of any method: stages of kick, drift and forces, and what is left after the last. With effects that flow or
 *  carry n is how many effects there are, else 0. */
static int one_step(struct model *model, const vti_stepper *stepper, double h, int64_t n, struct probe *probe,
                    vti_fault *fault)
{
    for (int64_t k = 0; k < stepper->stages; ++k) {
        int status = probe_forces(probe, model, stepper, k, h);
        if (status == VTI_OK)
            status = n > 0 ? vti_effects_stage(stepper, k, h, model->effects, n, &model->bodies, fault)
                           : vti_step_stage(stepper, k, h, &model->bodies, fault);
        if (status == VTI_OK)
            status = model_forces(model, &model->bodies);
        if (status != VTI_OK)
            return status;
    }
    const int status = probe_forces(probe, model, stepper, stepper->stages, h);
    if (status != VTI_OK)
        return status;
    return n > 0 ? vti_effects_finish(stepper, h, model->effects, n, &model->bodies)
                 : vti_step_finish(stepper, h, &model->bodies);
}

/** What a run consists of. */
struct run {
    struct model *model;
    const vti_stepper *stepper;
    double h;
    int64_t last; /* step */
    const struct observer *observers;
    int observers_count;
    struct reader reader;
    struct probe probe;
};

static int show(struct run *run, int64_t step)
{
    const vti_bodies *in_time = NULL;
    for (int k = 0; k < run->observers_count; ++k) {
        const struct observer *o = &run->observers[k];
        if (o->every > 1 && step % o->every != 0 && step != run->last)
            continue;
        if (!o->raw && in_time == NULL)
            in_time = reader_read(&run->reader, run->model, run->stepper, run->h);
        if (o->see(o->self, step, (double)step * run->h, o->raw ? &run->model->bodies : in_time) != 0)
            return 1;
    }
    return 0;
}

static int refused(const struct model *model, int status, const vti_fault *fault, const vti_stepper *stepper, double h,
                   int64_t from, int64_t step, struct message *message)
{
    char place[64];
    if (step > from)
        snprintf(place, sizeof place, "step %lld (t = %.10g)", (long long)step, (double)(step - 1) * h);
    else
        snprintf(place, sizeof place, "the start (t = %.10g)", (double)from * h);
    if (status == VTI_E_TOO_LARGE)
        return message_set(message, "%s at h = %s: %s: body %lld has h|Omega| = %.6g; %s", stepper->name, NUMBER(h),
                           place, (long long)fault->body, fault->value, vti_status_text(status));
    return message_set(message, "%s at h = %s: %s: %s", stepper->name, NUMBER(h), place, model_text(model, status));
}

/** Forces at the bodies' positions; at t = 0 velocities also move to where the method keeps them. */
static int begin(const struct run *run, int64_t from)
{
    int status = vti_step_check(run->stepper, run->model->effects, run->model->effects_count);
    if (status == VTI_OK)
        status = model_forces(run->model, &run->model->bodies);
    return status != VTI_OK || from > 0 ? status : vti_step_start(run->stepper, run->h, &run->model->bodies);
}

int loop_run(struct model *model, const vti_stepper *stepper, double h, int64_t from, int64_t steps,
             const struct observer *observers, int observers_count, struct message *message)
{
    struct run run = {
        model, stepper, h, steps, observers, observers_count, {model->bodies, NULL}, {model->bodies, NULL}};
    if (reader_create(&run.reader, model, stepper) != 0 || probe_create(&run.probe, model, stepper) != 0) {
        free(run.reader.memory);
        return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
    }
    vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
    const int64_t effects = model_dissipates(model) != NULL ? model->effects_count : 0;
    int64_t step = from;
    int status = begin(&run, from);
    int stopped = status == VTI_OK && show(&run, step);
    while (status == VTI_OK && !stopped && step < steps) {
        status = one_step(model, stepper, h, effects, &run.probe, &fault);
        ++step;
        if (status == VTI_OK)
            stopped = show(&run, step);
    }
    free(run.reader.memory);
    free(run.probe.memory);
    return status != VTI_OK ? refused(model, status, &fault, stepper, h, from, step, message) : stopped;
}
