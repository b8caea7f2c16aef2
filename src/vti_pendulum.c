/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The three-dimensional pendulum (paper, section 3; EQUATIONS 3). Gravity acts along +e3 (E2):
 *
 *     U = -m g e3 . R rho0,     RM = m g (R rho0) x e3     (E1: the print mixes frames)                              */
#include "vti_ready.h"

/** Inline: of the energy only one component is made. */
VTI_INLINE void arm_of(const vti_pendulum *pendulum, const vti_bodies *b, int64_t i, double arm[3])
{
    double q[4];
    vti_load_pair(b, i, q);
    vti_pair_rotate(q, 1.0, pendulum->rho0, arm);
}

void vti_pendulum_arm(const vti_pendulum *pendulum, const vti_bodies *b, int64_t i, double arm[3])
{
    if (arm == NULL)
        return;
    if (pendulum == NULL || vti_bodies_ready(b) != VTI_OK || !vti_has_attitude(b) || i < 0 || i >= b->first + b->count)
        arm[0] = arm[1] = arm[2] = NAN;
    else
        arm_of(pendulum, b, i, arm);
}

/** RM += (R m g rho0) x e3 of one body. */
VTI_INLINE void swing(const double q[4], const double pull[3], const vti_view *moment, int64_t i)
{
    double arm[3];
    vti_pair_rotate(q, 1.0, pull, arm);
    moment->c[0][i * moment->stride] += arm[1];
    moment->c[1][i * moment->stride] -= arm[0];
}

/** The same of a quaternion, or of an alpha that has to be scaled; apart, so that others need not wait for it. */
VTI_APART void swing_any(const vti_bodies *b, const double pull[3], int64_t i)
{
    double q[4];
    vti_load_pair(b, i, q);
    swing(q, pull, &b->moment, i);
}

static void apply(const void *self, const vti_bodies *b)
{
    const vti_pendulum *p = self;
    if (!vti_has(&b->moment))
        return;
    const double pull[3] = {p->weight * p->rho0[0], p->weight * p->rho0[1], p->weight * p->rho0[2]};
    const vti_view moment = b->moment, alpha = b->alpha; /* copies: what nobody else can change stays in registers */
    for (int64_t i = b->first, end = b->first + b->count; i < end; ++i) {
        double q[4] = {0.0, 0.0, 0.0, 2.0};
        if (vti_has(&alpha))
            vti_load(&alpha, i, q);
        if (vti_has(&alpha) && vti_max3(q) <= VTI_RRV_LARGE)
            swing(q, pull, &moment, i);
        else
            swing_any(b, pull, i);
    }
}

/** U = -m g e3 . R rho0 */
static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_pendulum *p = self;
    vti_sum sum = {0.0, 0.0};
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double arm[3];
        arm_of(p, b, i, arm);
        vti_sum_add(&sum, vti_pendulum_potential(p, arm));
    }
    energies[0] = vti_sum_value(&sum);
}

/** An arm in the field has the stiffness m g |rho0| against turning, at most. */
static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_pendulum *p = self;
    const double stiffness = fabs(p->weight) * vti_norm(p->rho0);
    (void)at;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const vti_spring s = {.element = i, .i = i, .j = -1, .length = 1.0, .bend = stiffness, .twist = stiffness};
        visit(context, &s);
    }
    return VTI_OK;
}

vti_effect vti_pendulum_effect(const vti_pendulum *pendulum)
{
    static const char *const term[] = {"pendulum"};
    if (pendulum == NULL)
        return vti_effect_none();
    /* the pivot takes up any linear momentum; of the angular one, all spin, gravity leaves the component along e3 */
    enum { ALONG_E3 = 1 << 5 | 1 << 8 };
    const vti_effect effect = {.name = "pendulum",
                               .apply = apply,
                               .energy = energy,
                               .springs = springs,
                               .self = pendulum,
                               .needs = 1 << VTI_QUANTITY_ALPHA,
                               .gives = 1 << VTI_QUANTITY_MOMENT,
                               .smooth = 1,
                               .terms = 1,
                               .term = term,
                               .breaks = VTI_BREAKS_LINEAR | ((VTI_BREAKS_ANGULAR | VTI_BREAKS_SPINS) & ~ALONG_E3)};
    return effect;
}
