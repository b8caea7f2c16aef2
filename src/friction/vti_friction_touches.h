/* SPDX-License-Identifier: BSD-3-Clause
 * Where springs of friction are looked up: what pairs hold, bodies near a wall. */
#ifndef VTI_FRICTION_TOUCHES_H
#define VTI_FRICTION_TOUCHES_H

#include "../contacts/vti_face.h"
#include "../contacts/vti_history.h"
#include "../contacts/vti_touch_table.h"

/** The effect's carry. */
void vti_friction_carry(const void *self, const vti_bodies *b, const vti_drifted *drifted);

/** What pair k holds, or NULL, where next is as vti_history_next has it. */
static inline vti_held *vti_friction_held(const vti_friction *p, int64_t k, int64_t *next)
{
    return vti_history_next(p->history, 1 + vti_contact_body(p->contacts, k, 0),
                            1 + vti_contact_body(p->contacts, k, 1), 1, next);
}

/** Of the bodies from the first on, as many as a kernel takes, those at wall w, as vti_touch_kernels.near_wall has
 *  them. */
static inline uint64_t vti_friction_near_wall(const vti_friction *p, const vti_bodies *b, int64_t w, int64_t first)
{
    const int64_t left = b->first + b->count - first, count = left < VTI_TOUCHES ? left : VTI_TOUCHES;
    return vti_touch_kernels_for(count)->near_wall(p->walls, b, 0.0, 0.0, w, first, count);
}

#endif
