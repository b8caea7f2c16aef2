/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hertzian contact of spheres with each other (EQUATIONS 3, E4), with o = [1 - r/D]_+. */
#include "vti_hertz.h"

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** d = x_i - x_j and D of pair k; returns 1 if they touch, or if a number is NaN, so that it shows. */
static inline int touch(const vti_contacts *p, const vti_bodies *b, int64_t k, double d[3], double *length, double *r2)
{
    const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
    double xj[3];
    vti_load(&b->x, i, d);
    vti_load(&b->x, j, xj);
    for (int c = 0; c < 3; ++c)
        d[c] -= xj[c];
    *length = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
    *r2 = vti_dot(d, d);
    return !(*r2 >= *length * *length);
}

/** Whether there is a list, and diameters. */
static int list_check(const vti_contacts *p)
{
    if (p->diameter.p == NULL || (p->count > 0 && p->pair == NULL))
        return VTI_E_NULL;
    return p->count < 0 ? VTI_E_COUNT : VTI_OK;
}

/** The list may be another one than when the effect was made. */
static int check(const void *self, const vti_bodies *b)
{
    return VTI_LOOKS ? vti_contacts_check(self, vti_bodies_named(b), NULL) : list_check(self);
}

/** F_i = (K/D) o^{3/2} n = -F_j */
static void apply(const void *self, const vti_bodies *b)
{
    const vti_contacts *p = self;
    for (int64_t k = 0; vti_has(&b->force) && k < p->count; ++k) {
        double d[3], length, r2;
        if (!touch(p, b, k, d, &length, &r2))
            continue;
        const double r = sqrt(r2), inv_r = r > VTI_COINCIDENT ? 1.0 / r : 0.0;
        const double f = vti_hertz_force(p->stiffness, length, 1.0 - r / length) * inv_r;
        const double force[3] = {f * d[0], f * d[1], f * d[2]}, back[3] = {-force[0], -force[1], -force[2]};
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        if (vti_owns(b, i))
            vti_add(&b->force, i, force);
        if (vti_owns(b, j))
            vti_add(&b->force, j, back);
    }
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_contacts *p = self;
    vti_sum sum = {0.0, 0.0};
    for (int64_t k = 0; k < p->count; ++k) {
        double d[3], length, r2;
        if (touch(p, b, k, d, &length, &r2))
            vti_sum_add(&sum, vti_hertz_energy(p->stiffness, 1.0 - sqrt(r2) / length));
    }
    energies[0] = vti_sum_value(&sum);
}

/* ---- springs ----------------------------------------------------------------------------------------------- */

/** What may come (EQUATIONS 6.10): each body i in a cage of as many neighbours as have room around it, or as there are
 *  bodies, none smaller than the smallest. As |u_i - u_j|^2 <= 2 |u_i|^2 + 2 |u_j|^2, contacts are no stiffer than one
 *  spring of 2 z_i k_i that holds every body to its place (vti_cage). */
static void cages(const vti_contacts *p, const vti_bodies *b, double o, vti_spring_visit *visit, void *context)
{
    double least = INFINITY;
    for (int64_t i = b->first; i < b->first + b->count; ++i)
        least = fmin(least, vti_scalar(&p->diameter, i));
    for (int64_t i = b->first; b->count > 1 && i < b->first + b->count; ++i) {
        const double length = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * least;
        const double z = vti_cage(b->count, length - 0.5 * least, 0.5 * least, o);
        const double stiffness = 2.0 * z * vti_hertz_stiffness(p->stiffness, o);
        const vti_spring s = {.element = i, .i = i, .j = -1, .length = length, .axial = stiffness, .across = stiffness};
        visit(context, &s);
    }
}

/** Pairs of the list, all of them at the overlap of *at, or those that touch as they do. What pushes takes off across.
 *  */
static int in_list(const vti_contacts *p, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    for (int64_t k = 0; k < p->count; ++k) {
        double d[3], length, r2;
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        if (vti_pair_check(b, i, j) != VTI_OK)
            return VTI_E_BOND;
        const int touches = at != NULL || touch(p, b, k, d, &length, &r2);
        if (at != NULL)
            length = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
        const double o = at != NULL ? at->overlap : touches ? 1.0 - sqrt(r2) / length : 0.0;
        const vti_spring s = {
            .element = k, .i = i, .j = j, .length = length, .axial = vti_hertz_stiffness(p->stiffness, o)};
        if (touches)
            visit(context, &s);
    }
    return VTI_OK;
}

static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    if (at == NULL || !at->meet)
        return in_list(self, b, at, visit, context);
    cages(self, b, at->overlap, visit, context);
    return VTI_OK;
}

/* ---- the effect -------------------------------------------------------------------------------------------- */

int vti_contacts_check(const vti_contacts *contacts, int64_t n, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    const int status = contacts == NULL ? VTI_E_NULL : list_check(contacts);
    if (status != VTI_OK)
        return status;
    if (n < 0)
        return VTI_E_COUNT;
    if (!(isfinite(contacts->stiffness) && contacts->stiffness >= 0.0))
        return vti_refuse(VTI_E_CONTACT, -1, contacts->stiffness, VTI_QUANTITY_NONE, fault);
    for (int64_t k = 0; k < contacts->count; ++k)
        for (int side = 0; side < 2; ++side) {
            const int64_t *pair = contacts->pair + 2 * k, i = pair[side] - contacts->base;
            const int64_t sizes = contacts->diameter.count;
            if (i < 0 || i >= n || pair[0] == pair[1] || (sizes != 0 && i >= sizes))
                return vti_refuse(VTI_E_CONTACT, k, (double)pair[side], VTI_QUANTITY_NONE, fault);
            const double diameter = vti_scalar(&contacts->diameter, i);
            if (!(isfinite(diameter) && diameter > 0.0))
                return vti_refuse(VTI_E_CONTACT, k, diameter, VTI_QUANTITY_NONE, fault);
        }
    return VTI_OK;
}

vti_effect vti_contacts_effect(const vti_contacts *contacts)
{
    static const char *const term[] = {"contact"};
    if (contacts == NULL || list_check(contacts) != VTI_OK)
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
