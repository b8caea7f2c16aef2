/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The torus impact once more, in quadruple precision and with rotation matrices: VTI-2 with h = 1e-3. */
#ifndef VTI_TESTS_TORUS_QUAD_H
#define VTI_TESTS_TORUS_QUAD_H

/** Kinetic of translation and of rotation, moment, axial, shear, contact, wall, total. */
enum { TORUS_ENERGIES = 8 };

/** energies[k][] after at[k] steps, k < records, at[] increasing; shear as printed, or else objective. */
void torus_quad(int printed, int records, const int *at, double (*energies)[TORUS_ENERGIES]);

#endif
