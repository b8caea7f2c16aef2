/* SPDX-License-Identifier: BSD-3-Clause
 * What vti-advise says, in words and as JSON. */
#ifndef VTI_ADVISE_TEXT_H
#define VTI_ADVISE_TEXT_H

#include <stdio.h>

#include "advise.h"

/** What to use, what the others would need, and how the step stands to stability and rotation. */
void advise_text(const struct scene *scene, const struct advice *a, FILE *file);
/** One line each for what should give pause. */
void advise_warnings(const struct scene *scene, const struct advice *a, FILE *file);
/** One JSON object with the keys that --help names. */
void advise_json(const struct advice *a, FILE *file);

#endif
