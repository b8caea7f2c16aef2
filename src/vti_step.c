/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The steppers, as data, and the step that plays them. With kick and drift as in vti_move.c:
 *
 *     VTI-1 (the paper's first map)   kick(h/2) drift(h) kick(h/2), closed form
 *     VTI-2 (the second)              kick(h/2) drift(h) kick(h/2), Cayley
 *     VTI-3 (Campello's, phi = 1)     kick(h) drift(h), Cayley
 *
 * All three are exactly variational (E14, E15); VTI-3 = kick(-h/2) VTI-2 kick(h/2). */
#include <string.h>

#include "vti_internal.h"

static const double half_half[] = {0.5, 0.5}, one_none[] = {1.0, 0.0}, one[] = {1.0};

static const vti_stepper steppers[] = {
    {"vti1", VTI_LAW_CLOSED, VTI_FRAME_SPACE, 2, 1, 1, 0.0, half_half, one,
     "VTI-1: variational, closed form, h|Omega| < 1"},
    {"vti2", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 2, 1, 1, 0.0, half_half, one, "VTI-2: variational, a la velocity Verlet"},
    {"vti3", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 1, 0, 1, 0.0, one_none, one, "VTI-3: variational, a la symplectic Euler"},
    {"vti3-leapfrog", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 2, 1, 1, 0.5, one_none, one,
     "VTI-3 started and read with half kicks: VTI-2 in leapfrog form"},
    {"vti1-body", VTI_LAW_CLOSED, VTI_FRAME_BODY, 2, 1, 1, 0.0, half_half, one,
     "VTI-1 with omega = R^T Omega and M in the body's frame (E16: no factor R_{k+1}^T R_k)"},
};

enum { STEPPERS = sizeof steppers / sizeof steppers[0] };

int64_t vti_stepper_count(void)
{
    return STEPPERS;
}

const vti_stepper *vti_stepper_at(int64_t index)
{
    return index >= 0 && index < STEPPERS ? &steppers[index] : NULL;
}

const vti_stepper *vti_stepper_find(const char *name)
{
    for (int64_t i = 0; name != NULL && i < STEPPERS; ++i)
        if (strcmp(name, steppers[i].name) == 0)
            return &steppers[i];
    return NULL;
}

/** Bodies of one block stay in the first-level cache from the kick to the drift. */
enum { BLOCK = 256 };

static int check(const vti_stepper *method, double h, const vti_bodies *b)
{
    if (method == NULL)
        return VTI_E_NULL;
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    return isfinite(h) && h > 0.0 ? VTI_OK : VTI_E_TIME;
}

int vti_step_stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, vti_fault *fault)
{
    if (fault != NULL) {
        fault->body = -1;
        fault->value = h;
    }
    int status = check(method, h, b);
    if (status == VTI_OK && (k < 0 || k >= method->stages))
        status = VTI_E_STAGE;
    if (status == VTI_OK)
        status = vti_law_check((int)method->law, (int)method->frame);
    if (status != VTI_OK)
        return status;

    const double kick = method->kick[k] * h, drift = method->drift[k] * h;
    status = vti_drift_refuses((int)method->law, kick, drift, b, fault);
    if (status != VTI_OK)
        return status;
    const int64_t end = b->first + b->count;
    for (int64_t first = b->first; first < end; first += BLOCK) {
        const int64_t next = end - first < BLOCK ? end : first + BLOCK;
        vti_kick_range(kick, b, first, next);
        vti_drift_range((int)method->law, (int)method->frame, drift, b, first, next);
    }
    return VTI_OK;
}

int vti_step_begin(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    return vti_step_stage(method, 0, h, b, fault);
}

/** kick(share h); a share of 0 touches nothing. */
static int kick_share(double share, double h, const vti_bodies *b)
{
    if (share != 0.0)
        vti_kick_range(share * h, b, b->first, b->first + b->count);
    return VTI_OK;
}

int vti_step_finish(const vti_stepper *method, double h, const vti_bodies *b)
{
    const int status = check(method, h, b);
    return status == VTI_OK ? kick_share(method->kick[method->stages], h, b) : status;
}

int vti_step_start(const vti_stepper *method, double h, const vti_bodies *b)
{
    const int status = check(method, h, b);
    return status == VTI_OK ? kick_share(-method->lag, h, b) : status;
}

int vti_step_sync(const vti_stepper *method, double h, const vti_bodies *b)
{
    const int status = check(method, h, b);
    return status == VTI_OK ? kick_share(method->lag, h, b) : status;
}
