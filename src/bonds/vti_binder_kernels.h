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

#include "vti_binder_chain.h"

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

/** The rows of the bonds first <= k < last. The last block begins earlier, if it is not whole: where the list is long
 *  enough some bonds are evaluated twice. */
VTI_INLINE void loads_all(int terms, int form, enum layout layout, const vti_bonds *bonds, const vti_bodies *bodies,
                          int64_t first, int64_t last, double *rows)
{
    const vti_bodies b = *bodies; /* what nobody else can change stays in registers */
    double rest[WIDTH * VTI_BOND_LOADS];
    struct vti_few_bonds few;
    for (; first < last; first += WIDTH, rows += WIDTH * VTI_BOND_LOADS) {
        const int64_t left = last - first < WIDTH ? last - first : WIDTH, begin = first + left - WIDTH;
        const vti_bonds block = begin >= 0 ? from(bonds, begin) : vti_bonds_filled(bonds, first, last, WIDTH, &few);
        /* cppcheck-suppress legacyUninitvar ; it is written */
        evaluate(terms, form, layout, &block, &b, left == WIDTH ? rows : rest);
        if (left < WIDTH)
            memcpy(rows, rest + (begin >= 0 ? WIDTH - left : 0) * VTI_BOND_LOADS,
                   (size_t)left * VTI_BOND_LOADS * sizeof *rows);
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
    struct vti_few_bonds few;
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
    struct vti_few_bonds few;
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
    struct vti_few_bonds few;
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
            sums_turn(layout, forces, moments, &b, vti_owns(&b, i) ? i : -1, &s);
        s.force = triple_plus(s.force, force);
        s.moment = triple_plus(s.moment, triple_of(rows[2], rows[3], rows[7]));
        if (!vti_owns(&b, j))
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
    static int64_t chain_##NAME(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last)              \
    {                                                                                                                  \
        return last - first < WIDTH ? first : chain_all(TERMS_, FORM, bonds, b, first, last);                          \
    }                                                                                                                  \
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
        {loads_ALPHA_##NAME, loads_QUAT_##NAME, loads_ANY_##NAME, NULL}, chain_##NAME, energy_##NAME                   \
    }
#define PICK_TURNED(NAME)                                                                                              \
    {                                                                                                                  \
        {loads_ALPHA_##NAME, loads_QUAT_##NAME, loads_ANY_##NAME, loads_TURNED_##NAME}, chain_##NAME, energy_##NAME    \
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
