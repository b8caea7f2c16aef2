/* SPDX-License-Identifier: BSD-3-Clause
 * What vti-run says before and after a run. */
#ifndef VTI_RUN_TEXT_H
#define VTI_RUN_TEXT_H

#include <stdio.h>

struct run; /* run.h */

/** What will be computed, from where, and h against the bound of the stable step. */
void run_text_start(struct run *run, FILE *file);
/** That the run was complete before. */
void run_text_done(const struct run *run, FILE *file);
/** Energy drift, time and files. */
void run_text_end(const struct run *run, FILE *file);

#endif
