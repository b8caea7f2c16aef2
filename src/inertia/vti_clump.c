/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Clumps (EQUATIONS 7.5): the list, and spheres where their bodies have them. */
#include "vti_clump_spheres.h"
#include "../vti_moments.h"
#include "../vti_ready.h"

/* ---- the list ---------------------------------------------------------------------------------------------------- */

int vti_clump_list_check(const vti_clumps *c)
{
    if (c == NULL || (c->count > 0 && (c->body == NULL || c->offset == NULL)))
        return VTI_E_NULL;
    return c->count < 0 || c->spheres.first != 0 || c->spheres.count != c->count ? VTI_E_COUNT : VTI_OK;
}

/** The first sphere whose body is i or behind it. */
static int64_t sphere_from(const vti_clumps *c, int64_t i)
{
    int64_t low = 0, high = c->count;
    while (low < high) {
        const int64_t middle = low + (high - low) / 2;
        if (c->body[middle] - c->base < i)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

vti_bodies vti_clumps_spheres(const vti_clumps *c, const vti_bodies *b)
{
    if (b == NULL || vti_clump_list_check(c) != VTI_OK)
        return vti_bodies_none(0);
    const int64_t from = sphere_from(c, b->first);
    return vti_bodies_slice(c->spheres, from, sphere_from(c, b->first + b->count) - from);
}

static int sphere_check(const vti_clumps *c, int64_t s, int64_t n, vti_fault *fault)
{
    if (!vti_is_body(c->body[s], c->base, n) || (s > 0 && c->body[s] < c->body[s - 1]))
        return vti_refuse(VTI_E_CLUMP, s, (double)c->body[s], VTI_QUANTITY_NONE, fault);
    for (int k = 0; k < 3; ++k)
        if (!isfinite(c->offset[3 * s + k]))
            return vti_refuse(VTI_E_CLUMP, s, c->offset[3 * s + k], VTI_QUANTITY_NONE, fault);
    return VTI_OK;
}

int vti_clumps_check(const vti_clumps *c, int64_t n, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    int status = vti_clump_list_check(c);
    if (status == VTI_OK && n < 0)
        status = VTI_E_COUNT;
    for (int64_t s = 0; status == VTI_OK && s < c->count; ++s)
        status = sphere_check(c, s, n, fault);
    return status;
}

/** Whether a quantity of the spheres begins where that of the bodies does. */
static int is_shared(const vti_bodies *spheres, const vti_bodies *b)
{
    int shared = 0;
#define START_vti_view(bodies, member) (bodies)->member.c[0]
#define START_vti_quat_view(bodies, member) (bodies)->member.xyzw[0]
#define MOVED_STATE(type, member)                                                                                      \
    shared |= START_##type(b, member) != NULL && START_##type(b, member) == START_##type(spheres, member);
#define MOVED_LOAD(type, member) MOVED_STATE(type, member)
#define MOVED_LOW(type, member)
#define MOVED_CONSTANT(type, member)
#define MOVED(constant, number, member, type, role) MOVED_##role(type, member)
    VTI_QUANTITIES(MOVED)
    return shared;
}

int vti_clump_ready(const vti_clumps *c, const vti_bodies *b)
{
    int status = vti_bodies_ready(b);
    if (status == VTI_OK)
        status = VTI_LOOKS
                     ? vti_clumps_check(c, vti_bodies_named(b, 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_ALPHA), NULL)
                     : vti_clump_list_check(c);
    if (status == VTI_OK)
        status = vti_bodies_fault(&c->spheres, NULL);
    if (status == VTI_OK && c->count > 0 && is_shared(&c->spheres, b)) /* empty arrays may share an address */
        status = VTI_E_ALIAS;
    return status == VTI_OK && c->count > 0 && !vti_has_attitude(b) ? VTI_E_NEEDS : status;
}

/* ---- spread and gather ------------------------------------------------------------------------------------------- */

/** Omega of body i, by L where it turns by that (EQUATIONS 7.1). */
static void turning(const vti_bodies *b, int64_t i, double omega[3])
{
    if (vti_has(&b->spin))
        vti_rotor_over(b, i, &b->spin, omega);
    else
        vti_load_or_zero(&b->omega, i, omega);
}

/** x_s = x + r */
static void put_place(const vti_clumps *c, const vti_bodies *b, int64_t s, int64_t i, const double r[3])
{
    double x[3];
    vti_load_or_zero(&b->x, i, x);
    for (int k = 0; k < 3; ++k)
        x[k] += r[k];
    vti_store(&c->spheres.x, s, x);
}

/** v_s = v + Omega x r */
static void put_velocity(const vti_clumps *c, const vti_bodies *b, int64_t s, int64_t i, const double omega[3],
                         const double r[3])
{
    double v[3], turn[3];
    vti_load_or_zero(&b->v, i, v);
    vti_cross(omega, r, turn);
    for (int k = 0; k < 3; ++k)
        v[k] += turn[k];
    vti_store(&c->spheres.v, s, v);
}

/** The attitude of the body, in the form that the spheres have; the same form is the same bits. */
static void put_attitude(const vti_bodies *spheres, const vti_bodies *b, int64_t s, int64_t i)
{
    double a[3], q[4];
    vti_load_pair(b, i, q);
    if (vti_has(&spheres->alpha)) {
        if (vti_has(&b->alpha))
            vti_load(&b->alpha, i, a);
        else
            vti_rrv_from_quat_xyzw(q, a);
        vti_store(&spheres->alpha, s, a);
    }
    if (spheres->quat.xyzw[0] == NULL)
        return;
    if (vti_has(&b->alpha)) {
        vti_load(&b->alpha, i, a);
        vti_rrv_to_quat_xyzw(a, q);
    }
    for (int k = 0; k < 4; ++k)
        spheres->quat.xyzw[k][s * spheres->quat.stride] = q[k];
}

void vti_clump_spread(const vti_clumps *c, const vti_bodies *b, int64_t from, int64_t to)
{
    for (int64_t s = from; s < to; ++s) {
        const int64_t i = c->body[s] - c->base;
        double r[3], omega[3];
        vti_clump_lever(c, b, s, i, r);
        turning(b, i, omega);
        if (vti_has(&c->spheres.x))
            put_place(c, b, s, i, r);
        if (vti_has(&c->spheres.v))
            put_velocity(c, b, s, i, omega, r);
        if (vti_has(&c->spheres.omega))
            vti_store(&c->spheres.omega, s, omega);
        put_attitude(&c->spheres, b, s, i);
    }
}

void vti_clump_gather(const vti_clumps *c, const vti_bodies *b, int64_t from, int64_t to)
{
    for (int64_t s = from; s < to; ++s) {
        const int64_t i = c->body[s] - c->base;
        double r[3], force[3], moment[3], turn[3];
        vti_load_or_zero(&c->spheres.force, s, force);
        vti_load_or_zero(&c->spheres.moment, s, moment);
        if (vti_has(&b->force))
            vti_add(&b->force, i, force);
        if (!vti_has(&b->moment))
            continue;
        vti_clump_lever(c, b, s, i, r);
        vti_cross(r, force, turn);
        for (int k = 0; k < 3; ++k)
            moment[k] += turn[k];
        vti_add(&b->moment, i, moment);
    }
}

int vti_clumps_spread(const vti_clumps *c, const vti_bodies *b)
{
    const int status = vti_clump_ready(c, b);
    if (status == VTI_OK)
        vti_clump_spread(c, b, sphere_from(c, b->first), sphere_from(c, b->first + b->count));
    return status;
}

int vti_clumps_gather(const vti_clumps *c, const vti_bodies *b)
{
    const int status = vti_clump_ready(c, b);
    if (status == VTI_OK)
        vti_clump_gather(c, b, sphere_from(c, b->first), sphere_from(c, b->first + b->count));
    return status;
}
