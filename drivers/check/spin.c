/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Free spins, whose turn is known: its side, its law, half turns, and the norm of what holds it. */
#include "check.h"

static const double start_turn[3] = {0.6, -0.5, 0.7}, spin_axis[3] = {2.0 / 7.0, 3.0 / 7.0, -6.0 / 7.0};

/** Free motion. */
static const struct field none;

/** A body turned by the rotation vector, spinning by w about a unit axis. */
static struct bodies spinning(const double turned[3], const double axis[3], double w)
{
    struct bodies b = vti_kit_bodies_none(1);
    double alpha[3];
    vti_rrv_from_rotvec(turned, alpha);
    vti_kit_bodies_set_alpha(&b, 0, alpha);
    for (int k = 0; k < 3; ++k)
        b.w[k] = w * axis[k];
    return b;
}

/* ---- turns ------------------------------------------------------------------------------------------- */

/** theta with exp S(theta) R_0 = R_1 (space), or R_0 exp S(theta) = R_1 (body). */
static void turn_of(const struct bodies *before, const struct bodies *after, double space[3], double body[3])
{
    double a[3], b[3], r[3];
    vti_kit_bodies_alpha(before, 0, a);
    vti_kit_bodies_alpha(after, 0, b);
    vti_rrv_relative(b, a, r);
    vti_rrv_to_rotvec(r, space);
    vti_rrv_rotate_back(a, space, body); /* R_0^T exp(S(u)) R_0 = exp S(R_0^T u) */
}

/** u = k along + what is across; returns k and the size of the rest. */
static double along(const double u[3], const double axis[3], double *across)
{
    const double k = vti_dot(u, axis);
    const double rest[3] = {u[0] - k * axis[0], u[1] - k * axis[1], u[2] - k * axis[2]};
    *across = vti_norm(rest);
    return k;
}

struct turn vti_kit_free_turn(struct kit *kit, double w, double h, int64_t steps)
{
    struct turn t = {NAN, NAN, 1, NAN};
    const struct bodies before = spinning(start_turn, spin_axis, w);
    struct bodies after = before;
    vti_kit_host_advance(&kit->host, &after, &none, h, steps);
    if (!vti_kit_bodies_are_finite(&after))
        return t;
    double space[3], body[3], across_body;
    turn_of(&before, &after, space, body);
    t.angle = along(space, spin_axis, &t.across);
    t.spin = vti_dot(after.w, spin_axis);
    const double angle_body = along(body, spin_axis, &across_body);
    if (across_body < t.across) {
        t.angle = angle_body;
        t.across = across_body;
        t.side = -1;
    }
    return t;
}

/** The names of the laws that are known, of EQUATIONS 2; s itself to the 5th order, so that it may be a truncated
 *  series. */
static const char *law_of(double s, double angle, double *off)
{
    static const char *const names[] = {"asin s", "2 atan(s/2)", "s"};
    const double law[] = {asin(s), 2.0 * atan(0.5 * s), s};
    int best = 0;
    for (int k = 1; k < 3; ++k)
        if (fabs(angle - law[k]) < fabs(angle - law[best]))
            best = k;
    *off = fabs(angle - law[best]);
    return *off < 1e-4 * s ? names[best] : NULL;
}

void vti_kit_say_side(struct kit *kit, const struct turn *t, double s)
{
    if (t->across > 1e-6 * s)
        vti_kit_fault(kit,
                      "a free spin does not turn a body about omega: increments are added up, or a quaternion's order "
                      "is another one");
    else if (fabs(t->angle) <= 1e-6 * s)
        vti_kit_fault(
            kit, "a free spin does not turn bodies (what moves positions only is checked by vti-check --translation)");
    else if (t->side < 0 && t->angle < 0.0)
        vti_kit_fault(kit, "the attitude is taken for its inverse, space to body");
    else if (t->side < 0)
        vti_kit_fault(kit, "attitude increments act in the body's frame while spins and moments are spatial: they are "
                           "composed in the wrong order");
    else
        return;
    kit->attitude_lost = 1;
}

static void check_law(struct kit *kit)
{
    const double s = 0.5;
    const struct turn t = vti_kit_free_turn(kit, s, 1.0, 1), half = vti_kit_free_turn(kit, 0.5 * s, 1.0, 1);
    double off;
    const double angle = fabs(t.angle);
    vti_kit_line(kit, "free spin: turn beside omega at h|omega| = 1/2", t.side > 0 ? t.across : NAN, -1, 1e-9,
                 VTI_CHECK_FAIL);
    const char *law = law_of(s, angle, &off);
    /* |theta - s| ~ s^3, and is 0.024 for asin and 0.010 for atan: a law that is odd in s */
    vti_check_line *line =
        vti_kit_line(kit, "free spin: turn at h|omega| = 1/2, off by", fabs(angle - s), -1, 0.03, VTI_CHECK_FAIL);
    if (law != NULL)
        vti_kit_line_say(line, "turns by %s", law);
    else if (isfinite(t.angle))
        vti_kit_line_say(line, "turns by %.6g, half of it by %.6g: a law of its own", t.angle, half.angle);
    if (!isfinite(t.angle))
        vti_kit_fault(kit, "a free spin of h|omega| = 1/2 is refused, or not finite");
}

/* ---- many steps -------------------------------------------------------------------------------------------------- */

/** Steps of s = 1/4 from no turn, past half a turn and nearly to a whole one, against multiples of the first step. The
 *  largest error, and in *before that up to then. */
static double past_half_turn(struct kit *kit, double *before)
{
    enum { STEPS = 25 };
    const double nothing[3] = {0, 0, 0}, s = 0.25;
    const double step = vti_kit_free_turn(kit, s, 1.0, 1).angle;
    double worst = 0.0;
    *before = 0.0;
    for (int k = 1; k <= STEPS; ++k) {
        struct bodies b = spinning(nothing, spin_axis, s);
        const double turn[3] = {k * step * spin_axis[0], k * step * spin_axis[1], k * step * spin_axis[2]};
        const struct bodies expected = spinning(turn, spin_axis, s);
        vti_kit_host_advance(&kit->host, &b, &none, 1.0, k);
        worst = larger(worst, vti_kit_bodies_apart(&b, &expected).attitude);
        if (k * s < 3.0)
            *before = worst;
    }
    return worst;
}

/** A body that is turned by exactly pi, w = 0, spins about an axis across, which keeps it there, and back. */
static double at_half_turn(struct kit *kit)
{
    enum { STEPS = 16 };
    const double turned[3] = {0, 0, 0}, across[3] = {0, 1, 0}, back[3] = {0, -1, 0};
    struct bodies b = spinning(turned, across, 0.25);
    b.q[0] = 1.0;
    b.q[3] = 0.0;
    const struct bodies start = b;
    vti_kit_host_advance(&kit->host, &b, &none, 1.0, STEPS);
    const double away = vti_kit_bodies_apart(&b, &start).attitude;
    for (int k = 0; k < 3; ++k)
        b.w[k] = 0.25 * back[k];
    vti_kit_host_advance(&kit->host, &b, &none, 1.0, STEPS);
    return away > 0.1 ? vti_kit_bodies_apart(&b, &start).attitude : NAN;
}

static double norm_drift(struct kit *kit)
{
    enum { STEPS = 1000 };
    struct bodies b = spinning(start_turn, spin_axis, 0.1);
    vti_kit_host_advance(&kit->host, &b, &none, 1.0, STEPS);
    return fabs(sqrt(vti_dot(b.q, b.q) + b.q[3] * b.q[3]) - 1.0);
}

void vti_kit_spin(struct kit *kit)
{
    check_law(kit);
    /* errors that go on growing as they did before are not lost there */
    const double growth = 30.0, there_and_back = 1e-3;
    double before;
    const double past = past_half_turn(kit, &before), at = at_half_turn(kit), drift = norm_drift(kit);
    const int is_lost = !(past <= fmax(1e-9, growth * before) && at <= there_and_back);
    vti_kit_line(kit, "half turn: attitude of a spin through it", past, -1, 1e-9, VTI_CHECK_FAIL);
    vti_kit_line(kit, "half turn: attitude there and back from it", at, -1, 1e-9, VTI_CHECK_FAIL);
    vti_kit_line(kit, "norm of the quaternion after 1000 steps, off by", drift, -1, 1e-11, VTI_CHECK_FAIL);
    if (!kit->attitude_lost && !kit->masked && is_lost)
        vti_kit_fault(kit, "attitudes are lost at half a turn");
    if (isfinite(drift) && drift > 1e-11)
        vti_kit_fault(kit, "quaternion is not renormalised: its norm drifts");
}
