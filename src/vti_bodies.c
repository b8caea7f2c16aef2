/* SPDX-License-Identifier: BSD-3-Clause
 * Checks of the bodies' views and values (vti_bodies_check and others). */
#include "vti_ready.h"

/* The table of quantities has every member of vti_bodies, as it stands there. */
#define SIZE(constant, number, member, type, role) +sizeof(((vti_bodies *)0)->member)
typedef char table_is_complete[sizeof(vti_bodies) == 4 * sizeof(int64_t) VTI_QUANTITIES(SIZE) ? 1 : -1];
#undef SIZE

/** Not one body, but a quantity of all. Kept apart: what is rare costs sound bodies nothing. */
VTI_APART int refuse_all(int status, int64_t quantity, vti_fault *fault)
{
    return vti_refuse(status, -1, 0.0, quantity, fault);
}

/** VTI_E_COUNT if the view says how many it has, and these are too few. */
VTI_INLINE int count_check(int64_t count, int64_t end, int64_t quantity, vti_fault *fault)
{
    return count != 0 && end > count ? vti_refuse(VTI_E_COUNT, -1, (double)count, quantity, fault) : VTI_OK;
}

/** One view: all components or none, on different memory, and a stride if there is more than one body, unless one is
 *  for all. */
VTI_INLINE int view_check(const vti_view *view, int64_t end, int one_for_all, int64_t quantity, vti_fault *fault)
{
    double *const *c = view->c;
    if (c[0] == NULL && c[1] == NULL && c[2] == NULL)
        return VTI_OK;
    if (c[0] == NULL || c[1] == NULL || c[2] == NULL)
        return refuse_all(VTI_E_VIEW, quantity, fault);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
        return refuse_all(VTI_E_ALIAS, quantity, fault);
    if (view->stride == 0 && end > 1)
        return one_for_all ? VTI_OK : refuse_all(VTI_E_STRIDE, quantity, fault);
    return count_check(view->count, end, quantity, fault);
}

static int quat_check(const vti_bodies *b, const vti_quat_view *quat, int64_t end, int one_for_all, int64_t quantity,
                      vti_fault *fault)
{
    double *const *c = quat->xyzw;
    int given = 0;
    for (int k = 0; k < 4; ++k)
        given += c[k] != NULL;
    if (given == 0)
        return VTI_OK;
    if (given < 4 || (vti_has(&b->alpha) && quat == &b->quat))
        return refuse_all(VTI_E_VIEW, quantity, fault);
    if (vti_has(&b->alpha_low) && quat == &b->quat) /* goes with alpha */
        return refuse_all(VTI_E_VIEW, VTI_QUANTITY_ALPHA_LOW, fault);
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < k; ++j)
            if (c[k] == c[j])
                return refuse_all(VTI_E_ALIAS, quantity, fault);
    if (quat->stride == 0 && end > 1)
        return one_for_all ? VTI_OK : refuse_all(VTI_E_STRIDE, quantity, fault);
    return count_check(quat->count, end, quantity, fault);
}

/** Whether a kick may divide by it. */
static int divides(double a)
{
    return vti_is_positive(a) && isfinite(1.0 / a);
}

/** A kick needs what it divides by; one value for all is looked at here, arrays in vti_bodies_check_values. */
static int scalars_check(const vti_scalars *s, int64_t end, int needed, int error, int64_t quantity, vti_fault *fault)
{
    if (s->p == NULL)
        return needed ? vti_refuse(error, -1, 0.0, quantity, fault) : VTI_OK;
    if (s->stride == 0 && !divides(*s->p))
        return vti_refuse(error, -1, *s->p, quantity, fault);
    return count_check(s->count, end, quantity, fault);
}

/** The moment of body i that is no principal moment of a body: not positive, of no finite inverse, or more than the sum
 *  of the two others, which sums that were rounded to single precision may be; VTI_OK if there is none. */
static int moments_check(const vti_view *moments, int64_t i, int64_t named, vti_fault *fault)
{
    double m[3];
    vti_load(moments, i, m);
    for (int k = 0; k < 3; ++k)
        if (!divides(m[k]))
            return vti_refuse(VTI_E_MOMENTS, named, m[k], VTI_QUANTITY_MOMENTS, fault);
    for (int k = 0; k < 3; ++k)
        if (m[k] - m[(k + 1) % 3] > m[(k + 2) % 3] + 0x1p-20 * m[k])
            return vti_refuse(VTI_E_MOMENTS, named, m[k], VTI_QUANTITY_MOMENTS, fault);
    return VTI_OK;
}

/** What general inertia goes with (EQUATIONS 7.1). */
VTI_APART int general_check(const vti_bodies *b, vti_fault *fault)
{
    if (!vti_has(&b->moments))
        return refuse_all(VTI_E_MOMENTS, VTI_QUANTITY_MOMENTS, fault);
    if (b->inertia.p != NULL)
        return refuse_all(VTI_E_MOMENTS, VTI_QUANTITY_INERTIA, fault);
    if (vti_has(&b->omega_low))
        return refuse_all(VTI_E_MOMENTS, VTI_QUANTITY_OMEGA_LOW, fault);
    if (vti_has(&b->omega) && !vti_has(&b->spin) && !vti_has_attitude(b))
        return refuse_all(VTI_E_MOMENTS, VTI_QUANTITY_OMEGA, fault);
    return b->moments.stride == 0 ? moments_check(&b->moments, 0, -1, fault) : VTI_OK;
}

int vti_bodies_fault(const vti_bodies *b, vti_fault *fault)
{
    if (b == NULL)
        return VTI_E_NULL;
    if (b->abi != VTI_ABI)
        return VTI_E_ABI;
    if (b->first < 0 || b->count < 0 || b->first > INT64_MAX - b->count)
        return VTI_E_COUNT;
    if (b->count == 0) /* nothing will be touched, and empty arrays may share an address */
        return VTI_OK;

    const int64_t end = b->first + b->count;
    int status = VTI_OK;
#define STATE_FOR_ALL 0
#define LOAD_FOR_ALL 0
#define LOW_FOR_ALL 0
#define CONSTANT_FOR_ALL 1
#define CHECK_vti_view(member, quantity, all) view_check(&b->member, end, all, quantity, fault)
#define CHECK_vti_quat_view(member, quantity, all) quat_check(b, &b->member, end, all, quantity, fault)
#define CHECK_vti_scalars(member, quantity, all) VTI_OK /* below */
#define CHECK(constant, number, member, type, role)                                                                    \
    status = status != VTI_OK ? status : CHECK_##type(member, constant, role##_FOR_ALL);
    VTI_QUANTITIES(CHECK)
    status = status != VTI_OK ? status : vti_alias_check(b, fault);
    if (status == VTI_OK)
        status =
            scalars_check(&b->mass, end, vti_has(&b->v) && vti_has(&b->force), VTI_E_MASS, VTI_QUANTITY_MASS, fault);
    if (status == VTI_OK)
        status = vti_has(&b->moments) || vti_has(&b->spin)
                     ? general_check(b, fault)
                     : scalars_check(&b->inertia, end, vti_has(&b->omega) && vti_has(&b->moment), VTI_E_INERTIA,
                                     VTI_QUANTITY_INERTIA, fault);
    return status;
}

int64_t vti_bodies_named(const vti_bodies *b, int64_t reads)
{
    const int64_t attitude = 1 << VTI_QUANTITY_ALPHA | 1 << VTI_QUANTITY_QUAT;
    const int64_t all = reads & attitude ? reads | attitude : reads;
    const int64_t others[] = {b->x.count, b->alpha.count, b->quat.count, b->first + b->count};
    int64_t named = 0;
#define FEWEST(constant, number, member, type, role)                                                                   \
    if (all & 1 << (constant) && b->member.count != 0 && (named == 0 || b->member.count < named))                      \
        named = b->member.count;
    VTI_QUANTITIES(FEWEST)
#undef FEWEST
    for (int k = 0; k < 4 && named == 0; ++k)
        named = others[k];
    return named;
}

int vti_bodies_check(const vti_bodies *b)
{
    return vti_bodies_fault(b, NULL);
}

int vti_bodies_seal(vti_bodies *b)
{
    const int status = vti_bodies_check(b);
    if (b != NULL)
        b->sealed = status == VTI_OK ? vti_seal_of(b) : 0;
    return status;
}

static int values_check(const vti_scalars *s, const vti_bodies *b, int error, int64_t quantity, vti_fault *fault)
{
    for (int64_t i = b->first; s->p != NULL && i < b->first + b->count; ++i)
        if (!divides(vti_scalar(s, i)))
            return vti_refuse(error, i, vti_scalar(s, i), quantity, fault);
    return VTI_OK;
}

/** n numbers of body i: all finite. */
static int state_check(double *const *c, int n, int64_t at, int64_t i, int64_t quantity, vti_fault *fault)
{
    double bad = 0.0;
    for (int k = 0; k < n; ++k)
        bad = isfinite(c[k][at]) ? bad : c[k][at];
    return bad == 0.0 ? VTI_OK : vti_refuse(VTI_E_STATE, i, bad, quantity, fault);
}

/** A quaternion of body i: the square of its length, by which it is divided, is a normal number. */
static int quat_state_check(double *const *c, int64_t at, int64_t i, int64_t quantity, vti_fault *fault)
{
    double square = 0.0, longest = 0.0;
    for (int k = 0; k < 4; ++k) {
        square += c[k][at] * c[k][at];
        longest = fabs(c[k][at]) > fabs(longest) ? c[k][at] : longest;
    }
    const int status = state_check(c, 4, at, i, quantity, fault);
    return status != VTI_OK || isnormal(square) ? status : vti_refuse(VTI_E_STATE, i, longest, quantity, fault);
}

/** What a step moves, of one body. */
static int body_check(const vti_bodies *b, int64_t i, vti_fault *fault)
{
    int status = VTI_OK;
#define STATE_vti_view(member, quantity) state_check(b->member.c, 3, i * b->member.stride, i, quantity, fault)
#define STATE_vti_quat_view(member, quantity) quat_state_check(b->member.xyzw, i * b->member.stride, i, quantity, fault)
#define GIVEN_vti_view(member) vti_has(&b->member)
#define GIVEN_vti_quat_view(member) (b->member.xyzw[0] != NULL)
#define CHECK_STATE(constant, member, type)                                                                            \
    if (GIVEN_##type(member) && status == VTI_OK)                                                                      \
        status = STATE_##type(member, constant);
#define CHECK_LOAD(constant, member, type)
#define CHECK_CONSTANT(constant, member, type) CONSTANT_##type(constant, member)
#define CONSTANT_vti_scalars(constant, member)
#define CONSTANT_vti_view(constant, member) /* moments_check */
#define CONSTANT_vti_quat_view(constant, member) CHECK_STATE(constant, member, vti_quat_view)
#define CHECK_LOW(constant, member, type)
#define CHECK_ROLE(constant, number, member, type, role) CHECK_##role(constant, member, type)
    VTI_QUANTITIES(CHECK_ROLE)
    return status;
}

static int states_check(const vti_bodies *b, vti_fault *fault)
{
    static const vti_view none;
    vti_bodies read = *b;
    int status = VTI_OK;
    if (vti_has(&b->spin)) /* beside which omega is only written */
        read.omega = none;
    for (int64_t i = b->first; i < b->first + b->count && status == VTI_OK; ++i)
        status = body_check(&read, i, fault);
    return status;
}

int vti_bodies_values_fault(const vti_bodies *b, vti_fault *fault)
{
    int status = vti_bodies_fault(b, fault);
    if (status == VTI_OK)
        status = values_check(&b->mass, b, VTI_E_MASS, VTI_QUANTITY_MASS, fault);
    if (status == VTI_OK)
        status = values_check(&b->inertia, b, VTI_E_INERTIA, VTI_QUANTITY_INERTIA, fault);
    if (status != VTI_OK) /* there may be no bodies to look at */
        return status;
    for (int64_t i = b->first; vti_has(&b->moments) && i < b->first + b->count && status == VTI_OK; ++i)
        status = moments_check(&b->moments, i, i, fault);
    return status == VTI_OK ? states_check(b, fault) : status;
}

int vti_bodies_check_values(const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    return vti_bodies_values_fault(b, fault);
}
