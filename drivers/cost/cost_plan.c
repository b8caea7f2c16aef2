/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "loop.h"
#include "number.h"
#include "tables.h"

/* ---- comma lists ------------------------------------------------------------------------------------------------- */

/** Takes the next part of a list into part; *list moves on, to NULL after the last. Returns 0, or -1 if it is too
 *  long. */
static int next_part(const char **list, char *part, size_t size)
{
    const char *comma = strchr(*list, ',');
    const size_t length = comma != NULL ? (size_t)(comma - *list) : strlen(*list);
    const int fits = length < size;
    memcpy(part, *list, fits ? length : size - 1);
    part[fits ? length : size - 1] = '\0';
    *list = comma != NULL ? comma + 1 : NULL;
    return fits ? 0 : -1;
}

/* ---- methods ----------------------------------------------------------------------------------------------------- */

/** Its bodies have three moments. */
static int is_general(const struct scene *scene)
{
    return scene->moments[0] != 0.0 || scene->clumps.given ||
           (scene->tables != NULL && table_has(&scene->tables->bodies, BODY_MOMENTS));
}

static int is_listed(const struct cost_plan *plan, const vti_stepper *method)
{
    int64_t i = 0;
    while (i < plan->methods_count && plan->methods[i] != method)
        ++i;
    return i < plan->methods_count;
}

int cost_plan_methods(struct cost_plan *plan, const char *list, struct message *message)
{
    int64_t general = 0;
    for (int64_t c = 0; c < plan->cases_count; ++c)
        general += is_general(plan->cases[c].scene);
    plan->methods_count = 0;
    for (int64_t i = 0; list == NULL && general < plan->cases_count && method_at(i) != NULL; ++i)
        plan->methods[plan->methods_count++] = method_at(i);
    if (plan->methods_count > 0) /* of those with steps by a tolerance the cheapest */
        plan->methods[plan->methods_count++] = method_find("srkn11-tol");
    for (int64_t i = 0; list == NULL && general > 0 && method_general_at(i) != NULL; ++i)
        if (!is_listed(plan, method_general_at(i)))
            plan->methods[plan->methods_count++] = method_general_at(i);
    if (list != NULL)
        plan->methods_count = methods_read("--steppers", list, plan->methods, COST_METHODS, message);
    return plan->methods_count > 0 ? 0 : -1;
}

/* ---- scenes and their ends --------------------------------------------------------------------------------------- */

static int add_case(struct cost_plan *plan, const struct scene *scene, double t_end, int several,
                    struct message *message)
{
    if (plan->cases_count == COST_CASES)
        return message_set(message, "%s: more than %d scenes and ends; use fewer at a time", scene->name, COST_CASES);
    if (scene->tolerance > 0.0)
        return message_set(
            message,
            "%s: tolerance: a cost study finds the tolerances by itself; leave it out and name srkn11-tol "
            "in --steppers",
            scene->name);
    if (scene->control != 0)
        return message_set(message, "%s: control: a cost study is of steps of one length; leave it out", scene->name);
    struct cost_case *c = &plan->cases[plan->cases_count];
    c->scene = scene;
    c->t_end = t_end;
    if (several)
        snprintf(c->name, sizeof c->name, "%s-%.10g", scene->name, t_end);
    else
        snprintf(c->name, sizeof c->name, "%s", scene->name);
    for (int64_t k = 0; k < plan->cases_count; ++k)
        if (strcmp(plan->cases[k].name, c->name) == 0)
            return message_set(
                message, "%s: appears twice; name every scene once, with all its ends: SCENE.yaml@10,100", c->name);
    ++plan->cases_count;
    return 0;
}

int cost_plan_add(struct cost_plan *plan, const struct scene *scene, const char *ends, const char *what,
                  struct message *message)
{
    if (ends == NULL)
        return add_case(plan, scene, scene->t_end, 0, message);
    const int several = strchr(ends, ',') != NULL;
    while (ends != NULL) {
        char text[64];
        double t_end;
        if (next_part(&ends, text, sizeof text) != 0 || number_read(text, &t_end) != 0 || !(t_end > 0.0))
            return message_set(message, "%s: '%s' is not a positive number; write 10, 1e3 or a list 10,100", what,
                               text);
        if (add_case(plan, scene, t_end, several, message) != 0)
            return -1;
    }
    return 0;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

int cost_plan_steps(struct cost_plan *plan, const char *list, struct message *message)
{
    plan->h_count = ladder_read(list, plan->h, message);
    for (int64_t k = 0; k < plan->h_count; ++k)
        for (int64_t c = 0; c < plan->cases_count; ++c) {
            const double steps = plan->cases[c].t_end / plan->h[k];
            if (steps > LOOP_STEPS)
                return message_set(message,
                                   "--h: t_end = %s of %s is more than 2^53 steps of h = %s; use a larger step",
                                   NUMBER(plan->cases[c].t_end), plan->cases[c].name, NUMBER(plan->h[k]));
            if (rint(steps) < 1.0 || fabs(steps - rint(steps)) > 1e-9 * steps)
                return message_set(message, "--h: %s does not divide the end t = %s of %s; use a whole fraction",
                                   NUMBER(plan->h[k]), NUMBER(plan->cases[c].t_end), plan->cases[c].name);
        }
    return plan->h_count > 0 ? 0 : -1;
}
