/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

/** In the order of the bits of vti_effect.breaks. */
enum { LINEAR = 0, ANGULAR = 3, SPIN = 6, MOMENTA = 9 };

static const struct invariant momenta[MOMENTA] = {
    {"momentum_x", "$P_x$", 1}, {"momentum_y", "$P_y$", 1}, {"momentum_z", "$P_z$", 1},
    {"angular_x", "$L_x$", 1},  {"angular_y", "$L_y$", 1},  {"angular_z", "$L_z$", 1},
    {"spin_x", "$S_x$", 1},     {"spin_y", "$S_y$", 1},     {"spin_z", "$S_z$", 1},
};

/** Bit k: momentum k is conserved. It exists in the scene, no effect breaks it, and it is not a part of another that is
 *  conserved as a whole, as the spin is of the angular one. */
int64_t model_momenta(const struct model *model)
{
    int64_t broken = 0;
    for (int64_t e = 0; e < model->effects_count; ++e)
        broken |= model->effects[e].breaks;
    const int64_t linear = model->translates ? 7 : 0,
                  spin = model->turns ? (broken & 7 << ANGULAR) << (SPIN - ANGULAR) : 0;
    return (linear | 7 << ANGULAR | spin) & ~broken;
}

/** What the effect itself conserves; that of bodies with moments nobody has said. */
static const struct effect_invariants *own_of(const struct model *model, int64_t e)
{
    return model->bodies.moments.c[0] == NULL ? model->rooms[e].kind->invariants : NULL;
}

int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS])
{
    const int64_t conserved = model_momenta(model);
    int64_t n = 0;
    for (int k = 0; k < MOMENTA; ++k)
        if (conserved >> k & 1)
            list[n++] = momenta[k];
    for (int64_t e = 0; e < model->rooms_count; ++e) {
        const struct effect_invariants *own = own_of(model, e);
        if (own == NULL || n + own->count > MODEL_INVARIANTS)
            continue;
        for (int k = 0; k < own->count; ++k)
            list[n++] = own->list[k];
    }
    return n;
}

static void take_angular(const vti_bodies *bodies, double values[3])
{
    const double origin[3] = {0.0, 0.0, 0.0};
    vti_angular_momentum(bodies, origin, values);
}

/** Of a vector whose components are three momenta, those that are conserved; taken if there is one. */
static int64_t take_conserved(int64_t conserved, void (*take)(const vti_bodies *bodies, double *values),
                              const vti_bodies *bodies, double *values)
{
    double all[3];
    int64_t n = 0;
    if ((conserved & 7) == 0)
        return 0;
    take(bodies, all);
    for (int k = 0; k < 3; ++k)
        if (conserved >> k & 1)
            values[n++] = all[k];
    return n;
}

void model_own_values(const struct model *model, const vti_bodies *bodies, int all, int64_t first, double *values)
{
    int64_t n = first;
    for (int64_t e = 0; e < model->rooms_count; ++e) {
        const struct effect_invariants *own = own_of(model, e);
        if (own == NULL || n + own->count > MODEL_INVARIANTS)
            continue;
        own->values(&model->rooms[e], bodies, all, values);
        values += own->count;
        n += own->count;
    }
}

void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS])
{
    const int64_t conserved = model_momenta(model);
    int64_t n = take_conserved(conserved >> LINEAR, vti_momentum, bodies, values);
    n += take_conserved(conserved >> ANGULAR, take_angular, bodies, values + n);
    n += take_conserved(conserved >> SPIN, vti_spin, bodies, values + n);
    model_own_values(model, bodies, 1, n, values + n);
}
