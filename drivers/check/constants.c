/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A host's constants, each exact to rounding, before anything else is looked at. Over N and over 2N steps
 *
 *     path of a free flight     x(2N) - x(N) = flight N h v
 *     turn of a free spin       theta(2N) - theta(N) = turn N h omega
 *     kick by a constant load   v(2N) - v(N) = kick N h F/m, and of spins by M/J
 *
 * whatever a scheme does at its start, and when its velocities are read: that is for response.c. Ratios that are off by
 * more than 1e-4 are named and corrected from here on (host.c), so that what else is wrong shows as it is. */
#include "check.h"

#include <string.h>

enum { STEPS = 64 };

static const double h = 1.0 / STEPS, tiny = 1e-2, axis[3] = {2.0 / 7.0, 3.0 / 7.0, -6.0 / 7.0};
/* unlike each other in every ratio, so that one taken for another shows */
static const double masses[VTI_CHECK_BODIES] = {1.3, 2.5, 1.7, 0.6}, inertias[VTI_CHECK_BODIES] = {0.7, 0.3, 0.4, 1.1};

static void ratio_line(struct kit *kit, const char *name, double ratio)
{
    vti_kit_line_say(vti_kit_line(kit, name, fabs(ratio - 1.0), -1, 1e-4, VTI_CHECK_FAIL), "%.6g times", ratio);
}

/* ---- free motion ------------------------------------------------------------------------------------------------- */

/** Free motion after N and 2N steps: distance or angle, and the velocity that is left; both in units of the velocity at
 *  first. */
struct free_motion {
    double path[2], left[2];
};

struct free_ratios {
    double ratio, lead, decay; /* of the path; steps that it is ahead; what is lost of the velocity per step */
};

static struct free_ratios ratios_of(const struct free_motion *m, double step)
{
    struct free_ratios r;
    r.ratio = (m->path[1] - m->path[0]) / (STEPS * step);
    r.lead = r.ratio != 0.0 ? m->path[0] / (r.ratio * step) - STEPS : 0.0;
    r.decay = 1.0 - pow(m->left[1] / m->left[0], 1.0 / STEPS);
    return r;
}

/** Body 0 stays at rest, 1 flies. fall: the velocity that body 0 gets per unit of time. */
static struct free_ratios flight(struct kit *kit, double step, double *fall)
{
    static const struct field none;
    struct free_motion m;
    for (int k = 0; k < 2; ++k) {
        struct bodies b = vti_kit_bodies_none(2);
        memcpy(b.v + 3, axis, sizeof axis);
        vti_kit_host_advance(&kit->host, &b, &none, step, (k + 1) * STEPS);
        m.path[k] = vti_dot(b.x + 3, axis);
        m.left[k] = vti_dot(b.v + 3, axis);
        *fall = vti_norm(b.v) / (STEPS * step * (k + 1));
    }
    return ratios_of(&m, step);
}

static struct free_ratios spin(struct kit *kit, double step, struct turn *last)
{
    struct free_motion m;
    for (int k = 0; k < 2; ++k) {
        *last = vti_kit_free_turn(kit, tiny, step, (k + 1) * STEPS);
        m.path[k] = last->angle / tiny;
        m.left[k] = last->spin / tiny;
    }
    return ratios_of(&m, step);
}

/** Whether it is so; what comes of kicks then says nothing more. */
static int masks(struct kit *kit, int is_so)
{
    kit->masked = kit->masked || is_so;
    return is_so;
}

/* ---- kicks ------------------------------------------------------------------------------------------------------- */

static void constant(const void *self, const vti_bodies *b)
{
    (void)self;
    for (int64_t i = 0; i < b->count; ++i)
        for (int k = 0; k < 3; ++k) {
            b->force.c[k][i * b->force.stride] += masses[i] * axis[k];
            b->moment.c[k][i * b->moment.stride] += 1e-3 * inertias[i] * axis[k];
        }
}

/** All bodies start at rest, unturned, and are pushed and twisted. */
static void kicks(struct kit *kit, double push[VTI_CHECK_BODIES], double twist[VTI_CHECK_BODIES], double *aside)
{
    struct field field;
    struct bodies b[2];
    memset(&field, 0, sizeof field);
    field.effect.apply = constant;
    field.count = 1;
    for (int k = 0; k < 2; ++k) {
        b[k] = vti_kit_bodies_none(VTI_CHECK_BODIES);
        memcpy(b[k].mass, masses, sizeof masses);
        memcpy(b[k].inertia, inertias, sizeof inertias);
        vti_kit_host_advance(&kit->host, &b[k], &field, h, (k + 1) * STEPS);
    }
    *aside = 0.0;
    for (int i = 0; i < VTI_CHECK_BODIES; ++i) {
        double v[3], w[3], cross[3];
        for (int k = 0; k < 3; ++k) {
            v[k] = (b[1].v[3 * i + k] - b[0].v[3 * i + k]) / (STEPS * h);
            w[k] = (b[1].w[3 * i + k] - b[0].w[3 * i + k]) / (1e-3 * STEPS * h);
        }
        push[i] = vti_dot(v, axis);
        twist[i] = vti_dot(w, axis);
        vti_cross(v, axis, cross);
        *aside = fmax(*aside, vti_norm(cross));
    }
}

/** The law by which all sizes have one ratio. */
static struct kick kick_of(const double size[VTI_CHECK_BODIES], const double *own, const double *other)
{
    struct kick kick = {KICK_RIGHT, 0.0};
    int is_nothing = 1;
    for (int i = 0; i < VTI_CHECK_BODIES; ++i)
        is_nothing = is_nothing && fabs(size[i]) < 1e-9;
    for (; !is_nothing && kick.law < KICK_LAWS; ++kick.law) {
        int same = 1;
        kick.ratio = 1.0;
        const double first = size[0] / vti_kit_kick_size(&kick, own[0], other[0]);
        for (int i = 1; i < VTI_CHECK_BODIES; ++i)
            same = same && vti_kit_same_ratio(size[i] / vti_kit_kick_size(&kick, own[i], other[i]), first);
        kick.ratio = first;
        if (same)
            return kick;
    }
    kick.ratio = is_nothing ? 0.0 : NAN;
    return kick;
}

/* ---- the check --------------------------------------------------------------------------------------------------- */

/** How often the host steps, by the steps that its free motions are ahead. */
static void say_lead(struct kit *kit, double flight_lead, double turn_lead)
{
    const int is_one = fabs(fabs(flight_lead) - 1.0) < 1e-3 && (!kit->rotates || fabs(turn_lead - flight_lead) < 1e-3);
    if (is_one) {
        kit->host.constants.extra_steps = flight_lead > 0.0 ? 1 : -1;
        vti_kit_fault(kit, "the host takes one step too %s", flight_lead > 0.0 ? "many" : "few");
        return;
    }
    if (masks(kit, fabs(flight_lead) > 1e-3))
        vti_kit_fault(kit, "positions of a free flight are %+.2g steps ahead", flight_lead);
    if (masks(kit, kit->rotates && fabs(turn_lead) > 1e-3))
        vti_kit_fault(kit, "attitudes of a free spin are %+.2g steps ahead", turn_lead);
}

/** What makes ratios of kicks meaningless. */
static void say_free(struct kit *kit, const struct free_ratios *fly, const struct free_ratios *turn, double fall)
{
    double again;
    if (masks(kit, fall > 1e-9)) {
        vti_kit_fault(kit, "a free body at rest gains a velocity of %.3g per unit of time: is gravity on?", fall);
        return;
    }
    if (masks(kit, fabs(fly->decay) > 1e-8))
        vti_kit_fault(kit, "a free velocity loses %.2g of itself in every step: damping?", fly->decay);
    if (masks(kit, kit->rotates && fabs(turn->decay) > 1e-8))
        vti_kit_fault(kit, "a free spin loses %.2g of itself in every step: damping?", turn->decay);
    if (kit->masked)
        return;
    if (vti_kit_ratio_is_off(fly->ratio) &&
        masks(kit, vti_kit_same_ratio(flight(kit, 0.5 * h, &again).ratio, 2.0 * fly->ratio)))
        vti_kit_fault(kit, "the host takes steps of h = %.5g, whatever it is asked for", fly->ratio * h);
    else
        say_lead(kit, fly->lead, turn->lead);
}

static double corrected(double ratio)
{
    return fabs(ratio - 1.0) <= 1e-4 ? 1.0 : ratio;
}

static void check_free(struct kit *kit)
{
    struct constants *c = &kit->host.constants;
    struct free_ratios turn = {1.0, 0.0, 0.0};
    struct turn turned = {0.0, 0.0, 1, 0.0};
    double fall;
    const struct free_ratios fly = flight(kit, h, &fall);
    if (kit->rotates)
        turn = spin(kit, h, &turned);
    ratio_line(kit, "free flight: distance, off by", fly.ratio);
    if (kit->rotates) {
        ratio_line(kit, "free spin: angle, off by", turn.ratio);
        vti_kit_say_side(kit, &turned, 2.0 * tiny);
    }
    if (turned.across > 1e-6 * tiny) /* no turn about omega, and no number for it */
        turn.ratio = NAN, turn.lead = 0.0;
    say_free(kit, &fly, &turn, fall);
    c->flight = corrected(fly.ratio);
    c->turn = corrected(turn.ratio);
}

static void check_kicks(struct kit *kit)
{
    struct constants *c = &kit->host.constants;
    double push[VTI_CHECK_BODIES], twist[VTI_CHECK_BODIES], aside;
    kicks(kit, push, twist, &aside);
    ratio_line(kit, "force: size of its kicks, off by", push[0]);
    if (kit->rotates)
        ratio_line(kit, "moment: size of its kicks, off by", twist[0]);
    if (!kit->masked && masks(kit, aside > 1e-3))
        vti_kit_fault(kit, "%s", "the kick by a force has another direction than the force");
    if (masks(kit, isnan(push[0]) || isnan(twist[0])))
        return;
    c->force = kick_of(push, masses, inertias);
    c->moment = kick_of(twist, inertias, masses);
}

void vti_kit_constants(struct kit *kit)
{
    struct constants *c = &kit->host.constants;
    check_free(kit);
    check_kicks(kit);
    if (kit->masked)
        return;
    vti_kit_say_ratios(kit, c);
    c->force.ratio = corrected(c->force.ratio);
    c->moment.ratio = corrected(c->moment.ratio);
}
