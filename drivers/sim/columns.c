/* SPDX-License-Identifier: BSD-3-Clause */
#include "columns.h"

#include <string.h>

#include "modified.h"

/* Everything there is to record, in one array: these, then the terms of all effects in the model's order. */
enum {
    T,
    TRANSLATION,
    ROTATION,
    TOTAL,
    MODIFIED,
    MOMENTUM,
    SPIN = MOMENTUM + 3,
    ANGULAR = SPIN + 3,
    TERMS = ANGULAR + 3
};
enum { SOURCES = TERMS + COLUMNS };

static void add(struct columns *c, const char *name, int source, int effect)
{
    if (c->count == COLUMNS || source >= SOURCES)
        return;
    c->name[c->count] = name;
    c->effect[c->count] = effect;
    c->source[c->count++] = source;
}

void columns_of(const struct model *model, const vti_stepper *stepper, struct columns *c)
{
    static const char *const momentum[] = {"momentum_x", "momentum_y", "momentum_z"};
    static const char *const spin[] = {"spin_x", "spin_y", "spin_z"};
    static const char *const angular[] = {"angular_x", "angular_y", "angular_z"};
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
    c->total = c->count;
    add(c, "total", TOTAL, -1);
    c->modified = modified_exists(stepper) ? c->count : -1;
    if (c->modified >= 0)
        add(c, "energy_modified", MODIFIED, -1);
    for (int k = 0; translates && k < 3; ++k)
        add(c, momentum[k], MOMENTUM + k, -1);
    for (int k = 0; turns && k < 3; ++k)
        add(c, spin[k], SPIN + k, -1);
    for (int k = 0; k < 3; ++k)
        add(c, angular[k], ANGULAR + k, -1);
}

void columns_values(const struct columns *c, double t, const vti_bodies *b, double row[COLUMNS])
{
    const double origin[3] = {0.0, 0.0, 0.0};
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
        effect->energy(effect->self, b, value + source);
        for (int64_t j = 0; j < effect->terms; ++j)
            vti_sum_add(&total, value[source++]);
    }
    value[TOTAL] = vti_sum_value(&total);
    vti_momentum(b, value + MOMENTUM);
    vti_spin(b, value + SPIN);
    vti_angular_momentum(b, origin, value + ANGULAR);
    for (int k = 0; k < c->count; ++k)
        row[k] = value[c->source[k]];
}
