/* SPDX-License-Identifier: BSD-3-Clause
 * Dashpots where spheres touch each other and walls (EQUATIONS 6.3). */
#include <math.h>
#include <stdlib.h>

#include "chunks.h"
#include "kind.h"
#include "model.h"
#include "number.h"
#include "scene_reader.h"

struct dashpot_settings {
    double restitution, zeta, normal, tangential, ratio, rolling, twisting;
    int64_t pull;
    struct scene_numbers walls;
};

/** What the pairs whose first body is in a chunk lose in one flow. */
struct dashpot_chunk {
    vti_walls walls;
    vti_sum lost[VTI_DASHPOT_BOOKS], work;
};

struct dashpot_self {
    vti_dashpots dashpots; /* of all; what the effect acts with */
    double wall_zeta[SCENE_WALLS_MAX];
    const struct chunks *chunks; /* NULL: none, and no memory for them */
    struct dashpot_chunk *chunk;
    vti_dashpots *group; /* of each group of theirs */
    void (*flow)(const void *dashpots, const vti_bodies *bodies, double t, double drift);
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

#define NUMBER_AT(KEY, MEMBER, RANGE, ABOUT, SAYS)                                                                     \
    {                                                                                                                  \
        "dashpot." KEY, SCENE_NUMBER, SCENE_MAY, RANGE, offsetof(struct dashpot_settings, MEMBER), ABOUT, SAYS, NULL   \
    }
static const struct scene_field fields[] = {
    {"dashpot", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "dashpots of contacts and walls",
     "Damps what touches; steppers with negative coefficients are refused.", NULL},
    NUMBER_AT(
        "restitution", restitution, SCENE_POSITIVE, "restitution e",
        "Share of the normal velocity that is left after an impact at any speed, from 1e-6 to 1; in place of zeta."),
    NUMBER_AT("zeta", zeta, SCENE_NOT_NEGATIVE, "damping ratio",
              "Of the normal motion: its coefficient is 2 zeta sqrt(5/6 m k), k being the stiffness where it is."),
    NUMBER_AT("normal", normal, SCENE_NOT_NEGATIVE, "normal coefficient",
              "Mass per time, the same at any overlap; adds to what restitution or zeta gives."),
    NUMBER_AT("tangential", tangential, SCENE_NOT_NEGATIVE, "tangential coefficient",
              "Mass per time, against sliding; bodies turn then."),
    NUMBER_AT("ratio", ratio, SCENE_NOT_NEGATIVE, "ratio of coefficients",
              "Adds this share of the normal coefficient to the tangential one; bodies turn then."),
    NUMBER_AT("rolling", rolling, SCENE_NOT_NEGATIVE, "rolling coefficient",
              "Energy times time, against rolling over each other; bodies turn then."),
    NUMBER_AT("twisting", twisting, SCENE_NOT_NEGATIVE, "twisting coefficient",
              "Energy times time, against turning about the normal; bodies turn then."),
    {"dashpot.pull", SCENE_YES_NO, SCENE_MAY, SCENE_ANY, offsetof(struct dashpot_settings, pull), "dashpots that pull",
     "no (default): normal dashpots pull no harder than the contact pushes, so that what parts is not held; yes: they "
     "do.",
     NULL},
    {"dashpot.wall_restitution", SCENE_NUMBERS, SCENE_MAY, SCENE_POSITIVE, offsetof(struct dashpot_settings, walls),
     "restitution e of each wall",
     "In place of restitution or zeta: a number for each plane, then for each cylinder, from 1e-6 to 1.", NULL},
};
#undef NUMBER_AT

/** Whether the normal motion may be damped: a number that is given counts, as below. */
static int has_normal(const struct scene_reader *reader, const struct dashpot_settings *d)
{
    return scene_reader_has(reader, "dashpot.restitution") || scene_reader_has(reader, "dashpot.zeta") ||
           scene_reader_has(reader, "dashpot.normal") || d->walls.count > 0;
}

/** Whether there is a coefficient; a restitution of 1 and a zeta of 0 are what somebody may want to see. */
static int has_coefficient(const struct scene_reader *reader, const struct dashpot_settings *d)
{
    return scene_reader_has(reader, "dashpot.restitution") || scene_reader_has(reader, "dashpot.zeta") ||
           d->walls.count > 0 || d->normal > 0.0 || d->tangential > 0.0 || d->rolling > 0.0 || d->twisting > 0.0;
}

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct dashpot_settings *d = settings;
    if (scene_first_with(scene, EFFECT_SURFACES) == NULL)
        return scene_reader_fail(reader, "dashpot", "nothing touches; give contact or wall");
    if (!has_coefficient(reader, d))
        return scene_reader_fail(reader, "dashpot", "no coefficient above 0; give restitution, zeta or normal");
    if (scene_reader_has(reader, "dashpot.restitution") && scene_reader_has(reader, "dashpot.zeta"))
        return scene_reader_fail(reader, "dashpot.restitution", "given with dashpot.zeta; keep one of them");
    if (d->ratio > 0.0 && !has_normal(reader, d))
        return scene_reader_fail(reader, "dashpot.ratio",
                                 "there is no normal coefficient that it could be a share of; give restitution, zeta "
                                 "or normal, or leave it out");
    if (d->pull && !has_normal(reader, d))
        return scene_reader_fail(reader, "dashpot.pull",
                                 "there is no normal coefficient that could pull; give restitution, zeta or normal, or "
                                 "leave it out");
    if (d->restitution > 1.0)
        return scene_reader_fail(reader, "dashpot.restitution", "'%s' is above 1; give a share of the velocity",
                                 scene_reader_value(reader, "dashpot.restitution"));
    if (d->restitution > 0.0 && d->restitution < 1e-6)
        return scene_reader_fail(reader, "dashpot.restitution", "'%s' is below 1e-6; give zeta, 1 or more",
                                 scene_reader_value(reader, "dashpot.restitution"));
    for (int64_t w = 0; w < d->walls.count; ++w)
        if (d->walls.number[w] > 1.0 || d->walls.number[w] < 1e-6)
            return scene_reader_fail(reader, "dashpot.wall_restitution",
                                     "%s is not from 1e-6 to 1; give shares of the velocity",
                                     NUMBER(d->walls.number[w]));
    return 0;
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

/** All but zeta and what touches. */
static void fill(vti_dashpots *dashpots, const struct dashpot_settings *d, vti_sum *lost)
{
    dashpots->normal = d->normal;
    dashpots->tangential = d->tangential;
    dashpots->ratio = d->ratio;
    dashpots->rolling = d->rolling;
    dashpots->twisting = d->twisting;
    dashpots->pull = d->pull;
    dashpots->lost = lost;
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_sum nothing[VTI_DASHPOT_BOOKS];
    static const vti_walls none;
    const struct dashpot_settings *d = settings;
    vti_dashpots dashpots = {.walls = &none};
    (void)table;
    fill(&dashpots, d, nothing);
    vti_effect effect = vti_dashpots_effect(&dashpots);
    effect.gives = d->tangential > 0.0 || d->ratio > 0.0 || d->rolling > 0.0 || d->twisting > 0.0 ? EFFECT_MOMENT : 0;
    effect.self = effect.booked = NULL;
    return effect;
}

/* ---- by chunks --------------------------------------------------------------------------------------------------- */

struct flowing {
    const struct dashpot_self *self;
    const vti_bodies *bodies;
    double t, drift;
};

/** Bodies of one chunk are at walls, too. */
static void flow_group(void *context, int64_t g)
{
    const struct flowing *f = context;
    const struct chunk_group *group = &f->self->chunks->group[g];
    const vti_bodies own = chunks_slice(f->self->chunks, group->low, f->bodies);
    f->self->flow(&f->self->group[g], group->low == group->high ? &own : f->bodies, f->t, f->drift);
}

static void flow(const void *dashpots, const vti_bodies *bodies, double t, double drift)
{
    const struct dashpot_self *self = dashpots; /* of which they are the first member */
    struct flowing flowing = {self, bodies, t, drift};
    chunks_by_rounds(self->chunks, drift < 0.0, flow_group, &flowing);
    for (int64_t k = 0; k < self->chunks->count; ++k) {
        struct dashpot_chunk *chunk = &self->chunk[k];
        for (int n = 0; n < VTI_DASHPOT_BOOKS; ++n)
            chunks_book(&self->dashpots.lost[n], &chunk->lost[n]);
        if (self->dashpots.walls != NULL && self->dashpots.walls->work != NULL)
            chunks_book(self->dashpots.walls->work, &chunk->work);
    }
}

/** Returns 0, or -1 if memory is out. */
static int make_groups(struct dashpot_self *self, const struct chunks *chunks, const struct effect *friction)
{
    self->chunks = chunks;
    self->chunk = calloc((size_t)chunks->count, sizeof *self->chunk);
    self->group = calloc((size_t)chunks->groups, sizeof *self->group);
    if (self->chunk == NULL || self->group == NULL)
        return -1;
    for (int64_t g = 0; g < chunks->groups; ++g) {
        const struct chunk_group *of = &chunks->group[g];
        struct dashpot_chunk *chunk = &self->chunk[of->low];
        vti_dashpots *group = &self->group[g];
        *group = self->dashpots;
        group->contacts = &of->contacts;
        group->lost = chunk->lost;
        group->friction = friction != NULL ? friction->kind->friction(friction, of->low) : NULL;
        if (group->walls == NULL)
            continue;
        chunk->walls = *self->dashpots.walls;
        chunk->walls.work = &chunk->work;
        group->walls = of->low == of->high ? &chunk->walls : NULL;
    }
    return 0;
}

static void destroy(struct effect *e)
{
    struct dashpot_self *self = e->self;
    free(self->chunk);
    free(self->group);
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    const struct dashpot_settings *d = e->settings;
    struct dashpot_self *self = effect_memory(e, sizeof *self, message);
    const struct effect_surfaces surfaces = model_surfaces(model);
    const struct effect *friction = effect_with_friction(model);
    (void)table;
    if (self == NULL)
        return -1;
    vti_dashpots *dashpots = &self->dashpots;
    dashpots->contacts = surfaces.contacts;
    dashpots->walls = surfaces.walls;
    dashpots->reach = surfaces.reach;
    dashpots->friction = friction != NULL ? friction->kind->friction(friction, 0) : NULL;
    dashpots->zeta = d->restitution > 0.0 ? vti_dashpots_zeta(d->restitution, d->pull) : d->zeta;
    fill(dashpots, d, e->booked);
    dashpots->by_body = e->by_body;
    if (effect_walls_match(model, "dashpot.wall_restitution", &d->walls, surfaces.walls, message) != 0)
        return -1;
    for (int64_t w = 0; w < d->walls.count; ++w)
        self->wall_zeta[w] = vti_dashpots_zeta(d->walls.number[w], d->pull);
    dashpots->wall_zeta = d->walls.count > 0 ? self->wall_zeta : NULL;
    *made = vti_dashpots_effect(dashpots);
    if (surfaces.chunks == NULL)
        return 0;
    self->flow = made->flow;
    made->flow = flow;
    return make_groups(self, surfaces.chunks, friction) == 0 ? 0 : scene_no_memory(model->scene, message);
}

/** The largest c/m by the constants, of a sphere at a wall, or of the two that give way most, of two bodies, where they
 *  touch each other. By zeta and restitution c falls with the stiffness, and what it slows has no further to go than
 *  the overlap. */
static double slowing(const struct effect *e, const struct model *model)
{
    const vti_dashpots *d = &((const struct dashpot_self *)e->self)->dashpots;
    const double across = d->tangential + d->ratio * d->normal, turning = fmax(d->rolling, d->twisting);
    double most = 0.0, second = 0.0; /* of another body */
    int64_t at = -1;                 /* the one of most */
    for (int64_t s = 0; s < model_spheres(model)->count; ++s) {
        const struct model_inverse_mass inverse = model_inverse_mass_of(model, 1, s);
        const double radius = 0.5 * model->diameter.p[s * model->diameter.stride];
        const double along = d->normal * (inverse.per_mass + inverse.by_turning);
        const double rate =
            fmax(fmax(along, across * model_inverse_mass_at(&inverse, radius)), turning * inverse.per_inertia);
        const int64_t body = model_has_clumps(model) ? model->clumps.list.body[s] : s;
        if (body != at)
            second = fmax(second, fmin(rate, most));
        at = rate > most ? body : at;
        most = fmax(most, rate);
    }
    return d->contacts != NULL ? most + second : most;
}

static const struct effect_term terms[] = {
    {"lost_dashpot_normal", "$Q^{\\mathrm{n}}$", "lost to normal dashpots", "#6A3D9A"},
    {"lost_dashpot_tangential", "$Q^{\\mathrm{t}}$", "lost to tangential dashpots", "#DDCC77"},
    {"lost_dashpot_rolling", "$Q^{\\mathrm{r}}$", "lost to rolling dashpots", "#44AA99"},
    {"lost_dashpot_twisting", "$Q^{\\mathrm{w}}$", "lost to twisting dashpots", "#661100"}};

const struct effect_kind effect_dashpot = {.number = EFFECT_dashpot,
                                           .key = "dashpot",
                                           EFFECT_FIELDS(fields),
                                           .settings = sizeof(struct dashpot_settings),
                                           .check = check,
                                           .draft = draft,
                                           .spheres = 1,
                                           .near = 1,
                                           .make = make,
                                           .slowing = slowing,
                                           .destroy = destroy,
                                           EFFECT_TERMS(terms)};
