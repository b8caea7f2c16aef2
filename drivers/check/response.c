/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a scheme does with loads that are known beforehand. Body 0 flies freely and is the clock: x = t. Body 1 is
 * pushed, body 2 twisted by a load that is constant, a = 1, or grows, a = t; over T = N h in free flight and at small
 * angles
 *
 *     constant   v = T,        x = T^2/2           growing   v = T^2/2
 *
 * exactly, by every scheme of order 2 or more. What is wrong at order 1 shows as three numbers in units of a step's
 * kick:
 *
 *     e1 = (v_const - T)/h,   e2 = (x_const - T^2/2)/(h T) - e1,   e3 = (v_grow - T^2/2)/(h T)
 *
 * e1 is what the start misses; e2 by how much positions lead; e3 by how much velocities lead. Phase volume grows as
 * -(e2 + e3) h omega^2: with e2 = -e3 a scheme is symplectic, and merely read at the wrong moment. */
#include "check.h"

#define MASS_PUSHED 2.5
#define INERTIA_TWISTED 0.4

static const double small = 1e-3;

enum { STEPS = 64, CLOCK = 0, PUSHED = 1, TWISTED = 2, BODIES = 3 };

static void loads(const void *self, const vti_bodies *b)
{
    const int grows = *(const int *)self;
    const double a = grows ? b->x.c[0][CLOCK * b->x.stride] : 1.0;
    b->force.c[1][PUSHED * b->force.stride] += MASS_PUSHED * a;
    b->moment.c[2][TWISTED * b->moment.stride] += small * INERTIA_TWISTED * a;
}

/** What came of a load: the kicked velocity and the moved position of one kind, per unit of load. calls: of growing
 *  loads. */
struct response {
    double v_const, x_const, v_grow;
    int primed;
    int64_t calls;
};

static struct bodies run(struct kit *kit, int grows)
{
    struct field field = {{0}, {0}, 1};
    struct bodies b = vti_kit_bodies_none(BODIES);
    field.effect.apply = loads;
    field.effect.self = &grows;
    b.mass[PUSHED] = MASS_PUSHED;
    b.inertia[TWISTED] = INERTIA_TWISTED;
    b.v[3 * CLOCK] = 1.0;
    vti_kit_host_advance(&kit->host, &b, &field, 1.0 / STEPS, STEPS);
    return b;
}

/** The angle about z in units of small. */
static double angle(const struct bodies *b, int64_t i)
{
    const double *q = b->q + 4 * i, s = q[3] < 0.0 ? -1.0 : 1.0;
    return 2.0 * atan2(s * q[2], s * q[3]) / small;
}

static void measure(struct kit *kit, struct response *push, struct response *twist)
{
    const struct bodies constant = run(kit, 0);
    push->primed = twist->primed = kit->host.primed;
    push->v_const = constant.v[3 * PUSHED + 1];
    push->x_const = constant.x[3 * PUSHED + 1];
    twist->v_const = constant.w[3 * TWISTED + 2] / small;
    twist->x_const = angle(&constant, TWISTED);
    const struct bodies growing = run(kit, 1);
    push->calls = twist->calls = kit->host.calls;
    push->v_grow = growing.v[3 * PUSHED + 1];
    twist->v_grow = growing.w[3 * TWISTED + 2] / small;
}

/* ---- words ------------------------------------------------------------------------------------------------------- */

struct nouns {
    const char *velocities, *places, *load, *drift, *new_velocity, *line_start, *line_lead, *line_kick;
};

static const struct nouns of_push = {"velocities",
                                     "positions",
                                     "force",
                                     "positions are pushed with the old velocity",
                                     "positions are pushed with the velocity of the end of the step",
                                     "force: kicks that the start misses",
                                     "force: lead of positions, in steps",
                                     "force: lead of velocities, in steps"};
static const struct nouns of_twist = {"spins",
                                      "attitudes",
                                      "moment",
                                      "rotation is pushed with the old spin",
                                      "rotation is pushed with the spin of the end of the step",
                                      "moment: kicks that the start misses",
                                      "moment: lead of attitudes, in steps",
                                      "moment: lead of spins, in steps"};

static int is(double a, double b)
{
    return fabs(a - b) < 0.05;
}

static void say_start(struct kit *kit, const struct nouns *of, double e1, int primed)
{
    if (is(e1, 0.0))
        return;
    if (is(e1, -0.5) && !primed)
        vti_kit_fault(kit, "forces are not primed before the first step");
    else if (is(e1, -0.5))
        vti_kit_fault(kit, "the half kick by the %s at the start is missing", of->load);
    else
        vti_kit_fault(kit, "at the start the %s kicks too %s, by %.2g of a kick", of->load,
                      e1 < 0.0 ? "little" : "much", fabs(e1));
}

/** What leads or lags, and what the energy does for it. */
static void say_order(struct kit *kit, const struct nouns *of, double e2, double e3)
{
    const char *energy = e2 + e3 < -0.05 ? ": energy grows" : e2 + e3 > 0.05 ? ": energy decays" : "";
    if (is(e2, 0.0) && is(e3, 0.0))
        return;
    if (is(e2, 0.5) && is(e3, -0.5))
        vti_kit_fault(kit, "order 1: %s are half a kick late", of->velocities);
    else if (is(e2, -0.5) && is(e3, 0.5))
        vti_kit_fault(kit, "order 1: %s are half a kick early", of->velocities);
    else if (is(e2, -0.5) && is(e3, 0.0))
        vti_kit_fault(kit, "%s%s", of->drift, energy);
    else if (is(e2, 0.5) && is(e3, 0.0))
        vti_kit_fault(kit, "%s%s", of->new_velocity, energy);
    else if (is(e2, -0.5) && is(e3, -0.5))
        vti_kit_fault(kit, "explicit Euler: %s, and kicks are by the old %s%s", of->drift, of->load, energy);
    else if (is(e2, 0.5) && is(e3, 0.5))
        vti_kit_fault(kit, "implicit Euler: %s, and kicks are by the new %s%s", of->new_velocity, of->load, energy);
    else if (is(e2, 0.0) && is(e3, -0.5))
        vti_kit_fault(kit, "%s are kicked by the %s of the previous step%s", of->velocities, of->load, energy);
    else if (is(e2, 0.0) && e3 < 0.0)
        vti_kit_fault(kit, "%s are kicked by a %s that is %.1f steps old%s", of->velocities, of->load, -e3, energy);
    else
        vti_kit_fault(kit, "by the %s, %s lead by %+.2g steps and %s by %+.2g%s", of->load, of->places, e2,
                      of->velocities, e3, energy);
}

static void signed_line(struct kit *kit, const char *name, double e)
{
    vti_kit_line_say(vti_kit_line(kit, name, fabs(e), -1, 0.01, VTI_CHECK_FAIL), "%+.3f", fabs(e) < 5e-4 ? 0.0 : e);
}

/** kick: how the load kicks, moves: how the velocity moves; nothing comes of a load where either is 0. */
static void judge(struct kit *kit, const struct nouns *of, const struct response *r, const struct kick *kick,
                  double moves)
{
    const double h = 1.0 / STEPS;
    const double e1 = (r->v_const - 1.0) / h, e2 = (r->x_const - 0.5) / h - e1, e3 = (r->v_grow - 0.5) / h;
    signed_line(kit, of->line_start, e1);
    signed_line(kit, of->line_lead, e2);
    signed_line(kit, of->line_kick, e3);
    if (kit->masked || kick->ratio == 0.0 || moves == 0.0 || !isfinite(kick->ratio + moves + e1 + e2 + e3))
        return;
    say_start(kit, of, e1, r->primed);
    if (r->calls <= 1)
        vti_kit_fault(kit, "forces are evaluated once, at the start, and never again");
    else
        say_order(kit, of, e2, e3);
}

void vti_kit_response(struct kit *kit)
{
    struct response push, twist;
    const struct constants *c = &kit->host.constants;
    measure(kit, &push, &twist);
    judge(kit, &of_push, &push, &c->force, c->flight);
    if (kit->rotates)
        judge(kit, &of_twist, &twist, &c->moment, c->turn);
}
