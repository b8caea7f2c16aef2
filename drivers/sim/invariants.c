/* SPDX-License-Identifier: BSD-3-Clause */
#include "model.h"

/** In the order of the bits of vti_effect.breaks. */
enum { LINEAR = 0, ANGULAR = 3, SPIN = 6, MOMENTA = 9 };

static const struct invariant momenta[MOMENTA] = {
    {"momentum_x", "$P_x$", 1}, {"momentum_y", "$P_y$", 1}, {"momentum_z", "$P_z$", 1},
    {"angular_x", "$L_x$", 1},  {"angular_y", "$L_y$", 1},  {"angular_z", "$L_z$", 1},
    {"spin_x", "$S_x$", 1},     {"spin_y", "$S_y$", 1},     {"spin_z", "$S_z$", 1},
};
/* the sphere's spin about its arm, and the arm's length (EQUATIONS 3) */
static const struct invariant arm_dot_omega = {"arm_dot_omega", "$R\\rho_0\\cdot\\Omega$", 1};
static const struct invariant arm_length = {"arm_length", "$|R\\rho_0|$", 0};

static int is_broken(const struct model *model, int k)
{
    for (int64_t e = 0; e < model->effects_count; ++e)
        if (model->effects[e].breaks >> k & 1)
            return 1;
    return 0;
}

/** Momentum k exists in the scene, no effect breaks it, and it is not a part of another that is conserved as a whole. */
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
    if (model->scene->has_pendulum) {
        list[n++] = arm_dot_omega;
        list[n++] = arm_length;
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
    if (model->scene->has_pendulum) {
        double arm[3];
        vti_pendulum_arm(&model->scene->pendulum, bodies, 0, arm);
        values[n++] = arm[0] * bodies->omega.c[0][0] + arm[1] * bodies->omega.c[1][0] + arm[2] * bodies->omega.c[2][0];
        values[n++] = vti_norm(arm);
    }
}
