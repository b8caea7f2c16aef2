/* SPDX-License-Identifier: BSD-3-Clause
 * Selects the bond kernels for the processor and defines vti_bonds_effect. */
#include <string.h>

#include "vti_binder_table.h"
#include "../vti_ready.h"

/* ---- the kernels ------------------------------------------------------------------------------------------------- */

/** The widest kernels of this machine whose lanes so many bonds fill. */
static const struct bond_kernels *kernels(int64_t count)
{
    (void)count;
#ifdef VTI_HAS_AVX512
    if (count >= 32 && vti_serves_avx512()) /* what does not fill eight lanes costs as much as what does */
        return &vti_binder_avx512;
#endif
#ifdef VTI_HAS_AVX2
    if (count > 2 && vti_serves_avx2())
        return &vti_binder_avx2;
#endif
    return &vti_binder_baseline;
}

/** 0 without shear. An unknown form counts as the objective one here; check refuses it. */
static int form_of(const vti_bonds *bonds)
{
    return bonds->shear.p == NULL ? 0 : vti_bonds_form_is_known(bonds) ? (int)bonds->shear_form : VTI_SHEAR_OBJECTIVE;
}

static int terms_of(const vti_bonds *bonds)
{
    return (bonds->moment.p != NULL ? TERM_MOMENT : 0) | (bonds->axial.p != NULL ? TERM_AXIAL : 0) |
           (bonds->shear.p != NULL ? TERM_SHEAR : 0);
}

static const struct bond_kernel *kernel_of(const struct bond_kernels *kernels, const vti_bonds *bonds)
{
    return &kernels->of[form_of(bonds)][terms_of(bonds) & (TERM_MOMENT | TERM_AXIAL)];
}

/** How loads are to be evaluated of bodies that lie so. */
static enum layout loads_layout(int terms, const vti_bonds *bonds, enum layout layout)
{
    return bonds->turn != NULL && terms & (TERM_MOMENT | TERM_SHEAR) ? TURNED : layout;
}

/** Of all that the terms read and write. */
static enum layout layout_of(int terms, const vti_bodies *b)
{
    const int turns = terms & (TERM_MOMENT | TERM_SHEAR), pulls = terms & (TERM_AXIAL | TERM_SHEAR);
    const vti_view *const all[] = {pulls ? &b->x : NULL, pulls ? &b->force : NULL, turns ? &b->moment : NULL,
                                   turns ? &b->alpha : NULL};
    const vti_quat_view *q = &b->quat;
    for (int k = 0; k < 4; ++k)
        if (all[k] != NULL && vti_has(all[k]) && !vti_is_packed(all[k]))
            return ANY;
    if (!turns || vti_has(&b->alpha))
        return ALPHA;
    const int side_by_side =
        q->xyzw[1] == q->xyzw[0] + 1 && q->xyzw[2] == q->xyzw[0] + 2 && q->xyzw[3] == q->xyzw[0] + 3;
    return q->stride == 4 && side_by_side ? QUAT : ANY;
}

vti_bonds vti_bonds_filled(const vti_bonds *bonds, int64_t first, int64_t last, int64_t width,
                           struct vti_few_bonds *few)
{
    vti_bonds block = *bonds;
    vti_scalars *const all[TERMS] = {&block.moment, &block.axial, &block.shear};
    for (int64_t l = 0; l < width; ++l) {
        const int64_t k = first + l < last ? first + l : last - 1;
        memcpy(few->pair + 2 * l, bonds->pair + 2 * k, 2 * sizeof *few->pair);
        memcpy(few->rest + 4 * l, bonds->rest + 4 * k, 4 * sizeof *few->rest);
        if (bonds->turn != NULL)
            memcpy(few->turn + 4 * l, bonds->turn + 4 * k, 4 * sizeof *few->turn);
        for (int c = 0; c < TERMS; ++c)
            few->stiffness[c][l] = all[c]->p != NULL ? vti_scalar(all[c], k) : 0.0;
    }
    block.pair = few->pair;
    block.rest = few->rest;
    block.turn = bonds->turn != NULL ? few->turn : NULL;
    for (int c = 0; c < TERMS; ++c)
        if (all[c]->p != NULL)
            *all[c] = (vti_scalars){few->stiffness[c], 1, width};
    return block;
}

/** Bonds that are evaluated before they are summed: their rows stay in the first-level cache. Behind a chain that ends
 *  there may soon be another one. */
enum { TILE = 64, TILE_BEHIND_CHAIN = 8 };

static void apply(const void *self, const vti_bodies *b)
{
    const vti_bonds *bonds = self;
    const struct bond_kernels *all = kernels(bonds->count);
    const struct bond_kernel *kernel = kernel_of(all, bonds);
    const int terms = terms_of(bonds);
    const enum layout layout = layout_of(terms, b), evaluated = loads_layout(terms, bonds, layout);
    double rows[TILE * VTI_BOND_LOADS];
    for (int64_t first = 0, last; first < bonds->count; first = last) {
        const int64_t begin = first;
        if (evaluated == ALPHA)
            first = kernel->chain(bonds, b, first, bonds->count);
        const int64_t tile = first > begin ? TILE_BEHIND_CHAIN : TILE;
        last = bonds->count - first < tile ? bonds->count : first + tile;
        kernel->loads[evaluated](bonds, b, first, last, rows);
        all->sum[layout == ANY](terms, bonds, b, first, last, rows);
    }
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_bonds *bonds = self;
    kernel_of(kernels(bonds->count), bonds)->energy(bonds, b, energies);
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

/** What the terms of bonds read of their bodies. */
static int64_t needs_of(const vti_bonds *p)
{
    const int64_t pulls = p->axial.p != NULL || p->shear.p != NULL, turns = p->moment.p != NULL || p->shear.p != NULL;
    return pulls << VTI_QUANTITY_X | turns << VTI_QUANTITY_ALPHA;
}

/** The list may be another one than when the effect was made. */
int vti_bonds_ready(const vti_bonds *p, const vti_bodies *b, int64_t reads)
{
    if (p->count <= 0)
        return p->count < 0 ? VTI_E_COUNT : VTI_OK;
    if (!vti_bonds_has_list(p))
        return VTI_E_NULL;
    if (VTI_LOOKS)
        return vti_bonds_check(p, vti_bodies_named(b, reads | needs_of(p)), NULL);
    return p->shear.p != NULL && !vti_bonds_form_is_known(p) ? VTI_E_BOND : VTI_OK;
}

/** The terms may be others too: what the effect needs was said of those that it had. */
static int check(const void *self, const vti_bodies *b)
{
    const int64_t lacks =
        (vti_has(&b->x) ? 0 : 1 << VTI_QUANTITY_X) | (vti_has_attitude(b) ? 0 : 1 << VTI_QUANTITY_ALPHA);
    return (needs_of(self) & lacks) != 0 ? VTI_E_NEEDS : vti_bonds_ready(self, b, 0);
}

/** r of bond k over L0 where the bodies are; 1 if it does not matter. */
static double ratio_now(const vti_bonds *p, int64_t k, const vti_bodies *b)
{
    double d[3];
    if (p->axial.p == NULL && p->shear.p == NULL)
        return 1.0;
    (void)vti_difference(&b->x, p->pair[2 * k] - p->base, p->pair[2 * k + 1] - p->base, d);
    return vti_norm(d) / p->rest[4 * k + 3];
}

static double stiffness_or_none(const vti_scalars *s, int64_t k)
{
    return s->p != NULL ? vti_scalar(s, k) : 0.0;
}

/** Bond k where it is shorter than L0 by the ratio, under a pull of K^a/L0 pull/(1 - pull). Not bent, it has K^a/L0^2
 *  along n at any r; across it K^s/r^2, of which |n - mh| turns with the bodies, and U'(r)/r = K^a/L0^2 pull; K^m
 *  against turning apart. A push would take off across, and is left out.
 *
 *  Shear with an exponent of 4 has no stiffness at rest. Bent by 60 degrees it has K^s, at most it has 9/8 K^s: it
 *  counts as K^s. As printed it is n against R_j^T R_i n0 that bends, with arms of 1 and -1. */
static vti_spring spring(const vti_bonds *p, int64_t k, double ratio, double pull)
{
    const double axial = stiffness_or_none(&p->axial, k), shear = stiffness_or_none(&p->shear, k);
    const double moment = stiffness_or_none(&p->moment, k);
    const double q = shear != 0.0 ? ratio : 1.0; /* of lengths only shear depends */
    const int printed = p->shear_form == VTI_SHEAR_PRINTED;
    const vti_spring s = {.element = k,
                          .i = p->pair[2 * k] - p->base,
                          .j = p->pair[2 * k + 1] - p->base,
                          .length = q * p->rest[4 * k + 3],
                          .axial = axial * q * q,
                          .across = axial * pull * q * q,
                          .shear = shear,
                          .arm_i = printed ? 1.0 : 0.5,
                          .arm_j = printed ? -1.0 : 0.5,
                          .bend = moment,
                          .twist = moment};
    return s;
}

/** While strained by up to e, a bond is as stiff as at (1 - e) L0, and as pulled as at (1 + e) L0. */
static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_bonds *p = self;
    const double e = at == NULL ? 0.0 : at->strain >= 0.0 ? at->strain : NAN;
    for (int64_t k = 0; k < p->count; ++k) {
        if (vti_pair_check(b, p->pair[2 * k] - p->base, p->pair[2 * k + 1] - p->base) != VTI_OK)
            return VTI_E_BOND;
        const double now = at == NULL ? ratio_now(p, k, b) : 1.0;
        const vti_spring s = at == NULL ? spring(p, k, now, now <= 1.0 ? 0.0 : 1.0 - 1.0 / now)
                                        : spring(p, k, e >= 1.0 ? 0.0 : 1.0 - e, e / (1.0 + e));
        visit(context, &s);
    }
    return p->count < 0 ? VTI_E_COUNT : VTI_OK;
}

vti_effect vti_bonds_effect(const vti_bonds *bonds)
{
    if (bonds == NULL || !vti_bonds_has_list(bonds))
        return vti_effect_none();
    static const char moment[] = "binder_moment", axial[] = "binder_axial", shear[] = "binder_shear";
    static const char *const names[8][TERMS] = {{NULL},  {moment},        {axial},        {moment, axial},
                                                {shear}, {moment, shear}, {axial, shear}, {moment, axial, shear}};
    const int has_moment = bonds->moment.p != NULL, has_axial = bonds->axial.p != NULL,
              has_shear = bonds->shear.p != NULL;
    const int pulls = has_axial || has_shear, turns = has_moment || has_shear;
    const int form = form_of(bonds);
    /* as printed, total angular momentum is not conserved but sum J Omega is; objective, it is the other way round */
    const int64_t breaks = form == VTI_SHEAR_PRINTED ? VTI_BREAKS_ANGULAR : form != 0 ? VTI_BREAKS_SPINS : 0;
    const vti_effect effect = {.name = "binder",
                               .apply = apply,
                               .energy = energy,
                               .check = check,
                               .springs = springs,
                               .self = bonds,
                               .needs = needs_of(bonds),
                               .gives = pulls << VTI_QUANTITY_FORCE | turns << VTI_QUANTITY_MOMENT,
                               .smooth = 1,
                               .terms = has_moment + has_axial + has_shear,
                               .term = names[has_moment + 2 * has_axial + 4 * has_shear],
                               .breaks = breaks};
    return effect;
}

/* ---- the two passes of threads ----------------------------------------------------------------------------------- */

static int pass_check(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last, const double *loads)
{
    if (bonds == NULL || b == NULL || !vti_bonds_has_list(bonds) || (last > first && loads == NULL))
        return VTI_E_NULL;
    if (first < 0 || first > last || last > bonds->count)
        return VTI_E_COUNT;
    const int terms = terms_of(bonds);
    if (terms & TERM_SHEAR && !vti_bonds_form_is_known(bonds))
        return VTI_E_BOND;
    const int status = vti_bodies_ready(b);
    const int lacks = first < last && ((terms & (TERM_AXIAL | TERM_SHEAR) && !vti_has(&b->x)) ||
                                       (terms & (TERM_MOMENT | TERM_SHEAR) && !vti_has_attitude(b)));
    return status != VTI_OK ? status : lacks ? VTI_E_NEEDS : VTI_OK;
}

int vti_bonds_loads(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last, double *loads)
{
    const int status = pass_check(bonds, b, first, last, loads);
    if (status != VTI_OK || first == last)
        return status;
    if (VTI_LOOKS && vti_bonds_ready(bonds, b, 0) != VTI_OK)
        return VTI_E_BOND;
    const int terms = terms_of(bonds);
    const enum layout layout = loads_layout(terms, bonds, layout_of(terms, b));
    kernel_of(kernels(bonds->count), bonds)->loads[layout](bonds, b, first, last, loads);
    return VTI_OK;
}

int vti_bonds_sum(const vti_bonds *bonds, const double *loads, int64_t first, int64_t last, const vti_bodies *b)
{
    const int status = pass_check(bonds, b, first, last, loads);
    if (status != VTI_OK || first == last)
        return status;
    const int terms = terms_of(bonds);
    kernels(bonds->count)->sum[layout_of(terms, b) == ANY](terms, bonds, b, first, last, loads);
    return VTI_OK;
}

/* ---- what bonds hold --------------------------------------------------------------------------------------------- */

int vti_bonds_measure(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last, double *measures)
{
    const int status = pass_check(bonds, b, first, last, measures);
    if (status != VTI_OK || first == last)
        return status;
    if (!vti_has(&b->x))
        return VTI_E_NEEDS;
    if (VTI_LOOKS && vti_bonds_ready(bonds, b, 1 << VTI_QUANTITY_X) != VTI_OK)
        return VTI_E_BOND;
    kernels(bonds->count)->measure(terms_of(bonds), form_of(bonds), bonds, b, first, last, measures);
    return VTI_OK;
}
