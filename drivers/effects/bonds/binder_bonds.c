/* SPDX-License-Identifier: BSD-3-Clause
 * Bonds from a table, or between the neighbours of an arrangement; and what each of them tells in files. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "arrange.h"
#include "binder.h"
#include "number.h"

static int out_of_memory(const struct model *model, struct message *message)
{
    return message_set(message, "%s: out of memory for its bonds; use fewer", model->scene->name);
}

/* ---- which bonds ------------------------------------------------------------------------------------------------- */

/** A bond of a table, ordered so that equal ones are neighbours: by its bodies, then by row. */
struct entry {
    int64_t low, high, row;
};

static int compare(const void *a, const void *b)
{
    const struct entry *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return p->row < q->row ? -1 : 1;
}

/** The first row, in the order of the file, that bonds two bodies that are bonded already is at fault. */
static int check_twice(const struct table *t, const char *what, const int64_t *pair, struct entry *all,
                       struct message *message)
{
    int64_t again = -1, first = -1;
    for (int64_t k = 0; k < t->rows; ++k) {
        const int64_t i = pair[2 * k], j = pair[2 * k + 1];
        const struct entry entry = {i < j ? i : j, i < j ? j : i, k};
        all[k] = entry;
    }
    qsort(all, (size_t)t->rows, sizeof *all, compare);
    for (int64_t k = 1; k < t->rows; ++k)
        if (all[k].low == all[k - 1].low && all[k].high == all[k - 1].high && (again < 0 || all[k].row < again)) {
            again = all[k].row;
            first = all[k - 1].row;
        }
    if (again < 0)
        return 0;
    return table_fail(t, again, message, "%s %lld and %lld are bonded a second time, first by %s %lld; keep one", what,
                      (long long)pair[2 * again], (long long)pair[2 * again + 1], t->has_lines ? "line" : "row",
                      (long long)first + (t->has_lines ? 2 : 0));
}

/** body: of each sphere, where spheres of clumps are bonded; else NULL. */
static int read_pairs(const struct model *model, const struct table *t, const int64_t *body, int64_t *pair,
                      struct message *message)
{
    const int64_t count = body != NULL ? model->clumps.list.count : model->bodies.count;
    const char *const one = body != NULL ? "sphere" : "body", *const two = body != NULL ? "spheres" : "bodies";
    for (int64_t k = 0; k < t->rows; ++k) {
        for (int c = 0; c < 2; ++c) {
            const double end = t->column[BOND_I + c][k];
            if (end >= (double)count)
                return table_fail(t, k, message, "%s: '%s' is not a %s; there are %lld, counted from 0",
                                  table_column(t->kind, BOND_I + c), NUMBER(end), one, (long long)count);
            pair[2 * k + c] = (int64_t)end;
        }
        if (pair[2 * k] == pair[2 * k + 1])
            return table_fail(t, k, message, "%s %lld is bonded to itself; name two %s", one, (long long)pair[2 * k],
                              two);
        if (body != NULL && body[pair[2 * k]] == body[pair[2 * k + 1]])
            return table_fail(t, k, message, "spheres %lld and %lld are of one body, %lld; name spheres of two",
                              (long long)pair[2 * k], (long long)pair[2 * k + 1], (long long)body[pair[2 * k]]);
    }
    struct entry *all = calloc(t->rows > 0 ? (size_t)t->rows : 1, sizeof *all);
    if (all == NULL)
        return out_of_memory(model, message);
    const int result = check_twice(t, two, pair, all, message);
    free(all);
    return result;
}

/* ---- bonds at rest ----------------------------------------------------------------------------------------------- */

/** One stiffness for all from the scene, or one for each from the table, copied behind *next; or none. */
static vti_scalars stiffness(const double *value, const struct table *t, int k, double **next)
{
    const vti_scalars none = {NULL, 0, 0};
    if (!table_has(t, k))
        return *value != 0.0 ? vti_scalars_one(value) : none;
    double *p = *next;
    *next += t->rows;
    for (int64_t b = 0; b < t->rows; ++b)
        p[b] = t->column[k][b];
    return vti_scalars_array(p);
}

static int fail_rest(const struct model *model, const struct table *t, const struct binder_self *self, int64_t bond,
                     struct message *message)
{
    char text[160];
    snprintf(text, sizeof text, "the centres of %s %lld and %lld give no direction to their bond; move one of them",
             self->body != NULL ? "spheres" : "bodies", (long long)self->pair[2 * bond],
             (long long)self->pair[2 * bond + 1]);
    if (t->rows > 0)
        return table_fail(t, bond, message, "%s", text);
    return message_set(message, "%s: %s", model->scene->name, text);
}

/** Rotations at rest, as unit quaternions. */
static int take_turns(const struct table *t, double *turn, struct message *message)
{
    for (int64_t k = 0; table_has(t, BOND_TURN) && k < t->rows; ++k) {
        double square = 0.0;
        for (int c = 0; c < 4; ++c)
            square += t->column[BOND_TURN + c][k] * t->column[BOND_TURN + c][k];
        if (!(square > 0.0 && isfinite(square)))
            return table_fail(t, k, message,
                              "turn_x, turn_y, turn_z and turn_w are no quaternion; 0, 0, 0, 1 turns nothing");
        for (int c = 0; c < 4; ++c)
            turn[4 * k + c] = t->column[BOND_TURN + c][k] / sqrt(square);
    }
    return 0;
}

/** Lengths and directions at rest of the table, in place of those at t = 0: bonds that are under stress then. */
static int take_rest(const struct table *t, double *rest, struct message *message)
{
    for (int64_t k = 0; table_has(t, BOND_LENGTH) && k < t->rows; ++k)
        rest[4 * k + 3] = t->column[BOND_LENGTH][k];
    for (int64_t k = 0; table_has(t, BOND_NORMAL) && k < t->rows; ++k) {
        const double n[3] = {t->column[BOND_NORMAL][k], t->column[BOND_NORMAL + 1][k], t->column[BOND_NORMAL + 2][k]};
        const double length = vti_norm(n);
        if (!(length > 0.0 && isfinite(length)))
            return table_fail(t, k, message, "nx, ny and nz give no direction; one of them must not be 0");
        for (int c = 0; c < 3; ++c)
            rest[4 * k + c] = n[c] / length;
    }
    return 0;
}

int binder_make_bonds(struct effect *e, const struct model *model, const struct table *t, struct message *message)
{
    enum { REST = 4, STIFFNESSES = 3 };
    const struct binder_settings *binder = e->settings;
    const int on_spheres = binder->on == BINDER_ON_SPHERES, turns = on_spheres || table_has(t, BOND_TURN) ? 4 : 0;
    struct binder_self *self = e->self;
    vti_fault fault;
    const vti_bodies *const joined = on_spheres ? model_spheres(model) : &model->bodies;
    const int64_t count = t->rows > 0 ? t->rows : arrange_bonds(model->scene);
    self->body = on_spheres ? model->clumps.list.body : NULL;
    if (on_spheres && vti_clumps_spread(&model->clumps.list, &model->bodies) != VTI_OK)
        return message_set(message, "%s: bodies.clumps: their spheres have no places", model->scene->name);
    self->pair = calloc((size_t)(2 * count), sizeof *self->pair);
    self->memory = calloc((size_t)((REST + turns + STIFFNESSES) * count), sizeof *self->memory);
    if (self->pair == NULL || self->memory == NULL)
        return out_of_memory(model, message);
    if (t->rows == 0)
        arrange_bond_pairs(model->scene, self->pair);
    else if (read_pairs(model, t, self->body, self->pair, message) != 0)
        return -1;
    double *turn = self->memory + REST * count, *next = turn + turns * count;
    if ((on_spheres ? vti_bonds_rest_now(count, self->pair, 0, joined, self->memory, turn, &fault)
                    : vti_bonds_rest(count, self->pair, 0, &joined->x, self->memory, &fault)) != VTI_OK)
        return fail_rest(model, t, self, fault.body, message);
    vti_bonds *bonds = &self->bonds;
    if (take_rest(t, self->memory, message) != 0 || take_turns(t, turn, message) != 0)
        return -1;
    bonds->count = self->all = count;
    bonds->pair = self->pair;
    bonds->rest = self->memory;
    bonds->turn = turns > 0 ? turn : NULL;
    bonds->moment = stiffness(&binder->stiffness[0], t, BOND_MOMENT, &next);
    bonds->axial = stiffness(&binder->stiffness[1], t, BOND_AXIAL, &next);
    bonds->shear = stiffness(&binder->stiffness[2], t, BOND_SHEAR, &next);
    bonds->shear_form = binder_shear(binder);
    const int status = vti_bonds_check(bonds, joined->count, &fault);
    if (status != VTI_OK)
        return message_set(message, "%s: bond %lld: %s", model->scene->name, (long long)fault.body,
                           vti_status_text(status));
    return binder_make_breaking(e, model, t, message);
}

/* ---- what a bond tells ------------------------------------------------------------------------------------------- */

static int64_t count(const struct effect *e)
{
    return ((const struct binder_self *)e->self)->all;
}

static void ends(const struct effect *e, int64_t k, int64_t pair[2])
{
    const struct binder_self *self = e->self;
    const int64_t *bodies = self->breaking.ends != NULL ? self->breaking.ends : self->pair;
    pair[0] = bodies[2 * k];
    pair[1] = bodies[2 * k + 1];
}

/** Of all bonds of the scene, whether they hold or not: their arrays have all. */
static int values(const struct effect *e, const vti_bodies *bodies, int64_t step, double *const *value)
{
    enum { TILE = 64 };
    const struct binder_self *self = e->self;
    const double *broke = self->breaking.broke, *made = self->breaking.made;
    double measures[TILE][VTI_BOND_MEASURES];
    vti_bonds every = self->bonds;
    every.count = self->all;
    for (int64_t k = 0; k < self->all; ++k) {
        const int64_t last = k + TILE < self->all ? k + TILE : self->all, m = binder_number(self, k);
        const int status = k % TILE == 0 ? vti_bonds_measure(&every, bodies, k, last, measures[0]) : VTI_OK;
        const int holds = broke == NULL || (broke[m] > (double)step && (made == NULL || made[m] <= (double)step));
        if (status != VTI_OK)
            return status;
        value[0][m] = holds ? measures[k % TILE][VTI_BOND_ENERGY] : 0.0;
        value[1][m] = holds ? measures[k % TILE][VTI_BOND_STRETCH] : 0.0;
        if (broke != NULL)
            value[2][m] = holds;
    }
    return VTI_OK;
}

static const char *const quantity[] = {"bond_energy", "bond_stretch", "bond_holds"};

static int told(const struct effect *e)
{
    return ((const struct binder_self *)e->self)->breaking.id != NULL ? 3 : 2;
}

const struct effect_lines binder_lines = {"bond", quantity, 3, told, count, ends, values};
