/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>

#include "plain.h"

/* h is aimed at this share of the error asked for */
static const double aim = 0.7;

/** The error at the end of a stage that becomes the goal at the end of the time. Those of trajectories grow with the
 *  time; the energy's does not, unless a method lets it drift. */
double offers_growth(const struct search *s, const vti_stepper *stepper, int measure)
{
    const double longer = s->advice->t_end / s->t_end;
    return measure == COST_ENERGY && vti_multistep_find(stepper->name) == NULL ? 1.0 : longer;
}

struct offer offers_none(const vti_stepper *stepper)
{
    struct offer none = {
        .stepper = stepper, .seconds = INFINITY, .doubt = INFINITY, .below = INFINITY, .error = NAN, .missed = NAN};
    for (int m = 0; m < COST_MEASURES; ++m)
        none.errors[m] = NAN;
    return none;
}

void offers_carry_over(const struct stages *g, const struct offer *found, double target, struct offer *o)
{
    static const double enough = 10.0;
    const struct search *s = &g->search;
    const double longer = s->advice->t_end / s->t_end;
    *o = *found;
    if (found->steps == 0)
        return;
    double finer = 1.0;
    /* below the errors that were seen kinks may leave no more than that */
    const double order = s->kinked ? fmin(found->order, search_kinked_order(found->stepper)) : found->order;
    if (target > g->goal) {
        finer = fmax(plain_power(found->error / (aim * g->goal), 1.0 / order), 1.0);
        o->source = OFFER_FOLLOWED;
        search_doubt(s, o, order, finer);
        o->doubt = fmax(o->doubt, found->doubt);
        o->below = fmax(o->below, found->below);
    }
    if (longer > 1.0) {
        o->source = OFFER_SHORTER;
        o->doubt = o->below = s->kinked ? INFINITY : fmax(found->doubt, s->doubt * fmax(1.0, sqrt(longer / enough)));
    }
    const double steps = ceil((double)found->steps * longer * finer);
    if (!(steps <= LOOP_STEPS)) { /* no run counts as many */
        *o = offers_none(found->stepper);
        return;
    }
    o->steps = (int64_t)steps;
    o->h = s->advice->t_end / (double)o->steps;
    o->force_evals = (int64_t)fmin((double)found->force_evals * longer * finer, 1e18);
    o->seconds = found->seconds * longer * finer;
    const double less = plain_power(finer, -order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = found->errors[m] * offers_growth(s, found->stepper, m) * less;
    o->error = found->error * offers_growth(s, found->stepper, s->measure) * less;
}

int64_t offers_best(const struct stages *g)
{
    const struct advice *a = g->search.advice;
    int64_t best = -1;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->latest[k] && isfinite(a->offers[k].seconds) && method_rival(a->offers[k].stepper) == NULL &&
            (best < 0 || a->offers[k].seconds < a->offers[best].seconds))
            best = k;
    return best;
}
