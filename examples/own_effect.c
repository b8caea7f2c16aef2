/* SPDX-License-Identifier: BSD-3-Clause
 * A host's own effect, stepped, bounded, refused and measured like the library's: a trap F = -k x with a drag -c v. */
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { N = 2, STEPS = 200 };

struct trap {
    double stiffness, drag;
    vti_sum *lost; /* what the drag has taken */
};

/** F = -k x */
static void pull(const void *self, const vti_bodies *b)
{
    const struct trap *trap = self;
    for (int64_t i = b->first; i < b->first + b->count; ++i)
        for (int k = 0; k < 3; ++k)
            b->force.c[k][i * b->force.stride] -= trap->stiffness * b->x.c[k][i * b->x.stride];
}

/** U = k/2 |x|^2 */
static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const struct trap *trap = self;
    energies[0] = 0.0;
    for (int64_t i = b->first; i < b->first + b->count; ++i)
        for (int k = 0; k < 3; ++k)
            energies[0] += 0.5 * trap->stiffness * pow(b->x.c[k][i * b->x.stride], 2.0);
}

/** The stiffness k at every body, along any direction: an energy, k times the length squared. */
static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const struct trap *trap = self;
    (void)at; /* the same wherever the bodies are */
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const vti_spring s = {
            .element = i, .i = i, .j = -1, .length = 1.0, .axial = trap->stiffness, .across = trap->stiffness};
        visit(context, &s);
    }
    return VTI_OK;
}

/** v <- v exp(-c t/m), exactly, whatever t is. */
static void damp(const void *self, const vti_bodies *b, double t, double drift)
{
    const struct trap *trap = self;
    (void)drift; /* the drag does not depend on positions */
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const double m = b->mass.p[i * b->mass.stride], keeps = exp(-trap->drag * t / m);
        for (int k = 0; k < 3; ++k) {
            double *v = b->v.c[k] + i * b->v.stride;
            vti_sum_add(trap->lost, 0.5 * m * *v * *v * (1.0 - keeps * keeps));
            *v *= keeps;
        }
    }
}

static void must(int status)
{
    if (status != VTI_OK) {
        fprintf(stderr, "own_effect: %s\n", vti_status_text(status));
        exit(EXIT_FAILURE);
    }
}

int main(void)
{
    static const char *const term[] = {"trap"}, *const book[] = {"drag"};
    double x[N][3] = {{1.0, 0.0, 0.5}, {0.0, -2.0, 0.0}}, v[N][3] = {{0.0, 1.0, 0.0}, {0.5, 0.0, 0.5}}, force[N][3];
    double mass[N] = {1.0, 2.0}, scratch[N];
    vti_sum lost = {0.0, 0.0};
    const struct trap trap = {.stiffness = 4.0, .drag = 0.3, .lost = &lost};
    const vti_effect effect = {.name = "trap",
                               .apply = pull,
                               .energy = energy,
                               .springs = springs,
                               .flow = damp,
                               .self = &trap,
                               .needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS,
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .smooth = 1,
                               .breaks = VTI_BREAKS_LINEAR | VTI_BREAKS_ANGULAR,
                               .dissipates = 1,
                               .terms = 1,
                               .term = term,
                               .books = 1,
                               .book = book,
                               .booked = &lost};
    vti_bodies bodies = vti_bodies_none(N);
    bodies.v = vti_view_packed(v[0]);
    bodies.force = vti_view_packed(force[0]);
    bodies.mass = vti_scalars_array(mass);

    vti_fault fault;
    int status = vti_effects_check(&effect, 1, &bodies, &fault);
    printf("without positions: effect %lld needs %s: %s\n", (long long)fault.body, vti_quantity_text(fault.quantity),
           vti_status_text(status));
    bodies.x = vti_view_packed(x[0]);
    must(vti_bodies_check_values(&bodies, NULL));
    must(vti_effects_check(&effect, 1, &bodies, NULL));
    status = vti_step_check(vti_stepper_find("srkn14"), &effect, 1);
    printf("by srkn14: %s\n", vti_status_text(status));

    const vti_deformation rest = {0.0, 0.0, 0};
    vti_stable stable;
    must(vti_stable_step(&effect, 1, &bodies, &rest, scratch, &stable));
    printf("stable below h = %.15g, by effect %lld at body %lld\n", stable.h, (long long)stable.effect,
           (long long)stable.i);

    const vti_stepper *method = vti_stepper_find("vti2");
    const double h = stable.h / 50.0, start = vti_energy(&effect, 1, &bodies);
    must(vti_apply(&effect, 1, &bodies));
    for (int k = 0; k < STEPS; ++k) {
        must(vti_effects_begin(method, h, &effect, 1, &bodies, NULL));
        must(vti_apply(&effect, 1, &bodies));
        must(vti_effects_finish(method, h, &effect, 1, &bodies));
    }
    const double end = vti_energy(&effect, 1, &bodies), off = end + vti_booked(&effect, 1) - start;
    printf("energy %.6f -> %.6f, booked %.6f, together off by %.1e\n", start, end, vti_booked(&effect, 1), off);
    return fabs(stable.h - 1.0) < 1e-15 && fabs(off) < 1e-3 * start ? EXIT_SUCCESS : EXIT_FAILURE;
}
