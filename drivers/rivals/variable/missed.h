/* SPDX-License-Identifier: BSD-3-Clause
 * Touches that a step may have passed by. */
#ifndef VTI_RIVALS_MISSED_H
#define VTI_RIVALS_MISSED_H

#include "model.h"

/** The largest change of a relative velocity by a touch of two spheres that fits between two evaluations of the forces of
 *  a step of h, gap being the largest part of it without any: of those that are apart at both ends of the step, at
 *  before[count of bodies][width], whose rows begin with a place, and where they are now, and overlap on the straight way
 *  between. 0 if there are none; of clumps none are looked for. */
double missed_touch(const struct model *model, const double *before, int64_t width, const vti_bodies *now, double h,
                    double gap);

#endif
