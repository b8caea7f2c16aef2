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

static double one = 1.0;
static const double stiffness = 1.0, diameter = 1.0, h = 1e-3;
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

int main(int argc, char **argv)
{
    const char *config = argc >= 3 ? argv[1] : "";
    const long steps = argc >= 3 ? atol(argv[2]) : 0;
    vti_bodies b = vti_bodies_none(strchr(config, '1') != NULL ? 1 : N);
    vti_effect effects[10];
    int64_t n = 0, broken = 0;
    place();
    if (strchr(config, 't') != NULL) {
        b.x = view(config, x);
        b.v = view(config, v);
        b.mass = vti_scalars_one(&one);
    }
    if (strchr(config, 'r') != NULL) {
        b.alpha = view(config, alpha);
        b.omega = view(config, omega);
        b.inertia = vti_scalars_one(&one);
    }
    if (strchr(config, 'l') != NULL && strchr(config, 't') != NULL)
        b.force = view(config, force);
    if (strchr(config, 'l') != NULL && strchr(config, 'r') != NULL)
        b.moment = view(config, moment);

    const vti_scalars none = {NULL, 0, 0}, k = vti_scalars_one(&stiffness), d = vti_scalars_one(&diameter);
    const int terms = strpbrk(config, "mas") != NULL;
    const vti_bonds bonds = {N - 1,
                             pair[0],
                             0,
                             rest[0],
                             strchr(config, 'm') != NULL ? k : none,
                             strchr(config, 'a') != NULL ? k : none,
                             strchr(config, 's') != NULL ? k : none,
                             VTI_SHEAR_OBJECTIVE,
                             NULL};
    const vti_contacts contacts = {.count = N - 1, .pair = pair[0], .diameter = d, .stiffness = stiffness};
    const vti_walls walls = {.count = 1, .plane = floor_plane[0], .diameter = d, .stiffness = stiffness};
    if (terms) {
        const vti_view start = vti_view_packed(x[0]);
        vti_bonds_rest(N - 1, pair[0], 0, &start, rest[0], NULL);
        effects[n++] = vti_bonds_effect(&bonds);
    }
    if (strchr(config, 'c') != NULL)
        effects[n++] = vti_contacts_effect(&contacts);
    if (strchr(config, 'w') != NULL)
        effects[n++] = vti_walls_effect(&walls);
    if (strchr(config, 'g') != NULL)
        effects[n++] = vti_gravity_effect(&gravity);
    if (strchr(config, 'p') != NULL)
        effects[n++] = vti_pendulum_effect(&pendulum);

    vti_history history = {2 * N, 0, 0, entries, slots};
    const vti_friction friction = {
        .contacts = &contacts, .sliding = 0.5, .mindlin = 0.8, .reach = 0.1, .history = &history, .lost = lost[0]};
    const vti_dashpots dashpots = {.contacts = &contacts,
                                   .friction = strchr(config, 'f') != NULL ? &friction : NULL,
                                   .zeta = 0.1,
                                   .ratio = 0.5,
                                   .reach = 0.1,
                                   .lost = lost[1]};
    const vti_drag drag = {.linear = k, .lost = lost[2]};
    const vti_bond_dashpots bond_dashpots = {.bonds = &bonds, .zeta = 0.1, .lost = lost[4]};
    const double limit = 1e9; /* nothing breaks: what looking for it costs */
    vti_bonds held = bonds;
    const vti_rupture rupture = {.bonds = &held, .id = id, .normal = vti_scalars_one(&limit), .lost = lost[3]};
    if (strchr(config, 'f') != NULL)
        effects[n++] = vti_friction_effect(&friction);
    if (strchr(config, 'd') != NULL)
        effects[n++] = vti_dashpots_effect(&dashpots);
    if (strchr(config, 'x') != NULL)
        effects[n++] = vti_drag_effect(&drag);
    if (strchr(config, 'k') != NULL)
        effects[n++] = vti_rupture_effect(&rupture);
    if (strchr(config, 'b') != NULL)
        effects[n++] = vti_bond_dashpots_effect(&bond_dashpots);

    if (argc > 3)
        pendulum.weight = one = atof(argv[3]);
    const vti_stepper *method = vti_stepper_find("vti2");
    int status = strchr(config, 'u') == NULL ? vti_bodies_seal(&b) : VTI_OK;
    if (strchr(config, 'h') != NULL)
        by_hand(steps);
    else if (strpbrk(config, "dfxkb") != NULL)
        for (long s = 0; s < steps && status == VTI_OK; ++s) {
            status = vti_effects_begin(method, h, effects, n, &b, NULL);
            vti_apply(effects, n, &b);
            vti_effects_finish(method, h, effects, n, &b);
            if (strchr(config, 'k') != NULL)
                status = vti_effects_rupture(effects, n, &b, &broken);
        }
    else
        for (long s = 0; s < steps && status == VTI_OK; ++s) {
            status = vti_step_begin(method, h, &b, NULL);
            if (strchr(config, 'y') == NULL)
                vti_apply(effects, n, &b);
            vti_step_finish(method, h, &b);
        }
    printf("%s: %.17g %.17g\n", config, x[N / 2][2], alpha[N / 2][0]);
    return status == VTI_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
