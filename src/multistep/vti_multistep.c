/* SPDX-License-Identifier: BSD-3-Clause
 *
 * AN(K, c) (EQUATIONS 8.1). With a = F/m, w = Omega, b = RM/J and the backward differences N^0 f = f_n,
 * N^j f_n = N^{j-1} f_n - N^{j-1} f_{n-1}:
 *
 *     predict   v_p = v + h sum g_j N^j a,  x_p = x + h v + h^2 sum d_j N^j a,  w_p = w + h sum g_j N^j b
 *               R_p = R turned by the Magnus vector of w(s) = w + h sum G_j(s) N^j b
 *     correct   D = f_{n+1} - sum_{j<K} N^j f_n, f_{n+1} at the predicted state
 *               v = v_p + h g D_a,  x = x_p + c h^2 d_K D_a,  w = w_p + h g D_b,  R = R(c h^2 d_K D_b) R_p,
 *               g = g_K + u, R(r) by Cayley's law, as r is small
 *
 * With u not 0 the last order is given for a larger reach. With c = 0 positions and attitudes stay where they were
 * predicted, which is where the forces are from: AN(1, 0) is velocity Verlet, AN(2, 0) Beeman's method. */
#define VTI_WIDTH 1 /* what is done here is done body by body */

#include <string.h>

#include "vti_adams_kernels.h"
#include "../vti_move.h"
#include "../vti_ready.h"

/* With the u of an4 the amplitude of x'' = -w^2 x falls by (h w)^8/48 of itself a step, and grows at no step below
 * 1.2249. an7 has the c of the widest reach, an9 c and u of a small error at a wide one. Of K = 10 an10-fine (c = 4/5)
 * has the smallest error, an10-mid (c = -1/2) twice its reach */
static const vti_multistep methods[] = {
    {"an4", 4, 0.0, -3.0 / 80.0, 1.225, "Adams-Nystroem, order 4, one force evaluation a step; not symplectic"},
    {"an7", 7, -0.75, 0.0, 0.825, "the same of order 8"},
    {"an9", 9, -0.3, -0.07, 0.593, "the same of order 9"},
    {"an10-mid", 10, -0.5, 0.0, 0.25, "the same of order 11, at smaller steps"},
    {"an10-fine", 10, 0.8, 0.0, 0.129, "the same of order 11, at steps that are smaller still"},
};

enum { METHODS = sizeof methods / sizeof methods[0] };

int64_t vti_multistep_count(void)
{
    return METHODS;
}

const vti_multistep *vti_multistep_at(int64_t index)
{
    return index >= 0 && index < METHODS ? &methods[index] : NULL;
}

const vti_multistep *vti_multistep_find(const char *name)
{
    for (int64_t i = 0; name != NULL && i < METHODS; ++i)
        if (strcmp(name, methods[i].name) == 0)
            return &methods[i];
    return NULL;
}

/* ---- what is remembered ------------------------------------------------------------------------------------------ */

static int check_past(const vti_past *past, const vti_bodies *b, vti_fault *fault)
{
    if (past == NULL)
        return VTI_E_NULL;
    const int status = vti_bodies_ready_or(b, fault);
    if (status != VTI_OK)
        return status;
    const int refused = vti_multistep_suits(b, fault);
    if (refused != VTI_OK)
        return refused;
    if (past->memory == NULL || past->depth < 1 || past->known < 0 || past->known > past->depth)
        return vti_refuse(VTI_E_PAST, -1, (double)past->known, VTI_QUANTITY_NONE, fault);
    return VTI_OK;
}

int vti_multistep_record(vti_past *past, const vti_bodies *b)
{
    const int status = check_past(past, b, NULL);
    if (status != VTI_OK)
        return status;
    const vti_view force = adams_load(&b->force, &b->v), moment = adams_load(&b->moment, &b->omega);
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        struct adams_felt f, off;
        adams_feel(&force, &b->mass, &moment, &b->inertia, i, &f);
        adams_compare(1, 0, adams_levels(past), adams_differences(past, i), 0, f, &off);
    }
    past->known += past->known < past->depth;
    return VTI_OK;
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

static int check(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (method == NULL || method->depth < 1 || method->depth > ADAMS_MOST || !isfinite(method->c + method->u))
        return VTI_E_STEPPER;
    const int status = check_past(past, b, fault);
    if (status != VTI_OK)
        return status;
    if (!vti_is_positive(h))
        return vti_refuse(VTI_E_TIME, -1, h, VTI_QUANTITY_NONE, fault);
    return past->known >= method->depth ? VTI_OK
                                        : vti_refuse(VTI_E_PAST, -1, (double)past->known, VTI_QUANTITY_NONE, fault);
}

/** Of so many bodies the past does not stay in the cache. */
enum { MANY = 4096 };

/** The kernels for so many bodies. Two at once are for the cache: from memory a past comes at half the speed where two
 *  places of it are read in turns. */
static const struct vti_move_kernels *const *kernels(int64_t bodies)
{
    const struct vti_move_kernels *const *first = vti_move_served();
    (void)bodies;
#ifdef VTI_HAS_AVX512
    first += bodies >= MANY && *first == &vti_move_avx512;
#endif
    return first;
}

/** Turns by what predict or correct has left, so many numbers of each body. */
static void turn_all(const struct vti_move_kernels *const *k, const double *by, int64_t each, const vti_bodies *b,
                     int64_t begin, int64_t end)
{
    int64_t i = begin;
    for (; *k != NULL && i + 1 < end; ++k)
        i = (*k)->turn(by + each * (i - begin), each, b, i, end);
    for (; i < end; ++i) {
        lanes theta[3];
        adams_theta(by + each * (i - begin), each, 1, theta);
        const double one[3] = {lanes_get(theta[0], 0), lanes_get(theta[1], 0), lanes_get(theta[2], 0)};
        vti_move_turn_by(adams_law(each), one, b, i);
    }
}

/** Bodies are turned so many at once, in vector registers where there are enough. */
enum { TILE = 64 };

/** Half a step of all bodies of the slice, and then the turns that it asks for. */
static void in_tiles(int corrects, const vti_multistep *m, double h, const vti_past *past, const vti_bodies *b)
{
    const struct vti_move_kernels *const *const widest = kernels(b->count);
    const int turns = vti_has(&b->omega) && vti_has_attitude(b) && !(corrects && adams_way(m, h) == 0.0);
    const int64_t each = corrects ? ADAMS_CORRECTION : ADAMS_PREDICTION;
    double turn[ADAMS_PREDICTION * TILE];
    for (int64_t begin = b->first, last = b->first + b->count, i = begin; begin < last; begin = i) {
        const int64_t end = last - begin < TILE ? last : begin + TILE;
        for (const struct vti_move_kernels *const *k = widest; *k != NULL && i < end; ++k)
            i = (corrects ? (*k)->correct : (*k)->predict)(m, h, past, b, i, end, turn + each * (i - begin));
        if (i < end) /* compiled for eight lanes, the last kernels too take two bodies at once */
            i = (corrects ? adams_correct : adams_predict)(m, h, past, b, i, end, turn + each * (i - begin));
        if (turns)
            turn_all(widest, turn, each, b, begin, end);
    }
}

int vti_multistep_predict(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b,
                          vti_fault *fault)
{
    const int status = check(method, h, past, b, fault);
    if (status == VTI_OK)
        in_tiles(0, method, h, past, b);
    return status;
}

int vti_multistep_correct(const vti_multistep *method, double h, vti_past *past, const vti_bodies *b)
{
    const int status = check(method, h, past, b, NULL);
    if (status != VTI_OK)
        return status;
    in_tiles(1, method, h, past, b);
    past->known += past->known < past->depth;
    return VTI_OK;
}

int vti_multistep_error(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b,
                        double *velocity, double *omega)
{
    const int status = check(method, h, past, b, NULL);
    if (status != VTI_OK)
        return status;
    if (velocity == NULL || omega == NULL)
        return VTI_E_NULL;
    *velocity = *omega = 0.0;
    const vti_view force = adams_load(&b->force, &b->v), moment = adams_load(&b->moment, &b->omega);
    const double g = h * fabs(adams_corrector(method));
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        struct adams_felt f, off;
        double a[3], w[3];
        adams_feel(&force, &b->mass, &moment, &b->inertia, i, &f);
        adams_compare(0, method->depth, method->depth, adams_differences(past, i), 0, f, &off);
        for (int k = 0; k < 3; ++k) {
            a[k] = quad_get(off.low, 0, k);
            w[k] = quad_get(off.high, 0, 1 + k);
        }
        *velocity = vti_larger(*velocity, g * vti_norm(a));
        *omega = vti_larger(*omega, g * vti_norm(w));
    }
    return VTI_OK;
}
