/* SPDX-License-Identifier: BSD-3-Clause */
#include "norms.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- energy and momenta ------------------------------------------------------------------------------------------ */

double norms_energy(struct model *model, const vti_bodies *bodies)
{
    return model_energy(model, bodies) + vti_booked(model->effects, model->effects_count);
}

/** Terms of energy that effects write, if all else that there is can be taken of many states at once: the energies of
 *  spheres, of which nothing dissipates where states wait. */
static int64_t terms_of(const struct model *model)
{
    int64_t terms = 0;
    for (int64_t e = 0; e < model->effects_count; ++e)
        terms += model->effects[e].terms;
    return model->bodies.moments.c[0] == NULL && terms <= EFFECT_TERMS_OF_ALL ? terms : -1;
}

/** (E_h - E_0)^2 in place of energies. */
static void square_deviations(const struct norms *n, double *energy, int64_t count)
{
    for (int64_t k = 0; k < count; ++k)
        energy[k] = (energy[k] - n->energy0) * (energy[k] - n->energy0);
}

/** Of momentum k. */
static void take_invariant(struct norms *n, int64_t k, const double *value, int64_t count)
{
    states_farthest(value, n->invariants0[k], count, &n->momentum_error);
}

static void take_conserved(struct norms *n, const vti_bodies *bodies)
{
    double values[MODEL_INVARIANTS], energy = norms_energy(n->model, bodies);
    square_deviations(n, &energy, 1);
    vti_integral_add(&n->energy_squared, n->h, energy);
    model_invariant_values(n->model, bodies, values);
    for (int64_t k = 0; k < n->invariants; ++k)
        if (n->invariant[k].is_momentum)
            take_invariant(n, k, &values[k], 1);
}

/** The effect whose energy is taken of many states at once, else NULL. */
static const struct effect *each_of(const struct model *model, int64_t e)
{
    return e < model->instances_count && model->instances[e].kind->each != NULL ? &model->instances[e] : NULL;
}

/** Energies that effects alone know, of the state that joins those that wait. */
static void put_terms(struct norms *n, const vti_bodies *bodies)
{
    const struct model *model = n->model;
    const int found = model_find_pairs(n->model, bodies) == VTI_OK;
    for (int64_t e = 0, j = 0; e < model->effects_count; j += model->effects[e++].terms) {
        double energies[VTI_TERMS];
        if (each_of(model, e) != NULL)
            continue;
        memset(energies, 0, (size_t)model->effects[e].terms * sizeof *energies);
        if (model->effects[e].energy != NULL)
            model->effects[e].energy(model->effects[e].self, bodies, energies);
        for (int64_t i = 0; i < model->effects[e].terms; ++i)
            n->terms[j + i][n->held] = found ? energies[i] : NAN;
    }
}

/** The others, of all that wait. */
static void take_terms(struct norms *n)
{
    const struct model *model = n->model;
    for (int64_t e = 0, j = 0; e < model->effects_count; j += model->effects[e++].terms)
        if (each_of(model, e) != NULL)
            states_sum_each(&n->states, each_of(model, e), n->bodies, n->terms[j]);
}

static void take_momenta(struct norms *n)
{
    double momentum[MODEL_INVARIANTS][PANELS_BLOCK];
    const int64_t momenta = model_momenta(n->model);
    int64_t row = 0;
    for (int which = STATES_LINEAR; which <= STATES_SPIN; ++which) {
        if ((momenta >> 3 * which & 7) == 0)
            continue;
        states_momenta(&n->states, (enum states_momentum)which, n->kept, n->held, momentum[0]);
        for (int c = 0; c < 3; ++c)
            if (momenta >> (3 * which + c) & 1)
                take_invariant(n, row++, momentum[c], n->held);
    }
    const int64_t own = model_own_momenta(n->model, n->bodies, momentum[0], PANELS_BLOCK);
    for (int64_t k = 0; k < own; ++row)
        if (n->invariant[row].is_momentum)
            take_invariant(n, row, momentum[k++], n->held);
}

/** The energies' deviations squared, and momenta. */
static void take_those_conserved(struct norms *n, double energy[PANELS_BLOCK])
{
    take_terms(n);
    states_energies(&n->states, n->kept, n->terms[0], n->terms_count, n->held, energy);
    square_deviations(n, energy, n->held);
    take_momenta(n);
}

/* ---- norms ------------------------------------------------------------------------------------------------------- */

int norms_create(struct norms *n, struct model *model, const struct trial *trial, int64_t compare_every,
                 struct reference *reference, const struct watch *watch, struct message *message)
{
    memset(n, 0, sizeof *n);
    n->reference = reference;
    n->watch = watch;
    n->h = trial->h;
    n->last = trial->steps;
    n->compare_every = compare_every;
    n->model = model;
    n->energy0 = norms_energy(model, &model->bodies);
    n->energy_unit = model_energy0(model) != 0.0 ? fabs(n->energy0) : 1.0;
    n->invariants = model_invariants(model, n->invariant);
    for (int64_t momenta = model_momenta(model); momenta != 0; momenta &= momenta - 1)
        ++n->momenta;
    model_invariant_values(model, &model->bodies, n->invariants0);
    n->terms_count = terms_of(model);
    n->states = states_of(model);
    for (int64_t e = 0; e < model->effects_count; ++e)
        n->puts |= each_of(model, e) == NULL;
    if (reference->interval != 0.0)
        return 0;
    const int64_t bodies = n->states.bodies, width = states_width(&n->states), loads = states_loads(&n->states);
    n->memory = calloc((size_t)(bodies * (width + loads) * PANELS_BLOCK + PANELS_SPARE), sizeof *n->memory);
    n->bodies = calloc((size_t)bodies, sizeof *n->bodies);
    if (n->memory == NULL || n->bodies == NULL)
        return scene_no_memory(model->scene, message);
    n->kept = panels_aligned(n->memory);
    n->loads = n->kept + bodies * width * PANELS_BLOCK;
    for (int64_t i = 0; i < bodies && n->terms_count >= 0; ++i) {
        n->bodies[i] = states_of_body(&n->states, i, n->kept, n->loads);
        vti_bodies_seal(&n->bodies[i]);
    }
    return 0;
}

void norms_destroy(struct norms *n)
{
    free(n->memory);
    free(n->bodies);
    n->memory = n->kept = NULL;
    n->bodies = NULL;
}

int norms_looks(const struct norms *n)
{
    return n->kept == NULL || n->terms_count < 0;
}

/** Where the reference is known at intervals. */
static int take_one(struct norms *n, int64_t step, const vti_bodies *bodies)
{
    take_conserved(n, bodies);
    vti_integral_add(&n->norm_squared, n->h, vti_h1_density(bodies));
    if (step != n->next_compare)
        return 0;
    n->next_compare += n->compare_every;
    const vti_bodies *exact = reference_state(n->reference, (double)step * n->h);
    vti_integral_add(&n->error_squared, (double)n->compare_every * n->h, vti_h1_distance(bodies, exact));
    if (step == n->last)
        n->attitude_error = vti_attitude_distance(bodies, exact);
    return 0;
}

/** The next values of integrals, which stay in registers: none waits for another's sums. energy is NULL where
 *  take_conserved has added it. */
static void integrate(struct norms *n, const double *energy, const double *density, const double *distance)
{
    vti_integral a = n->energy_squared, b = n->norm_squared, c = n->error_squared;
    for (int64_t k = 0; k < n->held; ++k) {
        if (energy != NULL)
            vti_integral_add(&a, n->h, energy[k]);
        vti_integral_add(&b, n->h, density[k]);
        vti_integral_add(&c, n->h, distance[k]);
    }
    n->energy_squared = a;
    n->norm_squared = b;
    n->error_squared = c;
}

static void take_those_that_wait(struct norms *n)
{
    double density[PANELS_BLOCK], distance[PANELS_BLOCK], energy[PANELS_BLOCK];
    for (int64_t i = 0; n->owed != 0.0 && i < n->states.bodies; ++i)
        vti_kick(n->owed, &n->bodies[i]);
    states_densities(&n->states, n->kept, n->held, density);
    states_distances(&n->states, n->kept, n->exact, n->held, distance);
    if (n->terms_count >= 0)
        take_those_conserved(n, energy);
    integrate(n, n->terms_count >= 0 ? energy : NULL, density, distance);
    n->held = 0;
}

int norms_take(struct norms *n, int64_t step, const vti_bodies *bodies, struct message *message)
{
    if (n->kept == NULL)
        return take_one(n, step, bodies);
    if (n->held == 0) {
        const int failed = reference_block(n->reference, n->h, step, n->watch, &n->exact, &n->room, message);
        if (failed != 0)
            return failed;
    }
    if (n->terms_count < 0)
        take_conserved(n, bodies);
    else if (n->puts)
        put_terms(n, bodies);
    const double owed = n->model->owed;
    n->owed = owed != 0.0 ? owed : n->owed;
    if (n->terms_count >= 0)
        states_put_loads(&n->states, bodies, owed != 0.0, n->held, n->loads);
    states_put(&n->states, bodies, n->held++, n->kept);
    if (n->held == n->room || step == n->last)
        take_those_that_wait(n);
    if (step == n->last) {
        const vti_bodies exact = reference_at(n->reference, (double)step * n->h);
        n->attitude_error = vti_attitude_distance(bodies, &exact);
    }
    return 0;
}
