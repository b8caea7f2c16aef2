/* SPDX-License-Identifier: BSD-3-Clause */
#include <string.h>

#include "far.h"
#include "number.h"
#include "step_errors.h"
#include "verdict_parts.h"

static const double most_swing = 0.7; /* of S, by H alone */
static const double rounding = 1e-12; /* of all energies: sqrt(1e7) steps of eps, and more */

/* ---- what the scene is ------------------------------------------------------------------------------------------- */

/** Whether its energy is that of a field from outside, as gravity's, of which only differences mean anything. Walls take
 *  up momentum too, but theirs is elastic. */
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

/** The largest rate at which something slows bodies that others push, times the longest drift: steps see such a push in
 *  whole kicks, and what comes to a steady speed moves (z/2) coth(z/2) times as fast (EQUATIONS 6.3). */
static double slowing_of(const struct model *model, const vti_stepper *stepper, double h)
{
    double most = 0.0, drift = stepper->drift == NULL ? 1.0 : 0.0;
    int pushes = 0;
    for (int64_t k = 0; stepper->drift != NULL && k <= stepper->stages; ++k)
        drift = fmax(drift, fabs(stepper->drift[k]));
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        pushes |= model->effects[k].apply != NULL;
        most = e->kind->slowing != NULL ? fmax(most, e->kind->slowing(e, model)) : most;
    }
    return pushes ? most * drift * h : 0.0;
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
    v->found.slowing = slowing_of(model, stepper, h);
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
        return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
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

/** T + U of what is within the scene, without the common motion; in *size the sum of all |terms|, in *booked that of what
 *  has been booked. */
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

static void vector_of(const vti_view *view, int64_t i, double r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = view->c[k][i * view->stride];
}

/** |Omega| of the body of sphere s of a clump, times how far the sphere is from its centre. */
static double swing(const vti_clumps *clumps, const vti_bodies *bodies, int64_t s)
{
    double omega[3];
    vector_of(&bodies->omega, clumps->body[s], omega);
    return vti_norm(omega) * vti_norm(clumps->offset + 3 * s);
}

/** The largest speed of a body at x along the normals of the planes of all effects. */
static double approach(const struct model *model, const double x[3], const double v[3])
{
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        if (e->kind->planes != NULL)
            most = number_larger(most, e->kind->planes->approach(e, x, v));
    }
    return most;
}

double verdict_travel(const struct verdict *v, const vti_bodies *bodies)
{
    const vti_clumps *clumps = &v->model->clumps.list;
    const vti_bodies *spheres = clumps->count > 0 ? &clumps->spheres : bodies;
    double sum[3], own[3], from[3], x[3], most = 0.0;
    vti_momentum(bodies, sum);
    for (int64_t s = 0; s < spheres->count; ++s) {
        const int64_t i = clumps->count > 0 ? clumps->body[s] : s;
        vector_of(&bodies->v, i, own);
        vector_of(&spheres->x, s, x);
        for (int k = 0; k < 3; ++k)
            from[k] = own[k] - sum[k] / v->mass;
        const double apart = v->meet ? vti_norm(from) : 0.0, to_planes = approach(v->model, x, own);
        most =
            number_larger(most, number_larger(apart, to_planes) + (clumps->count > 0 ? swing(clumps, bodies, s) : 0.0));
    }
    return most * v->h / v->diameter;
}

/** The largest overlap with each other or with walls. */
static double deepest_of(const struct model *model, const vti_bodies *bodies)
{
    const vti_clumps *clumps = &model->clumps.list;
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        if (e->kind->deepest != NULL)
            most = fmax(most, e->kind->deepest(e, clumps->count > 0 ? &clumps->spheres : bodies));
    }
    return most;
}

/** Rows 0 to 31, every second of the next 32, every fourth of the next 64, ... */
static int is_looked_at(double row)
{
    const int64_t number = (int64_t)row;
    int64_t every = 1;
    while (number >= 32 * every)
        every *= 2;
    return number % every == 0;
}

/** Whether what touches holds a tenth more energy than at any look before. The stable step of Hertzian
 *  contact falls as E^(-1/10), so that a hundredth of it is missed. */
static int is_pressed(struct verdict *v, const double *row)
{
    double energy = 0.0;
    for (int c = 1; c < v->columns->held; ++c) {
        const int effect = v->columns->effect[c];
        energy += effect >= 0 && !v->model->effects[effect].smooth ? row[c] : 0.0;
    }
    if (!(energy > 1.1 * v->found.pressed))
        return 0;
    v->found.pressed = energy;
    return 1;
}

/** The bound at t. Returns it, infinite if it is not known. */
static double find_stable_step(struct verdict *v, double t, const vti_bodies *bodies)
{
    struct message ignored;
    vti_stable stable;
    if (model_stable_step(v->model, bodies, NULL, &stable, &ignored) != 0)
        return INFINITY;
    const double h = stable.h * 0.5 * v->stepper->reach; /* what the stepper itself stands, where stable.h is 2/omega */
    if (h < v->found.stable) {
        v->found.stable = h;
        v->found.stable_t = t;
    }
    return h;
}

/** Of steps that vary the longest since the last look may have been taken where the stable step was that of either end. */
static void look_at_stable_step(struct verdict *v, double t, const vti_bodies *bodies, const double *row)
{
    struct findings *f = &v->found;
    const int pressed = is_pressed(v, row);
    f->longest = fmax(f->longest, v->h);
    if (!(is_looked_at(f->rows) || pressed))
        return;
    f->slowing = fmax(f->slowing, slowing_of(v->model, v->stepper, v->h)); /* bonds may have been made */
    const double h = find_stable_step(v, t, bodies);
    f->share = fmax(f->share, f->longest / (f->varies != 0.0 ? fmax(h, f->before) : h));
    f->before = h;
    f->longest = 0.0;
}

void verdict_longest(struct verdict *v, double h)
{
    v->found.lately = fmax(v->found.lately, h);
    v->found.varies = 1.0;
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
    const double noise = rounding * f->size, change = total - f->first;
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
    look_at_stable_step(v, t, bodies, row);
    const struct energies e = modified_energies(&v->modified, bodies, total);
    if (v->columns->modified >= 0)
        row[v->columns->modified] = e.modified;
    if (!isfinite(total)) {
        f->broken = 1.0;
        return;
    }
    f->scale = fmax(f->scale, inner);
    f->size = fmax(f->size, size);
    f->booked = fmax(f->booked, booked);
    look_at_energies(v, t, total, e.kicked, e.modified);
    if (v->diameter > 0.0)
        f->travel = number_larger(f->travel, verdict_travel(v, bodies));
    if (v->model->translates)
        f->rounding = fmax(f->rounding, verdict_rounding(v, bodies, &f->fastest));
    f->deepest = fmax(f->deepest, deepest_of(v->model, bodies));
    f->rotation = number_larger(f->rotation, vti_max_turn(v->h, bodies));
    const double longest = v->model->scene->tolerance > 0.0 ? INFINITY : v->h;
    int64_t k = 0;
    for (struct effect *watched; (watched = verdict_next_watch(v->model, &k)) != NULL;)
        watched->kind->watch->row(watched, bodies, inner, longest);
    f->rows += 1.0;
}

/** The square of the largest force on a body. */
static double largest_force2(const vti_bodies *b)
{
    const double *x = b->force.c[0], *y = b->force.c[1], *z = b->force.c[2];
    double most = 0.0;
    for (int64_t i = 0; i < b->count; ++i) {
        const int64_t at = i * b->force.stride;
        const double f2 = x[at] * x[at] + y[at] * y[at] + z[at] * z[at];
        most = f2 > most ? f2 : most;
    }
    return most;
}

/** Steps that vary are compared with the stable step at rows. */
static void look_at_contacts(struct verdict *v, double t, const vti_bodies *bodies)
{
    static const double quarter = 1.5625; /* 1.25^2 */
    static const double none[3];
    struct findings *f = &v->found;
    if (bodies->force.c[0] == NULL || !far_any(&bodies->force, 0, bodies->count, NULL, none, quarter * f->force2))
        return;
    const double force2 = largest_force2(bodies); /* without NaN, which the next row finds */
    if (!(force2 > quarter * f->force2))
        return;
    f->force2 = force2;
    f->deepest = fmax(f->deepest, deepest_of(v->model, bodies));
    if (f->varies == 0.0)
        f->share = fmax(f->share, v->h / find_stable_step(v, t, bodies));
}

void verdict_step(struct verdict *v, double t, const vti_bodies *bodies)
{
    int64_t k = 0;
    if (v->touches)
        look_at_contacts(v, t, bodies);
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
