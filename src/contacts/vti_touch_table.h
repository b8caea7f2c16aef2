/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of touches and of drag, for the vector units that there may be. */
#ifndef VTI_TOUCH_TABLE_H
#define VTI_TOUCH_TABLE_H

#include "vti_history.h"
#include "../vti_processor.h"

/** So many pairs at most are handed to a kernel at once, a whole number of lanes of any width. */
enum { VTI_TOUCHES = 64 };

/** Of a length: what begins just touching, up to rounding, lacks of that. */
#define VTI_JUST_TOUCHING (1.0 - 1e-12)

/** Pairs, or bodies at one wall, the springs of which follow a drift. */
struct vti_carried {
    int64_t count;
    int64_t which[VTI_TOUCHES];  /* their numbers in the list, or the bodies */
    vti_held *held[VTI_TOUCHES]; /* their slots, each another one */
    double delta[VTI_TOUCHES];   /* overlaps after the drift, which the kernel finds */
    /** Whether turn has the increments of attitude, as where bodies turn by L; else the law gives them by Omega. */
    int turned;
    /** Those of i, and of j of pairs; beyond count, up to a whole number of lanes, the last ones again. */
    double turn[6][VTI_TOUCHES];
};

struct vti_sweep;      /* of dashpots (vti_dashpot_flow.h) */
struct vti_bond_sweep; /* of bonds' (vti_bond_flow.h) */

struct vti_touch_kernels {
    /** Of so many pairs of the list from the first on those with directions and no gap wider than reach, in their
     *  order, into pair[count], unless that is NULL: k where pair k overlaps, -1 - k where there is a gap. Returns how
     *  many. */
    int64_t (*near)(const vti_contacts *p, const vti_bodies *b, double reach, int64_t first, int64_t count,
                    int64_t *pair);
    /** Of so many bodies, from 1 to 64, from the first on those at most reach away from wall w, as bits, and perhaps
     *  others. Where a drift of time h > 0 has been, those that have been as near before it, too. */
    uint64_t (*near_wall)(const vti_walls *p, const vti_bodies *b, double reach, double h, int64_t w, int64_t first,
                          int64_t count);
    /** Adds what the springs of pairs hold to forces and moments, pair by pair in their order. */
    void (*push)(const vti_friction *p, const vti_bodies *b, int64_t count, const int64_t *pair, vti_held *const *held);
    /** And those of bodies at wall w. */
    void (*push_at)(const vti_friction *p, const vti_bodies *b, int64_t w, int64_t count, const int64_t *body,
                    vti_held *const *held);
    void (*carry)(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, struct vti_carried *pairs);
    void (*carry_at)(const vti_friction *p, const vti_bodies *b, const vti_drifted *drifted, int64_t w,
                     struct vti_carried *bodies);
    /** Of so many pairs that are apart, the numbers of those that will overlap at the other end of the drift: delta -
     *  drift u.n > 0. Returns how many. */
    int64_t (*soon)(const struct vti_sweep *s, int64_t count, const int64_t *apart, int64_t *pair);
    /** The dashpots of pairs no two of which share a body. */
    void (*flow)(const struct vti_sweep *s, int64_t count, const int64_t *pair);
    /** And those of bodies at wall w, each another one, that are within reach of it. */
    void (*flow_at)(const struct vti_sweep *s, int64_t w, int64_t count, const int64_t *body);
    /** And those of bonds no two of which share a body. */
    void (*flow_bonds)(const struct vti_bond_sweep *s, int64_t count, const int64_t *bond);
    /** Drag on the bodies from begin to end, on their translation (book 0) or on their turn by Omega (1), booked there.
     *  Returns the first body that is left to do, one whose speed is out of range, or end. */
    int64_t (*drag)(const vti_drag *p, const vti_bodies *b, double t, int book, int64_t begin, int64_t end);
    /** Adds what the pairs of a list press to the forces, pair by pair in their order. */
    void (*press)(const vti_contacts *p, const vti_bodies *b);
    /** And what wall w presses to so many bodies from the first on. */
    void (*press_at)(const vti_walls *p, const vti_bodies *b, int64_t w, int64_t first, int64_t count);
    /** The first pair from the first on that has begun or ended to touch since bodies were where before says; p->count
     *  if none has. */
    int64_t (*crossing)(const vti_contacts *p, const vti_view *before, const vti_bodies *b, int64_t first);
    /** The first body of the slice that has so at a wall within the time h; the slice's end if none has. */
    int64_t (*crossing_wall)(const vti_walls *p, double h, const vti_view *before, const vti_bodies *b, int64_t first);
};

/** The pair's number in the list, of what near has found. */
static inline int64_t vti_touch_number(int64_t found)
{
    return found < 0 ? -1 - found : found;
}

/** The same bits from each. */
extern const struct vti_touch_kernels vti_touch_baseline, vti_touch_avx2, vti_touch_avx512;

/** Those for so many pairs. */
static inline const struct vti_touch_kernels *vti_touch_kernels_for(int64_t count)
{
    (void)count;
#ifdef VTI_HAS_AVX512
    if (count > 4 && vti_serves_avx512())
        return &vti_touch_avx512;
#endif
#ifdef VTI_HAS_AVX2
    if (count > 2 && vti_serves_avx2())
        return &vti_touch_avx2;
#endif
    return &vti_touch_baseline;
}

#endif
