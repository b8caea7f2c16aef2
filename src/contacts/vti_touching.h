/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What is kept of a list of pairs in the caller's memory (vti_touching). Nothing of it is believed: before it is used it
 * is compared with what it is of. */
#ifndef VTI_TOUCHING_H
#define VTI_TOUCHING_H

#include "vti_history.h"

/** So many pairs are worked in an order of their own, by so many colours. */
enum { VTI_WINDOW = 256, VTI_COLOURS = 64 };

/** In which order the pairs of a window are worked. */
struct vti_order {
    int64_t count, colours;     /* pairs, and how many colours they have */
    int64_t number[VTI_WINDOW]; /* theirs in the list */
    int64_t place[VTI_WINDOW];  /* which of them is the first one to be worked, the second ... */
    int64_t ends[VTI_COLOURS];  /* of the colours, in their order */
};

/** Where it is; NULL where there is none. */
struct vti_list_kept {
    int64_t *slot;       /* [pairs] that of the table where each has been, or would have been; NULL without a table */
    const int64_t *home; /* [pairs] that at which one begins to look for it */
    struct vti_order *order; /* [windows] */
};

/** That of this list and table, which may be NULL, made anew if it is another's. */
struct vti_list_kept vti_touching_take(const vti_touching *touching, const vti_contacts *list,
                                       const vti_history *table);
/** The same for those who only read it: none if it is another's. */
struct vti_list_kept vti_touching_read(const vti_touching *touching, const vti_contacts *list,
                                       const vti_history *table);

/** Whether the slot where the touch i, j, pair k, has been is still that of it: it holds this touch, which no other does,
 *  or it is empty, and one begins there. */
VTI_INLINE int vti_touching_stays(const struct vti_list_kept *kept, const vti_history *table, int64_t k, int64_t i,
                                  int64_t j)
{
    const int64_t at = kept->slot[k];
    const vti_held *const held = &table->slot[at];
    return held->i == i ? held->j == j : held->i == 0 && at == kept->home[k];
}

/** The slot of it, or the empty one where it would be. */
VTI_INLINE vti_held *vti_touching_find(const struct vti_list_kept *kept, const vti_history *table, int64_t k, int64_t i,
                                       int64_t j)
{
    if (kept->slot != NULL && vti_touching_stays(kept, table, k, i, j))
        return &table->slot[kept->slot[k]];
    return vti_history_at(table, i, j);
}

/** Likewise, and remembers it. */
VTI_INLINE vti_held *vti_touching_slot(const struct vti_list_kept *kept, const vti_history *table, int64_t k, int64_t i,
                                       int64_t j)
{
    if (kept->slot == NULL)
        return vti_history_at(table, i, j);
    if (!vti_touching_stays(kept, table, k, i, j))
        kept->slot[k] = vti_history_at(table, i, j) - table->slot;
    return &table->slot[kept->slot[k]];
}

#endif
