/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the library has beside lists of kicks and drifts at equal steps, as programs run it.
 *
 * Multistep methods (EQUATIONS 8.1): K - 1 steps by others that are accurate enough, the accelerations remembered
 * before each, then one force evaluation a step. What they remember is all that they keep beside the bodies, so that a
 * checkpoint goes on with it. Where something touches, the K - 1 steps are back in time and undone, so that what begins
 * to touch at the start does so within a step of theirs, which takes off what it would miss of that.
 *
 * Steps by a tolerance (EQUATIONS 8.3), of the steppers that estimate their error: vti_control chooses them. The
 * tolerance is the scene's, or, where it has none, SHARE (h f)^(q+1), f the fastest there is, so that steps are in
 * proportion to h. The last step, cut to end where the caller wants to look, is undone before the next: so neither the
 * path nor the number of evaluations depends on how often somebody looks. */
#include "rival.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"
#include "step_errors.h"
#include "travel.h"

enum { MOST = 16, CONTROLLED = 3 };

static struct rival ways[MOST]; /* in the order of the library's table, filled in as they are asked for */

/* ---- multistep methods ------------------------------------------------------------------------------------------- */

/** When the step that is made ends. */
static double step_end(const struct course *c)
{
    return (double)(c->steps + 1) * c->h;
}

int course_step(struct course *c, const vti_stepper *by, double h)
{
    struct step_errors *const errors = c->model->errors;
    int status = step_errors_watch(errors, by, 0, h, &c->bodies);
    for (int64_t k = 0; k < by->stages && status == VTI_OK; ++k) {
        status = vti_step_stage(by, k, h, &c->bodies, &c->fault);
        if (status == VTI_OK)
            status = course_forces(c);
        if (status == VTI_OK)
            status = step_errors_watch(errors, by, k + 1, h, &c->bodies);
    }
    if (status == VTI_OK)
        status = vti_step_finish(by, h, &c->bodies);
    return status == VTI_OK && errors != NULL ? step_errors_end(errors, by, step_end(c), &c->bodies) : status;
}

static int take_error(struct course *c, const vti_multistep *m, const vti_past *past)
{
    double error[2];
    const int status = vti_multistep_error(m, c->h, past, &c->bodies, &error[0], &error[1]);
    if (status == VTI_OK)
        step_errors_take(c->model->errors, step_end(c), &c->bodies, error);
    return status;
}

static int multistep(struct course *c, const vti_multistep *m, vti_past *past)
{
    int status = vti_multistep_predict(m, c->h, past, &c->bodies, &c->fault);
    if (status == VTI_OK)
        status = course_forces(c);
    if (status == VTI_OK && c->model->errors != NULL)
        status = take_error(c, m, past);
    return status == VTI_OK ? vti_multistep_correct(m, c->h, past, &c->bodies) : status;
}

/** A step of the start, K - 1 of them: of methods that are stable at large steps up to four by srkn6, and then one each
 *  by AN(5), AN(6) ..., which evaluate once; of others all by srkn11. Their orders are less than K, but at such steps
 *  they err by less than the rest of the way does, down to about 1e-11 by srkn6. */
static int start_step(struct course *c, const vti_multistep *m, vti_past *past)
{
    enum { GROWS_FROM = 5 };
    const int large = m->reach > 0.5;
    const vti_multistep grown = {.depth = past->known, .c = 1.0};
    int status = past->known == 0 ? vti_multistep_record(past, &c->bodies) : VTI_OK;
    if (status == VTI_OK && large && past->known >= GROWS_FROM)
        return multistep(c, &grown, past);
    if (status == VTI_OK)
        status = course_step(c, vti_stepper_find(large ? "srkn6" : "srkn11"), c->h);
    return status == VTI_OK ? vti_multistep_record(past, &c->bodies) : status;
}

/** Where something touches: what, positions before a step, and for the start all bodies and the loads of its steps. */
struct touching {
    struct effect_surfaces surfaces;
    double *before, *loads;
    vti_kept now;
    double memory[];
};

enum { KEPT = 19, LOADS = 6 };

static int prepare_multistep(struct course *c, struct message *message)
{
    const size_t depth = (size_t)vti_multistep_at(c->rival - ways)->depth, n = (size_t)c->n;
    struct effect_surfaces surfaces = {.contacts = NULL, .walls = NULL};
    for (int64_t k = 0; k < c->model->rooms_count; ++k)
        if (c->model->rooms[k].kind->surfaces != NULL)
            c->model->rooms[k].kind->surfaces(&c->model->rooms[k], &surfaces);
    if (surfaces.contacts == NULL && surfaces.walls == NULL)
        return 0;
    struct touching *t = calloc(1, sizeof *t + (3 + KEPT + LOADS * depth) * n * sizeof(double));
    if (t == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", c->model->scene->name);
    t->surfaces = surfaces;
    t->before = t->memory;
    t->now.memory = t->before + 3 * n;
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

/** K - 1 steps back in time, which are then undone. */
static int start_back(struct course *c, const vti_multistep *m, vti_past *past)
{
    const int64_t depth = m->depth;
    const vti_kept *const now = &((struct touching *)c->tool)->now;
    struct step_errors *const errors = c->model->errors;
    c->model->errors = NULL; /* no steps of the run */
    int status = vti_step_keep(&c->bodies, now);
    turn_back(c->v, c->n);
    turn_back(c->w, c->n);
    for (int64_t k = 1; k < depth && status == VTI_OK; ++k) {
        status = start_step(c, m, past);
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
    const int status = multistep(c, m, past);
    if (status != VTI_OK || t == NULL)
        return status;
    const vti_view before = vti_view_packed(t->before);
    return vti_multistep_touch(c->h, &before, t->surfaces.contacts, t->surfaces.walls, &c->bodies);
}

/** The numbers of the course: how many accelerations are known. */
static int go_multistep(struct course *c, int64_t steps)
{
    const vti_multistep *const m = vti_multistep_at(c->rival - ways);
    vti_past past = {c->own, m->depth, (int64_t)c->number[0]};
    int status = c->tool != NULL && past.known == 0 ? start_back(c, m, &past) : VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        const int starts = past.known < m->depth;
        status = starts ? start_step(c, m, &past) : step(c, m, &past);
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
    if (ways[i].go == NULL) {
        /* evaluations of a step vary, for the first ones take more */
        const struct rival way = {
            .stepper = RIVAL_STEPPER(m->name, m->depth + (m->u == 0.0), 0.0, 0, m->reach, m->about),
            .own_width = 6 * m->depth,
            .prepare = prepare_multistep,
            .go = go_multistep,
            .dismiss = dismiss_multistep,
            .takes_forces = 1,
        };
        ways[i] = way;
    }
    return &ways[i];
}

/* ---- steps by a tolerance ---------------------------------------------------------------------------------------- */

static const double share = 1e-6, shortest = 0x1p-40;

/** Numbers of a course: the tolerance, where it is and what it would try next, what programs are told of it, and
 *  whether the bodies are those of a step that was cut, with the evaluations that it took. A cut at the end of the run
 *  alone leaves no trace in them: the run may go on, as if it had not been. */
enum { TOLERANCE, TIME, STEP, HELD, LONGEST, ACCEPTED, REJECTED, CUT, IS_CUT, CUT_EVALS };
enum { NOT_CUT, CUT_TO_LOOK, CUT_AT_END }; /* IS_CUT */

/** Of own, a body's sums, its copy before the step, and its copy at the end of the last step that was not cut. */
enum { ROWS = 3, SUMS = 6 * ROWS, KEEPS = 19 };

static vti_kept kept_before(const struct course *c)
{
    const vti_kept kept = {c->own + SUMS * c->n, KEEPS};
    return kept;
}

static vti_kept kept_free(const struct course *c)
{
    const vti_kept kept = {c->own + (SUMS + KEEPS) * c->n, KEEPS};
    return kept;
}

static vti_control control_of(const struct course *c)
{
    vti_control control;
    vti_control_start(c->rival->table, c->number[TOLERANCE], c->number[STEP], &control);
    const struct scene *scene = c->model->scene;
    control.speed = scene->speed > 0.0 ? scene->speed : 1.0;
    control.turning = scene->turning > 0.0 ? scene->turning : 1.0;
    control.held = (int64_t)c->number[HELD];
    control.least = shortest * c->h;
    return control;
}

static int prepare_controlled(struct course *c, struct message *message)
{
    const vti_stepper *const by = c->rival->table;
    double most;
    c->number[STEP] = c->h;
    c->number[TOLERANCE] = c->model->scene->tolerance;
    if (c->number[TOLERANCE] > 0.0)
        return 0;
    if (course_fastest(c, &most, message) != 0)
        return -1;
    c->number[TOLERANCE] = share * plain_power(most, (int)by->estimate_order + 1);
    return 0;
}

/** A step, and what it errs by in v and in Omega. */
static int watched_step(struct course *c, double h, double error[2])
{
    const vti_stepper *const by = c->rival->table;
    const vti_errors errors = {c->own, ROWS};
    int status = vti_step_watch(by, 0, h, &c->bodies, &errors);
    for (int64_t k = 0; k < by->stages && status == VTI_OK; ++k) {
        status = vti_step_stage(by, k, h, &c->bodies, &c->fault);
        if (status == VTI_OK)
            status = course_forces(c);
        if (status == VTI_OK)
            status = vti_step_watch(by, k + 1, h, &c->bodies, &errors);
    }
    if (status == VTI_OK)
        status = vti_step_finish(by, h, &c->bodies);
    return status == VTI_OK ? vti_step_error(by, &c->bodies, &errors, &error[0], &error[1]) : status;
}

/** Of an accepted step that ends at t. Steps of other lengths err by other amounts: none is compared. */
static void take_controlled(struct course *c, double t, const double error[2])
{
    struct step_errors *const errors = c->model->errors;
    if (errors != NULL && c->number[IS_CUT] != NOT_CUT)
        step_errors_cut(errors, error);
    else if (errors != NULL)
        step_errors_take(errors, t, &c->bodies, error);
    step_errors_part(errors);
}

/** A step of h from t is tried, and undone if it is not accepted. One that fails is too long, until none is short
 *  enough. */
static int try_step(struct course *c, vti_control *control, double t, double h, int64_t *accepted)
{
    const vti_kept before = kept_before(c);
    double error[2] = {NAN, NAN};
    *accepted = 0;
    int status = vti_step_keep(&c->bodies, &before);
    if (status != VTI_OK)
        return status;
    status = watched_step(c, h, error);
    if (status != VTI_OK)
        error[0] = error[1] = NAN;
    const int judged = vti_control_judge(control, h, error[0], error[1], accepted);
    if (!*accepted)
        vti_step_undo(&c->bodies, &before);
    else
        take_controlled(c, t + h, error);
    return judged == VTI_OK || status == VTI_OK ? judged : status;
}

/** All steps that end before the time end. */
static int free_steps(struct course *c, double end)
{
    vti_control control = control_of(c);
    int status = VTI_OK;
    while (status == VTI_OK && c->number[TIME] + control.h < end) {
        const double h = control.h;
        int64_t accepted;
        status = try_step(c, &control, c->number[TIME], h, &accepted);
        if (accepted) {
            c->number[TIME] += h;
            c->number[LONGEST] = fmax(c->number[LONGEST], h);
        }
    }
    c->number[STEP] = control.h;
    c->number[HELD] = (double)control.held;
    c->number[ACCEPTED] += (double)control.accepted;
    c->number[REJECTED] += (double)control.rejected;
    return status;
}

/** From there to the time end, where the bodies are shown. */
static int cut_step(struct course *c, double end)
{
    vti_control control = control_of(c);
    double t = c->number[TIME];
    int status = VTI_OK;
    while (status == VTI_OK && t < end) {
        const double left = end - t, h = fmin(control.h, left);
        int64_t accepted;
        status = try_step(c, &control, t, h, &accepted);
        if (accepted)
            t = h < left ? t + h : end;
    }
    const int64_t tried = control.accepted + control.rejected;
    c->cut_at_end = c->ends ? tried : 0;
    c->number[CUT] += (double)(tried - c->cut_at_end);
    return status;
}

static int go_controlled(struct course *c, int64_t steps)
{
    const vti_kept kept = kept_free(c);
    const double end = (double)(c->steps + steps) * c->h;
    if (c->number[IS_CUT] != NOT_CUT)
        vti_step_undo(&c->bodies, &kept);
    step_errors_uncut(c->model->errors);
    c->evals -= (int64_t)c->number[CUT_EVALS];
    c->number[LONGEST] = c->number[IS_CUT] == CUT_AT_END ? c->number[LONGEST] : 0.0;
    c->number[IS_CUT] = NOT_CUT;
    int status = free_steps(c, end);
    const int64_t evals = c->evals;
    if (status == VTI_OK)
        status = vti_step_keep(&c->bodies, &kept);
    c->number[IS_CUT] = c->ends ? CUT_AT_END : CUT_TO_LOOK;
    if (status == VTI_OK)
        status = cut_step(c, end);
    c->number[CUT_EVALS] = (double)(c->evals - evals);
    c->steps += status == VTI_OK ? steps : 0;
    return status;
}

static void tally_controlled(const struct course *c, struct travel_tally *tally)
{
    const vti_stepper *const by = c->rival->table;
    const double *number = c->number;
    tally->accepted = (int64_t)number[ACCEPTED];
    tally->rejected = (int64_t)number[REJECTED];
    tally->cut = (int64_t)number[CUT] + c->cut_at_end;
    tally->evals = 1 + (tally->accepted + tally->rejected + tally->cut) * by->evals;
    tally->longest = c->steps > 0 ? fmax(number[LONGEST], fmin(number[STEP], (double)c->steps * c->h)) : 0.0;
    tally->tolerance = number[TOLERANCE];
}

const struct rival *controlled_at(int64_t i)
{
    static const char *const by[CONTROLLED] = {"srkn11", "srkn14", "srkn6"};
    static const char *const names[CONTROLLED] = {"srkn11-tol", "srkn14-tol", "srkn6-tol"};
    static const char *const about[CONTROLLED] = {
        "srkn11 with steps chosen by their errors: by the tolerance, or without one in proportion to h",
        "srkn14 with steps chosen by their errors: by the tolerance, or without one in proportion to h",
        "srkn6 with steps chosen by their errors: by the tolerance, or without one in proportion to h"};
    static struct rival controlled[CONTROLLED];
    if (i < 0 || i >= CONTROLLED)
        return NULL;
    if (controlled[i].go == NULL) {
        const vti_stepper *s = vti_stepper_find(by[i]);
        const struct rival way = {
            .stepper = RIVAL_STEPPER(names[i], s->order, 0.0, 0, NAN, about[i]),
            .table = s,
            .own_width = SUMS + 2 * KEEPS,
            .prepare = prepare_controlled,
            .go = go_controlled,
            .tally = tally_controlled,
            .takes_forces = 1,
        };
        controlled[i] = way;
    }
    return &controlled[i];
}
