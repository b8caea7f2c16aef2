/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Energies, momenta, and the norms of the errors. A measure has no status: of bodies that vti_bodies_check refuses, or
 * that cannot be compared, it is NaN. */
#ifndef VTI_MEASURE_H
#define VTI_MEASURE_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- measures (EQUATIONS 4) ----------------------------------------------------------------------------------- */

/** Sum of m|v|^2/2; 0 if nothing translates, or where there is no mass. */
VTI_API double vti_kinetic_translation(const vti_bodies *bodies);
/** Sum of J|Omega|^2/2, or L.Omega/2 of bodies with moments; 0 if nothing turns, where there is no inertia, or bodies
 *  with moments have no attitude. */
VTI_API double vti_kinetic_rotation(const vti_bodies *bodies);
/** Kinetic energies, which are 0 without mass or inertia, and all energies of the effects; NaN if vti_effects_check
 *  refuses them, or one has a force and no energy. */
VTI_API double vti_energy(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Sum of m v; 0 where there is no v or no mass. */
VTI_API void vti_momentum(const vti_bodies *bodies, double p[3]);
/** Sum of J Omega, or L; 0 where there is no omega, or neither inertia nor moments. */
VTI_API void vti_spin(const vti_bodies *bodies, double s[3]);
/** Sum of (x - about) x m v + J Omega, or L: without the first where x, v or mass is absent, without the others as
 *  vti_spin. */
VTI_API void vti_angular_momentum(const vti_bodies *bodies, const double about[3], double l[3]);
/** Largest h|Omega|: the rotation per step; of bodies with moments the largest of that and of all turns a drift is made
 *  of, h k_r|L|, h|d_x p_x|, h|d_y p_y| (EQUATIONS 7.2), 0 where they have no attitude. */
VTI_API double vti_max_turn(double h, const vti_bodies *bodies);
/** Integrand of ||q||^2_{H1}: sum over bodies of |x|^2 + |v|^2 + theta^2 + |Omega|^2, of the views that are present. */
VTI_API double vti_h1_density(const vti_bodies *bodies);
/** Integrand of ||q_h - q||^2_{H1}: the same of the differences, attitudes by |log(R_h R^T)|. Both slices must present
 *  the same views of these, an attitude in either form, and have equal counts; else it is NaN. */
VTI_API double vti_h1_distance(const vti_bodies *bodies, const vti_bodies *reference);
/** Largest attitude distance |log(R_h R^T)| over the slice, radians; 0 if neither has an attitude, NaN if one has, or
 *  their counts differ. */
VTI_API double vti_attitude_distance(const vti_bodies *bodies, const vti_bodies *reference);

#ifdef __cplusplus
}
#endif

#endif
