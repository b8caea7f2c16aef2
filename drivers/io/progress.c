/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 40 };

static double shown = -1.0;

void progress_show(int64_t done, int64_t all, double seconds)
{
    char bar[WIDTH + 1];
    if (!isatty(STDERR_FILENO) || all <= 0 || (shown >= 0.0 && seconds - shown < 0.1))
        return;
    shown = seconds;
    const double share = (double)done / (double)all;
    const int filled = (int)(share * WIDTH);
    memset(bar, '.', WIDTH);
    memset(bar, '#', (size_t)filled);
    bar[WIDTH] = '\0';
    fprintf(stderr, "\r[%s] %3.0f %%", bar, 100.0 * share);
    if (done > 0)
        fprintf(stderr, "  %.0f s left ", seconds * (1.0 - share) / share);
    fflush(stderr);
}

void progress_clear(void)
{
    if (shown >= 0.0)
        fprintf(stderr, "\r%*s\r", WIDTH + 32, "");
    shown = -1.0;
}
