/* SPDX-License-Identifier: BSD-3-Clause */
#include <stdio.h>

#include "model_parts.h"
#include "number.h"
#include "quote.h"
#include "table_csv.h"

/* ---- reading ----------------------------------------------------------------------------------------------------- */

int model_read_table(const char *path, const struct table_kind *kind, struct table *table, struct message *message)
{
    char shown[240];
    if (table_is_hdf5(path))
        return message_set(message, "%s: HDF5 tables are not read here; give a CSV file",
                           quote_tail(shown, sizeof shown, path));
    return table_csv_read(path, kind, table, message);
}

/* ---- the scene and its tables ------------------------------------------------------------------------------------ */

/** Writes "TABLE: TEXT" about the table as a whole, what being in the text. */
static int fail(const struct table *table, struct message *message, const char *format, const char *what)
{
    char text[256];
    snprintf(text, sizeof text, format, what);
    return table_fail_whole(table, message, text);
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
                  {s->density != 0.0, BODY_MASS, "bodies.density"},
                  {s->inertia != 0.0, BODY_INERTIA, "bodies.inertia"},
                  {s->moments[0] != 0.0, BODY_INERTIA, "bodies.moments"},
                  {s->moments[0] != 0.0, BODY_MOMENTS, "bodies.moments"},
                  {s->inertia != 0.0, BODY_MOMENTS, "bodies.inertia"},
                  {vti_norm(s->principal) != 0.0, BODY_PRINCIPAL, "bodies.principal"},
                  {s->clumps.given, BODY_MOMENTS, "bodies.clumps"},
                  {s->clumps.given, BODY_PRINCIPAL, "bodies.clumps"},
                  {s->diameter != 0.0, BODY_DIAMETER, "bodies.diameter"},
                  {s->clumps.given, BODY_INERTIA, "bodies.clumps"},
                  {s->clumps.given, BODY_DIAMETER, "bodies.clumps"},
                  {s->clumps.density != 0.0, BODY_MASS, "bodies.clumps.density"}};
    for (size_t k = 0; k < sizeof bodies / sizeof bodies[0]; ++k)
        if (bodies[k].in_scene && table_has(&t->bodies, bodies[k].column))
            return fail(&t->bodies, message, "gives what the scene gives as %s too; keep one of them", bodies[k].key);
    return 0;
}

/** What acts on positions; NULL if nothing does. */
static const char *needs_positions(const struct scene *s)
{
    return s->has_v ? "bodies.v" : s->random.v != 0.0 ? "bodies.random.v" : scene_first_with(s, EFFECT_TRANSLATING);
}

static int check_needs(const struct model *m, const struct tables *t, struct message *message)
{
    const struct scene *s = m->scene;
    const struct table *bodies = &t->bodies;
    const struct scene_known known =
        scene_knows(s, (struct scene_known){table_has(bodies, BODY_MASS), table_has(bodies, BODY_DIAMETER),
                                            table_has(bodies, BODY_INERTIA) || table_has(bodies, BODY_MOMENTS)});
    if (!m->translates && s->clumps.given)
        return fail(bodies, message, "no columns x, y, z; bodies.clumps needs them%s", "");
    if (!m->translates && needs_positions(s) != NULL)
        return fail(bodies, message, "no columns x, y, z; %s needs them", needs_positions(s));
    if (!m->translates && !m->turns)
        return fail(bodies, message, "nothing moves; give columns x, y, z or omega_x, omega_y, omega_z%s", "");
    if (m->translates && !known.mass)
        return fail(bodies, message, "no column mass; bodies that translate need it, or bodies.mass%s", "");
    if (s->density != 0.0 && !known.diameter)
        return fail(bodies, message, "no column diameter; bodies.density needs it, or bodies.diameter%s", "");
    if (m->turns && !known.inertia)
        return fail(bodies, message, "no column inertia; bodies that turn need it, or bodies.inertia%s", "");
    if (scene_first_with(s, EFFECT_SPHERES) != NULL && !known.diameter)
        return fail(bodies, message, "no column diameter; %s needs it, or bodies.diameter",
                    scene_first_with(s, EFFECT_SPHERES));
    return 0;
}

static int check_effects(const struct model *m, const struct tables *t, struct message *message)
{
    for (int k = 0; k < EFFECT_COUNT; ++k) {
        const struct effect_kind *kind = kinds_at(k);
        if (m->scene->has[k] && kind->check_tables != NULL &&
            kind->check_tables(m, kinds_settings_of(kind, &m->scene->settings), t, message) != 0)
            return -1;
    }
    return 0;
}

/** No material has a larger Poisson's ratio. */
static int check_material(const struct table *bodies, struct message *message)
{
    for (int64_t k = 0; table_has(bodies, BODY_POISSON) && k < bodies->rows; ++k)
        if (bodies->column[BODY_POISSON][k] > 0.5)
            return table_fail(bodies, k, message, "poisson: '%s' is above 0.5; no material has that",
                              NUMBER(bodies->column[BODY_POISSON][k]));
    return 0;
}

/** Moments that bodies can have, and axes of nothing else. */
static int check_moments(const struct scene *s, const struct table *bodies, struct message *message)
{
    if (table_has(bodies, BODY_PRINCIPAL) && !table_has(bodies, BODY_MOMENTS) && s->moments[0] == 0.0)
        return fail(bodies, message,
                    "no columns moment_a, moment_b, moment_c, whose axes principal_x, principal_y, principal_z are; "
                    "give them, or bodies.moments%s",
                    "");
    if (s->rotor != 0 && !table_has(bodies, BODY_MOMENTS) && s->moments[0] == 0.0 && !s->clumps.given)
        return fail(bodies, message,
                    "no columns moment_a, moment_b, moment_c; rotor is for such bodies, as a sphere's turn is one, of "
                    "any order: give them, or leave it out%s",
                    "");
    for (int64_t i = 0; table_has(bodies, BODY_MOMENTS) && i < bodies->rows; ++i) {
        double m[3];
        vti_bodies body = vti_bodies_none(1);
        for (int k = 0; k < 3; ++k)
            m[k] = bodies->column[BODY_MOMENTS + k][i];
        for (int k = 0; k < 3; ++k)
            if (!number_divides(m[k]))
                return table_fail(bodies, i, message,
                                  "%s: '%s' is too small to divide by; choose units in which it is larger",
                                  table_column(bodies->kind, BODY_MOMENTS + k), NUMBER(m[k]));
        body.moments = vti_view_packed(m);
        if (vti_bodies_check_values(&body, NULL) != VTI_OK)
            return table_fail(bodies, i, message,
                              "moment_a: one of %.10g, %.10g, %.10g is more than the sum of the others; no body has "
                              "such moments, give smaller ones",
                              m[0], m[1], m[2]);
    }
    return 0;
}

/** Templates that there are. */
static int check_templates(const struct scene *s, const struct table *bodies, struct message *message)
{
    const int64_t templates = scene_templates(s);
    if (!table_has(bodies, BODY_CLUMP))
        return 0;
    if (templates == 0)
        return fail(bodies, message, "has a column clump, and the scene no bodies.clumps; give both or neither%s", "");
    for (int64_t k = 0; k < bodies->rows; ++k)
        if (bodies->column[BODY_CLUMP][k] >= (double)templates)
            return table_fail(bodies, k, message, "clump: there is no template %s; bodies.clumps has %lld, from 0",
                              NUMBER(bodies->column[BODY_CLUMP][k]), (long long)templates);
    return 0;
}

int model_check_tables(struct model *model, const struct tables *tables, struct message *message)
{
    const struct scene *s = model->scene;
    const struct table *bodies = &tables->bodies;
    model->translates = s->translates || table_has(bodies, BODY_X);
    model->turns = s->turns || table_has(bodies, BODY_ALPHA) || table_has(bodies, BODY_OMEGA) ||
                   (model_loads(s, tables) & EFFECT_MOMENT) != 0;
    if (check_twice(s, tables, message) != 0 || check_material(bodies, message) != 0 ||
        check_moments(s, bodies, message) != 0 || check_templates(s, bodies, message) != 0 ||
        check_effects(model, tables, message) != 0)
        return -1;
    /* the others have all that bodies of theirs need (scene_check.c): a single one has no bonds, whose table could turn
     * it */
    return s->arrangement == SCENE_IN_TABLE ? check_needs(model, tables, message) : 0;
}
