/* SPDX-License-Identifier: BSD-3-Clause
 * How often a run is recorded if nobody says. */
#ifndef VTI_INTERVAL_H
#define VTI_INTERVAL_H

#include <stdint.h>

/** Steps between records of a run of so many steps of h, so that there are about as many, from half to twice, and
 *  people like their times: every 0.1, 0.2, 0.25, 0.5 and the like where h divides such a time; else so that they
 *  divide the steps; else every 10, 20, 25, 50 steps and the like. A short run is recorded at every step. */
int64_t interval_choose(double h, int64_t steps, int64_t about);

/** The same with at most so many records; of the start and the end alone where most is less than 2. */
int64_t interval_within(double h, int64_t steps, int64_t about, int64_t most);

/** Records of so many steps, one at each multiple of every; the start and the end are among them. */
int64_t interval_records(int64_t steps, int64_t every);

#endif
