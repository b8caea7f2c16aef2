/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The order of pairs whose flows change velocities (EQUATIONS 6.4), as many together as a window holds: each has the
 * smallest colour that neither of its bodies has yet; they are worked colour by colour, in their order inside,
 * backwards exactly reversed. Pairs of a colour share no body, and go into lanes; those of the last may, and go one by
 * one. */
#ifndef VTI_COLOUR_H
#define VTI_COLOUR_H

#include <string.h>

#include "../vti_views.h"
#include "../contacts/vti_touch_table.h"

enum { VTI_WINDOW = 256, VTI_COLOURS = 64, VTI_COLOUR_LAST = VTI_COLOURS - 1, VTI_WINDOW_SLOTS = 4 * VTI_WINDOW };

struct vti_window {
    int64_t sorted[VTI_WINDOW]; /* numbers of pairs as they are worked */
    int64_t colour[VTI_WINDOW];
    int64_t ends[VTI_COLOURS]; /* of the colours, in their order */
    int64_t bodies;            /* how many there are, from 1 on: */
    int64_t body[2 * VTI_WINDOW + 1];
    uint64_t coloured[2 * VTI_WINDOW + 1]; /* colours of its pairs, as bits */
    int16_t slot[VTI_WINDOW_SLOTS];        /* which of them each is; 0: none */
};

/** Which of the window's bodies is i, that may be new. */
VTI_INLINE int64_t vti_window_at(struct vti_window *w, int64_t slots, int64_t i)
{
    int64_t at = (int64_t)((uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) >> 40) & (slots - 1);
    while (w->slot[at] != 0 && w->body[w->slot[at]] != i)
        at = (at + 1) & (slots - 1);
    if (w->slot[at] == 0) {
        w->slot[at] = (int16_t)++w->bodies;
        w->body[w->bodies] = i;
        w->coloured[w->bodies] = 0;
    }
    return w->slot[at];
}

/** The smallest colour that is not among those; the last is always free. */
VTI_INLINE int64_t vti_colour_free(uint64_t coloured)
{
    return vti_first_bit(~coloured | UINT64_C(1) << VTI_COLOUR_LAST);
}

/** Colours of pairs (as vti_touch_number has them), and the end of each. Returns how many there are. */
static inline int64_t vti_window_colour(struct vti_window *w, const int64_t *pair, const int64_t *found, int64_t count)
{
    int64_t of[VTI_COLOURS] = {0}, slots = 8, most = 0, end = 0, last = 0, i = 0;
    while (slots < 4 * count)
        slots *= 2;
    memset(w->slot, 0, (size_t)slots * sizeof *w->slot);
    w->bodies = 0;
    for (int64_t n = 0; n < count; ++n) {
        const int64_t *const bodies = pair + 2 * vti_touch_number(found[n]);
        if (n == 0 || bodies[0] != last) /* lists have the pairs of a body one after the other */
            i = vti_window_at(w, slots, bodies[0]);
        last = bodies[0];
        const int64_t j = vti_window_at(w, slots, bodies[1]), c = vti_colour_free(w->coloured[i] | w->coloured[j]);
        w->coloured[i] |= UINT64_C(1) << c;
        w->coloured[j] |= UINT64_C(1) << c;
        w->colour[n] = c;
        most = c > most ? c : most;
        ++of[c];
    }
    for (int64_t c = 0; c <= most; ++c)
        w->ends[c] = end += of[c];
    return most + 1;
}

/** Works so many pairs of one colour in this order, no more than most at once. */
typedef void vti_colour_work(const void *context, const int64_t *found, int64_t count, int64_t most);

/** Works the pairs of a list that one window holds, backwards or forwards. */
static inline void vti_window_work(struct vti_window *w, const int64_t *pair, const int64_t *found, int64_t count,
                                   int back, vti_colour_work *work, const void *context)
{
    const int64_t colours = vti_window_colour(w, pair, found, count), step = back ? -1 : 1;
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
