/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How the advice is found. A stepper of the highest order that the scene may have is refined until its runs agree to a
 * fraction of the error asked for: that is the solution. Then every stepper searches its own way to that error
 * (search.c), and the fastest wins.
 *
 * Over the whole time that takes some hundred times the run that is advised on. So it is done in stages, each with more
 * of the time than the one before and fewer steppers, as far as the purse goes: what the first part of the time has
 * shown is carried over, errors growing with the time. Where forces have kinks the first part may be without any, and
 * only the whole time tells; then stages are of errors that are ever harder to reach. */
#include "advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"

/* h is aimed at this share of the error asked for */
static const double aim = 0.7;

/* force evaluations times bodies, about a tenth of a second of them, that pilots may always take */
static const double least_work = 1e6;

double advise_share(const struct scene *scene)
{
    return scene_first_with(scene, EFFECT_KINKED) != NULL ? 1.0 : 0.3;
}

int advise_measure(const char *name)
{
    for (int m = 0; m < COST_MEASURES; ++m)
        if (strcmp(name, cost_measures[m]) == 0)
            return m;
    return -1;
}

/** The search through its stages. */
struct stages {
    struct search search;
    const struct advise_request *request;
    double from;             /* when it began, purse_clock */
    double goal;             /* the error at the end of the whole time */
    int active[ADVICE_MOST]; /* offers that the next stage goes on with */
    int64_t active_count;
    int latest[ADVICE_MOST]; /* offers that the last stage has told something of */
    int whole;               /* it was over the whole time */
    int complete;            /* ... and of the error asked for */
};

/* ---- the purse --------------------------------------------------------------------------------------------------- */

/** In seconds where these are limited, else in work. */
static double spent(const struct stages *g)
{
    return isfinite(g->search.purse.until) ? purse_clock() : g->search.purse.work;
}

static double left(const struct stages *g)
{
    return fmax((isfinite(g->search.purse.until) ? g->search.purse.until : g->search.purse.most) - spent(g), 0.0);
}

/** Without a limit in seconds the purse goes by the run as it is predicted by now. */
static void open_purse(struct stages *g, double evals)
{
    struct search *s = &g->search;
    s->purse.most =
        isfinite(s->purse.until) ? INFINITY : fmax(least_work, advise_share(s->scene) * evals * (double)s->bodies);
}

/* ---- one stage --------------------------------------------------------------------------------------------------- */

/** The error at the end of a stage that becomes the goal at the end of the time. Those of trajectories grow with the
 *  time; the energy's does not, unless a method lets it drift. */
static double growth_of(const struct search *s, const vti_stepper *stepper, int measure)
{
    const double longer = s->advice->t_end / s->t_end;
    return measure == COST_ENERGY && vti_multistep_find(stepper->name) == NULL ? 1.0 : longer;
}

/** What a stage has found, for the whole time and the error asked for. */
static void carry_over(const struct stages *g, const struct offer *found, double target, struct offer *o)
{
    const struct search *s = &g->search;
    const double longer = s->advice->t_end / s->t_end;
    *o = *found;
    if (found->steps == 0)
        return;
    double finer = 1.0;
    if (target > g->goal) {
        finer = fmax(plain_power(found->error / (aim * g->goal), 1.0 / found->order), 1.0);
        o->source = OFFER_FOLLOWED;
        o->doubt = fmax(found->doubt, s->doubt * sqrt(finer));
    }
    if (longer > 1.0) {
        o->source = OFFER_SHORTER;
        o->doubt = s->kinked ? INFINITY : fmax(found->doubt, s->doubt * fmax(1.0, sqrt(longer / 10.0)));
    }
    o->steps = (int64_t)ceil(fmin((double)found->steps * longer * finer, 1e18));
    o->h = s->advice->t_end / (double)o->steps;
    o->force_evals = (int64_t)fmin((double)found->force_evals * longer * finer, 1e18);
    o->seconds = found->seconds * longer * finer;
    const double less = plain_power(finer, -found->order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = found->errors[m] * growth_of(s, found->stepper, m) * less;
    o->error = found->error * growth_of(s, found->stepper, s->measure) * less;
}

/** The least of several times of the same run, for runs that are over in a blink. */
static int time_again(struct search *s, struct offer *o)
{
    enum { MOST = 9 };
    const double enough = 0.05;
    double all = o->seconds, least = o->seconds;
    int result = 0;
    for (int k = 0; k < MOST && all < enough && result == 0; ++k) {
        struct pilot pilot;
        result = search_run(s, o->stepper, o->steps, &pilot);
        if (result == 0) {
            least = fmin(least, pilot.seconds);
            all += pilot.seconds;
        }
        pilot_destroy(&pilot);
    }
    o->seconds = least;
    return result < 0 ? -1 : 0; /* what an empty purse leaves untimed was timed once */
}

/** An offer of which nothing is known. */
static struct offer no_offer(const vti_stepper *stepper)
{
    struct offer none = {.stepper = stepper, .seconds = INFINITY, .doubt = INFINITY, .error = NAN};
    for (int m = 0; m < COST_MEASURES; ++m)
        none.errors[m] = NAN;
    return none;
}

/** Offer k at this stage. */
static int make_offer(struct stages *g, int64_t k, double limit)
{
    struct search *s = &g->search;
    struct offer found = no_offer(s->advice->offers[k].stepper);
    const double target = s->target;
    s->target = target / growth_of(s, found.stepper, s->measure);
    int result = search_stepper(s, &found, limit);
    s->target = target;
    if (result == 0 && g->complete && found.source == OFFER_MEASURED)
        result = time_again(s, &found);
    if (result != 0)
        return result;
    if (found.source == OFFER_MEASURED && method_rival(found.stepper) == NULL)
        s->limit = fmin(s->limit, 2.0 * (double)found.force_evals);
    carry_over(g, &found, target, &s->advice->offers[k]);
    return 0;
}

/** The number of the offer that is the advice so far, or -1: the fastest that the last stage has shown, ours
 *  before rivals. */
static int64_t best_of(const struct stages *g)
{
    const struct advice *a = g->search.advice;
    int64_t best = -1;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->latest[k] && isfinite(a->offers[k].seconds) && method_rival(a->offers[k].stepper) == NULL &&
            (best < 0 || a->offers[k].seconds < a->offers[best].seconds))
            best = k;
    return best;
}

/** The advice of a whole search is a run that was made. */
static int make_best(struct stages *g)
{
    int result = 0;
    for (int k = 0; k < ADVICE_MOST && result == 0; ++k) {
        const int64_t best = best_of(g);
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
        s->target = target / growth_of(s, s->advice->checked, s->measure);
        const int result = search_solution(s, share);
        s->target = target;
        return result;
    }
    s->target = fmax(coarse * s->t_end / s->advice->t_end, target);
    const int result = search_solution(s, aside);
    s->target = target;
    return result < 0 ? -1 : 0;
}

/** The active offer that was the fastest at the last stage, of those that have not been told yet; -1: all have. */
static int64_t next_offer(const struct stages *g, const int told[ADVICE_MOST])
{
    const struct advice *a = g->search.advice;
    int64_t next = -1;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->active[k] && !told[k] && (next < 0 || a->offers[k].seconds < a->offers[next].seconds))
            next = k;
    return next;
}

/** All active offers over [0, t_end], to the error that leads to target at the end of the time. Returns 0, -1,
 *  ADVISE_SPENT or ADVISE_PARTED. */
static int run_stage(struct stages *g, double t_end, double target)
{
    struct search *s = &g->search;
    s->t_end = t_end;
    s->target = target;
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
        result = make_best(g);
    return result;
}

/* ---- what the next stage is -------------------------------------------------------------------------------------- */

static int by_seconds(const void *a, const void *b)
{
    const double p = ((const struct offer *)a)->seconds, q = ((const struct offer *)b)->seconds;
    return (p > q) - (p < q);
}

/** Leaves the fastest half of the active offers, the best among them. */
static void prune(struct stages *g)
{
    struct offer by_time[ADVICE_MOST];
    const struct advice *a = g->search.advice;
    int64_t n = 0;
    for (int64_t k = 0; k < a->count; ++k)
        if (g->active[k])
            by_time[n++] = a->offers[k];
    qsort(by_time, (size_t)n, sizeof *by_time, by_seconds);
    const int64_t most = n > 8 ? 4 : n / 2;
    const double slowest = most > 0 ? by_time[most - 1].seconds : 0.0;
    const int64_t best = best_of(g);
    g->active_count = 0;
    for (int64_t k = 0; k < a->count; ++k) {
        g->active[k] = g->active[k] && (k == best || a->offers[k].seconds <= slowest);
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

static void all_active(struct stages *g)
{
    g->active_count = g->search.advice->count;
    for (int64_t k = 0; k < g->active_count; ++k)
        g->active[k] = 1;
}

/** From now on the energy is what can be told. The finest run of the stepper of the solution tells it already. */
static void go_by_energy(struct stages *g)
{
    struct search *s = &g->search;
    struct advice *a = s->advice;
    a->parted = 1;
    a->measure = g->search.measure = COST_ENERGY;
    all_active(g);
    memset(g->latest, 0, sizeof g->latest);
    for (int64_t k = 0; k < a->count; ++k)
        a->offers[k] = no_offer(a->offers[k].stepper);
    s->target = g->goal;
    for (int64_t k = 0; k < a->count && s->t_end == a->t_end; ++k)
        if (a->offers[k].stepper == a->checked) {
            search_law_energy(s, &a->offers[k], &s->solution);
            g->latest[k] = isfinite(a->offers[k].seconds);
        }
}

/** The first search over the whole time takes some dozen runs of the stepper of the solution, in work. */
static double whole_work(const struct stages *g)
{
    const struct search *s = &g->search;
    return 20.0 * (double)search_fewest(s, s->advice->checked) * (double)(s->advice->checked->evals * s->bodies);
}

/** The active offer of ours of which two runs are the cheapest; -1: there is none. */
static int64_t cheapest_law(const struct stages *g)
{
    const struct search *s = &g->search;
    int64_t least = -1;
    double least_evals = INFINITY;
    for (int64_t k = 0; k < s->advice->count; ++k) {
        const vti_stepper *stepper = s->advice->offers[k].stepper;
        /* those of the paper would tell what exact does */
        const double evals = law_evals(s, stepper) * (strcmp(method_kind(stepper), "paper") == 0 ? 1e6 : 1.0);
        if (g->active[k] && method_rival(stepper) == NULL && evals < least_evals) {
            least = k;
            least_evals = evals;
        }
    }
    return least;
}

/** Work that a share of what is left would do, by the seconds that work has taken so far. */
static double work_left(const struct stages *g, double share)
{
    static const double first_guess = 1e-7; /* seconds of a force evaluation of a body */
    const struct purse *p = &g->search.purse;
    if (!isfinite(p->until))
        return share * left(g);
    const double rate = p->work > 0.0 ? (purse_clock() - g->from) / p->work : first_guess;
    return share * left(g) / rate;
}

/** Offer k by two runs over as much of the time as a share of the purse allows, in up to most times as many steps as
 *  they need if a part of that allows more. */
static int make_law(struct stages *g, int64_t k, double share, double part, double most)
{
    struct search *s = &g->search;
    struct offer found = no_offer(s->advice->offers[k].stepper);
    s->t_end = s->advice->t_end;
    s->target = g->goal;
    const double work = work_left(g, share), least = law_evals(s, found.stepper) * (double)s->bodies;
    s->t_end *= fmin(1.0, work / least);
    s->target /= growth_of(s, found.stepper, s->measure);
    const int64_t fewest = search_fewest(s, found.stepper);
    const int64_t steps = pilot_steps((double)fewest * fmin(fmax(part * work / least, 1.0), most));
    int result = search_law(s, &found, steps);
    if (result == ADVISE_PARTED) { /* what the same runs tell of the energy stands */
        go_by_energy(g);
        s->target = g->goal;
        search_law_follow(s, &found);
        result = 0;
    }
    if (result == 0) {
        carry_over(g, &found, g->goal, &s->advice->offers[k]);
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
    const int64_t best = best_of(g);
    s->t_end = s->advice->t_end;
    if (best < 0)
        return 0;
    const struct offer *o = &s->advice->offers[best];
    const double fewest = (double)search_fewest(s, o->stepper), wanted = fmax(0.5 * (double)o->steps / fewest, 1.0),
                 seen = wanted / fmax(o->more, 1.0),
                 may = work_left(g, share) / (law_evals(s, o->stepper) * (double)s->bodies);
    return fmin(wanted, may) < worth * seen || may < 1.0 ? 0 : make_law(g, best, share, 1.0, wanted);
}

/** As many steppers as the purse has two runs for. The first takes what it needs; it tells what the run will be like,
 *  and with it how much the purse holds. */
static int make_laws(struct stages *g)
{
    struct search *s = &g->search;
    const double first = 0.9, other = 0.3, part = 0.4, most = 8.0;
    int result = 0;
    all_active(g);
    for (int64_t k, told = 0; (k = cheapest_law(g)) >= 0; ++told) {
        s->t_end = s->advice->t_end;
        if (told > 0 && law_evals(s, s->advice->offers[k].stepper) * (double)s->bodies > work_left(g, other))
            break;
        result = make_law(g, k, told > 0 ? other : first, part, most);
        g->active[k] = 0;
        if (result != 0 || !isfinite(work_left(g, first)))
            break;
        const int64_t best = best_of(g);
        if (best >= 0)
            open_purse(g, (double)s->advice->offers[best].force_evals);
    }
    all_active(g);
    return result == 0 ? make_law_again(g) : result;
}

static int all_stages(struct stages *g)
{
    static const double loose = 0.03;
    struct advice *a = g->search.advice;
    double t_end = first_end(g), target = g->goal;
    if (g->search.kinked) {
        g->search.t_end = a->t_end;
        if (whole_work(g) > work_left(g, 1.0)) {
            return make_laws(g) < 0 ? -1 : 0;
        }
        t_end = a->t_end;
        target = fmax(loose, g->goal);
    }
    for (;;) {
        const double before = spent(g);
        const int result = run_stage(g, t_end, target);
        if (result < 0)
            return -1;
        if (result == ADVISE_PARTED) {
            go_by_energy(g);
            t_end = g->search.kinked ? a->t_end : first_end(g);
            target = g->goal;
            continue;
        }
        const int64_t best = best_of(g);
        if (best >= 0)
            open_purse(g, (double)a->offers[best].force_evals);
        if (result == ADVISE_SPENT || g->complete || !plan_next(g, spent(g) - before, &t_end, &target))
            return 0;
    }
}

/* ---- what there is to advise on ---------------------------------------------------------------------------------- */

/** The highest orders first: they set the limit for the others. Rivals come last, and set none. Of ours those that the
 *  model may be run by, where none is named. */
static int list_offers(struct stages *g, const struct model *model, struct message *message)
{
    enum { HIGHEST = 16 };
    struct advice *a = g->search.advice;
    const struct advise_request *r = g->request;
    const int64_t known = r->count > 0 ? r->count : method_count();
    for (int rival = 0; rival <= 1; ++rival)
        for (int64_t order = HIGHEST; order > 0; --order)
            for (int64_t k = 0; k < known && a->count < ADVICE_MOST; ++k) {
                const vti_stepper *stepper = r->count > 0 ? r->steppers[k] : method_at(k);
                struct message refused;
                if (stepper->order != order || (method_rival(stepper) != NULL) != rival || (r->count == 0 && rival))
                    continue;
                if (travel_check(stepper, model, r->count > 0 ? message : &refused) == 0)
                    a->offers[a->count++] = no_offer(stepper);
                else if (r->count > 0)
                    return -1;
            }
    if (method_rival(a->offers[0].stepper) != NULL)
        return message_set(message,
                           "--steppers: only rivals, which are never advised; name one of ours too, such as %s",
                           a->checked->name);
    return 0;
}

static int choose_measure(struct stages *g, const struct model *model, struct message *message)
{
    struct search *s = &g->search;
    s->trajectory = model->turns ? COST_ATTITUDE : COST_VELOCITY;
    s->measure = g->request->measure >= 0 ? g->request->measure : s->trajectory;
    if (!model->turns && !model->translates)
        return message_set(message, "%s: nothing moves in this scene; there is no error to advise on", s->scene->name);
    if ((s->measure == COST_ATTITUDE && !model->turns) || (s->measure == COST_POSITION && !model->translates))
        return message_set(message, "--measure: %s has no %s; take %s", s->scene->name, cost_measures[s->measure],
                           cost_measures[s->trajectory]);
    s->advice->measure = s->measure;
    return 0;
}

static int any_breaks(const struct model *model)
{
    int any = 0;
    for (int64_t k = 0; k < model->effects_count; ++k)
        any |= model->effects[k].rupture != NULL;
    return any;
}

/** The scene's own numbers. */
static int look_at(struct stages *g)
{
    struct search *s = &g->search;
    struct model model;
    vti_stable begin;
    if (model_create(s->scene, &model, s->message) != 0)
        return -1;
    s->advice->checked = vti_stepper_find(model_dissipates(&model) != NULL ? "chin4" : "srkn11");
    s->bodies = model.bodies.count;
    s->omega0 = vti_max_turn(1.0, &model.bodies);
    s->kinked = scene_first_with(s->scene, EFFECT_KINKED) != NULL;
    s->doubt = any_breaks(&model) ? 30.0 : s->kinked ? 10.0 : 3.0;
    int failed = model_find_limits(&model, &s->advice->limits, s->message);
    const vti_deformation at = {s->advice->limits.at.overlap, 0.0, 0};
    if (failed == 0)
        failed = model_stable_step(&model, &model.bodies, &at, &begin, s->message);
    s->stable_h = failed == 0 ? begin.h : NAN;
    if (failed == 0)
        failed = choose_measure(g, &model, s->message);
    if (failed == 0)
        failed = list_offers(g, &model, s->message);
    model_destroy(&model);
    return failed;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/** Where no pilot came to its end: by half of the stable step something comes out, and nothing is known of its error.
 *  Returns the one to take: of order 2, of one evaluation, if there is one. */
static int64_t by_stability(struct stages *g)
{
    struct search at_end = g->search;
    struct advice *a = g->search.advice;
    int64_t best = 0;
    at_end.t_end = a->t_end;
    for (int64_t k = 0; k < a->count; ++k) {
        struct offer *o = &a->offers[k];
        o->steps = 2 * search_fewest(&at_end, o->stepper);
        o->h = a->t_end / (double)o->steps;
        o->force_evals = o->steps * o->stepper->evals;
        o->error = NAN;
        o->source = OFFER_STABILITY;
        for (int m = 0; m < COST_MEASURES; ++m)
            o->errors[m] = NAN;
        best = o->stepper->order == 2 && method_rival(o->stepper) == NULL ? k : best;
    }
    return best;
}

/** The advice first, then ours, then rivals, by rising seconds. */
static void sort_offers(struct stages *g)
{
    struct advice *a = g->search.advice;
    int64_t best = best_of(g);
    if (best < 0)
        best = by_stability(g);
    const struct offer first = a->offers[best];
    int64_t ours = 0;
    for (int64_t k = 0; k < a->count; ++k) {
        const struct offer o = a->offers[k];
        if (method_rival(o.stepper) == NULL && o.stepper != first.stepper) {
            a->offers[k] = a->offers[ours];
            a->offers[ours++] = o;
        }
    }
    for (int64_t k = ours; k < a->count; ++k)
        if (a->offers[k].stepper == first.stepper) {
            memmove(&a->offers[1], &a->offers[0], (size_t)k * sizeof first);
            a->offers[0] = first;
            break;
        }
    qsort(a->offers + 1, (size_t)ours, sizeof first, by_seconds);
    qsort(a->offers + 1 + ours, (size_t)(a->count - 1 - ours), sizeof first, by_seconds);
}

int advise(const struct advise_request *request, struct advice *advice, struct message *message)
{
    struct stages g;
    memset(advice, 0, sizeof *advice);
    memset(&g, 0, sizeof g);
    g.from = purse_clock();
    advice->target = g.goal = request->target;
    advice->t_end = request->t_end;
    advice->known = advice->order = advice->max_omega = advice->together = NAN;
    g.request = request;
    g.search.scene = request->scene;
    g.search.advice = advice;
    g.search.say = request->say;
    g.search.message = message;
    g.search.purse.until = request->budget > 0.0 ? g.from + request->budget : INFINITY;
    int failed = look_at(&g);
    if (failed == 0) {
        struct search at_end = g.search;
        at_end.t_end = request->t_end;
        /* kinks ask for a quarter of the stable step or so */
        open_purse(&g, (g.search.kinked ? 4.0 : 1.0) * (double)search_fewest(&at_end, vti_stepper_find("exact")));
        all_active(&g);
        failed = all_stages(&g);
    }
    if (failed == 0)
        sort_offers(&g);
    pilot_destroy(&g.search.solution);
    advice->work = g.search.purse.work;
    advice->seconds = purse_clock() - g.from;
    return failed;
}
