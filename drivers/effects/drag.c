/* SPDX-License-Identifier: BSD-3-Clause
 * Drag: a medium slows what moves and turns in it (EQUATIONS 6.3), by coefficients of all bodies, or by those of each
 * sphere, of diameter D, in slow flow (G. G. Stokes 1851, G. Kirchhoff 1876) and in fast flow (I. Newton 1687):
 *
 *     c = 3 pi viscosity D,     c_r = pi viscosity D^3,     k = pi/8 C_D density D^2 */
#include <stdlib.h>

#include "kind.h"
#include "model.h"
#include "plain.h"
#include "scene_reader.h"

enum { ON_BODIES, ON_SPHERES };

struct drag_settings {
    double linear, quadratic, angular, medium[3];
    double viscosity, density, coefficient; /* of the medium; of the spheres in it */
    int64_t on;
};

struct drag_self {
    vti_drag drag;
    double *memory; /* coefficients of each sphere; NULL where all have the same */
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

static const struct scene_word places[] = {{"bodies", ON_BODIES}, {"spheres", ON_SPHERES}, {NULL, 0}};

#define AT(MEMBER) offsetof(struct drag_settings, MEMBER)
static const struct scene_field fields[] = {
    {"drag", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "drag of a medium",
     "A medium slows what moves and turns in it; steppers with negative coefficients are refused.", NULL},
    {"drag.linear", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, AT(linear), "coefficient c",
     "Mass per time: F = -c (v - medium), of a sphere in slow flow 3 pi viscosity D.", NULL},
    {"drag.quadratic", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, AT(quadratic), "coefficient k",
     "Mass per length: F = -k |v - medium| (v - medium), of a sphere in fast flow 0.16 to 0.2 density D^2.", NULL},
    {"drag.angular", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, AT(angular), "coefficient c_r",
     "Energy times time: RM = -c_r Omega, of a sphere in slow flow pi viscosity D^3.", NULL},
    {"drag.viscosity", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(viscosity), "dynamic viscosity",
     "Mass per length and time, in the place of linear and angular: slow flow past each sphere by its own diameter D, "
     "linear = 3 pi viscosity D and angular = pi viscosity D^3 (Stokes). Bodies turn, and of clumps each sphere feels "
     "it (on: spheres).",
     NULL},
    {"drag.density", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(density), "density of the medium",
     "Mass per volume, in the place of quadratic: fast flow past each sphere by its own diameter D, quadratic = pi/8 "
     "coefficient density D^2 (Newton); of clumps each sphere feels it (on: spheres).",
     NULL},
    {"drag.coefficient", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(coefficient), "drag coefficient C_D",
     "Of spheres, beside density; 0.44 where it is left out.", NULL},
    {"drag.medium", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(medium), "velocity of the medium",
     "What velocities tend to; [0, 0, 0] where it is left out.", NULL},
    {"drag.on", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(on), "what of clumps feels the medium",
     "bodies (without it): the velocity of the centre of mass, and Omega; spheres: each sphere of bodies.clumps the "
     "velocity v + Omega x r of its centre, with linear, quadratic and angular as they stand or those of its diameter.",
     places},
};
#undef AT

static void defaults(void *settings)
{
    ((struct drag_settings *)settings)->coefficient = 0.44; /* Reynolds' numbers from 750 to 2e5 */
}

/** The key of the scene by which translation is slowed, the first there is; NULL: none. */
static const char *slows_translation_by(const struct drag_settings *drag)
{
    return drag->viscosity > 0.0   ? "drag.viscosity"
           : drag->density > 0.0   ? "drag.density"
           : drag->linear > 0.0    ? "drag.linear"
           : drag->quadratic > 0.0 ? "drag.quadratic"
                                   : NULL;
}

/** What diameters say is not said again, and of what has none nothing is said. */
static int check_flow(const struct scene_reader *reader, const struct scene *scene, const struct drag_settings *drag)
{
    static const char *const twice[][2] = {
        {"drag.linear", "drag.viscosity"}, {"drag.angular", "drag.viscosity"}, {"drag.quadratic", "drag.density"}};
    const char *const flow = slows_translation_by(drag);
    const int has_diameter = scene->diameter != 0.0 || scene->clumps.given || scene->arrangement != SCENE_SINGLE;
    for (size_t k = 0; k < sizeof twice / sizeof twice[0]; ++k)
        if (scene_reader_has(reader, twice[k][0]) && scene_reader_has(reader, twice[k][1]))
            return scene_reader_fail(reader, twice[k][0], "given besides %s, which says it; keep one of them",
                                     twice[k][1]);
    if (scene_reader_has(reader, "drag.coefficient") && drag->density == 0.0)
        return scene_reader_fail(reader, "drag.coefficient", "given without drag.density; give that too");
    if (drag->viscosity == 0.0 && drag->density == 0.0)
        return 0;
    if (!has_diameter)
        return scene_reader_fail(reader, flow, "acts by the diameter; give bodies.diameter");
    if (scene->clumps.given && drag->on != ON_SPHERES)
        return scene_reader_fail(reader, flow, "acts by diameters, which spheres of clumps have; give on: spheres");
    return 0;
}

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct drag_settings *drag = settings;
    const char *const slows = slows_translation_by(drag);
    const int known = scene->arrangement != SCENE_IN_TABLE;
    if (slows == NULL && !scene_reader_has(reader, "drag.linear") && !scene_reader_has(reader, "drag.quadratic") &&
        !scene_reader_has(reader, "drag.angular") && !scene_reader_has(reader, "drag.coefficient"))
        return scene_reader_fail(reader, "drag",
                                 "no coefficient; give linear, quadratic or angular, viscosity or density");
    if (slows == NULL && scene_reader_has(reader, "drag.medium"))
        return scene_reader_fail(reader, "drag.medium",
                                 "nothing is drawn along with it; give linear, quadratic, viscosity or density");
    if (known && slows != NULL && !scene->translates)
        return scene_reader_fail(reader, slows,
                                 "acts on bodies that translate; give bodies.x or an arrangement of them");
    if (known && drag->angular > 0.0 && !scene->turns)
        return scene_reader_fail(reader, "drag.angular", "acts on bodies that turn; give bodies.omega");
    if (drag->on == ON_SPHERES && !scene->clumps.given)
        return scene_reader_fail(reader, "drag.on", "there are no clumps; give bodies.clumps, or leave it out");
    return check_flow(reader, scene, drag);
}

static int on_spheres(const union effect_settings *all)
{
    return ((const struct drag_settings *)kinds_settings_of(&effect_drag, all))->on == ON_SPHERES;
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

/** One value for all bodies; absent where it is 0. */
static vti_scalars coefficient(const double *value)
{
    const vti_scalars none = {NULL, 0, 0};
    return *value > 0.0 ? vti_scalars_one(value) : none;
}

static void fill(vti_drag *drag, const struct drag_settings *settings, vti_sum *lost)
{
    drag->linear = coefficient(settings->viscosity > 0.0 ? &settings->viscosity : &settings->linear);
    drag->quadratic = coefficient(settings->density > 0.0 ? &settings->density : &settings->quadratic);
    drag->angular = coefficient(settings->viscosity > 0.0 ? &settings->viscosity : &settings->angular);
    for (int k = 0; k < 3; ++k)
        drag->medium[k] = settings->medium[k];
    drag->lost = lost;
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_sum none[VTI_DRAG_BOOKS];
    vti_drag drag = {.by_body = NULL};
    (void)table;
    fill(&drag, settings, none);
    vti_effect effect = vti_drag_effect(&drag);
    effect.gives = ((const struct drag_settings *)settings)->viscosity > 0.0 ? EFFECT_MOMENT : 0;
    effect.self = effect.booked = NULL;
    return effect;
}

/** Coefficients of each sphere, in the place of what fill has put there. */
static int fill_each(struct drag_self *self, const struct drag_settings *settings, const struct model *model,
                     struct message *message)
{
    static const double pi = PLAIN_PI;
    const int64_t n = model_spheres(model)->count;
    const int slow = settings->viscosity > 0.0, fast = settings->density > 0.0;
    if (!slow && !fast)
        return 0;
    if (model->diameter.p == NULL)
        return message_set(message, "%s: %s acts by diameters; give a column diameter, or bodies.diameter",
                           model->scene->name, slows_translation_by(settings));
    double *const c = self->memory = calloc((size_t)n, 3 * sizeof *c);
    if (c == NULL)
        return scene_no_memory(model->scene, message);
    double *const angular = c + n, *const k = c + 2 * n;
    for (int64_t s = 0; s < n; ++s) {
        const double D = model->diameter.p[s * model->diameter.stride];
        c[s] = 3.0 * pi * settings->viscosity * D;
        angular[s] = pi * settings->viscosity * D * D * D;
        k[s] = pi / 8.0 * settings->coefficient * settings->density * D * D;
    }
    self->drag.linear = slow ? vti_scalars_array(c) : self->drag.linear;
    self->drag.angular = slow ? vti_scalars_array(angular) : self->drag.angular;
    self->drag.quadratic = fast ? vti_scalars_array(k) : self->drag.quadratic;
    return 0;
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    struct drag_self *self = effect_memory(e, sizeof *self, message);
    (void)table;
    if (self == NULL)
        return -1;
    const vti_drag *drag = &self->drag;
    fill(&self->drag, e->settings, e->booked);
    self->drag.by_body = e->by_body;
    if (fill_each(self, e->settings, model, message) != 0)
        return -1;
    *made = vti_drag_effect(drag);
    if ((drag->linear.p != NULL || drag->quadratic.p != NULL) && !model->translates)
        return message_set(message, "%s: drag acts on bodies that translate; give columns x, y, z", model->scene->name);
    if (drag->angular.p != NULL && !model->turns)
        return message_set(message, "%s: drag.angular acts on bodies that turn; give columns omega_x, omega_y, omega_z",
                           model->scene->name);
    return 0;
}

static double coefficient_of(const vti_scalars *c, int64_t s)
{
    return c->p != NULL ? c->p[s * c->stride] : 0.0;
}

/** |u| against the medium as of now, of body s or sphere s; 0 of bodies that do not translate. */
static double speed_of(const vti_drag *drag, const vti_bodies *feels, int64_t s)
{
    double u[3];
    if (feels->v.c[0] == NULL)
        return 0.0;
    for (int k = 0; k < 3; ++k)
        u[k] = feels->v.c[k][s * feels->v.stride] - drag->medium[k];
    return vti_norm(u);
}

static int is_turning(const vti_bodies *b, int64_t i)
{
    int turns = 0;
    for (int k = 0; k < 3 && b->omega.c[0] != NULL; ++k)
        turns |= b->omega.c[k][i * b->omega.stride] != 0.0;
    return turns;
}

/** Adds (c + 2k|u|)/m to that of a way; to that of a turn, if there is one, c_r/J by the least moment of inertia, and
 *  of a sphere of a clump what its own drag does at its arm. */
static void add_rates(const vti_drag *drag, const struct model *model, int by_spheres, int64_t s, double speed,
                      int moves, int turns, double rate[2])
{
    const double c = coefficient_of(&drag->linear, s) + 2.0 * coefficient_of(&drag->quadratic, s) * speed;
    const struct model_inverse_mass inverse = model_inverse_mass_of(model, by_spheres, s);
    rate[0] += moves ? c * inverse.per_mass : 0.0;
    rate[1] += turns ? coefficient_of(&drag->angular, s) * inverse.per_inertia + c * inverse.by_turning : 0.0;
}

/** The largest rate at which a way or a turn is slowed, of clumps by the sum over their spheres: of those that others
 *  push, or of those that there are. Whatever else acts pushes bodies on; on their turns acts what gives moments. */
static double most_slowing(const struct effect *e, const struct model *model, int pushed)
{
    const vti_drag *drag = &((const struct drag_self *)e->self)->drag;
    const int by_spheres = on_spheres(&model->scene->settings);
    const vti_bodies *feels = by_spheres ? model_spheres(model) : &model->bodies;
    double most = 0.0, rate[2] = {0.0, 0.0};
    int turned = 0;
    for (int64_t k = 0; k < model->effects_count; ++k)
        turned |= (model->effects[k].gives >> VTI_QUANTITY_MOMENT & 1) != 0;
    for (int64_t s = 0, last = -1; s < feels->count; ++s) {
        const int64_t i = by_spheres ? model->clumps.list.body[s] : s; /* spheres of a body stand together */
        const int moves = pushed || speed_of(drag, &model->bodies, i) > 0.0;
        for (int k = 0; k < 2 && i != last; ++k)
            rate[k] = 0.0;
        add_rates(drag, model, by_spheres, s, speed_of(drag, feels, s), moves,
                  pushed ? turned : is_turning(&model->bodies, i), rate);
        most = fmax(most, fmax(rate[0], rate[1]));
        last = i;
    }
    return most;
}

static double slowing(const struct effect *e, const struct model *model)
{
    return most_slowing(e, model, 1);
}

static double slowing_free(const struct effect *e, const struct model *model)
{
    return most_slowing(e, model, 0);
}

static void destroy(struct effect *e)
{
    free(((struct drag_self *)e->self)->memory);
}

static const struct effect_term terms[] = {
    {"lost_drag_translation", "$Q^{\\mathrm{d}}$", "lost to drag", "#5C7A29"},
    {"lost_drag_rotation", "$Q^{\\mathrm{d}}_\\Omega$", "lost to drag, turning", "#FF6F61"}};

const struct effect_kind effect_drag = {.number = EFFECT_drag,
                                        .key = "drag",
                                        EFFECT_FIELDS(fields),
                                        .settings = sizeof(struct drag_settings),
                                        .defaults = defaults,
                                        .check = check,
                                        .draft = draft,
                                        .on_spheres = on_spheres,
                                        .make = make,
                                        .destroy = destroy,
                                        .slowing = slowing,
                                        .slowing_free = slowing_free,
                                        EFFECT_TERMS(terms)};
