/* SPDX-License-Identifier: BSD-3-Clause
 * study.csv and timing.csv, and the table on the screen. */
#ifndef VTI_STUDY_CSV_H
#define VTI_STUDY_CSV_H

#include <stdio.h>

#include "study.h"

/** One row per run in task order, 17 digits; nothing in it depends on clocks or ranks. */
void study_csv_write(const struct study *study, FILE *file);
/** Seconds of every run with its measurements, and the rank that did it. */
void timing_csv_write(const struct study *study, FILE *file);
/** The same for people: errors of every run, then the fitted orders. */
void study_table_write(const struct study *study, FILE *file);

#endif
