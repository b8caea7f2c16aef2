/* SPDX-License-Identifier: BSD-3-Clause
 * What each effect costs, on a lattice whose bodies all have neighbours in the three directions. */
#include <stdlib.h>

#include "bench.h"

/* ---- bodies and lists -------------------------------------------------------------------------------------------- */

/** The body at (i, j, k), k fastest. */
static int64_t body_at(int64_t side, int64_t i, int64_t j, int64_t k)
{
    return (i * side + j) * side + k;
}

/** Bodies stand still, a spacing of 1 apart, beside it by what random values they had. */
static void place(struct bench_lattice *l, int64_t side)
{
    const vti_bodies *bodies = &l->of.bodies;
    for (int64_t b = 0; b < l->of.n; ++b) {
        const int64_t at[3] = {b / (side * side), b / side % side, b % side};
        for (int c = 0; c < 3; ++c) {
            bodies->x.c[c][3 * b] = (double)at[c] + 0.02 * bodies->x.c[c][3 * b];
            bodies->alpha.c[c][3 * b] *= 0.2;
            bodies->v.c[c][3 * b] = bodies->omega.c[c][3 * b] = 0.0;
        }
    }
}

static void list_neighbours(struct bench_lattice *l, int64_t side)
{
    for (int64_t b = 0; b < l->of.n; ++b) {
        const int64_t at[3] = {b / (side * side), b / side % side, b % side};
        for (int c = 0; c < 3; ++c)
            if (at[c] + 1 < side) {
                l->pair[2 * l->pairs] = b;
                l->pair[2 * l->pairs++ + 1] = body_at(side, at[0] + (c == 0), at[1] + (c == 1), at[2] + (c == 2));
            }
    }
}

/* ---- effects ----------------------------------------------------------------------------------------------------- */

static vti_contacts contacts(const struct bench_lattice *l, const double *diameter)
{
    const vti_contacts c = {
        .count = l->pairs, .pair = l->pair, .diameter = vti_scalars_one(diameter), .stiffness = 1e-6};
    return c;
}

static void set_effects(struct bench_lattice *l, int64_t side)
{
    const vti_bonds bonds = {.count = l->pairs,
                             .pair = l->pair,
                             .rest = l->rest,
                             .moment = vti_scalars_one(&l->stiffness[0]),
                             .axial = vti_scalars_one(&l->stiffness[1]),
                             .shear = vti_scalars_one(&l->stiffness[2]),
                             .shear_form = VTI_SHEAR_OBJECTIVE};
    l->bonds = bonds;
    l->touching = contacts(l, &l->diameter[0]);
    l->apart = contacts(l, &l->diameter[1]);
    for (int k = 0; k < 6; ++k)
        for (int c = 0; c < 4; ++c)
            l->plane[k][c] = c == 3 ? (k % 2 ? -(double)side : -1.0) : c != k / 2 ? 0.0 : k % 2 ? -1.0 : 1.0;
    const vti_walls walls = {
        .count = 6, .plane = l->plane[0], .diameter = vti_scalars_one(&l->diameter[0]), .stiffness = 1e-6};
    l->walls = walls;
    const vti_friction friction = {.contacts = &l->touching,
                                   .sliding = 0.5,
                                   .mindlin = 0.8,
                                   .reach = 0.25,
                                   .history = &l->history,
                                   .lost = l->lost};
    l->friction = friction;
    const vti_dashpots dashpots = {.contacts = &l->touching,
                                   .friction = &l->friction,
                                   .zeta = 0.1,
                                   .ratio = 0.5,
                                   .reach = 0.25,
                                   .lost = l->lost + VTI_FRICTION_BOOKS};
    l->dashpots = dashpots;
    l->rubbing[0] = vti_contacts_effect(&l->touching);
    l->rubbing[1] = vti_friction_effect(&l->friction);
    l->rubbing[2] = vti_dashpots_effect(&l->dashpots);
    l->effect[0] = vti_bonds_effect(&l->bonds);
    l->effect[1] = vti_contacts_effect(&l->touching);
    l->effect[2] = vti_contacts_effect(&l->apart);
    l->effect[3] = vti_walls_effect(&l->walls);
}

/** Of more bodies a step with friction and dashpots, half a microsecond each, is not timed, the last of the cases. */
enum { DEAR = 100000 };

int bench_lattice_make(struct bench_lattice *l, int64_t side)
{
    const struct bench_lattice fresh = {.diameter = {1.2, 0.9}, .stiffness = {1e-6, 1e-6, 1e-6}};
    *l = fresh;
    if (bench_bodies_make(&l->of, BENCH_PACKED, side * side * side) != 0)
        return -1;
    l->pair = malloc(sizeof(int64_t) * 6 * (size_t)l->of.n);
    l->rest = malloc(sizeof(double) * 12 * (size_t)l->of.n);
    for (l->history.slots = 8; l->of.n <= DEAR && l->history.slots < 4 * l->of.n; l->history.slots *= 2)
        ; /* three pairs for each body, at most */
    l->history.held = malloc(sizeof *l->history.held * (size_t)l->history.slots);
    l->history.slot = calloc((size_t)l->history.slots, sizeof *l->history.slot);
    if (l->pair == NULL || l->rest == NULL || l->history.held == NULL || l->history.slot == NULL)
        return -1;
    list_neighbours(l, side);
    place(l, side);
    set_effects(l, side);
    const int rested = vti_bonds_rest(l->pairs, l->pair, 0, &l->of.bodies.x, l->rest, NULL);
    const int taken = vti_effects_check(l->rubbing, 3, &l->of.bodies, NULL); /* what is refused takes no time */
    return rested == VTI_OK && taken == VTI_OK ? 0 : -1;
}

void bench_lattice_free(struct bench_lattice *l)
{
    free(l->history.slot);
    free(l->history.held);
    free(l->rest);
    free(l->pair);
    bench_bodies_free(&l->of);
}

/* ---- cases ------------------------------------------------------------------------------------------------------- */

static void apply(const struct bench_lattice *l, int effect)
{
    l->effect[effect].apply(l->effect[effect].self, &l->of.bodies);
}

static void apply_bonds(void *self)
{
    apply(self, 0);
}

static void apply_touching(void *self)
{
    apply(self, 1);
}

static void apply_apart(void *self)
{
    apply(self, 2);
}

static void apply_walls(void *self)
{
    apply(self, 3);
}

/** A step as a host makes it: begin, clear and sum the loads, finish. */
static void step(const struct bench_lattice *l, const vti_effect *effect)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    vti_step_begin(method, 1e-3, &l->of.bodies, NULL);
    vti_apply(effect, 1, &l->of.bodies);
    vti_step_finish(method, 1e-3, &l->of.bodies);
}

static void step_bonded(void *self)
{
    const struct bench_lattice *l = self;
    step(l, &l->effect[0]);
}

static void step_touching(void *self)
{
    const struct bench_lattice *l = self;
    step(l, &l->effect[1]);
}

static void step_rubbing(void *self)
{
    struct bench_lattice *l = self;
    const vti_stepper *method = vti_stepper_find("vti2");
    vti_effects_begin(method, 1e-3, l->rubbing, 3, &l->of.bodies, NULL);
    vti_apply(l->rubbing, 3, &l->of.bodies);
    vti_effects_finish(method, 1e-3, l->rubbing, 3, &l->of.bodies);
}

int bench_lattice_cases(struct bench_lattice *l, struct bench_case *cases, int count)
{
    const struct bench_case all[] = {
        {.what = "bond", .items = l->pairs, .call = apply_bonds},
        {.what = "touching pair", .items = l->pairs, .call = apply_touching},
        {.what = "pair apart", .items = l->pairs, .call = apply_apart},
        {.what = "body between six walls", .items = l->of.n, .call = apply_walls},
        {.what = "body of a bonded lattice", .items = l->of.n, .call = step_bonded},
        {.what = "body that touches", .items = l->of.n, .call = step_touching},
        {.what = "body that rubs", .items = l->of.n, .call = step_rubbing},
    };
    const size_t most = sizeof all / sizeof *all - (l->of.n > DEAR);
    for (size_t k = 0; k < most; ++k) {
        cases[count] = all[k];
        cases[count].layout = "packed";
        cases[count++].self = l;
    }
    return count;
}
