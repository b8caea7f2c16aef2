/* SPDX-License-Identifier: BSD-3-Clause
 * What a plan comes to (study_plan.c), as its runs (study.c) need it. */
#ifndef VTI_STUDY_PARTS_H
#define VTI_STUDY_PARTS_H

#include "study.h"

/** All that comes before the reference; outcomes have room on rank 0. Returns 0, or -1 with one line in *message;
 *  study_destroy is due after either. */
int study_prepare(const struct plan *plan, int rank, struct study *study, struct message *message);
/** With a look at the steppers: what one of them refuses is no failed run then, but refuses the study. */
int study_prepare_checked(const struct plan *plan, int rank, struct study *study, struct message *message);

/** How far the reference must reach. */
struct reference_span study_span(const struct study *study);

#endif
