/* SPDX-License-Identifier: BSD-3-Clause
 * Advice in words, and as JSON. */
#ifndef VTI_ADVICE_TEXT_H
#define VTI_ADVICE_TEXT_H

#include <stdio.h>

#include "advise.h"

/** What to use, what the others would need, and how the step stands to stability and rotation. */
void advice_say(const struct scene *scene, const struct advice *advice, FILE *file);
/** One line each for what should give pause. */
void advice_warn(const struct scene *scene, const struct advice *advice, FILE *file);
/** One JSON object with the keys stepper, h, predicted_error, predicted_seconds, stable_h, h_max_omega, alternatives. */
void advice_json(const struct advice *advice, FILE *file);

#endif
