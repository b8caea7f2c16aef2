/* SPDX-License-Identifier: BSD-3-Clause
 * What tells one study from another: what its scenes mean, whatever their text; steppers, steps and ends. */
#ifndef VTI_STUDY_IDENTITY_H
#define VTI_STUDY_IDENTITY_H

#include "cost.h"
#include "survey.h"
#include "task_journal.h"

/** Of a convergence study; its results are outcomes. */
struct task_identity study_identity(const struct plan *plan);
/** Of a cost study; its results are ladders of errors. How often times are taken is no part of it. */
struct task_identity survey_identity(const struct survey_plan *plan);
struct task_identity cost_identity(const struct cost_plan *plan);

#endif
