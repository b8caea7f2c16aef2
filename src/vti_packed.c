/* SPDX-License-Identifier: BSD-3-Clause
 * The same calls on plain x[n][3] arrays, without structs. */
#include <stddef.h>

#include "vti.h"

static vti_view packed(const double *p)
{
    /* force and moment are only read; views have one type for all */
    return p != NULL ? vti_view_packed((double *)p) : vti_view_none();
}

static int scalars(int64_t values, const double *p, int64_t n, vti_scalars *s)
{
    s->p = p;
    s->stride = values == 1 ? 0 : 1;
    return p == NULL || values == 1 || values == n ? VTI_OK : VTI_E_COUNT;
}

/** Omega and one inertia for all or one for each; or L and three moments for each. */
static int spins(int64_t inertias, const double *inertia, int64_t n, double *omega, vti_bodies *b)
{
    if (n > 0 && inertias % 3 == 0 && inertias / 3 == n) {
        b->moments = packed(inertia);
        b->spin = packed(omega);
        return VTI_OK;
    }
    b->omega = packed(omega);
    return scalars(inertias, inertia, n, &b->inertia);
}

/** The stepper, or NULL if there is none or it needs more of a step than begin, forces, finish. */
static const vti_stepper *of_one_stage(int64_t stepper)
{
    const vti_stepper *s = vti_stepper_at(stepper);
    return s != NULL && s->stages == 1 ? s : NULL;
}

int vti_packed_begin(int64_t stepper, double h, int64_t n, double *x, double *v, const double *force, double *alpha,
                     double *omega, const double *moment, int64_t masses, const double *mass, int64_t inertias,
                     const double *inertia, int64_t *body, double *value)
{
    vti_fault fault = {-1, h, VTI_QUANTITY_NONE};
    vti_bodies b = vti_bodies_none(n);
    b.x = packed(x);
    b.v = packed(v);
    b.force = packed(force);
    b.alpha = packed(alpha);
    b.moment = packed(moment);
    const vti_stepper *method = of_one_stage(stepper);
    int status = method == NULL ? VTI_E_STEPPER : n < 0 ? VTI_E_COUNT : VTI_OK;
    if (status == VTI_OK)
        status = scalars(masses, mass, n, &b.mass);
    if (status == VTI_OK)
        status = spins(inertias, inertia, n, omega, &b);
    if (status == VTI_OK)
        status = vti_step_begin(method, h, &b, &fault);
    if (body != NULL)
        *body = fault.body;
    if (value != NULL)
        *value = fault.value;
    return status;
}

int vti_packed_finish(int64_t stepper, double h, int64_t n, double *v, const double *force, double *omega,
                      const double *moment, int64_t masses, const double *mass, int64_t inertias, const double *inertia)
{
    vti_bodies b = vti_bodies_none(n);
    b.v = packed(v);
    b.force = packed(force);
    b.moment = packed(moment);
    const vti_stepper *method = of_one_stage(stepper);
    if (method == NULL)
        return VTI_E_STEPPER;
    int status = scalars(masses, mass, n, &b.mass);
    if (status == VTI_OK)
        status = spins(inertias, inertia, n, omega, &b);
    return status == VTI_OK ? vti_step_finish(method, h, &b) : status;
}
