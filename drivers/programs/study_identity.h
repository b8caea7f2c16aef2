/* SPDX-License-Identifier: BSD-3-Clause
 * What a study is: what its scenes mean, and what it does with them. It goes on with --resume only as the same. */
#ifndef VTI_STUDY_IDENTITY_H
#define VTI_STUDY_IDENTITY_H

#include <stdio.h>

/** Write the lines "key: value" (identity.h) of a struct plan, survey_plan or cost_plan. */
void study_identify(FILE *text, const void *plan);
void survey_identify(FILE *text, const void *plan);
void cost_identify(FILE *text, const void *plan);

#endif
