/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Clumps (EQUATIONS 7.5): the spheres of bodies are bodies of their own to effects. */
#ifndef VTI_CLUMP_SPHERES_H
#define VTI_CLUMP_SPHERES_H

#include "../vti_views.h"

/** Whether there is a list, and spheres for it; of the whole list vti_clumps_check. */
int vti_clump_list_check(const vti_clumps *c);

/** Whether spheres and bodies may be used together. */
int vti_clump_ready(const vti_clumps *c, const vti_bodies *b);

/** The spheres from <= s < to, where their bodies have them, as vti_clumps_spread says. */
void vti_clump_spread(const vti_clumps *c, const vti_bodies *b, int64_t from, int64_t to);

/** F += F_s, RM += RM_s + r x F_s of the same. */
void vti_clump_gather(const vti_clumps *c, const vti_bodies *b, int64_t from, int64_t to);

/** What the view has of body i, 0 where it is absent. */
static inline void vti_load_or_zero(const vti_view *view, int64_t i, double a[3])
{
    a[0] = a[1] = a[2] = 0.0;
    if (vti_has(view))
        vti_load(view, i, a);
}

#endif
