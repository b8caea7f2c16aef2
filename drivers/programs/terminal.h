/* SPDX-License-Identifier: BSD-3-Clause
 * What a program shows at its terminal: a progress bar with the time left. */
#ifndef VTI_TERMINAL_H
#define VTI_TERMINAL_H

#include <stdint.h>
#include <stdio.h>

/* ---- the bar ---------------------------------------------------------------------------------------------------- */

/** Redraws the bar when something has changed that one can see. done of all are weights; seconds have passed. It
 *  goes to the standard output if that is a terminal, else to the standard error if that is one.
 *
 *  A launcher of MPI gives its ranks pipes (Open MPI: a terminal of its own making as the standard output, wherever
 *  its own goes), and passes on what comes out of them; Open MPI 5 only whole lines, and of a line that is not ended
 *  on the standard error it may make one of the standard output. So there the bar goes to the launcher's own
 *  terminal, which /proc leads to. Where that cannot be, VTI_TERMINAL=1 in the environment says that the standard
 *  error leads to a terminal; under mpirun of Open MPI 5 it says nothing. */
void progress_show(int64_t done, int64_t all, double seconds);
/** The same with a word in front of it: what is being done. */
void progress_show_what(const char *what, int64_t done, int64_t all, double seconds);
/** A line instead of the bar, where nobody knows how much is to be done: "vti-advise: trying exact in 1024 steps". */
void progress_say(const char *line, double seconds);
/** Wipes either. */
void progress_clear(void);

/* ---- where there is no terminal ---------------------------------------------------------------------------------- */

/* Lines on the standard error, so that logs show that a program is alive: a minute apart or more, or as many seconds as
 * VTI_LOG in the environment says, where 0 is never. progress_show_what writes "vti-study: runs: 37 % done, about 25
 * min left". */

/** The program that says so; until then nobody does. It says first if VTI_LOG is no number, and is then left as without
 *  it. */
void log_as(const char *program);
/** "vti-run: step 512 of 1024 (t = 0.5), about 3 h left"; seconds have passed, and so many are left, infinite if nobody
 *  knows. */
void log_step(int64_t step, int64_t steps, double t, double left, double seconds);

/* ---- the last words ---------------------------------------------------------------------------------------------- */

/** Where a program says why it ends that has been told to: the launcher's standard error if that is a terminal, for a
 *  launcher that has been told too may pass on nothing any more (that of Open MPI 4 on a busy machine, that of 5
 *  never); else the standard error. */
FILE *last_words(void);

#endif
