/* SPDX-License-Identifier: BSD-3-Clause
 * The formats of a run's files. */
#ifndef VTI_RUN_FORMATS_H
#define VTI_RUN_FORMATS_H

#include <stdio.h>

#include "hdf5_sink.h"
#include "record.h"

/* Each returns 0, or -1 with one line in *message; errors of a FILE the caller finds in ferror. */

/** out.h5 of a run. Root attributes: scene, stepper, vti_version, h, complete (0 if the run broke off), and
 *  what the scene says yes or no to for its effects, such as contact.bonded. /VTKHDF: the trajectory (below).
 *  /energies: a dataset per column of out.csv, and their order in its attribute "columns". /walls: planes n.x = d as
 *  rows nx, ny, nz, d, of the effect that has any, and beside it /wall_cylinders, /wall_velocities, /wall_spins if it
 *  has cylinders, if its walls move. /clumps: of each sphere of bodies that are clumps its body, its offset in it, its
 *  diameter. /restart: what a complete run goes on from (run/run.h), as the bytes of its last checkpoint. The bytes of
 *  the file depend on the scene, the options and the results only. */
int run_hdf5_write(const struct record *record, const char *path, struct message *message);

/** The trajectory as /VTKHDF, PolyData over time by the VTKHDF format (2.0, ParaView 5.12 and later): points are the
 *  bodies' centres, vertices the bodies, lines those of effects. Point data: velocity, omega, alpha, attitude_xyzw,
 *  attitude_wxyz, director, ellipsoid, of what the scene has; with --fields force, moment, and the energy that each
 *  body has lost, in all (lost) and by the columns of out.csv; diameter, if it has one; body, the index. Cell data, if
 *  there are lines: what effects say of theirs (effects/kind.h, struct effect_lines), first of the bodies' vertices,
 *  where all are 0, then of the lines; the index of each, -1 of all other cells. Bodies, lines, diameters and indices
 *  are written once, all else once per frame, frame after frame. Leaves *message alone if it was the file that
 *  failed. */
int vtkhdf_write(const struct record *record, struct hdf5_sink *file, struct message *message);

/** out-spheres.h5: the spheres of clumps as points of a /VTKHDF of their own, as ParaView opens one PolyData a file.
 *  Point data: velocity; diameter and body, which are written once. Root attributes: spheres_of (the scene),
 *  vti_version. */
int spheres_hdf5_write(const struct record *record, const char *path, struct message *message);

/** out-contacts.h5: what touches as lines of a /VTKHDF of its own, whose number is another one in each frame. Cell
 *  data: i, j, of clumps sphere_i, sphere_j, force, normal_force, tangential_force, overlap. Root attributes:
 *  contacts_of (the scene), vti_version. */
int contacts_hdf5_write(const struct record *record, const char *path, struct message *message);

/** out.csv: a row per recorded time, 17 digits. */
int run_csv_write(const struct record *record, FILE *file, struct message *message);

/** out.dump: a LAMMPS text dump, as OVITO reads it. Columns id (from 1) type x y z, then vx vy vz if bodies
 *  translate, omegax omegay omegaz quati quatj quatk quatw if they turn, and radius if they have one; or shapex shapey
 *  shapez, the whole axes of ellipsoids, whose quaternion then is that of the principal axes. Of clumps a row for each
 *  sphere, and behind its type mol, its body from 1. The box holds all of them at all times. */
int run_dump_write(const struct record *record, FILE *file, struct message *message);

/** out.xdmf: an index of the trajectory in the HDF5 file called name, in the same folder, for readers that do not
 *  know VTKHDF; of the spheres of clumps, if there are any, in the one called spheres; and the planes of effects, each
 *  as a square as wide as the diagonal of the box of all frames, which moves with its plane. Cylinders are not in
 *  it. */
int run_xdmf_write(const struct record *record, const char *name, const char *spheres, FILE *file,
                   struct message *message);

/* About how many bytes they take, of runs long enough that it matters. */
double run_hdf5_bytes(const struct record *record, int64_t rows, int64_t frames);
double vtkhdf_bytes(const struct record *record, int64_t frames);
double spheres_hdf5_bytes(const struct record *record, int64_t frames);
double contacts_hdf5_bytes(double frames, double touches);
double run_csv_bytes(const struct record *record, int64_t rows);
double run_xdmf_bytes(const struct record *record, int64_t frames);
double run_dump_bytes(const struct record *record, int64_t frames);

#endif
