/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Neighbours: the pairs of spheres that touch or may soon, for vti_contacts. A Verlet list: it holds the pairs whose
 * gap was below the skin when it was built, and is built anew, from a list of cells, once a body has moved by more than
 * half the skin against what all have moved together, so that no pair ever touches without being in it.
 *
 * The domain has no bounds; only cells with bodies in them exist, so that bodies that fly away cost nothing. Time and
 * memory are O(n + pairs), of spheres of any sizes: small ones have narrower cells (cells.h). At random places, with
 * equal volumes of two sizes that fill 0.6, a build takes 1.9 times the instructions of equal spheres per body for
 * diameters of 1:3, 1.6 times for 1:5 and 1.5 times for 1:10; 3.1 times for all sizes between 1 and 20 in equal shares
 * of the volume. */
#ifndef VTI_NEIGHBOURS_H
#define VTI_NEIGHBOURS_H

#include "vti.h"

#include "message.h"

struct neighbours {
    int64_t count;
    int64_t *pair;         /* [count][2]: i < j from 0, ascending by i, then by j; moves when the list is built anew */
    double skin;           /* length, of the last build */
    double reach;          /* length below the skin, 0 when it is made: it also holds all pairs with a gap below that */
    int64_t builds;        /* how often it has been built */
    const int64_t *owner;  /* [n] or NULL, as it is made; the caller's: spheres of one owner are never a pair */
    const int64_t *number; /* [n] or NULL, as it is made; the caller's: what people call them */
    struct neighbours_search *search;
};

/** Makes an empty list of n >= 0 spheres; the first update fills it.
 *
 *  diameter [n]   > 0 and finite; copied
 *  skin           a length > 0, or 0: it begins at 0.2 of the mean diameter and grows up to all of it while builds
 *                 cost more than the pairs that a wider one adds
 *  excluded       [excluded_count][2] bodies from 0, in any order and either way round: pairs that are never in the
 *                 list, such as those that bonds hold; copied. NULL if there are none
 *
 *  Returns 0, or -1 with one line in *message that names the body or the pair at fault, and *list as after
 *  neighbours_destroy. */
int neighbours_create(struct neighbours *list, int64_t n, const vti_scalars *diameter, double skin,
                      int64_t excluded_count, const int64_t *excluded, struct message *message);

/** Makes the list hold every pair that touches, or has a gap below list->reach, at the positions x [n], which must not
 *  be absent. Which others it holds depends on when it was built; as it is sorted and others add nothing, sums over it
 *  depend on x alone, to the bit.
 *
 *  Returns 1 if it was built anew, 0 if it still held, or -1 with one line in *message, if a position is not finite
 *  (the line names the body) or memory is out. The list is empty then, and the next update builds it. */
int neighbours_update(struct neighbours *list, const vti_view *x, struct message *message);

/** Whether the list has every pair that touches at the positions x [n], or has a gap below list->reach, as it stands:
 *  1 or 0. */
int neighbours_hold(struct neighbours *list, const vti_view *x);
/** Whether the pair of bodies i < j is never in the list: excluded, or of one owner. */
int neighbours_exclude(const struct neighbours *list, int64_t i, int64_t j);

/** From the next update on the pair of bodies, either way round, is in the list where it is near, though it was
 *  excluded. Harmless for one that was not. */
void neighbours_release(struct neighbours *list, int64_t i, int64_t j);

/** Frees the list's memory; harmless for one that is destroyed already or all zeros. */
void neighbours_destroy(struct neighbours *list);

#endif
