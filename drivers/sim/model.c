/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

#include <stdlib.h>
#include <string.h>

/* ---- bodies ---------------------------------------------------------------------------------------------------- */

/** The next packed view of n three-vectors, all set to value (or 0). */
static vti_view take(double **memory, int64_t n, const double value[3])
{
    double *p = *memory;
    for (int64_t i = 0; i < n; ++i)
        memcpy(p + 3 * i, value, 3 * sizeof *p);
    *memory += 3 * n;
    return vti_view_packed(p);
}

static void place_bodies(struct model *model, double *memory)
{
    const struct scene *s = model->scene;
    const double zero[3] = {0.0, 0.0, 0.0};
    vti_bodies *b = &model->bodies;
    const int64_t n = b->count;
    if (s->translates) {
        b->x = take(&memory, n, s->x);
        b->v = take(&memory, n, s->v);
        b->mass = vti_scalars_one(&s->mass);
    }
    if (s->turns) {
        b->alpha = take(&memory, n, s->alpha);
        b->omega = take(&memory, n, s->omega);
        b->inertia = vti_scalars_one(&s->inertia);
    }
    if (s->has_pendulum)
        b->moment = take(&memory, n, zero);
}

int model_create(const struct scene *scene, struct model *model, struct message *message)
{
    enum { VECTORS = 6 };
    memset(model, 0, sizeof *model);
    model->scene = scene;
    model->bodies = vti_bodies_none(1);
    model->memory = calloc((size_t)(3 * VECTORS * model->bodies.count), sizeof *model->memory);
    if (model->memory == NULL)
        return message_set(message, "%s: out of memory for %lld bodies; use fewer", scene->name,
                           (long long)model->bodies.count);
    place_bodies(model, model->memory);
    if (scene->has_pendulum)
        model->effects[model->effects_count++] = vti_pendulum_effect(&scene->pendulum);
    const int status = model_forces(model, &model->bodies);
    if (status != VTI_OK) {
        model_destroy(model);
        return message_set(message, "%s: %s", scene->name, vti_status_text(status));
    }
    return 0;
}

void model_destroy(struct model *model)
{
    free(model->memory);
    model->memory = NULL;
}

int model_forces(const struct model *model, const vti_bodies *bodies)
{
    return vti_apply(model->effects, model->effects_count, bodies);
}

double model_energy(const struct model *model, const vti_bodies *bodies)
{
    return vti_energy(model->effects, model->effects_count, bodies);
}

/* ---- invariants ------------------------------------------------------------------------------------------------- */

static const struct invariant momenta[6] = {
    {"momentum_x", "$P_x$", 1}, {"momentum_y", "$P_y$", 1}, {"momentum_z", "$P_z$", 1},
    {"angular_x", "$L_x$", 1},  {"angular_y", "$L_y$", 1},  {"angular_z", "$L_z$", 1},
};
/* the sphere's spin about its arm, and the arm's length (EQUATIONS 3) */
static const struct invariant arm_dot_omega = {"arm_dot_omega", "$R\\rho_0\\cdot\\Omega$", 1};
static const struct invariant arm_length = {"arm_length", "$|R\\rho_0|$", 0};

/** Momentum k (0-2 linear, 3-5 angular about the origin) exists in the scene and no effect breaks it. */
static int conserves(const struct model *model, int k)
{
    for (int64_t e = 0; e < model->effects_count; ++e)
        if (model->effects[e].breaks >> k & 1)
            return 0;
    return k < 3 ? model->scene->translates : 1;
}

int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS])
{
    int64_t n = 0;
    for (int k = 0; k < 6; ++k)
        if (conserves(model, k))
            list[n++] = momenta[k];
    if (model->scene->has_pendulum) {
        list[n++] = arm_dot_omega;
        list[n++] = arm_length;
    }
    return n;
}

void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS])
{
    const double origin[3] = {0.0, 0.0, 0.0};
    double pl[6];
    int64_t n = 0;
    vti_momentum(bodies, pl);
    vti_angular_momentum(bodies, origin, pl + 3);
    for (int k = 0; k < 6; ++k)
        if (conserves(model, k))
            values[n++] = pl[k];
    if (model->scene->has_pendulum) {
        double arm[3];
        vti_pendulum_arm(&model->scene->pendulum, bodies, 0, arm);
        values[n++] = arm[0] * bodies->omega.c[0][0] + arm[1] * bodies->omega.c[1][0] + arm[2] * bodies->omega.c[2][0];
        values[n++] = vti_norm(arm);
    }
}
