/* SPDX-License-Identifier: BSD-3-Clause
 * The files of a study, together. */
#ifndef VTI_STUDY_FILES_H
#define VTI_STUDY_FILES_H

#include "overwrite.h"
#include "study.h"

enum { STUDY_FILES = 3 };

/** Names and marks of the files in folder. */
void study_files_list(const char *folder, struct output files[STUDY_FILES]);

/** Writes study.h5, study.csv and timing.csv into folder: all under temporary names first, then all under their real ones, so that
 *  a failure leaves what was there before. Returns 0, or -1 with one line in *message. */
int study_files_write(const struct study *study, const char *folder, struct message *message);

#endif
