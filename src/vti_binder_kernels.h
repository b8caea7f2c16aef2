/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds: every combination of terms and every form of shear is a kernel of its own, made from the formulas of
 * vti_pair.h with literal masks and picked once. Bonds are done in blocks: gather what they need of the bodies,
 * evaluate all lanes without branches, add the loads to the bodies in the order of the bonds, so that the bits do not
 * depend on the vector width.
 *
 * The files vti_binder_*.c include this and nothing else: each is compiled for vector units of its own, and defines
 * BOND_KERNELS, the name of its table. */
#include "vti_binder_table.h"

/** A block, one array per number. */
struct block {
    double d[3][VTI_LANES], qi[4][VTI_LANES], qj[4][VTI_LANES], n0[3][VTI_LANES], length[VTI_LANES];
    double moment[VTI_LANES], axial[VTI_LANES], shear[VTI_LANES];
    double force[3][VTI_LANES], moment_i[3][VTI_LANES], moment_j[3][VTI_LANES], energy[TERMS][VTI_LANES];
};

/* ---- gather ------------------------------------------------------------------------------------------------------ */

VTI_INLINE void gather(int terms, const vti_bonds *bonds, const vti_bodies *b, int64_t first, int lanes,
                       struct block *s)
{
    for (int l = 0; l < lanes; ++l) {
        const int64_t k = first + l;
        const int64_t i = bonds->pair[2 * k] - bonds->base, j = bonds->pair[2 * k + 1] - bonds->base;
        if (terms & (TERM_MOMENT | TERM_SHEAR)) {
            double qi[4], qj[4];
            vti_load_pair(b, i, qi);
            vti_load_pair(b, j, qj);
            for (int c = 0; c < 4; ++c) {
                s->qi[c][l] = qi[c];
                s->qj[c][l] = qj[c];
            }
        }
        if (terms & (TERM_AXIAL | TERM_SHEAR))
            for (int c = 0; c < 3; ++c)
                s->d[c][l] = b->x.c[c][i * b->x.stride] - b->x.c[c][j * b->x.stride];
        if (terms & TERM_SHEAR)
            for (int c = 0; c < 3; ++c)
                s->n0[c][l] = bonds->rest[4 * k + c];
        if (terms & TERM_AXIAL)
            s->length[l] = bonds->rest[4 * k + 3];
        if (terms & TERM_MOMENT)
            s->moment[l] = stiffness(&bonds->moment, k);
        if (terms & TERM_AXIAL)
            s->axial[l] = stiffness(&bonds->axial, k);
        if (terms & TERM_SHEAR)
            s->shear[l] = stiffness(&bonds->shear, k);
    }
}

/* ---- evaluate ---------------------------------------------------------------------------------------------------- */

VTI_INLINE void load_lane(int terms, const struct block *s, int l, struct bond_state *b)
{
    for (int c = 0; c < 3; ++c) {
        b->d[c] = terms & (TERM_AXIAL | TERM_SHEAR) ? s->d[c][l] : 0.0;
        b->n0[c] = terms & TERM_SHEAR ? s->n0[c][l] : 0.0;
    }
    for (int c = 0; c < 4; ++c) {
        b->qi[c] = terms & (TERM_MOMENT | TERM_SHEAR) ? s->qi[c][l] : 0.0;
        b->qj[c] = terms & (TERM_MOMENT | TERM_SHEAR) ? s->qj[c][l] : 0.0;
    }
    b->length = terms & TERM_AXIAL ? s->length[l] : 1.0;
    b->moment = terms & TERM_MOMENT ? s->moment[l] : 0.0;
    b->axial = terms & TERM_AXIAL ? s->axial[l] : 0.0;
    b->shear = terms & TERM_SHEAR ? s->shear[l] : 0.0;
}

VTI_INLINE void evaluate_loads(int terms, int form, struct block *s, int lanes)
{
    for (int l = 0; l < lanes; ++l) {
        struct bond_state bond;
        struct bond_loads out;
        load_lane(terms, s, l, &bond);
        bond_evaluate(terms, form, &bond, &out);
        for (int c = 0; c < 3; ++c) {
            s->force[c][l] = out.force[c];
            s->moment_i[c][l] = out.moment_i[c];
            s->moment_j[c][l] = out.moment_j[c];
        }
    }
}

VTI_INLINE void evaluate_energies(int terms, int form, struct block *s, int lanes)
{
    for (int l = 0; l < lanes; ++l) {
        struct bond_state bond;
        struct bond_loads out;
        load_lane(terms, s, l, &bond);
        bond_evaluate(terms, form, &bond, &out);
        for (int c = 0; c < TERMS; ++c)
            s->energy[c][l] = out.energy[c];
    }
}

/* ---- scatter ----------------------------------------------------------------------------------------------------- */

VTI_INLINE void scatter(int terms, const vti_bonds *bonds, const vti_bodies *b, int64_t first, int lanes,
                        const struct block *s)
{
    const int has_force = terms & (TERM_AXIAL | TERM_SHEAR) && vti_has(&b->force);
    const int has_moment = terms & (TERM_MOMENT | TERM_SHEAR) && vti_has(&b->moment);
    for (int l = 0; l < lanes; ++l) {
        const int64_t k = first + l;
        const int64_t i = bonds->pair[2 * k] - bonds->base, j = bonds->pair[2 * k + 1] - bonds->base;
        for (int c = 0; c < 3 && has_force; ++c) {
            b->force.c[c][i * b->force.stride] += s->force[c][l];
            b->force.c[c][j * b->force.stride] -= s->force[c][l];
        }
        for (int c = 0; c < 3 && has_moment; ++c) {
            b->moment.c[c][i * b->moment.stride] += s->moment_i[c][l];
            b->moment.c[c][j * b->moment.stride] += s->moment_j[c][l];
        }
    }
}

/* ---- kernels ----------------------------------------------------------------------------------------------------- */

VTI_INLINE void apply_all(int terms, int form, const vti_bonds *bonds, const vti_bodies *b)
{
    struct block block;
    for (int64_t first = 0; first < bonds->count; first += VTI_LANES) {
        const int lanes = (int)(bonds->count - first < VTI_LANES ? bonds->count - first : VTI_LANES);
        gather(terms, bonds, b, first, lanes, &block);
        evaluate_loads(terms, form, &block, lanes);
        scatter(terms, bonds, b, first, lanes, &block);
    }
}

VTI_INLINE void energy_all(int terms, int form, const vti_bonds *bonds, const vti_bodies *b, double *energies)
{
    struct block block;
    vti_sum sum[TERMS] = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (int64_t first = 0; first < bonds->count; first += VTI_LANES) {
        const int lanes = (int)(bonds->count - first < VTI_LANES ? bonds->count - first : VTI_LANES);
        gather(terms, bonds, b, first, lanes, &block);
        evaluate_energies(terms, form, &block, lanes);
        for (int c = 0; c < TERMS; ++c)
            for (int l = 0; l < lanes && terms >> c & 1; ++l)
                vti_sum_add(&sum[c], block.energy[c][l]);
    }
    for (int c = 0, n = 0; c < TERMS; ++c)
        if (terms >> c & 1)
            energies[n++] = vti_sum_value(&sum[c]);
}

#define KERNEL(NAME, TERMS_, FORM)                                                                                     \
    static void apply_##NAME(const void *self, const vti_bodies *b)                                                    \
    {                                                                                                                  \
        apply_all(TERMS_, FORM, self, b);                                                                              \
    }                                                                                                                  \
    static void energy_##NAME(const void *self, const vti_bodies *b, double *energies)                                 \
    {                                                                                                                  \
        energy_all(TERMS_, FORM, self, b, energies);                                                                   \
    }

#define SHEAR_KERNELS(SHEAR, FORM)                                                                                     \
    KERNEL(SHEAR, TERM_SHEAR, FORM)                                                                                    \
    KERNEL(moment_##SHEAR, TERM_SHEAR | TERM_MOMENT, FORM)                                                             \
    KERNEL(axial_##SHEAR, TERM_SHEAR | TERM_AXIAL, FORM)                                                               \
    KERNEL(moment_axial_##SHEAR, TERM_SHEAR | TERM_MOMENT | TERM_AXIAL, FORM)

KERNEL(none, 0, 0)
KERNEL(moment, TERM_MOMENT, 0)
KERNEL(axial, TERM_AXIAL, 0)
KERNEL(moment_axial, TERM_MOMENT | TERM_AXIAL, 0)
SHEAR_KERNELS(objective, VTI_SHEAR_OBJECTIVE)
SHEAR_KERNELS(quartic, VTI_SHEAR_QUARTIC)
SHEAR_KERNELS(printed, VTI_SHEAR_PRINTED)

#define PICK(NAME)                                                                                                     \
    {                                                                                                                  \
        apply_##NAME, energy_##NAME                                                                                    \
    }
#define PICK_SHEAR(SHEAR)                                                                                              \
    {                                                                                                                  \
        PICK(SHEAR), PICK(moment_##SHEAR), PICK(axial_##SHEAR), PICK(moment_axial_##SHEAR)                             \
    }

/** [form of shear, 0 for none][moment + 2 axial] */
const struct bond_kernel BOND_KERNELS[4][4] = {{PICK(none), PICK(moment), PICK(axial), PICK(moment_axial)},
                                               PICK_SHEAR(objective),
                                               PICK_SHEAR(quartic),
                                               PICK_SHEAR(printed)};
