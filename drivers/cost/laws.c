/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>
#include <string.h>

int laws_are_due(const struct stages *g)
{
    static const double runs = 20.0;
    struct search at_end = g->search;
    const vti_stepper *checked = at_end.advice->checked;
    at_end.t_end = at_end.advice->t_end;
    return at_end.kinked && runs * (double)search_fewest(&at_end, checked) * (double)(checked->evals * at_end.bodies) >
                                stages_work_left(g, 1.0);
}

/** The active offer of ours of which two runs are the cheapest; -1: there is none. */
static int64_t cheapest_law(const struct stages *g)
{
    struct search whole = g->search;
    const struct advice *a = whole.advice;
    int64_t least = -1;
    double least_evals = INFINITY;
    whole.t_end = a->t_end;
    for (int64_t k = 0; k < a->count; ++k) {
        const vti_stepper *stepper = a->offers[k].stepper;
        /* those of the paper would tell what exact does */
        const double evals = law_evals(&whole, stepper) * (strcmp(method_kind(stepper), "paper") == 0 ? 1e6 : 1.0);
        if (g->active[k] && method_rival(stepper) == NULL && evals < least_evals) {
            least = k;
            least_evals = evals;
        }
    }
    return least;
}

/** Offer k by two runs over as much of the time as a share of the purse allows, in up to most times as many steps as
 *  they need if a part of that allows more. */
static int make_law(struct stages *g, int64_t k, double share, double part, double most)
{
    struct search *s = &g->search;
    struct offer found = offers_none(s->advice->offers[k].stepper);
    s->t_end = s->advice->t_end;
    s->target = g->goal;
    const double work = stages_work_left(g, share), least = law_evals(s, found.stepper) * (double)s->bodies;
    g->part = fmin(1.0, work / least);
    s->t_end *= g->part;
    s->target /= offers_growth(s, found.stepper, s->measure);
    const int64_t fewest = search_fewest(s, found.stepper);
    const int64_t steps = pilot_steps((double)fewest * fmin(fmax(part * work / least, 1.0), most));
    int result = search_law(s, &found, steps);
    if (result == ADVISE_PARTED) { /* what the same runs tell of the energy stands */
        stages_by_energy(g);
        s->target = g->goal;
        search_law_follow(s, &found);
        result = 0;
    }
    if (result == 0) {
        offers_carry_over(g, &found, g->goal, &s->advice->offers[k]);
        g->latest[k] = isfinite(found.seconds);
        g->active[k] = 0;
    }
    return result;
}

/** Two runs of the best again, which are not as far from the advised one, if the purse has so much left. */
static int make_law_again(struct stages *g)
{
    const double share = 0.8, worth = 1.5;
    struct search *s = &g->search;
    const int64_t best = offers_best(g);
    s->t_end = s->advice->t_end;
    if (best < 0)
        return 0;
    const struct offer *o = &s->advice->offers[best];
    if (o->source == OFFER_SHORTER) { /* the pace was better than it looked: over more of the time, once */
        const double longer = stages_work_left(g, share) / (law_evals(s, o->stepper) * (double)s->bodies);
        return longer < worth * g->part ? 0 : make_law(g, best, share, 1.0, 1.0);
    }
    const double fewest = (double)search_fewest(s, o->stepper), wanted = fmax(0.5 * (double)o->steps / fewest, 1.0),
                 seen = wanted / fmax(o->more, 1.0),
                 may = stages_work_left(g, share) / (law_evals(s, o->stepper) * (double)s->bodies);
    return fmin(wanted, may) < worth * seen || may < 1.0 ? 0 : make_law(g, best, share, 1.0, wanted);
}

/** Where seconds are limited, the pace: a few steps, before it is decided how much of the time the first runs go over. */
static int feel_pace(struct stages *g)
{
    enum { STEPS = 64 };
    struct search *s = &g->search;
    const vti_stepper *exact = vti_stepper_find("exact");
    struct pilot pilot;
    if (!isfinite(s->purse.until) || s->purse.work > 0.0)
        return 0;
    s->t_end = s->advice->t_end;
    s->t_end *= fmin(1.0, (double)STEPS / (double)search_fewest(s, exact));
    const int result = search_run(s, exact, STEPS, &pilot);
    pilot_destroy(&pilot);
    return result < 0 ? -1 : 0;
}

int laws_go(struct stages *g)
{
    struct search *s = &g->search;
    /* seconds are not all alike */
    const double first = isfinite(s->purse.until) ? 0.75 : 0.9, other = 0.3, part = 0.4, most = 8.0;
    int result = feel_pace(g);
    stages_all_active(g);
    for (int64_t k, told = 0; result == 0 && (k = cheapest_law(g)) >= 0; ++told) {
        s->t_end = s->advice->t_end;
        if (told > 0 && law_evals(s, s->advice->offers[k].stepper) * (double)s->bodies > stages_work_left(g, other))
            break;
        result = make_law(g, k, told > 0 ? other : first, part, most);
        g->active[k] = 0;
        if (result != 0 || !isfinite(stages_work_left(g, first)))
            break;
        const int64_t best = offers_best(g);
        if (best >= 0)
            stages_open_purse(g, (double)s->advice->offers[best].force_evals);
    }
    stages_all_active(g);
    return result == 0 ? make_law_again(g) : result;
}
