/* SPDX-License-Identifier: BSD-3-Clause
 * Masses and inertias that a step can divide by. The core would refuse others too, and could name neither key nor
 * row. */
#include <stdio.h>

#include "model_parts.h"
#include "number.h"

/** What is looked at: where it stands, or what it follows from. */
struct sought {
    const struct model *model;
    const struct tables *tables;
    const vti_scalars *mass; /* of each, whether bodies translate or not; p = NULL: model->mass */
    struct message *message;
};

/** A product that has underflowed to 0 is no property of the model. */
static double value_of(const vti_scalars *s, double of_all, int64_t i)
{
    return s->p != NULL ? s->p[i * s->stride] : of_all;
}

/** "b.csv:3: SOURCE is too small ...", or where all bodies have it by the scene, or clumps take turns, "t: SOURCE ...".
 *  or_else: what else might be given. */
static int refuse(const struct sought *s, int64_t row, double value, const char *source, const char *or_else)
{
    const struct scene *scene = s->model->scene;
    const char *is = value > 1.0 ? "large" : "small", *wanted = value > 1.0 ? "smaller" : "larger";
    if (row >= 0 && scene->arrangement == SCENE_IN_TABLE)
        return table_fail(&s->tables->bodies, row, s->message,
                          "%s too %s to divide by; choose units in which it is %s%s", source, is, wanted, or_else);
    return message_set(s->message, "%s: %s too %s to divide by; choose units in which it is %s%s", scene->name, source,
                       is, wanted, or_else);
}

static int refuse_mass(const struct sought *s, int64_t i, double mass)
{
    const struct scene *scene = s->model->scene;
    const struct table *t = &s->tables->bodies;
    char source[160];
    if (scene->clumps.density != 0.0)
        snprintf(source, sizeof source, "bodies.clumps.density: '%s' gives a mass of %s, which is",
                 NUMBER(scene->clumps.density), NUMBER(mass));
    else if (scene->density != 0.0)
        snprintf(source, sizeof source, "bodies.density: '%s' and the diameter %s give a mass of %s, which is",
                 NUMBER(scene->density), NUMBER(value_of(&s->model->diameter, s->model->sphere, i)), NUMBER(mass));
    else
        snprintf(source, sizeof source, "%s: '%s' is", table_has(t, BODY_MASS) ? "mass" : "bodies.mass", NUMBER(mass));
    return refuse(s, s->mass->p != NULL && s->mass->stride != 0 ? i : -1, mass, source, "");
}

static int refuse_inertia(const struct sought *s, int64_t i, double inertia)
{
    const struct model *m = s->model;
    const struct table *t = &s->tables->bodies;
    const double mass = value_of(s->mass, m->mass, i);
    const char *or_else = "";
    char source[200];
    if (m->scene->clumps.given)
        snprintf(source, sizeof source,
                 "bodies.clumps: spheres of the mass %s in all give a moment of inertia of %s, which is", NUMBER(mass),
                 NUMBER(inertia));
    else if (m->scene->inertia != 0.0 || table_has(t, BODY_INERTIA))
        snprintf(source, sizeof source, "%s: '%s' is", table_has(t, BODY_INERTIA) ? "inertia" : "bodies.inertia",
                 NUMBER(inertia));
    else {
        snprintf(source, sizeof source, "bodies.inertia: the mass %s and the diameter %s give %s, which is",
                 NUMBER(mass), NUMBER(value_of(&m->diameter, m->sphere, i)), NUMBER(inertia));
        or_else = ", or give it";
    }
    return refuse(s, m->bodies.inertia.p == NULL || m->bodies.inertia.stride != 0 ? i : -1, inertia, source, or_else);
}

/** A moment of body i that nothing can be divided by; 1 if there is none. */
static double bad_moment(const vti_bodies *b, int64_t i)
{
    double bad = 1.0;
    for (int k = 0; k < 3; ++k)
        if (!number_divides(b->moments.c[k][i * b->moments.stride]))
            bad = b->moments.c[k][i * b->moments.stride];
    return bad;
}

int model_check_masses(const struct model *model, const struct tables *tables, const vti_scalars *mass,
                       struct message *message)
{
    const struct sought sought = {model, tables, mass, message};
    const vti_bodies *b = &model->bodies;
    const int general = b->moments.c[0] != NULL;
    for (int64_t i = 0; i < b->count; ++i) {
        const double m = value_of(mass, model->mass, i);
        if (model->translates && !number_divides(m))
            return refuse_mass(&sought, i, m);
        const double J = !model->turns ? 1.0 : general ? bad_moment(b, i) : value_of(&b->inertia, model->inertia, i);
        if (!number_divides(J))
            return refuse_inertia(&sought, i, J);
    }
    return 0;
}
