/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene made of the effects that its argument names, stepped so many times: what callgrind counts instructions of.
 *     cost CONFIG STEPS [WEIGHT]
 *             CONFIG: letters t translation, r rotation, l force and moment arrays; m a s binder terms; c contact, w
 *             wall, g gravity, p pendulum; what loses energy: d dashpots (normal, tangential) and f friction (sliding)
 *             of contacts, x drag, k rupture of bonds, b dashpots of bonds; h the pendulum by hand, without the
 *             library's steps and effects; 1 one body, u not sealed, z an array for each component,
 *             y loads that stay as they are */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vti.h"

enum { N = 512 };

#define STIFFNESS 1.0

static double one = 1.0;
static const double stiffness = STIFFNESS, diameter = 1.0, h = 1e-3;
static double x[N][3], v[N][3], force[N][3], alpha[N][3], omega[N][3], moment[N][3], rest[N][4];
static int64_t pair[N - 1][2];
static const double floor_plane[1][4] = {{0.0, 0.0, 1.0, -0.4}}; /* every body touches it */
/* not constants, lest the loop by hand be compiled for this arm only */
static vti_pendulum pendulum = {1.0, {0.0, 0.0, 1.0}};
static vti_held entries[2 * N];
static int64_t slots[2 * N];
static vti_sum lost[5][5];
static int64_t id[N - 1];
static const vti_gravity gravity = {{0.0, 0.0, -1.0}};
static const double limit = 1e9; /* nothing breaks: what looking for it costs */

/* those of the letters m, a and s get their stiffnesses by set_bonds */
static vti_bonds bonds = {.count = N - 1, .pair = pair[0], .rest = rest[0], .shear_form = VTI_SHEAR_OBJECTIVE}, held;
static const vti_contacts contacts = {
    .count = N - 1, .pair = pair[0], .diameter = {.p = &diameter}, .stiffness = STIFFNESS};
static const vti_walls walls = {
    .count = 1, .plane = floor_plane[0], .diameter = {.p = &diameter}, .stiffness = STIFFNESS};
static vti_history history = {2 * N, 0, 0, entries, slots};
static const vti_friction friction = {
    .contacts = &contacts, .sliding = 0.5, .mindlin = 0.8, .reach = 0.1, .history = &history, .lost = lost[0]};
static vti_dashpots dashpots = {.contacts = &contacts, .zeta = 0.1, .ratio = 0.5, .reach = 0.1, .lost = lost[1]};
static const vti_drag drag = {.linear = {.p = &stiffness}, .lost = lost[2]};
static const vti_rupture rupture = {.bonds = &held, .id = id, .normal = {.p = &limit}, .lost = lost[3]};
static const vti_bond_dashpots bond_dashpots = {.bonds = &bonds, .zeta = 0.1, .lost = lost[4]};

/** A chain along x, its neighbours slightly overlapping, everything moving a little. */
static void place(void)
{
    for (int i = 0; i < N; ++i) {
        x[i][0] = 0.99 * i;
        for (int k = 0; k < 3; ++k) {
            v[i][k] = 1e-3 * ((7 * i + 3 * k) % 11 - 5);
            omega[i][k] = 1e-2 * ((5 * i + 2 * k) % 13 - 6);
        }
        alpha[i][1] = 0.1;
    }
    for (int i = 0; i < N - 1; ++i) {
        pair[i][0] = i;
        pair[i][1] = i + 1;
        id[i] = i;
    }
}

/** Packed vectors, or so many numbers as three arrays. */
static vti_view view(const char *config, double (*a)[3])
{
    return strchr(config, 'z') == NULL ? vti_view_packed(a[0]) : vti_view_separate(a[0], a[0] + N, a[0] + 2 * N);
}

/** The pendulum as one would write it: one loop over bodies, the same arithmetic. */
static void by_hand(long steps)
{
    const double kick = 0.5 * h / one;
    for (long n = 0; n < steps; ++n)
        for (int i = 0; i < N; ++i) {
            double q[4], arm[3], u[3];
            for (int k = 0; k < 3; ++k) {
                omega[i][k] += kick * moment[i][k];
                u[k] = h * omega[i][k];
            }
            vti_rrv_turn(2.0, u, alpha[i]);
            vti_rrv_to_pair(alpha[i], q);
            vti_pair_rotate(q, 1.0, pendulum.rho0, arm);
            moment[i][0] = pendulum.weight * arm[1];
            moment[i][1] = -pendulum.weight * arm[0];
            moment[i][2] = 0.0;
            for (int k = 0; k < 3; ++k)
                omega[i][k] += kick * moment[i][k];
        }
}

static int has(const char *config, const char *letters)
{
    return strpbrk(config, letters) != NULL;
}

static vti_bodies set_bodies(const char *config)
{
    vti_bodies b = vti_bodies_none(has(config, "1") ? 1 : N);
    if (has(config, "t")) {
        b.x = view(config, x);
        b.v = view(config, v);
        b.mass = vti_scalars_one(&one);
    }
    if (has(config, "r")) {
        b.alpha = view(config, alpha);
        b.omega = view(config, omega);
        b.inertia = vti_scalars_one(&one);
    }
    if (has(config, "l") && has(config, "t"))
        b.force = view(config, force);
    if (has(config, "l") && has(config, "r"))
        b.moment = view(config, moment);
    return b;
}

static int set_bonds(const char *config)
{
    const vti_view start = vti_view_packed(x[0]);
    const vti_scalars none = {NULL, 0, 0}, k = vti_scalars_one(&stiffness);
    bonds.moment = has(config, "m") ? k : none;
    bonds.axial = has(config, "a") ? k : none;
    bonds.shear = has(config, "s") ? k : none;
    held = bonds;
    return has(config, "mas") ? vti_bonds_rest(N - 1, pair[0], 0, &start, rest[0], NULL) : VTI_OK;
}

/* made only where they are asked for: a scene calls no function of what it does not have */
#define MAKES(name)                                                                                                    \
    static vti_effect make_##name(void)                                                                                \
    {                                                                                                                  \
        return vti_##name##_effect(&name);                                                                             \
    }
MAKES(bonds)
MAKES(contacts)
MAKES(walls)
MAKES(gravity)
MAKES(pendulum)
MAKES(friction)
MAKES(dashpots)
MAKES(drag)
MAKES(rupture)
MAKES(bond_dashpots)

static const struct {
    const char *letters;
    vti_effect (*make)(void);
} kinds[] = {{"mas", make_bonds},  {"c", make_contacts},     {"w", make_walls},    {"g", make_gravity},
             {"p", make_pendulum}, {"f", make_friction},     {"d", make_dashpots}, {"x", make_drag},
             {"k", make_rupture},  {"b", make_bond_dashpots}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/** Those of the letters, and how many. */
static int64_t set_effects(const char *config, vti_effect effects[KINDS])
{
    int64_t n = 0;
    dashpots.friction = has(config, "f") ? &friction : NULL;
    for (int k = 0; k < KINDS; ++k)
        if (has(config, kinds[k].letters))
            effects[n++] = kinds[k].make();
    return n;
}

static int step_losing(const vti_stepper *method, const char *config, const vti_effect *effects, int64_t n,
                       const vti_bodies *b)
{
    int64_t broken = 0;
    int status = vti_effects_begin(method, h, effects, n, b, NULL);
    if (status == VTI_OK)
        status = vti_apply(effects, n, b);
    if (status == VTI_OK)
        status = vti_effects_finish(method, h, effects, n, b);
    return status == VTI_OK && has(config, "k") ? vti_effects_rupture(effects, n, b, &broken) : status;
}

static int step_plain(const vti_stepper *method, const char *config, const vti_effect *effects, int64_t n,
                      const vti_bodies *b)
{
    int status = vti_step_begin(method, h, b, NULL);
    if (status == VTI_OK && !has(config, "y"))
        status = vti_apply(effects, n, b);
    return status == VTI_OK ? vti_step_finish(method, h, b) : status;
}

/** Of the first call that is refused. */
static int go(const char *config, long steps)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    vti_bodies b = set_bodies(config);
    vti_effect effects[KINDS];
    int status = set_bonds(config);
    const int64_t n = set_effects(config, effects);
    if (status == VTI_OK && !has(config, "u"))
        status = vti_bodies_seal(&b);
    for (long s = 0; s < steps && status == VTI_OK; ++s)
        status = (has(config, "dfxkb") ? step_losing : step_plain)(method, config, effects, n, &b);
    return status;
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        fputs("usage: cost CONFIG STEPS [WEIGHT]\n", stderr);
        return EXIT_FAILURE;
    }
    const char *config = argv[1];
    const long steps = atol(argv[2]);
    int status = VTI_OK;
    place();
    if (argc > 3)
        pendulum.weight = one = atof(argv[3]);
    if (has(config, "h"))
        by_hand(steps);
    else
        status = go(config, steps);
    if (status != VTI_OK) {
        fprintf(stderr, "cost: %s: %s\n", config, vti_status_text(status));
        return EXIT_FAILURE;
    }
    printf("%s: %.17g %.17g\n", config, x[N / 2][2], alpha[N / 2][0]);
    return EXIT_SUCCESS;
}
