/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Four lanes: AVX2. */
#ifndef VTI_LANES_FOUR_H
#define VTI_LANES_FOUR_H

#include "vti_lanes_fours.h"

VTI_INLINE int lanes_all(lanes_mask m)
{
    return four_bits(m) == 15;
}

VTI_INLINE lanes lanes_after(lanes before, lanes a)
{
    return SHUFFLE(before, a, 3, 4, 5, 6);
}

VTI_INLINE lanes lanes_before(lanes a, double next)
{
    return SHUFFLE(a, lanes_of(next), 1, 2, 3, 4);
}

VTI_INLINE void lanes_split(const lanes p[3], lanes a[3])
{
    const lanes x = SHUFFLE(p[0], p[1], 0, 1, 6, 7); /* x0 y0 x2 y2 */
    const lanes y = SHUFFLE(p[0], p[2], 2, 3, 4, 5); /* z0 x1 z2 x3 */
    const lanes z = SHUFFLE(p[1], p[2], 0, 1, 6, 7); /* y1 z1 y3 z3 */
    a[0] = SHUFFLE(x, y, 0, 5, 2, 7);
    a[1] = SHUFFLE(x, z, 1, 4, 3, 6);
    a[2] = SHUFFLE(y, z, 0, 5, 2, 7);
}

VTI_INLINE void lanes_join(const lanes a[3], lanes p[3])
{
    const lanes x = SHUFFLE(a[0], a[1], 0, 4, 2, 6);
    const lanes y = SHUFFLE(a[2], a[0], 0, 5, 2, 7);
    const lanes z = SHUFFLE(a[1], a[2], 1, 5, 3, 7);
    p[0] = SHUFFLE(x, y, 0, 1, 4, 5);
    p[1] = SHUFFLE(z, x, 0, 1, 6, 7);
    p[2] = SHUFFLE(y, z, 2, 3, 6, 7);
}

VTI_INLINE void lanes_spread(lanes k, lanes p[3])
{
    p[0] = SHUFFLE(k, k, 0, 0, 0, 1);
    p[1] = SHUFFLE(k, k, 1, 1, 2, 2);
    p[2] = SHUFFLE(k, k, 2, 3, 3, 3);
}

#define lanes_bits four_bits
#define lanes_gather four_gather
#define lanes_scatter four_scatter
#define lanes_triples four_triples
#define lanes_untriple four_untriple
#define lanes_quads four_quads
#define lanes_unquad four_unquad

#endif
