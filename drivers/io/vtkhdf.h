/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The trajectory as /VTKHDF, PolyData over time by the VTKHDF format (2.0, ParaView 5.12 and later): points are the
 * bodies' centres, vertices the bodies, lines the bonds. Point data: velocity, omega, alpha, attitude_xyzw, attitude_wxyz, director, of what
 * the scene has; force and moment, if they are asked for; diameter, if it has one; body, the index. Cell data, if there are bonds: bond_energy, the sum over the bond's terms,
 * and bond_stretch, r/L0 - 1, first of the bodies' vertices, where both are 0, then of the bonds' lines; bond, the index, -1 of a
 * vertex. Bodies, bonds, diameters and indices are written once, all else once per frame, frame after frame. */
#ifndef VTI_VTKHDF_H
#define VTI_VTKHDF_H

#include "hdf5_sink.h"
#include "record.h"

/** Returns 0, or -1, with a line in *message if it was not the file that failed. */
int vtkhdf_write(const struct record *record, struct hdf5_sink *file, struct message *message);

#endif
