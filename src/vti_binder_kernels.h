/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds: every combination of terms and every form of shear is a kernel of its own, made from the formulas of
 * vti_pair.h with literal masks and picked once. WIDTH bonds are done together, a bond to a lane: evaluate() gathers
 * what they need of the bodies and gives a row of loads for each, add_rows() adds the rows to the bodies in the order
 * of the bonds, so that the bits do not depend on the width.
 *
 * The files vti_binder_*.c include this and nothing else: each is compiled for vector units of its own, and defines
 * BOND_KERNELS, the name of its table. */
#include "vti_pair.h"

/** PACKED: vectors lie as x[n][3], quaternions as q[n][4]. ANY: whatever the views say. */
enum layout { PACKED, ANY };

/** The loads of a bond, in an order that vectors can write: Fx Fy, Tx Ty of i, Tx Ty of j, Fz, Tz of i, Tz of j. */
enum { ROW = 9 };

/* ---- blocks of the list ------------------------------------------------------------------------------------------ */

/** The last bonds, filled up to WIDTH with the last one. */
struct last {
    int64_t pair[2 * WIDTH];
    double rest[4 * WIDTH], stiffness[TERMS][WIDTH];
};

/** The bonds from first on. */
VTI_INLINE vti_bonds from(const vti_bonds *bonds, int64_t first)
{
    vti_bonds block = *bonds;
    block.pair += 2 * first;
    block.rest += 4 * first;
    block.moment.p += first * block.moment.stride;
    block.axial.p += first * block.axial.stride;
    block.shear.p += first * block.shear.stride;
    return block;
}

/** The same as a whole block, of fewer than WIDTH bonds. */
VTI_APART vti_bonds from_last(const vti_bonds *bonds, int64_t first, struct last *last)
{
    vti_bonds block = from(bonds, first);
    vti_scalars *const all[TERMS] = {&block.moment, &block.axial, &block.shear};
    for (int l = 0; l < WIDTH; ++l) {
        const int64_t k = first + l < bonds->count ? l : bonds->count - 1 - first;
        for (int side = 0; side < 2; ++side)
            last->pair[2 * l + side] = block.pair[2 * k + side];
        for (int c = 0; c < 4; ++c)
            last->rest[4 * l + c] = block.rest[4 * k + c];
        for (int c = 0; c < TERMS; ++c)
            last->stiffness[c][l] = all[c]->p != NULL ? vti_scalar(all[c], k) : 0.0;
    }
    block.pair = last->pair;
    block.rest = last->rest;
    for (int c = 0; c < TERMS; ++c) {
        all[c]->p = last->stiffness[c];
        all[c]->stride = 1;
    }
    return block;
}

/* ---- gather ------------------------------------------------------------------------------------------------------ */

VTI_INLINE void gather_vectors(enum layout layout, const vti_view *view, const int64_t body[WIDTH], lanes r[3])
{
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = body[l] * (layout == PACKED ? 3 : view->stride);
    if (layout == PACKED)
        lanes_triples(view->c[0], at, r);
    else
        for (int k = 0; k < 3; ++k)
            r[k] = lanes_gather(view->c[k], at);
}

VTI_INLINE void gather_quaternions(enum layout layout, const vti_quat_view *quat, const int64_t body[WIDTH], lanes q[4])
{
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = body[l] * (layout == PACKED ? 4 : quat->stride);
    if (layout == PACKED)
        lanes_quads(quat->xyzw[0], at, q);
    else
        for (int k = 0; k < 4; ++k)
            q[k] = lanes_gather(quat->xyzw[k], at);
}

/** Attitudes of which some may be so large that they have to be scaled. */
VTI_APART void pick_large(const vti_bodies *b, const int64_t body[WIDTH], double picked[4][WIDTH])
{
    for (int l = 0; l < WIDTH; ++l) {
        double q[4];
        vti_load_pair(b, body[l], q);
        for (int k = 0; k < 4; ++k)
            picked[k][l] = q[k];
    }
}

/** q ~ (alpha, 2), as vti_rrv_to_pair has it: no |alpha_k| > VTI_RRV_LARGE gets past the sum of their squares. */
VTI_INLINE void gather_attitudes(enum layout layout, const vti_bodies *b, const int64_t body[WIDTH], lanes q[4])
{
    if (!vti_has(&b->alpha)) {
        gather_quaternions(layout, &b->quat, body, q);
        return;
    }
    gather_vectors(layout, &b->alpha, body, q);
    q[3] = lanes_of(2.0);
    if (lanes_all(lanes_square(q) <= VTI_RRV_LARGE * VTI_RRV_LARGE))
        return;
    double picked[4][WIDTH];
    const vti_bodies copy = *b;
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = body[l];
    pick_large(&copy, at, picked);
    for (int k = 0; k < 4; ++k)
        q[k] = lanes_load(picked[k]);
}

VTI_INLINE void gather(int terms, enum layout layout, const vti_bonds *block, const vti_bodies *b, struct bond_state *s)
{
    int64_t i[WIDTH], j[WIDTH], at[WIDTH];
    lanes xj[3], rest[4];
    lanes_strided(4, at);
    for (int l = 0; l < WIDTH; ++l) {
        i[l] = block->pair[2 * l] - block->base;
        j[l] = block->pair[2 * l + 1] - block->base;
    }
    if (terms & (TERM_MOMENT | TERM_SHEAR)) {
        gather_attitudes(layout, b, i, s->qi);
        gather_attitudes(layout, b, j, s->qj);
    }
    if (terms & (TERM_AXIAL | TERM_SHEAR)) {
        gather_vectors(layout, &b->x, i, s->d);
        gather_vectors(layout, &b->x, j, xj);
        for (int c = 0; c < 3; ++c)
            s->d[c] -= xj[c];
        lanes_quads(block->rest, at, rest);
        for (int c = 0; c < 3; ++c)
            s->n0[c] = rest[c];
        s->length = rest[3];
    }
    if (terms & TERM_MOMENT)
        s->moment = lanes_of_scalars(block->moment.p, block->moment.stride);
    if (terms & TERM_AXIAL)
        s->axial = lanes_of_scalars(block->axial.p, block->axial.stride);
    if (terms & TERM_SHEAR)
        s->shear = lanes_of_scalars(block->shear.p, block->shear.stride);
}

/* ---- evaluate ---------------------------------------------------------------------------------------------------- */

/** The loads of WIDTH bonds as rows; only what the terms give is to be read of them. */
VTI_INLINE void evaluate(int terms, int form, enum layout layout, const vti_bonds *block, const vti_bodies *b,
                         double rows[WIDTH * ROW])
{
    struct bond_state state;
    struct bond_loads out;
    int64_t at[WIDTH];
    gather(terms, layout, block, b, &state);
    bond_evaluate(terms, form, &state, &out);
    lanes_strided(ROW, at);
    const lanes head[4] = {out.force[0], out.force[1], out.moment_i[0], out.moment_i[1]};
    const lanes tail[4] = {out.moment_j[0], out.moment_j[1], out.force[2], out.moment_i[2]};
    lanes_unquad(rows, at, head);
    lanes_unquad(rows + 4, at, tail);
    lanes_scatter(rows + 8, at, out.moment_j[2]);
}

/* ---- scatter ----------------------------------------------------------------------------------------------------- */

VTI_INLINE struct triple load(enum layout layout, const vti_view *view, int64_t body)
{
    if (layout == PACKED)
        return triple_load(view->c[0] + 3 * body);
    const int64_t at = body * view->stride;
    return triple_of(view->c[0][at], view->c[1][at], view->c[2][at]);
}

VTI_INLINE void store(enum layout layout, const vti_view *view, int64_t body, struct triple a)
{
    if (layout == PACKED)
        triple_store(view->c[0] + 3 * body, a);
    else {
        double r[3];
        triple_store(r, a);
        vti_store(view, body, r);
    }
}

/** What adds rows to the bodies: which of them it has, and the sums of the body that was i of the last bond. Lists name
 *  a body i several times in a row; until another one comes, its sums stay in registers, as no other j is that body. */
struct sums {
    int forces, moments;
    int64_t body;
    struct triple force, moment;
};

VTI_INLINE void sums_take(enum layout layout, const vti_bodies *b, int64_t body, struct sums *s)
{
    s->body = body;
    if (s->forces)
        s->force = load(layout, &b->force, body);
    if (s->moments)
        s->moment = load(layout, &b->moment, body);
}

VTI_INLINE void sums_leave(enum layout layout, const vti_bodies *b, const struct sums *s)
{
    if (s->forces)
        store(layout, &b->force, s->body, s->force);
    if (s->moments)
        store(layout, &b->moment, s->body, s->moment);
}

VTI_INLINE void add_row(enum layout layout, const vti_bodies *b, int64_t i, int64_t j, const double row[ROW],
                        struct sums *s)
{
    if (i != s->body) {
        sums_leave(layout, b, s);
        sums_take(layout, b, i, s);
    }
    if (s->forces) {
        const struct triple force = triple_of(row[0], row[1], row[6]);
        s->force = triple_plus(s->force, force);
        store(layout, &b->force, j, triple_minus(load(layout, &b->force, j), force));
    }
    if (s->moments) {
        s->moment = triple_plus(s->moment, triple_of(row[2], row[3], row[7]));
        store(layout, &b->moment, j, triple_plus(load(layout, &b->moment, j), triple_of(row[4], row[5], row[8])));
    }
}

/* ---- kernels ----------------------------------------------------------------------------------------------------- */

VTI_INLINE void apply_all(int terms, int form, enum layout layout, const vti_bonds *bonds, const vti_bodies *bodies)
{
    const vti_bodies b = *bodies; /* what nobody else can change stays in registers */
    double rows[WIDTH * ROW];
    struct last last;
    struct sums sums = {.forces = terms & (TERM_AXIAL | TERM_SHEAR) && vti_has(&b.force),
                        .moments = terms & (TERM_MOMENT | TERM_SHEAR) && vti_has(&b.moment)};
    sums_take(layout, &b, bonds->pair[0] - bonds->base, &sums);
    const int64_t count = bonds->count;
    for (int64_t first = 0; first < count; first += WIDTH) {
        const int full = count - first >= WIDTH, lanes_used = full ? WIDTH : (int)(count - first);
        const vti_bonds block = full ? from(bonds, first) : from_last(bonds, first, &last);
        evaluate(terms, form, layout, &block, &b, rows);
        for (int l = 0; l < lanes_used; ++l)
            add_row(layout, &b, block.pair[2 * l] - block.base, block.pair[2 * l + 1] - block.base, rows + l * ROW,
                    &sums);
    }
    sums_leave(layout, &b, &sums);
}

/** Whether all that the bonds read and write lies packed. */
static int is_packed(int terms, const vti_bodies *b)
{
    const vti_quat_view *q = &b->quat;
    int packed = !(terms & (TERM_AXIAL | TERM_SHEAR)) || vti_is_packed(&b->x);
    if (terms & (TERM_MOMENT | TERM_SHEAR)) {
        packed &= vti_has(&b->alpha) ? vti_is_packed(&b->alpha)
                                     : q->stride == 4 && q->xyzw[1] == q->xyzw[0] + 1 && q->xyzw[2] == q->xyzw[0] + 2 &&
                                           q->xyzw[3] == q->xyzw[0] + 3;
        packed &= !vti_has(&b->moment) || vti_is_packed(&b->moment);
    }
    return packed & (!(terms & (TERM_AXIAL | TERM_SHEAR)) || !vti_has(&b->force) || vti_is_packed(&b->force));
}

VTI_INLINE void energy_all(int terms, int form, const vti_bonds *bonds, const vti_bodies *bodies, double *energies)
{
    const vti_bodies b = *bodies;
    struct bond_state state;
    struct bond_loads out;
    struct last last;
    vti_sum sum[TERMS] = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (int64_t first = 0; first < bonds->count; first += WIDTH) {
        const int64_t left = bonds->count - first;
        const vti_bonds block = left >= WIDTH ? from(bonds, first) : from_last(bonds, first, &last);
        gather(terms, ANY, &block, &b, &state);
        bond_evaluate(terms, form, &state, &out);
        for (int c = 0; c < TERMS; ++c)
            for (int l = 0; l < WIDTH && l < left && terms >> c & 1; ++l)
                vti_sum_add(&sum[c], lanes_get(out.energy[c], l));
    }
    for (int c = 0, n = 0; c < TERMS; ++c)
        if (terms >> c & 1)
            energies[n++] = vti_sum_value(&sum[c]);
}

#define KERNEL(NAME, TERMS_, FORM)                                                                                     \
    static void apply_packed_##NAME(const vti_bonds *bonds, const vti_bodies *b)                                       \
    {                                                                                                                  \
        apply_all(TERMS_, FORM, PACKED, bonds, b);                                                                     \
    }                                                                                                                  \
    static void apply_any_##NAME(const vti_bonds *bonds, const vti_bodies *b)                                          \
    {                                                                                                                  \
        apply_all(TERMS_, FORM, ANY, bonds, b);                                                                        \
    }                                                                                                                  \
    static void apply_##NAME(const void *self, const vti_bodies *b)                                                    \
    {                                                                                                                  \
        const vti_bonds *const bonds = self;                                                                           \
        if (bonds->count > 0)                                                                                          \
            (is_packed(TERMS_, b) ? apply_packed_##NAME : apply_any_##NAME)(bonds, b);                                 \
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
