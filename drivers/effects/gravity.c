/* SPDX-License-Identifier: BSD-3-Clause
 * Gravity: a uniform field. */
#include "kind.h"

static const struct scene_field fields[] = {
    {"gravity", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, offsetof(vti_gravity, g), "acceleration g",
     "A uniform field that acts on bodies that translate.", NULL},
};

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    (void)model, (void)table, (void)message;
    *made = vti_gravity_effect(e->settings);
    return 0;
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
                                           .traits = EFFECT_TRANSLATING,
                                           .gives = EFFECT_FORCE,
                                           .make = make,
                                           EFFECT_TERMS(terms),
                                           .field = field};
