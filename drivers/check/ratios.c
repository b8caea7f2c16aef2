/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a host's constants say. Some mistakes are known by their ratio: moments of inertia are 2/5 m r^2 of a sphere,
 * 1/2 of a disc, 2/3 of a shell. */
#include "check.h"

struct ratio {
    double value;
    const char *hint;
};

static const struct ratio of_inertia[] = {
    {5.0 / 4, ": 1/2 for 2/5?"},
    {4.0 / 5, ": 2/5 for 1/2?"},
    {5.0 / 3, ": 2/3 for 2/5?"},
    {3.0 / 5, ": 2/5 for 2/3?"},
    {4.0 / 3, ": 2/3 for 1/2?"},
    {3.0 / 4, ": 1/2 for 2/3?"},
    {5.0 / 2, ": without the 2/5?"},
    {2.0 / 5, ": 2/5 twice?"},
    {7.0 / 2, ": 7/5 for 2/5, about a contact?"},
    {4, ": a diameter for a radius?"},
    {1.0 / 4, ": a radius for a diameter?"},
    {32, ": a diameter for a radius, in the mass too?"},
    {1.0 / 32, ": a radius for a diameter, in the mass too?"},
};
static const struct ratio of_mass[] = {
    {8, ": a diameter for a radius?"},
    {1.0 / 8, ": a radius for a diameter?"},
    {3.0 / 4, ": a volume without its 4/3?"},
    {1.0 / CHECK_PI, ": a volume without its pi?"},
    {9.80665, ": a weight for a mass?"},
    {9.81, ": a weight for a mass?"},
    {1e3, ": a unit?"},
    {1e-3, ": a unit?"},
};
static const struct ratio of_turn[] = {
    {2, ": h omega for h omega/2 in a quaternion?"}, {0.5, ": h omega/4 for h omega/2 in a quaternion?"},
    {CHECK_PI / 180, ": degrees for radians?"},      {180 / CHECK_PI, ": degrees for radians?"},
    {2 * CHECK_PI, ": revolutions for radians?"},    {0.5 / CHECK_PI, ": revolutions for radians?"},
};
static const struct ratio of_step[] = {
    {2, ": is each step taken twice?"},
    {0.5, ": half of each step?"},
};

int vti_kit_same_ratio(double a, double b)
{
    return fabs(a - b) <= 1e-4 * fabs(b);
}

int vti_kit_ratio_is_off(double ratio)
{
    return fabs(ratio - 1.0) > 1e-4;
}

static const char *hint_of(const struct ratio *known, size_t count, double ratio)
{
    for (size_t k = 0; k < count; ++k)
        if (vti_kit_same_ratio(ratio, known[k].value))
            return known[k].hint;
    return "";
}

#define HINT(known, ratio) hint_of(known, sizeof(known) / sizeof(known)[0], ratio)

/* ---- words ------------------------------------------------------------------------------------------------------- */

static void say_motion(struct kit *kit, const struct constants *c)
{
    if (vti_kit_ratio_is_off(c->flight))
        vti_kit_fault(kit, "free flight moves by %.5g times what it should", c->flight);
    if (c->turn < 0.0 && !kit->attitude_lost)
        vti_kit_fault(kit, "bodies turn against their spin");
    if (vti_kit_ratio_is_off(fabs(c->turn)) && c->turn != 0.0)
        vti_kit_fault(kit, "a free spin turns by %.5g times what it should%s", fabs(c->turn),
                      HINT(of_turn, fabs(c->turn)));
}

struct nouns {
    const char *load, *own, *other;
};
static const struct nouns of_push = {"force", "mass", "inertia"}, of_twist = {"moment", "inertia", "mass"};

/** Whether a ratio is one of a mistake in the order of a step's parts, not of a constant. */
static int is_of_steps(double ratio)
{
    return vti_kit_same_ratio(ratio, 2.0) || vti_kit_same_ratio(ratio, 0.5);
}

/** All but a constant: what is left is returned as the size of the kick. */
static double say_kick(struct kit *kit, const struct nouns *of, const struct kick *kick)
{
    const double size = fabs(kick->ratio);
    if (isnan(size)) {
        vti_kit_fault(kit, "the kick by the %s is not one number times %s/%s", of->load, of->load, of->own);
        return 1.0;
    }
    if (size == 0.0)
        vti_kit_fault(kit, "the %s does nothing", of->load);
    if (kick->law == KICK_UNDIVIDED)
        vti_kit_fault(kit, "the %s is not divided by the %s", of->load, of->own);
    if (kick->law == KICK_BY_OTHER)
        vti_kit_fault(kit, "the %s is divided by the %s where the %s is meant", of->load, of->other, of->own);
    if (kick->ratio < 0.0)
        vti_kit_fault(kit, "the %s enters with the wrong sign", of->load);
    if (vti_kit_same_ratio(size, 2.0))
        vti_kit_fault(kit, "the kick by the %s is applied twice", of->load);
    if (vti_kit_same_ratio(size, 0.5))
        vti_kit_fault(kit, "half of the kick by the %s is missing in every step", of->load);
    return size == 0.0 || is_of_steps(size) ? 1.0 : size;
}

static void say_force(struct kit *kit, double size)
{
    const double mass = 1.0 / size;
    const char *hint = HINT(of_mass, mass);
    if (vti_kit_ratio_is_off(size) && hint[0] != '\0')
        vti_kit_fault(kit, "masses are %.5g times what they should be%s", mass, hint);
    else if (vti_kit_ratio_is_off(size))
        vti_kit_fault(kit, "forces are %.5g times what they should be, or masses %.5g times: a unit?", size, mass);
}

static void say_inertia(struct kit *kit, double inertia)
{
    const char *hint = HINT(of_inertia, inertia);
    if (vti_kit_ratio_is_off(inertia) && hint[0] != '\0')
        vti_kit_fault(kit, "the inertia is %.5g times what it should be%s", inertia, hint);
    else if (vti_kit_ratio_is_off(inertia))
        vti_kit_fault(kit, "the inertia is %.5g times what it should be, or moments %.5g times", inertia,
                      1.0 / inertia);
}

/** Of sizes of both kicks. What both have in common is that of all loads, unless a known inertia explains the
 *  moment's. */
static void say_constants(struct kit *kit, double force, double moment)
{
    const int explains = HINT(of_inertia, force / moment)[0] != '\0' && HINT(of_inertia, 1.0 / moment)[0] == '\0';
    const int is_common = vti_kit_ratio_is_off(force) && (vti_kit_same_ratio(force, moment) || explains);
    const char *hint = HINT(of_mass, 1.0 / force);
    if (!is_common) {
        say_force(kit, force);
        say_inertia(kit, 1.0 / moment);
        return;
    }
    vti_kit_fault(kit, "forces and moments are %.5g times what they should be, or masses and inertias %.5g times%s",
                  force, 1.0 / force, hint[0] != '\0' ? hint : ": a unit?");
    say_inertia(kit, force / moment);
}

void vti_kit_say_ratios(struct kit *kit, const struct constants *c)
{
    const double step = c->flight, turn = kit->rotates ? fabs(c->turn) : step;
    const double twist = kit->rotates ? c->moment.ratio : step;
    if (vti_kit_ratio_is_off(step) && step > 0.0 && vti_kit_same_ratio(turn, step) &&
        vti_kit_same_ratio(c->force.ratio, step) && vti_kit_same_ratio(twist, step)) {
        vti_kit_fault(kit, "the time step is %.5g times what it should be%s", step, HINT(of_step, step));
        return;
    }
    say_motion(kit, c);
    const double force = say_kick(kit, &of_push, &c->force);
    const double moment = kit->rotates ? say_kick(kit, &of_twist, &c->moment) : force;
    if (kit->rotates)
        say_constants(kit, force, moment);
    else
        say_force(kit, force);
}
