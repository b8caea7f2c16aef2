/* SPDX-License-Identifier: BSD-3-Clause
 * Effects as data: what is in the array is computed, what is not does not exist. */
#include "vti_internal.h"

static void clear(const vti_view *view, int64_t begin, int64_t end)
{
    const double zero[3] = {0.0, 0.0, 0.0};
    for (int64_t i = begin; vti_has(view) && i < end; ++i)
        vti_store(view, i, zero);
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
    clear(&b->force, b->first, b->first + b->count);
    clear(&b->moment, b->first, b->first + b->count);
    for (int64_t k = 0; k < n; ++k)
        effects[k].apply(effects[k].self, b);
    return VTI_OK;
}
