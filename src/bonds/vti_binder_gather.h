/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Loads the parameters and bodies of WIDTH bonds into vector lanes, a bond to a lane. */
#ifndef VTI_BINDER_GATHER_H
#define VTI_BINDER_GATHER_H

#include "vti_pair.h"

/* ---- blocks of the list ------------------------------------------------------------------------------------------ */

/** The bonds from first on. What is absent is NULL, to which C lets nobody add 0. */
VTI_INLINE vti_bonds from(const vti_bonds *bonds, int64_t first)
{
    vti_bonds block = *bonds;
    vti_scalars *const all[TERMS] = {&block.moment, &block.axial, &block.shear};
    if (first == 0)
        return block;
    block.pair += 2 * first;
    block.rest += 4 * first;
    if (block.turn != NULL)
        block.turn += 4 * first;
    for (int c = 0; c < TERMS; ++c)
        if (all[c]->p != NULL)
            all[c]->p += first * all[c]->stride;
    return block;
}

/** WIDTH bonds from first on, or those up to last as a whole block. */
VTI_INLINE vti_bonds block_at(const vti_bonds *bonds, int64_t first, int64_t last, struct vti_few_bonds *few)
{
    return last - first >= WIDTH ? from(bonds, first) : vti_bonds_filled(bonds, first, last, WIDTH, few);
}

/* ---- gather ------------------------------------------------------------------------------------------------------ */

/** The components of the packed vectors of bodies i ... i + WIDTH - 1. */
VTI_INLINE void load_in_row(const vti_view *view, int64_t i, lanes r[3])
{
    const double *const p = view->c[0] + 3 * i;
    const lanes there[3] = {lanes_load(p), lanes_load(p + WIDTH), lanes_load(p + 2 * WIDTH)};
    lanes_split(there, r);
}

VTI_INLINE void gather_vectors(enum layout layout, const vti_view *view, const int64_t body[WIDTH], lanes r[3])
{
    int64_t at[WIDTH];
    if (layout == CHAIN) {
        load_in_row(view, body[0], r);
        return;
    }
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
    if (layout == ALPHA || layout == CHAIN) {
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

/** Of the second bodies of bonds in a row: those of the first but one, and any other. */
VTI_INLINE void follow_end(int terms, const vti_bonds *block, const vti_bodies *b, const lanes qi[4], const lanes xi[3],
                           lanes qj[4], lanes xj[3])
{
    const int64_t last = 3 * (block->pair[2 * WIDTH - 1] - block->base);
    for (int k = 0; k < 3 && terms & (TERM_MOMENT | TERM_SHEAR); ++k)
        qj[k] = lanes_before(qi[k], 0.5 * b->alpha.c[0][last + k]);
    qj[3] = lanes_of(1.0);
    for (int k = 0; k < 3 && terms & (TERM_AXIAL | TERM_SHEAR); ++k)
        xj[k] = lanes_before(xi[k], b->x.c[0][last + k]);
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
    if (layout == CHAIN)
        follow_end(terms, block, b, s->qi, s->d, s->qj, xj);
    else
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

#endif
