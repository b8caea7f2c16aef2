/* SPDX-License-Identifier: BSD-3-Clause
 * Signals that ask a run to stop: batch systems send SIGTERM or SIGUSR1 before they kill, people press Ctrl-C. */
#ifndef VTI_SIGNALS_H
#define VTI_SIGNALS_H

/** From now on SIGTERM, SIGUSR1, SIGINT, SIGHUP and SIGXCPU are noted, but one that comes seconds after another, which
 *  ends the program; and a file that grows too large or a pipe that nobody reads any more is an error, not a signal. */
void signals_catch(void);
/** "SIGTERM", say, if one has come, else NULL. */
const char *signals_seen(void);
/** Ends the program as the signal that has come would have. */
void signals_obey(void);

#endif
