/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The steppers, as data, and the step that plays them. With kick and drift as in vti_kick.c and vti_drift.c:
 *
 *     VTI-1 (the paper's first map)   kick(h/2) drift(h) kick(h/2), closed form
 *     VTI-2 (the second)              kick(h/2) drift(h) kick(h/2), Cayley
 *     VTI-3 (Campello's, phi = 1)     kick(h) drift(h), Cayley
 *
 * All three are exactly variational (E14, E15); VTI-3 = kick(-h/2) VTI-2 kick(h/2). The others are longer lists of the same two,
 * with the exact drift; with another one they fall to order 2. */
#include <string.h>

#include "vti_coefficients.h"
#include "vti_internal.h"

#define SPACE VTI_FRAME_SPACE
static const vti_stepper steppers[] = {
    /* name, law, frame, order, reversible, symplectic, stages, evals, lag, reach, kick, drift, probe, about */
    {"vti1", VTI_LAW_CLOSED, SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,
     "VTI-1: variational, closed form, h|Omega| < 1"},
    {"vti2", VTI_LAW_CAYLEY, SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,
     "VTI-2: variational, a la velocity Verlet"},
    {"vti3", VTI_LAW_CAYLEY, SPACE, 1, 0, 1, 1, 1, 0.0, 2.0, one_none, one_none, NULL,
     "VTI-3: variational, a la symplectic Euler"},
    {"vti3-leapfrog", VTI_LAW_CAYLEY, SPACE, 2, 1, 1, 1, 1, 0.5, 2.0, one_none, one_none, NULL,
     "VTI-3 started and read with half kicks: VTI-2 in leapfrog form"},
    {"vti1-body", VTI_LAW_CLOSED, VTI_FRAME_BODY, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,
     "VTI-1 with omega = R^T Omega and M in the body's frame (E16: no factor R_{k+1}^T R_k)"},
    {"exact", VTI_LAW_EXACT, SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,
     "velocity Verlet with the exact drift"},
    {"suzuki4", VTI_LAW_EXACT, SPACE, 4, 1, 1, 5, 5, 0.0, 2.72097, suzuki4_kick, suzuki4_drift, NULL,
     "composition of five steps of exact (Suzuki 1990)"},
    {"kl6", VTI_LAW_EXACT, SPACE, 6, 1, 1, 9, 9, 0.0, 2.53262, kl6_kick, kl6_drift, NULL,
     "composition of nine steps of exact (Kahan and Li 1997)"},
    {"kl8", VTI_LAW_EXACT9, SPACE, 8, 1, 1, 17, 17, 0.0, 3.09643, kl8_kick, kl8_drift, NULL,
     "composition of seventeen steps of exact (Kahan and Li 1997)"},
    {"srkn6", VTI_LAW_EXACT, SPACE, 4, 1, 1, 6, 6, 0.0, 3.16346, srkn6_kick, srkn6_drift, NULL,
     "Runge-Kutta-Nystroem splitting, six stages (Blanes and Moan 2002)"},
    {"srkn11", VTI_LAW_EXACT, SPACE, 6, 1, 1, 11, 11, 0.0, 3.14143, srkn11_kick, srkn11_drift, NULL,
     "Runge-Kutta-Nystroem splitting, eleven stages (Blanes and Moan 2002)"},
    {"srkn14", VTI_LAW_EXACT, SPACE, 6, 1, 1, 14, 14, 0.0, 3.14092, srkn14_kick, srkn14_drift, NULL,
     "Runge-Kutta-Nystroem splitting, fourteen stages, begins with a drift (Blanes and Moan 2002)"},
    {"chin4", VTI_LAW_EXACT, SPACE, 4, 1, 0, 2, 3, 0.0, 3.46410, chin4_kick, chin4_drift, chin4_probe,
     "positive coefficients and a force gradient, by one more evaluation (Chin 1997)"},
};
#undef SPACE

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

static int check(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    if (method == NULL || method->kick == NULL || method->drift == NULL)
        return VTI_E_NULL;
    if (method->stages < 1)
        return VTI_E_STAGE;
    const int status = vti_bodies_ready_or(b, fault);
    if (status != VTI_OK)
        return status;
    return isfinite(h) && h > 0.0 ? VTI_OK : vti_blame(VTI_E_TIME, -1, h, VTI_QUANTITY_NONE, fault);
}

/** kick(kick[k] h), drift(drift[k] h); a kick of 0 does not look at the forces. */
VTI_INLINE int play(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, vti_fault *fault)
{
    const int law = (int)method->law, frame = (int)method->frame;
    const double kick = method->kick[k] * h, drift = method->drift[k] * h;
    int status = vti_law_check(law, frame);
    if (status == VTI_OK && law == VTI_LAW_CLOSED)
        status = vti_drift_refuses(law, kick, drift, b, fault);
    if (status != VTI_OK)
        return status;
    const int64_t end = b->first + b->count;
    for (int64_t first = b->first; first < end; first += BLOCK) {
        const int64_t next = end - first < BLOCK ? end : first + BLOCK;
        vti_push(law, frame, kick, drift, b, first, next);
    }
    return VTI_OK;
}

int vti_step_stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, vti_fault *fault)
{
    vti_blame_none(VTI_OK, fault);
    int status = check(method, h, b, fault);
    if (status == VTI_OK && (k < 0 || k >= method->stages))
        status = VTI_E_STAGE;
    return status == VTI_OK ? play(method, k, h, b, fault) : status;
}

int vti_step_begin(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    return vti_step_stage(method, 0, h, b, fault);
}

/** kick(share h); a share of 0 touches nothing. */
static int kick_share(double share, double h, const vti_bodies *b)
{
    return share != 0.0 ? vti_kick(share * h, b) : VTI_OK;
}

int vti_step_finish(const vti_stepper *method, double h, const vti_bodies *b)
{
    int status = check(method, h, b, NULL);
    if (status != VTI_OK)
        return status;
    if (method->drift[method->stages] != 0.0)
        return play(method, method->stages, h, b, NULL);
    return kick_share(method->kick[method->stages], h, b);
}

int vti_step_start(const vti_stepper *method, double h, const vti_bodies *b)
{
    const int status = check(method, h, b, NULL);
    return status == VTI_OK ? kick_share(-method->lag, h, b) : status;
}

int vti_step_sync(const vti_stepper *method, double h, const vti_bodies *b)
{
    const int status = check(method, h, b, NULL);
    return status == VTI_OK ? kick_share(method->lag, h, b) : status;
}

/* ---- force gradients ---------------------------------------------------------------------------------------------- */

/** Whether a is where any quantity of the bodies begins. */
static int is_of(const vti_bodies *b, const double *a)
{
    const double *const all[] = {b->x.c[0],         b->v.c[0],     b->force.c[0],    b->alpha.c[0],
                                 b->quat.xyzw[0],   b->omega.c[0], b->moment.c[0],   b->x_low.c[0],
                                 b->alpha_low.c[0], b->v_low.c[0], b->omega_low.c[0]};
    int found = 0;
    for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k)
        found |= a != NULL && all[k] == a;
    return found;
}

static int probe_check(const vti_bodies *b, const vti_bodies *probed)
{
    const int status = vti_bodies_ready(probed);
    if (status != VTI_OK)
        return status;
    if (probed->first != b->first || probed->count != b->count)
        return VTI_E_COUNT;
    if (vti_has(&probed->x) != vti_has(&b->x) || vti_has(&probed->alpha) != vti_has(&b->alpha) ||
        vti_has_attitude(probed) != vti_has_attitude(b))
        return VTI_E_VIEW;
    const int same = is_of(b, probed->x.c[0]) || is_of(b, probed->alpha.c[0]) || is_of(b, probed->quat.xyzw[0]);
    return same ? VTI_E_ALIAS : VTI_OK;
}

static void copy_configuration(const vti_bodies *b, const vti_bodies *to)
{
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        for (int k = 0; k < 3 && vti_has(&b->x); ++k)
            to->x.c[k][i * to->x.stride] = b->x.c[k][i * b->x.stride];
        for (int k = 0; k < 3 && vti_has(&b->alpha); ++k)
            to->alpha.c[k][i * to->alpha.stride] = b->alpha.c[k][i * b->alpha.stride];
        for (int k = 0; k < 4 && b->quat.xyzw[0] != NULL; ++k)
            to->quat.xyzw[k][i * to->quat.stride] = b->quat.xyzw[k][i * b->quat.stride];
    }
}

/** A drift by F/m and RM/J instead of v and Omega, body by body where masses differ; by the exact law, which has no bound.
 *  What has no v does not translate here either, and what has no Omega does not turn. */
static void displace(int frame, double t, const vti_bodies *b, const vti_bodies *to)
{
    const int translates = vti_has(&b->v) && vti_has(&b->force), turns = vti_has(&b->omega) && vti_has(&b->moment);
    vti_bodies centres = vti_bodies_none(b->count), attitudes = centres;
    centres.x = to->x;
    centres.v = b->force;
    attitudes.alpha = to->alpha;
    attitudes.quat = to->quat;
    attitudes.omega = b->moment;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        if (translates)
            vti_push(VTI_LAW_EXACT, frame, 0.0, t / vti_scalar(&b->mass, i), &centres, i, i + 1);
        if (turns)
            vti_push(VTI_LAW_EXACT, frame, 0.0, t / vti_scalar(&b->inertia, i), &attitudes, i, i + 1);
    }
}

int vti_step_probe(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, const vti_bodies *probed)
{
    int status = check(method, h, b, NULL);
    if (status == VTI_OK && (k < 0 || k > method->stages))
        status = VTI_E_STAGE;
    if (status == VTI_OK)
        status = vti_law_check((int)method->law, (int)method->frame);
    if (status == VTI_OK)
        status = probe_check(b, probed);
    if (status != VTI_OK)
        return status;
    copy_configuration(b, probed);
    if (method->probe != NULL && method->probe[k] != 0.0)
        displace((int)method->frame, method->probe[k] * h * h, b, probed);
    return VTI_OK;
}
