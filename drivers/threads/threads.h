/* SPDX-License-Identifier: BSD-3-Clause
 * The threads of a program (POSIX): the one place where they are started. They wait a few microseconds and then sleep,
 * and whoever is free does the parts of those that the system lets wait: OpenMP's spin at every barrier, for
 * milliseconds, which on a machine with other work took twenty times as long as one thread. */
#ifndef VTI_THREADS_H
#define VTI_THREADS_H

#include <stdint.h>

enum { THREADS_MOST = 1024 };

/** As many as this process may use, at least 1. */
int64_t threads_most(void);

/** From now on work calls for so many threads, at most THREADS_MOST; 1, as at the start of the program: for that of
 *  the caller. Those that have been started stay: unless the number is 1 they take parts, however small it is now. */
void threads_use(int64_t count);
int64_t threads_used(void);

/** Does parts 0 ... parts - 1 of some work at once, and returns the sum of what they return. No part may depend on
 *  another; what they write is for each its own. Not to be called by two threads at once, nor by a part. */
int64_t threads_sum(int64_t parts, int64_t (*work)(void *self, int64_t part), void *self);

/** Where part k of parts of so many begins; parts are as long as each other, but for one. */
static inline int64_t threads_begin(int64_t all, int64_t part, int64_t parts)
{
    const int64_t rest = all % parts;
    return all / parts * part + (part < rest ? part : rest);
}

#endif
