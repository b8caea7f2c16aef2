/* SPDX-License-Identifier: BSD-3-Clause */
#include "stages.h"

#include <math.h>
#include <string.h>

#include "clock.h"

/* ---- the purse --------------------------------------------------------------------------------------------------- */

/** In seconds where these are limited, else in work. */
static double spent(const struct stages *g)
{
    return isfinite(g->search.purse.until) ? clock_now() : g->search.purse.work;
}

static double left(const struct stages *g)
{
    return fmax((isfinite(g->search.purse.until) ? g->search.purse.until : g->search.purse.most) - spent(g), 0.0);
}

/** How many times longer than it counts for a step of a pilot takes, if bodies are few and forces smooth: then a look
 *  takes as long as four steps of the pendulum, and as eight of two bonded bodies by vti2. */
static double looks_too_dear(const struct search *s)
{
    static const double few = 8.0;
    return s->kinked ? 1.0 : fmax(1.0, few / (double)s->bodies);
}

void stages_open_purse(struct stages *g, double evals)
{
    const double prudent = 0.65; /* what turns out to be the best may take less than what was by now */
    struct search *s = &g->search;
    const double share = prudent * advise_share(s->scene) / looks_too_dear(s);
    s->purse.most = isfinite(s->purse.until) ? INFINITY : fmax(PURSE_LEAST, share * evals * (double)s->bodies);
}

double stages_work_left(const struct stages *g, double share)
{
    static const double first_guess = 1e-7; /* seconds of a force evaluation of a body */
    const struct purse *p = &g->search.purse;
    if (!isfinite(p->until))
        return share * left(g);
    const double rate = p->work > 0.0 ? (clock_now() - g->pace_from) / p->work : first_guess;
    return share * left(g) / rate;
}

/* ---- one stage --------------------------------------------------------------------------------------------------- */

/** Of a run that is over in a blink the seconds without looks. */
static void time_again(struct search *s, struct offer *o)
{
    enum { TIMES = 5 };
    static const double blink = 5e5; /* evaluations of a body, a twentieth of a second or so */
    const double work = (double)o->force_evals * (double)s->bodies;
    struct message ignored;
    for (int k = 0; k < TIMES && work < blink && purse_may_start(&s->purse); ++k) {
        const double seconds = race_sample(s->scene, o->stepper, o->h, s->t_end, &ignored);
        o->seconds = k == 0 && seconds > 0.0 ? seconds : fmin(o->seconds, seconds);
        s->purse.work += work;
    }
}

/** Of a search that the purse has cut short: what its runs tell, unless more is known. Returns 0 if nothing better than
 *  that is known of any stepper, so that others are told likewise, else ADVISE_SPENT: what is far less sure than
 *  another offer is not the advice, however little it costs. */
static int take_cut(struct stages *g, int64_t k, const struct offer *found, double target)
{
    static const double surer = 2.0;
    struct offer *o = &g->search.advice->offers[k], told;
    const int64_t best = offers_best(g);
    g->cut = g->cut || best < 0;
    offers_carry_over(g, found, target, &told);
    if (o->source == OFFER_NONE || told.doubt < o->doubt)
        *o = told;
    return g->cut && (best < 0 || o->doubt <= surer * g->search.advice->offers[best].doubt) ? 0 : ADVISE_SPENT;
}

/** Offer k at this stage. */
static int make_offer(struct stages *g, int64_t k, double limit)
{
    struct search *s = &g->search;
    struct offer found = offers_none(s->advice->offers[k].stepper);
    const double target = s->target;
    s->target = target / offers_growth(s, found.stepper, s->measure);
    const int result = search_stepper(s, &found, limit);
    s->target = target;
    if (result == ADVISE_SPENT && found.source != OFFER_NONE)
        return take_cut(g, k, &found, target);
    if (result != 0)
        return result;
    if (g->complete && found.source == OFFER_MEASURED)
        time_again(s, &found);
    if (found.source == OFFER_MEASURED && method_rival(found.stepper) == NULL) {
        s->limit = fmin(s->limit, 2.0 * offers_cost(&found));
        g->cut = 0;
    }
    offers_carry_over(g, &found, target, &s->advice->offers[k]);
    return 0;
}

/** The advice of a whole search is a run that was made. Runs that were too dear to be made cost more than one that was
 *  (search.c), so that only a search whose TRIES have run out, on errors that hardly fall, leaves something to do. */
static int make_best(struct stages *g)
{
    int result = 0;
    for (int k = 0; k < ADVICE_MOST && result == 0; ++k) {
        const int64_t best = offers_best(g);
        if (best < 0 || g->search.advice->offers[best].source == OFFER_MEASURED)
            break;
        result = make_offer(g, best, INFINITY);
    }
    return result;
}

/** By errors of the energy alone nothing has to be known of the solution; other errors are told where it is found. */
static int find_solution(struct stages *g)
{
    static const double coarse = 1e-2;
    struct search *s = &g->search;
    const double target = s->target, share = 0.5, aside = 0.2;
    if (s->advice->parted) {
        pilot_destroy(&s->solution);
        s->solved = 0;
        return 0;
    }
    if (s->measure != COST_ENERGY) {
        s->target = target / offers_growth(s, s->advice->checked, s->measure);
        const int result = search_solution(s, share);
        s->target = target;
        return result;
    }
    s->target = fmax(coarse * s->t_end / s->advice->t_end, target);
    const int result = search_solution(s, aside);
    s->target = target;
    return result < 0 ? -1 : 0;
}

/** The active offer that cost least at the last stage, of those that have not been told yet; -1: all have. */
static int64_t next_offer(const struct stages *g, const int told[ADVICE_MOST])
{
    const struct advice *a = g->search.advice;
    int64_t next = -1;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->active[k] && !told[k] && (next < 0 || offers_cost(&a->offers[k]) < offers_cost(&a->offers[next])))
            next = k;
    return next;
}

/** An error that leads to target, and that is not lost in rounding at the end of a part of the time. */
static double told_by_part(const struct search *s, double target)
{
    static const double rounding = 1e-13;
    const double longer = s->advice->t_end / s->t_end;
    if (longer == 1.0 || s->measure == COST_ENERGY)
        return target;
    return fmax(target, rounding * sqrt(longer) * offers_growth(s, s->advice->checked, s->measure));
}

/** All active offers over [0, t_end], to the error that leads to target at the end of the time. Returns 0, -1,
 *  ADVISE_SPENT or ADVISE_PARTED. */
static int run_stage(struct stages *g, double t_end, double target)
{
    struct search *s = &g->search;
    s->t_end = t_end;
    s->target = told_by_part(s, target);
    s->limit = INFINITY;
    g->whole = t_end == s->advice->t_end;
    g->complete = g->whole && target == g->goal;
    int result = find_solution(g), told[ADVICE_MOST] = {0}, any = 0;
    for (int64_t k; result == 0 && (k = next_offer(g, told)) >= 0;) {
        result = make_offer(g, k, s->limit);
        told[k] = 1;
        if (result == 0 && !any)
            memset(g->latest, 0, sizeof g->latest);
        any = g->latest[k] = result == 0 || g->latest[k];
    }
    if (result == 0 && g->complete)
        result = g->cut ? ADVISE_SPENT : make_best(g);
    return result;
}

/* ---- what the next stage is -------------------------------------------------------------------------------------- */

/** Active offers that cost less than offer k, or as much and come before it in the list. */
static int64_t cheaper_than(const struct stages *g, const int before[ADVICE_MOST], int64_t k)
{
    const struct advice *a = g->search.advice;
    const double cost = offers_cost(&a->offers[k]);
    int64_t cheaper = 0;
    for (int64_t j = 0; j < a->count; ++j) {
        const double other = offers_cost(&a->offers[j]);
        cheaper += before[j] && (other < cost || (!(other > cost) && j < k));
    }
    return cheaper;
}

/** Leaves the cheaper half of the active offers, and no more than four, the best among them. */
static void prune(struct stages *g)
{
    enum { MOST = 4 };
    const int64_t best = offers_best(g), half = g->active_count / 2, most = half < MOST ? half : MOST;
    int before[ADVICE_MOST];
    memcpy(before, g->active, sizeof before);
    g->active_count = 0;
    for (int64_t k = 0; k < g->search.advice->count; ++k) {
        g->active[k] = before[k] && (k == best || cheaper_than(g, before, k) < most);
        g->active_count += g->active[k];
    }
}

/** How many times the cost of the last stage is left, if steppers are dropped until that is enough times; 0 if it never
 *  is. The solution costs about as much as two of them. */
static double times_left(struct stages *g, double cost, double enough)
{
    const double reserve = 0.7, solution = 2.0;
    double times = reserve * left(g) / fmax(cost, 1e-12);
    while (times < enough && g->active_count > 1) {
        const double before = solution + (double)g->active_count;
        prune(g);
        times *= before / (solution + (double)g->active_count);
    }
    return times < enough ? 0.0 : times;
}

/** Sets what the next stage goes to. Returns 0 if there is none. */
static int plan_next(struct stages *g, double cost, double *t_end, double *target)
{
    static const double harder = 10.0, dearer = 3.2, longest = 8.0, least_gain = 1.5;
    const double whole = g->search.advice->t_end;
    if (g->whole) { /* of an error that is easier to reach */
        if (times_left(g, cost, dearer) == 0.0)
            return 0;
        *target = fmax(*target / harder, g->goal);
        return 1;
    }
    double times = 0.7 * left(g) / fmax(cost, 1e-12);
    if (times < longest && *t_end * times < whole)
        times = times_left(g, cost, least_gain);
    if (times == 0.0)
        return 0;
    *t_end = *t_end * times >= whole ? whole : *t_end * fmin(times, longest);
    return 1;
}

/** The first stage: some hundred evaluations for each stable step, of a small part of the purse. */
static double first_end(const struct stages *g)
{
    static const double evals_of_step = 600.0, part = 0.2, fewest = 32.0;
    struct search at_end = g->search;
    at_end.t_end = g->search.advice->t_end;
    const double steps = (double)search_fewest(&at_end, vti_stepper_find("exact")),
                 affordable = isfinite(g->search.purse.until)
                                  ? fewest
                                  : part * g->search.purse.most / (evals_of_step * (double)g->search.bodies);
    return at_end.t_end * fmin(1.0, fmax(fewest, affordable) / steps);
}

void stages_all_active(struct stages *g)
{
    g->active_count = g->search.advice->count;
    for (int64_t k = 0; k < g->active_count; ++k)
        g->active[k] = 1;
}

void stages_by_energy(struct stages *g)
{
    struct search *s = &g->search;
    struct advice *a = s->advice;
    a->parted = 1;
    g->cut = 0;
    a->measure = g->search.measure = COST_ENERGY;
    stages_all_active(g);
    memset(g->latest, 0, sizeof g->latest);
    for (int64_t k = 0; k < a->count; ++k)
        a->offers[k] = offers_none(a->offers[k].stepper);
    s->target = g->goal;
    for (int64_t k = 0; k < a->count && s->t_end == a->t_end; ++k)
        if (a->offers[k].stepper == a->checked) {
            search_law_energy(s, &a->offers[k], &s->solution);
            g->latest[k] = isfinite(a->offers[k].seconds);
        }
}

/** Where only a part of the time was gone over: how errors grow from there to the end, if the purse has room for that.
 *  Returns 0, -1 or ADVISE_PARTED. */
static int find_growth(struct stages *g)
{
    static const double share = 0.5;
    struct search *s = &g->search;
    double before[ADVICE_MOST];
    if (s->kinked || s->advice->parted || g->whole || search_knows_growth(s) ||
        search_stray_work(s) > stages_work_left(g, share))
        return 0;
    for (int64_t k = 0; k < s->advice->count; ++k)
        before[k] = offers_growth(s, s->advice->offers[k].stepper, s->measure);
    const int result = search_stray(s);
    if (result == 0 && search_strays(s, g->goal) && s->measure != COST_ENERGY)
        return ADVISE_PARTED;
    if (result == 0)
        offers_regrow(g, before);
    return result < 0 ? -1 : 0;
}

int stages_go(struct stages *g)
{
    static const double loose = 0.03;
    struct advice *a = g->search.advice;
    double t_end = first_end(g), target = g->goal;
    if (laws_are_due(g))
        return laws_go(g) < 0 ? -1 : 0;
    if (g->search.kinked) {
        t_end = a->t_end;
        target = fmax(loose, g->goal);
    }
    for (;;) {
        const double before = spent(g);
        int result = run_stage(g, t_end, target);
        const double cost = spent(g) - before;
        const int64_t best = offers_best(g);
        if (best >= 0 && result != ADVISE_PARTED)
            stages_open_purse(g, (double)a->offers[best].force_evals);
        if (result == 0)
            result = find_growth(g);
        if (result < 0)
            return -1;
        if (result == ADVISE_PARTED) {
            stages_by_energy(g);
            t_end = g->search.kinked ? a->t_end : first_end(g);
            target = g->goal;
            continue;
        }
        if (result == ADVISE_SPENT && best < 0 && !a->parted)
            return laws_go(g) < 0 ? -1 : 0; /* the solution was too dear: two runs tell less, for less */
        if (result == ADVISE_SPENT || g->complete || !plan_next(g, cost, &t_end, &target))
            return 0;
    }
}
