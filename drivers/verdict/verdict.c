/* SPDX-License-Identifier: BSD-3-Clause */
#include <math.h>
#include <string.h>

#include "number.h"
#include "step_errors.h"
#include "verdict_parts.h"

static const double most_swing = 0.7; /* of S, by H alone */
static const double rounding = 1e-12; /* of all energies: sqrt(1e7) steps of eps, and more */

/* ---- what the scene is ------------------------------------------------------------------------------------------- */

/** Whether its energy is that of a field from outside, as gravity's, of which only differences mean anything. Walls
 *  take up momentum too, but theirs is elastic. */
static int is_of_field(const vti_effect *effect)
{
    return effect->smooth && (effect->breaks & VTI_BREAKS_LINEAR) != 0;
}

static double smallest_diameter(const struct model *model)
{
    double least = INFINITY;
    const vti_scalars *d = &model->diameter;
    if (d->p == NULL || !model->translates || scene_first_with(model->scene, EFFECT_SPHERES) == NULL)
        return 0.0;
    for (int64_t i = 0; i < model_spheres(model)->count; ++i)
        least = fmin(least, d->p[i * d->stride]);
    return least;
}

struct effect *verdict_next_watch(const struct model *model, int64_t *k)
{
    while (*k < model->instances_count)
        if (model->instances[(*k)++].kind->watch != NULL)
            return (struct effect *)&model->instances[*k - 1];
    return NULL;
}

static int start_watches(struct model *model, int *watches)
{
    int64_t k = 0;
    for (struct effect *e; (e = verdict_next_watch(model, &k)) != NULL; *watches = 1)
        if (e->kind->watch->start(e) != 0)
            return -1;
    return 0;
}

int verdict_create(struct verdict *v, struct model *model, const vti_stepper *stepper, double h,
                   const struct columns *columns, struct message *message)
{
    memset(v, 0, sizeof *v);
    v->model = model;
    v->stepper = stepper;
    v->columns = columns;
    v->h = h;
    v->diameter = smallest_diameter(model);
    v->found.slowing = stability_slowing(model, stepper, h);
    v->found.slowing_free = stability_slowing_free(model, stepper, h);
    for (int64_t k = 0; k < model->instances_count; ++k)
        v->touches |= model->instances[k].kind->deepest != NULL;
    v->meet = model_surfaces(model).contacts != NULL && model->bodies.count > 1;
    v->found.stable = INFINITY;
    for (int64_t e = 0; e < model->effects_count; ++e)
        for (int k = 0; k < 3; ++k)
            v->open[k] |= (int)(model->effects[e].breaks >> k & 1);
    vti_sum mass = {0.0, 0.0};
    for (int64_t i = 0; model->translates && i < model->bodies.count; ++i)
        vti_sum_add(&mass, model->bodies.mass.p[i * model->bodies.mass.stride]);
    v->mass = vti_sum_value(&mass);
    if (modified_create(&v->modified, model, stepper, h) != 0 || start_watches(model, &v->watches) != 0)
        return scene_no_memory(model->scene, message);
    return 0;
}

void verdict_destroy(struct verdict *v)
{
    int64_t k = 0;
    for (struct effect *e; v->model != NULL && (e = verdict_next_watch(v->model, &k)) != NULL;)
        e->kind->watch->end(e);
    modified_destroy(&v->modified);
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

/** The velocity of the centre of mass along the axes that nothing from outside acts along; 0 along the others. */
static void common_velocity(const struct verdict *v, const vti_bodies *bodies, double u[3])
{
    vti_momentum(bodies, u);
    for (int k = 0; k < 3; ++k)
        u[k] = v->open[k] || v->mass == 0.0 ? 0.0 : u[k] / v->mass;
}

/** T + U of what is within the scene, without the common motion; in *size the sum of all |terms|, in *booked that of
 *  what has been booked. */
static double inner_energy(const struct verdict *v, const vti_bodies *bodies, const double *row, double *size,
                           double *booked)
{
    const struct model *model = v->model;
    double u[3];
    common_velocity(v, bodies, u);
    double kinetic = 0.0, elastic = 0.0;
    *size = *booked = 0.0;
    for (int c = 1; c < v->columns->total; ++c) {
        const int effect = v->columns->effect[c];
        *size += fabs(row[c]);
        if (c >= v->columns->held) {
            *booked += fabs(row[c]);
            continue;
        }
        kinetic += effect < 0 ? row[c] : 0.0;
        elastic += effect >= 0 && !is_of_field(&model->effects[effect]) ? row[c] : 0.0;
    }
    return fmax(kinetic - 0.5 * v->mass * vti_dot(u, u), 0.0) + elastic;
}

/** Of the energies of a row, kicked being H~ or NaN. */
static void look_at_energies(struct verdict *v, double t, double total, double kicked, double modified)
{
    struct findings *f = &v->found;
    if (f->rows == 0.0) {
        f->first = f->highest = f->lowest = total;
        f->first_kicked = kicked;
    }
    f->highest = fmax(f->highest, total);
    f->lowest = fmin(f->lowest, total);
    const double noise = rounding * f->size + f->idle, change = total - f->first;
    const double other = isnan(kicked) ? change : kicked - f->first_kicked;
    const double grown = change > most_swing * verdict_scale(f) ? change : fmin(change, other);
    const double bad = VERDICT_MOST_GAIN * verdict_scale(f), last = f->gain;
    f->gain = fmax(f->gain, grown - noise);
    f->loss = fmax(f->loss, fmin(-change, -other) - noise);
    if (f->gain > bad && !(last > bad))
        f->gain_t = t;
    trend_add(&f->trend, t, isnan(modified) ? change : modified - f->first);
}

void verdict_row(struct verdict *v, double t, const vti_bodies *bodies, double row[COLUMNS])
{
    struct findings *f = &v->found;
    double size, booked;
    v->h = f->varies != 0.0 ? f->lately : v->h;
    f->lately = 0.0;
    columns_values(v->columns, t, bodies, row);
    const double total = row[v->columns->total], inner = inner_energy(v, bodies, row, &size, &booked);
    stability_row(v, t, bodies, row);
    const struct energies e = modified_energies(&v->modified, bodies, total);
    if (v->columns->modified >= 0)
        row[v->columns->modified] = e.modified;
    if (!isfinite(total)) {
        f->broken = 1.0;
        return;
    }
    if (f->rows == 0.0)
        f->idle = stability_idle(v->model, bodies);
    f->scale = fmax(f->scale, inner);
    f->size = fmax(f->size, size);
    f->booked = fmax(f->booked, booked);
    look_at_energies(v, t, total, e.kicked, e.modified);
    if (v->diameter > 0.0)
        f->travel = number_larger(f->travel, places_travel(v, bodies));
    if (v->model->translates)
        f->rounding = fmax(f->rounding, places_rounding(v, bodies, f->idle, &f->fastest));
    f->deepest = fmax(f->deepest, stability_deepest(v->model, bodies));
    f->rotation = number_larger(f->rotation, vti_max_turn(v->h, bodies));
    const double longest = v->model->scene->tolerance > 0.0 ? INFINITY : v->h;
    int64_t k = 0;
    for (struct effect *watched; (watched = verdict_next_watch(v->model, &k)) != NULL;)
        watched->kind->watch->row(watched, bodies, inner, longest);
    f->rows += 1.0;
}

void verdict_step(struct verdict *v, double t, const vti_bodies *bodies)
{
    int64_t k = 0;
    if (v->touches)
        stability_step(v, t, bodies);
    for (struct effect *e; v->watches && (e = verdict_next_watch(v->model, &k)) != NULL;)
        e->kind->watch->step(e, bodies);
}

/* ---- keeping it -------------------------------------------------------------------------------------------------- */

enum {
    FINDINGS = sizeof(struct findings) / sizeof(double),
    ERRORS = sizeof(struct step_errors_found) / sizeof(double)
};

int64_t verdict_size(const struct verdict *v)
{
    int64_t size = FINDINGS + (v->model->errors != NULL ? ERRORS : 0), k = 0;
    for (struct effect *e; (e = verdict_next_watch(v->model, &k)) != NULL;)
        size += e->kind->watch->size(e);
    return size;
}

void verdict_give(const struct verdict *v, struct sink *sink)
{
    int64_t k = 0;
    sink->add(sink, (const double *)&v->found, FINDINGS);
    if (v->model->errors != NULL)
        sink->add(sink, (const double *)&v->model->errors->found, ERRORS);
    for (struct effect *e; (e = verdict_next_watch(v->model, &k)) != NULL;)
        e->kind->watch->give(e, sink);
}

void verdict_put(struct verdict *v, const double *state)
{
    int64_t k = 0;
    memcpy(&v->found, state, sizeof v->found);
    state += FINDINGS;
    if (v->model->errors != NULL) {
        memcpy(&v->model->errors->found, state, sizeof v->model->errors->found);
        state += ERRORS;
    }
    for (struct effect *e; (e = verdict_next_watch(v->model, &k)) != NULL; state += e->kind->watch->size(e))
        e->kind->watch->put(e, state);
}
