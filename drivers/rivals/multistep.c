/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Multistep methods (EQUATIONS 8.1), as programs run them: K - 1 steps by others that are accurate enough, the
 * accelerations remembered before each, then one force evaluation a step. What they remember is all that they keep
 * beside the bodies, so that a checkpoint goes on with it. Where something may touch, the K - 1 steps are back in time and
 * undone, so that what begins to touch at the start does so within a step of theirs, which takes off what it would miss
 * of that. What does not touch at the start does not on the way back: bodies that have just parted would meet there. */
#include "rival.h"

#include <stdlib.h>
#include <string.h>

#include "step_errors.h"
#include "touches.h"

enum { MOST = 16 };

static struct rival engines[MOST]; /* in the order of the library's table, filled in as they are asked for */

/** When the step that is made ends. */
static double step_end(const struct course *c)
{
    return (double)(c->steps + 1) * c->h;
}

static int step_by(struct course *c, const vti_stepper *by, double h, int (*forces)(struct course *c))
{
    struct step_errors *const errors = c->model->errors;
    int status = step_errors_watch(errors, by, 0, h, &c->bodies);
    for (int64_t k = 0; k < by->stages && status == VTI_OK; ++k) {
        status = vti_step_stage(by, k, h, &c->bodies, &c->fault);
        if (status == VTI_OK)
            status = forces(c);
        if (status == VTI_OK)
            status = step_errors_watch(errors, by, k + 1, h, &c->bodies);
    }
    if (status == VTI_OK)
        status = vti_step_finish(by, h, &c->bodies);
    return status == VTI_OK && errors != NULL ? step_errors_end(errors, by, step_end(c), &c->bodies) : status;
}

int course_step(struct course *c, const vti_stepper *by, double h)
{
    return step_by(c, by, h, course_forces);
}

static int take_error(struct course *c, const vti_multistep *m, const vti_past *past)
{
    double error[2];
    const int status = vti_multistep_error(m, c->h, past, &c->bodies, &error[0], &error[1]);
    if (status == VTI_OK)
        step_errors_take(c->model->errors, step_end(c), &c->bodies, error);
    return status;
}

static int multistep(struct course *c, const vti_multistep *m, vti_past *past, int (*forces)(struct course *c))
{
    int status = vti_multistep_predict(m, c->h, past, &c->bodies, &c->fault);
    if (status == VTI_OK)
        status = forces(c);
    if (status == VTI_OK && c->model->errors != NULL)
        status = take_error(c, m, past);
    return status == VTI_OK ? vti_multistep_correct(m, c->h, past, &c->bodies) : status;
}

/** A step of the start, K - 1 of them: up to four by srkn6 where steps are large, up to six by srkn11 where they are small,
 *  and then one each by AN(5), or AN(7), and so on, which evaluate once. Their orders are less than K, but at such steps
 *  they err by less than the rest of the way does: by srkn6 down to about 1e-11, by srkn11 to rounding (an10-mid on the
 *  chain: order 10.7 down to 5e-14). */
static int start_step(struct course *c, const vti_multistep *m, vti_past *past, int (*forces)(struct course *c))
{
    const int large = m->reach > 0.5;
    const int64_t grows_from = large ? 5 : 7;
    const vti_multistep grown = {.depth = past->known, .c = 1.0};
    int status = past->known == 0 ? vti_multistep_record(past, &c->bodies) : VTI_OK;
    if (status == VTI_OK && past->known >= grows_from)
        return multistep(c, &grown, past, forces);
    if (status == VTI_OK)
        status = step_by(c, vti_stepper_find(large ? "srkn6" : "srkn11"), c->h, forces);
    return status == VTI_OK ? vti_multistep_record(past, &c->bodies) : status;
}

/** Where something touches: what, positions before a step, and for the start all bodies and the loads of its steps. */
struct touching {
    struct effect_surfaces surfaces;
    double *before, *loads; /* on the way back before is where it begins, */
    double *scratch;        /* and this memory for forces that are left out */
    vti_kept now;
    double memory[];
};

enum { KEPT = 19, LOADS = 6 };

static int prepare_multistep(struct course *c, struct message *message)
{
    const size_t depth = (size_t)vti_multistep_at(c->rival - engines)->depth, n = (size_t)c->n;
    const struct effect_surfaces surfaces = model_surfaces(c->model);
    if (surfaces.contacts == NULL && surfaces.walls == NULL)
        return 0;
    struct touching *t = calloc(1, sizeof *t + (3 + 3 + KEPT + LOADS * depth) * n * sizeof(double));
    if (t == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", c->model->scene->name);
    t->surfaces = surfaces;
    t->before = t->memory;
    t->scratch = t->before + 3 * n;
    t->now.memory = t->scratch + 3 * n;
    t->now.width = KEPT;
    t->loads = t->now.memory + KEPT * n;
    c->tool = t;
    return 0;
}

static void dismiss_multistep(struct course *c)
{
    free(c->tool);
}

static void turn_back(double *v, int64_t n)
{
    for (int64_t k = 0; v != NULL && k < 3 * n; ++k)
        v[k] = -v[k];
}

/** Forces and moments to or from the loads of step k. */
static void move_loads(struct course *c, int64_t k, int put)
{
    const size_t size = (size_t)(3 * c->n) * sizeof(double);
    double *const now[2] = {c->f, c->m}, *const loads = ((struct touching *)c->tool)->loads + LOADS * c->n * k;
    for (int which = 0; which < 2; ++which)
        if (now[which] != NULL)
            memcpy(put ? now[which] : loads + which * 3 * c->n, put ? loads + which * 3 * c->n : now[which], size);
}

/** Those of what touches at the start, and all else. */
static int forces_back(struct course *c)
{
    const struct touching *t = c->tool;
    const int status = course_forces(c);
    if (status == VTI_OK)
        touches_take_new(&t->surfaces, t->before, &c->bodies, t->scratch);
    return status;
}

/** K - 1 steps back in time, which are then undone. */
static int start_back(struct course *c, const vti_multistep *m, vti_past *past)
{
    const int64_t depth = m->depth;
    struct touching *const t = c->tool;
    const vti_kept *const now = &t->now;
    struct step_errors *const errors = c->model->errors;
    c->model->errors = NULL; /* no steps of the run */
    int status = vti_step_keep(&c->bodies, now);
    memcpy(t->before, c->x, (size_t)(3 * c->n) * sizeof *t->before);
    turn_back(c->v, c->n);
    turn_back(c->w, c->n);
    for (int64_t k = 1; k < depth && status == VTI_OK; ++k) {
        status = start_step(c, m, past, forces_back);
        move_loads(c, k, 0);
    }
    c->model->errors = errors;
    past->known = 0;
    for (int64_t k = depth - 1; k > 0 && status == VTI_OK; --k) {
        move_loads(c, k, 1);
        status = vti_multistep_record(past, &c->bodies);
    }
    if (status == VTI_OK)
        status = vti_step_undo(&c->bodies, now);
    return status == VTI_OK ? vti_multistep_record(past, &c->bodies) : status;
}

static int step(struct course *c, const vti_multistep *m, vti_past *past)
{
    struct touching *const t = c->tool;
    if (t != NULL)
        memcpy(t->before, c->x, (size_t)(3 * c->n) * sizeof *t->before);
    const int status = multistep(c, m, past, course_forces);
    if (status != VTI_OK || t == NULL)
        return status;
    const vti_view before = vti_view_packed(t->before);
    return vti_multistep_touch(c->h, &before, t->surfaces.contacts, t->surfaces.walls, &c->bodies);
}

/** The numbers of the course: how many accelerations are known. */
static int go_multistep(struct course *c, int64_t steps)
{
    const vti_multistep *const m = vti_multistep_at(c->rival - engines);
    vti_past past = {c->own, m->depth, (int64_t)c->number[0]};
    int status = c->tool != NULL && past.known == 0 ? start_back(c, m, &past) : VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        const int starts = past.known < m->depth;
        status = starts ? start_step(c, m, &past, course_forces) : step(c, m, &past);
        if (starts)
            step_errors_part(c->model->errors); /* the next one may be by another method */
        c->number[0] = (double)past.known;
        c->steps += status == VTI_OK;
    }
    return status;
}

const struct rival *multistep_at(int64_t i)
{
    const vti_multistep *m = i < MOST ? vti_multistep_at(i) : NULL;
    if (m == NULL)
        return NULL;
    if (engines[i].go == NULL) {
        /* evaluations of a step vary, for the first ones take more */
        const struct rival engine = {
            .stepper = RIVAL_STEPPER(m->name, m->depth + (m->u == 0.0), 0.0, 0, m->reach, m->about),
            .own_width = 6 * m->depth,
            .prepare = prepare_multistep,
            .go = go_multistep,
            .dismiss = dismiss_multistep,
            .takes_forces = 1,
        };
        engines[i] = engine;
    }
    return &engines[i];
}
