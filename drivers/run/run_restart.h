/* SPDX-License-Identifier: BSD-3-Clause
 * A complete run goes on from its HDF5 file: /restart there holds its identity and the checkpoint at its end, byte for
 * byte, and rows and frames are those of /energies and /VTKHDF. */
#ifndef VTI_RUN_RESTART_H
#define VTI_RUN_RESTART_H

#include "record.h"

struct run_restart {
    char *identity;       /* text (identity.h) */
    unsigned char *bytes; /* of the checkpoint */
    size_t size;
};

/** What the file of the run says of its end; run_restart_free is due. Returns 1, 0 if there is no such file, or -1 with
 *  one line in *message: the file holds no run that can go on. */
int run_restart_find(const char *path, struct run_restart *restart, struct message *message);
void run_restart_free(struct run_restart *restart);

/** Adds the records that *checkpoint counts to the open, empty journal of *record. Returns 0, or -1 with one line in
 *  *message: they are not those of the checkpoint. */
int run_restart_fill(const char *path, const struct record *record, const struct checkpoint *checkpoint,
                     struct message *message);

#endif
