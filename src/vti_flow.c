/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps with effects that damp, remember or break (EQUATIONS 6.1, 6.8): kicks of time b h and drifts of time a h, with
 *
 *     flow(b h)    forward before the first kick, backward after the last; half of it on either side of others
 *     carry(a h)   after each drift
 *
 * and each flow beside the drift over which it takes its means. VTI-3, which is Verlet from half a kick on to the next,
 * has it where Verlet has: kick(h/2) flow(h/2) backward, flow(h/2) forward kick(h/2) drift(h). Before a whole kick it
 * would lower the stable step, by sqrt(2) at most: an oscillator's step has the trace 1 - (h omega)^2 + E and the
 * determinant E = exp(-c h/m). */
#include "vti_move.h"
#include "vti_ready.h"

static int any_flows(const vti_effect *effects, int64_t n)
{
    int any = 0;
    for (int64_t k = 0; k < n; ++k)
        any |= effects[k].flow != NULL;
    return any;
}

static int any_carries(const vti_effect *effects, int64_t n)
{
    int any = 0;
    for (int64_t k = 0; k < n; ++k)
        any |= effects[k].carry != NULL;
    return any;
}

/** Whether some effect takes Omega for a vector in space, beside positions: what carries, and dashpots that turn
 *  bodies. Drag on Omega is the same in any frame. */
static int any_in_space(const vti_effect *effects, int64_t n)
{
    int any = any_carries(effects, n);
    for (int64_t k = 0; k < n; ++k)
        any |= effects[k].flow != NULL && (effects[k].breaks & VTI_BREAKS_SPINS) != 0 &&
               (effects[k].needs & 1 << VTI_QUANTITY_X) != 0;
    return any;
}

int vti_step_check(const vti_stepper *method, const vti_effect *effects, int64_t n)
{
    const int status = vti_stepper_check(method);
    if (status != VTI_OK)
        return status;
    if (effects == NULL && n > 0)
        return VTI_E_NULL;
    if (n < 0)
        return VTI_E_COUNT;
    int backwards = 0, dissipates = any_flows(effects, n) || any_carries(effects, n);
    for (int64_t k = 0; k <= method->stages; ++k)
        backwards |= method->kick[k] < 0.0 || method->drift[k] < 0.0;
    for (int64_t e = 0; e < n; ++e) {
        if (effects[e].apply == NULL && effects[e].flow == NULL && effects[e].rupture == NULL)
            return VTI_E_NULL;
        dissipates |= effects[e].dissipates != 0 || effects[e].rupture != NULL;
    }
    return backwards && dissipates ? VTI_E_DISSIPATES : VTI_OK;
}

/* ---- rest -------------------------------------------------------------------------------------------------------- */

/** So many numbers, from one to the next stride. */
static void settle_numbers(double *p, int64_t stride, int64_t count)
{
    int64_t done = 0;
    for (const struct vti_move_kernels *const *k = vti_move_served(); stride == 1 && *k != NULL; ++k)
        done += (*k)->settle(p + done, count - done);
    for (; done < count; ++done)
        p[done * stride] = vti_settled(p[done * stride]);
}

static void settle_vectors(const vti_view *view, int64_t first, int64_t count)
{
    const int packed = vti_is_packed(view);
    if (vti_has(view) && packed)
        settle_numbers(view->c[0] + 3 * first, 1, 3 * count);
    for (int k = 0; vti_has(view) && !packed && k < 3; ++k)
        settle_numbers(view->c[k] + first * view->stride, view->stride, count);
}

/** Whether some flow lets velocities decay and does not set them to 0 itself. Drag on spheres does so itself, and under
 *  dashpots of bonds bodies never come to rest to the last bit. */
static int needs_settling(const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    int any = 0;
    for (int64_t k = 0; k < n; ++k)
        any |= effects[k].flow != NULL && (!effects[k].settles || vti_has(&b->moments));
    return any;
}

/** What has decayed to nothing is 0. Else bodies at rest keep velocities of which the squares, and in the end they
 *  themselves, are subnormal numbers, each of which takes many processors a hundred times as long as another. */
static void settle(const vti_bodies *b)
{
    const vti_view *const all[] = {&b->v, &b->omega, &b->spin, &b->v_low, &b->omega_low, &b->spin_low};
    for (int k = 0; k < 6; ++k)
        settle_vectors(all[k], b->first, b->count);
}

/* ---- the calls of the effects ------------------------------------------------------------------------------------ */

/** Of effects and bodies that have been checked. */
static void flow(const vti_effect *effects, int64_t n, double t, double drift, const vti_bodies *b)
{
    if (t > 0.0 && drift < 0.0 && needs_settling(effects, n, b))
        settle(b);
    for (int64_t k = 0; t > 0.0 && b->count > 0 && k < n; ++k) {
        const vti_effect *e = &effects[drift < 0.0 ? n - 1 - k : k];
        if (e->flow != NULL)
            e->flow(e->self, b, t, drift);
    }
}

static void carry(const vti_effect *effects, int64_t n, const vti_drifted *drifted, const vti_bodies *b)
{
    for (int64_t k = 0; b->count > 0 && k < n; ++k)
        if (effects[k].carry != NULL)
            effects[k].carry(effects[k].self, b, drifted);
}

int vti_effects_flow(const vti_effect *effects, int64_t n, double t, double drift, const vti_bodies *b)
{
    const int status = vti_effects_fault(effects, n, b, NULL);
    if (status != VTI_OK)
        return status;
    if (!(isfinite(t) && t >= 0.0 && isfinite(drift)))
        return VTI_E_TIME;
    flow(effects, n, t, drift, b);
    return VTI_OK;
}

int vti_effects_carry(const vti_effect *effects, int64_t n, const vti_drifted *drifted, const vti_bodies *b)
{
    if (drifted == NULL || (drifted->clumps != NULL && drifted->bodies == NULL))
        return VTI_E_NULL;
    int status = vti_effects_fault(effects, n, b, NULL);
    if (status == VTI_OK)
        status = vti_law_check(drifted->law, drifted->frame);
    if (status == VTI_OK && !vti_is_rotor(drifted->rotor))
        status = VTI_E_STEPPER;
    if (status == VTI_OK && !isfinite(drifted->t))
        status = VTI_E_TIME;
    if (status == VTI_OK && drifted->frame != VTI_FRAME_SPACE && any_carries(effects, n))
        status = VTI_E_FRAME;
    if (status == VTI_OK)
        carry(effects, n, drifted, b);
    return status;
}

int vti_effects_rupture(const vti_effect *effects, int64_t n, const vti_bodies *b, int64_t *broken)
{
    if (broken == NULL)
        return VTI_E_NULL;
    const int status = vti_effects_fault(effects, n, b, NULL);
    if (status != VTI_OK)
        return status;
    *broken = 0;
    for (int64_t k = 0; b->count > 0 && k < n; ++k)
        if (effects[k].rupture != NULL)
            *broken += effects[k].rupture(effects[k].self, b);
    return VTI_OK;
}

double vti_booked(const vti_effect *effects, int64_t n)
{
    vti_sum sum = {0.0, 0.0};
    if (n < 0 || (n > 0 && effects == NULL))
        return NAN;
    for (int64_t k = 0; k < n; ++k) {
        if (effects[k].books > 0 && effects[k].booked == NULL)
            return NAN;
        for (int64_t j = 0; j < effects[k].books; ++j) {
            vti_sum_add(&sum, effects[k].booked[j].high);
            vti_sum_add(&sum, effects[k].booked[j].low);
        }
    }
    return vti_sum_value(&sum);
}

double vti_booked_of_body(const vti_effect *effects, int64_t n, int64_t i)
{
    vti_sum sum = {0.0, 0.0};
    if (n < 0 || i < 0 || (n > 0 && effects == NULL))
        return NAN;
    for (int64_t k = 0; k < n; ++k) {
        const vti_effect *e = &effects[k];
        if (e->by_body != NULL && e->of_body < e->books)
            return NAN;
        for (int64_t j = 0; e->by_body != NULL && j < e->books; ++j) {
            vti_sum_add(&sum, e->by_body[e->of_body * i + j].high);
            vti_sum_add(&sum, e->by_body[e->of_body * i + j].low);
        }
    }
    return vti_sum_value(&sum);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static int check(const vti_stepper *method, double h, const vti_effect *effects, int64_t n, const vti_bodies *b,
                 vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    int status = vti_step_check(method, effects, n);
    if (status == VTI_OK)
        status = vti_effects_fault(effects, n, b, fault);
    if (status == VTI_OK)
        status = vti_stepper_suits(method, b, fault);
    if (status == VTI_OK && !vti_is_positive(h))
        status = vti_refuse(VTI_E_TIME, -1, h, VTI_QUANTITY_NONE, fault);
    if (status == VTI_OK && method->frame != VTI_FRAME_SPACE && any_in_space(effects, n))
        status = VTI_E_FRAME;
    return status;
}

/** Kick k between two drifts: half of its flow on either side, and the drift that follows. */
static int between_drifts(const vti_stepper *method, int64_t k, double h, const vti_effect *effects, int64_t n,
                          const vti_bodies *b, vti_fault *fault)
{
    const double kick = method->kick[k] * h, before = method->drift[k - 1] * h, after = method->drift[k] * h;
    flow(effects, n, 0.5 * kick, -before, b);
    const int status = vti_kick(kick, b);
    if (status != VTI_OK)
        return status;
    flow(effects, n, 0.5 * kick, after, b);
    return vti_drift_by((int)method->law, (int)method->frame, (int)method->rotor, after, b, fault);
}

/** The one kick of a step, which has the flows of both of its halves between them, and the drift. */
static int whole_kick(const vti_stepper *method, double h, const vti_effect *effects, int64_t n, const vti_bodies *b,
                      vti_fault *fault)
{
    const double half = 0.5 * method->kick[0] * h, drift = method->drift[0] * h;
    int status = vti_kick(half, b);
    if (status != VTI_OK)
        return status;
    flow(effects, n, half, -drift, b);
    flow(effects, n, half, drift, b);
    status = vti_kick(half, b);
    return status != VTI_OK ? status
                            : vti_drift_by((int)method->law, (int)method->frame, (int)method->rotor, drift, b, fault);
}

/** Whether a step has one kick, that of VTI-3. */
static int kicks_once(const vti_stepper *method)
{
    return method->stages == 1 && method->kick[1] == 0.0;
}

/** Tells of drift k, if it was done. */
static int carry_after(int status, const vti_stepper *method, int64_t k, double h, const vti_effect *effects, int64_t n,
                       const vti_bodies *b)
{
    const vti_drifted drifted = {
        .t = method->drift[k] * h, .law = method->law, .frame = method->frame, .rotor = method->rotor};
    if (status == VTI_OK)
        carry(effects, n, &drifted, b);
    return status;
}

int vti_effects_stage(const vti_stepper *method, int64_t k, double h, const vti_effect *effects, int64_t n,
                      const vti_bodies *b, vti_fault *fault)
{
    int status = check(method, h, effects, n, b, fault);
    if (status == VTI_OK && (k < 0 || k >= method->stages))
        status = VTI_E_STAGE;
    if (status != VTI_OK)
        return status;
    if (k > 0 && any_flows(effects, n))
        status = between_drifts(method, k, h, effects, n, b, fault);
    else if (kicks_once(method) && any_flows(effects, n))
        status = whole_kick(method, h, effects, n, b, fault);
    else {
        flow(effects, n, method->kick[k] * h, method->drift[k] * h, b);
        status = vti_step_stage(method, k, h, b, fault);
    }
    return carry_after(status, method, k, h, effects, n, b);
}

int vti_effects_begin(const vti_stepper *method, double h, const vti_effect *effects, int64_t n, const vti_bodies *b,
                      vti_fault *fault)
{
    return vti_effects_stage(method, 0, h, effects, n, b, fault);
}

int vti_effects_finish(const vti_stepper *method, double h, const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    int status = check(method, h, effects, n, b, NULL);
    if (status != VTI_OK)
        return status;
    const int64_t last = method->stages;
    if (method->drift[last] == 0.0) {
        status = vti_step_finish(method, h, b);
        if (status == VTI_OK)
            flow(effects, n, method->kick[last] * h, -method->drift[last - 1] * h, b);
        return status;
    }
    status =
        any_flows(effects, n) ? between_drifts(method, last, h, effects, n, b, NULL) : vti_step_finish(method, h, b);
    return carry_after(status, method, last, h, effects, n, b);
}
