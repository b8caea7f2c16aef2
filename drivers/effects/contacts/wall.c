/* SPDX-License-Identifier: BSD-3-Clause
 * Walls: rigid planes and cylinders that spheres touch, and that may move (EQUATIONS 3). */
#include <stdio.h>
#include <string.h>

#include "hertz.h"
#include "kind.h"
#include "model.h"
#include "wall.h"

struct wall_self {
    vti_walls walls;
    vti_wall_motion motion[SCENE_WALLS_MAX];
    double moduli[SCENE_WALLS_MAX];
};

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static int moves(const struct wall_settings *wall)
{
    int any = 0;
    for (int64_t w = 0; w < wall->spins.count; ++w)
        any |= wall->spins.number[w] != 0.0;
    for (int64_t w = 0; w < wall->velocities.count; ++w)
        any |= vti_norm(wall->velocities.vector[w]) > 0.0;
    return any;
}

/** All but bodies and motion. */
static void fill(vti_walls *walls, const struct wall_settings *wall)
{
    walls->count = wall->planes.count;
    walls->plane = wall->planes.plane[0];
    walls->cylinders = wall->cylinders.count;
    walls->cylinder = wall->cylinders.cylinder[0];
    walls->stiffness = wall->stiffness;
    walls->each = wall->each.count > 0 ? wall->each.number : NULL;
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_wall_motion motion;
    static vti_sum nothing;
    const vti_walls none = {.motion = moves(settings) ? &motion : NULL, .work = &nothing};
    (void)table;
    vti_effect effect = vti_walls_effect(&none);
    effect.self = effect.booked = NULL;
    return effect;
}

/** E/(1 - nu^2) of the bodies: what their contact has, or their table. */
static vti_scalars modulus_of_bodies(const struct model *model)
{
    const vti_contacts *contacts = model_surfaces(model).contacts;
    return contacts != NULL && contacts->modulus.p != NULL ? contacts->modulus : model->modulus;
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    const struct wall_settings *wall = e->settings;
    struct wall_self *self = effect_memory(e, sizeof *self, message);
    (void)table;
    if (self == NULL)
        return -1;
    fill(&self->walls, wall);
    self->walls.diameter = model->diameter;
    self->walls.work = e->booked;
    self->walls.by_body = e->by_body;
    if (wall->young > 0.0) {
        self->walls.modulus = modulus_of_bodies(model);
        self->walls.moduli = self->moduli;
        for (int64_t w = 0; w < wall_settings_count(wall); ++w)
            self->moduli[w] = hertz_modulus(wall->young, wall->poisson);
        if (self->walls.modulus.p == NULL)
            return message_set(message,
                               "%s: wall.young: bodies have no material; give contact.young and contact.poisson, or "
                               "columns young and poisson of bodies.table",
                               model->scene->name);
    }
    for (int64_t w = 0; w < wall->spins.count; ++w)
        self->motion[w].spin = wall->spins.number[w];
    for (int64_t w = 0; w < wall->velocities.count; ++w)
        memcpy(self->motion[w].velocity, wall->velocities.vector[w], sizeof self->motion[w].velocity);
    if (moves(wall))
        self->walls.motion = self->motion;
    *made = vti_walls_effect(&self->walls);
    return 0;
}

static const vti_walls *walls_of(const struct effect *e)
{
    return &((const struct wall_self *)e->self)->walls;
}

static void surfaces(const struct effect *e, struct effect_surfaces *surfaces)
{
    surfaces->walls = walls_of(e);
}

/* ---- what it remembers: how far walls have come ------------------------------------------------------------------ */

static int64_t size(const struct effect *e)
{
    return walls_of(e)->motion != NULL ? 3 * wall_settings_count(e->settings) : 0;
}

static void get(const struct effect *e, double *memory)
{
    const struct wall_self *self = e->self;
    for (int64_t k = 0; k < size(e); ++k)
        memory[k] = self->motion[k / 3].moved[k % 3];
}

static int64_t put(struct effect *e, const double *memory, int64_t left)
{
    struct wall_self *self = e->self;
    if (left < size(e))
        return -1;
    for (int64_t k = 0; k < size(e); ++k)
        self->motion[k / 3].moved[k % 3] = memory[k];
    return size(e);
}

static const struct effect_memory_of remembered = {size, get, put};

/* ---- what it tells ----------------------------------------------------------------------------------------------- */

static int64_t planes(const struct effect *e, const double **plane)
{
    *plane = walls_of(e)->plane;
    return walls_of(e)->count;
}

static int64_t cylinders(const struct effect *e, const double **cylinder)
{
    *cylinder = walls_of(e)->cylinder;
    return walls_of(e)->cylinders;
}

static const vti_wall_motion *motion(const struct effect *e)
{
    return walls_of(e)->motion;
}

static void limit(const struct effect *e, const vti_deformation *at, const vti_stable *stable, char *text,
                  size_t size_of_text)
{
    (void)e, (void)at;
    if (stable->element < 0) /* of clumps */
        snprintf(text, size_of_text, "pull of walls on body %lld", (long long)stable->i);
    else
        snprintf(text, size_of_text, "wall %lld at body %lld", (long long)stable->element, (long long)stable->i);
}

/** A wall that moves brings m V^2 on top. */
static void deform(const struct effect *e, const vti_bodies *bodies, double energy, vti_deformation *at)
{
    const int64_t walls = wall_settings_count(e->settings), alike = walls_of(e)->modulus.p == NULL;
    double least = INFINITY, heaviest = 0.0;
    for (int64_t w = 0; w < walls; ++w)
        for (int64_t i = 0; i < (alike ? 1 : bodies->count); ++i)
            least = fmin(least, vti_walls_stiffness(walls_of(e), w, i));
    for (int64_t i = 0; i < bodies->count && walls_of(e)->motion != NULL; ++i)
        heaviest = fmax(heaviest, bodies->mass.p[i * bodies->mass.stride]);
    hertz_deform(least, energy + heaviest * wall_fastest(walls_of(e), bodies), at);
}

static double approach(const struct effect *e, const double x[3], const double v[3])
{
    return wall_approach(walls_of(e), x, v);
}

static double held(const struct effect *e, const vti_bodies *spheres)
{
    return wall_held(walls_of(e), spheres);
}

static double deepest(const struct effect *e, const vti_bodies *spheres)
{
    double share;
    int64_t wall;
    wall_deepest(walls_of(e), spheres, 0.0, &share, &wall);
    return share;
}

static double missed(const struct effect *e, const struct effect_way *way)
{
    return wall_missed(walls_of(e), way);
}

/** The body of a sphere as people number it. */
static long long number_of(const struct model *model, int64_t sphere)
{
    return model_number(model, model_has_clumps(model) ? model->clumps.list.body[sphere] : sphere);
}

/** The first wall whose motion nothing feels, for want of what acts along faces; -1: none. */
static int64_t unfelt(const struct effect *e, const struct scene *scene)
{
    return scene->has[EFFECT_friction] || scene->has[EFFECT_dashpot] ? -1 : wall_first_sliding(walls_of(e));
}

/** One that fills a cylinder, which always presses it and from another side as it crosses the axis; or one that begins
 *  deep in a wall, or behind it: mostly a mistake. Clumps are named whose spheres they are. Else a wall that moves to
 *  no effect. */
static void note(const struct effect *e, const struct model *model, char *text, size_t size_of_text)
{
    const double much = 0.2;
    double share;
    int64_t wall = -1;
    const int64_t filling = wall_first_filled(walls_of(e), model_spheres(model), &wall);
    const int64_t at = filling < 0 ? wall_deepest(walls_of(e), model_spheres(model), much, &share, &wall) : -1;
    const int64_t idle = unfelt(e, model->scene);
    text[0] = '\0';
    if (idle >= 0)
        snprintf(text, size_of_text,
                 "wall %lld moves along its own face, which nothing feels; give friction or dashpot, or let it rest",
                 (long long)idle);
    if (filling >= 0)
        snprintf(text, size_of_text,
                 "body %lld is as wide as wall %lld, a cylinder: where it crosses the axis its force turns round at "
                 "once, and the order is lost; widen the cylinder if that is not meant",
                 number_of(model, filling), (long long)wall);
    if (at >= 0)
        snprintf(text, size_of_text,
                 "body %lld is %.3g radii deep in wall %lld at t = 0, and none is deeper; move it if that is not meant",
                 number_of(model, at), share, (long long)wall);
}

static int by_material(const struct effect *e)
{
    return ((const struct wall_settings *)e->settings)->young > 0.0;
}

static const struct effect_planes faces = {"wall", planes, cylinders, motion, approach};

static const struct effect_term terms[] = {{"wall", "$U^{\\mathrm{pw}}$", "particle-wall", "#009E73"},
                                           {"work_wall", "$-W^{\\mathrm{pw}}$", "taken by moving walls", "#14505C"}};

const struct effect_kind effect_wall = {.number = EFFECT_wall,
                                        .key = "wall",
                                        EFFECT_FIELDS(wall_fields),
                                        .settings = sizeof(struct wall_settings),
                                        .check = wall_check,
                                        .draft = draft,
                                        .spheres = 1,
                                        .make = make,
                                        EFFECT_TERMS(terms),
                                        .note = note,
                                        .limit = limit,
                                        .deform = deform,
                                        .held = held,
                                        .deepest = deepest,
                                        .missed = missed,
                                        .planes = &faces,
                                        .surfaces = surfaces,
                                        .by_material = by_material,
                                        .memory = &remembered};
