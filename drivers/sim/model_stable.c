/* SPDX-License-Identifier: BSD-3-Clause */
#include <math.h>
#include <stdlib.h>

#include "model.h"

/* ---- how deep contacts go --------------------------------------------------------------------------------------------- */

/** How far body i falls along g until its surface meets the first plane in its way; 0 if none is. */
static double fall(const struct model *model, int64_t i)
{
    const vti_view *x = &model->bodies.x;
    const double centre[3] = {x->c[0][i * x->stride], x->c[1][i * x->stride], x->c[2][i * x->stride]};
    const double *g = model->scene->gravity.g, length = vti_norm(g);
    const double radius = 0.5 * model->diameter.p[i * model->diameter.stride];
    double least = INFINITY;
    for (int64_t w = 0; w < model->walls.count; ++w) {
        const double *plane = model->walls.plane + 4 * w, towards = -vti_dot(plane, g) / length;
        if (towards > 0.0)
            least = fmin(least, fmax(vti_dot(plane, centre) - plane[3] - radius, 0.0) / towards);
    }
    return isfinite(least) ? least : 0.0;
}

double model_overlap(const struct model *model)
{
    const struct scene *s = model->scene;
    const vti_bodies *b = &model->bodies;
    double most = 0.0, stiffness = INFINITY;
    if (s->has_contact)
        stiffness = s->contact.stiffness;
    if (s->has_wall)
        stiffness = fmin(stiffness, s->wall.stiffness);
    for (int64_t i = 0; i < b->count && isfinite(stiffness); ++i) {
        const double mass = b->mass.p[i * b->mass.stride];
        const double v[3] = {b->v.c[0][i * b->v.stride], b->v.c[1][i * b->v.stride], b->v.c[2][i * b->v.stride]};
        const double work = s->has_gravity && s->has_wall ? mass * vti_norm(s->gravity.g) * fall(model, i) : 0.0;
        most = fmax(most, mass * vti_dot(v, v) + work);
    }
    return fmin(pow(2.5 * most / stiffness, 0.4), 1.0);
}

/* ---- the bound -------------------------------------------------------------------------------------------------------- */

int model_stable_step(const struct model *model, double overlap, double *h, struct message *message)
{
    const struct scene *s = model->scene;
    const vti_springs springs = {s->has_binder ? &model->bonds : NULL, s->has_contact ? &model->contacts : NULL,
                                 s->has_wall ? &model->walls : NULL, s->has_pendulum ? &s->pendulum : NULL, overlap};
    double *scratch = calloc((size_t)model->bodies.count, sizeof *scratch);
    if (scratch == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", s->name);
    const int status = vti_stable_step(&springs, &model->bodies, scratch, h);
    free(scratch);
    return status == VTI_OK ? 0 : message_set(message, "%s: %s", s->name, vti_status_text(status));
}
