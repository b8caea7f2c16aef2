/* SPDX-License-Identifier: BSD-3-Clause
 * Progress reports and cancellation of long computations. */
#ifndef VTI_WATCH_H
#define VTI_WATCH_H

#include <stdint.h>

/** see is called now and then with the share that is done, 0 to 1; non-zero asks for the end. A NULL watch looks at
 *  nothing. */
struct watch {
    int (*see)(void *self, double share);
    void *self;
};

static inline int watch_see(const struct watch *watch, double share)
{
    return watch != NULL && watch->see(watch->self, share);
}

/** Returned by functions that were asked to stop. */
enum { WATCH_ASKED = -2 };

/** The person at the terminal of a study, who may be NULL too. */
struct study_watch {
    /** Rank 0: done of all of what ("reference", "runs") after so many seconds. */
    void (*show)(const char *what, int64_t done, int64_t all, double seconds);
    /** Any rank: whether the person, or the machine, has asked it to end. */
    int (*asked)(void);
};

static inline void study_show(const struct study_watch *watch, const char *what, int64_t done, int64_t all,
                              double seconds)
{
    if (watch != NULL)
        watch->show(what, done, all, seconds);
}

static inline int study_asked(const struct study_watch *watch)
{
    return watch != NULL && watch->asked();
}

#endif
