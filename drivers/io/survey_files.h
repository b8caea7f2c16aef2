/* SPDX-License-Identifier: BSD-3-Clause
 * The files of a survey, together: study.csv and timing.csv with the swept values as further
 * columns, study.h5 with a table for runs, points, orders, means and spreads. */
#ifndef VTI_SURVEY_FILES_H
#define VTI_SURVEY_FILES_H

#include "study_files.h"
#include "survey.h"

/** What is counted while they are written. */
struct survey_counts {
    int64_t verdict[3], failed; /* runs */
};

/** Writes study.h5, study.csv and timing.csv into folder, as study_files_write does. Returns likewise. */
int survey_files_write(const struct survey *survey, const char *folder, struct survey_counts *counts,
                       struct message *message);

/** study.h5 alone. failed: runs. */
int survey_hdf5_write(const struct survey *survey, const char *path, int64_t failed, struct message *message);

#endif
