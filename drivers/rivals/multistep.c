/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Multistep methods (EQUATIONS 8.1), as programs run them: one force evaluation a step. What they remember is all that
 * they keep beside the bodies, so that a checkpoint goes on with it. They begin with K - 1 steps by others back in
 * time, which are undone once their accelerations are remembered: what those steps err by is no error of the run, and
 * what touches at the start begins to within a step of theirs, which takes off what it would miss of that. What does
 * not touch at the start does not on the way back: bodies that have just parted would meet there. */
#include "rival.h"

#include <assert.h>
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

/* ---- the start --------------------------------------------------------------------------------------------------- */

/** Where something may touch, and what the start needs, which is given back after it. */
struct start {
    struct effect_surfaces surfaces;
    double *loads;   /* of its steps */
    double *scratch; /* forces that are left out */
    vti_kept now;
    double before[]; /* positions at the start; later before each step */
};

enum { KEPT = 19, LOADS = 6 };

static int prepare_multistep(struct course *c, struct message *message)
{
    const size_t depth = (size_t)vti_multistep_at(c->rival - engines)->depth, n = (size_t)c->n;
    struct start *s = calloc(1, sizeof *s + 3 * n * sizeof(double));
    c->tool = s;
    if (s != NULL)
        s->loads = malloc((LOADS * depth + 3 + KEPT) * n * sizeof(double));
    if (s == NULL || s->loads == NULL)
        return scene_no_memory(c->model->scene, message);
    s->surfaces = model_surfaces(c->model);
    s->scratch = s->loads + LOADS * depth * n;
    s->now.memory = s->scratch + 3 * n;
    s->now.width = KEPT;
    return 0;
}

static void end_start(struct start *s)
{
    free(s->loads);
    s->loads = NULL;
}

static void dismiss_multistep(struct course *c)
{
    if (c->tool != NULL)
        end_start(c->tool);
    free(c->tool);
}

static int may_touch(const struct start *s)
{
    return s->surfaces.contacts != NULL || s->surfaces.walls != NULL;
}

static void remember_positions(struct course *c)
{
    struct start *s = c->tool;
    if (may_touch(s))
        memcpy(s->before, c->x, (size_t)(3 * c->n) * sizeof *c->x);
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
    double *const now[2] = {c->f, c->m}, *const loads = ((struct start *)c->tool)->loads + LOADS * c->n * k;
    for (int which = 0; which < 2; ++which)
        if (now[which] != NULL)
            memcpy(put ? now[which] : loads + which * 3 * c->n, put ? loads + which * 3 * c->n : now[which], size);
}

/** Those of what touches at the start, and all else. */
static int forces_back(struct course *c)
{
    const struct start *s = c->tool;
    const int status = course_forces(c);
    if (status == VTI_OK && may_touch(s))
        touches_take_new(&s->surfaces, s->before, &c->bodies, s->scratch);
    return status;
}

/** A step back: where steps are large the first four by chin4's list without its gradient, two evaluations each, where
 *  they are small the first six by srkn6; and then one each by AN(5), or AN(7), and so on, which evaluate once. All are
 *  of orders below K, and the first of order 2: but what they err by grows smoothly from 0 with the way back, and of
 *  that the sums of K accelerations see only what their ends leave (an9 keeps its order on the chain down to 1e-12, on
 *  a heavy pendulum down to 1e-9). */
static int step_back(struct course *c, const vti_multistep *m, vti_past *past)
{
    const int large = m->reach > 0.5;
    const int64_t by_list = large ? 4 : 6;
    const vti_multistep grown = {.depth = past->known, .c = 1.0};
    vti_stepper list = *vti_stepper_find(large ? "chin4" : "srkn6");
    int status = past->known == 0 ? vti_multistep_record(past, &c->bodies) : VTI_OK;
    list.probe = NULL;
    if (status == VTI_OK && past->known > by_list)
        return multistep(c, &grown, past, forces_back);
    if (status == VTI_OK)
        status = step_by(c, &list, c->h, forces_back);
    return status == VTI_OK ? vti_multistep_record(past, &c->bodies) : status;
}

/** The steps back, and what they leave in the past: their loads, the earliest first. */
static int go_back(struct course *c, const vti_multistep *m, vti_past *past)
{
    int status = VTI_OK;
    for (int64_t k = 1; k < m->depth && status == VTI_OK; ++k) {
        status = step_back(c, m, past);
        move_loads(c, k, 0);
    }
    past->known = 0;
    for (int64_t k = m->depth - 1; k > 0 && status == VTI_OK; --k) {
        move_loads(c, k, 1);
        status = vti_multistep_record(past, &c->bodies);
    }
    return status;
}

static int begin(struct course *c, const vti_multistep *m, vti_past *past)
{
    struct start *const s = c->tool;
    struct step_errors *const errors = c->model->errors;
    int status = vti_step_keep(&c->bodies, &s->now);
    if (status != VTI_OK)
        return status;
    remember_positions(c);
    turn_back(c->v, c->n);
    turn_back(c->w, c->n);
    c->model->errors = NULL; /* these are no steps of the run */
    status = go_back(c, m, past);
    c->model->errors = errors;
    const int undone = vti_step_undo(&c->bodies, &s->now);
    end_start(s);
    if (status == VTI_OK)
        status = undone;
    return status == VTI_OK ? vti_multistep_record(past, &c->bodies) : status;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static int step(struct course *c, const vti_multistep *m, vti_past *past)
{
    struct start *const s = c->tool;
    remember_positions(c);
    const int status = multistep(c, m, past, course_forces);
    if (status != VTI_OK || !may_touch(s))
        return status;
    const vti_view before = vti_view_packed(s->before);
    return vti_multistep_touch(c->h, &before, s->surfaces.contacts, s->surfaces.walls, &c->bodies);
}

/** The numbers of the course: how many accelerations are known. */
static int go_multistep(struct course *c, int64_t steps)
{
    const vti_multistep *const m = vti_multistep_at(c->rival - engines);
    vti_past past = {c->own, m->depth, (int64_t)c->number[0]};
    int status = past.known == 0 ? begin(c, m, &past) : VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        status = step(c, m, &past);
        c->number[0] = (double)past.known;
        c->steps += status == VTI_OK;
    }
    return status;
}

const struct rival *multistep_at(int64_t i)
{
    const vti_multistep *m = vti_multistep_at(i);
    if (m == NULL)
        return NULL;
    assert(i < MOST);
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
