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

/** What effect e itself conserves, behind n others, if there is room for it; that of bodies with moments nobody has
 *  said. */
static const struct effect_invariants *own_of(const struct model *model, int64_t e, int64_t n)
{
    const struct effect_invariants *own = model->instances[e].kind->invariants;
    return own == NULL || model->bodies.moments.c[0] != NULL || n + own->count > MODEL_INVARIANTS ? NULL : own;
}

int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS])
{
    const int64_t conserved = model_momenta(model);
    int64_t n = 0;
    for (int k = 0; k < MOMENTA; ++k)
        if (conserved >> k & 1)
            list[n++] = momenta[k];
    for (int64_t e = 0; e < model->instances_count; ++e) {
        const struct effect_invariants *own = own_of(model, e, n);
        for (int k = 0; own != NULL && k < own->count; ++k)
            list[n++] = own->list[k];
    }
    return n;
}

void model_angular_momentum(const vti_bodies *bodies, double values[3])
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

void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS])
{
    const int64_t conserved = model_momenta(model);
    int64_t n = take_conserved(conserved >> LINEAR, vti_momentum, bodies, values);
    n += take_conserved(conserved >> ANGULAR, model_angular_momentum, bodies, values + n);
    n += take_conserved(conserved >> SPIN, vti_spin, bodies, values + n);
    for (int64_t e = 0; e < model->instances_count; ++e) {
        const struct effect_invariants *own = own_of(model, e, n);
        if (own == NULL)
            continue;
        own->values(&model->instances[e], bodies, values + n);
        n += own->count;
    }
}

int64_t model_own_momenta(const struct model *model, const vti_bodies *states, double *value, int64_t stride)
{
    int64_t n = 0, taken = 0;
    for (int64_t left = model_momenta(model); left != 0; left &= left - 1)
        ++n;
    for (int64_t e = 0; e < model->instances_count; ++e) {
        const struct effect_invariants *own = own_of(model, e, n);
        if (own == NULL)
            continue;
        own->of_states(&model->instances[e], states, value + taken * stride, stride);
        taken += own->momenta;
        n += own->count;
    }
    return taken;
}
