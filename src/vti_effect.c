/* SPDX-License-Identifier: BSD-3-Clause
 * Effects as data: what is in the array is computed, what is not does not exist. */
#include <string.h>

#include "vti_internal.h"

static void clear(const vti_view *view, int64_t begin, int64_t end)
{
    double *const *c = view->c;
    if (vti_is_packed(view)) {
        /* in small parts, for which no C library falls back to storing bytes */
        for (int64_t first = begin; first < end; first += VTI_LANES)
            memset(c[0] + 3 * first, 0,
                   (size_t)(end - first < VTI_LANES ? end - first : VTI_LANES) * 3 * sizeof(double));
        return;
    }
    for (int64_t i = begin; i < end; ++i)
        for (int k = 0; k < 3; ++k)
            c[k][i * view->stride] = 0.0;
}

static inline void clear_few(const vti_view *view, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        view->c[0][i * view->stride] = 0.0;
        view->c[1][i * view->stride] = 0.0;
        view->c[2][i * view->stride] = 0.0;
    }
}

/** force = moment = 0 */
static inline void clear_loads(const vti_bodies *b)
{
    const int64_t begin = b->first, end = begin + b->count;
    if (vti_has(&b->force))
        (b->count <= VTI_FEW ? clear_few : clear)(&b->force, begin, end);
    if (vti_has(&b->moment))
        (b->count <= VTI_FEW ? clear_few : clear)(&b->moment, begin, end);
}

int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (n < 0)
        return VTI_E_COUNT;
    if (n > 0 && effects == NULL)
        return VTI_E_NULL;
    for (int64_t k = 0; k < n; ++k) {
        const int refused = effects[k].apply == NULL ? VTI_E_NULL : vti_effect_check(&effects[k], b);
        if (refused != VTI_OK)
            return refused;
    }
    clear_loads(b);
    for (int64_t k = 0; k < n; ++k)
        effects[k].apply(effects[k].self, b);
    return VTI_OK;
}

int vti_step_check(const vti_stepper *method, const vti_effect *effects, int64_t n)
{
    if (method == NULL || method->kick == NULL || method->drift == NULL)
        return VTI_E_STEPPER;
    if (effects == NULL && n > 0)
        return VTI_E_NULL;
    if (n < 0)
        return VTI_E_COUNT;
    if (method->stages < 1)
        return VTI_E_STAGE;
    int backwards = 0, dissipates = 0;
    for (int64_t k = 0; k <= method->stages; ++k)
        backwards |= method->kick[k] < 0.0 || method->drift[k] < 0.0;
    for (int64_t e = 0; e < n; ++e)
        dissipates |= effects[e].dissipates != 0;
    return backwards && dissipates ? VTI_E_DISSIPATES : VTI_OK;
}
