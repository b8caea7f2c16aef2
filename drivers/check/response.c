/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a scheme does with loads that are known beforehand. Body 0 flies freely and is the clock: x = t. Body 1 is pushed, body
 * 2 twisted by a load that is constant, a = 1, or grows, a = t; over T = N h in free flight and at small angles
 *
 *     constant   v = T,        x = T^2/2           growing   v = T^2/2
 *
 * exactly, by every scheme of order 2 or more. What is wrong at order 1 shows as three numbers in units of a step's kick:
 *
 *     e1 = (v_const - T)/h,   e2 = (x_const - T^2/2)/(h T) - e1,   e3 = (v_grow - T^2/2)/(h T)
 *
 * e1 is what the start misses; e2 by how much positions lead; e3 by how much velocities lead. Phase volume grows as
 * -(e2 + e3) h omega^2: with e2 = -e3 a scheme is symplectic, and merely read at the wrong moment. */
#include "check.h"

/* unlike each other in every ratio, so that one taken for another shows */
#define MASS_PUSHED 2.5
#define INERTIA_PUSHED 0.3
#define MASS_TWISTED 1.7
#define INERTIA_TWISTED 0.4

static const double small = 1e-3;

enum { STEPS = 64, CLOCK = 0, PUSHED = 1, TWISTED = 2, TURNING = 3 };

static void loads(const void *self, const vti_bodies *b)
{
    const int grows = *(const int *)self;
    const double a = grows ? b->x.c[0][CLOCK * b->x.stride] : 1.0;
    b->force.c[1][PUSHED * b->force.stride] += MASS_PUSHED * a;
    b->moment.c[2][TWISTED * b->moment.stride] += small * INERTIA_TWISTED * a;
}

/** What came of a load: the kicked velocity and the moved position of one kind, per unit of load; what free motion did in
 *  units of what it should. */
struct response {
    double v_const, x_const, v_grow, free;
    int primed;
};

static struct bed run(struct kit *kit, int grows)
{
    struct field field = {{0}, {0}, 1};
    struct bed b = bed_none(VTI_CHECK_BODIES);
    field.effect.apply = loads;
    field.effect.self = &grows;
    b.mass[PUSHED] = MASS_PUSHED;
    b.inertia[PUSHED] = INERTIA_PUSHED;
    b.mass[TWISTED] = MASS_TWISTED;
    b.inertia[TWISTED] = INERTIA_TWISTED;
    b.v[3 * CLOCK] = 1.0;
    b.w[3 * TURNING + 2] = small;
    bed_advance(&kit->host, &b, &field, 1.0 / STEPS, STEPS);
    return b;
}

/** The angle about z in units of small. */
static double angle(const struct bed *b, int64_t i)
{
    const double *q = b->q + 4 * i, s = q[3] < 0.0 ? -1.0 : 1.0;
    return 2.0 * atan2(s * q[2], s * q[3]) / small;
}

static void measure(struct kit *kit, struct response *push, struct response *twist)
{
    const struct bed constant = run(kit, 0);
    push->primed = twist->primed = kit->host.primed;
    push->free = constant.x[3 * CLOCK];
    push->v_const = constant.v[3 * PUSHED + 1];
    push->x_const = constant.x[3 * PUSHED + 1];
    twist->free = angle(&constant, TURNING);
    twist->v_const = constant.w[3 * TWISTED + 2] / small;
    twist->x_const = angle(&constant, TWISTED);
    const struct bed growing = run(kit, 1);
    push->v_grow = growing.v[3 * PUSHED + 1];
    twist->v_grow = growing.w[3 * TWISTED + 2] / small;
}

/* ---- words --------------------------------------------------------------------------------------------------------- */

struct nouns {
    const char *velocities, *load, *inertia, *other, *moves, *drift, *new_velocity, *line_size, *line_start, *line_lead,
        *line_kick;
    double m, j; /* what the load is to be divided by, and what one might take for it */
};

static const struct nouns of_push = {"velocities",
                                     "force",
                                     "mass",
                                     "inertia",
                                     "free flight moves",
                                     "positions are pushed with the old velocity",
                                     "positions are pushed with the velocity of the end of the step",
                                     "force: size of its kicks, off by",
                                     "force: kicks that the start misses",
                                     "force: lead of positions, in steps",
                                     "force: lead of velocities, in steps",
                                     MASS_PUSHED,
                                     INERTIA_PUSHED};
static const struct nouns of_twist = {"spins",
                                      "moment",
                                      "inertia",
                                      "mass",
                                      "a free spin turns",
                                      "rotation is pushed with the old spin",
                                      "rotation is pushed with the spin of the end of the step",
                                      "moment: size of its kicks, off by",
                                      "moment: kicks that the start misses",
                                      "moment: lead of attitudes, in steps",
                                      "moment: lead of spins, in steps",
                                      INERTIA_TWISTED,
                                      MASS_TWISTED};

static int is(double a, double b)
{
    return fabs(a - b) < 0.05;
}

/** The size of a kick in units of the right one. */
static void say_size(struct kit *kit, const struct nouns *of, double size)
{
    kit->energy_known = 1;
    if (is(size, -1.0))
        kit_fault(kit, "the %s enters with the wrong sign", of->load);
    else if (is(size, 2.0))
        kit_fault(kit, "the kick by the %s is applied twice", of->load);
    else if (is(size, 0.5))
        kit_fault(kit, "half of the kick by the %s is missing in every step", of->load);
    else if (is(size, 0.0))
        kit_fault(kit, "the %s does nothing", of->load);
    else if (is(size / of->m, 1.0))
        kit_fault(kit, "the %s is not divided by the %s", of->load, of->inertia);
    else if (is(size * of->j / of->m, 1.0))
        kit_fault(kit, "the %s is divided by the %s where the %s is meant", of->load, of->other, of->inertia);
    else
        kit_fault(kit, "the kick by the %s is %.3g times what it should be", of->load, size);
}

static void say_start(struct kit *kit, const struct nouns *of, double e1, int primed)
{
    if (is(e1, 0.0))
        return;
    if (is(e1, -0.5) && !primed)
        kit_fault(kit, "forces are not primed before the first step");
    else if (is(e1, -0.5))
        kit_fault(kit, "the half kick by the %s at the start is missing", of->load);
    else
        kit_fault(kit, "at the start the %s kicks too %s, by %.2g of a kick", of->load, e1 < 0.0 ? "little" : "much",
                  fabs(e1));
}

/** What leads or lags, and what the energy does for it. */
static void say_order(struct kit *kit, const struct nouns *of, double e2, double e3)
{
    const char *energy = e2 + e3 < -0.05 ? ": energy grows" : e2 + e3 > 0.05 ? ": energy decays" : "";
    if (is(e2, 0.0) && is(e3, 0.0))
        return;
    kit->energy_known = 1;
    if (is(e2, 0.5) && is(e3, -0.5))
        kit_fault(kit, "order 1: %s are half a kick late", of->velocities);
    else if (is(e2, -0.5) && is(e3, 0.5))
        kit_fault(kit, "order 1: %s are half a kick early", of->velocities);
    else if (is(e2, -0.5) && is(e3, 0.0))
        kit_fault(kit, "%s%s", of->drift, energy);
    else if (is(e2, 0.5) && is(e3, 0.0))
        kit_fault(kit, "%s%s", of->new_velocity, energy);
    else if (is(e2, -0.5) && is(e3, -0.5))
        kit_fault(kit, "explicit Euler: %s, and kicks are by the old %s%s", of->drift, of->load, energy);
    else if (is(e2, 0.5) && is(e3, 0.5))
        kit_fault(kit, "implicit Euler: %s, and kicks are by the new %s%s", of->new_velocity, of->load, energy);
    else if (is(e2, 0.0) && e3 < 0.0)
        kit_fault(kit, "%s are kicked by the %s of the previous step%s", of->velocities, of->load, energy);
    else
        kit_fault(kit, "order 1: positions lead by %.2g of a kick by the %s, %s by %.2g%s", e2, of->load,
                  of->velocities, e3, energy);
}

static void signed_line(struct kit *kit, const char *name, double e)
{
    line_say(kit_line(kit, name, fabs(e), -1, 0.01, VTI_CHECK_FAIL), "%+.3f", fabs(e) < 5e-4 ? 0.0 : e);
}

static void judge(struct kit *kit, const struct nouns *of, const struct response *r)
{
    const double h = 1.0 / STEPS, free = fabs(r->free - 1.0) < 1e-3 ? 1.0 : r->free;
    const int is_scaled = fabs(r->v_const - 1.0) > 0.3;
    const double size = is_scaled ? r->v_const : 1.0;
    const double e1 = (r->v_const / size - 1.0) / h, e2 = (r->x_const / (size * free) - 0.5) / h - e1;
    const double e3 = (r->v_grow / size - 0.5) / h;
    line_say(kit_line(kit, of->line_size, fabs(r->v_const - 1.0), -1, 0.3, VTI_CHECK_FAIL), "%.4g of its own",
             r->v_const);
    signed_line(kit, of->line_start, e1);
    signed_line(kit, of->line_lead, e2);
    signed_line(kit, of->line_kick, e3);
    if (free != 1.0 && !kit->attitude_lost)
        kit_fault(kit, "%s by %.3g times what it should", of->moves, free);
    if (is_scaled)
        say_size(kit, of, size);
    if (is(size, 0.0) || is(free, 0.0) || !isfinite(e1 + e2 + e3))
        return;
    say_start(kit, of, e1, r->primed);
    say_order(kit, of, e2, e3);
}

void check_response(struct kit *kit)
{
    struct response push, twist;
    measure(kit, &push, &twist);
    if (!kit->rotates) {
        judge(kit, &of_push, &push);
        return;
    }
    const int attitude_lost = kit->attitude_lost;
    kit->attitude_lost = 0; /* which says nothing of positions */
    judge(kit, &of_push, &push);
    kit->attitude_lost = attitude_lost;
    judge(kit, &of_twist, &twist);
}
