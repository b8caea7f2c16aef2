/* SPDX-License-Identifier: BSD-3-Clause
 * A host with contacts, walls, friction and dashpots: 64 beads fall into a box and come to rest. It searches for pairs
 * itself, and prints what becomes of the energy. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vti.h"

enum { SIDE = 4, N = SIDE * SIDE * SIDE, PAIRS = 16 * N, SLOTS = 4096 /* a power of 2, twice the touches and more */ };

static const double D = 1.0, mass = 1.0, inertia = 0.1, skin = 0.2;
static double x[N][3], v[N][3], force[N][3], alpha[N][3], omega[N][3], moment[N][3];
static double listed[N][3]; /* where the beads were when the pairs were listed */
static int64_t pair[PAIRS][2];
static vti_held held[SLOTS];
static int64_t slot[SLOTS];

static void must(int status)
{
    if (status != VTI_OK) {
        fprintf(stderr, "grains: %s\n", vti_status_text(status));
        exit(EXIT_FAILURE);
    }
}

static double squared(const double a[3], const double b[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

/** All pairs with a gap below the skin, each once, the lower number first. */
static void find_pairs(vti_contacts *contacts)
{
    contacts->count = 0;
    for (int64_t i = 0; i < N; ++i)
        for (int64_t j = i + 1; j < N; ++j)
            if (squared(x[i], x[j]) < (D + skin) * (D + skin)) {
                if (contacts->count == PAIRS) {
                    fputs("grains: too many pairs\n", stderr);
                    exit(EXIT_FAILURE);
                }
                pair[contacts->count][0] = i;
                pair[contacts->count++][1] = j;
            }
    memcpy(listed, x, sizeof x);
}

/** Whether a bead has moved by a quarter of the skin: two of them then leave half of it for `reach`, a quarter, and for
 *  what they come nearer in the next step. */
static int have_moved(void)
{
    for (int i = 0; i < N; ++i)
        if (squared(x[i], listed[i]) > 0.0625 * skin * skin)
            return 1;
    return 0;
}

static void place(vti_bodies *b)
{
    for (int i = 0; i < N; ++i) {
        const int at[3] = {i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE};
        for (int k = 0; k < 3; ++k) {
            x[i][k] = 0.8 + 1.1 * at[k];
            v[i][k] = 0.1 * ((7 * i + 3 * k) % 11 - 5); /* or they would fall in columns */
        }
    }
    *b = vti_bodies_none(N);
    b->x = vti_view_packed(x[0]);
    b->v = vti_view_packed(v[0]);
    b->force = vti_view_packed(force[0]);
    b->alpha = vti_view_packed(alpha[0]);
    b->omega = vti_view_packed(omega[0]);
    b->moment = vti_view_packed(moment[0]);
    b->mass = vti_scalars_one(&mass);
    b->inertia = vti_scalars_one(&inertia);
    must(vti_bodies_check_values(b, NULL));
}

/** A step that is stable while contacts overlap by up to a twentieth, whoever may meet: a fifth of it resolves them. */
static double find_step(const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    const vti_deformation at = {.overlap = 0.05, .meet = 1};
    static double scratch[N];
    vti_stable stable;
    must(vti_stable_step(effects, n, b, &at, scratch, &stable));
    return 0.2 * stable.h;
}

static void step(double h, vti_effect *effects, int64_t n, vti_bodies *b, vti_contacts *contacts)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    must(vti_effects_begin(method, h, effects, n, b, NULL));
    if (have_moved()) /* springs of friction have been carried by the old list, which had the pair too */
        find_pairs(contacts);
    must(vti_apply(effects, n, b));
    must(vti_effects_finish(method, h, effects, n, b));
}

int main(void)
{
    enum { EFFECTS = 5, ROWS = 8 };
    static const double box[5][4] = {
        {0, 0, 1, 0}, {1, 0, 0, 0}, {-1, 0, 0, -4.9}, {0, 1, 0, 0}, {0, -1, 0, -4.9}}; /* n.x >= offset */
    const double stiffness = 1e5, nu = 0.3;
    vti_sum lost_friction[VTI_FRICTION_BOOKS] = {{0.0, 0.0}}, lost_dashpot[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}};
    vti_history history = {.slots = SLOTS, .held = held, .slot = slot};
    vti_bodies b;
    place(&b);

    vti_contacts contacts = {.pair = pair[0], .diameter = vti_scalars_one(&D), .stiffness = stiffness};
    find_pairs(&contacts);
    const vti_walls walls = {.count = 5, .plane = box[0], .diameter = contacts.diameter, .stiffness = stiffness};
    const vti_gravity gravity = {{0.0, 0.0, -9.81}};
    const vti_friction friction = {.contacts = &contacts,
                                   .walls = &walls,
                                   .sliding = 0.5,
                                   .mindlin = 2.0 * (1.0 - nu) / (2.0 - nu),
                                   .rolling = 0.05,
                                   .rolling_stiffness = 500.0,
                                   .twisting = 0.05,
                                   .twisting_stiffness = 500.0,
                                   .reach = 0.25 * skin,
                                   .history = &history,
                                   .lost = lost_friction};
    const vti_dashpots dashpots = {.contacts = &contacts,
                                   .walls = &walls,
                                   .friction = &friction,
                                   .zeta = vti_dashpots_zeta(0.5, 0), /* restitution 1/2 at any speed */
                                   .ratio = 0.5,
                                   .rolling = 2.0,
                                   .twisting = 2.0,
                                   .reach = 0.25 * skin,
                                   .lost = lost_dashpot};
    vti_effect effects[EFFECTS] = {vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                   vti_gravity_effect(&gravity), vti_friction_effect(&friction),
                                   vti_dashpots_effect(&dashpots)};
    must(vti_contacts_check(&contacts, N, NULL));
    must(vti_effects_check(effects, EFFECTS, &b, NULL));
    must(vti_step_check(vti_stepper_find("vti2"), effects, EFFECTS));

    const double h = find_step(effects, EFFECTS, &b), t_end = 8.0;
    const long steps = (long)(t_end / h);
    must(vti_apply(effects, EFFECTS, &b)); /* the first kick needs forces */
    const double start = vti_energy(effects, EFFECTS, &b);
    printf("h = %.3g\n%8s %12s %12s %12s %12s\n", h, "t", "kinetic", "friction", "dashpots", "sum");
    double sum = start, kinetic = 0.0;
    for (long k = 0; k <= steps; ++k) {
        if (k % (steps / ROWS) == 0) {
            const vti_effect *const takes = effects + 3;
            kinetic = vti_kinetic_translation(&b) + vti_kinetic_rotation(&b);
            sum = vti_energy(effects, EFFECTS, &b) + vti_booked(effects, EFFECTS);
            printf("%8.3f %12.4g %12.4g %12.4g %12.6g\n", (double)k * h, kinetic, vti_booked(takes, 1),
                   vti_booked(takes + 1, 1), sum);
        }
        step(h, effects, EFFECTS, &b, &contacts);
    }
    if (kinetic > 1e-9 * start || !(sum > 0.999 * start && sum < 1.001 * start)) {
        fputs("grains: the beads are not at rest, or energy is not accounted for\n", stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
