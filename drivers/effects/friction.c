/* SPDX-License-Identifier: BSD-3-Clause
 * Friction where spheres touch each other and walls: sliding, rolling, twisting (EQUATIONS 6.5). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "friction.h"
#include "model.h"
#include "number.h"
#include "scene_reader.h"
#include "tables.h"

struct friction_settings {
    double sliding, stiffness, poisson, rolling, rolling_stiffness, twisting, twisting_stiffness;
    struct scene_numbers walls;
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

#define NUMBER_AT(KEY, RANGE, ABOUT, SAYS)                                                                             \
    {                                                                                                                  \
        "friction." #KEY, SCENE_NUMBER, SCENE_MAY, RANGE, offsetof(struct friction_settings, KEY), ABOUT, SAYS, NULL   \
    }
static const struct scene_field fields[] = {
    {"friction", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "friction of contacts and walls",
     "Springs that slide where they would hold more than a share of the normal force; bodies turn then, and steppers "
     "with negative coefficients are refused.",
     NULL},
    NUMBER_AT(sliding, SCENE_NOT_NEGATIVE, "coefficient mu", "Sliding friction is at most mu times the normal force."),
    NUMBER_AT(stiffness, SCENE_POSITIVE, "tangential stiffness", "Force per length of the sliding spring, a constant."),
    NUMBER_AT(poisson, SCENE_POISSON, "Poisson's ratio nu",
              "In place of stiffness: 2 (1 - nu)/(2 - nu) times the normal stiffness, which changes with the overlap "
              "(Mindlin); one number for all pairs and walls, whatever materials these are of."),
    NUMBER_AT(rolling, SCENE_NOT_NEGATIVE, "length mu_r",
              "The moment against rolling is at most mu_r times the force."),
    NUMBER_AT(rolling_stiffness, SCENE_POSITIVE, "rolling stiffness", "Moment per angle."),
    NUMBER_AT(twisting, SCENE_NOT_NEGATIVE, "length mu_w",
              "The moment against turning about the normal is at most mu_w times the force."),
    NUMBER_AT(twisting_stiffness, SCENE_POSITIVE, "twisting stiffness", "Moment per angle."),
    {"friction.wall_sliding", SCENE_NUMBERS, SCENE_MAY, SCENE_NOT_NEGATIVE, offsetof(struct friction_settings, walls),
     "coefficient mu of each wall",
     "In place of sliding, which is to be above 0 still: a number for each plane, then for each cylinder.", NULL},
};
#undef NUMBER_AT

/** Of 0 there is no spring and no limit: a dashpot beside it would act without one. */
static int check_zero(const struct scene_reader *reader, const char *limit, double value, const char *dashpot)
{
    if (value > 0.0 || !scene_reader_has(reader, limit) || !scene_reader_has(reader, dashpot))
        return 0;
    return scene_reader_fail(reader, limit, "is 0, which sets %s no limit; leave that out, or give a limit above 0",
                             dashpot);
}

/** A coefficient and its stiffness go together; one that is 0 is what somebody may want to see. */
static int check_pair(const struct scene_reader *reader, const char *limit, double value, const char *stiffness)
{
    if (value > 0.0 && !scene_reader_has(reader, stiffness))
        return scene_reader_fail(reader, limit, "has no stiffness; give %s", stiffness);
    if (scene_reader_has(reader, stiffness) && !scene_reader_has(reader, limit))
        return scene_reader_fail(reader, stiffness, "has no limit, and would do nothing; give %s, or leave it out",
                                 limit);
    return 0;
}

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct friction_settings *f = settings;
    const int linear = scene_reader_has(reader, "friction.stiffness"),
              mindlin = scene_reader_has(reader, "friction.poisson");
    if (scene_first_with(scene, EFFECT_SURFACES) == NULL)
        return scene_reader_fail(reader, "friction", "nothing touches; give contact or wall");
    if (scene_reader_has(reader, "friction.wall_sliding") && !(f->sliding > 0.0))
        return scene_reader_fail(reader, "friction.wall_sliding",
                                 "needs friction.sliding, that of bodies; give one above 0, as small as you like");
    if (!(f->sliding > 0.0 || f->rolling > 0.0 || f->twisting > 0.0))
        return scene_reader_fail(reader, "friction", "no coefficient above 0; give sliding, rolling or twisting");
    if (check_zero(reader, "friction.sliding", f->sliding, "dashpot.tangential") != 0 ||
        check_zero(reader, "friction.sliding", f->sliding, "dashpot.ratio") != 0 ||
        check_zero(reader, "friction.rolling", f->rolling, "dashpot.rolling") != 0 ||
        check_zero(reader, "friction.twisting", f->twisting, "dashpot.twisting") != 0)
        return -1;
    if (linear && mindlin)
        return scene_reader_fail(reader, "friction.poisson", "given with friction.stiffness; keep one of them");
    if (f->sliding > 0.0 && !linear && !mindlin)
        return scene_reader_fail(reader, "friction.sliding",
                                 "has no stiffness; give friction.stiffness or friction.poisson");
    if ((linear || mindlin) && !scene_reader_has(reader, "friction.sliding"))
        return scene_reader_fail(reader, linear ? "friction.stiffness" : "friction.poisson",
                                 "has no limit, and would do nothing; give friction.sliding, or leave it out");
    return check_pair(reader, "friction.rolling", f->rolling, "friction.rolling_stiffness") != 0
               ? -1
               : check_pair(reader, "friction.twisting", f->twisting, "friction.twisting_stiffness");
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

/** All but what touches. */
static void fill(vti_friction *friction, const struct friction_settings *f, vti_history *history, vti_sum *lost)
{
    friction->sliding = f->sliding;
    friction->stiffness = f->sliding > 0.0 ? f->stiffness : 0.0;
    friction->mindlin = f->sliding > 0.0 && f->stiffness == 0.0 ? 2.0 * (1.0 - f->poisson) / (2.0 - f->poisson) : 0.0;
    friction->rolling = f->rolling;
    friction->rolling_stiffness = f->rolling_stiffness;
    friction->twisting = f->twisting;
    friction->twisting_stiffness = f->twisting_stiffness;
    friction->history = history;
    friction->lost = lost;
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_sum nothing[VTI_FRICTION_BOOKS];
    static vti_history empty;
    static const vti_walls none;
    vti_friction friction = {.walls = &none};
    (void)table;
    fill(&friction, settings, &empty, nothing);
    vti_effect effect = vti_friction_effect(&friction);
    effect.self = effect.booked = NULL;
    return effect;
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    struct friction_self *self = effect_memory(e, sizeof *self, message);
    const struct effect_surfaces surfaces = model_surfaces(model);
    (void)table;
    if (self == NULL)
        return -1;
    self->diameter = model->diameter;
    self->friction.contacts = surfaces.contacts;
    self->friction.walls = surfaces.walls;
    self->friction.reach = surfaces.reach;
    const struct friction_settings *f = e->settings;
    if (effect_walls_match(model, "friction.wall_sliding", &f->walls, surfaces.walls, message) != 0)
        return -1;
    self->friction.wall_sliding = f->walls.count > 0 ? f->walls.number : NULL;
    self->chunks = surfaces.chunks;
    fill(&self->friction, e->settings, NULL, e->booked);
    self->friction.by_body = e->by_body;
    if (friction_make_chunks(self) != 0)
        return scene_no_memory(model->scene, message);
    *made = vti_friction_effect(&self->friction);
    friction_by_chunks(self, made);
    return 0;
}

static void destroy(struct effect *e)
{
    struct friction_self *self = e->self;
    for (int64_t k = 0; self->chunk != NULL && k < self->count; ++k)
        friction_free(&self->chunk[k].history);
    free(self->chunk);
    free(self->by_pair);
}

static const vti_friction *friction_of(const struct effect *e, int64_t k)
{
    const struct friction_self *self = e->self;
    return self->chunks != NULL ? &self->chunk[k].friction : &self->friction;
}

/* ---- what it tells ----------------------------------------------------------------------------------------------- */

/** The number at a path of another effect's keys. */
static double number_of(const struct scene *scene, const struct effect_kind *kind, const char *path)
{
    double number = 0.0;
    for (int f = 0; f < kind->fields_count; ++f)
        if (strcmp(kind->fields[f].path, path) == 0)
            memcpy(&number, (const char *)kinds_settings_of(kind, &scene->settings) + kind->fields[f].offset,
                   sizeof number);
    return number;
}

/** Where materials have another ratio of Poisson's than this one, which is that of all pairs. */
static void note(const struct effect *e, const struct model *model, char *text, size_t size_of_text)
{
    const struct friction_settings *f = e->settings;
    const struct scene *scene = model->scene;
    const struct table *bodies = scene->tables != NULL ? &scene->tables->bodies : NULL;
    char other[96] = "";
    text[0] = '\0';
    if (!(f->sliding > 0.0) || f->stiffness > 0.0)
        return;
    const double of_contact = number_of(scene, &effect_contact, "contact.poisson"),
                 of_wall = number_of(scene, &effect_wall, "wall.poisson");
    if (number_of(scene, &effect_wall, "wall.young") > 0.0 && of_wall != f->poisson)
        snprintf(other, sizeof other, "wall.poisson = %s", NUMBER(of_wall));
    if (number_of(scene, &effect_contact, "contact.young") > 0.0 && of_contact != f->poisson)
        snprintf(other, sizeof other, "contact.poisson = %s", NUMBER(of_contact));
    for (int64_t i = 0; bodies != NULL && table_has(bodies, BODY_POISSON) && i < bodies->rows; ++i)
        if (bodies->column[BODY_POISSON][i] != f->poisson) {
            snprintf(other, sizeof other, "poisson = %s of body %lld in the table",
                     NUMBER(bodies->column[BODY_POISSON][i]), (long long)model_number(model, i));
            break;
        }
    if (other[0] != '\0')
        snprintf(text, size_of_text,
                 "friction.poisson = %s is used for all pairs and walls; %s is for normal forces alone",
                 NUMBER(f->poisson), other);
}

static void limit(const struct effect *e, const vti_deformation *at, const vti_stable *stable, char *text,
                  size_t size_of_text)
{
    (void)e;
    if (stable->j >= 0)
        snprintf(text, size_of_text, "friction of bodies %lld and %lld", (long long)stable->i, (long long)stable->j);
    else
        snprintf(text, size_of_text,
                 at != NULL && at->meet ? "friction of a future contact of body %lld" : "friction at body %lld",
                 (long long)stable->i);
}

static const struct effect_term terms[] = {
    {"friction_sliding", "$U^{\\mathrm{t}}$", "friction springs", "#F0E442"},
    {"friction_rolling", "$U^{\\mathrm{r}}$", "rolling springs", "#CC79A7"},
    {"friction_twisting", "$U^{\\mathrm{w}}$", "twisting springs", "#BBBBBB"},
    {"lost_friction_sliding", "$Q^{\\mathrm{ft}}$", "lost to sliding", "#BB5566"},
    {"lost_friction_rolling", "$Q^{\\mathrm{fr}}$", "lost to rolling", "#117733"},
    {"lost_friction_twisting", "$Q^{\\mathrm{fw}}$", "lost to twisting", "#004488"}};

const struct effect_kind effect_friction = {.number = EFFECT_friction,
                                            .key = "friction",
                                            EFFECT_FIELDS(fields),
                                            .settings = sizeof(struct friction_settings),
                                            .check = check,
                                            .draft = draft,
                                            .spheres = 1,
                                            .near = 1,
                                            .make = make,
                                            .destroy = destroy,
                                            .find_pairs = friction_find_pairs,
                                            .take_part = friction_take_part,
                                            EFFECT_TERMS(terms),
                                            .note = note,
                                            .limit = limit,
                                            .friction = friction_of,
                                            .memory = &friction_memory};
