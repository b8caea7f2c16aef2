/* SPDX-License-Identifier: BSD-3-Clause
 * Random physics as the text of a scene: contacts, walls, gravity, pendulums, bonds; sizes, masses and stiffnesses over
 * orders of magnitude, speeds such that contacts go up to some percent of a diameter deep and bonds stretch by as much.
 * Without libm, so that a seed is the same scene everywhere. */
#ifndef VTI_RANDOM_SCENE_H
#define VTI_RANDOM_SCENE_H

#include "../driver/model_support.h"

/** 2^low to 2^high, evenly in the exponent. */
static inline double size_between(rng *g, int low, int high)
{
    return ldexp(uniform(g, 1.0, 2.0), low + rng_below(g, high - low));
}

struct physics {
    double mass, diameter, stiffness, depth, speed; /* depth: of a contact, as a share of the diameter */
};

/** Two bodies that meet at speed go depth into each other: 5 m v^2/8 = K depth^(5/2), within a factor. */
static inline struct physics random_physics(rng *g)
{
    struct physics p = {size_between(g, -7, 7), size_between(g, -3, 4), size_between(g, 0, 20),
                        size_between(g, -13, -4), 0};
    p.speed = sqrt(1.6 * p.stiffness / p.mass * p.depth * p.depth * sqrt(p.depth));
    return p;
}

static inline void say(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static inline void say(char *text, const char *format, ...)
{
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    quote_append(text, TEXT_SIZE, line);
}

static inline void pendulum_text(rng *g, char *text)
{
    double a[3], w[3], rho[3];
    random_alpha(g, a);
    random_unit(g, 3, rho);
    const double inertia = size_between(g, -4, 4), weight = size_between(g, -4, 4);
    random_vector(g, sqrt(weight / inertia), w);
    say(text, "bodies:\n  inertia: %.9g\n  alpha: [%.9g, %.9g, %.9g]\n  omega: [%.9g, %.9g, %.9g]\n", inertia, a[0],
        a[1], a[2], w[0], w[1], w[2]);
    say(text, "pendulum: {weight: %.9g, rho0: [%.9g, %.9g, %.9g]}\n", weight, rho[0], rho[1], rho[2]);
}

static inline void walls_text(rng *g, const struct physics *p, const int counts[3], double spacing, char *text)
{
    say(text, "wall:\n  stiffness: %.9g\n  planes:\n    - [0, 0, 1, %.9g]\n", p->stiffness * uniform(g, 0.5, 2.0),
        -spacing);
    for (int k = 0; rng_below(g, 2) && k < 2; ++k)
        say(text, "    - [%d, %d, 0, %.9g]\n    - [%d, %d, 0, %.9g]\n", k == 0, k == 1, -spacing, -(k == 0), -(k == 1),
            -spacing * counts[k]);
}

/** A lattice of 2 to 27 spheres, bonded or not. */
static inline void spheres_text(rng *g, int bonded, char *text)
{
    static const char *const forms[] = {"objective", "quartic", "printed"};
    const struct physics p = random_physics(g);
    const int counts[3] = {2 + rng_below(g, 2), 1 + rng_below(g, 3), 1 + rng_below(g, 3)};
    const double spacing = p.diameter * (bonded ? 1.0 : uniform(g, 1.02, 1.5));
    const int wall = rng_below(g, 2), gravity = wall && rng_below(g, 2);
    say(text, "bodies:\n  lattice: {counts: [%d, %d, %d], spacing: %.9g, corner: [0, 0, 0]}\n", counts[0], counts[1],
        counts[2], spacing);
    say(text, "  diameter: %.9g\n  mass: %.9g\n  v: [0, 0, %.9g]\n", p.diameter, p.mass, wall ? -p.speed : 0.0);
    say(text, "  random: {seed: %d, v: %.9g", 1 + rng_below(g, 1000000), p.speed);
    if (bonded)
        say(text, ", omega: %.9g", p.speed / p.diameter * uniform(g, 0.0, 2.0));
    say(text, "}\n");
    if (bonded)
        say(text, "binder: {moment: %.9g, axial: %.9g, shear: {stiffness: %.9g, form: %s}}\n",
            p.stiffness * size_between(g, -6, 0), p.stiffness, p.stiffness * size_between(g, -4, 1),
            forms[rng_below(g, 3)]);
    if (!bonded || rng_below(g, 2))
        say(text, "contact: {stiffness: %.9g}\n", p.stiffness);
    if (wall)
        walls_text(g, &p, counts, spacing, text);
    if (gravity)
        say(text, "gravity: [0, 0, %.9g]\n", -p.speed * p.speed / spacing * uniform(g, 0.05, 0.5));
}

/** The text but for h and t_end; the stepper is one of steppers. */
static inline void random_scene(rng *g, const char *const *steppers, int n, char text[TEXT_SIZE])
{
    const int kind = rng_below(g, 8);
    text[0] = '\0';
    if (kind == 0)
        pendulum_text(g, text);
    else
        spheres_text(g, kind < 6, text);
    say(text, "stepper: %s\nh: 1\nt_end: 1\n", steppers[rng_below(g, n)]);
}

/** The stable step that the energies of the start allow, contacts that may come included. To seven bits, so that
 *  nothing hangs on the last of them. */
static inline double random_bound(const struct model *model)
{
    struct message message;
    struct model_limits limits;
    int exponent;
    if (model_find_limits(model, &limits, &message) != 0)
        fail_msg("%s", message.text);
    const double h = fmin(limits.rest.h, limits.within.h), digits = frexp(h, &exponent);
    assert_true(isfinite(h));
    return ldexp(floor(128.0 * digits) / 128.0, exponent);
}

#endif
