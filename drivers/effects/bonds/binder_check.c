/* SPDX-License-Identifier: BSD-3-Clause
 * Which bonds there cannot be: what no single key says, and no single column. */
#include <stdio.h>

#include "binder.h"
#include "scene_reader.h"

/** Limits of forces and moments, and the term that each of them is of. */
static const struct {
    const char *key, *stiffness;
    int term;
} limits[LIMITS] = {[LIMIT_NORMAL] = {"binder.break.normal", "binder.axial", BOND_AXIAL},
                    [LIMIT_SHEAR] = {"binder.break.shear", "binder.shear", BOND_SHEAR},
                    [LIMIT_BENDING] = {"binder.break.bending", "binder.moment", BOND_MOMENT},
                    [LIMIT_TORSION] = {"binder.break.torsion", "binder.moment", BOND_MOMENT}};

/** Whether bodies that are bonded are in contact, too: 1, 0, or -1 if there is no contact. */
static int bonded_contact(const struct scene *scene)
{
    int found = -1;
    for (int k = 0; k < EFFECT_COUNT; ++k) {
        const struct effect_kind *kind = kinds_at(k);
        const struct effect e = {.kind = kind, .settings = kinds_settings_of(kind, &scene->settings)};
        if (scene->has[k] && kind->touching != NULL)
            found = kind->touching(&e) == EFFECT_TOUCH_ALL;
    }
    return found;
}

/** Bonds of touching bodies hold no energy when they are made, and so take nothing out of the contact, which stays. */
static int check_touching(const struct scene_reader *reader, const struct scene *scene,
                          const struct binder_settings *binder)
{
    const int contact = bonded_contact(scene);
    if (binder->table[0] != '\0')
        return scene_reader_fail(reader, "binder.table",
                                 "bonds that are made where bodies touch are in no table; remove it");
    if (contact != 1)
        return scene_reader_fail(reader, "binder.when",
                                 "bonds that are made where bodies touch need their contact; give %s",
                                 contact < 0 ? "contact" : "contact.bonded: yes");
    if (binder->stiffness[2] != 0.0 && binder->shear_form == VTI_SHEAR_PRINTED)
        return scene_reader_fail(reader, "binder.shear.form",
                                 "the printed shear knows bonds of t = 0 only; give objective or quartic");
    return 0;
}

int binder_check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct binder_settings *binder = settings;
    const int touching = binder->when == BINDER_TOUCHING;
    if (binder->on == BINDER_ON_SPHERES && !scene->clumps.given)
        return scene_reader_fail(reader, "binder.on", "there are no clumps; give bodies.clumps, or leave it out");
    if (binder->on == BINDER_ON_SPHERES && binder->table[0] == '\0')
        return scene_reader_fail(reader, "binder.on", "spheres have no neighbours; give table, a file of their bonds");
    if (binder->on == BINDER_ON_SPHERES && binder->shear_form == VTI_SHEAR_PRINTED)
        return scene_reader_fail(reader, "binder.shear.form",
                                 "the printed shear knows bonds of bodies only; give objective or quartic");
    if (touching && check_touching(reader, scene, binder) != 0)
        return -1;
    if (!touching && binder->most != 0)
        return scene_reader_fail(reader, "binder.most", "all bonds are made at t = 0; give when: touching");
    for (int k = 0; k < 2 && !touching; ++k)
        if (scene_reader_has(reader, k ? "binder.until" : "binder.from"))
            return scene_reader_fail(reader, k ? "binder.until" : "binder.from",
                                     "all bonds are made at t = 0; give when: touching");
    if (!(binder->from < binder->until))
        return scene_reader_fail(reader, "binder.until", "is not later than from, %.17g; give a later time",
                                 binder->from);
    const int has_table = binder->table[0] != '\0', in_table = scene->arrangement == SCENE_IN_TABLE;
    if (!touching && in_table && !has_table)
        return scene_reader_fail(reader, "binder", "bodies of a table have no neighbours; give table, a file of bonds");
    if (!touching && !in_table && scene_bodies(scene) < 2)
        return scene_reader_fail(reader, "binder",
                                 "a single body has no bonds; give bodies.ring, chain, lattice or table");
    if (scene_reader_has(reader, "binder.shear") && binder->stiffness[2] == 0.0 &&
        (!has_table || binder->shear_form == 0))
        return scene_reader_fail(reader, "binder.shear.stiffness", "missing; add 'stiffness:', the stiffness K^s");
    if (!has_table && binder->stiffness[0] == 0.0 && binder->stiffness[1] == 0.0 && binder->stiffness[2] == 0.0)
        return scene_reader_fail(reader, "binder", "no stiffness; give moment, axial or shear");
    if (scene_reader_has(reader, "binder.break") && !binder_may_break(binder, NULL))
        return scene_reader_fail(reader, "binder.break",
                                 "no limit; give stretch, normal, shear, bending, torsion or energy");
    for (int k = LIMIT_NORMAL; k <= LIMIT_TORSION && !has_table; ++k)
        if (binder->limit[k] != 0.0 && binder->stiffness[limits[k].term - BOND_MOMENT] == 0.0)
            return scene_reader_fail(reader, limits[k].key, "bonds have no stiffness that could reach it; give %s",
                                     limits[k].stiffness);
    return 0;
}

/* ---- with the table of bonds ------------------------------------------------------------------------------------- */

/** No limit has two sources, or none that could reach it. */
static int check_limits(const struct binder_settings *binder, const struct table *table, struct message *message)
{
    char text[160];
    for (int k = 0; k < LIMITS; ++k) {
        const char *name = table_column(&binder_table, BOND_LIMITS + k);
        if (binder->limit[k] != 0.0 && table_has(table, BOND_LIMITS + k)) {
            snprintf(text, sizeof text, "gives %s, which the scene gives in binder.break too; keep one of them", name);
            return table_fail_whole(table, message, text);
        }
        if (limits[k].key != NULL && binder_has_limit(binder, table, k) &&
            !binder_has_term(binder, table, limits[k].term)) {
            snprintf(text, sizeof text, "bonds have no stiffness that could reach %s; give %s", name,
                     limits[k].stiffness);
            return table_fail_whole(table, message, text);
        }
    }
    return 0;
}

/** A bond without stiffness would do nothing but keep its bodies from touching each other. */
static int check_rows(const struct binder_settings *binder, const struct table *table, struct message *message)
{
    for (int64_t row = 0; row < table->rows; ++row) {
        double all = 0.0;
        for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k)
            all += table_has(table, k) ? table->column[k][row] : binder->stiffness[k - BOND_MOMENT];
        if (all == 0.0)
            return table_fail(table, row, message, "no stiffness; give this bond one, or leave it out");
    }
    return 0;
}

int binder_check_tables(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message)
{
    static const char *const both[] = {"gives moment, which the scene gives as binder.moment too; keep one of them",
                                       "gives axial, which the scene gives as binder.axial too; keep one of them",
                                       "gives shear, which the scene gives as binder.shear too; keep one of them"};
    const struct binder_settings *binder = settings;
    const struct table *table = &tables->effect[EFFECT_binder];
    int terms = 0;
    (void)model;
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k) {
        if (binder->stiffness[k - BOND_MOMENT] != 0.0 && table_has(table, k))
            return table_fail_whole(table, message, both[k - BOND_MOMENT]);
        terms += binder_has_term(binder, table, k);
    }
    if (table_has(table, BOND_TURN) && binder->shear_form == VTI_SHEAR_PRINTED &&
        binder_has_term(binder, table, BOND_SHEAR))
        return table_fail_whole(
            table, message, "the printed shear knows no turn_x, turn_y, turn_z, turn_w; give shear.form: objective");
    if (binder->shear_form != 0 && !binder_has_term(binder, table, BOND_SHEAR))
        return table_fail_whole(table, message,
                                "no column shear, of which the scene gives binder.shear.form; give that column, or "
                                "binder.shear.stiffness");
    if (terms == 0)
        return table_fail_whole(table, message,
                                "no column moment, axial or shear; bonds need one of them, or binder.moment");
    return check_rows(binder, table, message) != 0 ? -1 : check_limits(binder, table, message);
}
