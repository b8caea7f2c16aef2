/* SPDX-License-Identifier: BSD-3-Clause
 * The binder: elastic bonds between bodies (EQUATIONS 3). */
#include "binder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "scene_reader.h"

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

#define AT(member) offsetof(struct binder_settings, member)

static const struct scene_word times[] = {{"start", BINDER_START}, {"touching", BINDER_TOUCHING}, {NULL, 0}};
static const struct scene_word joined[] = {{"bodies", BINDER_ON_BODIES}, {"spheres", BINDER_ON_SPHERES}, {NULL, 0}};
static const struct scene_word shear_forms[] = {
    {"objective", VTI_SHEAR_OBJECTIVE}, {"quartic", VTI_SHEAR_QUARTIC}, {"printed", VTI_SHEAR_PRINTED}, {NULL, 0}};

#define LIMIT(KEY, NUMBER, ABOUT, SAYS)                                                                                \
    {                                                                                                                  \
        "binder.break." #KEY, SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(limit[NUMBER]), ABOUT, SAYS, NULL            \
    }
static const struct scene_field fields[] = {
    {"binder", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "bonds",
     "Elastic bonds between neighbours, or between the bodies of a table; at least one of moment, axial and shear.",
     NULL},
    {"binder.table", SCENE_PATH, SCENE_MAY, SCENE_ANY, AT(table), "file of bonds",
     "CSV or HDF5, relative to the scene's folder: a row for each bond, bodies i and j from 0, moment, axial, shear "
     "and limits (break_stretch ...) as far as they differ, and length, nx, ny, nz and turn_x, turn_y, turn_z, turn_w "
     "where bonds are not at rest at t = 0: the direction in the frame of body i, and a quaternion that takes vectors "
     "from the frame of j to that of i.",
     NULL},
    {"binder.on", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(on), "what bonds join",
     "bodies (without it); spheres: i and j of the table are spheres of bodies.clumps, from 0, body by body in the "
     "order of their templates, and no two of one body; bonds are then at rest as the bodies are turned at t = 0.",
     joined},
    {"binder.when", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(when), "when bonds are made",
     "start (default): at t = 0; touching: at the end of the step in which two spheres come into contact, at rest as "
     "they "
     "are then, once for each pair. Then there is no table, the contact stays inside the bond (contact.bonded: yes), "
     "and "
     "steppers with negative coefficients are refused.",
     times},
    {"binder.most", SCENE_COUNT, SCENE_MAY, SCENE_POSITIVE, AT(most), "most bonds of a body",
     "Of bonds that are made where bodies touch; without it any number.", NULL},
    {"binder.from", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, AT(from), "time of the first bonds",
     "Bonds that are made where bodies touch are made at ends of steps from this time on; pairs that touch then, "
     "included.",
     NULL},
    {"binder.until", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(until), "time of the last bonds",
     "Until this time, which is later than from; without it there is no end.", NULL},
    {"binder.moment", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(stiffness[0]), "stiffness K^m",
     "Energy: bending and torsion cost K^m/2 |theta|^2, theta being the angle between the bodies.", NULL},
    {"binder.axial", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(stiffness[1]), "stiffness K^a",
     "Energy: stretching costs K^a/2 (r/L0 - 1)^2.", NULL},
    {"binder.shear", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "shear of bonds",
     "Turning of the bond against its bodies.", NULL},
    {"binder.shear.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(stiffness[2]), "stiffness K^s",
     "Energy: small shear angles gamma cost K^s/2 gamma^2 in the objective form.", NULL},
    {"binder.shear.form", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(shear_form), "form of the shear energy",
     "objective: unchanged by turning the whole; quartic: the same with the paper's exponent; printed: as in the "
     "paper, not objective.",
     shear_forms},
    {"binder.break", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "rupture of bonds",
     "Bonds break at the end of a step where N/normal + V/shear + M_b/bending + M_t/torsion >= 1, or stretch or energy "
     "is reached; steppers with negative coefficients are refused.",
     NULL},
    LIMIT(stretch, LIMIT_STRETCH, "limit of stretch", "Of r/L0 - 1."),
    LIMIT(normal, LIMIT_NORMAL, "limit of normal force",
          "Of N = K^a/L0 (r/L0 - 1), which is negative under pressure, and then delays rupture."),
    LIMIT(shear, LIMIT_SHEAR, "limit of shear force", "Of V, the force across the bond."),
    LIMIT(bending, LIMIT_BENDING, "limit of bending moment", "Of M_b = K^m theta across the bond."),
    LIMIT(torsion, LIMIT_TORSION, "limit of torsion moment", "Of M_t = K^m theta about the bond."),
    LIMIT(energy, LIMIT_ENERGY, "limit of energy", "Of what all terms of a bond hold."),
};
#undef LIMIT

/** Limits of forces and moments, and the term that each of them is of. */
static const struct {
    const char *key, *stiffness;
    int term;
} limits[LIMITS] = {[LIMIT_NORMAL] = {"binder.break.normal", "binder.axial", BOND_AXIAL},
                    [LIMIT_SHEAR] = {"binder.break.shear", "binder.shear", BOND_SHEAR},
                    [LIMIT_BENDING] = {"binder.break.bending", "binder.moment", BOND_MOMENT},
                    [LIMIT_TORSION] = {"binder.break.torsion", "binder.moment", BOND_MOMENT}};

static void defaults(void *settings)
{
    struct binder_settings *binder = settings;
    binder->shear_form = VTI_SHEAR_OBJECTIVE;
    binder->until = INFINITY;
}

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

static int on_spheres(const union effect_settings *all)
{
    return ((const struct binder_settings *)kinds_settings_of(&effect_binder, all))->on == BINDER_ON_SPHERES;
}

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
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

/* ---- the table of bonds ------------------------------------------------------------------------------------------ */

static const struct table_column columns[] = {{"i", TABLE_INDEX},
                                              {"j", TABLE_INDEX},
                                              {"moment", TABLE_NOT_NEGATIVE},
                                              {"axial", TABLE_NOT_NEGATIVE},
                                              {"shear", TABLE_NOT_NEGATIVE},
                                              {"break_stretch", TABLE_POSITIVE},
                                              {"break_normal", TABLE_POSITIVE},
                                              {"break_shear", TABLE_POSITIVE},
                                              {"break_bending", TABLE_POSITIVE},
                                              {"break_torsion", TABLE_POSITIVE},
                                              {"break_energy", TABLE_POSITIVE},
                                              {"length", TABLE_POSITIVE},
                                              {"nx", TABLE_ANY},
                                              {"ny", TABLE_ANY},
                                              {"nz", TABLE_ANY},
                                              {"turn_x", TABLE_ANY},
                                              {"turn_y", TABLE_ANY},
                                              {"turn_z", TABLE_ANY},
                                              {"turn_w", TABLE_ANY}};

static int check_columns(const struct table *table, struct message *message)
{
    if (!table_has(table, BOND_I))
        return table_fail_columns(table, message, "no column i; bonds need i and j");
    if (!table_has(table, BOND_J))
        return table_fail_columns(table, message, "no column j; bonds need i and j");
    const int components =
        table_has(table, BOND_NORMAL) + table_has(table, BOND_NORMAL + 1) + table_has(table, BOND_NORMAL + 2);
    int turns = 0;
    for (int c = 0; c < 4; ++c)
        turns += table_has(table, BOND_TURN + c);
    if (components % 3 != 0)
        return table_fail_columns(table, message, "nx, ny and nz come together; give all three");
    return turns % 4 == 0
               ? 0
               : table_fail_columns(table, message, "turn_x, turn_y, turn_z and turn_w come together; give all four");
}

const struct table_kind binder_table = {"bonds", "the scene's table of bonds", columns,
                                        sizeof columns / sizeof columns[0], check_columns};

/** A term exists if the scene gives its stiffness or the table of bonds has it as a column. */
static int has_term(const struct binder_settings *binder, const struct table *table, int column)
{
    return binder->stiffness[column - BOND_MOMENT] != 0.0 || (table != NULL && table_has(table, column));
}

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
        if (limits[k].key != NULL && binder_has_limit(binder, table, k) && !has_term(binder, table, limits[k].term)) {
            snprintf(text, sizeof text, "bonds have no stiffness that could reach %s; give %s", name,
                     limits[k].stiffness);
            return table_fail_whole(table, message, text);
        }
    }
    return 0;
}

static int check_tables(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message)
{
    static const char *const both[] = {"gives what the scene gives as binder.moment too; keep one of them",
                                       "gives what the scene gives as binder.axial too; keep one of them",
                                       "gives what the scene gives as binder.shear too; keep one of them"};
    const struct binder_settings *binder = settings;
    const struct table *table = &tables->effect[EFFECT_binder];
    int terms = 0;
    (void)model;
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k) {
        if (binder->stiffness[k - BOND_MOMENT] != 0.0 && table_has(table, k))
            return table_fail_whole(table, message, both[k - BOND_MOMENT]);
        terms += has_term(binder, table, k);
    }
    if (table_has(table, BOND_TURN) && binder->shear_form == VTI_SHEAR_PRINTED && has_term(binder, table, BOND_SHEAR))
        return table_fail_whole(
            table, message, "the printed shear knows no turn_x, turn_y, turn_z, turn_w; give shear.form: objective");
    if (terms == 0)
        return table_fail_whole(table, message,
                                "no column moment, axial or shear; bonds need one of them, or binder.moment");
    return check_limits(binder, table, message);
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static const double any = 1.0;
    const struct binder_settings *binder = settings;
    vti_bonds bonds = {.shear_form = binder->shear_form};
    vti_scalars *const terms[] = {&bonds.moment, &bonds.axial, &bonds.shear};
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k)
        if (has_term(binder, table, k))
            *terms[k - BOND_MOMENT] = vti_scalars_one(&any);
    vti_effect effect = vti_bonds_effect(&bonds);
    effect.self = NULL;
    if (binder_may_break(binder, table) || binder->when == BINDER_TOUCHING)
        binder_add_rupture(&effect, binder_may_break(binder, table));
    return effect;
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    struct binder_self *self = effect_memory(e, sizeof *self, message);
    const int touching = ((const struct binder_settings *)e->settings)->when == BINDER_TOUCHING;
    if (self == NULL ||
        (touching ? binder_make_none(e, model, message) : binder_make_bonds(e, model, table, message)) != 0)
        return -1;
    made->self = &self->bonds;
    if (made->books > 0)
        made->booked = e->booked;
    made->by_body = e->by_body;
    return 0;
}

static void destroy(struct effect *e)
{
    struct binder_self *self = e->self;
    binder_free_breaking(&self->breaking);
    binder_free_touch(&self->touch);
    free(self->turns.pair);
    free(self->pair);
    free(self->memory);
}

/* ---- what it tells ----------------------------------------------------------------------------------------------- */

static void say(const struct effect *e, char *text, size_t size)
{
    const struct binder_self *self = e->self;
    const char *what = self->breaking.limits ? ", which may break" : "";
    if (binder_touches(self))
        snprintf(text, size, "bonds where bodies touch%s", what);
    else
        snprintf(text, size, "%lld bonds%s%s", (long long)self->bonds.count, self->body != NULL ? " of spheres" : "",
                 what);
}

static void limit(const struct effect *e, const vti_deformation *at, const vti_stable *stable, char *text, size_t size)
{
    const int64_t number = binder_number(e->self, stable->element);
    (void)at;
    if (stable->j < 0) /* of a clump, which the force on its sphere turns */
        snprintf(text, size, "pull of bonds on body %lld", (long long)stable->i);
    else
        snprintf(text, size, "bond %lld of bodies %lld and %lld", (long long)number, (long long)stable->i,
                 (long long)stable->j);
}

/** A strain s at which the axial spring has taken up the energy and what is in it now, K/2 s^2. */
static void deform(const struct effect *e, const vti_bodies *b, double energy, vti_deformation *at)
{
    const vti_bonds *p = &((const struct binder_self *)e->self)->bonds;
    double most = 0.0;
    for (int64_t k = 0; p->axial.p != NULL && k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] * b->x.stride, j = p->pair[2 * k + 1] * b->x.stride;
        const double d[3] = {b->x.c[0][i] - b->x.c[0][j], b->x.c[1][i] - b->x.c[1][j], b->x.c[2][i] - b->x.c[2][j]};
        const double now = vti_norm(d) / p->rest[4 * k + 3] - 1.0, stiffness = p->axial.p[k * p->axial.stride];
        if (stiffness > 0.0)
            most = fmax(most, now * now + 2.0 * energy / stiffness);
    }
    if (most > 1e-20) /* what rounding makes of positions is no strain */
        at->strain = fmax(at->strain, fmin(sqrt(most), 1.0));
}

/* ---- together ---------------------------------------------------------------------------------------------------- */

static const vti_bonds *bonds(const struct effect *e)
{
    return &((const struct binder_self *)e->self)->bonds;
}

static const struct effect_term terms[] = {{"binder_moment", "$U^{\\mathrm{m}}$", "bending and torsion", "#E69F00"},
                                           {"binder_axial", "$U^{\\mathrm{a}}$", "axial", "#D55E00"},
                                           {"binder_shear", "$U^{\\mathrm{s}}$", "shear", "#AA4499"},
                                           {"lost_rupture", "$Q^{\\mathrm{b}}$", "lost to rupture", "#882255"}};

const struct effect_kind effect_binder = {.number = EFFECT_binder,
                                          .key = "binder",
                                          EFFECT_FIELDS(fields),
                                          .settings = sizeof(struct binder_settings),
                                          .defaults = defaults,
                                          .check = check,
                                          .draft = draft,
                                          .table = &binder_table,
                                          .check_tables = check_tables,
                                          .on_spheres = on_spheres,
                                          .make = make,
                                          .join = binder_join,
                                          .take_part = binder_take_part,
                                          .destroy = destroy,
                                          EFFECT_TERMS(terms),
                                          .say = say,
                                          .limit = limit,
                                          .deform = deform,
                                          .lines = &binder_lines,
                                          .bonds = bonds,
                                          .watch = &binder_watch,
                                          .breaks = &binder_breaks,
                                          .memory = &binder_memory};
