/* SPDX-License-Identifier: BSD-3-Clause */
#include "cells_parts.h"

#include <float.h>
#include <stdlib.h>

#include "threads.h"

/** Longer by what rounding can take off distances and displacements, with room to spare. */
static const double rounding = 1.0 + 16.0 * DBL_EPSILON;

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
    const uint64_t hxy = cells_hash(hx, y);
    for (; z <= last; ++z) {
        const int64_t q[3] = {x, y, z}, next = *cells_slot(s, cells_hash(hxy, z), q) - 1;
        if (next >= 0 && search_two_cells(s, skin, cell, &s->cell[next], found) != 0)
            return -1;
    }
    return 0;
}

/** The cell with itself and with 13 of the 26 around it, for which it is one of the other 13. */
static int search_around(const struct cells *s, double skin, const struct cell *cell, struct pairs *found)
{
    const int64_t x = cell->q[0], y = cell->q[1], z = cell->q[2];
    const uint64_t here = cells_hash(0, x), beside = cells_hash(0, x + 1);
    int failed = search_line(s, skin, cell, here, x, y, z, found);
    failed |= search_line(s, skin, cell, here, x, y + 1, z - 1, found);
    for (int64_t line = y - 1; line <= y + 1; ++line)
        failed |= search_line(s, skin, cell, beside, x + 1, line, z - 1, found);
    return failed;
}

/** A body with those of a level of wider cells: with the cells that the longest of them would reach it from. */
static int search_wider(const struct cells *s, double skin, const struct member *a, int64_t level, struct pairs *found)
{
    const double reach = (a->radius + 0.5 * (s->width[level] + skin)) * CELLS_MARGIN;
    const double low[3] = {a->x[0] - reach, a->x[1] - reach, a->x[2] - reach},
                 high[3] = {a->x[0] + reach, a->x[1] + reach, a->x[2] + reach};
    int64_t begin[3], end[3], q[3];
    cells_at(s, low, level, begin);
    cells_at(s, high, level, end);
    for (q[0] = begin[0]; q[0] <= end[0]; ++q[0])
        for (q[1] = begin[1]; q[1] <= end[1]; ++q[1]) {
            const uint64_t hxy = cells_hash(cells_hash(0, q[0]), q[1]);
            for (q[2] = begin[2]; q[2] <= end[2]; ++q[2]) {
                const int64_t next = *cells_slot(s, cells_hash(hxy, q[2]), q) - 1;
                if (next >= 0 && search_members(s, skin, a, s->cell[next].begin, s->cell[next].end, found) != 0)
                    return -1;
            }
        }
    return 0;
}

/** The bodies of the cell with those of all wider ones, for which it is none of those that they look at. */
static int search_all_wider(const struct cells *s, double skin, const struct cell *cell, struct pairs *found)
{
    const int64_t own = cells_level(cell);
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
    cells_fill(cells, longest, skin);
    return parts > 1 ? search_by_parts(cells, skin, parts, found) : -(int)search_part(&whole, 0);
}
