/* SPDX-License-Identifier: BSD-3-Clause
 * What a scene says of bonds, and the columns of a table of them. */
#include <math.h>

#include "binder.h"
#include "scene_reader.h"

/* ---- keys -------------------------------------------------------------------------------------------------------- */

#define AT(member) offsetof(struct binder_settings, member)

static const struct scene_word times[] = {{"start", BINDER_START}, {"touching", BINDER_TOUCHING}, {NULL, 0}};
static const struct scene_word joined[] = {{"bodies", BINDER_ON_BODIES}, {"spheres", BINDER_ON_SPHERES}, {NULL, 0}};
static const struct scene_word shear_forms[] = {
    {"objective", VTI_SHEAR_OBJECTIVE}, {"quartic", VTI_SHEAR_QUARTIC}, {"printed", VTI_SHEAR_PRINTED}, {NULL, 0}};

#define LIMIT(KEY, NUMBER, ABOUT, SAYS)                                                                                \
    {                                                                                                                  \
        "binder.break." #KEY, SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(limit[NUMBER]), ABOUT, SAYS, NULL            \
    }
const struct scene_field binder_fields[BINDER_FIELDS] = {
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
     "they are then, once for each pair. Then there is no table, the contact stays inside the bond (contact.bonded: "
     "yes), and steppers with negative coefficients are refused.",
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
     "Energy: bending and torsion cost K^m/2 |theta|^2, theta being the angle between the bodies; of a beam E I/L0.",
     NULL},
    {"binder.axial", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(stiffness[1]), "stiffness K^a",
     "Energy: stretching costs K^a/2 (r/L0 - 1)^2; of a beam E A L0.", NULL},
    {"binder.shear", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "shear of bonds",
     "Turning of the bond against its bodies.", NULL},
    {"binder.shear.stiffness", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(stiffness[2]), "stiffness K^s",
     "Energy: small shear angles gamma cost K^s/2 gamma^2 in the objective form; of a beam 1/(1/(k G A L0) + L0/(12 E "
     "I)), k = 9/10 if round. Needed, unless the table has a column shear.",
     NULL},
    {"binder.shear.form", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(shear_form), "form of the shear energy",
     "objective (default): unchanged by turning the whole; quartic: the same with the paper's exponent; printed: as in "
     "the paper, not objective.",
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

void binder_defaults(void *settings)
{
    struct binder_settings *binder = settings;
    binder->until = INFINITY;
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
