/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>

#include "plain.h"

/** The error at the end of a stage that becomes the goal at the end of the time. Those of trajectories grow with the time,
 *  or as what strays does if that is more; those of methods whose energy drifts by its power 1 to 2. The energy's own do
 *  not, unless it drifts. */
double offers_growth(const struct search *s, const vti_stepper *stepper, int measure)
{
    const double longer = s->advice->t_end / s->t_end;
    const int drifts = vti_multistep_find(stepper->name) != NULL;
    if (measure == COST_ENERGY)
        return drifts ? longer : 1.0;
    return fmax(longer, search_growth(s, s->t_end)) * (drifts ? sqrt(longer) : 1.0);
}

/** By how much more or less an error may grow than that. A motion that strays does so at a rate that varies:
 *  e^((ln G)^(1/2)). */
static double growth_doubt(const struct search *s, const vti_stepper *stepper)
{
    static const double enough = 10.0, blind = 4.0;
    const double longer = s->advice->t_end / s->t_end, more = fmax(search_growth(s, s->t_end) / longer, 1.0);
    const double drift = vti_multistep_find(stepper->name) != NULL ? sqrt(longer) : 1.0;
    if (s->measure == COST_ENERGY)
        return fmax(1.0, sqrt(longer / enough));
    if (s->kinked || (!search_knows_growth(s) && longer > blind))
        return INFINITY;
    return fmax(1.0, sqrt(longer / enough)) * drift * plain_exp2(1.2 * sqrt(plain_log2(more)));
}

struct offer offers_none(const vti_stepper *stepper)
{
    struct offer none = {.stepper = stepper,
                         .seconds = INFINITY,
                         .usual = 1.0,
                         .doubt = INFINITY,
                         .below = INFINITY,
                         .error = NAN,
                         .missed = NAN};
    for (int m = 0; m < COST_MEASURES; ++m)
        none.errors[m] = NAN;
    return none;
}

/** The same in times as many steps over the whole time. No run counts more than LOOP_STEPS: then it is none, and 0 is
 *  returned. */
static int lengthen(const struct search *s, struct offer *o, double times)
{
    const double steps = ceil((double)o->steps * times);
    if (!(steps <= LOOP_STEPS)) {
        *o = offers_none(o->stepper);
        return 0;
    }
    o->steps = (int64_t)steps;
    o->h = s->advice->t_end / (double)o->steps;
    o->force_evals = (int64_t)fmin((double)o->force_evals * times, 1e18);
    o->seconds *= times;
    return 1;
}

void offers_carry_over(const struct stages *g, const struct offer *found, double target, struct offer *o)
{
    const struct search *s = &g->search;
    const double longer = s->advice->t_end / s->t_end;
    *o = *found;
    if (found->steps == 0)
        return;
    double finer = 1.0, luck = 1.0;
    const double order = search_lasting_order(s, found->stepper, found->order);
    if (target > g->goal) {
        luck = found->usual;
        finer = fmax(plain_power(luck * found->error / (search_aim(s) * g->goal), 1.0 / order), 1.0);
        o->source = OFFER_FOLLOWED;
        search_doubt(s, o, order, finer);
        o->doubt = fmax(o->doubt, found->doubt);
        o->below = fmax(luck * o->below, found->below);
    }
    if (longer > 1.0) {
        o->source = OFFER_SHORTER;
        o->doubt = o->below = fmax(found->doubt, s->doubt * growth_doubt(s, found->stepper));
    }
    if (!lengthen(s, o, longer * finer))
        return;
    const double less = luck * plain_power(finer, -order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = finer > 1.0 && !search_falls_alike(s, found->stepper, m)
                           ? NAN
                           : found->errors[m] * offers_growth(s, found->stepper, m) * less;
    o->error = found->error * offers_growth(s, found->stepper, s->measure) * less;
}

/** Seconds, with what one pays if the error turns out to be larger. */
static double price_of(const struct stages *g, const struct offer *o)
{
    return o->source == OFFER_MEASURED ? o->seconds : (g->search.kinked ? 1.5 : 1.1) * o->seconds;
}

void offers_regrow(struct stages *g, const double before[ADVICE_MOST])
{
    const struct search *s = &g->search;
    for (int64_t k = 0; k < s->advice->count; ++k) {
        struct offer *o = &s->advice->offers[k];
        if (o->source != OFFER_SHORTER)
            continue;
        const double more = offers_growth(s, o->stepper, s->measure) / before[k];
        if (lengthen(s, o, plain_power(fmax(more, 1.0), 1.0 / search_lasting_order(s, o->stepper, o->order))))
            o->doubt = o->below = s->doubt * growth_doubt(s, o->stepper);
    }
}

int64_t offers_best(const struct stages *g)
{
    const struct advice *a = g->search.advice;
    int64_t best = -1;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->latest[k] && isfinite(a->offers[k].seconds) && method_rival(a->offers[k].stepper) == NULL &&
            (best < 0 || price_of(g, &a->offers[k]) < price_of(g, &a->offers[best])))
            best = k;
    return best;
}
