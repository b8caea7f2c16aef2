/* SPDX-License-Identifier: BSD-3-Clause
 * The reference of a model that dissipates: states at multiples of an interval by the library's own chin4, since what
 * flows, slides or breaks is no differential equation of forces that GSL could take. Its steps are a fourth of the
 * finest that will be compared with it; how well it is known shows in runs of twice and four times as long steps. */
#ifndef VTI_STEPPED_H
#define VTI_STEPPED_H

#include "sampled.h"

/** Fills the states of *sampled (sampled_create), energy_error with booked energies included, and spread. finest is the
 *  shortest step of those who compare. Returns 0, or -1 with one line in *message, or WATCH_ASKED. */
int stepped_solve(struct sampled *sampled, double finest, const struct watch *watch, struct message *message);

#endif
