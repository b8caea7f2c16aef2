/* SPDX-License-Identifier: BSD-3-Clause
 * Walls: rigid planes that spheres touch (EQUATIONS 3). */
#include <stdio.h>

#include "hertz.h"
#include "kind.h"
#include "model.h"
#include "scene_reader.h"

struct wall_settings {
    double stiffness;
    struct scene_planes planes;
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

static const struct scene_field fields[] = {
    {"wall", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "rigid planes",
     "Rigid planes that keep bodies on one side.", NULL},
    {"wall.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, offsetof(struct wall_settings, stiffness),
     "stiffness K^pw", "Energy: an overlap costs 2/5 K^pw (1 - g/(D/2))^(5/2), g being the distance of the centre.",
     NULL},
    {"wall.planes", SCENE_PLANES, SCENE_MAY, SCENE_ANY, offsetof(struct wall_settings, planes),
     "planes nx x + ny y + nz z = d", "Rows nx, ny, nz, d; bodies stay where n.x > d; n need not be of unit length.",
     NULL},
};

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct wall_settings *wall = settings;
    (void)scene;
    if (wall->planes.count > 0)
        return 0;
    return scene_reader_fail(reader, "wall.planes", "no planes; give a list of them, such as [[1, 0, 0, 0]]");
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static vti_effect draft(const void *settings, const struct table *table)
{
    static const vti_walls none;
    (void)settings, (void)table;
    return vti_walls_effect(&none);
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    const struct wall_settings *wall = e->settings;
    vti_walls *walls = effect_memory(e, sizeof *walls, message);
    (void)table;
    if (walls == NULL)
        return -1;
    walls->count = wall->planes.count;
    walls->plane = wall->planes.plane[0];
    walls->diameter = model->diameter;
    walls->stiffness = wall->stiffness;
    *made = vti_walls_effect(walls);
    return 0;
}

static void surfaces(const struct effect *e, struct effect_surfaces *surfaces)
{
    surfaces->walls = e->self;
}

/* ---- what it tells ----------------------------------------------------------------------------------------------- */

static int64_t planes(const struct effect *e, const double **plane)
{
    const vti_walls *walls = e->self;
    *plane = walls->plane;
    return walls->count;
}

static void limit(const vti_deformation *at, const vti_stable *stable, char *text, size_t size)
{
    (void)at;
    snprintf(text, size, "wall %lld at body %lld", (long long)stable->element, (long long)stable->i);
}

static void deform(const struct effect *e, const vti_bodies *bodies, double energy, vti_deformation *at)
{
    (void)bodies;
    hertz_deform(((const struct wall_settings *)e->settings)->stiffness, energy, at);
}

static const struct effect_planes drawn = {"wall", planes};

static const struct effect_term terms[] = {{"wall", "$U^{\\mathrm{pw}}$", "particle-wall", "#009E73"}};

const struct effect_kind effect_wall = {.number = EFFECT_wall,
                                        .key = "wall",
                                        EFFECT_FIELDS(fields),
                                        .settings = sizeof(struct wall_settings),
                                        .check = check,
                                        .draft = draft,
                                        .spheres = 1,
                                        .make = make,
                                        EFFECT_TERMS(terms),
                                        .limit = limit,
                                        .deform = deform,
                                        .planes = &drawn,
                                        .surfaces = surfaces};
