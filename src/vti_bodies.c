/* SPDX-License-Identifier: BSD-3-Clause
 * What a stateless library can see of wrong use before it touches a body. */
#include "vti_internal.h"

/** Nothing about one body, but a quantity of all. Kept apart: what is rare costs sound bodies nothing. */
VTI_APART int blame_all(int status, int64_t quantity, vti_fault *fault)
{
    return vti_blame(status, -1, 0.0, quantity, fault);
}

/** A view of which the end is known shows all bodies. */
VTI_INLINE int count_check(int64_t count, int64_t end, int64_t quantity, vti_fault *fault)
{
    return count != 0 && end > count ? vti_blame(VTI_E_COUNT, -1, (double)count, quantity, fault) : VTI_OK;
}

/** One view: all components or none, on different memory, and a stride if there is more than one body. */
VTI_INLINE int view_check(const vti_view *view, int64_t end, int64_t quantity, vti_fault *fault)
{
    double *const *c = view->c;
    if (c[0] == NULL && c[1] == NULL && c[2] == NULL)
        return VTI_OK;
    if (c[0] == NULL || c[1] == NULL || c[2] == NULL)
        return blame_all(VTI_E_VIEW, quantity, fault);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
        return blame_all(VTI_E_ALIAS, quantity, fault);
    if (view->stride == 0 && end > 1)
        return blame_all(VTI_E_STRIDE, quantity, fault);
    return count_check(view->count, end, quantity, fault);
}

static int quat_check(const vti_bodies *b, int64_t end, vti_fault *fault)
{
    double *const *c = b->quat.xyzw;
    int given = 0;
    for (int k = 0; k < 4; ++k)
        given += c[k] != NULL;
    if (given == 0)
        return VTI_OK;
    if (given < 4 || vti_has(&b->alpha))
        return blame_all(VTI_E_VIEW, VTI_QUANTITY_QUAT, fault);
    if (vti_has(&b->alpha_low)) /* goes with alpha */
        return blame_all(VTI_E_VIEW, VTI_QUANTITY_ALPHA_LOW, fault);
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < k; ++j)
            if (c[k] == c[j])
                return blame_all(VTI_E_ALIAS, VTI_QUANTITY_QUAT, fault);
    if (b->quat.stride == 0 && end > 1)
        return blame_all(VTI_E_STRIDE, VTI_QUANTITY_QUAT, fault);
    return count_check(b->quat.count, end, VTI_QUANTITY_QUAT, fault);
}

static int is_positive(double value)
{
    return isfinite(value) && value > 0.0;
}

/** A kick needs what it divides by; one value for all is looked at here, arrays in vti_bodies_check_values. */
static int scalars_check(const vti_scalars *s, int64_t end, int needed, int error, int64_t quantity, vti_fault *fault)
{
    if (s->p == NULL)
        return needed ? vti_blame(error, -1, 0.0, quantity, fault) : VTI_OK;
    if (s->stride == 0 && !is_positive(*s->p))
        return vti_blame(error, -1, *s->p, quantity, fault);
    return count_check(s->count, end, quantity, fault);
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
    int status = view_check(&b->x, end, VTI_QUANTITY_X, fault);
    status = status != VTI_OK ? status : view_check(&b->v, end, VTI_QUANTITY_V, fault);
    status = status != VTI_OK ? status : view_check(&b->force, end, VTI_QUANTITY_FORCE, fault);
    status = status != VTI_OK ? status : view_check(&b->alpha, end, VTI_QUANTITY_ALPHA, fault);
    status = status != VTI_OK ? status : view_check(&b->omega, end, VTI_QUANTITY_OMEGA, fault);
    status = status != VTI_OK ? status : view_check(&b->moment, end, VTI_QUANTITY_MOMENT, fault);
    status = status != VTI_OK ? status : view_check(&b->x_low, end, VTI_QUANTITY_X_LOW, fault);
    status = status != VTI_OK ? status : view_check(&b->v_low, end, VTI_QUANTITY_V_LOW, fault);
    status = status != VTI_OK ? status : view_check(&b->alpha_low, end, VTI_QUANTITY_ALPHA_LOW, fault);
    status = status != VTI_OK ? status : view_check(&b->omega_low, end, VTI_QUANTITY_OMEGA_LOW, fault);
    status = status != VTI_OK ? status : quat_check(b, end, fault);
    status = status != VTI_OK ? status : vti_alias_check(b, fault);
    if (status == VTI_OK)
        status =
            scalars_check(&b->mass, end, vti_has(&b->v) && vti_has(&b->force), VTI_E_MASS, VTI_QUANTITY_MASS, fault);
    if (status == VTI_OK)
        status = scalars_check(&b->inertia, end, vti_has(&b->omega) && vti_has(&b->moment), VTI_E_INERTIA,
                               VTI_QUANTITY_INERTIA, fault);
    return status;
}

int vti_bodies_check(const vti_bodies *b)
{
    return vti_bodies_fault(b, NULL);
}

int vti_bodies_seal(vti_bodies *b)
{
    const int status = vti_bodies_check(b);
    if (b != NULL)
        b->sealed = status == VTI_OK ? VTI_SEAL : 0;
    return status;
}

static int values_check(const vti_scalars *s, const vti_bodies *b, int error, int64_t quantity, vti_fault *fault)
{
    for (int64_t i = b->first; s->p != NULL && i < b->first + b->count; ++i)
        if (!is_positive(vti_scalar(s, i)))
            return vti_blame(error, i, vti_scalar(s, i), quantity, fault);
    return VTI_OK;
}

/** n numbers of body i: all finite, and if one has to be there, not all zero. */
static int state_check(double *const *c, int n, int64_t at, int one, int64_t i, int64_t quantity, vti_fault *fault)
{
    int some = !one;
    double bad = 0.0;
    for (int k = 0; k < n; ++k) {
        bad = isfinite(c[k][at]) ? bad : c[k][at];
        some |= c[k][at] != 0.0;
    }
    return some && bad == 0.0 ? VTI_OK : vti_blame(VTI_E_STATE, i, bad, quantity, fault);
}

static int states_check(const vti_bodies *b, vti_fault *fault)
{
    static const int64_t quantity[] = {VTI_QUANTITY_X, VTI_QUANTITY_V, VTI_QUANTITY_ALPHA, VTI_QUANTITY_OMEGA};
    const vti_view *const views[] = {&b->x, &b->v, &b->alpha, &b->omega};
    int status = VTI_OK;
    for (int64_t i = b->first; i < b->first + b->count && status == VTI_OK; ++i) {
        for (int k = 0; k < 4 && status == VTI_OK; ++k)
            if (vti_has(views[k]))
                status = state_check(views[k]->c, 3, i * views[k]->stride, 0, i, quantity[k], fault);
        if (b->quat.xyzw[0] != NULL && status == VTI_OK)
            status = state_check(b->quat.xyzw, 4, i * b->quat.stride, 1, i, VTI_QUANTITY_QUAT, fault);
    }
    return status;
}

int vti_bodies_values_fault(const vti_bodies *b, vti_fault *fault)
{
    int status = vti_bodies_fault(b, fault);
    if (status == VTI_OK)
        status = values_check(&b->mass, b, VTI_E_MASS, VTI_QUANTITY_MASS, fault);
    if (status == VTI_OK)
        status = values_check(&b->inertia, b, VTI_E_INERTIA, VTI_QUANTITY_INERTIA, fault);
    return status == VTI_OK ? states_check(b, fault) : status;
}

int vti_bodies_check_values(const vti_bodies *b, vti_fault *fault)
{
    vti_blame_none(VTI_OK, fault);
    return vti_bodies_values_fault(b, fault);
}
