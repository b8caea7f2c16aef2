/* SPDX-License-Identifier: BSD-3-Clause */
#include "ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "plain.h"

#define HELP "write one step (1/64), a list (0.1,0.05) or a ladder by factors of two (2^-4:2^-13)"

/** The number in text[0..length). */
static int read_part(const char *text, size_t length, double *value)
{
    char part[64];
    if (length >= sizeof part)
        return -1;
    memcpy(part, text, length);
    part[length] = '\0';
    return number_read(part, value) == 0 && *value > 0.0 ? 0 : -1;
}

static int64_t read_ladder(const char *text, const char *colon, double h[LADDER_MOST], struct message *message)
{
    double from, to;
    if (read_part(text, (size_t)(colon - text), &from) != 0 || read_part(colon + 1, strlen(colon + 1), &to) != 0)
        return message_set(message, "--h: '%s' is not a ladder of two positive numbers; " HELP, text);
    const double rungs = plain_log2(from / to);
    if (fabs(rungs - rint(rungs)) > 1e-9)
        return message_set(message, "--h: '%s' does not go from one to the other by factors of two; " HELP, text);
    if (fabs(rungs) >= LADDER_MOST)
        return message_set(message, "--h: '%s' has more than %d steps; use a shorter ladder", text, LADDER_MOST);
    const int64_t n = 1 + llabs((long long)rint(rungs));
    for (int64_t k = 0; k < n; ++k)
        h[k] = ldexp(fmax(from, to), (int)-k);
    return n;
}

static int falling(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p < q) - (p > q);
}

int64_t ladder_read(const char *text, double h[LADDER_MOST], struct message *message)
{
    const char *colon = strchr(text, ':');
    if (colon != NULL)
        return read_ladder(text, colon, h, message);
    int64_t n = 0;
    for (const char *part = text; part != NULL;) {
        const char *comma = strchr(part, ',');
        const size_t length = comma != NULL ? (size_t)(comma - part) : strlen(part);
        if (n == LADDER_MOST)
            return message_set(message, "--h: more than %d steps; use fewer", LADDER_MOST);
        if (read_part(part, length, &h[n]) != 0)
            return message_set(message, "--h: '%.*s' is not a positive number; " HELP, (int)length, part);
        for (int64_t k = 0; k < n; ++k)
            if (h[k] == h[n])
                return message_set(message, "--h: '%.*s' appears twice; name every step once", (int)length, part);
        ++n;
        part = comma != NULL ? comma + 1 : NULL;
    }
    qsort(h, (size_t)n, sizeof *h, falling);
    return n;
}
