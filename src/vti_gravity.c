/* SPDX-License-Identifier: BSD-3-Clause
 * Uniform gravity: F = m g, U = -m g.x. */
#include "vti_ready.h"

static void apply(const void *self, const vti_bodies *b)
{
    const vti_gravity *p = self;
    if (!vti_has(&b->force))
        return;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const double m = vti_scalar(&b->mass, i), force[3] = {m * p->g[0], m * p->g[1], m * p->g[2]};
        vti_add(&b->force, i, force);
    }
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_gravity *p = self;
    vti_sum sum = {vti_has(&b->x) ? 0.0 : NAN, 0.0};
    for (int64_t i = b->first; vti_has(&b->x) && i < b->first + b->count; ++i) {
        double x[3];
        vti_load(&b->x, i, x);
        vti_sum_add(&sum, -vti_scalar(&b->mass, i) * vti_dot(p->g, x));
    }
    energies[0] = vti_sum_value(&sum);
}

vti_effect vti_gravity_effect(const vti_gravity *gravity)
{
    static const char *const term[] = {"gravity"};
    if (gravity == NULL)
        return vti_effect_none();
    const vti_effect effect = {.name = "gravity",
                               .apply = apply,
                               .energy = energy,
                               .springs = vti_springs_none,
                               .self = gravity,
                               .needs = 1 << VTI_QUANTITY_MASS,
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .smooth = 1,
                               .terms = 1,
                               .term = term,
                               .breaks = vti_broken_along(gravity->g)};
    return effect;
}
