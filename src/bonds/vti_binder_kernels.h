/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds: every combination of terms and every form of shear is a kernel of its own, made from the formulas of
 * vti_pair.h with literal masks. WIDTH bonds are done together, a bond to a lane, into a row of loads for each; rows
 * are added to the bodies in the order of the bonds, so that the bits depend neither on the width nor on who evaluates
 * what.
 *
 * The files vti_binder_*.c include this and nothing else: each is compiled for vector units of its own, and defines
 * BOND_KERNELS, the name of its table. */
#include <string.h>

#include "vti_pair.h"

/* ---- blocks of the list ------------------------------------------------------------------------------------------ */

/** The last bonds, filled up to WIDTH with the last one. */
struct last {
    int64_t pair[2 * WIDTH];
    double rest[4 * WIDTH], turn[4 * WIDTH], stiffness[TERMS][WIDTH];
};

/** The bonds from first on, but for turn. What is absent is NULL, to which C lets nobody add 0. */
VTI_INLINE vti_bonds from(const vti_bonds *bonds, int64_t first)
{
    vti_bonds block = *bonds;
    vti_scalars *const all[TERMS] = {&block.moment, &block.axial, &block.shear};
    if (first == 0)
        return block;
    block.pair += 2 * first;
    block.rest += 4 * first;
    for (int c = 0; c < TERMS; ++c)
        if (all[c]->p != NULL)
            all[c]->p += first * all[c]->stride;
    return block;
}

/** The same up to last, of fewer than WIDTH, as a whole block. */
VTI_APART vti_bonds from_last(const vti_bonds *bonds, int64_t first, int64_t last, struct last *few)
{
    vti_bonds block = from(bonds, first);
    vti_scalars *const all[TERMS] = {&block.moment, &block.axial, &block.shear};
    for (int l = 0; l < WIDTH; ++l) {
        const int64_t k = first + l < last ? l : last - 1 - first;
        for (int side = 0; side < 2; ++side)
            few->pair[2 * l + side] = block.pair[2 * k + side];
        for (int c = 0; c < 4; ++c)
            few->rest[4 * l + c] = block.rest[4 * k + c];
        for (int c = 0; c < TERMS; ++c)
            few->stiffness[c][l] = all[c]->p != NULL ? vti_scalar(all[c], k) : 0.0;
    }
    block.pair = few->pair;
    block.rest = few->rest;
    for (int c = 0; c < TERMS; ++c) {
        all[c]->p = few->stiffness[c];
        all[c]->stride = 1;
    }
    return block;
}

/** WIDTH bonds from first on, or those up to last as a whole block, with turn. */
VTI_INLINE vti_bonds block_at(const vti_bonds *bonds, int64_t first, int64_t last, struct last *few)
{
    vti_bonds block = last - first >= WIDTH ? from(bonds, first) : from_last(bonds, first, last, few);
    if (bonds->turn == NULL)
        return block;
    block.turn = bonds->turn + 4 * first;
    for (int c = 0; last - first < WIDTH && c < 4 * WIDTH; ++c)
        few->turn[c] = block.turn[c < 4 * (last - first) ? c : 4 * (last - first - 1) + c % 4];
    if (last - first < WIDTH)
        block.turn = few->turn;
    return block;
}

/* ---- gather ------------------------------------------------------------------------------------------------------ */

VTI_INLINE void gather_vectors(enum layout layout, const vti_view *view, const int64_t body[WIDTH], lanes r[3])
{
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = body[l] * (layout == ANY ? view->stride : 3);
    if (layout != ANY)
        lanes_triples(view->c[0], at, r);
    else
        for (int k = 0; k < 3; ++k)
            r[k] = lanes_gather(view->c[k], at);
}

/** Attitudes as pairs, of alpha as (alpha/2, 1): what is multiplied by a literal 1 is not. */
VTI_INLINE void gather_pairs(enum layout layout, const vti_bodies *b, const int64_t body[WIDTH], lanes q[4])
{
    int64_t at[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        at[l] = body[l] * 4;
    if (layout == ALPHA) {
        gather_vectors(layout, &b->alpha, body, q);
        for (int k = 0; k < 3; ++k)
            q[k] *= 0.5;
        q[3] = lanes_of(1.0);
    } else if (layout == QUAT)
        lanes_quads(b->quat.xyzw[0], at, q);
    else {
        double lane[4][WIDTH], one[4];
        for (int l = 0; l < WIDTH; ++l) {
            vti_load_pair(b, body[l], one);
            for (int k = 0; k < 4; ++k)
                lane[k][l] = vti_has(&b->alpha) ? 0.5 * one[k] : one[k];
        }
        for (int k = 0; k < 4; ++k)
            q[k] = lanes_load(lane[k]);
    }
}

/** Of one body of each bond: its attitude and its place. */
VTI_INLINE void gather_end(int terms, enum layout layout, const vti_bonds *block, int side, const vti_bodies *b,
                           lanes q[4], lanes x[3])
{
    int64_t body[WIDTH];
    for (int l = 0; l < WIDTH; ++l)
        body[l] = block->pair[2 * l + side] - block->base;
    if (terms & (TERM_MOMENT | TERM_SHEAR))
        gather_pairs(layout, b, body, q);
    if (terms & (TERM_AXIAL | TERM_SHEAR))
        gather_vectors(layout, &b->x, body, x);
}

VTI_INLINE void gather_stiffness(int terms, const vti_bonds *block, struct bond_state *s)
{
    if (terms & TERM_MOMENT)
        s->moment = lanes_of_scalars(block->moment.p, block->moment.stride);
    if (terms & TERM_AXIAL)
        s->axial = lanes_of_scalars(block->axial.p, block->axial.stride);
    if (terms & TERM_SHEAR)
        s->shear = lanes_of_scalars(block->shear.p, block->shear.stride);
}

/** Where the bodies are, and the rest vectors. */
VTI_INLINE void gather_places(int terms, enum layout layout, const vti_bonds *block, const vti_bodies *b,
                              struct bond_state *s)
{
    int64_t at[WIDTH];
    lanes xj[3], rest[4];
    gather_end(terms, layout, block, 0, b, s->qi, s->d);
    gather_end(terms, layout, block, 1, b, s->qj, xj);
    if (terms & (TERM_AXIAL | TERM_SHEAR)) {
        lanes_strided(4, at);
        lanes_quads(block->rest, at, rest);
        for (int c = 0; c < 3; ++c) {
            s->d[c] -= xj[c];
            s->n0[c] = rest[c];
        }
        s->length = rest[3];
    }
}

VTI_INLINE void gather(int terms, enum layout layout, const vti_bonds *block, const vti_bodies *b, struct bond_state *s)
{
    gather_places(terms, layout, block, b, s);
    gather_stiffness(terms, block, s);
}

/** R_j Q0^T in place of R_j. */
VTI_INLINE void gather_turns(const vti_bonds *block, struct bond_state *s)
{
    int64_t at[WIDTH];
    lanes turn[4], v[3];
    lanes_strided(4, at);
    lanes_quads(block->turn, at, turn);
    const lanes w = quotient(s->qj, turn, v);
    for (int k = 0; k < 3; ++k)
        s->qj[k] = v[k];
    s->qj[3] = w;
}

/** Wherever bodies lie, with turns if there are any and terms that they matter to. */
VTI_INLINE void gather_all(int terms, const vti_bonds *block, const vti_bodies *b, struct bond_state *s)
{
    gather(terms, ANY, block, b, s);
    if (terms & (TERM_MOMENT | TERM_SHEAR) && block->turn != NULL)
        gather_turns(block, s);
}

/* ---- evaluate ---------------------------------------------------------------------------------------------------- */

/** Rows hold Fx Fy, Tx Ty of i, Tx Ty of j, Fz, Tz of i, Tz of j: an order that vectors can write. */
VTI_INLINE void write_rows(const struct bond_loads *loads, double rows[WIDTH * VTI_BOND_LOADS])
{
    int64_t at[WIDTH];
    lanes_strided(VTI_BOND_LOADS, at);
    const lanes head[4] = {loads->force[0], loads->force[1], loads->moment_i[0], loads->moment_i[1]};
    const lanes tail[4] = {loads->moment_j[0], loads->moment_j[1], loads->force[2], loads->moment_i[2]};
    lanes_unquad(rows, at, head);
    lanes_unquad(rows + 4, at, tail);
    lanes_scatter(rows + 8, at, loads->moment_j[2]);
}

/** The loads of WIDTH bonds that come seldom: the last ones, and those of which some alpha may be so large that it has
 *  to be scaled, as vti_load_pair does. */
VTI_APART void evaluate_apart(int terms, int form, const vti_bonds *block, const vti_bodies *b,
                              double rows[WIDTH * VTI_BOND_LOADS])
{
    struct bond_state state;
    struct bond_loads loads;
    gather(terms, ANY, block, b, &state);
    bond_evaluate(terms, form, &state, &loads);
    write_rows(&loads, rows);
}

/** Whether some alpha of WIDTH bonds is so large that it has to be scaled. No |alpha_k| > VTI_RRV_LARGE gets past the
 *  square of its pair. */
VTI_INLINE int is_large(const struct bond_state *s)
{
    const double most = 0.25 * VTI_RRV_LARGE * VTI_RRV_LARGE;
    return !(lanes_all(lanes_square(s->qi) <= most) && lanes_all(lanes_square(s->qj) <= most));
}

/** The loads of WIDTH bonds as rows; only what the terms give is to be read of them. */
VTI_INLINE void evaluate(int terms, int form, enum layout layout, const vti_bonds *block, const vti_bodies *b,
                         double rows[WIDTH * VTI_BOND_LOADS])
{
    struct bond_state state;
    struct bond_loads loads;
    gather(terms, layout, block, b, &state);
    if (layout == ALPHA && terms & (TERM_MOMENT | TERM_SHEAR) && is_large(&state)) {
        const vti_bonds same_block = *block;
        const vti_bodies same = *b;
        evaluate_apart(terms, form, &same_block, &same, rows);
        return;
    }
    bond_evaluate(terms, form, &state, &loads);
    write_rows(&loads, rows);
}

/** The rows of the bonds first <= k < last. */
VTI_INLINE void loads_all(int terms, int form, enum layout layout, const vti_bonds *bonds, const vti_bodies *bodies,
                          int64_t first, int64_t last, double *rows)
{
    const vti_bodies b = *bodies; /* what nobody else can change stays in registers */
    for (; first + WIDTH <= last; first += WIDTH, rows += WIDTH * VTI_BOND_LOADS) {
        const vti_bonds block = from(bonds, first);
        evaluate(terms, form, layout, &block, &b, rows);
    }
    if (first < last) {
        double rest[WIDTH * VTI_BOND_LOADS];
        struct last few;
        const vti_bonds block = from_last(bonds, first, last, &few);
        evaluate_apart(terms, form, &block, bodies, rest);
        for (int64_t k = 0; k < (last - first) * VTI_BOND_LOADS; ++k)
            rows[k] = rest[k];
    }
}

/** The same of bonds that have turns, gathered as the bodies lie. */
VTI_INLINE void loads_turned(int terms, int form, const vti_bonds *bonds, const vti_bodies *bodies, int64_t first,
                             int64_t last, double *rows)
{
    const vti_bodies b = *bodies;
    const int packed = vti_is_packed(&b.x) && vti_is_packed(&b.alpha);
    double row[WIDTH * VTI_BOND_LOADS];
    struct bond_state state;
    struct bond_loads loads;
    struct last few;
    for (; first < last; first += WIDTH, rows += WIDTH * VTI_BOND_LOADS) {
        const int whole = last - first >= WIDTH;
        const vti_bonds block = block_at(bonds, first, last, &few);
        if (packed)
            gather(terms, ALPHA, &block, &b, &state);
        if (!packed || is_large(&state))
            gather(terms, ANY, &block, &b, &state);
        gather_turns(&block, &state);
        bond_evaluate(terms, form, &state, &loads);
        /* cppcheck-suppress legacyUninitvar ; it is written */
        write_rows(&loads, whole ? rows : row);
        for (int64_t k = 0; !whole && k < (last - first) * VTI_BOND_LOADS; ++k)
            rows[k] = row[k];
    }
}

VTI_INLINE void energy_all(int terms, int form, const vti_bonds *bonds, const vti_bodies *bodies, double *energies)
{
    const vti_bodies b = *bodies;
    struct bond_state state;
    struct bond_loads out;
    struct last few;
    vti_sum sum[TERMS] = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (int64_t first = 0; first < bonds->count; first += WIDTH) {
        const int64_t left = bonds->count - first;
        const vti_bonds block = block_at(bonds, first, bonds->count, &few);
        gather_all(terms, &block, &b, &state);
        bond_evaluate(terms, form, &state, &out);
        for (int c = 0; c < TERMS; ++c)
            for (int l = 0; l < WIDTH && l < left && terms >> c & 1; ++l)
                vti_sum_add(&sum[c], lanes_get(out.energy[c], l));
    }
    for (int c = 0, n = 0; c < TERMS; ++c)
        if (terms >> c & 1)
            energies[n++] = vti_sum_value(&sum[c]);
}

/* ---- measure ----------------------------------------------------------------------------------------------------- */

/** Of any terms and form, which are no literals here: what breaks looks once in a step. */
static void measure(int terms, int form, const vti_bonds *bonds, const vti_bodies *bodies, int64_t first, int64_t last,
                    double *rows)
{
    struct bond_state state;
    struct bond_measures of;
    struct last few;
    memset(&state, 0, sizeof state); /* terms that are absent are not gathered */
    for (; first < last; first += WIDTH) {
        const int64_t left = last - first;
        const vti_bonds block = block_at(bonds, first, last, &few);
        gather_places(terms | TERM_AXIAL, ANY, &block, bodies, &state);
        gather_stiffness(terms, &block, &state);
        if (terms & (TERM_MOMENT | TERM_SHEAR) && block.turn != NULL)
            gather_turns(&block, &state);
        bond_measure(terms, form, &state, &of);
        for (int l = 0; l < WIDTH && l < left; ++l)
            for (int c = 0; c < VTI_BOND_MEASURES; ++c)
                *rows++ = lanes_get(of.of[c], l);
    }
}

/* ---- sum --------------------------------------------------------------------------------------------------------- */

VTI_INLINE struct triple load(enum layout layout, const vti_view *view, int64_t body)
{
    if (layout != ANY)
        return triple_load(view->c[0] + 3 * body);
    const int64_t at = body * view->stride;
    return triple_of(view->c[0][at], view->c[1][at], view->c[2][at]);
}

VTI_INLINE void store(enum layout layout, const vti_view *view, int64_t body, struct triple a)
{
    if (layout != ANY)
        triple_store(view->c[0] + 3 * body, a);
    else {
        double r[3];
        triple_store(r, a);
        vti_store(view, body, r);
    }
}

/** The sums of the body that was i of the last bond, -1 for one that is not of the slice. Lists name a body i several
 *  times in a row; until another one comes its sums stay in registers, as no j is that body. */
struct sums {
    int64_t body;
    struct triple force, moment;
};

/** Leaves one body, and takes another. */
VTI_INLINE void sums_turn(enum layout layout, int forces, int moments, const vti_bodies *b, int64_t body,
                          struct sums *s)
{
    if (forces && s->body >= 0)
        store(layout, &b->force, s->body, s->force);
    if (moments && s->body >= 0)
        store(layout, &b->moment, s->body, s->moment);
    if (forces && body >= 0)
        s->force = load(layout, &b->force, body);
    if (moments && body >= 0)
        s->moment = load(layout, &b->moment, body);
    s->body = body;
}

VTI_INLINE int is_of_slice(const vti_bodies *b, int64_t body)
{
    return (uint64_t)body - (uint64_t)b->first < (uint64_t)b->count;
}

/** Adds the rows of the bonds first <= k < last to those of their bodies that are in the slice. */
VTI_INLINE void sum_all(enum layout layout, int forces, int moments, const vti_bonds *bonds, const vti_bodies *bodies,
                        int64_t first, int64_t last, const double *rows)
{
    const vti_bodies b = *bodies;
    const int64_t *const ends = bonds->pair, base = bonds->base;
    struct sums s = {-1, triple_of(0.0, 0.0, 0.0), triple_of(0.0, 0.0, 0.0)};
    for (int64_t k = first; k < last; ++k, rows += VTI_BOND_LOADS) {
        const int64_t i = ends[2 * k] - base, j = ends[2 * k + 1] - base;
        const struct triple force = triple_of(rows[0], rows[1], rows[6]);
        if (i != s.body)
            sums_turn(layout, forces, moments, &b, is_of_slice(&b, i) ? i : -1, &s);
        s.force = triple_plus(s.force, force);
        s.moment = triple_plus(s.moment, triple_of(rows[2], rows[3], rows[7]));
        if (!is_of_slice(&b, j))
            continue;
        if (forces)
            store(layout, &b.force, j, triple_minus(load(layout, &b.force, j), force));
        if (moments)
            store(layout, &b.moment, j, triple_plus(load(layout, &b.moment, j), triple_of(rows[4], rows[5], rows[8])));
    }
    sums_turn(layout, forces, moments, &b, -1, &s);
}

#define SUM(NAME, LAYOUT)                                                                                              \
    static void sum_##NAME(int terms, const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,        \
                           const double *rows)                                                                         \
    {                                                                                                                  \
        const int forces = terms & (TERM_AXIAL | TERM_SHEAR) && vti_has(&b->force);                                    \
        const int moments = terms & (TERM_MOMENT | TERM_SHEAR) && vti_has(&b->moment);                                 \
        if (forces && moments)                                                                                         \
            sum_all(LAYOUT, 1, 1, bonds, b, first, last, rows);                                                        \
        else if (forces || moments)                                                                                    \
            sum_all(LAYOUT, forces, moments, bonds, b, first, last, rows);                                             \
    }
SUM(packed, ALPHA)
SUM(any, ANY)

/* ---- kernels ----------------------------------------------------------------------------------------------------- */

#define LOADS(LAYOUT, NAME, TERMS_, FORM)                                                                              \
    static void loads_##LAYOUT##_##NAME(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,      \
                                        double *rows)                                                                  \
    {                                                                                                                  \
        loads_all(TERMS_, FORM, LAYOUT, bonds, b, first, last, rows);                                                  \
    }
#define KERNEL(NAME, TERMS_, FORM)                                                                                     \
    LOADS(ALPHA, NAME, TERMS_, FORM)                                                                                   \
    LOADS(QUAT, NAME, TERMS_, FORM)                                                                                    \
    LOADS(ANY, NAME, TERMS_, FORM)                                                                                     \
    static void energy_##NAME(const vti_bonds *bonds, const vti_bodies *b, double *energies)                           \
    {                                                                                                                  \
        energy_all(TERMS_, FORM, bonds, b, energies);                                                                  \
    }

/** A kernel of terms to which turns matter, in a form that knows them. */
#define TURNED_KERNEL(NAME, TERMS_, FORM)                                                                              \
    KERNEL(NAME, TERMS_, FORM)                                                                                         \
    static void loads_TURNED_##NAME(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,          \
                                    double *rows)                                                                      \
    {                                                                                                                  \
        loads_turned(TERMS_, FORM, bonds, b, first, last, rows);                                                       \
    }

#define SHEAR_KERNELS(MAKE, SHEAR, FORM)                                                                               \
    MAKE(SHEAR, TERM_SHEAR, FORM)                                                                                      \
    MAKE(moment_##SHEAR, TERM_SHEAR | TERM_MOMENT, FORM)                                                               \
    MAKE(axial_##SHEAR, TERM_SHEAR | TERM_AXIAL, FORM)                                                                 \
    MAKE(moment_axial_##SHEAR, TERM_SHEAR | TERM_MOMENT | TERM_AXIAL, FORM)

KERNEL(none, 0, 0)
TURNED_KERNEL(moment, TERM_MOMENT, 0)
KERNEL(axial, TERM_AXIAL, 0)
TURNED_KERNEL(moment_axial, TERM_MOMENT | TERM_AXIAL, 0)
SHEAR_KERNELS(TURNED_KERNEL, objective, VTI_SHEAR_OBJECTIVE)
SHEAR_KERNELS(TURNED_KERNEL, quartic, VTI_SHEAR_QUARTIC)
SHEAR_KERNELS(KERNEL, printed, VTI_SHEAR_PRINTED)

#define PICK(NAME)                                                                                                     \
    {                                                                                                                  \
        {loads_ALPHA_##NAME, loads_QUAT_##NAME, loads_ANY_##NAME, NULL}, energy_##NAME                                 \
    }
#define PICK_TURNED(NAME)                                                                                              \
    {                                                                                                                  \
        {loads_ALPHA_##NAME, loads_QUAT_##NAME, loads_ANY_##NAME, loads_TURNED_##NAME}, energy_##NAME                  \
    }
#define PICK_SHEAR(PICK_ONE, SHEAR)                                                                                    \
    {                                                                                                                  \
        PICK_ONE(SHEAR), PICK_ONE(moment_##SHEAR), PICK_ONE(axial_##SHEAR), PICK_ONE(moment_axial_##SHEAR)             \
    }

const struct bond_kernels BOND_KERNELS = {{{PICK(none), PICK_TURNED(moment), PICK(axial), PICK_TURNED(moment_axial)},
                                           PICK_SHEAR(PICK_TURNED, objective),
                                           PICK_SHEAR(PICK_TURNED, quartic),
                                           PICK_SHEAR(PICK, printed)},
                                          {sum_packed, sum_any},
                                          measure};
