/* SPDX-License-Identifier: BSD-3-Clause
 * The bounds on the step, in words. */
#ifndef VTI_STABLE_TEXT_H
#define VTI_STABLE_TEXT_H

#include <stdio.h>

#include "model.h"

/** A line for the bound at rest and one for that of what energies of single bodies allow, if it is another; h beside
 *  them, if it is > 0. */
void stable_say(const struct model_limits *limits, const vti_stepper *stepper, double h, FILE *file);
/** The smaller bound for a stepper, whose reach may be other than 2. */
double stable_least(const struct model_limits *limits, const vti_stepper *stepper);

#endif
