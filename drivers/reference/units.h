/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef VTI_UNITS_H
#define VTI_UNITS_H

#include "model.h"

/** What numbers of a state are compared with where they are small, [width]: 1 in scenes of lengths, speeds and spins
 *  from 1/64 to 64, else a power of 2 near those that the scene has, or takes up over such a length. state is the one
 *  at t = 0 (equations.h), rate its rates. */
void units_of(const struct model *model, int64_t width, const double *state, const double *rate, double *unit);

#endif
