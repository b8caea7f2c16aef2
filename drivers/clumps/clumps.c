/* SPDX-License-Identifier: BSD-3-Clause */
#include "clumps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertia.h"
#include "kind.h"
#include "tables.h"

/** Lines across a template whose spheres overlap: its mass and moments are good to 1e-4 (EQUATIONS 7.5). */
enum { LINES = 256 };

/* ---- templates --------------------------------------------------------------------------------------------------- */

/** Centres and diameters of the template's spheres. */
static void spheres_of(const struct clump_template *of, const struct scene *scene, double centre[][3],
                       double diameter[])
{
    for (int64_t s = 0; s < of->count; ++s) {
        const double *sphere = scene->clumps.spheres.sphere[of->first + s];
        memcpy(centre[s], sphere, sizeof centre[s]);
        diameter[s] = sphere[3];
    }
}

static int weigh(struct clump_template *of, const struct scene *scene)
{
    double centre[SCENE_SPHERES_MAX][3], diameter[SCENE_SPHERES_MAX];
    vti_solid *const solid = &of->solid;
    spheres_of(of, scene, centre, diameter);
    const int status = vti_clump_solid(of->count, centre[0], diameter, 1.0, LINES, solid, NULL);
    int good = status == VTI_OK && isfinite(solid->mass) && solid->mass > 0.0;
    for (int k = 0; k < 3 && good; ++k)
        good = isfinite(solid->centre[k]) && isfinite(solid->moments[k]) && solid->moments[k] > 0.0;
    return good ? 0 : -1;
}

int clumps_weigh(struct clumps *clumps, const struct scene *scene, struct message *message)
{
    const int64_t count = scene_templates(scene);
    int64_t first = 0;
    clumps->template = calloc((size_t)count, sizeof *clumps->template);
    if (clumps->template == NULL)
        return message_set(message, "%s: out of memory; use fewer templates of clumps", scene->name);
    for (int64_t k = 0; k < count; ++k) {
        struct clump_template *of = &clumps->template[k];
        of->first = first;
        of->count =
            scene->clumps.counts.count > 0 ? (int64_t)scene->clumps.counts.number[k] : scene->clumps.spheres.count;
        first += of->count;
        if (weigh(of, scene) != 0)
            return message_set(message,
                               "%s: bodies.clumps: the volume or a moment of template %lld is 0 or not finite; give "
                               "spheres of moderate size",
                               scene->name, (long long)k);
    }
    return 0;
}

const struct clump_template *clumps_template(const struct clumps *clumps, const struct scene *scene,
                                             const struct table *bodies, int64_t i)
{
    if (table_has(bodies, BODY_CLUMP))
        return &clumps->template[(int64_t)bodies->column[BODY_CLUMP][i]];
    return &clumps->template[i % scene_templates(scene)];
}

int clumps_are_spheres(const struct clumps *clumps, const struct scene *scene)
{
    int single = 1;
    for (int64_t k = 0; k < scene_templates(scene); ++k)
        single &= clumps->template[k].count == 1;
    return single;
}

void clumps_moments(const struct clump_template *of, const struct scene *scene, double mass, double moments[3])
{
    const double diameter = scene->clumps.spheres.sphere[of->first][3];
    for (int k = 0; k < 3; ++k)
        moments[k] = of->count == 1 ? inertia_of_sphere(mass, diameter) : mass / of->solid.mass * of->solid.moments[k];
}

/* ---- their spheres ----------------------------------------------------------------------------------------------- */

/** What the scene's effects on spheres read and load: bits of vti_effect. */
static int64_t views_of(const struct scene *scene, const struct tables *tables)
{
    const int64_t velocities = 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_OMEGA;
    int64_t views = 1 << VTI_QUANTITY_X;
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (scene->has[k] && kinds_has(kinds_at(k), &scene->settings, EFFECT_ON_SPHERES)) {
            const vti_effect draft = kinds_draft(kinds_at(k), &scene->settings, &tables->effect[k]);
            views |= draft.needs | draft.gives;
            views |= kinds_has(kinds_at(k), &scene->settings, EFFECT_NEAR) ? velocities : 0;
        }
    return views;
}

/** The next n doubles. */
static double *take(double **block, int64_t n)
{
    double *p = *block;
    *block += n;
    return p;
}

/** The vectors of the spheres that are to be there. */
static void give_views(vti_bodies *spheres, int64_t views, double **block)
{
    vti_view *const view[] = {&spheres->x,     &spheres->v,     &spheres->force,
                              &spheres->alpha, &spheres->omega, &spheres->moment};
    static const int of[] = {VTI_QUANTITY_X,     VTI_QUANTITY_V,     VTI_QUANTITY_FORCE,
                             VTI_QUANTITY_ALPHA, VTI_QUANTITY_OMEGA, VTI_QUANTITY_MOMENT};
    for (size_t k = 0; k < sizeof of / sizeof of[0]; ++k)
        if ((views >> of[k] & 1) != 0)
            *view[k] = vti_view_packed(take(block, 3 * spheres->count));
    spheres->x.count = spheres->count; /* as those of bodies */
}

static double scalar(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** Sphere s of the list is sphere k of the template; its offset is from the centre of mass, which of a single sphere is
 *  its own. */
static void place_offset(const struct clump_template *of, const struct scene *scene, int64_t k, double offset[3])
{
    const double *sphere = scene->clumps.spheres.sphere[of->first + k];
    for (int c = 0; c < 3; ++c)
        offset[c] = of->count == 1 ? 0.0 : sphere[c] - of->solid.centre[c];
}

/** Fills the list of spheres, body by body. Mass and inertia are those of the whole body, which a load on the sphere
 *  moves. */
static void fill(struct clumps *clumps, const struct scene *scene, const struct table *table, const vti_bodies *bodies,
                 const vti_scalars *modulus, double **block)
{
    const int64_t n = clumps->list.count;
    double *const offset = take(block, 3 * n), *const diameter = take(block, n), *const mass = take(block, n),
                  *const inertia = take(block, n), *const moduli = take(block, n);
    int64_t s = 0;
    for (int64_t i = 0; i < bodies->count; ++i) {
        const struct clump_template *of = clumps_template(clumps, scene, table, i);
        for (int64_t k = 0; k < of->count; ++k, ++s) {
            clumps->body[s] = i;
            place_offset(of, scene, k, offset + 3 * s);
            diameter[s] = scene->clumps.spheres.sphere[of->first + k][3];
            mass[s] = scalar(&bodies->mass, i);
            inertia[s] = inertia_least(bodies, i);
            moduli[s] = modulus->p != NULL ? scalar(modulus, i) : 0.0;
        }
    }
    clumps->list.body = clumps->body;
    clumps->list.offset = offset;
    clumps->list.spheres.mass = vti_scalars_array(mass);
    clumps->list.spheres.inertia = vti_scalars_array(inertia);
    clumps->diameter = vti_scalars_array(diameter);
    if (modulus->p != NULL)
        clumps->modulus = vti_scalars_array(moduli);
}

int clumps_place(struct clumps *clumps, const struct scene *scene, const struct tables *tables,
                 const vti_bodies *bodies, const vti_scalars *modulus, struct message *message)
{
    enum { DOUBLES = 3 * 6 + 3 + 4 }; /* of a sphere: six views, an offset, four scalars */
    int64_t n = 0;
    for (int64_t i = 0; i < bodies->count; ++i)
        n += clumps_template(clumps, scene, &tables->bodies, i)->count;
    clumps->body = calloc((size_t)n, sizeof *clumps->body);
    clumps->memory = calloc((size_t)n * DOUBLES, sizeof *clumps->memory);
    if (clumps->body == NULL || clumps->memory == NULL)
        return message_set(message, "%s: out of memory for the %lld spheres of its clumps; use fewer", scene->name,
                           (long long)n);
    double *block = clumps->memory;
    clumps->list.count = n;
    clumps->list.spheres = vti_bodies_none(n);
    give_views(&clumps->list.spheres, views_of(scene, tables), &block);
    fill(clumps, scene, &tables->bodies, bodies, modulus, &block);
    const int status = vti_bodies_seal(&clumps->list.spheres);
    return status == VTI_OK ? 0 : message_set(message, "%s: bodies.clumps: %s", scene->name, vti_status_text(status));
}

void clumps_destroy(struct clumps *clumps)
{
    free(clumps->template);
    free(clumps->body);
    free(clumps->memory);
    memset(clumps, 0, sizeof *clumps);
}
