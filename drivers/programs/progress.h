/* SPDX-License-Identifier: BSD-3-Clause
 * A progress bar with the time left, on a terminal only. */
#ifndef VTI_PROGRESS_H
#define VTI_PROGRESS_H

#include <stdint.h>

/** Redraws the bar when something has changed that one can see. done of all are weights; seconds have passed. It goes to the
 *  standard output if that is a terminal, else to the standard error if that is one.
 *
 *  A launcher of MPI gives its ranks pipes (Open MPI: a terminal of its own making as the standard output, wherever its own
 *  goes), and passes on what comes out of them; Open MPI 5 only whole lines, and of a line that is not ended on the standard
 *  error it may make one of the standard output. So there the bar goes to the launcher's own terminal, which /proc leads to.
 *  Where that cannot be, VTI_TERMINAL=1 in the environment says that the standard error leads to a terminal; under mpirun of
 *  Open MPI 5 it says nothing. */
void progress_show(int64_t done, int64_t all, double seconds);
/** The same with a word in front of it: what is being done. */
void progress_show_what(const char *what, int64_t done, int64_t all, double seconds);
/** Wipes the bar. */
void progress_clear(void);

#endif
