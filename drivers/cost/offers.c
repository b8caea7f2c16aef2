/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>

#include "plain.h"

/** The error at the end of a stage that becomes the goal at the end of the time. Those of trajectories grow with the
 *  time, or as what strays does if that is more; those of methods whose energy drifts by its power 1 to 2. The energy's
 *  own do not, unless it drifts. */
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
    const double growth = offers_growth(s, found->stepper, s->measure);
    const double order = search_lasting_order(s, found->stepper, found->order);
    if (target > g->goal) {
        luck = found->usual;
        finer = fmax(plain_power(luck * growth * found->error / (search_aim(s) * g->goal), 1.0 / order), 1.0);
        o->source = OFFER_FOLLOWED;
        search_doubt(s, o, order, finer);
        o->doubt = fmax(o->doubt, found->doubt);
        o->below = fmax(luck * o->below, found->below);
    }
    if (longer > 1.0) {
        o->source = OFFER_SHORTER;
        o->part_doubt = o->doubt;
        o->doubt = o->below = fmax(o->doubt, s->doubt * growth_doubt(s, found->stepper));
    }
    if (!lengthen(s, o, longer * finer))
        return;
    const double less = luck * plain_power(finer, -order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = finer > 1.0 && !search_falls_alike(s, found->stepper, m)
                           ? NAN
                           : found->errors[m] * offers_growth(s, found->stepper, m) * less;
    o->error = found->error * growth * less;
}

double offers_cost(const struct offer *o)
{
    return isfinite(o->seconds) ? pilot_cost(o->stepper, (double)o->force_evals) : INFINITY;
}

/** With what one pays if the error turns out to be larger. */
static double with_risk(const struct stages *g, const struct offer *o, double price)
{
    return o->source == OFFER_MEASURED ? price : (g->search.kinked ? 1.5 : 1.1) * price;
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
            o->doubt = o->below = fmax(o->part_doubt, s->doubt * growth_doubt(s, o->stepper));
    }
}

static double price_of(const struct stages *g, int64_t k, int by_seconds)
{
    const struct offer *o = &g->search.advice->offers[k];
    const int serves = g->latest[k] && method_rival(o->stepper) == NULL;
    return serves ? with_risk(g, o, by_seconds ? o->seconds : offers_cost(o)) : INFINITY;
}

/** By what it costs. Of those of a source only, and within a limit of seconds. */
static int64_t cheapest(const struct stages *g, enum offer_source least, double limit)
{
    int64_t best = -1;
    for (int64_t k = 0; k < g->search.advice->count; ++k) {
        const double price = price_of(g, k, 0);
        const int serves = g->search.advice->offers[k].source >= least && price_of(g, k, 1) <= limit;
        if (isfinite(price) && serves && (best < 0 || price < price_of(g, best, 0)))
            best = k;
    }
    return best;
}

int64_t offers_best(const struct stages *g)
{
    return cheapest(g, OFFER_NONE, INFINITY);
}

int64_t offers_fastest(const struct stages *g)
{
    static const double tie = 1.1;
    const struct offer *offers = g->search.advice->offers;
    const int64_t best = offers_best(g);
    const enum offer_source least = best < 0 || !g->complete ? OFFER_NONE : offers[best].source;
    double seconds = INFINITY;
    for (int64_t k = 0; k < g->search.advice->count; ++k)
        seconds = offers[k].source >= least ? fmin(seconds, price_of(g, k, 1)) : seconds;
    return cheapest(g, least, tie * seconds);
}
