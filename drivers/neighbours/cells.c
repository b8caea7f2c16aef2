/* SPDX-License-Identifier: BSD-3-Clause */
#include "cells_parts.h"

#include <stdlib.h>

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/** Cells of level 0 are as wide as two of the longest that touch need them, those of each level half as wide as those
 *  of the level before. A body is of the last level whose cells are wide enough for two of its own radius, so that
 *  among many short bodies a long one does not put all of them into one cell. */
static int64_t level_of(const struct cells *s, double radius, double skin)
{
    const double least = (2.0 * radius + skin) * CELLS_MARGIN;
    int64_t level = 0;
    while (level + 1 < s->levels && s->width[level + 1] >= least)
        ++level;
    return level;
}

static void set_widths(struct cells *s, double longest, double skin)
{
    s->width[0] = (2.0 * longest + skin) * CELLS_MARGIN;
    for (int level = 1; level < CELLS_LEVELS; ++level)
        s->width[level] = 0.5 * s->width[level - 1];
}

/** The cell of each body, and of each cell how many bodies it has, in end. */
static void count_members(struct cells *s, double skin)
{
    memset(s->slot, 0, (size_t)s->slots * sizeof *s->slot);
    memset(s->on_level, 0, sizeof s->on_level);
    s->count = 0;
    for (int64_t i = 0; i < s->n; ++i) {
        int64_t q[3];
        const int64_t level = level_of(s, s->radius[i], skin);
        cells_at(s, s->x + 3 * i, level, q);
        int64_t *const slot = cells_slot(s, cells_hash(cells_hash(cells_hash(0, q[0]), q[1]), q[2]), q);
        if (*slot == 0) {
            const struct cell empty = {{q[0], q[1], q[2]}, 0, 0};
            s->cell[s->count] = empty;
            *slot = ++s->count;
            ++s->on_level[level];
        }
        s->home[i] = *slot - 1;
        ++s->cell[*slot - 1].end;
    }
}

/** Whether cells have so many members, on the mean over bodies, that to look at all pairs of neighbouring cells takes
 *  longer than to look for each body among the wider cells too. For 2e4 bodies of two sizes or of many the two take the
 *  same number of instructions at 9 to 12. */
static int is_crowded(const struct cells *s)
{
    static const double crowd = 11.0;
    double others = 0.0;
    for (int64_t c = 0; c < s->count; ++c)
        others += (double)s->cell[c].end * (double)s->cell[c].end;
    return others > crowd * (double)s->n;
}

/** How many there are down to the level of the shortest body. */
static int64_t levels_for(struct cells *s, double skin)
{
    double least = INFINITY;
    for (int64_t i = 0; i < s->n; ++i)
        least = fmin(least, s->radius[i]);
    s->levels = CELLS_LEVELS;
    return 1 + level_of(s, least, skin);
}

void cells_fill(struct cells *s, double longest, double skin)
{
    set_widths(s, longest, skin);
    const int64_t levels = levels_for(s, skin);
    s->levels = 1;
    count_members(s, skin);
    if (levels > 1 && is_crowded(s)) {
        s->levels = levels;
        count_members(s, skin);
    }
    int64_t begin = 0;
    for (int64_t c = 0; c < s->count; ++c) {
        const int64_t members = s->cell[c].end;
        s->cell[c].begin = s->cell[c].end = begin;
        begin += members;
    }
    for (int64_t i = 0; i < s->n; ++i) {
        const double *const x = s->x + 3 * i;
        const struct member m = {{x[0], x[1], x[2]}, s->radius[i], i};
        s->member[s->cell[s->home[i]].end++] = m;
    }
}

/* ---- create and destroy ------------------------------------------------------------------------------------------ */

/** NULL if memory is out, never for being empty. */
static void *array(int64_t count, size_t size)
{
    return calloc(count > 0 ? (size_t)count : 1, size);
}

static int allocate(struct cells *cells, int64_t n)
{
    cells->n = n;
    cells->radius = array(n, sizeof *cells->radius);
    cells->x = array(n, 3 * sizeof *cells->x);
    cells->home = array(n, sizeof *cells->home);
    cells->cell = array(n, sizeof *cells->cell);
    cells->member = array(n, sizeof *cells->member);
    if (!cells->radius || !cells->x || !cells->home || !cells->cell || !cells->member)
        return -1;
    /* at least half of the slots stay empty, so that probes are short and end */
    for (cells->slots = 2; cells->slots < 2 * n;)
        cells->slots *= 2;
    cells->slot = array(cells->slots, sizeof *cells->slot);
    return cells->slot ? 0 : -1;
}

int cells_create(struct cells *cells, int64_t n)
{
    memset(cells, 0, sizeof *cells);
    if (allocate(cells, n) == 0)
        return 0;
    cells_destroy(cells);
    return -1;
}

void cells_destroy(struct cells *cells)
{
    free(cells->radius);
    free(cells->x);
    free(cells->home);
    free(cells->cell);
    free(cells->member);
    free(cells->slot);
    for (int64_t k = 0; k < cells->parts; ++k)
        free(cells->part[k].pair);
    free(cells->part);
    memset(cells, 0, sizeof *cells);
}
