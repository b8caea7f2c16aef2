/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>
#include <string.h>

#include "clock.h"
#include "plain.h"

enum { DONE = ADVISE_PARTED + 1 };

int laws_are_due(const struct stages *g)
{
    static const double runs = 20.0;
    struct search at_end = g->search;
    const vti_stepper *checked = at_end.advice->checked;
    at_end.t_end = at_end.advice->t_end;
    return at_end.kinked &&
           runs * (double)search_fewest(&at_end, checked) * pilot_evals(checked) * (double)at_end.bodies >
               stages_work_left(g, 1.0);
}

/** Evaluations by which a stepper will reach the goal, guessed from what another one needs: by their largest stable
 *  steps they err alike, and from there on by their orders. */
static double guess_evals(const struct search *whole, const vti_stepper *stepper, const struct offer *known)
{
    const double finer = fmax((double)known->steps / (double)search_fewest(whole, known->stepper), 1.0),
                 steps =
                     (double)search_fewest(whole, stepper) *
                     plain_power(finer, search_usual_order(whole, known->stepper) / search_usual_order(whole, stepper));
    return steps * (double)(stepper->evals > 0 ? stepper->evals : 1);
}

/** The share of the purse for two runs of a stepper that may need so many evaluations, where another one needs more or
 *  less. */
static double share_for(const struct offer *known, double guess)
{
    static const double share = 0.3, large = 0.9, far = 0.5;
    return guess < far * (double)known->force_evals ? large : share;
}

/** The purse goes by what the run may need that is advised on then. */
static void open_purse_for(struct stages *g, const struct offer *known, double guess)
{
    static const double bold = 1.5; /* of a guess, what is prudent with a run that is known is taken back */
    stages_open_purse(g, fmin((double)known->force_evals, bold * guess));
}

/** Whether it has room for two runs then. */
static int has_room(const struct stages *g, const vti_stepper *stepper, const struct offer *known, double guess)
{
    struct stages then = *g;
    then.search.t_end = g->search.advice->t_end;
    open_purse_for(&then, known, guess);
    const double left = stages_work_left(&then, share_for(known, guess));
    return isfinite(left) && search_law_evals(&then.search, stepper) * (double)then.search.bodies <= left;
}

/** The offer that two runs may tell of next, by the least evaluations: of these runs, or, of those for which there is
 *  room, of the run that it would be if something is known of another one already. -1: there is none. */
static int64_t next_law(const struct stages *g, const struct offer *known, double *evals)
{
    struct search whole = g->search;
    const struct advice *a = whole.advice;
    int64_t next = -1;
    whole.t_end = a->t_end;
    *evals = INFINITY;
    for (int64_t k = 0; k < a->count; ++k) {
        const vti_stepper *stepper = a->offers[k].stepper;
        /* those of the paper would tell what exact does */
        const double least = known != NULL ? guess_evals(&whole, stepper, known) : search_law_evals(&whole, stepper),
                     needs = least * (strcmp(method_kind(stepper), "paper") == 0 ? 1e6 : 1.0);
        if (g->active[k] && method_rival(stepper) == NULL && needs < *evals &&
            (known == NULL || has_room(g, stepper, known, least))) {
            next = k;
            *evals = needs;
        }
    }
    return next;
}

/** Offer k by two runs over as much of the time as a share of the purse allows, in up to most times as many steps as
 *  they need if a part of that allows more. */
static int make_law(struct stages *g, int64_t k, double share, double part, double most)
{
    struct search *s = &g->search;
    struct offer found = offers_none(s->advice->offers[k].stepper);
    s->t_end = s->advice->t_end;
    s->target = g->goal;
    const double work = stages_work_left(g, share), least = search_law_evals(s, found.stepper) * (double)s->bodies;
    g->part = fmin(1.0, work / least);
    s->t_end *= g->part;
    s->target /= offers_growth(s, found.stepper, s->measure);
    const int64_t fewest = search_fewest(s, found.stepper);
    const int64_t steps = pilot_steps((double)fewest * fmin(fmax(part * work / least, 1.0), most));
    const double together = s->advice->together, max_omega = s->advice->max_omega;
    int result = search_law(s, &found, steps, offers_best(g) >= 0 ? 0.0 : work);
    if (result == ADVISE_PARTED && offers_best(g) >= 0 && !s->advice->parted) {
        s->advice->together = together; /* too coarse, as others were not */
        s->advice->max_omega = max_omega;
        return 0;
    }
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
    struct search *s = &g->search;
    /* where time does not limit it the purse goes by the run, which may turn out to be a shorter one */
    const double share = isfinite(s->purse.until) ? 0.8 : 0.6, worth = 1.5;
    const int64_t best = offers_best(g);
    s->t_end = s->advice->t_end;
    if (best < 0)
        return 0;
    const struct offer *o = &s->advice->offers[best];
    if (o->source == OFFER_SHORTER) { /* the pace was better than it looked: over more of the time, once */
        const double longer = stages_work_left(g, share) / (search_law_evals(s, o->stepper) * (double)s->bodies);
        return longer < worth * g->part ? 0 : make_law(g, best, share, 1.0, 1.0);
    }
    const double fewest = (double)search_fewest(s, o->stepper), wanted = fmax(0.5 * (double)o->steps / fewest, 1.0),
                 seen = wanted / fmax(o->more, 1.0),
                 may = stages_work_left(g, share) / (search_law_evals(s, o->stepper) * (double)s->bodies);
    return fmin(wanted, may) < worth * seen || may < 1.0 ? 0 : make_law(g, best, share, 1.0, wanted);
}

/** Where seconds are limited, the pace: a few steps, for a small share of them, before it is decided how much of the
 *  time the first runs go over. */
static int feel_pace(struct stages *g)
{
    enum { STEPS = 64 };
    static const double share = 0.1;
    struct search *s = &g->search;
    const vti_stepper *exact = vti_stepper_find("exact");
    const double until = s->purse.until;
    struct pilot pilot;
    if (!isfinite(s->purse.until) || s->purse.work > 0.0)
        return 0;
    s->t_end = s->advice->t_end;
    s->t_end *= fmin(1.0, (double)STEPS / (double)search_fewest(s, exact));
    s->purse.until -= (1.0 - share) * fmax(until - s->purse.start - clock_now(), 0.0);
    const int result = search_run(s, exact, STEPS, &pilot);
    s->purse.until = until;
    pilot_destroy(&pilot);
    return result < 0 ? -1 : 0;
}

/** Another stepper, once something is known of one: that which may need the least, if that is worth it. The purse goes
 *  by what it may need. Returns 0, -1, ADVISE_SPENT, or DONE. */
static int make_other_law(struct stages *g, const struct offer *known)
{
    static const double part = 0.4, most = 2.0, worth = 2.0;
    double guess;
    const int64_t k = next_law(g, known, &guess);
    if (k < 0 || guess > worth * (double)known->force_evals)
        return DONE;
    open_purse_for(g, known, guess);
    g->active[k] = 0;
    return make_law(g, k, share_for(known, guess), part, most);
}

/** The first of which two runs do not fail, by those that take the least. */
static int make_first_law(struct stages *g)
{
    /* seconds are not all alike */
    const double share = isfinite(g->search.purse.until) ? 0.75 : 0.9, part = 0.4, most = 8.0;
    double evals;
    const int64_t k = next_law(g, NULL, &evals);
    if (k < 0)
        return DONE;
    g->active[k] = 0;
    return make_law(g, k, share, part, most);
}

int laws_go(struct stages *g)
{
    int result = feel_pace(g);
    stages_all_active(g);
    while (result == 0) {
        const int64_t best = offers_best(g);
        result = best < 0 ? make_first_law(g) : make_other_law(g, &g->search.advice->offers[best]);
    }
    const int64_t best = offers_best(g);
    if (best >= 0)
        stages_open_purse(g, (double)g->search.advice->offers[best].force_evals);
    stages_all_active(g);
    return result == DONE ? make_law_again(g) : result;
}
