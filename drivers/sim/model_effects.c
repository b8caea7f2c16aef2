/* SPDX-License-Identifier: BSD-3-Clause */
#include <stdio.h>
#include <stdlib.h>

#include "arrange.h"
#include "model_parts.h"
#include "number.h"

static int out_of_memory(const struct model *model, struct message *message)
{
    return message_set(message, "%s: out of memory for its bonds; use fewer", model->scene->name);
}

/* ---- which bonds ------------------------------------------------------------------------------------------------------ */

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

/** The first row, in the order of the file, that bonds two bodies that are bonded already is to blame. */
static int check_twice(const struct table *t, const int64_t *pair, struct entry *all, struct message *message)
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
    return table_fail(t, again, message, "bodies %lld and %lld are bonded a second time, first by %s %lld; keep one",
                      (long long)pair[2 * again], (long long)pair[2 * again + 1], t->has_lines ? "line" : "row",
                      (long long)first + (t->has_lines ? 2 : 0));
}

static int read_pairs(const struct model *model, const struct table *t, int64_t *pair, struct message *message)
{
    for (int64_t k = 0; k < t->rows; ++k) {
        for (int c = 0; c < 2; ++c) {
            const double body = t->column[BOND_I + c][k];
            if (body >= (double)model->bodies.count)
                return table_fail(t, k, message, "%s: '%s' is not a body; there are %lld, counted from 0",
                                  table_column(TABLE_BONDS, BOND_I + c), NUMBER(body), (long long)model->bodies.count);
            pair[2 * k + c] = (int64_t)body;
        }
        if (pair[2 * k] == pair[2 * k + 1])
            return table_fail(t, k, message, "body %lld is bonded to itself; name two bodies", (long long)pair[2 * k]);
    }
    struct entry *all = calloc(t->rows > 0 ? (size_t)t->rows : 1, sizeof *all);
    if (all == NULL)
        return out_of_memory(model, message);
    const int result = check_twice(t, pair, all, message);
    free(all);
    return result;
}

/* ---- the binder ------------------------------------------------------------------------------------------------------- */

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

static int fail_rest(const struct model *model, const struct table *t, int64_t bond, struct message *message)
{
    char text[160];
    snprintf(text, sizeof text, "the centres of bodies %lld and %lld give no direction to their bond; move one of them",
             (long long)model->bond_pairs[2 * bond], (long long)model->bond_pairs[2 * bond + 1]);
    if (t->rows > 0)
        return table_fail(t, bond, message, "%s", text);
    return message_set(message, "%s: %s", model->scene->name, text);
}

static int make_bonds(struct model *model, const struct table *t, struct message *message)
{
    enum { REST = 4, STIFFNESSES = 3 };
    const struct scene_binder *binder = &model->scene->binder;
    vti_fault fault;
    const int64_t count = t->rows > 0 ? t->rows : arrange_bonds(model->scene);
    model->bond_pairs = calloc((size_t)(2 * count), sizeof *model->bond_pairs);
    model->bond_memory = calloc((size_t)((REST + STIFFNESSES) * count), sizeof *model->bond_memory);
    if (model->bond_pairs == NULL || model->bond_memory == NULL)
        return out_of_memory(model, message);
    if (t->rows == 0)
        arrange_bond_pairs(model->scene, model->bond_pairs);
    else if (read_pairs(model, t, model->bond_pairs, message) != 0)
        return -1;
    if (vti_bonds_rest(count, model->bond_pairs, 0, &model->bodies.x, model->bond_memory, &fault) != VTI_OK)
        return fail_rest(model, t, fault.body, message);
    double *next = model->bond_memory + REST * count;
    vti_bonds *bonds = &model->bonds;
    bonds->count = count;
    bonds->pair = model->bond_pairs;
    bonds->rest = model->bond_memory;
    bonds->moment = stiffness(&binder->moment, t, BOND_MOMENT, &next);
    bonds->axial = stiffness(&binder->axial, t, BOND_AXIAL, &next);
    bonds->shear = stiffness(&binder->shear, t, BOND_SHEAR, &next);
    bonds->shear_form = binder->shear_form;
    const int status = vti_bonds_check(bonds, model->bodies.count, &fault);
    if (status != VTI_OK)
        return message_set(message, "%s: bond %lld: %s", model->scene->name, (long long)fault.body,
                           vti_status_text(status));
    return 0;
}

/* ---- contacts and walls ----------------------------------------------------------------------------------------------- */

/** Bonds keep their bodies out of the list, unless the scene wants contact inside them too. */
static int make_contacts(struct model *model, struct message *message)
{
    const int64_t excluded = model->scene->contact.bonded ? 0 : model->bonds.count;
    model->contacts.diameter = model->diameter;
    model->contacts.stiffness = model->scene->contact.stiffness;
    return neighbours_create(&model->neighbours, model->bodies.count, &model->diameter, 0.0, excluded,
                             model->bonds.pair, message);
}

static void make_walls(struct model *model)
{
    const struct scene_wall *wall = &model->scene->wall;
    model->walls.count = wall->planes.count;
    model->walls.plane = wall->planes.plane[0];
    model->walls.diameter = model->diameter;
    model->walls.stiffness = wall->stiffness;
}

/* ---- the array -------------------------------------------------------------------------------------------------------- */

static void add(struct model *model, vti_effect effect)
{
    model->effects[model->effects_count++] = effect;
}

int model_add_effects(struct model *model, const struct tables *tables, struct message *message)
{
    const struct scene *scene = model->scene;
    if (scene->has_binder) {
        if (make_bonds(model, &tables->bonds, message) != 0)
            return -1;
        add(model, vti_bonds_effect(&model->bonds));
    }
    if (scene->has_contact) {
        if (make_contacts(model, message) != 0)
            return -1;
        add(model, vti_contacts_effect(&model->contacts));
    }
    if (scene->has_wall) {
        make_walls(model);
        add(model, vti_walls_effect(&model->walls));
    }
    if (scene->has_gravity)
        add(model, vti_gravity_effect(&scene->gravity));
    if (scene->has_pendulum)
        add(model, vti_pendulum_effect(&scene->pendulum));
    return 0;
}
