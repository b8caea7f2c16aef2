/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies turned by vectors of their own in space, a body to a lane, as vti_move_turn_by does one: the attitudes in a
 * step of a multistep method, which turn by what vti_adams_kernels.h finds. Lanes that are left over do the last body
 * once more, with the same result. Included by vti_move_kernels.h only. */
#ifndef VTI_ADAMS_TURNS_H
#define VTI_ADAMS_TURNS_H

#include "vti_adams_magnus.h"
#include "../move/vti_turn_kernels.h"

/** Turns the bodies of the lanes; 0, and nothing is written, where one turns by so much, or has turned so far, that
 *  they are to be done one by one. */
VTI_INLINE int adams_turn_alphas(int law, lanes s2, const lanes u[3], const vti_view *alpha, int adjacent, int64_t i,
                                 int64_t n)
{
    lanes a[3];
    int64_t at[WIDTH];
    adams_places(n, alpha->stride, at);
    if (adjacent)
        lanes_triples(alpha->c[0] + i * alpha->stride, at, a);
    else
        for (int k = 0; k < 3; ++k)
            a[k] = lanes_gather(alpha->c[k] + i * alpha->stride, at);
    if (!turn_alphas(law, 1.0, s2, u, a))
        return 0;
    if (adjacent)
        lanes_untriple(alpha->c[0] + i * alpha->stride, at, a);
    else
        for (int k = 0; k < 3; ++k)
            lanes_scatter(alpha->c[k] + i * alpha->stride, at, a[k]);
    return 1;
}

VTI_INLINE int adams_turn_quats(int law, lanes s2, const lanes u[3], const vti_quat_view *quat, int adjacent, int64_t i,
                                int64_t n)
{
    lanes q[4], r[4];
    int64_t at[WIDTH];
    if (!lanes_all(s2 < 8.0))
        return 0;
    adams_places(n, quat->stride, at);
    if (adjacent)
        lanes_quads(quat->xyzw[0] + i * quat->stride, at, q);
    else
        for (int k = 0; k < 4; ++k)
            q[k] = lanes_gather(quat->xyzw[k] + i * quat->stride, at);
    turn_quats(law, 1.0, s2, u, q, r);
    if (adjacent)
        lanes_unquad(quat->xyzw[0] + i * quat->stride, at, r);
    else
        for (int k = 0; k < 4; ++k)
            lanes_scatter(quat->xyzw[k] + i * quat->stride, at, r[k]);
    return 1;
}

/** Of so many it pays to fill the lanes; fewer are for narrower ones. */
enum { ADAMS_LEAST = WIDTH < 8 ? 2 : 5 };

VTI_INLINE int64_t adams_turn_many(int64_t each, const double *by, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int law = adams_law(each);
    const vti_view alpha = b->alpha;
    const vti_quat_view quat = b->quat;
    const int by_alpha = vti_has(&alpha), adjacent = by_alpha ? stream_of(&alpha).adjacent : quat_is_adjacent(&quat);
    int64_t i = begin;
    for (int64_t n; end - i >= ADAMS_LEAST; i += n, by += each * n) {
        lanes u[3];
        n = end - i < WIDTH ? end - i : WIDTH;
        adams_theta(by, each, n, u);
        const lanes s2 = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        const int turned = by_alpha ? adams_turn_alphas(law, s2, u, &alpha, adjacent, i, n)
                                    : adams_turn_quats(law, s2, u, &quat, adjacent, i, n);
        for (int l = 0; !turned && l < n; ++l) {
            const double one[3] = {lanes_get(u[0], l), lanes_get(u[1], l), lanes_get(u[2], l)};
            vti_move_turn_by(law, one, b, i + l);
        }
    }
    return i;
}

static int64_t adams_turn(const double *by, int64_t each, const vti_bodies *b, int64_t begin, int64_t end)
{
    return each == ADAMS_CORRECTION ? adams_turn_many(ADAMS_CORRECTION, by, b, begin, end)
                                    : adams_turn_many(ADAMS_PREDICTION, by, b, begin, end);
}

#endif
