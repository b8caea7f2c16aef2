/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rupture of bonds (EQUATIONS 6.7): all are tested on the same state, and
 *
 *     N/N_c + V/V_c + M_b/M_bc + M_t/M_tc >= 1   or   r/L0 - 1 >= e_c   or   U >= U_c:   Lost += U, bond off
 *
 * A bond that breaks leaves the list, so that no loop over the list has to test for it. */
#include "../vti_shares.h"
#include "../vti_ready.h"

enum { LIMITS = 6, TERMS = 3 };

/** In the order of vti_bond_measure. */
static void limits_of(const vti_rupture *p, const vti_scalars *limit[LIMITS])
{
    limit[VTI_BOND_NORMAL] = &p->normal;
    limit[VTI_BOND_ACROSS] = &p->shear;
    limit[VTI_BOND_BENDING] = &p->bending;
    limit[VTI_BOND_TORSION] = &p->torsion;
    limit[VTI_BOND_ENERGY] = &p->energy;
    limit[VTI_BOND_STRETCH] = &p->stretch;
}

/* ---- the list ---------------------------------------------------------------------------------------------------- */

static void swap(double *a, double *b)
{
    const double kept = *a;
    *a = *b;
    *b = kept;
}

static void swap_integers(int64_t *a, int64_t *b)
{
    const int64_t kept = *a;
    *a = *b;
    *b = kept;
}

/** Bonds k and l change places. The list's arrays are const to those who read it only. */
static void exchange(const vti_rupture *p, int64_t k, int64_t l)
{
    const vti_bonds *bonds = p->bonds;
    const vti_scalars *const term[TERMS] = {&bonds->moment, &bonds->axial, &bonds->shear};
    int64_t *pair = (int64_t *)bonds->pair;
    double *const rest[2] = {(double *)bonds->rest, (double *)bonds->turn};
    swap_integers(&p->id[k], &p->id[l]);
    for (int c = 0; c < 2; ++c)
        swap_integers(&pair[2 * k + c], &pair[2 * l + c]);
    for (int c = 0; c < 8; ++c)
        if (rest[c / 4] != NULL)
            swap(&rest[c / 4][4 * k + c % 4], &rest[c / 4][4 * l + c % 4]);
    for (int c = 0; c < TERMS; ++c) {
        int done = term[c]->p == NULL || term[c]->stride == 0;
        for (int before = 0; before < c; ++before) /* one array may serve several terms */
            done |= term[before]->p == term[c]->p && term[before]->stride != 0;
        double *stiffness = (double *)term[c]->p;
        if (!done)
            swap(&stiffness[k * term[c]->stride], &stiffness[l * term[c]->stride]);
    }
}

/** Bond k stays: it moves up to the place behind those that stay already. Returns how many there are now. */
static int64_t keep(const vti_rupture *p, int64_t kept, int64_t k)
{
    if (kept != k)
        exchange(p, kept, k);
    return kept + 1;
}

/* ---- the test ---------------------------------------------------------------------------------------------------- */

/** Whether the bond of number m, from 0, that holds so much breaks. */
static int breaks(const vti_scalars *const limit[LIMITS], int64_t m, const double measure[VTI_BOND_MEASURES])
{
    double share = 0.0; /* of what it bears: the sum over forces and moments, or all of it alone */
    for (int c = VTI_BOND_NORMAL; c <= VTI_BOND_TORSION; ++c)
        share += limit[c]->p != NULL ? measure[c] / vti_scalar(limit[c], m) : 0.0;
    int broken = share >= 1.0;
    for (int c = VTI_BOND_ENERGY; c <= VTI_BOND_STRETCH; ++c)
        broken |= limit[c]->p != NULL && measure[c] >= vti_scalar(limit[c], m);
    return broken;
}

/** What bond k held. */
static void book(const vti_rupture *p, int64_t k, double energy)
{
    const int64_t *const pair = p->bonds->pair + 2 * k, base = p->bonds->base;
    vti_sum_add(p->lost, energy);
    if (p->by_body != NULL)
        vti_share(p->by_body, VTI_RUPTURE_BOOKS, 0, pair[0] - base, pair[1] - base, energy);
}

/** Bonds are measured so many at a time, before one of them is tested or moved. */
enum { TILE = 64 };

static int64_t rupture_of_bonds(const void *self, const vti_bodies *b)
{
    const vti_rupture *p = self;
    const vti_scalars *limit[LIMITS];
    const int64_t count = p->bonds->count;
    double measures[TILE * VTI_BOND_MEASURES];
    int64_t kept = 0;
    limits_of(p, limit);
    for (int64_t first = 0; first < count; first += TILE) {
        const int64_t last = count - first < TILE ? count : first + TILE;
        vti_bonds_measure(p->bonds, b, first, last, measures);
        for (int64_t k = first; k < last; ++k) {
            const double *measure = measures + (k - first) * VTI_BOND_MEASURES;
            if (breaks(limit, p->id[k] - p->bonds->base, measure))
                book(p, k, measure[VTI_BOND_ENERGY]);
            else
                kept = keep(p, kept, k);
        }
    }
    p->bonds->count = kept;
    return count - kept;
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

int vti_rupture_check(const vti_rupture *rupture, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (rupture == NULL || rupture->bonds == NULL || rupture->id == NULL || rupture->lost == NULL)
        return VTI_E_NULL;
    const vti_scalars *limit[LIMITS];
    const vti_bonds *bonds = rupture->bonds;
    if (bonds->count < 0)
        return VTI_E_COUNT;
    limits_of(rupture, limit);
    for (int64_t k = 0; k < bonds->count; ++k) {
        const int64_t id = rupture->id[k], least = k > 0 ? rupture->id[k - 1] : bonds->base;
        if (k > 0 ? id <= least : id < least)
            return vti_refuse(VTI_E_BOND, k, (double)id, VTI_QUANTITY_NONE, fault);
        const int64_t m = id - bonds->base;
        for (int c = 0; c < LIMITS; ++c) {
            if (limit[c]->p == NULL)
                continue;
            if (vti_ends_before(limit[c], m))
                return vti_refuse(VTI_E_BOND, k, (double)limit[c]->count, VTI_QUANTITY_NONE, fault);
            if (!(vti_scalar(limit[c], m) > 0.0))
                return vti_refuse(VTI_E_BOND, k, vti_scalar(limit[c], m), VTI_QUANTITY_NONE, fault);
        }
    }
    return VTI_OK;
}

static int check(const void *self, const vti_bodies *b)
{
    const vti_rupture *p = self;
    if (p->lost == NULL)
        return VTI_E_NULL;
    const vti_effect bonds = vti_bonds_effect(p->bonds);
    const int status = bonds.check != NULL ? bonds.check(bonds.self, b) : VTI_E_NULL;
    return VTI_LOOKS && status == VTI_OK ? vti_rupture_check(p, NULL) : status;
}

vti_effect vti_rupture_effect(const vti_rupture *rupture)
{
    static const char *const book[VTI_RUPTURE_BOOKS] = {"lost_rupture"};
    const vti_rupture *p = rupture;
    if (p == NULL || p->bonds == NULL || p->id == NULL || p->lost == NULL)
        return vti_effect_none();
    const vti_effect effect = {.name = "rupture",
                               .check = check,
                               .springs = vti_springs_none,
                               .rupture = rupture_of_bonds,
                               .self = p,
                               .needs = vti_bonds_effect(p->bonds).needs | 1 << VTI_QUANTITY_X,
                               .dissipates = 1,
                               .books = VTI_RUPTURE_BOOKS,
                               .book = book,
                               .booked = p->lost,
                               .by_body = p->by_body,
                               .of_body = VTI_RUPTURE_BOOKS};
    return effect;
}

int vti_rupture_take_out(const vti_rupture *rupture, int64_t count, const int64_t *id)
{
    const vti_rupture *p = rupture;
    if (p == NULL || p->bonds == NULL || p->id == NULL || (count > 0 && (id == NULL || !vti_bonds_has_list(p->bonds))))
        return VTI_E_NULL;
    if (count < 0)
        return VTI_E_COUNT;
    int64_t found = 0, kept = 0;
    for (int64_t k = 0; k < p->bonds->count; ++k)
        found += found < count && p->id[k] == id[found];
    if (found < count)
        return VTI_E_BOND;
    found = 0;
    for (int64_t k = 0; k < p->bonds->count; ++k)
        if (found < count && p->id[k] == id[found])
            ++found;
        else
            kept = keep(p, kept, k);
    p->bonds->count = kept;
    return VTI_OK;
}
