/* SPDX-License-Identifier: BSD-3-Clause */
#include "renumber.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shape.h"

/* ---- the order --------------------------------------------------------------------------------------------------- */

/** A row, and what it is sorted by. */
struct place {
    uint64_t first, second;
    int64_t row;
};

static int compare(const void *a, const void *b)
{
    const struct place *p = a, *q = b;
    if (p->first != q->first)
        return p->first < q->first ? -1 : 1;
    if (p->second != q->second)
        return p->second < q->second ? -1 : 1;
    return p->row < q->row ? -1 : 1;
}

/** So many cells along the longest side of the box that has all bodies. */
enum { BITS = 20 };

/** The cells' numbers along x, y and z, bit by bit in turn. */
static uint64_t along_curve(const double x[3], const double low[3], double width)
{
    uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
        const double most = (1 << BITS) - 1, cell = width > 0.0 ? fmin((x[k] - low[k]) / width, most) : 0.0;
        for (int bit = 0; bit < BITS; ++bit)
            code |= ((uint64_t)cell >> bit & 1) << (3 * bit + k);
    }
    return code;
}

static void order_bodies(const struct table *bodies, struct place *place)
{
    double low[3], high[3], width = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double *const x = bodies->column[BODY_X + k];
        low[k] = high[k] = x[0];
        for (int64_t i = 1; i < bodies->rows; ++i) {
            low[k] = fmin(low[k], x[i]);
            high[k] = fmax(high[k], x[i]);
        }
        width = fmax(width, ldexp(high[k] - low[k], -BITS));
    }
    for (int64_t i = 0; i < bodies->rows; ++i) {
        const double x[3] = {bodies->column[BODY_X][i], bodies->column[BODY_X + 1][i], bodies->column[BODY_X + 2][i]};
        const struct place at = {along_curve(x, low, width), 0, i};
        place[i] = at;
    }
    qsort(place, (size_t)bodies->rows, sizeof *place, compare);
}

/* ---- tables in that order ---------------------------------------------------------------------------------------- */

/** The rows of *from as places have them. */
static int copy_rows(const struct table *from, const struct place *place, struct table *to)
{
    table_start(to, from->kind, from->path);
    for (int c = 0; c < TABLE_COLUMNS; ++c)
        if (table_has(from, c) && table_add(to, c) != 0)
            return -1;
    if (table_reserve(to, from->rows) != 0)
        return -1;
    to->rows = from->rows;
    for (int c = 0; c < TABLE_COLUMNS; ++c)
        for (int64_t k = 0; table_has(from, c) && k < from->rows; ++k)
            to->column[c][k] = from->column[c][place[k].row];
    return 0;
}

/** New numbers in the columns that name bodies, and rows by the lowest of them, then by the highest. */
static int copy_names(const struct table *from, const int64_t *now, struct place *place, struct table *to)
{
    for (int64_t k = 0; k < from->rows; ++k) {
        const struct place none = {UINT64_MAX, 0, k};
        place[k] = none;
        for (int c = 0; c < from->kind->columns; ++c) {
            if (!table_has(from, c) || from->kind->column[c].range != TABLE_INDEX)
                continue;
            const uint64_t body = (uint64_t)now[(int64_t)from->column[c][k]];
            place[k].first = body < place[k].first ? body : place[k].first;
            place[k].second = body > place[k].second ? body : place[k].second;
        }
    }
    qsort(place, (size_t)from->rows, sizeof *place, compare);
    if (copy_rows(from, place, to) != 0)
        return -1;
    for (int c = 0; c < from->kind->columns; ++c)
        for (int64_t k = 0; table_has(to, c) && from->kind->column[c].range == TABLE_INDEX && k < to->rows; ++k)
            to->column[c][k] = (double)now[(int64_t)to->column[c][k]];
    return 0;
}

static int copy_all(const struct tables *from, struct place *place, int64_t *now, struct renumbering *r)
{
    const int64_t n = from->bodies.rows;
    order_bodies(&from->bodies, place);
    for (int64_t k = 0; k < n; ++k) {
        r->number[k] = place[k].row;
        now[place[k].row] = k;
    }
    r->tables.number = r->number;
    int failed = copy_rows(&from->bodies, place, &r->tables.bodies);
    for (int k = 0; k < EFFECT_COUNT && failed == 0; ++k)
        if (from->effect[k].rows > 0)
            failed = copy_names(&from->effect[k], now, place, &r->tables.effect[k]);
    return failed;
}

/* ---- together ---------------------------------------------------------------------------------------------------- */

static int check(const struct model *model, const struct tables *tables, struct message *message)
{
    const char *name = model->scene->name;
    if (model->scene->arrangement != SCENE_IN_TABLE || !table_has(&tables->bodies, BODY_X))
        return message_set(message, "%s: bodies are not in a table with columns x, y, z; leave --renumber out", name);
    if (model_has_clumps(model))
        return message_set(message, "%s: bodies.clumps are not renumbered; leave --renumber out", name);
    if (shape_breaking(model) != NULL)
        return message_set(
            message, "%s: bonds that break or are made on the way are not renumbered; leave --renumber out", name);
    return 0;
}

int renumber(const struct model *model, const struct tables *tables, struct renumbering *r, struct message *message)
{
    int64_t most = tables->bodies.rows;
    memset(r, 0, sizeof *r);
    if (check(model, tables, message) != 0)
        return -1;
    for (int k = 0; k < EFFECT_COUNT; ++k)
        most = tables->effect[k].rows > most ? tables->effect[k].rows : most;
    struct place *place = calloc((size_t)most, sizeof *place);
    int64_t *now = calloc((size_t)tables->bodies.rows, sizeof *now);
    r->number = calloc((size_t)tables->bodies.rows, sizeof *r->number);
    const int failed = place == NULL || now == NULL || r->number == NULL || copy_all(tables, place, now, r) != 0;
    free(place);
    free(now);
    return failed ? scene_no_memory(model->scene, message) : 0;
}

void renumber_destroy(struct renumbering *r)
{
    tables_destroy(&r->tables);
    free(r->number);
    memset(r, 0, sizeof *r);
}

void renumber_back(const int64_t *number, const vti_bodies *from, const vti_bodies *to)
{
    const vti_view *const views[][2] = {{&from->x, &to->x},
                                        {&from->v, &to->v},
                                        {&from->alpha, &to->alpha},
                                        {&from->omega, &to->omega},
                                        {&from->spin, &to->spin}};
    for (size_t q = 0; q < sizeof views / sizeof views[0]; ++q)
        for (int64_t i = 0; views[q][0]->c[0] != NULL && i < from->count; ++i)
            for (int k = 0; k < 3; ++k)
                views[q][1]->c[k][number[i] * views[q][1]->stride] = views[q][0]->c[k][i * views[q][0]->stride];
}
