/* SPDX-License-Identifier: BSD-3-Clause
 * Single touches: what one does, and those that are new. */
#ifndef VTI_TOUCHES_H
#define VTI_TOUCHES_H

#include "kind.h"

/** Adds the elastic loads of pair k of the list to its bodies. */
void touches_add_pair(const vti_contacts *p, int64_t k, const vti_bodies *b);
/** Adds that of wall w, where it is now, on body i. */
void touches_add_wall(const vti_walls *p, int64_t w, int64_t i, const vti_bodies *b);

/** Takes off the forces of the bodies, packed, what acts where surfaces touch now that did not at start, [n][3];
 *  scratch is as large. */
void touches_take_new(const struct effect_surfaces *surfaces, const double *start, const vti_bodies *bodies,
                      double *scratch);

#endif
