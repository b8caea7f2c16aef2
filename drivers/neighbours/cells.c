/* SPDX-License-Identifier: BSD-3-Clause */
#include "cells.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "threads.h"

/** Longer by what rounding can take off distances and displacements, with room to spare. */
static const double rounding = 1.0 + 16.0 * DBL_EPSILON;

/** Cells are counted to 2^40 either way, where x/width is rounded to 2^-13 of a cell: as they are 2^-10 wider than any
 *  reach, bodies in reach are never more than one cell apart. What is farther out shares the last cells. */
static const double last_cell = 0x1p40;
static const double cell_margin = 1.0 + 0x1p-10;

/** Levels of cells stand so far apart in z that none of the one is beside any of the other. */
static const int64_t apart = (int64_t)1 << 44;

/** A body as its cell stores it, so that cells are read in one go. */
struct member {
    double x[3], radius;
    int64_t body;
};

struct cell {
    int64_t q[3], begin, end; /* its members */
};

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/** Cells of level 0 are as wide as two of the longest that touch need them, those of each level half as wide as those
 *  of the level before. A body is of the last level whose cells are wide enough for two of its own radius, so that
 *  among many short bodies a long one does not put all of them into one cell. */
static int64_t level_of(const struct cells *s, double radius, double skin)
{
    const double least = (2.0 * radius + skin) * cell_margin;
    int64_t level = 0;
    while (level + 1 < s->levels && s->width[level + 1] >= least)
        ++level;
    return level;
}

static void set_widths(struct cells *s, double longest, double skin)
{
    s->width[0] = (2.0 * longest + skin) * cell_margin;
    for (int level = 1; level < CELLS_LEVELS; ++level)
        s->width[level] = 0.5 * s->width[level - 1];
}

static void cell_of(const struct cells *s, const double x[3], int64_t level, int64_t q[3])
{
    const double width = s->width[level];
    for (int k = 0; k < 3; ++k)
        q[k] = (int64_t)floor(fmax(-last_cell, fmin(x[k] / width, last_cell)));
    q[2] += level * apart;
}

static int64_t level_of_cell(const struct cell *cell)
{
    return (cell->q[2] + apart / 2) / apart;
}

/** Hashes of cells take in x, y and z one after the other, so that cells in a line share the most of it. */
static uint64_t hash(uint64_t h, int64_t q)
{
    h = (h ^ (uint64_t)q) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 32;
}

/** The slot of the cell q, which has the hash h, or the empty one where it belongs. */
static int64_t *slot_of(const struct cells *s, uint64_t h, const int64_t q[3])
{
    const uint64_t mask = (uint64_t)s->slots - 1;
    for (h &= mask;; h = (h + 1) & mask) {
        const int64_t c = s->slot[h] - 1;
        if (c < 0 || memcmp(s->cell[c].q, q, sizeof s->cell[c].q) == 0)
            return &s->slot[h];
    }
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
        cell_of(s, s->x + 3 * i, level, q);
        int64_t *const slot = slot_of(s, hash(hash(hash(0, q[0]), q[1]), q[2]), q);
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

static void fill_cells(struct cells *s, double skin)
{
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

/* ---- search ------------------------------------------------------------------------------------------------------ */

/** Room for so many more. */
static int make_room(struct pairs *found, int64_t more)
{
    if (found->count + more <= found->room)
        return 0;
    const int64_t room = 2 * found->room + more + 64;
    int64_t *const pair = realloc(found->pair, (size_t)room * 2 * sizeof *pair);
    if (pair == NULL)
        return -1;
    found->pair = pair;
    found->room = room;
    return 0;
}

static int add(struct pairs *found, int64_t i, int64_t j)
{
    if (make_room(found, 1) != 0)
        return -1;
    found->pair[2 * found->count] = i < j ? i : j;
    found->pair[2 * found->count + 1] = i < j ? j : i;
    ++found->count;
    return 0;
}

static int is_crowd(const struct cells *s, const struct pairs *found)
{
    return found->count > CELLS_FEW_PAIRS && found->count > CELLS_CROWD * s->n;
}

int cells_are_crowded(const struct cells *cells, const struct pairs *found)
{
    int crowded = is_crowd(cells, found);
    for (int64_t k = 0; k < cells->parts; ++k)
        crowded |= is_crowd(cells, &cells->part[k]);
    return crowded;
}

/** The pairs of one member with the members begin <= k < end. */
static int search_members(const struct cells *s, double skin, const struct member *a, int64_t begin, int64_t end,
                          struct pairs *found)
{
    for (int64_t k = begin; k < end; ++k) {
        const struct member *const b = &s->member[k];
        const double d[3] = {a->x[0] - b->x[0], a->x[1] - b->x[1], a->x[2] - b->x[2]};
        const double reach = (a->radius + b->radius + skin) * rounding;
        if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach && add(found, a->body, b->body) != 0)
            return -1;
    }
    return is_crowd(s, found) ? -1 : 0;
}

static int search_two_cells(const struct cells *s, double skin, const struct cell *cell, const struct cell *next,
                            struct pairs *found)
{
    for (int64_t k = cell->begin; k < cell->end; ++k) {
        const int64_t begin = cell == next ? k + 1 : next->begin;
        if (search_members(s, skin, &s->member[k], begin, next->end, found) != 0)
            return -1;
    }
    return 0;
}

/** The cell with those of the line at x and y beside it, from z on, the hash of x being hx. */
static int search_line(const struct cells *s, double skin, const struct cell *cell, uint64_t hx, int64_t x, int64_t y,
                       int64_t z, struct pairs *found)
{
    const int64_t last = cell->q[2] + 1;
    const uint64_t hxy = hash(hx, y);
    for (; z <= last; ++z) {
        const int64_t q[3] = {x, y, z}, next = *slot_of(s, hash(hxy, z), q) - 1;
        if (next >= 0 && search_two_cells(s, skin, cell, &s->cell[next], found) != 0)
            return -1;
    }
    return 0;
}

/** The cell with itself and with 13 of the 26 around it, for which it is one of the other 13. */
static int search_around(const struct cells *s, double skin, const struct cell *cell, struct pairs *found)
{
    const int64_t x = cell->q[0], y = cell->q[1], z = cell->q[2];
    const uint64_t here = hash(0, x), beside = hash(0, x + 1);
    int failed = search_line(s, skin, cell, here, x, y, z, found);
    failed |= search_line(s, skin, cell, here, x, y + 1, z - 1, found);
    for (int64_t line = y - 1; line <= y + 1; ++line)
        failed |= search_line(s, skin, cell, beside, x + 1, line, z - 1, found);
    return failed;
}

/** A body with those of a level of wider cells: with the cells that the longest of them would reach it from. */
static int search_wider(const struct cells *s, double skin, const struct member *a, int64_t level, struct pairs *found)
{
    const double reach = (a->radius + 0.5 * (s->width[level] + skin)) * cell_margin;
    const double low[3] = {a->x[0] - reach, a->x[1] - reach, a->x[2] - reach},
                 high[3] = {a->x[0] + reach, a->x[1] + reach, a->x[2] + reach};
    int64_t begin[3], end[3], q[3];
    cell_of(s, low, level, begin);
    cell_of(s, high, level, end);
    for (q[0] = begin[0]; q[0] <= end[0]; ++q[0])
        for (q[1] = begin[1]; q[1] <= end[1]; ++q[1]) {
            const uint64_t hxy = hash(hash(0, q[0]), q[1]);
            for (q[2] = begin[2]; q[2] <= end[2]; ++q[2]) {
                const int64_t next = *slot_of(s, hash(hxy, q[2]), q) - 1;
                if (next >= 0 && search_members(s, skin, a, s->cell[next].begin, s->cell[next].end, found) != 0)
                    return -1;
            }
        }
    return 0;
}

/** The bodies of the cell with those of all wider ones, for which it is none of those that they look at. */
static int search_all_wider(const struct cells *s, double skin, const struct cell *cell, struct pairs *found)
{
    const int64_t own = level_of_cell(cell);
    for (int64_t level = 0; level < own; ++level)
        for (int64_t k = cell->begin; s->on_level[level] > 0 && k < cell->end; ++k)
            if (search_wider(s, skin, &s->member[k], level, found) != 0)
                return -1;
    return 0;
}

struct search {
    const struct cells *cells;
    double skin;
    int64_t parts;
    struct pairs *found; /* [parts] */
};

/** Returns 1 if memory is out or there is a crowd. */
static int64_t search_part(void *self, int64_t part)
{
    const struct search *s = self;
    const int64_t all = s->cells->count, end = threads_begin(all, part + 1, s->parts);
    struct pairs *const found = &s->found[part];
    found->count = 0;
    for (int64_t c = threads_begin(all, part, s->parts); c < end; ++c)
        if (search_around(s->cells, s->skin, &s->cells->cell[c], found) != 0 ||
            search_all_wider(s->cells, s->skin, &s->cells->cell[c], found) != 0)
            return 1;
    return 0;
}

/** A list for each of the threads that there are. */
static int make_parts(struct cells *cells, int64_t parts)
{
    if (parts <= cells->parts)
        return 0;
    struct pairs *const part = realloc(cells->part, (size_t)parts * sizeof *part);
    if (part == NULL)
        return -1;
    memset(part + cells->parts, 0, (size_t)(parts - cells->parts) * sizeof *part);
    cells->part = part;
    cells->parts = parts;
    return 0;
}

static int search_by_parts(struct cells *cells, double skin, int64_t parts, struct pairs *found)
{
    if (make_parts(cells, parts) != 0)
        return -1;
    struct search search = {cells, skin, parts, cells->part};
    if (threads_sum(parts, search_part, &search) > 0)
        return -1;
    found->count = 0;
    for (int64_t k = 0; k < parts; ++k) {
        const struct pairs *const part = &cells->part[k];
        if (part->count == 0)
            continue;
        if (make_room(found, part->count) != 0)
            return -1;
        memcpy(found->pair + 2 * found->count, part->pair, (size_t)part->count * 2 * sizeof *part->pair);
        found->count += part->count;
    }
    return 0;
}

int cells_search(struct cells *cells, double longest, double skin, struct pairs *found)
{
    const int64_t parts = threads_used();
    struct search whole = {cells, skin, 1, found};
    set_widths(cells, longest, skin);
    fill_cells(cells, skin);
    return parts > 1 ? search_by_parts(cells, skin, parts, found) : -(int)search_part(&whole, 0);
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
