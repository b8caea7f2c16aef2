/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds in a row: bond l of a block joins bodies i + l and i + l + 1, as those of chains and rings do, and the last one
 * i + WIDTH - 1 and any other, so that rings close. Their bodies are read and their loads added a whole block at a
 * time, without rows of loads. Body i + l takes what bond l - 1 has for its second body and then what bond l has for
 * its first, as in the order of the list, so that the bits are the same. */
#ifndef VTI_BINDER_CHAIN_H
#define VTI_BINDER_CHAIN_H

#include "vti_binder_gather.h"

/** Whether some alpha of WIDTH bonds is so large that it has to be scaled. No |alpha_k| > VTI_RRV_LARGE gets past the
 *  square of its pair. */
VTI_INLINE int is_large(const struct bond_state *s)
{
    const double most = 0.25 * VTI_RRV_LARGE * VTI_RRV_LARGE;
    return !(lanes_all(lanes_square(s->qi) <= most) && lanes_all(lanes_square(s->qj) <= most));
}

/** The first body of a block whose bonds join bodies in a row, all of the slice; -1 of any other. */
VTI_INLINE int64_t chain_begin(const vti_bonds *block, const vti_bodies *b)
{
    const int64_t i = block->pair[0] - block->base, last = block->pair[2 * WIDTH - 1] - block->base;
    return lanes_are_row(block->pair) && vti_owns(b, i) && vti_owns(b, i + WIDTH - 1) && vti_owns(b, last) ? i : -1;
}

/** Adds to the loads of bodies i ... i + WIDTH - 1 what bonds have for their second bodies, the one before the block
 *  among them, and for their first ones. The last bond's is left in before. */
VTI_INLINE void add_in_row(const vti_view *load, int64_t i, lanes before[3], const lanes second[3],
                           const lanes first[3])
{
    double *const p = load->c[0] + 3 * i;
    lanes a[3], there[3];
    load_in_row(load, i, a);
    for (int c = 0; c < 3; ++c) {
        a[c] = (a[c] + lanes_after(before[c], second[c])) + first[c];
        before[c] = second[c];
    }
    lanes_join(a, there);
    for (int c = 0; c < 3; ++c)
        lanes_store(p + c * WIDTH, there[c]);
}

/** Adds what the last bond of a chain has for its second body. */
VTI_INLINE void end_row(const vti_view *load, int64_t i, const lanes before[3])
{
    for (int c = 0; c < 3; ++c)
        load->c[c][3 * i] += lanes_get(before[c], WIDTH - 1);
}

VTI_INLINE int64_t chain_all(int terms, int form, const vti_bonds *bonds, const vti_bodies *bodies, int64_t first,
                             int64_t last)
{
    const vti_bodies b = *bodies; /* what nobody else can change stays in registers */
    const int pulls = terms & (TERM_AXIAL | TERM_SHEAR), turns = terms & (TERM_MOMENT | TERM_SHEAR);
    const lanes none = lanes_of(-0.0); /* a sum leaves what -0 is added to as it is */
    lanes force[3] = {none, none, none}, moment[3] = {none, none, none};
    int64_t next = -1;
    if ((pulls && !vti_has(&b.force)) || (turns && !vti_has(&b.moment)))
        return first;
    for (; first + WIDTH <= last; first += WIDTH) {
        struct bond_state state;
        struct bond_loads loads;
        const vti_bonds block = from(bonds, first);
        const int64_t i = chain_begin(&block, &b);
        if (i < 0 || (next >= 0 && i != next))
            break;
        gather(terms, CHAIN, &block, &b, &state);
        if (turns && is_large(&state))
            break;
        bond_evaluate(terms, form, &state, &loads);
        const lanes back[3] = {-loads.force[0], -loads.force[1], -loads.force[2]};
        if (pulls)
            add_in_row(&b.force, i, force, back, loads.force);
        if (turns)
            add_in_row(&b.moment, i, moment, loads.moment_j, loads.moment_i);
        next = block.pair[2 * WIDTH - 1] - block.base;
    }
    if (pulls && next >= 0)
        end_row(&b.force, next, force);
    if (turns && next >= 0)
        end_row(&b.moment, next, moment);
    return first;
}

#endif
