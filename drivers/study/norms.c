/* SPDX-License-Identifier: BSD-3-Clause */
#include "norms.h"

#include <stdlib.h>
#include <string.h>

int norms_create(struct norms *n, const struct model *model, const struct trial *trial, int64_t compare_every,
                 struct reference *reference, const struct watch *watch, struct message *message)
{
    memset(n, 0, sizeof *n);
    n->reference = reference;
    n->watch = watch;
    n->h = trial->h;
    n->last = trial->steps;
    n->compare_every = compare_every;
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
    for (int64_t k = 0; k < n->held; ++k) {
        vti_integral_add(&n->norm_squared, n->h, density[k]);
        vti_integral_add(&n->error_squared, n->h, distance[k]);
    }
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
    states_put(&n->states, bodies, n->held++, n->kept);
    if (n->held == n->room || step == n->last)
        take_those_that_wait(n);
    if (step == n->last) {
        const vti_bodies exact = reference_at(n->reference, (double)step * n->h);
        n->attitude_error = vti_attitude_distance(bodies, &exact);
    }
    return 0;
}
