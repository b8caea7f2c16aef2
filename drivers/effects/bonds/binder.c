/* SPDX-License-Identifier: BSD-3-Clause
 * The binder: elastic bonds between bodies (EQUATIONS 3). */
#include "binder.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "number.h"

/* ---- what it does ------------------------------------------------------------------------------------------------ */

int binder_has_term(const struct binder_settings *binder, const struct table *table, int column)
{
    return binder->stiffness[column - BOND_MOMENT] != 0.0 || (table != NULL && table_has(table, column));
}

static vti_effect draft(const void *settings, const struct table *table)
{
    static const double any = 1.0;
    const struct binder_settings *binder = settings;
    vti_bonds bonds = {.shear_form = binder_shear(binder)};
    vti_scalars *const terms[] = {&bonds.moment, &bonds.axial, &bonds.shear};
    for (int k = BOND_MOMENT; k <= BOND_SHEAR; ++k)
        if (binder_has_term(binder, table, k))
            *terms[k - BOND_MOMENT] = vti_scalars_one(&any);
    vti_effect effect = vti_bonds_effect(&bonds);
    effect.self = NULL;
    if (binder_may_break(binder, table) || binder->when == BINDER_TOUCHING)
        binder_add_rupture(&effect, binder_may_break(binder, table));
    return effect;
}

static int on_spheres(const union effect_settings *all)
{
    return ((const struct binder_settings *)kinds_settings_of(&effect_binder, all))->on == BINDER_ON_SPHERES;
}

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
        snprintf(text, size, "%lld bond%s%s%s", (long long)self->bonds.count, self->bonds.count == 1 ? "" : "s",
                 self->body != NULL ? " of spheres" : "", what);
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

/** How far bond k is stretched now, as a share of its length, and its axial stiffness K; 0 without. */
static double strain_of(const vti_bonds *p, const vti_bodies *b, int64_t k, double *stiffness)
{
    const int64_t i = p->pair[2 * k] * b->x.stride, j = p->pair[2 * k + 1] * b->x.stride;
    const double d[3] = {b->x.c[0][i] - b->x.c[0][j], b->x.c[1][i] - b->x.c[1][j], b->x.c[2][i] - b->x.c[2][j]};
    *stiffness = p->axial.p != NULL ? p->axial.p[k * p->axial.stride] : 0.0;
    return vti_norm(d) / p->rest[4 * k + 3] - 1.0;
}

static const double rounding = 1e-20; /* of strains squared: what it makes of positions is none */

/** A strain s at which the axial spring has taken up the energy and what is in it now, K/2 s^2. */
static void deform(const struct effect *e, const vti_bodies *b, double energy, vti_deformation *at)
{
    const vti_bonds *p = &((const struct binder_self *)e->self)->bonds;
    double most = 0.0, stiffness;
    for (int64_t k = 0; k < p->count; ++k) {
        const double now = strain_of(p, b, k, &stiffness);
        if (stiffness > 0.0)
            most = fmax(most, now * now + 2.0 * energy / stiffness);
    }
    if (most > rounding)
        at->strain = fmax(at->strain, fmin(sqrt(most), 1.0));
}

/** That of the axial spring. */
static double held(const struct effect *e, const vti_bodies *b)
{
    const vti_bonds *p = &((const struct binder_self *)e->self)->bonds;
    double most = 0.0, stiffness;
    for (int64_t k = 0; k < p->count; ++k) {
        const double now = strain_of(p, b, k, &stiffness);
        most = fmax(most, now * now > rounding ? 0.5 * stiffness * now * now : 0.0);
    }
    return most;
}

/** A time that the run does not reach: it may be meant for a longer one. */
static void note(const struct effect *e, const struct model *model, char *text, size_t size)
{
    const struct binder_settings *binder = e->settings;
    const double t_end = model->scene->t_end;
    if (binder->when == BINDER_TOUCHING && binder->from > t_end * (1.0 + 4.0 * DBL_EPSILON))
        snprintf(
            text, size,
            "binder.from: %s is later than t_end, %s, so that no bond is made; give an earlier time, or a later t_end",
            NUMBER(binder->from), NUMBER(t_end));
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
                                          EFFECT_FIELDS(binder_fields),
                                          .settings = sizeof(struct binder_settings),
                                          .defaults = binder_defaults,
                                          .check = binder_check,
                                          .draft = draft,
                                          .table = &binder_table,
                                          .check_tables = binder_check_tables,
                                          .on_spheres = on_spheres,
                                          .make = make,
                                          .join = binder_join,
                                          .take_part = binder_take_part,
                                          .destroy = destroy,
                                          EFFECT_TERMS(terms),
                                          .say = say,
                                          .note = note,
                                          .limit = limit,
                                          .deform = deform,
                                          .held = held,
                                          .lines = &binder_lines,
                                          .bonds = bonds,
                                          .watch = &binder_watch,
                                          .breaks = &binder_breaks,
                                          .memory = &binder_memory};
