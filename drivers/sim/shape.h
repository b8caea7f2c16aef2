/* SPDX-License-Identifier: BSD-3-Clause
 * What of a model can be drawn: centres, diameters, bonds. */
#ifndef VTI_SHAPE_H
#define VTI_SHAPE_H

#include "model.h"

/** Centre of body i of the bodies. Where nothing translates: the end of the pendulum's arm, or the origin. */
void shape_centre(const struct model *model, const vti_bodies *bodies, int64_t i, double x[3]);

int shape_has_diameters(const struct model *model);
/** Of body i; 0 without diameters. */
double shape_diameter(const struct model *model, int64_t i);

int64_t shape_bonds(const struct model *model);
/** The bodies, from 0, of bond k. */
void shape_bond(const struct model *model, int64_t k, int64_t pair[2]);

#endif
