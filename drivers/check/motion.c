/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Motions against what is known of them: the reference is the library's method of order 6 at a far smaller step, or a
 * number on paper. */
#include "check.h"

/** The paper's pendulum to t = 10. Steppers of order 2 are off by some 1e-3 at most at h = 1/64, those of order 1 by
 *  more. */
void vti_kit_pendulum(struct kit *kit)
{
    enum { STEPS = 640, FINER = 16 };
    struct field field;
    struct bodies b = vti_kit_scene_pendulum(&field), reference = b;
    vti_kit_host_advance(&kit->host, &b, &field, 1.0 / 64.0, STEPS);
    vti_kit_bodies_advance_reference(&reference, &field, 1.0 / (64.0 * FINER), (int64_t)STEPS * FINER);
    vti_kit_line(kit, "pendulum: attitude at t = 10 with h = 1/64, off by",
                 vti_kit_bodies_apart(&b, &reference).attitude, -1, 2e-3, VTI_CHECK_FAIL);
}

/* ---- torsion pair ------------------------------------------------------------------------------------------------ */

/** Twist theta and its rate of the pair, in units of the first twist; frequency 1. */
static void twist_of(const struct bodies *b, double *twist, double *rate)
{
    const double amplitude = 1e-3;
    double p[3], q[3], r[3];
    *twist = *rate = NAN;
    if (!vti_kit_bodies_are_finite(b))
        return;
    vti_kit_bodies_alpha(b, 0, p);
    vti_kit_bodies_alpha(b, 1, q);
    vti_rrv_relative(p, q, r);
    *twist = r[2] / amplitude;
    *rate = (b->w[2] - b->w[5]) / amplitude;
}

/** The same of the stretched pair. */
static void stretch_of(const struct bodies *b, double *stretch, double *rate)
{
    const double amplitude = 1e-3;
    const double d[3] = {b->x[3] - b->x[0], b->x[4] - b->x[1], b->x[5] - b->x[2]};
    *stretch = (vti_norm(d) - 1.0) / amplitude;
    *rate = (b->v[3] - b->v[0]) / amplitude;
}

/** The oscillator that a host is put to: by its rotation, or by translation only. */
struct oscillator {
    struct bodies (*scene)(struct field *field);
    void (*state)(const struct bodies *b, double *size, double *rate);
    const char *frequency, *amplitude;
};

static const struct oscillator torsion = {vti_kit_scene_torsion, twist_of,
                                          "torsion pair: frequency at h omega = 0.2, off by",
                                          "torsion pair: amplitude bounded to h omega ="};
static const struct oscillator stretching = {vti_kit_scene_stretch, stretch_of,
                                             "stretched pair: frequency at h omega = 0.2, off by",
                                             "stretched pair: amplitude bounded to h omega ="};

static const struct oscillator *oscillator_of(const struct kit *kit)
{
    return kit->rotates ? &torsion : &stretching;
}

/** The oscillator after so many steps. */
static void swing_to(struct kit *kit, double h, int64_t steps, double *size, double *rate)
{
    struct field field;
    const struct oscillator *o = oscillator_of(kit);
    struct bodies b = o->scene(&field);
    vti_kit_host_advance(&kit->host, &b, &field, h, steps);
    o->state(&b, size, rate);
}

/** The amplitude after so many steps, 1 at first. */
static double swing(struct kit *kit, double h, int64_t steps)
{
    double twist, rate;
    swing_to(kit, h, steps, &twist, &rate);
    return sqrt(twist * twist + rate * rate);
}

/** The last of the steps 1/4, 1/4 2^(1/16), ... 4 at which the amplitude stays bounded. */
static double stable_to(struct kit *kit)
{
    enum { STEPS = 400, STEPS_TRIED = 64 };
    double good = 0.0;
    for (int k = 0; k <= STEPS_TRIED; ++k) {
        const double h = 0.25 * exp2(k / 16.0), size = swing(kit, h, STEPS);
        if (!(size < 30.0)) /* at h near the limit the ellipse is long; what grows has grown past that */
            break;
        good = h;
    }
    return good;
}

/** theta = cos t; 20 periods at h = 0.2, so that Verlet's frequency is off by h^2/24 = 1.7e-3. */
void vti_kit_torsion(struct kit *kit)
{
    enum { STEPS = 628 };
    const double h = 0.2, t = h * STEPS;
    double twist, rate;
    swing_to(kit, h, STEPS, &twist, &rate);
    const double phase = atan2(-rate, twist) - t;
    const double off = fabs(remainder(phase, 2.0 * CHECK_PI)) / t;
    vti_kit_line(kit, oscillator_of(kit)->frequency, off, -1, 4e-3, VTI_CHECK_FAIL);
    vti_kit_line(kit, oscillator_of(kit)->amplitude, stable_to(kit), 1, 0.5, VTI_CHECK_FAIL);
}

/* ---- rigid motion ------------------------------------------------------------------------------------------------ */

/** A bond that turns like a rigid body with its bodies: its length and twist stay as they are, to the order of the
 *  method. */
void vti_kit_rigid(struct kit *kit)
{
    enum { STEPS = 640 };
    struct field field;
    double r, p[3], q[3], worst = NAN;
    struct bodies b = vti_kit_scene_rigid(&field, &r);
    vti_kit_host_advance(&kit->host, &b, &field, 1.0 / 64.0, STEPS);
    if (vti_kit_bodies_are_finite(&b)) {
        const double d[3] = {b.x[3] - b.x[0], b.x[4] - b.x[1], b.x[5] - b.x[2]};
        double along[3];
        const double unit[3] = {r, 0.0, 0.0};
        vti_kit_bodies_alpha(&b, 0, p);
        vti_kit_bodies_alpha(&b, 1, q);
        vti_rrv_rotate(p, unit, along); /* where the body's own arm now points */
        const double aside[3] = {d[0] - along[0], d[1] - along[1], d[2] - along[2]};
        worst = fmax(vti_norm(aside) / r, vti_rrv_distance(p, q));
    }
    vti_kit_line(kit, "bonded pair in rigid motion: distortion after t = 10", worst, -1, 2e-3, VTI_CHECK_FAIL);
}

/* ---- order ------------------------------------------------------------------------------------------------------- */

enum { LADDER = 4 };

/** Order between the two smallest steps whose error is above rounding; infinite if there are none, or if no step has an
 *  error worth the name, as of methods that choose steps of their own within h. */
static double order_of(const double error[LADDER])
{
    const double least = 1e-6;
    int small = 1;
    for (int k = 0; k < LADDER; ++k)
        small = small && error[k] < least;
    for (int k = LADDER - 1; k > 0; --k)
        if (!(error[k] < 1e-9)) {
            const double order = log2(error[k - 1] / error[k]);
            return small && !(order >= 1.8) ? HUGE_VAL : order;
        }
    return HUGE_VAL;
}

static void order_line(struct kit *kit, const char *name, const double error[LADDER])
{
    const double order = order_of(error);
    vti_check_line *line = vti_kit_line(kit, name, order, 1, 1.8, VTI_CHECK_FAIL);
    line->verdict = order >= 1.8 ? VTI_CHECK_PASS : VTI_CHECK_FAIL;
    vti_kit_line_say(line, "error %.2e at the smallest step", error[LADDER - 1]);
    kit->order = order < kit->order || isnan(order) ? order : kit->order;
}

/** The bonded pair to t = 2 by h = 1/32 ... 1/256; positions and velocities, attitudes and spins each for
 *  themselves. */
void vti_kit_order(struct kit *kit)
{
    enum { FIRST = 32, T = 2, FINER = 4 };
    struct field field;
    const struct bodies start = vti_kit_scene_bonded(kit, &field);
    struct bodies reference = start;
    double x[LADDER], v[LADDER], attitude[LADDER], w[LADDER];
    const int64_t finest = (int64_t)FIRST << (LADDER - 1);
    vti_kit_bodies_advance_reference(&reference, &field, 1.0 / (double)(FINER * finest), T * FINER * finest);
    for (int k = 0; k < LADDER; ++k) {
        struct bodies b = start;
        const int64_t per_unit = (int64_t)FIRST << k;
        vti_kit_host_advance(&kit->host, &b, &field, 1.0 / (double)per_unit, T * per_unit);
        const struct apart d = vti_kit_bodies_apart(&b, &reference);
        x[k] = d.x;
        v[k] = d.v;
        attitude[k] = d.attitude;
        w[k] = d.w;
    }
    kit->order = HUGE_VAL;
    order_line(kit, "order of positions", x);
    order_line(kit, "order of velocities", v);
    if (!kit->rotates)
        return;
    order_line(kit, "order of attitudes", attitude);
    order_line(kit, "order of spins", w);
}
