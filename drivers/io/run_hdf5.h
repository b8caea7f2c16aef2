/* SPDX-License-Identifier: BSD-3-Clause
 *
 * out.h5 of a run. Root attributes: scene, stepper, vti_version, h, complete (0 if the run broke off), and
 * contact.bonded (1 if bonded bodies touch too) if the scene has contact. /VTKHDF: the trajectory (vtkhdf.h).
 * /energies: a dataset per column of out.csv, and their order in its attribute "columns". /walls: planes n.x = d as
 * rows nx, ny, nz, d, if the scene has any. /restart: what a complete run goes on from (run_restart.h), as the bytes of its
 * last checkpoint. The bytes of the file depend on the scene, the options and the results only. */
#ifndef VTI_RUN_HDF5_H
#define VTI_RUN_HDF5_H

#include "record.h"

/** Writes the file at path. Returns 0, or -1 with one line in *message. */
int run_hdf5_write(const struct record *record, const char *path, struct message *message);

#endif
