/* SPDX-License-Identifier: BSD-3-Clause
 * Pairs of bodies that a search leaves out. */
#ifndef VTI_EXCLUDED_H
#define VTI_EXCLUDED_H

#include <stdint.h>

#include "message.h"

/** Pairs that are left out until they are released. */
struct excluded {
    int64_t count;
    int64_t *pair;           /* [count][2], i < j, sorted */
    unsigned char *released; /* [count] 1: no longer left out */
};

/** Copies pairs of bodies below n, in any order and either way round; start is [n + 1] of scratch. Returns 0, or -1
 *  with one line in *message; excluded_destroy is due in either case. */
int excluded_create(struct excluded *e, int64_t n, int64_t *start, int64_t count, const int64_t *pair,
                    struct message *message);
/** Whether the pair i < j is left out. */
int excluded_has(const struct excluded *e, const int64_t pair[2]);
/** No longer leaves the pair i < j out. Returns 1 if it was left out before, else 0. */
int excluded_release(struct excluded *e, const int64_t pair[2]);
/** Copies the count sorted pairs `from` that are not left out to `to`, and of these only pairs of two owners unless
 *  owner is NULL. Returns how many. */
int64_t excluded_leave_out(const struct excluded *e, int64_t count, const int64_t *from, const int64_t *owner,
                           int64_t *to);
void excluded_destroy(struct excluded *e);

#endif
