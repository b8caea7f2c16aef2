/* SPDX-License-Identifier: BSD-3-Clause */
#include "pairs.h"

#include <string.h>

/** Stable counting sort of pairs by their side 0 or 1, whose values are below n. */
static void sort_by(int side, int64_t n, int64_t *start, int64_t count, const int64_t *from, int64_t *to)
{
    memset(start, 0, (size_t)(n + 1) * sizeof *start);
    for (int64_t k = 0; k < count; ++k)
        ++start[from[2 * k + side] + 1];
    for (int64_t i = 0; i < n; ++i)
        start[i + 1] += start[i];
    for (int64_t k = 0; k < count; ++k) {
        const int64_t at = start[from[2 * k + side]]++;
        to[2 * at] = from[2 * k];
        to[2 * at + 1] = from[2 * k + 1];
    }
}

void pairs_sort(int64_t n, int64_t *start, int64_t count, int64_t *pair, int64_t *other)
{
    sort_by(1, n, start, count, pair, other);
    sort_by(0, n, start, count, other, pair);
}
