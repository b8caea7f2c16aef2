/* SPDX-License-Identifier: BSD-3-Clause
 * What a stateless library can see of wrong use before it touches a body. */
#include "vti_internal.h"

enum { VECTORS = 10 };

static int view_check(double *const *c, int components, int64_t stride, int64_t end)
{
    for (int k = 1; k < components; ++k)
        if ((c[k] == NULL) != (c[0] == NULL))
            return VTI_E_VIEW;
    if (c[0] == NULL)
        return VTI_OK;
    for (int k = 1; k < components; ++k)
        if (c[k] == c[k - 1] || c[k] == c[0])
            return VTI_E_ALIAS;
    return stride == 0 && end > 1 ? VTI_E_STRIDE : VTI_OK;
}

static int is_positive(double value)
{
    return isfinite(value) && value > 0.0;
}

/** A kick needs what it divides by; one value for all is looked at here, arrays in vti_bodies_check_values. */
static int scalars_check(const vti_scalars *s, int needed, int64_t count, int error)
{
    if (s->p == NULL)
        return needed ? error : VTI_OK;
    return s->stride == 0 && count > 0 && !is_positive(*s->p) ? error : VTI_OK;
}

int vti_bodies_check(const vti_bodies *b)
{
    if (b == NULL)
        return VTI_E_NULL;
    if (b->abi != VTI_ABI)
        return VTI_E_ABI;
    if (b->first < 0 || b->count < 0 || b->first > INT64_MAX - b->count)
        return VTI_E_COUNT;

    const vti_view *const views[VECTORS] = {&b->x,      &b->v,     &b->force, &b->alpha,     &b->omega,
                                            &b->moment, &b->x_low, &b->v_low, &b->alpha_low, &b->omega_low};
    const int64_t end = b->first + b->count;
    for (int i = 0; i < VECTORS; ++i) {
        const int status = view_check(views[i]->c, 3, views[i]->stride, end);
        if (status != VTI_OK)
            return status;
        for (int j = 0; j < i; ++j)
            if (vti_has(views[i]) && views[i]->c[0] == views[j]->c[0])
                return VTI_E_ALIAS;
    }
    const int status = view_check(b->quat.xyzw, 4, b->quat.stride, end);
    if (status != VTI_OK)
        return status;
    if (b->quat.xyzw[0] != NULL && (vti_has(&b->alpha) || vti_has(&b->alpha_low)))
        return VTI_E_VIEW;

    const int mass = scalars_check(&b->mass, vti_has(&b->v) && vti_has(&b->force), b->count, VTI_E_MASS);
    if (mass != VTI_OK)
        return mass;
    return scalars_check(&b->inertia, vti_has(&b->omega) && vti_has(&b->moment), b->count, VTI_E_INERTIA);
}

static int values_check(const vti_scalars *s, const vti_bodies *b, int error, vti_fault *fault)
{
    for (int64_t i = b->first; s->p != NULL && i < b->first + b->count; ++i)
        if (!is_positive(vti_scalar(s, i))) {
            if (fault != NULL) {
                fault->body = i;
                fault->value = vti_scalar(s, i);
            }
            return error;
        }
    return VTI_OK;
}

int vti_bodies_check_values(const vti_bodies *b, vti_fault *fault)
{
    int status = vti_bodies_check(b);
    if (fault != NULL) {
        fault->body = -1;
        fault->value = 0.0;
    }
    if (status == VTI_OK)
        status = values_check(&b->mass, b, VTI_E_MASS, fault);
    if (status == VTI_OK)
        status = values_check(&b->inertia, b, VTI_E_INERTIA, fault);
    return status;
}
