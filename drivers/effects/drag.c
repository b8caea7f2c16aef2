/* SPDX-License-Identifier: BSD-3-Clause
 * Drag: a medium slows what moves and turns in it (EQUATIONS 6.3). */
#include "kind.h"
#include "model.h"
#include "scene_reader.h"

enum { ON_BODIES, ON_SPHERES };

struct drag_settings {
    double linear, quadratic, angular, medium[3];
    int64_t on;
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
     "Mass per length: F = -k |v - medium| (v - medium), of a sphere in fast flow 0.2 to 0.25 density D^2.", NULL},
    {"drag.angular", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, AT(angular), "coefficient c_r",
     "Energy times time: RM = -c_r Omega, of a sphere in slow flow pi viscosity D^3.", NULL},
    {"drag.medium", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(medium), "velocity of the medium",
     "What velocities tend to; [0, 0, 0] where it is left out.", NULL},
    {"drag.on", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(on), "what of clumps feels the medium",
     "bodies (without it): the velocity of the centre of mass, and Omega; spheres: each sphere of bodies.clumps, with "
     "these coefficients, the velocity v + Omega x r of its centre.",
     places},
};
#undef AT

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct drag_settings *drag = settings;
    const int slows = drag->linear > 0.0 || drag->quadratic > 0.0, turns = drag->angular > 0.0;
    const int known = scene->arrangement != SCENE_IN_TABLE;
    if (!scene_reader_has(reader, "drag.linear") && !scene_reader_has(reader, "drag.quadratic") &&
        !scene_reader_has(reader, "drag.angular"))
        return scene_reader_fail(reader, "drag", "no coefficient; give linear, quadratic or angular");
    if (known && slows && !scene->translates)
        return scene_reader_fail(reader, drag->linear > 0.0 ? "drag.linear" : "drag.quadratic",
                                 "acts on bodies that translate; give bodies.x or an arrangement of them");
    if (known && turns && !scene->turns)
        return scene_reader_fail(reader, "drag.angular", "acts on bodies that turn; give bodies.omega");
    if (drag->on == ON_SPHERES && !scene->clumps.given)
        return scene_reader_fail(reader, "drag.on", "there are no clumps; give bodies.clumps, or leave it out");
    return 0;
}

static int on_spheres(const void *settings)
{
    return ((const struct drag_settings *)settings)->on == ON_SPHERES;
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
    drag->linear = coefficient(&settings->linear);
    drag->quadratic = coefficient(&settings->quadratic);
    drag->angular = coefficient(&settings->angular);
    for (int k = 0; k < 3; ++k)
        drag->medium[k] = settings->medium[k];
    drag->lost = lost;
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_sum none[VTI_DRAG_BOOKS];
    vti_drag drag;
    (void)table;
    fill(&drag, settings, none);
    vti_effect effect = vti_drag_effect(&drag);
    effect.self = effect.booked = NULL;
    return effect;
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    vti_drag *drag = effect_memory(e, sizeof *drag, message);
    (void)table;
    if (drag == NULL)
        return -1;
    fill(drag, e->settings, e->booked);
    *made = vti_drag_effect(drag);
    if ((drag->linear.p != NULL || drag->quadratic.p != NULL) && !model->translates)
        return message_set(message, "%s: drag acts on bodies that translate; give columns x, y, z", model->scene->name);
    if (drag->angular.p != NULL && !model->turns)
        return message_set(message, "%s: drag.angular acts on bodies that turn; give columns omega_x, omega_y, omega_z",
                           model->scene->name);
    return 0;
}

static const struct effect_term terms[] = {
    {"lost_drag_translation", "$Q^{\\mathrm{d}}$", "lost to drag", "#882255"},
    {"lost_drag_rotation", "$Q^{\\mathrm{d}}_\\Omega$", "lost to drag, turning", "#CC6677"}};

const struct effect_kind effect_drag = {.number = EFFECT_drag,
                                        .key = "drag",
                                        EFFECT_FIELDS(fields),
                                        .settings = sizeof(struct drag_settings),
                                        .check = check,
                                        .draft = draft,
                                        .on_spheres = on_spheres,
                                        .make = make,
                                        EFFECT_TERMS(terms)};
