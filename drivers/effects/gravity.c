/* SPDX-License-Identifier: BSD-3-Clause
 * Gravity: a uniform field. */
#include "kind.h"

static const struct scene_field fields[] = {
    {"gravity", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, offsetof(vti_gravity, g), "acceleration g",
     "A uniform field that acts on bodies that translate.", NULL},
};

static vti_effect draft(const void *settings, const struct table *table)
{
    (void)table;
    return vti_gravity_effect(settings);
}

static const double *field(const struct effect *e)
{
    return ((const vti_gravity *)e->settings)->g;
}

static const struct effect_term terms[] = {{"gravity", "$U^{\\mathrm{g}}$", "gravity", "#999933"}};

const struct effect_kind effect_gravity = {.number = EFFECT_gravity,
                                           .key = "gravity",
                                           EFFECT_FIELDS(fields),
                                           .settings = sizeof(vti_gravity),
                                           .draft = draft,
                                           EFFECT_TERMS(terms),
                                           .field = field};
