/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hertzian contact of spheres with each other (EQUATIONS 3, E4), with o = [1 - r/L]_+. */
#include "vti_cage.h"
#include "vti_touch_table.h"
#include "../vti_ready.h"

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** d = x_i - x_j and L of pair k; returns 1 if they touch, or if a number is NaN, so that it shows. */
static inline int touch(const vti_contacts *p, const vti_bodies *b, int64_t k, double d[3], double *length, double *r2)
{
    const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
    *length = vti_contact_length(p, k, i, j);
    *r2 = vti_difference(&b->x, i, j, d);
    return !(*r2 >= *length * *length);
}

/** The list may be another one than when the effect was made. */
int vti_contacts_ready(const vti_contacts *contacts, const vti_bodies *b, int64_t reads)
{
    return VTI_LOOKS ? vti_contacts_check(contacts, vti_bodies_named(b, reads), NULL)
                     : vti_contacts_list_check(contacts);
}

static int check(const void *self, const vti_bodies *b)
{
    return vti_contacts_ready(self, b, 1 << VTI_QUANTITY_X);
}

static void apply(const void *self, const vti_bodies *b)
{
    const vti_contacts *const p = self;
    if (vti_has(&b->force) && p->count > 0)
        vti_touch_kernels_for(p->count)->press(p, b);
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_contacts *p = self;
    vti_sum sum = {0.0, 0.0};
    for (int64_t k = 0; k < p->count; ++k) {
        double d[3], length, r2;
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        if (touch(p, b, k, d, &length, &r2))
            vti_sum_add(&sum, vti_hertz_energy(vti_contact_stiffness(p, i, j, length), 1.0 - sqrt(r2) / length));
    }
    energies[0] = vti_sum_value(&sum);
}

/* ---- springs ----------------------------------------------------------------------------------------------- */

/** What may come. */
static int cages(const vti_contacts *p, const vti_bodies *b, double o, vti_spring_visit *visit, void *context)
{
    struct vti_cages cages;
    const int status = vti_cages_of(p, b, &cages);
    for (int64_t i = b->first; status == VTI_OK && b->count > 1 && i < b->first + b->count; ++i) {
        const struct vti_cage cage = vti_cage_at(&cages, i, o);
        const double stiffness = 2.0 * cage.z * vti_hertz_stiffness(cage.stiffness, o);
        const vti_spring s = {
            .element = i, .i = i, .j = -1, .length = cage.length, .axial = stiffness, .across = stiffness};
        visit(context, &s);
    }
    return status;
}

/** Pairs of the list: all at the overlap of *at, or those that touch, as they do. A push takes off from across. */
static int in_list(const vti_contacts *p, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    for (int64_t k = 0; k < p->count; ++k) {
        double d[3], length, r2;
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        if (vti_pair_check(b, i, j) != VTI_OK)
            return VTI_E_BOND;
        if (at != NULL)
            length = vti_contact_length(p, k, i, j);
        else if (!touch(p, b, k, d, &length, &r2))
            continue;
        const double o = at != NULL ? at->overlap : 1.0 - sqrt(r2) / length;
        const double stiffness = vti_contact_stiffness(p, i, j, length);
        const vti_spring s = {
            .element = k, .i = i, .j = j, .length = length, .axial = vti_hertz_stiffness(stiffness, o)};
        visit(context, &s);
    }
    return VTI_OK;
}

static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    if (at == NULL || !at->meet)
        return in_list(self, b, at, visit, context);
    return cages(self, b, at->overlap, visit, context);
}

/* ---- the effect -------------------------------------------------------------------------------------------- */

/** Whether s has number k, finite and positive; else *value is what it has there, or none where it ends before. */
static int has(const vti_scalars *s, int64_t k, double none, double *value)
{
    const int ends = vti_ends_before(s, k);
    *value = ends ? none : vti_scalar(s, k);
    return !ends && vti_is_positive(*value);
}

/** Whether pair k is one of n bodies that have what they need; else *value is what is wrong. */
static int pair_is_good(const vti_contacts *p, int64_t k, int64_t n, double *value)
{
    const int64_t *pair = p->pair + 2 * k;
    for (int side = 0; side < 2; ++side) {
        *value = (double)pair[side];
        if (!vti_is_body(pair[side], p->base, n) || pair[0] == pair[1])
            return 0;
        const int64_t i = pair[side] - p->base;
        if (!has(&p->diameter, i, *value, value))
            return 0;
        if (p->modulus.p != NULL && !has(&p->modulus, i, (double)pair[side], value))
            return 0;
    }
    return p->length.p == NULL || has(&p->length, k, (double)p->length.count, value);
}

int vti_contacts_check(const vti_contacts *contacts, int64_t n, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    const int status = contacts == NULL ? VTI_E_NULL : vti_contacts_list_check(contacts);
    if (status != VTI_OK)
        return status;
    if (n < 0)
        return VTI_E_COUNT;
    const double stiffness = contacts->stiffness;
    if (!(isfinite(stiffness) && stiffness >= 0.0) || (stiffness > 0.0 && contacts->modulus.p != NULL))
        return vti_refuse(VTI_E_CONTACT, -1, stiffness, VTI_QUANTITY_NONE, fault);
    for (int64_t k = 0; k < contacts->count; ++k) {
        double value;
        if (!pair_is_good(contacts, k, n, &value))
            return vti_refuse(VTI_E_CONTACT, k, value, VTI_QUANTITY_NONE, fault);
    }
    return VTI_OK;
}

double vti_contacts_stiffness(const vti_contacts *contacts, int64_t k)
{
    if (contacts == NULL || vti_contacts_list_check(contacts) != VTI_OK || k < 0 || k >= contacts->count)
        return NAN;
    const int64_t *const pair = contacts->pair + 2 * k, base = contacts->base;
    if (!vti_is_body(pair[0], base, INT64_MAX) || !vti_is_body(pair[1], base, INT64_MAX))
        return NAN;
    const int64_t i = pair[0] - base, j = pair[1] - base, last = i > j ? i : j;
    if (vti_ends_before(&contacts->diameter, last) || vti_ends_before(&contacts->modulus, last) ||
        vti_ends_before(&contacts->length, k))
        return NAN;
    return vti_contact_stiffness(contacts, i, j, vti_contact_length(contacts, k, i, j));
}

vti_effect vti_contacts_effect(const vti_contacts *contacts)
{
    static const char *const term[] = {"contact"};
    if (contacts == NULL || vti_contacts_list_check(contacts) != VTI_OK)
        return vti_effect_none();
    const vti_effect effect = {.name = "contact",
                               .apply = apply,
                               .energy = energy,
                               .check = check,
                               .springs = springs,
                               .self = contacts,
                               .needs = 1 << VTI_QUANTITY_X,
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .terms = 1,
                               .term = term};
    return effect;
}
