/* SPDX-License-Identifier: BSD-3-Clause
 * What other spheres leave of the lines through one of them (EQUATIONS 7.5). */
#ifndef VTI_OVERLAPS_H
#define VTI_OVERLAPS_H

#include <string.h>

#include "vti.h"

static inline double distance(const double *centre, int64_t i, int64_t j)
{
    const double *a = centre + 3 * i, *b = centre + 3 * j, d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return vti_norm(d);
}

/** The spheres that overlap sphere s, if they are no more than there is room for; else count is -1, and all are
 *  asked. */
enum { ROOM = 128 };
struct neighbours {
    int64_t s, count, of[ROOM];
};

/** A lens thinner than 2^-27 of a diameter, of which only rounding knows, has no volume. */
static inline void find_neighbours(int64_t n, const double *centre, const double *diameter, int64_t s,
                                   struct neighbours *near)
{
    near->s = s;
    near->count = 0;
    for (int64_t j = 0; j < n && near->count >= 0; ++j) {
        const double touch = 0.5 * (diameter[s] + diameter[j]);
        if (j == s || distance(centre, s, j) >= (1.0 - 0x1p-27) * touch)
            continue;
        if (near->count < ROOM)
            near->of[near->count++] = j;
        else
            near->count = -1;
    }
}

/** Where the line through x, y passes sphere j, all from the centre of sphere s; 0 if it does not. */
static inline int pass(const double *centre, const double *diameter, int64_t s, int64_t j, double x, double y,
                       double ends[2])
{
    const double *a = centre + 3 * s, *b = centre + 3 * j, dx = x - (b[0] - a[0]), dy = y - (b[1] - a[1]);
    const double z = b[2] - a[2], half2 = 0.25 * diameter[j] * diameter[j] - dx * dx - dy * dy;
    if (!(half2 > 0.0))
        return 0;
    ends[0] = z - sqrt(half2);
    ends[1] = z + sqrt(half2);
    return 1;
}

/** Lines through the ball of a sphere, and who takes from it: the neighbours before it in the list, or those behind. */
struct scan {
    int64_t n;
    const double *centre, *diameter;
    const struct neighbours *near;
    int behind;
};

/** Who takes from the lines of one x, which pass its centre at half2 less than its radius squared, seen along y. */
struct taker {
    double half2, y, z;
};
struct row {
    int64_t count;
    struct taker of[ROOM];
};

static inline void find_row(const struct scan *scan, double x, struct row *row)
{
    const struct neighbours *near = scan->near;
    const double *a = scan->centre + 3 * near->s;
    row->count = 0;
    for (int64_t k = 0; k < near->count; ++k) {
        const int64_t j = near->of[k];
        const double *b = scan->centre + 3 * j, d = scan->diameter[j], dx = x - (b[0] - a[0]);
        const double half2 = 0.25 * d * d - dx * dx;
        if ((j > near->s) == scan->behind && half2 > 0.0)
            row->of[row->count++] = (struct taker){half2, b[1] - a[1], b[2] - a[2]};
    }
}

/** What may be left of a line, and what is taken from its midst, in the order in which it begins. */
struct line {
    double from, to, taken[ROOM][2];
    int64_t count;
};

/** What reaches an end of the line moves that end: so few are kept in most lines. */
static inline void take(struct line *line, double from, double to)
{
    int64_t k = line->count;
    if (!(to > line->from && from < line->to))
        return;
    if (from <= line->from)
        line->from = to;
    else if (to >= line->to)
        line->to = from;
    else {
        for (; k > 0 && line->taken[k - 1][0] > from; --k)
            memcpy(line->taken[k], line->taken[k - 1], sizeof line->taken[k]);
        line->taken[k][0] = from;
        line->taken[k][1] = to;
        ++line->count;
    }
}

/** Who takes the last that is left of a line is the first to be asked about the next one. */
static inline void find_line(struct row *row, double y, const double ball[2], struct line *line)
{
    line->from = ball[0];
    line->to = ball[1];
    line->count = 0;
    for (int64_t k = 0; k < row->count && line->from < line->to; ++k) {
        const struct taker of = row->of[k];
        const double dy = y - of.y, half2 = of.half2 - dy * dy;
        if (!(half2 > 0.0))
            continue;
        const double half = sqrt(half2);
        take(line, of.z - half, of.z + half);
        if (!(line->from < line->to)) {
            row->of[k] = row->of[0];
            row->of[0] = of;
        }
    }
}

/** Whether sphere j passes the line and takes from it, and where. */
static inline int takes(const struct scan *scan, int64_t j, double x, double y, double ends[2])
{
    const int64_t s = scan->near->s;
    return j != s && (j > s) == scan->behind && pass(scan->centre, scan->diameter, s, j, x, y, ends);
}

/** The first piece of the line from `from` on, up to `to`, that no sphere takes, all being asked: none if
 *  piece[0] >= piece[1]. */
static inline void next_free(const struct scan *scan, double x, double y, double from, double to, double piece[2])
{
    double ends[2];
    for (int moved = 1; moved;) {
        moved = 0;
        for (int64_t j = 0; j < scan->n; ++j)
            if (takes(scan, j, x, y, ends) && ends[0] <= from && ends[1] > from) {
                from = ends[1];
                moved = 1;
            }
    }
    for (int64_t j = 0; j < scan->n; ++j)
        if (takes(scan, j, x, y, ends) && ends[0] > from)
            to = fmin(to, ends[0]);
    piece[0] = from;
    piece[1] = to;
}

#endif
