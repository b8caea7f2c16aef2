/* SPDX-License-Identifier: BSD-3-Clause
 *
 * study.h5. Root attributes: scene, t_end, energy0, norm_squared (||q||^2_H1 of the exact solution), the two errors of the
 * reference, vti_version. /runs: a dataset per column of study.csv. /orders: a dataset per column, a row per stepper and
 * measure. /series/NNNNNN: for run NNNNNN t, energy_error (E_h - E_0) and every invariant less its initial value. The bytes
 * depend on the results only. */
#ifndef VTI_STUDY_HDF5_H
#define VTI_STUDY_HDF5_H

#include "study.h"

/** Writes the file at path. Returns 0, or -1 with one line in *message. */
int study_hdf5_write(const struct study *study, const char *path, struct message *message);

#endif
