/* SPDX-License-Identifier: BSD-3-Clause
 * The text files of a run. */
#ifndef VTI_RUN_TEXT_H
#define VTI_RUN_TEXT_H

#include <stdio.h>

#include "record.h"

/* Each writes to the file, whose own errors the caller finds in ferror. Returns 0, or -1 with one line in *message. */

/** out.csv: a row per recorded time, 17 digits. */
int run_csv_write(const struct record *record, FILE *file, struct message *message);

/** out.dump: a LAMMPS text dump, as OVITO reads it. Columns id (from 1) type x y z, then vx vy vz if bodies
 *  translate, omegax omegay omegaz quati quatj quatk quatw if they turn, and radius if they have one. The box holds
 *  all of them at all times. */
int run_dump_write(const struct record *record, FILE *file, struct message *message);

/** out.xdmf: an index of the trajectory in the HDF5 file called name, in the same folder, for readers that do not
 *  know VTKHDF; and the walls, each as a square behind all bodies of all frames. */
int run_xdmf_write(const struct record *record, const char *name, FILE *file, struct message *message);

#endif
