/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps by a tolerance (EQUATIONS 8.3), of the steppers that estimate their error: vti_control chooses them. The
 * tolerance is the scene's, or, where it has none, SHARE (h f)^(q+1), f the fastest there is, so that steps are in
 * proportion to h; not less than rounding. */
#include <float.h>
#include <math.h>

#include "cut.h"
#include "number.h"
#include "plain.h"
#include "rivals.h"
#include "scene.h"
#include "step_errors.h"
#include "travel.h"

enum { CONTROLLED = 3 };

static const double share = 1e-6;

/** Numbers of a course: the tolerance, where it is and what it would try next, what programs are told of it, and
 *  whether the bodies are those of a step that was cut, with the evaluations that it took. */
enum { TOLERANCE, TIME, STEP, HELD, LONGEST, ACCEPTED, REJECTED, CUT, IS_CUT, CUT_EVALS };

/** Of own, a body's sums, its copy before the step, and its copy at the end of the last step that was not cut. */
enum { ROWS = 3, SUMS = 6 * ROWS };

static vti_control control_of(const struct course *c)
{
    vti_control control;
    vti_control_start(c->rival->table, c->number[TOLERANCE], c->number[STEP], &control);
    const struct scene *scene = c->model->scene;
    control.speed = scene_unit(scene->speed);
    control.turning = scene_unit(scene->turning);
    control.held = (int64_t)c->number[HELD];
    control.least = CUT_SHORTEST * c->h;
    control.most = c->longest;
    return control;
}

/** Where in the step forces are taken for the k-th time, from 0 to 1. */
static double place_of(const vti_stepper *by, int64_t k)
{
    return k > 0 ? place_of(by, k - 1) + by->drift[k] : by->drift[0];
}

/** The largest part of steps, one after the other, in which forces are not taken. */
static double gap_of(const vti_stepper *by)
{
    double gap = 0.0;
    for (int64_t k = 0; k < by->stages; ++k) {
        double next = 1.0;
        for (int64_t j = 0; j < by->stages; ++j) {
            const double ahead = place_of(by, j) - place_of(by, k);
            next = fmin(next, ahead > 0.0 ? ahead : ahead + 1.0);
        }
        gap = fmax(gap, next);
    }
    return gap;
}

/** What rounding leaves of the largest velocity and spin at the start, in the units of the tolerance. */
static double rounding_of(const struct course *c)
{
    const struct scene *scene = c->model->scene;
    double most = 0.0;
    for (int64_t i = 0; i < c->n; ++i) {
        if (c->v != NULL)
            most = fmax(most, vti_norm(c->v + 3 * i) / scene_unit(scene->speed));
        if (c->w != NULL)
            most = fmax(most, vti_norm(c->w + 3 * i) / scene_unit(scene->turning));
    }
    return 0.5 * DBL_EPSILON * most;
}

static int prepare_controlled(struct course *c, struct message *message)
{
    const vti_stepper *const by = c->rival->table;
    const char *const kinked = scene_first_with(c->model->scene, EFFECT_KINKED);
    const double rounding = rounding_of(c);
    double most;
    if (kinked != NULL && by->drift[by->stages] != 0.0)
        return message_set(
            message,
            "%s: %s: steps of %s begin and end with a drift, and of a touch that begins there its estimated "
            "error says nothing; take srkn11 or srkn6 for steps by a tolerance",
            c->model->scene->name, kinked, by->name);
    if (course_longest(c, gap_of(by), message) != 0)
        return -1;
    c->number[STEP] = fmin(c->h, c->longest);
    c->number[TOLERANCE] = c->model->scene->tolerance;
    if (c->number[TOLERANCE] > 0.0 && c->number[TOLERANCE] < rounding)
        return message_set(message,
                           "%s: tolerance: %s is less than rounding leaves of velocities and spins, %.2g; give more",
                           c->model->scene->name, NUMBER(c->number[TOLERANCE]), rounding);
    if (c->number[TOLERANCE] > 0.0)
        return 0;
    if (course_fastest(c, &most, message) != 0)
        return -1;
    c->number[TOLERANCE] = fmax(rounding, share * plain_power(most, (int)by->estimate_order + 1));
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

/** The error, of v or what a touch would have changed that no evaluation has seen; NaN where that of v is. */
static double with_missed(const struct course *c, const vti_kept *before, double h, double error)
{
    const struct model *const model = c->model;
    const struct effect_way way = {before->memory, before->width, &c->bodies, h, c->gap};
    for (int64_t k = 0; k < model->instances_count && !model_has_clumps(model); ++k) {
        const struct effect *const e = &model->instances[k];
        const double missed = e->kind->missed != NULL ? e->kind->missed(e, &way) : 0.0;
        error = missed > error ? missed : error;
    }
    return error;
}

/** A step of h from t is tried, and undone if it is not accepted. One that fails is too long, until none is short
 *  enough; so is one that has passed a touch by, which errs by what that would have changed. */
static int try_step(struct course *c, vti_control *control, double t, double h, int64_t *accepted)
{
    const vti_kept before = cut_kept(c, SUMS);
    double error[2] = {NAN, NAN};
    *accepted = 0;
    if (!(t + h > t))
        return RIVAL_E_LATE;
    int status = vti_step_keep(&c->bodies, &before);
    if (status != VTI_OK)
        return status;
    status = watched_step(c, h, error);
    if (status != VTI_OK)
        error[0] = error[1] = NAN;
    else
        error[0] = with_missed(c, &before, h, error[0]);
    int judged = vti_control_judge(control, h, error[0], error[1], accepted);
    if (judged == VTI_E_CONTROL && h <= control->least) {
        judged = RIVAL_E_SHORT;
        c->fault.value = t;
    }
    if (!*accepted)
        vti_step_undo(&c->bodies, &before);
    else
        take_controlled(c, t + h, error);
    return judged == VTI_OK || status == VTI_OK ? judged : status;
}

/** All steps that end before so many of h. */
static int free_steps(struct course *c, int64_t *steps)
{
    vti_control control = control_of(c);
    int status = VTI_OK;
    while (status == VTI_OK && c->number[TIME] + control.h < cut_end(c, c->number[TIME], steps)) {
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
    const vti_kept kept = cut_kept(c, SUMS + KEEPS);
    if (c->number[IS_CUT] != NOT_CUT)
        vti_step_undo(&c->bodies, &kept);
    step_errors_uncut(c->model->errors);
    c->evals -= (int64_t)c->number[CUT_EVALS];
    c->number[LONGEST] = c->number[IS_CUT] == CUT_AT_END ? c->number[LONGEST] : 0.0;
    c->number[IS_CUT] = NOT_CUT;
    int status = free_steps(c, &steps);
    const int64_t evals = c->evals;
    if (status == VTI_OK)
        status = vti_step_keep(&c->bodies, &kept);
    c->number[IS_CUT] = c->ends ? CUT_AT_END : CUT_TO_LOOK;
    if (status == VTI_OK)
        status = cut_step(c, (double)(c->steps + steps) * c->h);
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
    tally->longest = cut_longest(c, number[LONGEST], number[STEP]);
    tally->tolerance = number[TOLERANCE];
}

const struct rival *tolerance_at(int64_t i)
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
        const struct rival engine = {
            .stepper = RIVAL_STEPPER(names[i], s->order, 0.0, 0, NAN, about[i]),
            .table = s,
            .own_width = SUMS + 2 * KEEPS,
            .prepare = prepare_controlled,
            .go = go_controlled,
            .tally = tally_controlled,
            .takes_forces = 1,
        };
        controlled[i] = engine;
    }
    return &controlled[i];
}
