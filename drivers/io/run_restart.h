/* SPDX-License-Identifier: BSD-3-Clause
 * A complete run goes on from its HDF5 file: /restart there is the checkpoint at its end, byte for byte, and rows and frames are
 * those of /energies and /VTKHDF. */
#ifndef VTI_RUN_RESTART_H
#define VTI_RUN_RESTART_H

#include "checkpoint.h"
#include "record.h"

/** The bytes of the checkpoint in the file of the run, from malloc. Returns 1, 0 if there is no such file, or -1 with one line
 *  in *message: the file holds no run that can go on. */
int run_restart_find(const char *path, unsigned char **bytes, size_t *size, struct message *message);

/** Adds the records that *checkpoint counts to the open, empty journal of *record. Returns 0, or -1 with one line in *message:
 *  they are not those of the checkpoint. */
int run_restart_fill(const char *path, const struct record *record, const struct checkpoint *checkpoint,
                     struct message *message);

#endif
