/* SPDX-License-Identifier: BSD-3-Clause
 * Dashpots in bonds (EQUATIONS 6.3). */
#include <math.h>

#include "kind.h"
#include "model.h"
#include "scene_reader.h"

struct bond_dashpot_settings {
    double zeta, axial, shear, bending, twisting;
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

#define NUMBER_AT(KEY, ABOUT, SAYS)                                                                                    \
    {                                                                                                                  \
        "bond_dashpot." #KEY, SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE,                                             \
            offsetof(struct bond_dashpot_settings, KEY), ABOUT, SAYS, NULL                                             \
    }
static const struct scene_field fields[] = {
    {"bond_dashpot", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "dashpots of bonds",
     "Damps the bonds; steppers with negative coefficients are refused.", NULL},
    NUMBER_AT(zeta, "damping ratio",
              "Of each term of a bond alone, by its own stiffness; in a chain slower motions have less, about in "
              "proportion to their frequency. Adds to the coefficients below."),
    NUMBER_AT(axial, "axial coefficient", "Mass per time, along the bond."),
    NUMBER_AT(shear, "shear coefficient", "Mass per time, across the bond."),
    NUMBER_AT(bending, "bending coefficient", "Energy times time; bodies turn then."),
    NUMBER_AT(twisting, "twisting coefficient", "Energy times time; bodies turn then."),
};
#undef NUMBER_AT

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct bond_dashpot_settings *d = settings;
    if (scene_first_with(scene, EFFECT_BONDS) == NULL)
        return scene_reader_fail(reader, "bond_dashpot", "there are no bonds; give binder");
    if (!(d->zeta > 0.0 || d->axial > 0.0 || d->shear > 0.0 || d->bending > 0.0 || d->twisting > 0.0))
        return scene_reader_fail(reader, "bond_dashpot", "no coefficient above 0; give zeta");
    return 0;
}

/** As the bonds do. */
static int on_spheres(const union effect_settings *all)
{
    int on = 0;
    for (int k = 0; k < EFFECT_COUNT; ++k)
        on |= kinds_at(k)->bonds != NULL && kinds_has(kinds_at(k), all, EFFECT_ON_SPHERES);
    return on;
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static void fill(vti_bond_dashpots *dashpots, const struct bond_dashpot_settings *d, vti_sum *lost)
{
    dashpots->zeta = d->zeta;
    dashpots->axial = d->axial;
    dashpots->shear = d->shear;
    dashpots->bending = d->bending;
    dashpots->twisting = d->twisting;
    dashpots->lost = lost;
}

/** Bonds with moments turn bodies by themselves: only constants ask for it here. */
static vti_effect draft(const void *settings, const struct table *table)
{
    static vti_sum nothing[VTI_BOND_DASHPOT_BOOKS];
    static const vti_bonds none;
    const struct bond_dashpot_settings *d = settings;
    vti_bond_dashpots dashpots = {.bonds = &none};
    (void)table;
    fill(&dashpots, d, nothing);
    vti_effect effect = vti_bond_dashpots_effect(&dashpots);
    effect.gives = d->bending > 0.0 || d->twisting > 0.0 ? EFFECT_MOMENT : 0;
    effect.self = effect.booked = NULL;
    return effect;
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    vti_bond_dashpots *dashpots = effect_memory(e, sizeof *dashpots, message);
    (void)table;
    if (dashpots == NULL)
        return -1;
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (model->instances[k].kind->bonds != NULL)
            dashpots->bonds = model->instances[k].kind->bonds(&model->instances[k]);
    fill(dashpots, e->settings, e->booked);
    dashpots->by_body = e->by_body;
    *made = vti_bond_dashpots_effect(dashpots);
    made->needs &= ~(int64_t)(1 << VTI_QUANTITY_OMEGA); /* what bonds turn has it */
    made->needs |= dashpots->bending > 0.0 || dashpots->twisting > 0.0 ? 1 << VTI_QUANTITY_OMEGA : 0;
    return 0;
}

/** c/m: that of the constant, and where nothing swings any more 2 zeta sqrt(k/m) of the stiffness k. */
static double rate(double constant, double zeta, double stiffness, double per_mass)
{
    return constant * per_mass + (zeta > 1.0 ? 2.0 * zeta * sqrt(stiffness * per_mass) : 0.0);
}

static double stiffness_of(const vti_scalars *s, int64_t k)
{
    return s->p != NULL ? s->p[k * s->stride] : 0.0;
}

/** The largest c/m of a bond's motions. */
static double slowing(const struct effect *e, const struct model *model)
{
    const vti_bond_dashpots *d = e->self;
    const vti_bonds *p = d->bonds;
    const int of_spheres = on_spheres(&model->scene->settings);
    double most = 0.0;
    for (int64_t k = 0; k < p->count; ++k) {
        const double length = p->rest[4 * k + 3], square = length * length;
        double along = 0.0, across = 0.0, turning = 0.0; /* 1/m_n, 1/m_t, 1/J_r */
        for (int side = 0; side < 2; ++side) {
            const struct model_inverse_mass inverse =
                model_inverse_mass_of(model, of_spheres, p->pair[2 * k + side] - p->base);
            along += inverse.per_mass + inverse.by_turning;
            across += model_inverse_mass_at(&inverse, 0.5 * length);
            turning += inverse.per_inertia;
        }
        const double bent = fmax(d->bending, d->twisting), moment = stiffness_of(&p->moment, k);
        most = fmax(most, rate(d->axial, d->zeta, stiffness_of(&p->axial, k) / square, along));
        most = fmax(most, rate(d->shear, d->zeta, stiffness_of(&p->shear, k) / square, across));
        most = fmax(most, rate(bent, d->zeta, moment, turning));
    }
    return most;
}

static const struct effect_term terms[] = {
    {"lost_bond_axial", "$Q^{\\mathrm{ba}}$", "lost to axial dashpots", "#5533DD"},
    {"lost_bond_shear", "$Q^{\\mathrm{bs}}$", "lost to shear dashpots", "#B15928"},
    {"lost_bond_bending", "$Q^{\\mathrm{bb}}$", "lost to bending dashpots", "#88CCEE"},
    {"lost_bond_twisting", "$Q^{\\mathrm{bw}}$", "lost to torsion dashpots", "#66A61E"}};

const struct effect_kind effect_bond_dashpot = {.number = EFFECT_bond_dashpot,
                                                .key = "bond_dashpot",
                                                EFFECT_FIELDS(fields),
                                                .settings = sizeof(struct bond_dashpot_settings),
                                                .check = check,
                                                .draft = draft,
                                                .on_spheres = on_spheres,
                                                .make = make,
                                                .slowing = slowing,
                                                EFFECT_TERMS(terms)};
