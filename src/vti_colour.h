/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The order of pairs whose flows change velocities (EQUATIONS 6.4), as many together as a window holds: each has the
 * smallest colour that neither of its bodies has yet; they are worked colour by colour, in their order inside, backwards
 * exactly reversed. Pairs of a colour share no body, so that they may be lanes; those of the last may. */
#ifndef VTI_COLOUR_H
#define VTI_COLOUR_H

#include "vti_touch_table.h"

enum { VTI_WINDOW = 256, VTI_COLOURS = 64, VTI_COLOUR_LAST = VTI_COLOURS - 1, VTI_WINDOW_BODIES = 4 * VTI_WINDOW };

struct vti_window {
    int64_t sorted[VTI_WINDOW]; /* numbers of pairs as they are worked */
    int64_t colour[VTI_WINDOW];
    int64_t ends[VTI_COLOURS]; /* of the colours, in their order */
    struct {
        int64_t body;      /* from 1; 0: nobody */
        uint64_t coloured; /* colours of its pairs, as bits */
    } table[VTI_WINDOW_BODIES];
    int64_t taken[2 * VTI_WINDOW]; /* slots of it that are */
    int64_t slots;                 /* of it, a power of 2 */
};

/** Nobody is in the table, which serves windows of a list of so many pairs. */
static inline void vti_window_clear(struct vti_window *w, int64_t pairs)
{
    w->slots = 8;
    while (w->slots < VTI_WINDOW_BODIES && w->slots < 4 * pairs)
        w->slots *= 2;
    for (int64_t k = 0; k < w->slots; ++k)
        w->table[k].body = 0;
}

/** Where body i stands in the table. */
VTI_INLINE int64_t vti_window_slot(struct vti_window *w, int64_t i)
{
    int64_t at = (int64_t)((uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) >> 40) & (w->slots - 1);
    while (w->table[at].body != 0 && w->table[at].body != i + 1)
        at = (at + 1) & (w->slots - 1);
    if (w->table[at].body == 0) {
        w->table[at].body = i + 1;
        w->table[at].coloured = 0;
    }
    return at;
}

/** The smallest colour that is not among those; the last is always free. */
VTI_INLINE int64_t vti_colour_free(uint64_t coloured)
{
    int64_t c = 0;
    for (coloured &= ~(UINT64_C(1) << VTI_COLOUR_LAST); (coloured & 15) == 15; coloured >>= 4)
        c += 4;
    return c + (INT64_C(0x4010201030102010) >> 4 * (coloured & 15) & 15);
}

/** Colours of pairs (as vti_touch_number has them), and the end of each. Nobody is left in the table. Returns how many
 *  there are. */
static inline int64_t vti_window_colour(struct vti_window *w, const int64_t *pair, int64_t base, const int64_t *found,
                                        int64_t count)
{
    int64_t of[VTI_COLOURS] = {0}, most = 0, end = 0;
    for (int64_t n = 0; n < count; ++n) {
        const int64_t *const bodies = pair + 2 * vti_touch_number(found[n]);
        const int64_t i = vti_window_slot(w, bodies[0] - base), j = vti_window_slot(w, bodies[1] - base);
        const int64_t c = vti_colour_free(w->table[i].coloured | w->table[j].coloured);
        w->table[i].coloured |= UINT64_C(1) << c;
        w->table[j].coloured |= UINT64_C(1) << c;
        w->taken[2 * n] = i;
        w->taken[2 * n + 1] = j;
        w->colour[n] = c;
        most = c > most ? c : most;
        ++of[c];
    }
    for (int64_t c = 0; c <= most; ++c)
        w->ends[c] = end += of[c];
    for (int64_t n = 0; n < 2 * count; ++n)
        w->table[w->taken[n]].body = 0;
    return most + 1;
}

/** Works so many pairs of one colour in this order, no more than most at once. */
typedef void vti_colour_work(const void *context, const int64_t *found, int64_t count, int64_t most);

/** Works the pairs of a list that one window holds, backwards or forwards. */
static inline void vti_window_work(struct vti_window *w, const int64_t *pair, int64_t base, const int64_t *found,
                                   int64_t count, int back, vti_colour_work *work, const void *context)
{
    const int64_t colours = vti_window_colour(w, pair, base, found, count);
    int64_t to[VTI_COLOURS] = {0};
    for (int64_t c = 1; c < colours; ++c)
        to[c] = w->ends[c - 1];
    for (int64_t n = 0; n < count; ++n) {
        const int64_t at = to[w->colour[n]]++;
        w->sorted[back ? count - 1 - at : at] = found[n];
    }
    for (int64_t k = 0; k < colours; ++k) {
        const int64_t c = back ? colours - 1 - k : k, first = c > 0 ? w->ends[c - 1] : 0, end = w->ends[c];
        work(context, w->sorted + (back ? count - end : first), end - first, c == VTI_COLOUR_LAST ? 1 : VTI_TOUCHES);
    }
}

#endif
