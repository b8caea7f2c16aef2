/* SPDX-License-Identifier: BSD-3-Clause
 * The files of a study and of a cost study. */
#ifndef VTI_STUDY_FILES_H
#define VTI_STUDY_FILES_H

#include <stdio.h>

#include "cost.h"
#include "folder.h"
#include "overwrite.h"
#include "study.h"
#include "survey.h"

/* ---- a study ---------------------------------------------------------------------------------------------------- */

enum { STUDY_FILES = 3 };

extern const struct output study_outputs[STUDY_FILES];

/** Writes study.h5, study.csv and timing.csv into folder: all under temporary names first, then all under their real
 *  ones, so that a failure leaves what was there before. Returns 0, or -1 with one line in *message. */
int study_files_write(const struct study *study, const char *folder, struct message *message);

/** study.h5. Root attributes: scene, t_end, energy0, norm_squared (||q||^2_H1 of the exact solution), the two errors
 *  of the reference, vti_version. /runs: a dataset per column of study.csv. /orders: a dataset per column, a row per
 *  stepper and measure. /series/NNNNNN: for run NNNNNN, if it did not fail, t, energy_error (E_h - E_0) and every
 *  invariant less its initial value. The bytes depend on the results only. Writes the file at path. Returns 0, or -1
 *  with one line in *message. */
int study_hdf5_write(const struct study *study, const char *path, struct message *message);
/** study.csv of a struct study: one row per run in task order, 17 digits; nothing in it depends on clocks or ranks. */
folder_writer study_csv_write;
/** timing.csv of a struct study: seconds of every run with its measurements, and the rank that did it. */
folder_writer study_csv_timing_write;

/** Of both the first line and a row of one run, for files with more columns behind; error: as outcome_errors names
 *  them. */
void study_csv_header(FILE *file);
void study_csv_row(const char *scene, const struct trial *trial, int64_t force_evals, const double error[],
                   const struct judgement *judgement, FILE *file);
/** ",text", in quotes where commas or quotes are in it. */
void study_csv_text(const char *text, FILE *file);
void study_csv_timing_header(FILE *file);
void study_csv_timing_row(const char *scene, const struct trial *trial, double seconds, int rank, FILE *file);

/* ---- a cost study ----------------------------------------------------------------------------------------------- */

enum { COST_FILES = 4 };

extern const struct output cost_outputs[COST_FILES];

/** Writes cost.csv, errors.csv, prices.csv and machine.txt into folder: all under temporary names first, then all
 *  under their real ones, so that a failure leaves what was there before. Rows are ordered by case, method and
 *  falling h; runs that failed have none. Returns 0, or -1 with one line in *message. */
int cost_files_write(const struct cost *cost, const char *folder, struct message *message);

/* ---- a survey ---------------------------------------------------------------------------------------------------- */

/* The files of a survey, together: study.csv and timing.csv with the swept values as further columns, study.h5 with a
 * table for runs, points, orders, means and spreads. */

/** What is counted while they are written. */
struct survey_counts {
    int64_t verdict[3], failed; /* runs */
    int64_t parted;             /* points at which trajectories part from the reference */
};

/** Writes study.h5, study.csv and timing.csv into folder, as study_files_write does. Returns likewise. */
int survey_files_write(const struct survey *survey, const char *folder, struct survey_counts *counts,
                       struct message *message);

/** study.h5 alone. failed: runs. */
int survey_hdf5_write(const struct survey *survey, const char *path, int64_t failed, struct message *message);

#endif
