/* SPDX-License-Identifier: BSD-3-Clause */
#include <stdlib.h>

#include "arrange.h"
#include "hertz.h"
#include "inertia.h"
#include "model_parts.h"
#include "plain.h"
#include "random.h"

/* ---- one block of memory ----------------------------------------------------------------------------------------- */

/** The next n doubles of the block. */
static double *take(double **block, int64_t n)
{
    double *p = *block;
    *block += n;
    return p;
}

int model_loads(const struct scene *scene, const struct tables *tables)
{
    int64_t loads = 0;
    for (int k = 0; k < EFFECT_COUNT; ++k)
        loads |= scene->has[k] ? kinds_draft(kinds_at(k), &scene->settings, &tables->effect[k]).gives : 0;
    /* a force on a sphere of a clump turns it */
    return (int)loads | (scene->clumps.given && (loads & EFFECT_FORCE) != 0 ? EFFECT_MOMENT : 0);
}

/** Inertia of each body follows from mass and diameter, of which one differs from body to body. */
static int derives_inertia(const struct model *model, const struct table *bodies)
{
    return model->turns && model->scene->inertia == 0.0 && model->scene->moments[0] == 0.0 &&
           !table_has(bodies, BODY_INERTIA) && !table_has(bodies, BODY_MOMENTS) &&
           (table_has(bodies, BODY_MASS) || table_has(bodies, BODY_DIAMETER) || model->scene->clumps.given);
}

/** They turn, and have three moments: all the same ones, each its own, or as clumps. */
static int is_general(const struct model *model, const struct table *bodies)
{
    const struct scene *s = model->scene;
    return model->turns && (s->moments[0] != 0.0 || table_has(bodies, BODY_MOMENTS) ||
                            (s->clumps.given && !clumps_are_spheres(&model->clumps, s)));
}

/** Their moments, or the axes of these, differ from body to body. */
static int has_own_moments(const struct model *model, const struct table *bodies)
{
    return model->scene->clumps.given || table_has(bodies, BODY_MOMENTS) || table_has(bodies, BODY_PRINCIPAL);
}

/** Each body has a mass of its own, which follows from the density. */
static int is_weighed(const struct scene *s, const struct table *bodies)
{
    return s->clumps.density != 0.0 || (s->density != 0.0 && table_has(bodies, BODY_DIAMETER));
}

/** Doubles per body. */
static int64_t body_width(const struct model *model, const struct tables *tables)
{
    const int loads = model_loads(model->scene, tables);
    int64_t width = derives_inertia(model, &tables->bodies);
    width += model->translates ? 6 + 3 * ((loads & EFFECT_FORCE) != 0) : 0;
    width += is_general(model, &tables->bodies) ? 3 : 0;
    width += has_own_moments(model, &tables->bodies) ? 3 + 4 : 0;
    width += is_weighed(model->scene, &tables->bodies);
    width += model->turns ? 6 + 3 * ((loads & EFFECT_MOMENT) != 0) : 0;
    for (int k = BODY_MASS; k <= BODY_YOUNG; ++k)
        width += table_has(&tables->bodies, k);
    return width;
}

/* ---- vectors ----------------------------------------------------------------------------------------------------- */

/** n vectors, [n][3]: columns k, k+1, k+2 of the table if it has them, else value for all. */
static double *place(double **block, int64_t n, const struct table *bodies, int k, const double value[3])
{
    double *p = take(block, 3 * n);
    for (int64_t i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c)
            p[3 * i + c] = table_has(bodies, k) ? bodies->column[k + c][i] : value[c];
    return p;
}

/** Numbers 6 i ... 6 i + 2 of the scene's sequence are for v of body i, as people number them, the next three for
 *  omega, and those from 2^40 + 6 i on for alpha. p is [n][3]. */
static void add_random(const struct model *model, double *p, int64_t first, double most)
{
    const uint64_t seed = (uint64_t)model->scene->random.seed;
    for (int64_t k = 0; k < model->bodies.count && most != 0.0; ++k) {
        const int64_t i = model_number(model, k);
        for (int64_t c = 0; c < 3; ++c)
            p[3 * k + c] += random_symmetric(seed, (uint64_t)(6 * i + first + c), most);
    }
}

static void place_vectors(struct model *model, const struct tables *tables, double **block)
{
    const struct scene *s = model->scene;
    const struct table *t = &tables->bodies;
    const int loads = model_loads(s, tables);
    vti_bodies *b = &model->bodies;
    const int64_t n = b->count;
    if (model->translates) {
        double *x = place(block, n, t, BODY_X, s->x), *v = place(block, n, t, BODY_V, s->v);
        if (s->arrangement != SCENE_IN_TABLE)
            arrange_positions(s, x);
        add_random(model, v, 0, s->random.v);
        b->x = vti_view_packed(x);
        b->x.count = n; /* slices of threads keep it, for a library that looks at lists */
        b->v = vti_view_packed(v);
        if ((loads & EFFECT_FORCE) != 0)
            b->force = vti_view_packed(take(block, 3 * n));
    }
    if (model->turns) {
        double *alpha = place(block, n, t, BODY_ALPHA, s->alpha), *omega = place(block, n, t, BODY_OMEGA, s->omega);
        add_random(model, omega, 3, s->random.omega);
        add_random(model, alpha, (int64_t)1 << 40, s->random.alpha);
        b->alpha = vti_view_packed(alpha);
        b->alpha.count = n;
        b->omega = vti_view_packed(omega);
        if ((loads & EFFECT_MOMENT) != 0)
            b->moment = vti_view_packed(take(block, 3 * n));
    }
}

/* ---- mass, inertia, diameter ------------------------------------------------------------------------------------- */

/** Column k of the table, or the value for all if it is not 0; else nothing. */
static vti_scalars property(double **block, int64_t n, const struct table *bodies, int k, const double *value)
{
    const vti_scalars none = {NULL, 0, 0};
    if (!table_has(bodies, k))
        return *value != 0.0 ? vti_scalars_one(value) : none;
    double *p = take(block, n);
    for (int64_t i = 0; i < n; ++i)
        p[i] = bodies->column[k][i];
    return vti_scalars_array(p);
}

/** m of a solid sphere. */
static double ball(double density, double diameter)
{
    return density * (PLAIN_PI / 6.0) * diameter * diameter * diameter;
}

/** The template of body i, which has clumps. */
static const struct clump_template *template_of(const struct model *model, const struct tables *tables, int64_t i)
{
    return clumps_template(&model->clumps, model->scene, &tables->bodies, i);
}

/** Mass of each body, of its template or its diameter. */
static vti_scalars weighed(const struct model *model, const struct tables *tables, double **block)
{
    const struct scene *s = model->scene;
    double *mass = take(block, model->bodies.count);
    for (int64_t i = 0; i < model->bodies.count; ++i)
        mass[i] = s->clumps.given ? s->clumps.density * template_of(model, tables, i)->solid.mass
                                  : ball(s->density, tables->bodies.column[BODY_DIAMETER][i]);
    return vti_scalars_array(mass);
}

/** Moments of inertia of bodies of which mass and diameter are known; clumps have those of their template. */
static vti_scalars derived(const struct model *model, const struct tables *tables, const vti_scalars *mass,
                           double **block)
{
    double *inertia = take(block, model->bodies.count), moments[3];
    for (int64_t i = 0; i < model->bodies.count; ++i) {
        const double m = mass->p[i * mass->stride];
        if (model->scene->clumps.given)
            clumps_moments(template_of(model, tables, i), model->scene, m, moments);
        else
            moments[0] = inertia_of_sphere(m, model->diameter.p[i * model->diameter.stride]);
        inertia[i] = moments[0];
    }
    return vti_scalars_array(inertia);
}

/** Returns the masses, which bodies that do not translate have not. */
static vti_scalars place_properties(struct model *model, const struct tables *tables, double **block)
{
    const struct scene *s = model->scene;
    const struct table *t = &tables->bodies;
    vti_bodies *b = &model->bodies;
    model->sphere = s->diameter != 0.0 ? s->diameter : arrange_touching(s);
    model->mass = s->density != 0.0 ? ball(s->density, model->sphere) : s->mass;
    model->inertia = s->inertia != 0.0 ? s->inertia : inertia_of_sphere(model->mass, model->sphere);
    const vti_scalars mass =
        is_weighed(s, t) ? weighed(model, tables, block) : property(block, b->count, t, BODY_MASS, &model->mass);
    model->diameter = property(block, b->count, t, BODY_DIAMETER, &model->sphere);
    if (table_has(t, BODY_YOUNG)) {
        double *modulus = take(block, b->count);
        for (int64_t i = 0; i < b->count; ++i)
            modulus[i] = hertz_modulus(t->column[BODY_YOUNG][i], t->column[BODY_POISSON][i]);
        model->modulus = vti_scalars_array(modulus);
    }
    if (model->translates)
        b->mass = mass;
    if (model->turns && !is_general(model, t))
        b->inertia = derives_inertia(model, t) ? derived(model, tables, &mass, block)
                                               : property(block, b->count, t, BODY_INERTIA, &model->inertia);
    return mass;
}

/** The same moments for all. */
static void place_moments(struct model *model)
{
    double *const m = model->moments, *const p = model->principal;
    for (int k = 0; k < 3; ++k)
        m[k] = model->scene->moments[k];
    vti_rrv_to_quat_xyzw(model->scene->principal, p);
    model->bodies.moments = (vti_view){{m, m + 1, m + 2}, 0, 0};
    model->bodies.principal = (vti_quat_view){{p, p + 1, p + 2, p + 3}, 0, 0};
}

/** Those of body i, by its template or its row: A, B, C in m, P in p. */
static void moments_of(const struct model *model, const struct tables *tables, int64_t i, double m[3], double p[4])
{
    const struct scene *s = model->scene;
    const struct table *t = &tables->bodies;
    double axes[3];
    if (s->clumps.given) {
        const struct clump_template *of = template_of(model, tables, i);
        clumps_moments(of, s, model->bodies.mass.p[i * model->bodies.mass.stride], m);
        for (int k = 0; k < 4; ++k)
            p[k] = of->solid.principal[k];
        return;
    }
    for (int k = 0; k < 3; ++k) {
        m[k] = table_has(t, BODY_MOMENTS) ? t->column[BODY_MOMENTS + k][i] : s->moments[k];
        axes[k] = table_has(t, BODY_PRINCIPAL) ? t->column[BODY_PRINCIPAL + k][i] : s->principal[k];
    }
    vti_rrv_to_quat_xyzw(axes, p);
}

/** Those of each body. */
static void place_own_moments(struct model *model, const struct tables *tables, double **block)
{
    vti_bodies *b = &model->bodies;
    double *const m = take(block, 3 * b->count), *const p = take(block, 4 * b->count);
    for (int64_t i = 0; i < b->count; ++i)
        moments_of(model, tables, i, m + 3 * i, p + 4 * i);
    b->moments = vti_view_packed(m);
    b->principal = (vti_quat_view){{p, p + 1, p + 2, p + 3}, 4, 0};
}

/** Of each body L = R_p diag(A, B, C) R_p^T Omega, which it turns by from then on; Omega is what is shown of it. */
static void place_spin(struct model *model, double **block)
{
    vti_bodies *b = &model->bodies;
    double *const L = take(block, 3 * b->count);
    for (int64_t i = 0; i < b->count; ++i) {
        const vti_bodies one = vti_bodies_slice(*b, i, 1);
        vti_spin(&one, L + 3 * i);
    }
    b->spin = vti_view_packed(L);
}

/* ---- together ---------------------------------------------------------------------------------------------------- */

/** The spheres of clumps, which have the surfaces. */
static int place_spheres(struct model *model, const struct tables *tables, struct message *message)
{
    struct clumps *clumps = &model->clumps;
    if (!model->scene->clumps.given)
        return 0;
    if (clumps_place(clumps, model->scene, tables, &model->bodies, &model->modulus, message) != 0)
        return -1;
    model->diameter = clumps->diameter;
    model->modulus = clumps->modulus;
    return 0;
}

int model_place_bodies(struct model *model, const struct tables *tables, struct message *message)
{
    const int64_t n = model->scene->arrangement == SCENE_IN_TABLE ? tables->bodies.rows : scene_bodies(model->scene);
    if (model->scene->clumps.given && clumps_weigh(&model->clumps, model->scene, message) != 0)
        return -1;
    const int64_t doubles = n * body_width(model, tables);
    model->bodies = vti_bodies_none(n);
    model->memory = calloc((size_t)(doubles > 0 ? doubles : 1), sizeof *model->memory);
    if (model->memory == NULL)
        return message_set(message, "%s: out of memory for %lld bodies; use fewer", model->scene->name, (long long)n);
    double *block = model->memory;
    place_vectors(model, tables, &block);
    const vti_scalars mass = place_properties(model, tables, &block);
    if (is_general(model, &tables->bodies)) {
        if (has_own_moments(model, &tables->bodies))
            place_own_moments(model, tables, &block);
        else
            place_moments(model);
        place_spin(model, &block);
    }
    if (model_check_masses(model, tables, &mass, message) != 0)
        return -1;
    return place_spheres(model, tables, message);
}
