/* SPDX-License-Identifier: BSD-3-Clause */
#include "excluded.h"

#include <stdlib.h>
#include <string.h>

#include "pairs.h"

static int is_before(const int64_t a[2], const int64_t b[2])
{
    return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
}

int excluded_create(struct excluded *e, int64_t n, int64_t *start, int64_t count, const int64_t *pair,
                    struct message *message)
{
    memset(e, 0, sizeof *e);
    for (int64_t k = 0; k < 2 * count; ++k)
        if (pair[k] < 0 || pair[k] >= n)
            return message_set(message, "contacts: the excluded pair %lld names body %lld; there are %lld, from 0",
                               (long long)(k / 2), (long long)pair[k], (long long)n);
    if (count == 0)
        return 0;
    e->pair = malloc((size_t)count * 2 * sizeof *e->pair);
    e->released = calloc((size_t)count, sizeof *e->released);
    int64_t *const other = malloc((size_t)count * 2 * sizeof *other);
    if (e->pair == NULL || e->released == NULL || other == NULL) {
        free(other);
        return message_set(message, "contacts: out of memory for %lld excluded pairs; use fewer", (long long)count);
    }
    for (int64_t k = 0; k < count; ++k) {
        const int64_t i = pair[2 * k], j = pair[2 * k + 1];
        e->pair[2 * k] = i < j ? i : j;
        e->pair[2 * k + 1] = i < j ? j : i;
    }
    pairs_sort(n, start, count, e->pair, other);
    e->count = count;
    free(other);
    return 0;
}

/** The first that is not before the pair. */
static int64_t find(const struct excluded *e, const int64_t pair[2])
{
    int64_t at = 0, end = e->count;
    while (at < end) {
        const int64_t middle = at + (end - at) / 2;
        if (is_before(e->pair + 2 * middle, pair))
            at = middle + 1;
        else
            end = middle;
    }
    return at;
}

int excluded_has(const struct excluded *e, const int64_t pair[2])
{
    const int64_t at = find(e, pair);
    return at < e->count && !is_before(pair, e->pair + 2 * at) && !e->released[at];
}

int excluded_release(struct excluded *e, const int64_t pair[2])
{
    int any = 0; /* a pair may be given twice */
    for (int64_t at = find(e, pair); at < e->count && !is_before(pair, e->pair + 2 * at); ++at) {
        any |= !e->released[at];
        e->released[at] = 1;
    }
    return any;
}

int64_t excluded_leave_out(const struct excluded *e, int64_t count, const int64_t *from, const int64_t *owner,
                           int64_t *to)
{
    int64_t kept = 0, at = 0;
    for (int64_t k = 0; k < count; ++k) {
        const int64_t *const f = from + 2 * k;
        while (at < e->count && is_before(e->pair + 2 * at, f))
            ++at;
        if (at < e->count && !is_before(f, e->pair + 2 * at) && !e->released[at])
            continue;
        if (owner != NULL && owner[f[0]] == owner[f[1]])
            continue;
        to[2 * kept] = f[0];
        to[2 * kept + 1] = f[1];
        ++kept;
    }
    return kept;
}

void excluded_destroy(struct excluded *e)
{
    free(e->pair);
    free(e->released);
    memset(e, 0, sizeof *e);
}
