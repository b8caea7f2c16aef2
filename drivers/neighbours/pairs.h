/* SPDX-License-Identifier: BSD-3-Clause
 * Lists of pairs of bodies. */
#ifndef VTI_PAIRS_H
#define VTI_PAIRS_H

#include <stdint.h>

/** A list of pairs that grows. */
struct pairs {
    int64_t count, room;
    int64_t *pair; /* [room][2], of which count are used */
};

/** Sorts count pairs of bodies below n by (i, j) in time O(n + count), however many neighbours a body has. other is as
 *  large as pair, start is [n + 1]. */
void pairs_sort(int64_t n, int64_t *start, int64_t count, int64_t *pair, int64_t *other);

#endif
