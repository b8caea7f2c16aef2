/* SPDX-License-Identifier: BSD-3-Clause */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"
#include "plain.h"

/* ---- how far bodies get from rest ------------------------------------------------------------------------------------- */

static void load(const vti_view *view, int64_t i, double r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = view->c[0] != NULL ? view->c[k][i * view->stride] : 0.0;
}

static double scalar(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** How far body i falls along g until its surface meets the first plane in its way; 0 if none is. */
static double fall(const struct model *model, const vti_bodies *bodies, int64_t i)
{
    const double *g = model->scene->gravity.g, length = vti_norm(g);
    const double radius = 0.5 * scalar(&model->diameter, i);
    double least = INFINITY, centre[3];
    load(&bodies->x, i, centre);
    for (int64_t w = 0; w < model->walls.count; ++w) {
        const double *plane = model->walls.plane + 4 * w, towards = -vti_dot(plane, g) / length;
        if (towards > 0.0)
            least = fmin(least, fmax(vti_dot(plane, centre) - plane[3] - radius, 0.0) / towards);
    }
    return isfinite(least) ? least : 0.0;
}

/** The velocity of the centre of mass, which deforms nothing unless it meets a wall. */
static void velocity_of_whole(const struct model *model, const vti_bodies *b, double whole[3])
{
    double mass = 0.0, momentum[3] = {0.0, 0.0, 0.0};
    for (int64_t i = 0; i < b->count && model->translates && !model->scene->has_wall; ++i) {
        double v[3];
        load(&b->v, i, v);
        mass += scalar(&b->mass, i);
        for (int k = 0; k < 3; ++k)
            momentum[k] += scalar(&b->mass, i) * v[k];
    }
    for (int k = 0; k < 3; ++k)
        whole[k] = mass > 0.0 ? momentum[k] / mass : 0.0;
}

/** The energy that two bodies bring to where they meet, at most. */
static double energy_to_meet(const struct model *model, const vti_bodies *b)
{
    const struct scene *s = model->scene;
    double most = 0.0, whole[3];
    velocity_of_whole(model, b, whole);
    for (int64_t i = 0; i < b->count && model->translates; ++i) {
        const double mass = scalar(&b->mass, i);
        double v[3];
        load(&b->v, i, v);
        for (int k = 0; k < 3; ++k)
            v[k] -= whole[k];
        const double work = s->has_gravity && s->has_wall ? mass * vti_norm(s->gravity.g) * fall(model, b, i) : 0.0;
        most = fmax(most, mass * vti_dot(v, v) + work);
    }
    return most;
}

static double overlap_of(const struct model *model, double energy)
{
    const struct scene *s = model->scene;
    double stiffness = INFINITY;
    if (s->has_contact)
        stiffness = s->contact.stiffness;
    if (s->has_wall)
        stiffness = fmin(stiffness, s->wall.stiffness);
    return fmin(plain_power(2.5 * energy / stiffness, 0.4), 1.0);
}

static double strain_of(const struct model *model, const vti_bodies *b, double energy)
{
    const vti_bonds *p = &model->bonds;
    double most = 0.0;
    for (int64_t k = 0; p->axial.p != NULL && k < p->count; ++k) {
        double d[3], xj[3];
        load(&b->x, p->pair[2 * k], d);
        load(&b->x, p->pair[2 * k + 1], xj);
        for (int c = 0; c < 3; ++c)
            d[c] -= xj[c];
        const double now = vti_norm(d) / p->rest[4 * k + 3] - 1.0, stiffness = scalar(&p->axial, k);
        if (stiffness > 0.0)
            most = fmax(most, now * now + 2.0 * energy / stiffness);
    }
    /* what rounding makes of positions is no strain */
    return most > 1e-20 ? fmin(sqrt(most), 1.0) : 0.0;
}

vti_deformation model_deformation(const struct model *model, const vti_bodies *bodies)
{
    const double energy = energy_to_meet(model, bodies);
    const vti_deformation at = {overlap_of(model, energy), strain_of(model, bodies, energy), model->scene->has_contact};
    return at;
}

/* ---- the bound -------------------------------------------------------------------------------------------------------- */

int model_stable_step(const struct model *model, const vti_bodies *bodies, const vti_deformation *at,
                      vti_stable *stable, struct message *message)
{
    double *scratch = calloc(bodies->count > 0 ? (size_t)bodies->count : 1, sizeof *scratch);
    if (scratch == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
    const int status = vti_stable_step(model->effects, model->effects_count, bodies, at, scratch, stable);
    free(scratch);
    return status == VTI_OK ? 0 : message_set(message, "%s: %s", model->scene->name, vti_status_text(status));
}

void model_limit_text(const struct model *model, const vti_deformation *at, const vti_stable *stable, char *text,
                      size_t size)
{
    const long long element = stable->element, i = stable->i, j = stable->j;
    if (stable->effect < 0) {
        snprintf(text, size, "nothing oscillates");
        return;
    }
    const char *name = model->effects[stable->effect].name;
    if (strcmp(name, "binder") == 0)
        snprintf(text, size, "bond %lld of bodies %lld and %lld", element, i, j);
    else if (strcmp(name, "contact") == 0 && at != NULL && at->meet)
        snprintf(text, size, "contacts that may come to body %lld", i);
    else if (strcmp(name, "contact") == 0)
        snprintf(text, size, "contact of bodies %lld and %lld", i, j);
    else if (strcmp(name, "wall") == 0)
        snprintf(text, size, "wall %lld at body %lld", element, i);
    else
        snprintf(text, size, "%s at body %lld", name, i);
}

int model_find_limits(const struct model *model, struct model_limits *l, struct message *message)
{
    const vti_deformation none = {0.0, 0.0, 0};
    l->at = model_deformation(model, &model->bodies);
    if (model_stable_step(model, &model->bodies, &none, &l->rest, message) != 0 ||
        model_stable_step(model, &model->bodies, &l->at, &l->within, message) != 0)
        return -1;
    model_limit_text(model, &none, &l->rest, l->rest_by, sizeof l->rest_by);
    model_limit_text(model, &l->at, &l->within, l->within_by, sizeof l->within_by);
    return 0;
}
