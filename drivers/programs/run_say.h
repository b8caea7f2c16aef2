/* SPDX-License-Identifier: BSD-3-Clause
 * What a run tells people. */
#ifndef VTI_RUN_SAY_H
#define VTI_RUN_SAY_H

#include "run.h"

/** What will be computed, from where, and h against the bound of the stable step. */
void run_say_start(const struct run *run, FILE *file);
/** That the run was complete before. */
void run_say_done(const struct run *run, FILE *file);
/** Energy drift, time and files. */
void run_say_end(const struct run *run, FILE *file);

#endif
