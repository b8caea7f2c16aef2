/* SPDX-License-Identifier: BSD-3-Clause */
#define _XOPEN_SOURCE 700 /* SIGXFSZ, clock_gettime */
#include "signals.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <time.h>

static volatile sig_atomic_t seen = 0;
static volatile sig_atomic_t since; /* seconds of a clock that nobody sets */

/** One that comes again after so many seconds is not to be waited for any longer. Launchers send the same one twice at
 *  once, to the process and to its group. */
enum { PATIENCE = 5 };

static void note(int number)
{
    struct timespec now = {0, 0};
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (seen == 0)
        since = (sig_atomic_t)now.tv_sec;
    else if (now.tv_sec - since >= PATIENCE) {
        signal(number, SIG_DFL);
        raise(number); /* once this handler has returned */
    }
    seen = number;
}

void signals_catch(void)
{
    static const int numbers[] = {SIGTERM, SIGUSR1, SIGINT, SIGHUP, SIGXCPU};
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k) {
        struct sigaction before;
        /* what the caller wants ignored stays so: nohup's SIGHUP, Ctrl-C in a shell's background */
        if (sigaction(numbers[k], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(numbers[k], &action, NULL);
    }
    action.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &action, NULL);
    sigaction(SIGPIPE, &action, NULL);
}

const char *signals_seen(void)
{
    const int number = seen;
    return number == 0         ? NULL
           : number == SIGTERM ? "SIGTERM"
           : number == SIGUSR1 ? "SIGUSR1"
           : number == SIGHUP  ? "SIGHUP"
           : number == SIGXCPU ? "SIGXCPU"
                               : "SIGINT";
}

void signals_obey(void)
{
    const int number = seen;
    signal(number, SIG_DFL);
    raise(number);
}
