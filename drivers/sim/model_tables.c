/* SPDX-License-Identifier: BSD-3-Clause */
#include <stdio.h>

#include "model_parts.h"
#include "quote.h"
#include "table_csv.h"

/* ---- reading ---------------------------------------------------------------------------------------------------------- */

static int read_one(const char *path, enum table_kind kind, struct table *table, struct message *message)
{
    char shown[240];
    table_start(table, kind, path);
    if (path[0] == '\0')
        return 0;
    if (table_is_hdf5(path))
        return message_set(message, "%s: HDF5 tables are not read here; give a CSV file",
                           quote_tail(shown, sizeof shown, path));
    return table_csv_read(path, kind, table, message);
}

int model_read_tables(const struct scene *scene, struct tables *own, struct message *message)
{
    table_start(&own->bonds, TABLE_BONDS, "");
    if (read_one(scene->table, TABLE_BODIES, &own->bodies, message) != 0)
        return -1;
    return read_one(scene->binder.table, TABLE_BONDS, &own->bonds, message);
}

/* ---- the scene and its tables ----------------------------------------------------------------------------------------- */

static double binder_stiffness(const struct scene *scene, int k)
{
    return k == BOND_MOMENT ? scene->binder.moment : k == BOND_AXIAL ? scene->binder.axial : scene->binder.shear;
}

int model_has_term(const struct scene *scene, const struct tables *tables, int k)
{
    return scene->has_binder && (binder_stiffness(scene, k) != 0.0 || table_has(&tables->bonds, k));
}

/** Writes "TABLE: TEXT" about the table as a whole. */
static int fail(const struct table *table, struct message *message, const char *format, const char *what)
{
    char path[240], text[256];
    snprintf(text, sizeof text, format, what);
    return message_set(message, "%s: %s", quote_tail(path, sizeof path, table->path), text);
}

/** No quantity has two sources. */
static int check_twice(const struct scene *s, const struct tables *t, struct message *message)
{
    const struct {
        int in_scene, column;
        const char *key;
    } bodies[] = {{s->has_v, BODY_V, "bodies.v"},
                  {s->has_alpha, BODY_ALPHA, "bodies.alpha"},
                  {s->has_omega, BODY_OMEGA, "bodies.omega"},
                  {s->mass != 0.0, BODY_MASS, "bodies.mass"},
                  {s->inertia != 0.0, BODY_INERTIA, "bodies.inertia"},
                  {s->diameter != 0.0, BODY_DIAMETER, "bodies.diameter"}};
    static const char *const bonds[] = {"binder.moment", "binder.axial", "binder.shear"};
    for (size_t k = 0; k < sizeof bodies / sizeof bodies[0]; ++k)
        if (bodies[k].in_scene && table_has(&t->bodies, bodies[k].column))
            return fail(&t->bodies, message, "gives what the scene gives as %s too; keep one of them", bodies[k].key);
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k)
        if (binder_stiffness(s, k) != 0.0 && table_has(&t->bonds, k))
            return fail(&t->bonds, message, "gives what the scene gives as %s too; keep one of them",
                        bonds[k - BOND_MOMENT]);
    return 0;
}

/** What acts on positions; NULL if nothing does. */
static const char *needs_positions(const struct scene *s)
{
    return s->has_v             ? "bodies.v"
           : s->random.v != 0.0 ? "bodies.random.v"
           : s->has_binder      ? "binder"
           : s->has_contact     ? "contact"
           : s->has_wall        ? "wall"
           : s->has_gravity     ? "gravity"
                                : NULL;
}

static int check_needs(const struct model *m, const struct tables *t, struct message *message)
{
    const struct scene *s = m->scene;
    const struct table *bodies = &t->bodies;
    const int has_mass = s->mass != 0.0 || table_has(bodies, BODY_MASS);
    const int has_diameter = s->diameter != 0.0 || table_has(bodies, BODY_DIAMETER);
    const int has_inertia = s->inertia != 0.0 || table_has(bodies, BODY_INERTIA) || (has_mass && has_diameter);
    if (!m->translates && needs_positions(s) != NULL)
        return fail(bodies, message, "no columns x, y, z; %s needs them", needs_positions(s));
    if (m->translates && s->has_pendulum)
        return fail(bodies, message, "%s; a pendulum hangs bodies on fixed pivots, where they cannot translate",
                    "has columns x, y, z");
    if (!m->translates && !m->turns)
        return fail(bodies, message, "nothing moves; give columns x, y, z or omega_x, omega_y, omega_z%s", "");
    if (m->translates && !has_mass)
        return fail(bodies, message, "no column mass; bodies that translate need it, or bodies.mass%s", "");
    if (m->turns && !has_inertia)
        return fail(bodies, message, "no column inertia; bodies that turn need it, or bodies.inertia%s", "");
    if ((s->has_contact || s->has_wall) && !has_diameter)
        return fail(bodies, message, "no column diameter; %s needs it, or bodies.diameter",
                    s->has_contact ? "contact" : "wall");
    return 0;
}

static int check_terms(const struct scene *s, const struct tables *t, struct message *message)
{
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k)
        if (!s->has_binder || model_has_term(s, t, k))
            return 0;
    return fail(&t->bonds, message, "no column moment, axial or shear%s; bonds need one of them, or binder.moment", "");
}

int model_check_tables(struct model *model, const struct tables *tables, struct message *message)
{
    const struct scene *s = model->scene;
    const struct table *bodies = &tables->bodies;
    model->translates = s->translates || table_has(bodies, BODY_X);
    model->turns = s->turns || table_has(bodies, BODY_ALPHA) || table_has(bodies, BODY_OMEGA) ||
                   model_has_term(s, tables, BOND_MOMENT) || model_has_term(s, tables, BOND_SHEAR);
    if (check_twice(s, tables, message) != 0 || check_terms(s, tables, message) != 0)
        return -1;
    if (s->arrangement == SCENE_IN_TABLE)
        return check_needs(model, tables, message);
    if (model->turns && s->inertia == 0.0 &&
        s->mass == 0.0) /* only a table of bonds can turn what the scene does not */
        return fail(&tables->bonds, message, "its bonds turn bodies, which need %s", "bodies.inertia");
    return 0;
}
