/* SPDX-License-Identifier: BSD-3-Clause */
#include "columns.h"

#include <string.h>

#include "modified.h"
#include "shape.h"
#include "step_errors.h"

/* ---- quantities of the bodies, behind the energies -------------------------------------------------------------- */

/** Of which bodies there are such columns. */
enum whose { OF_ALL, OF_TRANSLATING, OF_TURNING };

/** One to three columns, and what writes a value for each; they are 0 before. */
static const struct quantity {
    const char *name[3];
    enum whose whose;
    void (*take)(const vti_bodies *bodies, double *values);
} quantities[] = {
    {{"momentum_x", "momentum_y", "momentum_z"}, OF_TRANSLATING, vti_momentum},
    {{"spin_x", "spin_y", "spin_z"}, OF_TURNING, vti_spin},
    {{"angular_x", "angular_y", "angular_z"}, OF_ALL, model_angular_momentum},
};
enum { QUANTITIES = sizeof quantities / sizeof quantities[0] };

static int has(const vti_bodies *bodies, const struct quantity *quantity)
{
    const vti_view *needed = quantity->whose == OF_TRANSLATING ? &bodies->v : &bodies->omega;
    return quantity->whose == OF_ALL || needed->c[0] != NULL;
}

/* ---- all columns ------------------------------------------------------------------------------------------------ */

/* Everything there is to record, in one array: these, three of each quantity, two errors of steps, then the terms of
 * all effects in the model's order, then their booked energies, then the number of lines that hold and of fragments. */
enum { T, TRANSLATION, ROTATION, TOTAL, MODIFIED, QUANTITY, ERRORS = QUANTITY + 3 * QUANTITIES, TERMS = ERRORS + 2 };
enum { BREAKS = 2, SOURCES = TERMS + EFFECT_TERMS_OF_ALL + BREAKS };

/* if this is negative, enlarge COLUMNS (columns.h) */
typedef char columns_have_room[(int)COLUMNS >= (int)SOURCES ? 1 : -1];

static const struct effect_term kinetic[] = {{"kinetic_translation", "$m‖v‖^2\\!/2$", "translation", "#0072B2"},
                                             {"kinetic_rotation", "$J‖\\Omega‖^2\\!/2$", "rotation", "#56B4E9"}};
static const struct effect_term general = {"kinetic_rotation", "$L\\cdot\\Omega/2$", "rotation", "#56B4E9"};

/** What is known of the energy called name in pictures; NULL if nothing is. */
static const struct effect_term *term_of(const struct model *model, const char *name, int effect)
{
    const struct effect_kind *kind =
        effect >= 0 && effect < model->instances_count ? model->instances[effect].kind : NULL;
    const struct effect_term *terms = kind != NULL ? kind->terms : kinetic;
    const int count = kind != NULL ? kind->terms_count : (int)(sizeof kinetic / sizeof kinetic[0]);
    if (kind == NULL && model->bodies.moments.c[0] != NULL && strcmp(general.name, name) == 0)
        return &general;
    for (int k = 0; k < count; ++k)
        if (strcmp(terms[k].name, name) == 0)
            return &terms[k];
    return NULL;
}

/** Leaves out what there is no room for, of effects that are not a scene's: others kinds_check has counted. */
static void add(struct columns *c, const char *name, int source, int effect)
{
    if (c->count == COLUMNS || source >= SOURCES)
        return;
    c->name[c->count] = name;
    c->term[c->count] = term_of(c->model, name, effect);
    c->effect[c->count] = effect;
    c->source[c->count++] = source;
}

void columns_of(const struct model *model, const vti_stepper *stepper, struct columns *c)
{
    int source = TERMS;
    const int translates = model->bodies.v.c[0] != NULL, turns = model->bodies.omega.c[0] != NULL;
    memset(c, 0, sizeof *c);
    c->model = model;
    add(c, "t", T, -1);
    if (translates)
        add(c, "kinetic_translation", TRANSLATION, -1);
    if (turns)
        add(c, "kinetic_rotation", ROTATION, -1);
    for (int64_t e = 0; e < model->effects_count; ++e)
        for (int64_t j = 0; j < model->effects[e].terms; ++j, ++source)
            add(c, model->effects[e].term[j], source, (int)e);
    c->held = c->count;
    for (int64_t e = 0; e < model->effects_count; ++e)
        for (int64_t j = 0; j < model->effects[e].books; ++j, ++source)
            add(c, model->effects[e].book[j], source, (int)e);
    c->total = c->count;
    add(c, "total", TOTAL, -1);
    c->modified = modified_exists(stepper, model) ? c->count : -1;
    if (c->modified >= 0)
        add(c, "energy_modified", MODIFIED, -1);
    for (int q = 0; q < QUANTITIES; ++q) {
        for (int k = 0; has(&model->bodies, &quantities[q]) && k < 3 && quantities[q].name[k] != NULL; ++k)
            add(c, quantities[q].name[k], QUANTITY + 3 * q + k, -1);
    }
    const struct effect *breaking = shape_breaking(model);
    for (int k = 0; breaking != NULL && k < BREAKS; ++k)
        add(c, breaking->kind->breaks->name[k], source + k, -1);
    if (model->errors != NULL && translates)
        add(c, "error_velocity", ERRORS, -1);
    if (model->errors != NULL && turns)
        add(c, "error_omega", ERRORS + 1, -1);
}

void columns_values(const struct columns *c, double t, const vti_bodies *b, double row[COLUMNS])
{
    double value[SOURCES] = {0.0};
    vti_sum total = {0.0, 0.0};
    int source = TERMS;
    value[T] = t;
    value[TRANSLATION] = vti_kinetic_translation(b);
    value[ROTATION] = vti_kinetic_rotation(b);
    vti_sum_add(&total, value[TRANSLATION]);
    vti_sum_add(&total, value[ROTATION]);
    for (int64_t e = 0; e < c->model->effects_count; ++e) {
        const vti_effect *effect = &c->model->effects[e];
        if (source + effect->terms > SOURCES)
            break;
        if (effect->terms > 0)
            effect->energy(effect->self, b, value + source);
        for (int64_t j = 0; j < effect->terms; ++j)
            vti_sum_add(&total, value[source++]);
    }
    for (int64_t e = 0; e < c->model->effects_count; ++e)
        for (int64_t j = 0; j < c->model->effects[e].books && source < SOURCES; ++j, ++source) {
            value[source] = vti_sum_value(&c->model->effects[e].booked[j]);
            vti_sum_add(&total, value[source]);
        }
    value[TOTAL] = vti_sum_value(&total);
    for (int q = 0; q < QUANTITIES; ++q)
        if (has(b, &quantities[q]))
            quantities[q].take(b, value + QUANTITY + 3 * q);
    const struct effect *breaking = shape_breaking(c->model);
    if (breaking != NULL && source + BREAKS <= SOURCES)
        breaking->kind->breaks->count(breaking, value + source);
    for (int k = 0; c->model->errors != NULL && k < 2; ++k)
        value[ERRORS + k] = step_errors_shown(c->model->errors, k);
    for (int k = 0; k < c->count; ++k)
        row[k] = value[c->source[k]];
}
