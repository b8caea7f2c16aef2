/* SPDX-License-Identifier: BSD-3-Clause
 * The progress bar with the time left, and where the terminal is (terminal.h). */
#define _POSIX_C_SOURCE 200809L
#include "terminal.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "number.h"
#include "quote.h"

enum { WIDTH = 40, REST = 40 /* what stands beside the bar, at most */ };

static double shown = -1.0;

/* ---- where the terminal is -------------------------------------------------------------------------------------- */

/** Whether this is a rank that a launcher reads by pipes. A program that is started without one has most of the
 *  variables too. */
static int is_launched(void)
{
    struct stat info;
    return (getenv("OMPI_COMM_WORLD_SIZE") != NULL || getenv("PMI_SIZE") != NULL) && fstat(STDERR_FILENO, &info) == 0 &&
           (S_ISFIFO(info.st_mode) || S_ISSOCK(info.st_mode));
}

/** A stream of the process that has started this one, if that is a terminal; or NULL. */
static FILE *launchers(int stream)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%ld/fd/%d", (long)getppid(), stream);
    const int fd = open(path, O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0)
        return NULL;
    FILE *const file = isatty(fd) ? fdopen(fd, "w") : NULL;
    if (file == NULL)
        close(fd);
    else
        signal(SIGTTOU, SIG_IGN); /* ranks are in the background, where `stty tostop` would stop who writes */
    return file;
}

static int is_told(const char *value)
{
    const char *told = getenv("VTI_TERMINAL");
    return told != NULL && strcmp(told, value) == 0;
}

/** A stream that leads to a terminal; or NULL. Of a launcher's it is one of our own, past its pipes: see terminal.h. */
static FILE *find_terminal(void)
{
    FILE *found = NULL;
    if (is_told("0"))
        return NULL;
    if (is_launched()) {
        found = launchers(STDOUT_FILENO);
        found = found != NULL ? found : launchers(STDERR_FILENO);
    } else if (isatty(STDOUT_FILENO) || isatty(STDERR_FILENO))
        found = isatty(STDOUT_FILENO) ? stdout : stderr;
    const int relayed = is_told("1") && getenv("PRTE_LAUNCHED") == NULL;
    return found != NULL || !relayed ? found : stderr;
}

/** It is looked for once. */
static FILE *terminal(void)
{
    static FILE *found = NULL;
    static int looked = 0;
    if (!looked)
        found = find_terminal();
    looked = 1;
    return found;
}

/** Bar and results reach the terminal by different ways under a launcher: it gets the time to pass on what was
 *  first. */
static void let_pass(void)
{
    const struct timespec a_moment = {0, 50000000};
    if (is_launched())
        nanosleep(&a_moment, NULL);
}

/* ---- the bar ---------------------------------------------------------------------------------------------------- */

/** "12 s left", "25 min left", "3.5 h left" */
static void say_left(const char *before, double seconds, FILE *file)
{
    if (seconds < 100.0)
        fprintf(file, "%s%.0f s left", before, seconds);
    else if (seconds < 6000.0)
        fprintf(file, "%s%.0f min left", before, seconds / 60.0);
    else
        fprintf(file, "%s%.3g h left", before, seconds / 3600.0);
}

/* ---- lines where there is no terminal ---------------------------------------------------------------------------- */

static const char *speaker = NULL;

/** Seconds between lines; infinite: none. */
static double interval = 60.0;

/** Whether one is due; it is written then. */
static int log_is_due(double seconds)
{
    static double last = 0.0;
    last = fmin(last, seconds); /* another clock has begun */
    if (speaker == NULL || terminal() != NULL || !(seconds - last >= interval))
        return 0;
    last = seconds;
    return 1;
}

void log_as(const char *program)
{
    const char *const told = getenv("VTI_LOG");
    char shown_told[QUOTE_SIZE];
    double seconds = interval;
    speaker = program;
    if (told != NULL && told[0] != '\0' && number_read(told, &seconds) != 0) {
        fprintf(stderr, "%s: VTI_LOG: '%s' is no number of seconds; lines are %.0f s apart, give 0 for none\n", program,
                quote(shown_told, sizeof shown_told, told), interval);
        return;
    }
    interval = seconds > 0.0 ? seconds : INFINITY;
}

static void end_line(double left)
{
    if (isfinite(left))
        say_left(", about ", left, stderr);
    fputc('\n', stderr);
}

void log_step(int64_t step, int64_t steps, double t, double left, double seconds)
{
    if (!log_is_due(seconds))
        return;
    fprintf(stderr, "%s: step %lld of %lld (t = %.10g)", speaker, (long long)step, (long long)steps, t);
    end_line(left);
}

static void log_share(const char *what, double share, double seconds)
{
    if (!log_is_due(seconds))
        return;
    fprintf(stderr, "%s: %s%s%.0f %% done", speaker, what, *what != '\0' ? ": " : "", 100.0 * share);
    end_line(share > 0.0 ? seconds * (1.0 - share) / share : INFINITY);
}

/* ---- the bar, drawn ---------------------------------------------------------------------------------------------- */

void progress_show_what(const char *what, int64_t done, int64_t all, double seconds)
{
    char bar[WIDTH + 1];
    static const char *last = NULL;
    const int same = last != NULL && strcmp(what, last) == 0;
    if (all <= 0)
        return;
    const double share = fmin((double)done / (double)all, 1.0);
    if (terminal() == NULL)
        log_share(what, share, seconds);
    if (terminal() == NULL || (shown >= 0.0 && same && seconds >= shown && seconds - shown < 0.1))
        return;
    if (shown < 0.0)
        let_pass();
    last = what;
    shown = seconds;
    const int filled = (int)(share * WIDTH);
    memset(bar, '.', WIDTH);
    memset(bar, '#', (size_t)filled);
    bar[WIDTH] = '\0';
    fprintf(terminal(), "\r%s%s[%s] %3.0f %%", what, *what != '\0' ? " " : "", bar, 100.0 * share);
    if (done > 0)
        say_left("  ", seconds * (1.0 - share) / share, terminal());
    fputs("   ", terminal()); /* over the rest of a longer one */
    fflush(terminal());
}

void progress_show(int64_t done, int64_t all, double seconds)
{
    if (terminal() != NULL) /* who shows a step without a name has lines of his own */
        progress_show_what("", done, all, seconds);
}

void progress_say(const char *line, double seconds)
{
    if (terminal() == NULL) {
        if (log_is_due(seconds))
            fprintf(stderr, "%s: %s\n", speaker, line);
        return;
    }
    if (shown < 0.0)
        let_pass();
    shown = seconds;
    fprintf(terminal(), "\r%-*.*s", WIDTH + REST - 1, WIDTH + REST - 1, line);
    fflush(terminal());
}

void progress_clear(void)
{
    if (shown >= 0.0) {
        fprintf(terminal(), "\r%*s\r", WIDTH + REST - 1, "");
        fflush(terminal());
        let_pass();
    }
    shown = -1.0;
}

/* ---- the last words ---------------------------------------------------------------------------------------------- */

FILE *last_words(void)
{
    FILE *const found = is_launched() && !is_told("0") ? launchers(STDERR_FILENO) : NULL;
    return found != NULL ? found : stderr;
}
