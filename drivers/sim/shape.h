/* SPDX-License-Identifier: BSD-3-Clause
 * What of a model can be drawn: centres, diameters, lines between bodies. */
#ifndef VTI_SHAPE_H
#define VTI_SHAPE_H

#include "model.h"

/** Centre of body i of the bodies. Where nothing translates: where an effect has it, or the origin. */
void shape_centre(const struct model *model, const vti_bodies *bodies, int64_t i, double x[3]);

/** Whether bodies are spheres of known size; clumps are not. */
int shape_has_diameters(const struct model *model);
/** Of body i; 0 without diameters. */
double shape_diameter(const struct model *model, int64_t i);

/** Whether bodies can be drawn as ellipsoids: they have masses and three moments, and no surface that says otherwise;
 *  those of clumps do not. */
int shape_has_axes(const struct model *model);
/** The whole axes of the solid ellipsoid of that mass and these moments, along the principal axes of body i:
 *  5 (B + C - A) = m a^2/2, and so on. */
void shape_axes(const struct model *model, int64_t i, double axes[3]);

/** The lines of one effect: count of them from line first of all. */
struct shape_group {
    const struct effect *effect; /* its kind has lines */
    int64_t first, count;
};
/** Those that have any, in the model's order. Returns how many. */
int shape_groups(const struct model *model, struct shape_group list[MODEL_EFFECTS]);
/** Lines of all effects; while a model is being made, of those before. */
int64_t shape_lines(const struct model *model);
/** Numbers of each line of the effect in files, of those that it may have. */
int shape_quantities(const struct effect *effect);
/** What line k of all joins, from 0: bodies, or spheres of clumps where its effect acts on these. */
void shape_ends(const struct model *model, int64_t k, int64_t pair[2]);
/** The bodies, from 0, of line k of all. */
void shape_line(const struct model *model, int64_t k, int64_t pair[2]);
/** Whether it acts on the spheres of clumps; whether all lines do, if there are any. */
int shape_on_spheres(const struct model *model, const struct effect *effect);
int shape_lines_join_spheres(const struct model *model);

/** The effect whose lines may break in this scene; NULL if there is none. */
const struct effect *shape_breaking(const struct model *model);

#endif
