/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hosts of bodies of three principal moments: what they do is compared with Euler's equations (euler.c), and with what
 * comes of mistakes: L misunderstood at the first step, g = 0 or -1 later on, moments in another frame. */
#include "check.h"

#include <string.h>

/* ---- the first step ---------------------------------------------------------------------------------------------- */

/** R^before diag(k) R^after L */
static void tilted(const struct top *b, int before, const double k[3], int after, double w[3])
{
    memcpy(w, b->L, sizeof b->L);
    if (after != 0)
        vti_pair_rotate(b->q, after, w, w);
    for (int n = 0; n < 3; ++n)
        w[n] *= k[n];
    if (before != 0)
        vti_pair_rotate(b->q, before, w, w);
}

/** What the angular velocity of the start may have been taken for; text is room for that. */
static const char *rate_named(const struct top *b, const double found[3], char text[VTI_CHECK_TEXT])
{
    static const double one[3] = {1.0, 1.0, 1.0};
    static const char *const orders[5] = {"A, C, B", "B, A, C", "B, C, A", "C, A, B", "C, B, A"};
    static const int order[5][3] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const struct {
        int before, after, sign;
        int by; /* 0: 1, 1: 1/I, 2: I */
        const char *says;
    } mistake[] = {
        {0, 0, 1, 0, "the angular momentum is taken for an angular velocity: Omega for L"},
        {1, 0, 1, 1, "the angular momentum is taken along the body's axes, and is spatial"},
        {0, -1, 1, 1, "the angular velocity along the body's axes is taken for a spatial one"},
        {1, -1, 1, 2, "the angular momentum is multiplied by the moments of inertia where it is to be divided by them"},
        {0, 1, -1, 1, "the attitude is taken for its inverse, space to body"},
    };
    const double k[3] = {1.0 / b->I[0], 1.0 / b->I[1], 1.0 / b->I[2]}, near = 0.005 * vti_norm(found);
    double w[3];
    for (size_t m = 0; m < sizeof mistake / sizeof mistake[0]; ++m) {
        tilted(b, mistake[m].before, mistake[m].by == 0 ? one : mistake[m].by == 1 ? k : b->I, mistake[m].after, w);
        for (int n = 0; n < 3; ++n)
            w[n] *= mistake[m].sign;
        if (difference(w, found) <= near)
            return mistake[m].says;
    }
    for (int m = 0; m < 5; ++m) {
        const double other[3] = {k[order[m][0]], k[order[m][1]], k[order[m][2]]};
        tilted(b, 1, other, -1, w);
        snprintf(text, VTI_CHECK_TEXT, "moments of inertia are taken in the wrong order: %s for A, B, C", orders[m]);
        if (difference(w, found) <= near)
            return text;
    }
    tilted(b, 1, k, -1, w);
    vti_pair_rotate(b->q, 1.0, w, w);
    if (difference(w, found) <= near)
        return "attitude increments act in the body's frame while the angular velocity is spatial";
    vti_cross(b->L, found, w);
    if (vti_norm(w) <= 0.005 * vti_norm(b->L) * vti_norm(found))
        return "the body is turned about L, as a sphere would be";
    return NULL;
}

static void check_rate(struct kit *kit)
{
    const double h = 0x1p-12;
    const int steps = 4;
    const struct top start = vti_kit_top_usual(), end = vti_kit_top_hosted(kit, &start, h, steps);
    const double k[3] = {1.0 / start.I[0], 1.0 / start.I[1], 1.0 / start.I[2]};
    double should[3], found[3] = {NAN, NAN, NAN}, a[3], b[3];
    tilted(&start, 1, k, -1, should);
    if (isfinite(end.q[0])) {
        vti_rrv_from_quat_xyzw(start.q, a);
        vti_rrv_from_quat_xyzw(end.q, b);
        vti_rrv_relative(b, a, found);
        vti_rrv_to_rotvec(found, found);
        for (int n = 0; n < 3; ++n)
            found[n] /= h * steps;
    }
    const double off = difference(should, found) / vti_norm(should);
    vti_kit_line(kit, "general inertia: angular velocity at the start, off by", off, -1, 0.01, VTI_CHECK_FAIL);
    if (off <= 0.01)
        return;
    char text[VTI_CHECK_TEXT];
    const char *const says = isfinite(off) ? rate_named(&start, found, text) : NULL;
    kit->attitude_lost = 1;
    if (!isfinite(off))
        vti_kit_fault(kit, "a free body of three moments is refused, or not finite");
    else
        vti_kit_fault(kit, "%s", says != NULL ? says : "a free body does not turn by R diag(1/A, 1/B, 1/C) R^T L");
}

/* ---- moments ----------------------------------------------------------------------------------------------------- */

/** A body at rest, and a constant moment: how L has grown, over the time. */
static void check_kick(struct kit *kit)
{
    const double h = 0x1p-10, m[3] = {0.4, -0.7, 0.5};
    const int steps = 4;
    struct top start = vti_kit_top_usual();
    memset(start.L, 0, sizeof start.L);
    memcpy(start.moment, m, sizeof m);
    const struct top end = vti_kit_top_hosted(kit, &start, h, steps);
    struct top as_momentum = start;
    const double k[3] = {1.0 / start.I[0], 1.0 / start.I[1], 1.0 / start.I[2]};
    double grown[3], body[3], space[3], divided[3], along, rest[3];
    memcpy(as_momentum.L, m, sizeof m);
    for (int n = 0; n < 3; ++n)
        grown[n] = end.L[n] / (h * steps);
    along = vti_dot(grown, m) / vti_dot(m, m);
    for (int n = 0; n < 3; ++n)
        rest[n] = grown[n] - along * m[n];
    vti_pair_rotate(start.q, -1.0, m, body);
    vti_pair_rotate(start.q, 1.0, m, space);
    tilted(&as_momentum, 1, k, -1, divided);
    const double size = vti_norm(m), near = 0.005 * size, off = difference(grown, m) / size, half = 0.5 / steps;
    vti_kit_line(kit, "general inertia: L by a constant moment, off by", off, -1, 0.01, VTI_CHECK_FAIL);
    if (off <= 0.01 || (!isfinite(off) && kit->report->faults > 0))
        return;
    if (!isfinite(off))
        vti_kit_fault(kit, "a body of three moments under a moment is refused, or not finite");
    else if (difference(grown, body) <= near)
        vti_kit_fault(kit, "moments are turned into the body's frame while L is spatial");
    else if (difference(grown, space) <= near)
        vti_kit_fault(kit, "moments are taken along the body's axes, and are spatial");
    else if (difference(grown, divided) <= near)
        vti_kit_fault(kit, "L is kicked by the moment over the inertia, as an angular velocity is");
    else if (vti_norm(rest) > near)
        vti_kit_fault(kit, "L does not grow along the moment");
    else if (fabs(along - 1.0 + half) <= 0.005 || fabs(along - 1.0 - half) <= 0.005)
        vti_kit_fault(kit, "L is half a kick %s", along < 1.0 ? "late" : "early");
    else if (fabs(along) <= 0.005)
        vti_kit_fault(kit, "moments do not act");
    else
        vti_kit_fault(kit, "L grows by %.4g times the moment", along);
}

/* ---- motion ------------------------------------------------------------------------------------------------------ */

/** A free body: what is left of the gyroscopic term. */
static void check_gyroscopic(struct kit *kit)
{
    const double t = 2.0;
    const struct top start = vti_kit_top_usual(), end = vti_kit_top_hosted(kit, &start, t / 512, 512);
    const struct top right = vti_kit_top_moved(&start, 1.0, t), without = vti_kit_top_moved(&start, 0.0, t),
                     against = vti_kit_top_moved(&start, -1.0, t);
    const double off = vti_kit_top_turned(&right, &end), kept = difference(end.L, start.L) / vti_norm(start.L);
    vti_kit_line(kit, "general inertia: attitude of a free body, off by", off, -1, 0.02, VTI_CHECK_FAIL);
    vti_kit_line(kit, "general inertia: L of a free body, changed by", kept, -1, 1e-9, VTI_CHECK_NOTE);
    if (off <= 0.02 || kit->attitude_lost)
        return;
    if (vti_kit_top_turned(&without, &end) < 0.2 * off)
        vti_kit_fault(kit, "the gyroscopic term w x J w is missing: a free body turns about a fixed axis");
    else if (vti_kit_top_turned(&against, &end) < 0.2 * off)
        vti_kit_fault(kit, "the gyroscopic term w x J w has the wrong sign");
}

/** How the error falls at each halving of the step. */
static double order_of(struct kit *kit, const struct top *start, double t)
{
    const struct top right = vti_kit_top_moved(start, 1.0, t);
    double error[2];
    for (int k = 0; k < 2; ++k) {
        const int64_t steps = 256 << k;
        const struct top end = vti_kit_top_hosted(kit, start, t / (double)steps, steps);
        error[k] = vti_kit_top_turned(&right, &end);
    }
    return error[1] <= 1e-10 ? 9.0 : log2(error[0] / error[1]); /* beyond what the reference tells */
}

static void check_orders(struct kit *kit)
{
    struct top top = vti_kit_top_usual();
    const struct top body = top;
    top.arm[0] = 0.3;
    top.arm[1] = 0.2;
    top.arm[2] = 0.9;
    const double flight = order_of(kit, &body, 2.0), fall = order_of(kit, &top, 2.0);
    vti_kit_line(kit, "general inertia: order of a free body", flight, 1, 1.8, VTI_CHECK_FAIL);
    vti_kit_line(kit, "general inertia: order of a heavy top", fall, 1, 1.8, VTI_CHECK_FAIL);
    if (kit->report->faults > 0 || (flight >= 1.8 && fall >= 1.8))
        return;
    if (flight > 0.6 && flight < 1.8)
        vti_kit_fault(kit, "order %.1f of a free body: a step's whole turn goes by the axes of its start?", flight);
    else if (fall > 0.6 && flight >= 1.8)
        vti_kit_fault(kit, "order %.1f under moments: they are those of the step's start, or L is half a kick off?",
                      fall);
    else
        vti_kit_fault(kit, "bodies of three moments do not converge, for a reason that is not recognised");
}

/** A slender body at h|Omega| = 0.2, which some schemes that are good elsewhere wind up. */
static void check_slender(struct kit *kit)
{
    static const double slender[3] = {1.7231, 0.0658, 1.7243}, w[3] = {0.2, 1.0, 0.1};
    struct top start;
    double p[3], energy = 0.0, later = 0.0;
    memset(&start, 0, sizeof start);
    start.q[3] = 1.0;
    memcpy(start.I, slender, sizeof slender);
    for (int k = 0; k < 3; ++k) {
        start.L[k] = slender[k] * w[k];
        energy += slender[k] * w[k] * w[k];
    }
    const struct top end = vti_kit_top_hosted(kit, &start, 0.2, 4000);
    vti_pair_rotate(end.q, -1.0, end.L, p);
    for (int k = 0; k < 3; ++k)
        later += p[k] * p[k] / slender[k];
    const double off = fabs(later / energy - 1.0);
    vti_kit_line(kit, "general inertia: energy of a slender body, 4000 steps", off, -1, 0.1, VTI_CHECK_NOTE);
    if (!(off <= 0.1) && kit->report->faults == 0)
        vti_kit_remark(kit, "the energy of a slender body (1.7231, 0.0658, 1.7243) grows at h|Omega| = 0.2");
}

void vti_kit_inertia(struct kit *kit)
{
    check_rate(kit);
    check_kick(kit);
    check_gyroscopic(kit);
    check_orders(kit);
    check_slender(kit);
}
