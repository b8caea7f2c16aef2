/* SPDX-License-Identifier: BSD-3-Clause
 * The files of a cost study, together. */
#ifndef VTI_COST_FILES_H
#define VTI_COST_FILES_H

#include "cost.h"
#include "overwrite.h"

enum { COST_FILES = 4 };

/** Names and marks of the files in folder. */
void cost_files_list(const char *folder, struct output files[COST_FILES]);

/** Writes cost.csv, errors.csv, prices.csv and machine.txt into folder: all under temporary names first, then all under their
 *  real ones, so that a failure leaves what was there before. Returns 0, or -1 with one line in *message. */
int cost_files_write(const struct cost *cost, const char *folder, struct message *message);

#endif
