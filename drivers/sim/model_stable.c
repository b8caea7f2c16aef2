/* SPDX-License-Identifier: BSD-3-Clause */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model.h"

/* ---- how far bodies get from rest -------------------------------------------------------------------------------- */

static void load(const vti_view *view, int64_t i, double r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = view->c[0] != NULL ? view->c[k][i * view->stride] : 0.0;
}

static double scalar(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** How many planes the effect has, [count][4] in *plane. */
static int64_t planes_of(const struct effect *e, const double **plane)
{
    return e->kind->planes != NULL ? e->kind->planes->get(e, plane) : 0;
}

/** How many cylinders, [count][7] in *cylinder: axis, a point on it, radius. */
static int64_t cylinders_of(const struct effect *e, const double **cylinder)
{
    const struct effect_planes *p = e->kind->planes;
    return p != NULL && p->cylinders != NULL ? p->cylinders(e, cylinder) : 0;
}

static int has_walls(const struct model *model)
{
    const double *face;
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (planes_of(&model->instances[k], &face) > 0 || cylinders_of(&model->instances[k], &face) > 0)
            return 1;
    return 0;
}

/** The acceleration of all fields. */
static void fields_of(const struct model *model, double g[3])
{
    g[0] = g[1] = g[2] = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        const double *more = e->kind->field != NULL ? e->kind->field(e) : g;
        for (int c = 0; c < 3 && more != g; ++c)
            g[c] += more[c];
    }
}

/** How far a sphere at x goes along the unit vector d until its surface meets the plane; infinite if it goes away from
 *  it. */
static double way_to_plane(const double plane[4], const double x[3], const double d[3], double radius)
{
    const double towards = -vti_dot(plane, d);
    return towards > 0.0 ? fmax(vti_dot(plane, x) - plane[3] - radius, 0.0) / towards : INFINITY;
}

/** The same of a cylinder that it is in: of s >= 0 with |rho + s a| = R - radius, rho and a being what of its place and
 *  of d is across the axis; or down to the lowest line, to which it bounces, if that is further. Infinite along the
 *  axis. */
static double way_to_cylinder(const double cylinder[7], const double x[3], const double d[3], double radius)
{
    static const double rounding = 1e-24; /* of a^2 */
    double from[3], rho[3], a[3];
    for (int k = 0; k < 3; ++k)
        from[k] = x[k] - cylinder[3 + k];
    for (int k = 0; k < 3; ++k) {
        rho[k] = from[k] - vti_dot(cylinder, from) * cylinder[k];
        a[k] = d[k] - vti_dot(cylinder, d) * cylinder[k];
    }
    const double aa = vti_dot(a, a), out = vti_dot(rho, a), room = fmax(cylinder[6] - radius, 0.0);
    const double inside = room * room - vti_dot(rho, rho);
    const double straight = (sqrt(fmax(out * out + aa * inside, 0.0)) - out) / aa, lowest = sqrt(aa) * room - out;
    return aa < rounding ? INFINITY : fmax(fmax(straight, lowest), 0.0);
}

/** How far sphere i falls along g until its surface meets the first wall in its way; 0 if none is. */
static double fall(const struct model *model, const vti_bodies *spheres, int64_t i, const double g[3])
{
    const double length = vti_norm(g), radius = 0.5 * scalar(&model->diameter, i);
    const double down[3] = {g[0] / length, g[1] / length, g[2] / length};
    double least = INFINITY, centre[3];
    load(&spheres->x, i, centre);
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const double *plane = NULL, *cylinder = NULL;
        const int64_t planes = planes_of(&model->instances[k], &plane),
                      cylinders = cylinders_of(&model->instances[k], &cylinder);
        for (int64_t w = 0; w < planes; ++w)
            least = fmin(least, way_to_plane(plane + 4 * w, centre, down, radius));
        for (int64_t w = 0; w < cylinders; ++w)
            least = fmin(least, way_to_cylinder(cylinder + 7 * w, centre, down, radius));
    }
    return isfinite(least) ? least : 0.0;
}

/** The velocity of the centre of mass, which deforms nothing but along axes on which walls act. */
static void velocity_of_whole(const struct model *model, const vti_bodies *b, double whole[3])
{
    double mass = 0.0, momentum[3] = {0.0, 0.0, 0.0};
    int64_t broken = 0;
    for (int64_t e = 0; e < model->effects_count && has_walls(model); ++e)
        broken |= model->effects[e].breaks;
    for (int64_t i = 0; i < b->count && model->translates; ++i) {
        double v[3];
        load(&b->v, i, v);
        mass += scalar(&b->mass, i);
        for (int k = 0; k < 3; ++k)
            momentum[k] += scalar(&b->mass, i) * v[k];
    }
    for (int k = 0; k < 3; ++k)
        whole[k] = mass > 0.0 && (broken >> k & 1) == 0 ? momentum[k] / mass : 0.0;
}

/** m v^2 of body i less the velocity of the whole, and 2 T of how it turns, if it is a clump, whose spheres that
 *  moves. */
static double energy_of_two(const struct model *model, const vti_bodies *b, int64_t i, const double whole[3])
{
    const vti_bodies one = vti_bodies_slice(*b, i, 1);
    double v[3];
    load(&b->v, i, v);
    for (int k = 0; k < 3; ++k)
        v[k] -= whole[k];
    return scalar(&b->mass, i) * vti_dot(v, v) + (model_has_clumps(model) ? 2.0 * vti_kinetic_rotation(&one) : 0.0);
}

/** What effect k acts on: the bodies, or their spheres. */
static const vti_bodies *acted_on(const struct model *model, int64_t k, const vti_bodies *bodies)
{
    return model->on_spheres[k] ? model_spheres(model) : bodies;
}

/** Twice the largest energy that a single contact, wall or bond holds already, which all may go to one body. */
static double energy_held(const struct model *model, const vti_bodies *b)
{
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (model->instances[k].kind->held != NULL)
            most = fmax(most, model->instances[k].kind->held(&model->instances[k], acted_on(model, k, b)));
    return 2.0 * most;
}

/** The energy that two bodies bring to where they meet, at most. */
static double energy_to_meet(const struct model *model, const vti_bodies *b)
{
    double most = 0.0, whole[3], g[3];
    velocity_of_whole(model, b, whole);
    fields_of(model, g);
    const int falls = vti_norm(g) > 0.0 && has_walls(model);
    const vti_bodies *spheres = model_has_clumps(model) ? model_spheres(model) : b;
    for (int64_t s = 0; s < spheres->count && model->translates; ++s) {
        const int64_t i = model_has_clumps(model) ? model->clumps.list.body[s] : s;
        const double weight = falls ? scalar(&b->mass, i) * vti_norm(g) * fall(model, spheres, s, g) : 0.0;
        most = fmax(most, energy_of_two(model, b, i, whole) + weight);
    }
    return most;
}

static vti_deformation deformation_by(const struct model *model, const vti_bodies *bodies, double energy)
{
    vti_deformation at = {0.0, 0.0, 0};
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (model->instances[k].kind->deform != NULL)
            model->instances[k].kind->deform(&model->instances[k], acted_on(model, k, bodies), energy, &at);
    return at;
}

/** m g D, by which the weight of what overlaps rises with the overlap, of the heaviest; 0 where nothing falls to a
 *  wall. */
static double weight_to_sink(const struct model *model, const vti_bodies *b)
{
    double most = 0.0, g[3];
    fields_of(model, g);
    const vti_bodies *spheres = model_has_clumps(model) ? model_spheres(model) : b;
    const int falls = model->translates && has_walls(model);
    for (int64_t s = 0; s < spheres->count && falls; ++s) {
        const int64_t i = model_has_clumps(model) ? model->clumps.list.body[s] : s;
        most = fmax(most, scalar(&b->mass, i) * vti_norm(g) * scalar(&model->diameter, s));
    }
    return most;
}

/** Bodies that touch a wall and have no energy sink into it from rest, until the springs hold what that sets free. The
 *  overlap is that energy's, which grows as its power 2/5: a fixed point to which any start comes. */
vti_deformation model_deformation(const struct model *model, const vti_bodies *bodies)
{
    enum { TIMES = 16 };
    const double energy = energy_to_meet(model, bodies) + energy_held(model, bodies);
    const double weight = weight_to_sink(model, bodies);
    if (!(energy < weight))
        return deformation_by(model, bodies, energy);
    vti_deformation at = deformation_by(model, bodies, weight);
    for (int k = 0; k < TIMES; ++k)
        at = deformation_by(model, bodies, fmax(energy, weight * at.overlap));
    return at;
}

/* ---- the bound --------------------------------------------------------------------------------------------------- */

/** That of these effects alone. */
static int stable_step(const struct model *model, const vti_effect *effects, int64_t count, const vti_bodies *bodies,
                       const vti_deformation *at, vti_stable *stable, struct message *message)
{
    double *scratch = calloc(bodies->count > 0 ? (size_t)bodies->count : 1, sizeof *scratch);
    if (scratch == NULL)
        return scene_no_memory(model->scene, message);
    const int status = vti_stable_step(effects, count, bodies, at, scratch, stable);
    free(scratch);
    return status == VTI_OK ? 0 : message_set(message, "%s: %s", model->scene->name, vti_status_text(status));
}

int model_stable_step(const struct model *model, const vti_bodies *bodies, const vti_deformation *at,
                      vti_stable *stable, struct message *message)
{
    return stable_step(model, model->effects, model->effects_count, bodies, at, stable, message);
}

int model_longest_gap(const struct model *model, double *gap, struct message *message)
{
    const vti_deformation at = model_deformation(model, &model->bodies);
    *gap = INFINITY;
    for (int64_t k = 0; k < model->effects_count; ++k) {
        const vti_effect *e = &model->effects[k];
        vti_stable stable = {.h = INFINITY};
        if (e->smooth || e->rupture != NULL || e->apply == NULL)
            continue;
        if (stable_step(model, e, 1, &model->bodies, &at, &stable, message) != 0)
            return -1;
        *gap = fmin(*gap, 1.5 * stable.h); /* h is 2/omega */
    }
    return 0;
}

void model_limit_text(const struct model *model, const vti_deformation *at, const vti_stable *stable, char *text,
                      size_t size)
{
    const int64_t k = stable->effect;
    if (k < 0)
        snprintf(text, size, "nothing oscillates");
    else if (k < model->instances_count && model->instances[k].kind->limit != NULL)
        model->instances[k].kind->limit(&model->instances[k], at, stable, text, size);
    else if (stable->j < 0)
        snprintf(text, size, "%s at body %lld", model->effects[k].name, (long long)stable->i);
    else
        snprintf(text, size, "%s of bodies %lld and %lld", model->effects[k].name, (long long)stable->i,
                 (long long)stable->j);
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
