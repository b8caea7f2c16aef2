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

/** The next values of an integral, which stays in registers. */
static void add_all(vti_integral *integral, double h, const double *value, int64_t n)
{
    vti_integral sum = *integral;
    for (int64_t k = 0; k < n; ++k)
        vti_integral_add(&sum, h, value[k]);
    *integral = sum;
}

static void take_energies(struct norms *n, double *energy, int64_t count)
{
    for (int64_t k = 0; k < count; ++k)
        energy[k] = (energy[k] - n->energy0) * (energy[k] - n->energy0);
    add_all(&n->energy_squared, n->h, energy, count);
}

/** Of momentum k. */
static void take_invariant(struct norms *n, int64_t k, const double *value, int64_t count)
{
    double most = n->momentum_error;
    for (int64_t i = 0; i < count; ++i) {
        const double deviation = fabs(value[i] - n->invariants0[k]);
        most = isnan(most) || deviation <= most ? most : deviation;
    }
    n->momentum_error = most;
}

static void take_conserved(struct norms *n, const vti_bodies *bodies)
{
    double values[MODEL_INVARIANTS], energy = norms_energy(n->model, bodies);
    take_energies(n, &energy, 1);
    model_invariant_values(n->model, bodies, values);
    for (int64_t k = 0; k < n->invariants; ++k)
        if (n->invariant[k].is_momentum)
            take_invariant(n, k, &values[k], 1);
}

/** What effects alone know, of the state that joins those that wait. */
static void put_terms(struct norms *n, const vti_bodies *bodies)
{
    const struct model *model = n->model;
    double values[MODEL_INVARIANTS];
    const int found = model_find_pairs(n->model, bodies) == VTI_OK;
    for (int64_t e = 0, j = 0; e < model->effects_count; ++e) {
        double energies[VTI_TERMS];
        memset(energies, 0, (size_t)model->effects[e].terms * sizeof *energies);
        if (model->effects[e].energy != NULL)
            model->effects[e].energy(model->effects[e].self, bodies, energies);
        for (int64_t i = 0; i < model->effects[e].terms; ++i)
            n->terms[j++][n->held] = found ? energies[i] : NAN;
    }
    model_own_values(model, bodies, 0, n->momenta, values);
    for (int64_t k = n->momenta; k < n->invariants; ++k)
        if (n->invariant[k].is_momentum)
            n->own[k][n->held] = values[k - n->momenta];
}

static void take_those_conserved(struct norms *n)
{
    double energy[PANELS_BLOCK], momentum[3][PANELS_BLOCK];
    states_energies(&n->states, n->kept, n->terms[0], n->terms_count, n->held, energy);
    take_energies(n, energy, n->held);
    const int64_t momenta = model_momenta(n->model);
    for (int which = STATES_LINEAR, row = 0; which <= STATES_SPIN; ++which) {
        if ((momenta >> 3 * which & 7) == 0)
            continue;
        states_momenta(&n->states, (enum states_momentum)which, n->kept, n->held, momentum[0]);
        for (int c = 0; c < 3; ++c) {
            if ((momenta >> (3 * which + c) & 1) == 0)
                continue;
            take_invariant(n, row++, momentum[c], n->held);
        }
    }
    for (int64_t k = n->momenta; k < n->invariants; ++k)
        if (n->invariant[k].is_momentum)
            take_invariant(n, k, n->own[k], n->held);
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
    n->invariants = model_invariants(model, n->invariant);
    for (int64_t momenta = model_momenta(model); momenta != 0; momenta &= momenta - 1)
        ++n->momenta;
    model_invariant_values(model, &model->bodies, n->invariants0);
    n->terms_count = terms_of(model);
    n->states = states_of(model);
    if (reference->interval != 0.0)
        return 0;
    n->kept = calloc((size_t)(n->states.bodies * states_width(&n->states) * PANELS_BLOCK), sizeof *n->kept);
    return n->kept != NULL ? 0 : message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
}

void norms_destroy(struct norms *n)
{
    free(n->kept);
    n->kept = NULL;
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

static void take_those_that_wait(struct norms *n)
{
    double density[PANELS_BLOCK], distance[PANELS_BLOCK];
    states_densities(&n->states, n->kept, n->held, density);
    states_distances(&n->states, n->kept, n->exact, n->held, distance);
    add_all(&n->norm_squared, n->h, density, n->held);
    add_all(&n->error_squared, n->h, distance, n->held);
    if (n->terms_count >= 0)
        take_those_conserved(n);
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
    if (n->terms_count >= 0)
        put_terms(n, bodies);
    else
        take_conserved(n, bodies);
    states_put(&n->states, bodies, n->held++, n->kept);
    if (n->held == n->room || step == n->last)
        take_those_that_wait(n);
    if (step == n->last) {
        const vti_bodies exact = reference_at(n->reference, (double)step * n->h);
        n->attitude_error = vti_attitude_distance(bodies, &exact);
    }
    return 0;
}
