/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The order of pairs whose flows change velocities (EQUATIONS 6.4), as many together as a window holds: each has the
 * smallest colour that neither of its bodies has yet; they are worked colour by colour, in their order inside, backwards
 * exactly reversed. Pairs of a colour share no body, and go into lanes; those of the last may, and go one by one. */
#ifndef VTI_COLOUR_H
#define VTI_COLOUR_H

#include <string.h>

#include "../contacts/vti_touch_table.h"

enum { VTI_WINDOW = 256, VTI_COLOURS = 64, VTI_COLOUR_LAST = VTI_COLOURS - 1, VTI_WINDOW_BODIES = 4 * VTI_WINDOW };

struct vti_window {
    int64_t sorted[VTI_WINDOW]; /* numbers of pairs as they are worked */
    int64_t colour[VTI_WINDOW];
    int64_t ends[VTI_COLOURS]; /* of the colours, in their order */
    struct vti_window_body {
        int64_t body;      /* from 1; 0: nobody */
        uint64_t coloured; /* colours of its pairs, as bits */
    } table[VTI_WINDOW_BODIES];
    struct vti_window_body *taken[2 * VTI_WINDOW]; /* slots of it that are */
    int64_t bodies;                                /* how many */
    int64_t slots;                                 /* of it, a power of 2 */
};

/** Nobody is in the table, which serves windows of a list of so many pairs. */
static inline void vti_window_clear(struct vti_window *w, int64_t pairs)
{
    w->slots = 8;
    while (w->slots < VTI_WINDOW_BODIES && w->slots < 4 * pairs)
        w->slots *= 2;
    w->bodies = 0;
    memset(w->table, 0, (size_t)w->slots * sizeof *w->table); /* all of it: wider stores than those of bodies alone */
}

/** Body i in the table. */
VTI_INLINE struct vti_window_body *vti_window_at(struct vti_window *w, int64_t i)
{
    int64_t at = (int64_t)((uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) >> 40) & (w->slots - 1);
    while (w->table[at].body != 0 && w->table[at].body != i + 1)
        at = (at + 1) & (w->slots - 1);
    struct vti_window_body *const of = &w->table[at];
    if (of->body == 0) {
        of->body = i + 1;
        of->coloured = 0;
        w->taken[w->bodies++] = of;
    }
    return of;
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
    int64_t of[VTI_COLOURS] = {0}, most = 0, end = 0, last = 0;
    struct vti_window_body *i = NULL;
    for (int64_t n = 0; n < count; ++n) {
        const int64_t *const bodies = pair + 2 * vti_touch_number(found[n]);
        if (n == 0 || bodies[0] != last) /* lists have the pairs of a body one after the other */
            i = vti_window_at(w, bodies[0] - base);
        last = bodies[0];
        struct vti_window_body *const j = vti_window_at(w, bodies[1] - base);
        const int64_t c = vti_colour_free(i->coloured | j->coloured);
        i->coloured |= UINT64_C(1) << c;
        j->coloured |= UINT64_C(1) << c;
        w->colour[n] = c;
        most = c > most ? c : most;
        ++of[c];
    }
    for (int64_t c = 0; c <= most; ++c)
        w->ends[c] = end += of[c];
    while (w->bodies > 0)
        w->taken[--w->bodies]->body = 0;
    return most + 1;
}

/** Works so many pairs of one colour in this order, no more than most at once. */
typedef void vti_colour_work(const void *context, const int64_t *found, int64_t count, int64_t most);

/** Works the pairs of a list that one window holds, backwards or forwards. */
static inline void vti_window_work(struct vti_window *w, const int64_t *pair, int64_t base, const int64_t *found,
                                   int64_t count, int back, vti_colour_work *work, const void *context)
{
    const int64_t colours = vti_window_colour(w, pair, base, found, count), step = back ? -1 : 1;
    int64_t to[VTI_COLOURS];
    for (int64_t c = 0; c < colours; ++c) {
        const int64_t first = c > 0 ? w->ends[c - 1] : 0;
        to[c] = back ? count - 1 - first : first;
    }
    for (int64_t n = 0; n < count; ++n) {
        int64_t *const at = &to[w->colour[n]];
        w->sorted[*at] = found[n];
        *at += step;
    }
    for (int64_t k = 0; k < colours; ++k) {
        const int64_t c = back ? colours - 1 - k : k, first = c > 0 ? w->ends[c - 1] : 0, end = w->ends[c];
        work(context, w->sorted + (back ? count - end : first), end - first, c == VTI_COLOUR_LAST ? 1 : VTI_TOUCHES);
    }
}

#endif
