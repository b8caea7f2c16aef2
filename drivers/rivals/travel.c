/* SPDX-License-Identifier: BSD-3-Clause */
#include "travel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rival.h"

/** Lists of kicks and drifts take spheres and bodies of three moments, others only the ones or the others. */
static int check_inertia(const struct rival *engine, const struct model *model, struct message *message)
{
    if (engine == NULL)
        return 0;
    if (engine->general == RIVAL_OF_BOTH)
        return 0;
    if (engine->general == RIVAL_OF_MOMENTS && model->bodies.moments.c[0] == NULL)
        return message_set(message,
                           "%s: %s moves bodies of three moments, and these have none; give bodies.moments, or take "
                           "one of the rivals that vti-run --list steppers names",
                           model->scene->name, engine->stepper.name);
    if (engine->general)
        return 0;
    const int controlled = method_rival(&engine->stepper) == NULL && engine->table != NULL;
    return model_of_spheres(model, controlled ? "step control" : engine->stepper.name,
                            controlled ? "leave --tolerance and --control out"
                                       : "run the scene by a stepper of kicks and drifts, such as vti2",
                            message);
}

/** Only lists of kicks and drifts flow and carry, and of those only the ones that never step back. */
int travel_check(const vti_stepper *stepper, const struct model *model, struct message *message)
{
    const struct rival *engine = method_engine(stepper);
    if (check_inertia(engine, model, message) != 0)
        return -1;
    const vti_effect *e = model_dissipates(model);
    if (e == NULL || (engine == NULL && vti_step_check(stepper, model->effects, model->effects_count) == VTI_OK))
        return 0;
    const char *const why = method_is_varied(stepper)
                                ? "a step that is undone would have dissipated already; leave control out"
                            : engine == NULL                ? "it has negative coefficients"
                            : method_rival(stepper) != NULL ? "rivals have forces alone"
                            : engine->table != NULL         ? "a step that is undone would have dissipated already"
                                                    : "a multistep method takes smooth forces of positions alone";
    return message_set(message,
                       "%s: %s dissipates, which the stepper %s cannot do: %s; take vti2, vti1, exact or chin4",
                       model->scene->name, e->name, stepper->name, why);
}

/** Steps of variable length, by a stepper that cannot make them. */
static int refuse_variable(const struct scene *scene, const char *stepper, struct message *message)
{
    if (scene->control != 0)
        return message_set(message,
                           "%s: control: the stepper %s is no reversible list of kicks and drifts with forces at its "
                           "own positions alone, whose steps may vary without drift; take srkn6, srkn11 or exact, or "
                           "leave control out",
                           scene->name, stepper);
    return message_set(message,
                       "%s: tolerance: the stepper %s has no estimate of its error to choose steps by; take srkn11, "
                       "srkn14 or srkn6, or leave the tolerance out",
                       scene->name, stepper);
}

int travel_create(struct travel *travel, const vti_stepper *stepper, struct model *model, double h,
                  struct message *message)
{
    memset(travel, 0, sizeof *travel);
    const char *const asked = stepper->name;
    stepper = method_for(model->scene, stepper);
    if (stepper == NULL)
        return refuse_variable(model->scene, asked, message);
    const struct rival *engine = method_engine(stepper);
    travel->stepper = stepper;
    travel->list = *stepper;
    travel->list.rotor = model->scene->rotor != 0 ? model->scene->rotor : stepper->rotor;
    travel->model = model;
    travel->h = h;
    if (!(h > 0.0) || !isfinite(h))
        return message_set(message, "%s: h = %g is not a step; it has to be finite and > 0", stepper->name, h);
    if (travel_check(stepper, model, message) != 0)
        return -1;
    if (engine != NULL) {
        travel->course = course_create(engine, model, h, message);
        if (travel->course == NULL)
            return -1;
    }
    if (stepper->lag == 0.0)
        return 0;
    travel->copies = calloc((size_t)(9 * model->bodies.count), sizeof *travel->copies);
    if (travel->copies != NULL)
        return 0;
    travel_destroy(travel);
    return scene_no_memory(model->scene, message);
}

void travel_destroy(struct travel *travel)
{
    course_destroy(travel->course);
    free(travel->copies);
    memset(travel, 0, sizeof *travel);
}

int64_t travel_force_evals(const struct travel *travel)
{
    if (travel->course != NULL)
        return travel->course->evals;
    return travel->steps > 0 ? 1 + travel->steps * travel->stepper->evals : 0;
}

int travel_tally(const struct travel *travel, struct travel_tally *tally)
{
    if (travel->course == NULL || travel->course->rival->tally == NULL)
        return 0;
    travel->course->rival->tally(travel->course, tally);
    return 1;
}

int64_t travel_pause(const struct travel *travel, int64_t moves)
{
    struct travel_tally varied;
    return travel_tally(travel, &varied) ? 1 : 1 + moves / (travel->model->bodies.count + 1);
}

double *travel_state(struct travel *travel, int64_t *count)
{
    struct course *course = travel->course;
    *count = course != NULL ? course->memory_doubles : 0;
    return course != NULL ? course->memory : NULL;
}

void travel_resume(struct travel *travel, int64_t steps)
{
    travel->steps = steps;
    if (travel->course != NULL)
        travel->course->steps = steps;
}

/** A copy of the view at p, if there is one. */
static vti_view copied(const vti_view *from, int64_t n, double *p)
{
    if (from->c[0] == NULL)
        return *from;
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            p[3 * i + k] = from->c[k][i * from->stride];
    return vti_view_packed(p);
}

/** v and Omega of a lagging stepper are of t - lag h, and its forces of t: kick(lag h). */
vti_bodies travel_bodies(struct travel *travel)
{
    vti_bodies b = travel->course != NULL ? *course_bodies(travel->course) : travel->model->bodies;
    if (travel->copies == NULL || travel->steps == 0)
        return b;
    b.v = copied(&b.v, b.count, travel->copies);
    b.omega = copied(&b.omega, b.count, travel->copies + 3 * b.count);
    b.spin = copied(&b.spin, b.count, travel->copies + 6 * b.count);
    b.v_low = b.omega_low = b.spin_low = vti_view_none();
    vti_kick(travel->stepper->lag * travel->h, &b);
    return b;
}

/* ---- observers of a rival ---------------------------------------------------------------------------------------- */

/** The bodies with the attitude as alpha, in the model's own memory, which a rival leaves alone. */
static vti_bodies turned_to_alpha(const struct travel *travel, vti_bodies b)
{
    for (int64_t i = 0; b.quat.xyzw[0] != NULL && i < b.count; ++i) {
        double q[4], alpha[3];
        for (int k = 0; k < 4; ++k)
            q[k] = b.quat.xyzw[k][i * b.quat.stride];
        vti_rrv_from_quat_xyzw(q, alpha);
        for (int k = 0; k < 3; ++k)
            travel->model->bodies.alpha.c[k][i * travel->model->bodies.alpha.stride] = alpha[k];
    }
    b.alpha = travel->model->bodies.alpha;
    for (int k = 0; k < 4; ++k)
        b.quat.xyzw[k] = NULL;
    return b;
}

static int is_due(const struct observer *observer, int64_t step, int64_t last)
{
    return step % observer->every == 0 || step == last;
}

/** *kept sees what b sees. Sealed the first time: from then on only addresses of like memory change. */
static const vti_bodies *keep_seen(vti_bodies *kept, vti_bodies b)
{
    b.sealed = kept->sealed;
    *kept = b;
    if (kept->sealed == 0)
        vti_bodies_seal(kept);
    return kept;
}

/** sooner: before the step at which somebody is due, to those who want that. */
static int show(struct travel *travel, int sooner, int64_t last, const struct observer *observers, int n)
{
    const vti_bodies *in_time = keep_seen(&travel->seen[0], turned_to_alpha(travel, travel_bodies(travel))),
                     *raw = keep_seen(&travel->seen[1], turned_to_alpha(travel, *course_bodies(travel->course)));
    for (int k = 0; k < n; ++k)
        if ((sooner ? observers[k].wants != NULL : is_due(&observers[k], travel->steps, last)) &&
            observers[k].see(observers[k].self, travel->steps, (double)travel->steps * travel->h,
                             observers[k].raw ? raw : in_time) != 0)
            return 1;
    return 0;
}

/** Steps to where somebody looks next. */
static int64_t steps_to_look(int64_t step, int64_t last, const struct observer *observers, int n)
{
    int64_t next = last - step;
    for (int k = 0; k < n; ++k) {
        const int64_t left = observers[k].every - step % observers[k].every;
        next = left < next ? left : next;
    }
    return next;
}

/** Whether somebody looks there who would if the run went on. */
static int is_looked_at(int64_t step, const struct observer *observers, int n)
{
    int looked = n == 0;
    for (int k = 0; k < n; ++k)
        looked |= step % observers[k].every == 0;
    return looked;
}

static const struct observer *who_wants(const struct observer *observers, int n)
{
    for (int k = 0; k < n; ++k)
        if (observers[k].wants != NULL)
            return &observers[k];
    return NULL;
}

static int course_show(struct travel *travel, int64_t last, const struct observer *observers, int n,
                       struct message *message)
{
    if (travel->steps > 0 && course_begin(travel->course, message) != 0)
        return -1;
    int stopped = n > 0 && show(travel, 0, last, observers, n);
    while (!stopped && travel->steps < last) {
        const int64_t steps = steps_to_look(travel->steps, last, observers, n);
        travel->course->ends = !is_looked_at(travel->steps + steps, observers, n);
        travel->course->wants = who_wants(observers, n);
        if (course_go(travel->course, steps, message) != 0)
            return -1;
        const int64_t made = travel->course->rival->tally != NULL ? travel->course->steps - travel->steps : steps;
        travel->steps += made;
        stopped = n > 0 && show(travel, made < steps, last, observers, n);
    }
    return stopped;
}

int travel_show(struct travel *travel, int64_t steps, const struct observer *observers, int observers_count,
                struct message *message)
{
    const int64_t last = travel->steps + steps;
    if (steps < 0 || (steps == 0 && observers_count == 0))
        return 0;
    if (travel->course != NULL)
        return course_show(travel, last, observers, observers_count, message);
    const int result =
        loop_run(travel->model, &travel->list, travel->h, travel->steps, last, observers, observers_count, message);
    travel->steps = result == 0 ? last : travel->steps;
    return result;
}

int travel_go(struct travel *travel, int64_t steps, struct message *message)
{
    return travel_show(travel, steps, NULL, 0, message);
}
