/* SPDX-License-Identifier: BSD-3-Clause
 * A progress bar with the time left, on standard error and on a terminal only. */
#ifndef VTI_PROGRESS_H
#define VTI_PROGRESS_H

#include <stdint.h>

/** Redraws the bar when something has changed that one can see. done of all are weights; seconds have passed. */
void progress_show(int64_t done, int64_t all, double seconds);
/** Wipes the bar. */
void progress_clear(void);

#endif
