/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

/** In the order of the bits of vti_effect.breaks. */
enum { LINEAR = 0, ANGULAR = 3, SPIN = 6, MOMENTA = 9 };

static const struct invariant momenta[MOMENTA] = {
    {"momentum_x", "$P_x$", 1}, {"momentum_y", "$P_y$", 1}, {"momentum_z", "$P_z$", 1},
    {"angular_x", "$L_x$", 1},  {"angular_y", "$L_y$", 1},  {"angular_z", "$L_z$", 1},
    {"spin_x", "$S_x$", 1},     {"spin_y", "$S_y$", 1},     {"spin_z", "$S_z$", 1},
};
static int is_broken(const struct model *model, int k)
{
    for (int64_t e = 0; e < model->effects_count; ++e)
        if (model->effects[e].breaks >> k & 1)
            return 1;
    return 0;
}

/** Momentum k exists in the scene, no effect breaks it, and it is not a part of another that is conserved as a whole.
 *  */
static int conserves(const struct model *model, int k)
{
    if (is_broken(model, k))
        return 0;
    if (k >= SPIN)
        return model->turns && is_broken(model, k - SPIN + ANGULAR);
    return k >= ANGULAR || model->translates;
}

int64_t model_invariants(const struct model *model, struct invariant list[MODEL_INVARIANTS])
{
    int64_t n = 0;
    for (int k = 0; k < MOMENTA; ++k)
        if (conserves(model, k))
            list[n++] = momenta[k];
    for (int64_t e = 0; e < model->rooms_count; ++e) {
        const struct effect_invariants *own = model->rooms[e].kind->invariants;
        if (own == NULL || n + own->count > MODEL_INVARIANTS)
            continue;
        for (int k = 0; k < own->count; ++k)
            list[n++] = own->list[k];
    }
    return n;
}

void model_invariant_values(const struct model *model, const vti_bodies *bodies, double values[MODEL_INVARIANTS])
{
    const double origin[3] = {0.0, 0.0, 0.0};
    double all[MOMENTA];
    int64_t n = 0;
    vti_momentum(bodies, all + LINEAR);
    vti_angular_momentum(bodies, origin, all + ANGULAR);
    vti_spin(bodies, all + SPIN);
    for (int k = 0; k < MOMENTA; ++k)
        if (conserves(model, k))
            values[n++] = all[k];
    for (int64_t e = 0; e < model->rooms_count; ++e) {
        const struct effect_invariants *own = model->rooms[e].kind->invariants;
        if (own == NULL || n + own->count > MODEL_INVARIANTS)
            continue;
        own->values(&model->rooms[e], bodies, values + n);
        n += own->count;
    }
}
