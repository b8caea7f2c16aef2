/* SPDX-License-Identifier: BSD-3-Clause */
#include "method.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "loop.h"
#include "rival.h"

/* ---- what there is --------------------------------------------------------------------------------------------------- */

enum { METHODS_MAX = 64 };

static struct method methods[METHODS_MAX];
static int64_t methods_count, methods_all; /* those that are listed, and with those that are only found by name */

static struct method of_stepper(const vti_stepper *s)
{
    const int is_paper = strncmp(s->name, "vti", 3) == 0;
    const struct method method = {s->name, is_paper ? "paper" : "ours", s->about, s->order, s, NULL};
    return method;
}

static struct method of_rival(const struct rival *r)
{
    const struct method method = {r->name, "rival", r->about, r->order, NULL, r};
    return method;
}

static void collect(void)
{
    for (int64_t i = 0; i < vti_stepper_count() && methods_count < METHODS_MAX; ++i)
        if (vti_stepper_at(i)->frame == VTI_FRAME_SPACE)
            methods[methods_count++] = of_stepper(vti_stepper_at(i));
    for (int64_t i = 0; i < rival_count() && methods_count < METHODS_MAX; ++i)
        methods[methods_count++] = of_rival(rival_at(i));
    methods_all = methods_count;
    for (int64_t i = 0; rival_unlisted(i) != NULL && methods_all < METHODS_MAX; ++i)
        methods[methods_all++] = of_rival(rival_unlisted(i));
}

int64_t method_count(void)
{
    if (methods_count == 0)
        collect();
    return methods_count;
}

const struct method *method_at(int64_t i)
{
    return i >= 0 && i < method_count() ? &methods[i] : NULL;
}

const struct method *method_find(const char *name)
{
    if (methods_count == 0)
        collect();
    for (int64_t i = 0; name != NULL && i < methods_all; ++i)
        if (strcmp(name, methods[i].name) == 0)
            return &methods[i];
    return NULL;
}

/* ---- on the way ------------------------------------------------------------------------------------------------------ */

int travel_create(struct travel *travel, const struct method *method, struct model *model, double h,
                  struct message *message)
{
    memset(travel, 0, sizeof *travel);
    travel->method = method;
    travel->model = model;
    travel->h = h;
    if (!(h > 0.0) || !isfinite(h))
        return message_set(message, "%s: h = %g is not a step; it has to be finite and > 0", method->name, h);
    travel->lag = method->rival != NULL ? method->rival->lag : method->stepper->lag;
    if (method->rival != NULL) {
        travel->course = course_create(method->rival, model, h, message);
        if (travel->course == NULL)
            return -1;
    }
    if (travel->lag == 0.0)
        return 0;
    travel->copies = calloc((size_t)(6 * model->bodies.count), sizeof *travel->copies);
    if (travel->copies != NULL)
        return 0;
    travel_destroy(travel);
    return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
}

void travel_destroy(struct travel *travel)
{
    course_destroy(travel->course);
    free(travel->copies);
    memset(travel, 0, sizeof *travel);
}

int travel_go(struct travel *travel, int64_t steps, struct message *message)
{
    const vti_stepper *stepper = travel->method->stepper;
    if (steps <= 0)
        return 0;
    const int64_t to = travel->steps + steps;
    if (stepper == NULL) {
        if (course_go(travel->course, steps, message) != 0)
            return -1;
    } else {
        if (loop_run(travel->model, stepper, travel->h, travel->steps, to, NULL, 0, message) != 0)
            return -1;
        travel->force_evals = 1 + to * stepper->evals;
    }
    travel->steps = to;
    return 0;
}

int64_t travel_force_evals(const struct travel *travel)
{
    return travel->course != NULL ? travel->course->evals : travel->force_evals;
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

/** v and Omega of a lagging method are of t - lag h, and its forces of t: kick(lag h). */
vti_bodies travel_bodies(struct travel *travel)
{
    vti_bodies b = travel->course != NULL ? *course_bodies(travel->course) : travel->model->bodies;
    if (travel->copies == NULL || travel->steps == 0)
        return b;
    b.sealed = 0;
    b.v = copied(&b.v, b.count, travel->copies);
    b.omega = copied(&b.omega, b.count, travel->copies + 3 * b.count);
    b.v_low = b.omega_low = vti_view_none();
    vti_kick(travel->lag * travel->h, &b);
    return b;
}
