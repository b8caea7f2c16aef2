/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef VTI_TOUCHES_H
#define VTI_TOUCHES_H

#include "kind.h"

/** Takes off the forces of the bodies, packed, what acts where surfaces touch now that did not at start, [n][3];
 *  scratch is as large. */
void touches_take_new(const struct effect_surfaces *surfaces, const double *start, const vti_bodies *bodies,
                      double *scratch);

#endif
