/* SPDX-License-Identifier: BSD-3-Clause */
#include "loop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "number.h"
#include "slices.h"
#include "state.h"
#include "step_errors.h"

int64_t loop_steps(double t_end, double h)
{
    const double ratio = t_end / h;
    /* t_end and h are rounded, so their ratio may fall short of a whole number by a few ulps */
    return (int64_t)fmin(floor(ratio * (1.0 + 4.0 * 2.220446049250313e-16)), LOOP_STEPS);
}

/* ---- what a step needs besides the model ------------------------------------------------------------------------- */

/** What a run consists of. */
struct run {
    struct model *model;
    const vti_stepper *stepper;
    double h;
    int64_t last; /* step */
    const struct observer *observers;
    int observers_count;
    int64_t effects; /* how many there are, if some of them flow, carry or break, else 0 */
    int breaks;      /* 1 if some of them break */
    int joins;       /* 1 if steps at which nobody looks at velocities end with the begin of the next */
    int is_open;     /* 1 while the last step waits for the begin of the next */
    int64_t called;  /* bit k: observer k is, at this step */
    int64_t always;  /* bit k: observer k is called at every step */
    int64_t due;     /* the next step at which another one is */
    /** Its v and omega are those of a lagging method at the time of the positions: looking at a run changes no bits. */
    struct fork reader;
    struct fork probe; /* at whose x and alpha a stepper with a probe takes forces besides */
};

/** Residuals are left out of what is read; what they add to one reading is below its rounding. */
static int create_forks(struct run *run)
{
    const int reads = run->stepper->lag != 0.0 ? OWN_V | OWN_OMEGA | OWN_SPIN : 0;
    const int probes = run->stepper->probe != NULL ? OWN_X | OWN_ALPHA : 0;
    const int failed = state_fork_create(&run->reader, &run->model->bodies, reads);
    return state_fork_create(&run->probe, &run->model->bodies, probes) | failed;
}

static const vti_bodies *read_bodies(struct run *run)
{
    if (run->reader.own == 0)
        return &run->model->bodies;
    state_fork_take(&run->reader, run->model->bodies);
    vti_step_sync(run->stepper, run->h, &run->reader.bodies);
    return &run->reader.bodies;
}

/** The forces of kick k are there already, but for a probe. */
static int probe_forces(struct run *run, int64_t k)
{
    const vti_stepper *stepper = run->stepper;
    if (stepper->probe == NULL || stepper->probe[k] == 0.0)
        return VTI_OK;
    const int status = vti_step_probe(stepper, k, run->h, &run->model->bodies, &run->probe.bodies);
    return status == VTI_OK ? model_forces(run->model, &run->probe.bodies) : status;
}

/* ---- the loop ---------------------------------------------------------------------------------------------------- */

static int stage(struct run *run, int64_t k, vti_fault *fault)
{
    struct model *model = run->model;
    if (run->is_open) {
        run->is_open = 0;
        return model->slices != NULL ? slices_next(model, run->stepper, run->h)
                                     : vti_step_next(run->stepper, run->h, &model->bodies, fault);
    }
    if (run->effects > 0)
        return vti_effects_stage(run->stepper, k, run->h, model->effects, run->effects, &model->bodies, fault);
    if (model->slices != NULL)
        return slices_stage(model, run->stepper, k, run->h, fault);
    return vti_step_stage(run->stepper, k, run->h, &model->bodies, fault);
}

/** Who is called at the step, and when somebody is next who is not called at all of them. */
static int64_t find_called(struct run *run, int64_t step)
{
    int64_t called = 0;
    run->due = run->last;
    for (int k = 0; k < run->observers_count; ++k) {
        const int64_t every = run->observers[k].every, since = every > 1 ? step % every : 0;
        called |= (int64_t)(since == 0 || step == run->last) << k;
        run->always |= (int64_t)(every <= 1) << k;
        if (every > 1 && every - since < run->due - step)
            run->due = step + every - since;
    }
    return called;
}

/** Finds who is called at the step; returns 1 if somebody looks at velocities there. */
static int look_ahead(struct run *run, int64_t step)
{
    int looked = step == run->last;
    run->called = step < run->due ? run->always : find_called(run, step);
    for (int k = 0; run->called >> k != 0; ++k) {
        const struct observer *o = &run->observers[k];
        if (run->called >> k & 1)
            looked |= o->looks == NULL || o->looks(o->self, step);
    }
    return looked;
}

static int finish(struct run *run)
{
    struct model *model = run->model;
    run->is_open = 0;
    model->owed = 0.0;
    if (run->effects > 0)
        return vti_effects_finish(run->stepper, run->h, model->effects, run->effects, &model->bodies);
    if (model->slices != NULL)
        return slices_finish(model, run->stepper, run->h);
    return vti_step_finish(run->stepper, run->h, &model->bodies);
}

/** One step of any method: stages of kick, drift and forces, what is left after the last, and what breaks then. */
static int one_step(struct run *run, int64_t step, vti_fault *fault)
{
    struct model *const model = run->model;
    for (int64_t k = 0; k < run->stepper->stages; ++k) {
        int status = probe_forces(run, k);
        if (status == VTI_OK)
            status = step_errors_watch(model->errors, run->stepper, k, run->h, &model->bodies);
        if (status == VTI_OK)
            status = stage(run, k, fault);
        if (status == VTI_OK)
            status = model_forces(model, &model->bodies);
        if (status != VTI_OK)
            return status;
    }
    int status = probe_forces(run, run->stepper->stages);
    if (status == VTI_OK)
        status = step_errors_watch(model->errors, run->stepper, run->stepper->stages, run->h, &model->bodies);
    const int looked = look_ahead(run, step);
    run->is_open = status == VTI_OK && run->joins && !looked;
    model->owed = run->is_open ? run->stepper->kick[run->stepper->stages] * run->h : 0.0;
    if (status == VTI_OK && !run->is_open)
        status = finish(run);
    if (status == VTI_OK && model->errors != NULL)
        status = step_errors_end(model->errors, run->stepper, (double)step * run->h, &model->bodies);
    return status == VTI_OK && run->breaks ? model_rupture(run->model, step, (double)step * run->h) : status;
}

static int show(struct run *run, int64_t step)
{
    const vti_bodies *in_time = NULL;
    for (int k = 0; run->called >> k != 0; ++k) {
        const struct observer *o = &run->observers[k];
        if ((run->called >> k & 1) == 0)
            continue;
        if (!o->raw && in_time == NULL)
            in_time = read_bodies(run);
        if (o->see(o->self, step, (double)step * run->h, o->raw ? &run->model->bodies : in_time) != 0)
            return 1;
    }
    return 0;
}

static int refused(const struct run *run, int status, const vti_fault *fault, int64_t from, int64_t step,
                   struct message *message)
{
    const struct model *const model = run->model;
    const double h = run->h;
    char place[64];
    if (step > from)
        snprintf(place, sizeof place, "step %lld (t = %.10g)", (long long)step, (double)(step - 1) * h);
    else
        snprintf(place, sizeof place, "the start (t = %.10g)", (double)from * h);
    if (status == VTI_E_TOO_LARGE)
        return message_set(message, "%s at h = %s: %s: body %lld has h|Omega| = %.6g; %s", run->stepper->name,
                           NUMBER(h), place, (long long)model_number(model, fault->body), fault->value,
                           vti_status_text(status));
    return message_set(message, "%s at h = %s: %s: %s", run->stepper->name, NUMBER(h), place,
                       model_text(model, status));
}

int loop_never_looks(void *self, int64_t step)
{
    (void)self;
    (void)step;
    return 0;
}

/** Forces at the bodies' positions; at t = 0 velocities also move to where the method keeps them. */
static int begin(const struct run *run, int64_t from)
{
    int status = vti_step_check(run->stepper, run->model->effects, run->model->effects_count);
    if (status == VTI_OK)
        status = model_forces(run->model, &run->model->bodies);
    return status != VTI_OK || from > 0 ? status : vti_step_start(run->stepper, run->h, &run->model->bodies);
}

/** Nothing is done between two steps, and a step that is refused leaves the one before finished. */
static int can_join(const struct run *run)
{
    const vti_stepper *s = run->stepper;
    return s->law != VTI_LAW_CLOSED && s->drift[s->stages] == 0.0 && s->lag == 0.0 && s->probe == NULL &&
           run->effects == 0 && !run->breaks && run->model->errors == NULL;
}

int loop_run(struct model *model, const vti_stepper *stepper, double h, int64_t from, int64_t steps,
             const struct observer *observers, int observers_count, struct message *message)
{
    struct run run = {.model = model,
                      .stepper = stepper,
                      .h = h,
                      .last = steps,
                      .observers = observers,
                      .observers_count = observers_count,
                      .effects = model_dissipates(model) != NULL ? model->effects_count : 0,
                      .breaks = model_breaks(model)};
    if (create_forks(&run) != 0) {
        free(run.reader.memory);
        free(run.probe.memory);
        return scene_no_memory(model->scene, message);
    }
    run.joins = can_join(&run);
    vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
    int64_t step = from;
    int status = begin(&run, from);
    look_ahead(&run, step);
    int stopped = status == VTI_OK && show(&run, step);
    while (status == VTI_OK && !stopped && step < steps) {
        status = one_step(&run, ++step, &fault);
        if (status == VTI_OK)
            stopped = show(&run, step);
    }
    if (status == VTI_OK && run.is_open)
        status = finish(&run);
    free(run.reader.memory);
    free(run.probe.memory);
    return status != VTI_OK ? refused(&run, status, &fault, from, step, message) : stopped;
}
