/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The steppers, as data, and the step that plays them. With kick and drift as in vti_move.c:
 *
 *     VTI-1 (the paper's first map)   kick(h/2) drift(h) kick(h/2), closed form
 *     VTI-2 (the second)              kick(h/2) drift(h) kick(h/2), Cayley
 *     VTI-3 (Campello's, phi = 1)     kick(h) drift(h), Cayley
 *
 * All three are exactly variational (E14, E15); VTI-3 = kick(-h/2) VTI-2 kick(h/2). The others are longer lists of the
 * same two, with the exact drift; with another one they fall to order 2. */
#include <float.h>
#include <string.h>

#include "vti_coefficients.h"
#include "vti_move.h"
#include "vti_steppers.h"
#include "vti_moments.h"
#include "vti_ready.h"

static const vti_stepper steppers[] = {
#define ROW(...) {__VA_ARGS__},
    VTI_STEPPERS(ROW)
#undef ROW
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

static int check(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    int status = vti_stepper_check(method);
    if (status == VTI_OK)
        status = vti_bodies_ready_or(b, fault);
    if (status == VTI_OK)
        status = vti_stepper_suits(method, b, fault);
    if (status != VTI_OK)
        return status;
    return vti_is_positive(h) ? VTI_OK : vti_refuse(VTI_E_TIME, -1, h, VTI_QUANTITY_NONE, fault);
}

/** kick(before h), kick(kick[k] h), drift(drift[k] h); a kick of 0 does not look at the forces. */
VTI_INLINE int play(const vti_stepper *method, double before, int64_t k, double h, const vti_bodies *b,
                    vti_fault *fault)
{
    const struct vti_move move = {before * h,       method->kick[k] * h, method->drift[k] * h, 1,
                                  (int)method->law, (int)method->frame,  (int)method->rotor};
    int status = VTI_OK;
    if (vti_has(&b->moments))
        status = vti_rotor_check(&move, b, fault);
    else if (move.law == VTI_LAW_CLOSED)
        status = vti_move_check(&move, b, fault);
    if (status == VTI_OK)
        vti_move_all(&move, b);
    return status;
}

VTI_INLINE int stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    int status = check(method, h, b, fault);
    if (status == VTI_OK && (k < 0 || k >= method->stages))
        status = VTI_E_STAGE;
    return status == VTI_OK ? play(method, 0.0, k, h, b, fault) : status;
}

int vti_step_stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, vti_fault *fault)
{
    return stage(method, k, h, b, fault);
}

int vti_step_begin(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    return stage(method, 0, h, b, fault);
}

/** kick(share h) of bodies that have been checked; a share of 0 touches nothing. */
static int kick_share(double share, double h, const vti_bodies *b)
{
    const struct vti_move move = {0.0, share * h, 0.0, 0, VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0};
    if (!(fabs(move.kick) <= DBL_MAX))
        return VTI_E_TIME;
    if (move.kick != 0.0)
        vti_move_all(&move, b);
    return VTI_OK;
}

int vti_step_finish(const vti_stepper *method, double h, const vti_bodies *b)
{
    int status = check(method, h, b, NULL);
    if (status != VTI_OK)
        return status;
    if (method->drift[method->stages] != 0.0)
        return play(method, 0.0, method->stages, h, b, NULL);
    return kick_share(method->kick[method->stages], h, b);
}

int vti_step_next(const vti_stepper *method, double h, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    const int status = check(method, h, b, fault);
    if (status != VTI_OK)
        return status;
    if (method->drift[method->stages] != 0.0) /* two drifts */
        return VTI_E_STAGE;
    return play(method, method->kick[method->stages], 0, h, b, fault);
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

/* ---- force gradients --------------------------------------------------------------------------------------------- */

/** Whether a is where any quantity of the bodies begins. */
static int is_of(const vti_bodies *b, const double *a)
{
#define START_vti_view(member) b->member.c[0],
#define START_vti_quat_view(member) b->member.xyzw[0],
#define START_vti_scalars(member) b->member.p,
#define START(constant, number, member, type, role) START_##type(member)
    const double *const all[] = {VTI_QUANTITIES(START)};
    int found = 0;
    for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k)
        found |= a != NULL && all[k] == a;
    return found;
}

static int probe_check(const vti_bodies *b, const vti_bodies *probed)
{
    const int status = vti_bodies_check(probed); /* what they hold is to be written */
    if (status != VTI_OK)
        return status;
    if (probed->first != b->first || probed->count != b->count)
        return VTI_E_COUNT;
    if (vti_has(&probed->x) != vti_has(&b->x) || vti_has(&probed->alpha) != vti_has(&b->alpha) ||
        vti_has_attitude(probed) != vti_has_attitude(b))
        return VTI_E_VIEW;
    const int same =
        b->count > 0 && (is_of(b, probed->x.c[0]) || is_of(b, probed->alpha.c[0]) || is_of(b, probed->quat.xyzw[0]));
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

/** A drift by F/m and RM/J instead of v and Omega, body by body where masses differ; by the exact law, which has no
 *  bound. What has no v does not translate here either, and what has no Omega or L does not turn. */
static void displace(int frame, double t, const vti_bodies *b, const vti_bodies *to)
{
    const int general = vti_has(&b->moments), translates = vti_has(&b->v) && vti_has(&b->force);
    const int turns = (vti_has(&b->omega) || vti_has(&b->spin)) && vti_has(&b->moment);
    double w[3];
    vti_bodies centres = vti_bodies_none(1), attitudes = centres;
    centres.x = to->x;
    centres.v = b->force;
    attitudes.alpha = to->alpha;
    attitudes.quat = to->quat;
    attitudes.omega = general ? (vti_view){{w, w + 1, w + 2}, 0, 0} : b->moment;
    struct vti_move move = {0.0, 0.0, 0.0, 1, VTI_LAW_EXACT, frame, 0};
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        centres.first = attitudes.first = i;
        if (translates) {
            move.drift = t / vti_scalar(&b->mass, i);
            vti_move_all(&move, &centres);
        }
        if (turns) {
            move.drift = general ? t : t / vti_scalar(&b->inertia, i);
            if (general)
                vti_rotor_over(b, i, &b->moment, w);
            vti_move_all(&move, &attitudes);
        }
    }
}

int vti_step_probe(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, const vti_bodies *probed)
{
    int status = check(method, h, b, NULL);
    if (status == VTI_OK && (k < 0 || k > method->stages))
        status = VTI_E_STAGE;
    if (status == VTI_OK)
        status = probe_check(b, probed);
    if (status != VTI_OK)
        return status;
    copy_configuration(b, probed);
    if (method->probe != NULL && method->probe[k] != 0.0)
        displace((int)method->frame, method->probe[k] * h * h, b, probed);
    return VTI_OK;
}
