/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef VTI_CLOCK_H
#define VTI_CLOCK_H

/** Seconds on a clock that nobody sets. */
double clock_now(void);

/** Processor time of this thread in seconds: what the clock would say on a core of one's own, whatever else runs
 *  here. */
double clock_of_thread(void);

#endif
